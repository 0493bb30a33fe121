// The keys of the timeline as a slider.

// Where a key of the slider goes to, null when it is none: arrows 0.1 s, with shift 1 s, pages a
// tenth of the whole.
export function sliderTarget(
  key: string,
  shift: boolean,
  tUs: number,
  startUs: number,
  durationUs: number,
): number | null {
  const step = shift ? 1_000_000 : 100_000;
  const page = (durationUs - startUs) / 10;
  const targets: Readonly<Record<string, number>> = {
    ArrowRight: tUs + step,
    ArrowUp: tUs + step,
    ArrowLeft: tUs - step,
    ArrowDown: tUs - step,
    PageUp: tUs + page,
    PageDown: tUs - page,
    Home: startUs,
    End: durationUs,
  };
  const target = targets[key];
  return target === undefined ? null : Math.min(Math.max(target, startUs), durationUs);
}
