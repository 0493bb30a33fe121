// Reads VIZ_FRAME by hand, because it comes 60 times a second with up to 1000 objects; the schema's reader, which
// the tests compare it with, takes several times as long.

import { BadBytes, Reader } from './bytes';
import type { Frame, VizObject } from './messages';

const objectSize = 78;

function readObject(view: DataView, at: number): VizObject {
  const f = (offset: number): number => view.getFloat32(at + offset);
  return {
    id: view.getInt32(at),
    kind: view.getInt8(at + 4),
    flags: view.getInt8(at + 5),
    pos: [f(6), f(10), f(14)],
    vel: [f(18), f(22), f(26)],
    yaw: f(30),
    roll: f(34),
    pitch: f(38),
    posEst: [f(42), f(46), f(50)],
    velEst: [f(54), f(58), f(62)],
    comfort: f(66),
    steer: [f(70), f(74)],
  };
}

// A payload whose fingerprint is right. Throws BadBytes.
export function decodeFrame(payload: Uint8Array): Frame {
  const reader = new Reader(payload, 8);
  const tUs = reader.int64('frame.t_us');
  const run = reader.int32('frame.run');
  const seq = reader.int32('frame.seq');
  const n = reader.int32('frame.n');
  if (n < 0 || n * objectSize !== reader.left)
    throw new BadBytes(`frame.objects: ${n} of ${objectSize} bytes, ${reader.left} bytes are left`);
  const objects: VizObject[] = [];
  for (let at = reader.at; at < reader.end; at += objectSize) objects.push(readObject(reader.view, at));
  return { tUs, run, seq, objects };
}
