import { describe, expect, it } from 'vitest';
import { SvgSurface } from '../map/svg_surface';
import { testPalette } from '../map/testing';
import { type PackedFrame, packFrame } from '../model/packed_frame';
import { anObject } from '../model/testing';
import { TimeBuffer } from '../model/time_buffer';
import { drawCurves } from './curves_picture';
import { decimate, firstAt } from './decimate';
import { curvesOf, GROUPS, type Group } from './groups';
import { quantityAt } from './quantity';
import { axisRange } from './scale';
import { Growing, Tracks } from './tracks';

const growing = (values: readonly number[]): Growing => {
  const made = new Growing();
  for (const value of values) made.push(value);
  return made;
};

const frame = (tUs: number, error = 0): PackedFrame =>
  packFrame(
    {
      tUs,
      run: 1,
      seq: tUs,
      objects: [
        anObject(1, {
          pos: [0, 0, 0],
          posEst: [error, 0, 0],
          vel: [1, 2, 2],
          velEst: [0, 0, 0],
          comfort: 0.7,
        }),
        anObject(2, { pos: [3, 4, 0] }),
        anObject(3, { pos: [0, 0, 9] }),
      ],
    },
    null,
  );

describe('quantities', () => {
  it('are those of one object', () => {
    const of = (quantity: Parameters<typeof quantityAt>[0]) => quantityAt(quantity, frame(0, 0.5), 0);
    expect([of('positionError'), of('velocityError'), of('nearest'), of('x'), of('xEst')]).toEqual([
      0.5, 3, 5, 0, 0.5,
    ]);
    expect(of('comfort')).toBeCloseTo(0.7);
  });

  it('alone there is no nearest', () => {
    const alone = packFrame({ tUs: 0, run: 1, seq: 0, objects: [anObject(1)] }, null);
    expect(quantityAt('nearest', alone, 0)).toBeNaN();
  });
});

describe('tracks', () => {
  it('grow with the frames and compute each frame once', () => {
    const frames = new TimeBuffer<PackedFrame>(1e6);
    const tracks = new Tracks();
    frames.add(frame(0, 1));
    const { values } = tracks.of(1, 'positionError', frames);
    frames.add(frame(10, 2));
    expect(tracks.of(1, 'positionError', frames).values).toBe(values);
    expect([values.length, values.at(0), values.at(1)]).toEqual([2, 1, 2]);
    expect(tracks.times.at(1)).toBe(10);
  });

  it('are made anew when the frames were thinned or are of another run', () => {
    const frames = new TimeBuffer<PackedFrame>(1e6);
    const tracks = new Tracks();
    frames.add(frame(10, 1));
    tracks.of(1, 'positionError', frames);
    frames.add(frame(5, 2)); // a late one
    const { values } = tracks.of(1, 'positionError', frames);
    expect([values.at(0), values.at(1)]).toEqual([2, 1]);
    expect(tracks.times.at(0)).toBe(5);
  });

  it('are made anew for another log, though neither was edited', () => {
    const [first, second] = [new TimeBuffer<PackedFrame>(1e6), new TimeBuffer<PackedFrame>(1e6)];
    for (const [index, value] of [7, 8].entries()) first.add(frame(index, value));
    for (const [index, value] of [1, 2, 3].entries()) second.add(frame(100 + index, value));
    const tracks = new Tracks();
    tracks.of(1, 'positionError', first);
    const { values } = tracks.of(1, 'positionError', second);
    expect([values.length, values.at(0), values.at(2)]).toEqual([3, 1, 3]);
    expect([tracks.times.length, tracks.times.at(0)]).toEqual([3, 100]);
  });

  it('have gaps where the object is missing', () => {
    const frames = new TimeBuffer<PackedFrame>(1e6);
    frames.add(frame(0));
    expect(new Tracks().of(99, 'x', frames).values.at(0)).toBeNaN();
  });
});

