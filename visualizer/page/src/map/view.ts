// Which part of the world the map shows: metres to CSS pixels and back. The world's y points north,
// the screen's down. Pure.

export interface Size {
  readonly width: number; // CSS pixels
  readonly height: number;
}

export interface View {
  readonly x: number; // m, at the middle of the map
  readonly y: number;
  readonly scale: number; // CSS pixels a metre
  readonly size: Size;
}

export interface Bounds {
  readonly minX: number; // m
  readonly minY: number;
  readonly maxX: number;
  readonly maxY: number;
}

export const MIN_SCALE = 0.05;
export const MAX_SCALE = 5000;
// Part of the map that stays free on each side of what is fitted.
const MARGIN = 0.06;

export function screenX(view: View, x: number): number {
  return view.size.width / 2 + (x - view.x) * view.scale;
}

export function screenY(view: View, y: number): number {
  return view.size.height / 2 - (y - view.y) * view.scale;
}

export function worldX(view: View, px: number): number {
  return view.x + (px - view.size.width / 2) / view.scale;
}

export function worldY(view: View, py: number): number {
  return view.y - (py - view.size.height / 2) / view.scale;
}

// The view moved by a drag of so many CSS pixels.
export function panned(view: View, dx: number, dy: number): View {
  return { ...view, x: view.x - dx / view.scale, y: view.y + dy / view.scale };
}

// Zoomed so that what is under the point (CSS pixels) stays there.
export function zoomedAt(view: View, factor: number, px: number, py: number): View {
  const scale = Math.min(Math.max(view.scale * factor, MIN_SCALE), MAX_SCALE);
  const keep = { x: worldX(view, px), y: worldY(view, py) };
  return {
    ...view,
    scale,
    x: keep.x - (px - view.size.width / 2) / scale,
    y: keep.y + (py - view.size.height / 2) / scale,
  };
}

// The view that shows all of the bounds, as large as possible.
export function fitted(bounds: Bounds, size: Size): View {
  const width = Math.max(bounds.maxX - bounds.minX, 0.5);
  const height = Math.max(bounds.maxY - bounds.minY, 0.5);
  const free = 1 - 2 * MARGIN;
  const scale = Math.min((size.width * free) / width, (size.height * free) / height);
  return {
    x: (bounds.minX + bounds.maxX) / 2,
    y: (bounds.minY + bounds.maxY) / 2,
    scale: Math.min(Math.max(scale, MIN_SCALE), MAX_SCALE),
    size,
  };
}

// Bounds of points given as x, y, x, y ...; null without any finite one.
export function boundsOf(points: Iterable<readonly [number, number]>): Bounds | null {
  let minX = Infinity;
  let minY = Infinity;
  let maxX = -Infinity;
  let maxY = -Infinity;
  for (const [x, y] of points) {
    if (!Number.isFinite(x) || !Number.isFinite(y)) continue;
    minX = Math.min(minX, x);
    minY = Math.min(minY, y);
    maxX = Math.max(maxX, x);
    maxY = Math.max(maxY, y);
  }
  return minX <= maxX ? { minX, minY, maxX, maxY } : null;
}

// The round length (1, 2 or 5 times a power of ten, m) nearest below so many CSS pixels: of a scale
// bar, or the distance of grid lines.
export function roundLength(scale: number, px: number): number {
  const metres = px / scale;
  const power = 10 ** Math.floor(Math.log10(metres));
  const digit = metres / power;
  return power * (digit >= 5 ? 5 : digit >= 2 ? 2 : 1);
}
