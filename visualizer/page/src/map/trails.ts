// Trails: the way of each object over the last seconds, from frames picked at fixed times so that
// the line does not flicker as time goes on.

import { Col, type PackedFrame, STRIDE } from '../model/packed_frame';
import type { TimeBuffer } from '../model/time_buffer';
import type { Trail } from '../shell/settings';
import type { Surface } from './surface';
import { screenX, screenY, type View } from './view';

const POINTS = 60;
const POINTS_OF_MANY = 30; // when there are over 200 objects
const POINTS_OF_ALL = 240; // of a whole run
// Points nearer than this to the last are left out.
const NEAR_PX = 1.5;

// The frames that a trail goes through, oldest first, the one shown last. `into` is reused.
export function trailFrames(
  frames: TimeBuffer<PackedFrame>,
  shown: PackedFrame,
  tUs: number,
  trail: Trail,
  into: PackedFrame[],
): void {
  into.length = 0;
  const fromUs = trail === 'all' ? (frames.first?.tUs ?? tUs) : tUs - trail * 1e6;
  const stepUs = trailStepUs(trail, shown.layout.ids.length, tUs - fromUs);
  let last = -1;
  for (let t = Math.ceil(fromUs / stepUs) * stepUs; t < tUs; t += stepUs) {
    const index = frames.indexAt(t);
    const frame = frames.at(index);
    if (index === last || frame === null || frame.tUs < fromUs - stepUs) continue;
    into.push(frame);
    last = index;
  }
  into.push(shown);
}

function trailStepUs(trail: Trail, objects: number, spanUs: number): number {
  if (trail !== 'all') return (trail * 1e6) / (objects > 200 ? POINTS_OF_MANY : POINTS);
  // Steps of a run that grows: doubled now and then, so that most points stay where they are.
  return 2 ** Math.ceil(Math.log2(Math.max(spanUs / POINTS_OF_ALL, 10_000)));
}

// Adds the trail of the object in a row of the frame shown to the path.
export function addTrail(surface: Surface, view: View, frames: readonly PackedFrame[], row: number): void {
  const shown = frames[frames.length - 1];
  if (shown === undefined) return;
  const id = shown.layout.ids[row] ?? -1;
  let lastX = NaN;
  let lastY = NaN;
  for (const frame of frames) {
    const at = frame.layout === shown.layout ? row : frame.layout.rowOf.get(id);
    if (at === undefined) continue;
    const x = screenX(view, frame.data[at * STRIDE + Col.x] ?? NaN);
    const y = screenY(view, frame.data[at * STRIDE + Col.y] ?? NaN);
    if (Number.isNaN(lastX)) {
      surface.moveTo(x, y);
    } else if (frame === shown || Math.abs(x - lastX) > NEAR_PX || Math.abs(y - lastY) > NEAR_PX) {
      surface.lineTo(x, y);
    } else {
      continue;
    }
    lastX = x;
    lastY = y;
  }
}
