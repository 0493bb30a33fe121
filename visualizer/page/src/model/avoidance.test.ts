import { expect, it } from 'vitest';
import { AvoidanceSpans } from './avoidance';
import { type PackedFrame, packFrame } from './packed_frame';
import { anObject } from './testing';
import { TimeBuffer } from './time_buffer';

const frame = (tUs: number, ...avoiding: number[]): PackedFrame => {
  const objects = [1, 2].map((id) => anObject(id, { flags: avoiding.includes(id) ? 2 | 4 : 4 }));
  return packFrame({ tUs, run: 1, seq: tUs, objects }, null);
};

it('spans run from the first frame of avoiding to the first without, and grow with the frames', () => {
  const frames = new TimeBuffer<PackedFrame>(1e6);
  const spans = new AvoidanceSpans();
  for (const [t, ...ids] of [[0], [10, 1], [20, 1], [30], [40, 1, 2]] as const) frames.add(frame(t, ...ids));
  expect(spans.of(1, frames)).toEqual([
    { fromUs: 10, toUs: 30 },
    { fromUs: 40, toUs: 40 },
  ]);
  frames.add(frame(50, 1));
  expect(spans.of(1, frames)).toEqual([
    { fromUs: 10, toUs: 30 },
    { fromUs: 40, toUs: 50 },
  ]);
  expect(spans.of(2, frames)).toEqual([{ fromUs: 40, toUs: 50 }]);
  expect(spans.of(9, frames)).toEqual([]);
});

it('begins anew when the frames are others', () => {
  const frames = new TimeBuffer<PackedFrame>(1e6);
  const spans = new AvoidanceSpans();
  frames.add(frame(10, 1));
  expect(spans.of(1, frames)).toHaveLength(1);
  frames.clear();
  frames.add(frame(20));
  expect(spans.of(1, frames)).toEqual([]);
});

it('begins anew for another log, though neither was edited', () => {
  const [first, second] = [new TimeBuffer<PackedFrame>(1e6), new TimeBuffer<PackedFrame>(1e6)];
  for (const t of [0, 10]) first.add(frame(t, 1));
  for (const t of [100, 110, 120]) second.add(frame(t));
  const spans = new AvoidanceSpans();
  expect(spans.of(1, first)).toHaveLength(1);
  expect(spans.of(1, second)).toEqual([]);
});
