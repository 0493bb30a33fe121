import { expect, it } from 'vitest';
import type { Frame } from '../../../codec/messages';
import { Col, packFrame, STRIDE, unpackFrame } from './packed_frame';
import { packRisk, unpackRisk } from './packed_risk';
import { anObject, aRisk } from './testing';

const frame = (ids: number[]): Frame => ({
  tUs: 5,
  run: 2,
  seq: 3,
  objects: ids.map((id) =>
    anObject(id, {
      kind: 1,
      flags: 5,
      pos: [1, 2, 3],
      vel: [4, 5, 6],
      yaw: 0.5,
      roll: 0.25,
      pitch: -0.5,
      posEst: [7, 8, 9],
      velEst: [10, 11, 12],
      comfort: 0.75,
      steer: [0.125, -0.125],
    }),
  ),
});

it('a frame comes back as it was', () => {
  expect(unpackFrame(packFrame(frame([3, 70000]), null))).toEqual(frame([3, 70000]));
});

it('columns hold what their names say', () => {
  const packed = packFrame(frame([3, 9]), null);
  const second = (column: number) => packed.data[STRIDE + column];
  expect([Col.x, Col.vy, Col.zEst, Col.comfort, Col.steer1].map(second)).toEqual([1, 5, 9, 0.75, -0.125]);
  expect(packed.layout.rowOf.get(9)).toBe(1);
});

it('frames of the same objects share their layout, others do not', () => {
  const first = packFrame(frame([1, 2]), null);
  expect(packFrame(frame([1, 2]), first.layout).layout).toBe(first.layout);
  expect(packFrame(frame([1, 3]), first.layout).layout).not.toBe(first.layout);
  expect(packFrame(frame([1]), first.layout).layout.ids).toEqual(Int32Array.of(1));
});

it('contours come back as they were', () => {
  expect(unpackRisk(packRisk(aRisk(4, 9)))).toEqual(aRisk(4, 9));
});
