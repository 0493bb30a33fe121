// What the map draws on: the part of a canvas context that it uses. A canvas is one, svg_surface.ts
// another, so that the exported picture is drawn by the same code.

export type Surface = Pick<
  CanvasRenderingContext2D,
  | 'beginPath'
  | 'closePath'
  | 'moveTo'
  | 'lineTo'
  | 'rect'
  | 'ellipse'
  | 'fill'
  | 'stroke'
  | 'fillText'
  | 'setLineDash'
  | 'fillStyle'
  | 'strokeStyle'
  | 'lineWidth'
  | 'lineJoin'
  | 'font'
  | 'textAlign'
  | 'textBaseline'
  | 'globalAlpha'
>;

export const FULL_CIRCLE = 2 * Math.PI;

// A circle as a path of its own.
export function circle(surface: Surface, x: number, y: number, radius: number): void {
  surface.moveTo(x + radius, y);
  surface.ellipse(x, y, radius, radius, 0, 0, FULL_CIRCLE);
}
