// Which object is meant by a point of the map.

import { Col, type PackedFrame, STRIDE } from '../model/packed_frame';
import { glyphRadius } from './glyphs';
import { screenX, screenY, type View } from './view';

const LEAST_REACH_PX = 14; // fingers and hasty mice

// Id of the object nearest to the point (CSS pixels) that is within reach, -1 when none is.
export function pick(view: View, frame: PackedFrame | null, px: number, py: number): number {
  let best = Math.max(glyphRadius(view.scale) * 1.6, LEAST_REACH_PX);
  let found = -1;
  const ids = frame?.layout.ids ?? new Int32Array();
  for (let row = 0; row < ids.length; row++) {
    const x = screenX(view, frame?.data[row * STRIDE + Col.x] ?? NaN);
    const y = screenY(view, frame?.data[row * STRIDE + Col.y] ?? NaN);
    const distance = Math.hypot(x - px, y - py);
    if (distance < best) {
      best = distance;
      found = ids[row] ?? -1;
    }
  }
  return found;
}
