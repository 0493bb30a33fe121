import { describe, expect, it } from 'vitest';
import { packFrame } from '../model/packed_frame';
import { anObject } from '../model/testing';
import { FrameCounter } from './frame_counter';
import { wheelFactor } from './gestures';
import { lengthText } from './length_text';
import { shortNameOf } from '../model/short_name';
import { objectColor } from './palette';
import { pick } from './picking';
import { Places } from './places';
import { headingStep } from './stamps';
import { worldBounds } from './world_bounds';

const view = { x: 0, y: 0, scale: 10, size: { width: 200, height: 200 } };
const frame = packFrame(
  {
    tUs: 0,
    run: 1,
    seq: 0,
    objects: [anObject(4, { pos: [1, 0, 0] }), anObject(7, { pos: [2, 0, 0] })],
  },
  null,
);

describe('picking', () => {
  it('means the nearest within reach', () => {
    expect(pick(view, frame, 111, 100)).toBe(4);
    expect(pick(view, frame, 119, 103)).toBe(7);
    expect(pick(view, frame, 150, 100)).toBe(-1);
    expect(pick(view, null, 110, 100)).toBe(-1);
  });
});

describe('the wheel', () => {
  it('zooms in when turned away, as much out again, lines like pixels', () => {
    expect(wheelFactor(-100, 0)).toBeGreaterThan(1.1);
    expect(wheelFactor(-100, 0) * wheelFactor(100, 0)).toBeCloseTo(1);
    expect(wheelFactor(3, 1)).toBeCloseTo(wheelFactor(48, 0));
    expect(wheelFactor(1e9, 0)).toBeGreaterThan(0.4);
  });
});

it('marks of one size are kept apart', () => {
  const places = new Places(20, 10);
  places.begin();
  expect([places.free(0, 0), places.free(5, 2), places.free(100, 0)]).toEqual([0, 12, 0]);
  places.begin();
  expect(places.free(0, 0)).toBe(0);
});

it('headings go round', () => {
  expect([headingStep(0), headingStep(Math.PI), headingStep(-Math.PI / 2), headingStep(2 * Math.PI)]).toEqual(
    [0, 32, 48, 0],
  );
});

it('frames a second are those of the last one', () => {
  const counter = new FrameCounter();
  for (let i = 0; i < 300; i++) counter.count(i * 20);
  expect(counter.drawn).toBe(300);
  expect(counter.perSecond(299 * 20)).toBe(50);
  expect(counter.perSecond(299 * 20 + 5000)).toBe(0);
});

it('lengths and names are short', () => {
  expect([lengthText(2, 'mm'), lengthText(0.5, 'mm')]).toEqual(['2000 mm', '500 mm']);
  expect([lengthText(2), lengthText(0.05), lengthText(1500), lengthText(0.123456)]).toEqual([
    '2 m',
    '50 mm',
    '1.5 km',
    '0.123 m',
  ]);
  expect([shortNameOf(3, 0), shortNameOf(1, 1), shortNameOf(9, 2)]).toEqual(['Q3', 'C1', 'O9']);
});

it('objects have one of a few colours, also with a negative id', () => {
  expect(objectColor(7)).toBe(objectColor(1));
  expect(objectColor(-5)).toBe(objectColor(1));
});

it('what fits holds terrain, areas, anchors and objects', () => {
  const world = {
    run: 1,
    version: 1,
    seg: [[-3, 0, 0, 1] as const],
    anchors: [{ id: 1, pos: [0, -4, 9] as const }],
    polys: [{ name: '', role: 2, pt: [[0, 5, 0] as const] }],
  };
  expect(worldBounds(world, frame)).toEqual({ minX: -3, minY: -4, maxX: 2, maxY: 5 });
  expect(worldBounds(null, null)).toBeNull();
});
