import { expect, it } from 'vitest';
import { type PackedFrame, packFrame } from '../model/packed_frame';
import { anObject } from '../model/testing';
import { TimeBuffer } from '../model/time_buffer';
import { SvgSurface } from './svg_surface';
import { addTrail, trailFrames } from './trails';

const view = { x: 0, y: 0, scale: 100, size: { width: 200, height: 200 } };

function framesOf(seconds: number): TimeBuffer<PackedFrame> {
  const frames = new TimeBuffer<PackedFrame>(1e9);
  for (let i = 0; i <= seconds * 60; i++) {
    const objects = [anObject(1, { pos: [i / 60, 0, 1] }), anObject(2, { pos: [0, 0, 1] })];
    frames.add(
      packFrame({ tUs: Math.round((i * 1e6) / 60), run: 1, seq: i, objects }, frames.last?.layout ?? null),
    );
  }
  return frames;
}

function picked(frames: TimeBuffer<PackedFrame>, tUs: number, trail: 2 | 10 | 'all'): PackedFrame[] {
  const into: PackedFrame[] = [];
  const shown = frames.at(frames.indexAt(tUs));
  if (shown !== null) trailFrames(frames, shown, tUs, trail, into);
  return into;
}

it('goes as far back as asked and ends at the vehicle', () => {
  const frames = framesOf(20);
  for (const [trail, from] of [
    [2, 10],
    [10, 2],
    ['all', 0],
  ] as const) {
    const times = picked(frames, 12e6, trail).map((frame) => frame.tUs / 1e6);
    expect(Math.abs((times[0] ?? NaN) - from)).toBeLessThan(0.2);
    expect(times[times.length - 1]).toBe(12);
    expect(times).toEqual([...times].sort((a, b) => a - b));
    expect(times.length).toBeLessThan(400);
  }
});

it('keeps its points as time goes on, so that the line does not flicker', () => {
  const frames = framesOf(20);
  const before = new Set(picked(frames, 12e6, 10).map((frame) => frame.tUs));
  const after = picked(frames, 12.05e6, 10)
    .map((frame) => frame.tUs)
    .slice(2, -2);
  expect(after.every((tUs) => before.has(tUs))).toBe(true);
});

it('is one line per object; what stands still has only its begin and end', () => {
  const into = picked(framesOf(3), 3e6, 2);
  const path = (row: number): string => {
    const surface = new SvgSurface();
    surface.beginPath();
    addTrail(surface, view, into, row);
    surface.stroke();
    return surface.document(1, 1, '');
  };
  expect(path(0).split('L').length - 1).toBeGreaterThan(30);
  expect(path(1)).toContain('d="M100 100L100 100"');
});

it('follows an object through frames that have other objects', () => {
  const frames = new TimeBuffer<PackedFrame>(1e9);
  frames.add(packFrame({ tUs: 0, run: 1, seq: 0, objects: [anObject(5, { pos: [0.5, 0, 0] })] }, null));
  const both = [anObject(3, { pos: [9, 9, 0] }), anObject(5, { pos: [0.75, 0, 0] })];
  frames.add(packFrame({ tUs: 1e6, run: 1, seq: 1, objects: both }, null));
  const surface = new SvgSurface();
  surface.beginPath();
  addTrail(surface, view, picked(frames, 1e6, 2), 1);
  surface.stroke();
  expect(surface.document(1, 1, '')).toContain('d="M150 100L175 100"');
});
