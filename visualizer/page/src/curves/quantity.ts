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

// The value of an object in a frame; NaN where there is none.
export function quantityAt(quantity: Quantity, frame: PackedFrame, row: number): number {
  const at = row * STRIDE;
  const value = (column: number): number => frame.data[at + column] ?? NaN;
  switch (quantity) {
    case 'positionError':
      return distance(frame, at, Col.x, at, Col.xEst);
    case 'velocityError':
      return distance(frame, at, Col.vx, at, Col.vxEst);
    case 'x':
      return value(Col.x);
    case 'y':
      return value(Col.y);
    case 'xEst':
      return value(Col.xEst);
    case 'yEst':
      return value(Col.yEst);
    case 'comfort':
      return value(Col.comfort);
    case 'nearest':
      return nearest(frame, at);
  }
}

// True distance (m) to the nearest other object, NaN when there is no other.
function nearest(frame: PackedFrame, at: number): number {
  let least = Infinity;
  for (let other = 0; other < frame.data.length; other += STRIDE) {
    if (other !== at) least = Math.min(least, distance(frame, at, Col.x, other, Col.x));
  }
  return least < Infinity ? least : NaN;
}

// Length of the difference of two vectors of three columns.
function distance({ data }: PackedFrame, row: number, from: number, otherRow: number, to: number): number {
  const dx = (data[otherRow + to] ?? NaN) - (data[row + from] ?? NaN);
  const dy = (data[otherRow + to + 1] ?? NaN) - (data[row + from + 1] ?? NaN);
  const dz = (data[otherRow + to + 2] ?? NaN) - (data[row + from + 2] ?? NaN);
  return Math.sqrt(dx * dx + dy * dy + dz * dz);
}
