// The quantities that have curves, each from one row of a frame. SI units.

import { Col, type PackedFrame, STRIDE } from '../model/packed_frame';

export type Quantity =
  | 'positionError'
  | 'velocityError'
  | 'x'
  | 'y'
  | 'xEst'
  | 'yEst'
  | 'comfort'
  | 'nearest';

const COLUMNS: Readonly<Record<Exclude<Quantity, 'positionError' | 'velocityError' | 'nearest'>, number>> = {
  x: Col.x,
  y: Col.y,
  xEst: Col.xEst,
  yEst: Col.yEst,
  comfort: Col.comfort,
};

// The value of an object in a frame; NaN where there is none.
export function quantityAt(quantity: Quantity, frame: PackedFrame, row: number): number {
  const at = row * STRIDE;
  if (quantity === 'positionError') return distance(frame.data, at + Col.x, at + Col.xEst);
  if (quantity === 'velocityError') return distance(frame.data, at + Col.vx, at + Col.vxEst);
  if (quantity === 'nearest') return nearest(frame.data, at);
  return frame.data[at + COLUMNS[quantity]] ?? NaN;
}

// True distance (m) of the object at a place to the nearest other one, NaN when there is no other.
function nearest(data: Float32Array, at: number): number {
  let least = Infinity;
  for (let other = 0; other < data.length; other += STRIDE) {
    if (other !== at) least = Math.min(least, distance(data, at + Col.x, other + Col.x));
  }
  return least < Infinity ? least : NaN;
}

// Length of the difference of two vectors of three columns, which begin at these places.
function distance(data: Float32Array, one: number, other: number): number {
  const dx = (data[other] ?? NaN) - (data[one] ?? NaN);
  const dy = (data[other + 1] ?? NaN) - (data[one + 1] ?? NaN);
  const dz = (data[other + 2] ?? NaN) - (data[one + 2] ?? NaN);
  return Math.sqrt(dx * dx + dy * dy + dz * dz);
}
