// Pointer and wheel on the map, as gestures: drag, click, double click, shift-drag, wheel.

export interface Gestures {
  pan(dx: number, dy: number): void; // CSS pixels
  zoom(factor: number, px: number, py: number): void;
  click(px: number, py: number): void;
  doubleClick(px: number, py: number): void;
  measureFrom(px: number, py: number): void;
  measureTo(px: number, py: number): void;
  hover(px: number, py: number): void;
  leave(): void;
  measuring(): boolean; // drags measure also without shift
}

const DRAG_PX = 4; // a pointer moved less than this has clicked
const LINE_PX = 16; // of wheels that count lines

export function listenGestures(element: HTMLElement, gestures: Gestures): void {
  let from: { x: number; y: number; id: number; measure: boolean; dragged: boolean } | null = null;
  element.addEventListener('pointerdown', (event) => {
    if (event.button !== 0) return;
    const { x, y } = place(element, event);
    const measure = event.shiftKey || gestures.measuring();
    from = { x, y, id: event.pointerId, measure, dragged: false };
    element.setPointerCapture(event.pointerId);
    element.focus({ preventScroll: true });
    if (measure) gestures.measureFrom(x, y);
  });
  element.addEventListener('pointermove', (event) => {
    const { x, y } = place(element, event);
    gestures.hover(x, y);
    if (from === null || event.pointerId !== from.id) return;
    if (!from.dragged && Math.hypot(x - from.x, y - from.y) < DRAG_PX) return;
    from.dragged = true;
    if (from.measure) {
      gestures.measureTo(x, y);
      return;
    }
    gestures.pan(x - from.x, y - from.y);
    from.x = x;
    from.y = y;
  });
  element.addEventListener('pointerup', (event) => {
    const done = from;
    from = null;
    if (done === null || done.dragged || done.measure) return;
    const { x, y } = place(element, event);
    gestures.click(x, y);
  });
  element.addEventListener('pointercancel', () => {
    from = null;
  });
  element.addEventListener('pointerleave', () => gestures.leave());
  element.addEventListener('dblclick', (event) => {
    const { x, y } = place(element, event);
    gestures.doubleClick(x, y);
  });
  element.addEventListener(
    'wheel',
    (event) => {
      event.preventDefault();
      const { x, y } = place(element, event);
      gestures.zoom(wheelFactor(event.deltaY, event.deltaMode), x, y);
    },
    { passive: false },
  );
}

// How much one turn of the wheel zooms; deltaMode 0 counts pixels, 1 lines, 2 pages.
export function wheelFactor(deltaY: number, deltaMode: number): number {
  const pixels = deltaMode === 0 ? deltaY : deltaMode === 1 ? deltaY * LINE_PX : deltaY * 20 * LINE_PX;
  return Math.exp(-Math.min(Math.max(pixels, -400), 400) * 0.0018);
}

function place(element: HTMLElement, event: MouseEvent): { x: number; y: number } {
  const box = element.getBoundingClientRect();
  return { x: event.clientX - box.left, y: event.clientY - box.top };
}