describe('decimation', () => {
  const n = 10_000;
  const times = growing(Array.from({ length: n }, (_, i) => i * 1000));
  const wave = growing(Array.from({ length: n }, (_, i) => Math.sin(i / 300) + (i === 5555 ? 50 : 0)));

  it('finds the first time at or after one', () => {
    expect([firstAt(times, -1), firstAt(times, 1000), firstAt(times, 1001), firstAt(times, 1e12)]).toEqual([
      0,
      1,
      2,
      n,
    ]);
  });

  it('keeps all of a few', () => {
    const { seconds, points } = decimate(times, [wave], 0, 50_000, 100);
    expect(seconds).toHaveLength(51);
    expect(points[0]?.[3]).toBe(wave.at(3));
  });

  it('keeps every extreme of many, in ascending time, in few points', () => {
    const { seconds, points } = decimate(times, [wave], 0, n * 1000, 200);
    expect(seconds.length).toBeLessThanOrEqual(402);
    expect(seconds.length).toBe(points[0]?.length);
    for (let i = 1; i < seconds.length; i++) expect(seconds[i] ?? 0).toBeGreaterThan(seconds[i - 1] ?? 0);
    const values = (points[0] ?? []).filter((value) => value !== null);
    let min = Infinity;
    for (let i = 0; i < n; i++) min = Math.min(min, wave.at(i));
    expect(Math.max(...values)).toBe(wave.at(5555));
    expect(Math.min(...values)).toBe(min);
  });

  it('leaves gaps where there is nothing', () => {
    const holes = growing(Array.from({ length: n }, (_, i) => (i < n / 2 ? NaN : 1)));
    const { points } = decimate(times, [holes], 0, n * 1000, 100);
    expect(points[0]?.[0]).toBeNull();
    expect(points[0]?.at(-1)).toBe(1);
  });
});

it('axes of errors begin at zero, others leave room', () => {
  expect(axisRange(0.5, 1, true)).toEqual([0, 1.12]);
  const [low, high] = axisRange(-2, 8, false);
  expect([low < -2, high > 8]).toEqual([true, true]);
  expect(axisRange(null, null, true)).toEqual([0, 1]);
  const [least, most] = axisRange(1e38, 1e38, false);
  expect(most).toBeGreaterThan(least);
});

it("each object has all curves of a group, the observer's first", () => {
  const curves = curvesOf(GROUPS[0] as Group, [4, 7]);
  expect(curves.map(({ object, kind }) => `${object} ${kind.quantity}`)).toEqual([
    '4 positionError',
    '4 velocityError',
    '7 positionError',
    '7 velocityError',
  ]);
});

it('the picture has each curve as a line within the plot, and its name', () => {
  const surface = new SvgSurface();
  const group = GROUPS[0] as Group;
  const [position, velocity] = curvesOf(group, [4]);
  if (position === undefined || velocity === undefined) throw new Error('no curves');
  drawCurves(surface, {
    area: { width: 924, span: { fromUs: 0, toUs: 8e6 } },
    top: 0,
    height: 146,
    palette: testPalette,
    group,
    seconds: [0, 4, 8],
    endsS: [6],
    curves: [
      { curve: position, name: 'Q4 position error', points: [0, 1, null] },
      { curve: velocity, name: 'Q4 velocity error', points: [0, 0, 0] },
    ],
  });
  const svg = surface.document(924, 146, '');
  // 100 px for 0 to 1.12: a value of 1 stands 89.29 px above the axis at 122.
  expect(svg).toContain('d="M72 122L472 32.71"');
  expect(svg).toContain('M672 22L672 122');
  expect(svg).toContain('>Q4 velocity error</text>');
});

it('the legend goes on in further lines when one is full, above the plot', () => {
  const surface = new SvgSurface();
  const group = GROUPS[0] as Group;
  const curves = curvesOf(group, [1, 2, 3, 4, 5, 6, 7]).map((curve) => ({
    curve,
    name: `Q${curve.object} ${curve.kind.name}`,
    points: [0, 1],
  }));
  const area = { width: 924, span: { fromUs: 0, toUs: 8e6 } };
  drawCurves(surface, {
    area,
    top: 0,
    height: 300,
    palette: testPalette,
    group,
    seconds: [0, 8],
    curves,
    endsS: [],
  });
  const svg = surface.document(924, 300, '');
  const places = [...svg.matchAll(/<text x="([\d.]+)" y="([\d.]+)"[^>]*>Q\d/g)].map((match) =>
    match.slice(1).map(Number),
  );
  expect(places).toHaveLength(14);
  expect(places.every(([x]) => (x ?? 0) + 'Q1 position error'.length * 6.2 < 924)).toBe(true);
  const lines = new Set(places.map(([, y]) => y));
  expect(lines.size).toBeGreaterThan(1);
  const top = Number(/d="M72 (\d+)L72 \d+/.exec(svg)?.[1]);
  expect(Math.max(...places.map(([, y]) => y ?? 0))).toBeLessThan(top);
});
