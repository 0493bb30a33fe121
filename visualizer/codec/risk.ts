// Reads VIZ_RISK by hand, which comes with each frame.

import { BadBytes, Reader } from './bytes';
import type { Ellipse, Risk } from './messages';

const ellipseSize = 30;

function readEllipse(view: DataView, at: number): Ellipse {
  const f = (offset: number): number => view.getFloat32(at + offset);
  return {
    about: view.getInt32(at),
    kind: view.getInt8(at + 4),
    overlap: view.getInt8(at + 5) !== 0,
    x: f(6),
    y: f(10),
    rx: f(14),
    ry: f(18),
    theta: f(22),
    age: f(26),
  };
}

// A payload whose fingerprint is right. Throws BadBytes.
export function decodeRisk(payload: Uint8Array): Risk {
  const reader = new Reader(payload, 8);
  const tUs = reader.int64('risk.t_us');
  const run = reader.int32('risk.run');
  const observer = reader.int32('risk.observer');
  const n = reader.int32('risk.n');
  if (n < 0 || n * ellipseSize !== reader.left)
    throw new BadBytes(`risk.ellipses: ${n} of ${ellipseSize} bytes, ${reader.left} bytes are left`);
  const ellipses: Ellipse[] = [];
  for (let at = reader.at; at < reader.end; at += ellipseSize) ellipses.push(readEllipse(reader.view, at));
  return { tUs, run, observer, ellipses };
}
