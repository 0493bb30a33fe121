// Risk contours in little memory, as packed_frame.ts does for frames: nine values an ellipse.

import type { Ellipse, Risk } from '../../../codec/messages';

// Where a value of an ellipse lies in its row. Metres, radians, seconds.
export const RiskCol = {
  about: 0,
  kind: 1,
  overlap: 2,
  x: 3,
  y: 4,
  rx: 5,
  ry: 6,
  theta: 7,
  age: 8,
} as const;

export const RISK_STRIDE = 9;

export interface PackedRisk {
  readonly tUs: number;
  readonly run: number;
  readonly observer: number;
  readonly data: Float32Array; // RISK_STRIDE values an ellipse
  readonly bytes: number; // estimated
}

const OVERHEAD_BYTES = 200;

// Packs the contours of one moment. Object ids above 2^24 would lose digits in `about`, which only
// names the contour.
export function packRisk(risk: Risk): PackedRisk {
  const data = new Float32Array(risk.ellipses.length * RISK_STRIDE);
  risk.ellipses.forEach((e, row) => {
    const values = [e.about, e.kind, e.overlap ? 1 : 0, e.x, e.y, e.rx, e.ry, e.theta, e.age];
    data.set(values, row * RISK_STRIDE);
  });
  const bytes = data.byteLength + OVERHEAD_BYTES;
  return { tUs: risk.tUs, run: risk.run, observer: risk.observer, data, bytes };
}

// The contours as objects again.
export function unpackRisk(packed: PackedRisk): Risk {
  const ellipses: Ellipse[] = [];
  for (let at = 0; at < packed.data.length; at += RISK_STRIDE) {
    const value = (column: number): number => packed.data[at + column] ?? NaN;
    ellipses.push({
      about: value(RiskCol.about),
      kind: value(RiskCol.kind),
      overlap: value(RiskCol.overlap) !== 0,
      x: value(RiskCol.x),
      y: value(RiskCol.y),
      rx: value(RiskCol.rx),
      ry: value(RiskCol.ry),
      theta: value(RiskCol.theta),
      age: value(RiskCol.age),
    });
  }
  return { tUs: packed.tUs, run: packed.run, observer: packed.observer, ellipses };
}
