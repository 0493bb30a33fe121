// Values of objects in a frame's columns, and where they are on the screen.

import { Col, type PackedFrame, STRIDE } from '../model/packed_frame';
import { screenX, screenY, type View } from './view';

// Value of an object in a frame; NaN for a row that is not there.
export function valueAt(frame: PackedFrame, row: number, column: number): number {
  return frame.data[row * STRIDE + column] ?? NaN;
}

export function objectX(view: View, frame: PackedFrame, row: number): number {
  return screenX(view, valueAt(frame, row, Col.x));
}

export function objectY(view: View, frame: PackedFrame, row: number): number {
  return screenY(view, valueAt(frame, row, Col.y));
}
