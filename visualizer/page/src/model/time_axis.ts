// The span of time that the timeline and the curves show, shared by both.

export interface Span {
  readonly fromUs: number;
  readonly toUs: number;
}

export interface TimeAxis {
  readonly span: Span; // what is shown
  readonly whole: Span; // all there is
  readonly zoomed: boolean;
  setWhole(span: Span): void;
  zoom(span: Span): void; // clamped to the whole; too narrow a span is refused
  reset(): void;
  // Called at once after each change. Answers how to stop listening.
  listen(listener: () => void): () => void;
}

// Narrower than this is a click, not a span.
export const MIN_SPAN_US = 20_000;

export function createTimeAxis(): TimeAxis {
  const listeners = new Set<() => void>();
  let whole: Span = { fromUs: 0, toUs: 1_000_000 };
  let zoomed: Span | null = null;
  const changed = (): void => {
    for (const listener of listeners) listener();
  };
  return {
    get span() {
      return zoomed ?? whole;
    },
    get whole() {
      return whole;
    },
    get zoomed() {
      return zoomed !== null;
    },
    setWhole: (span) => {
      const next = { fromUs: span.fromUs, toUs: Math.max(span.toUs, span.fromUs + MIN_SPAN_US) };
      if (next.fromUs === whole.fromUs && next.toUs === whole.toUs) return;
      if (zoomed !== null && (zoomed.fromUs < next.fromUs || zoomed.toUs > next.toUs)) zoomed = null;
      whole = next;
      changed();
    },
    zoom: (span) => {
      const fromUs = Math.max(Math.min(span.fromUs, span.toUs), whole.fromUs);
      const toUs = Math.min(Math.max(span.fromUs, span.toUs), whole.toUs);
      if (toUs - fromUs < MIN_SPAN_US) return;
      zoomed = { fromUs, toUs };
      changed();
    },
    reset: () => {
      if (zoomed === null) return;
      zoomed = null;
      changed();
    },
    listen: (listener) => {
      listeners.add(listener);
      return () => listeners.delete(listener);
    },
  };
}

// Where an axis has its marks: multiples of 1, 2 or 5 times a power of ten, at least `atLeastUs` (> 0)
// apart. Axes of values use it as well, in their own unit.
export function marks(span: Span, atLeastUs: number): { timesUs: number[]; stepUs: number } {
  const power = 10 ** Math.floor(Math.log10(atLeastUs));
  const stepUs = power * ([1, 2, 5, 10].find((factor) => factor * power >= atLeastUs) ?? 10);
  const timesUs: number[] = [];
  for (let n = Math.ceil(span.fromUs / stepUs); n * stepUs <= span.toUs; n++) timesUs.push(n * stepUs);
  return { timesUs, stepUs };
}

// The end of an axis for data that still grow: some room to the right, so that the axis seldom moves.
export function roomFor(toUs: number): number {
  const steps = [10, 15, 20, 30, 45, 60, 90, 120, 180, 240, 300, 450, 600];
  const seconds = toUs / 1e6;
  return (steps.find((step) => step >= seconds) ?? Math.ceil(seconds / 300) * 300) * 1e6;
}

// What the axis of a viewer spans: the whole of a case that is known, room to grow otherwise.
export function wholeSpan(known: boolean, fromUs: number, durationUs: number): Span {
  return known ? { fromUs: 0, toUs: durationUs } : { fromUs: Math.min(fromUs, 0), toUs: roomFor(durationUs) };
}
