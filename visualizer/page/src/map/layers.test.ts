import { describe, expect, it } from 'vitest';
import { packFrame } from '../model/packed_frame';
import { packRisk } from '../model/packed_risk';
import { anObject } from '../model/testing';
import { drawMovingLayers } from './moving_layers';
import { OBJECT_COLORS } from './palette';
import type { Scene } from './scene';
import { drawStaticLayers, gridLines } from './static_layers';
import { SvgSurface } from './svg_surface';
import { aScene, withLayers } from './testing';

function moving(scene: Scene): string {
  const surface = new SvgSurface();
  drawMovingLayers(surface, scene);
  return surface.document(400, 300, 't');
}

function still(scene: Scene): string {
  const surface = new SvgSurface();
  drawStaticLayers(surface, scene);
  return surface.document(400, 300, 't');
}

const count = (text: string, part: string): number => text.split(part).length - 1;
const texts = (svg: string): string[] =>
  [...svg.matchAll(/<text[^>]*>([^<]*)</g)].map((match) => match[1] ?? '');
const ellipse = { about: 1, kind: 0, overlap: false, x: 0, y: 0, rx: 0.5, ry: 0.25, theta: 0, age: 0 };
const risk = (overlap: boolean) =>
  packRisk({ tUs: 1e6, run: 1, observer: 2, ellipses: [{ ...ellipse, overlap }] });
const fault = {
  object: 1,
  probe: 'PxId1',
  type: 'offset',
  params: '{}',
  fromUs: 0,
  toUs: 2e6,
  active: true,
  hits: 1,
};

describe('vehicles', () => {
  it('a copter is a cross with three rotors of its colour and a marked front one', () => {
    const svg = moving(aScene([anObject(1, { pos: [0, 0, 1], yaw: 0 })]));
    expect(svg).toContain(`fill="${OBJECT_COLORS[1]}"`);
    // Scale 100: rotors 20 px from the middle; the front one to the east has 20 * 0.45 * 1.15 px.
    expect(svg).toContain('M230.35 150A10.35 10.35');
    expect(svg).toContain('M180 150L220 150');
  });

  it('a car has an outline and four wheels, the front ones steered', () => {
    const straight = moving(aScene([anObject(1, { kind: 1, pos: [0, 0, 0], posEst: [0, 0, 0] })]));
    const steered = moving(
      aScene([anObject(1, { kind: 1, pos: [0, 0, 0], posEst: [0, 0, 0], steer: [0.3, 0] })]),
    );
    const wheels = (svg: string) => /<path d="([^"]*)"[^>]*stroke-width="3.2"/.exec(svg)?.[1] ?? '';
    expect(count(wheels(straight), 'Z')).toBe(4);
    expect(wheels(steered)).not.toBe(wheels(straight));
  });

  it('hundreds are copied from stamps where there are any', () => {
    const many = Array.from({ length: 100 }, (_, id) => anObject(id));
    const copies: number[] = [];
    const stamps = { prepare: () => undefined, copter: (x: number) => void copies.push(x) };
    moving(aScene(many, { stamps }));
    expect(copies).toHaveLength(100);
    expect(copies[2]).toBe(400);
  });
});

describe('layers', () => {
  it('each object has a trail, whatever its number', () => {
    const ids = [1, 2, 7, 9];
    const at = (x: number) => ids.map((id) => anObject(id, { pos: [x, id / 10, 0] }));
    const scene = aScene(at(1), { layers: withLayers('trails') });
    scene.frames.add(packFrame({ tUs: 0, run: 1, seq: 0, objects: at(0) }, null));
    const trails = [...moving(scene).matchAll(/<path d="([^"]*)"[^>]*stroke-width="1.25"/g)].map(
      (path) => path[1],
    );
    expect(count(trails.join(''), 'M')).toBe(ids.length);
    expect(count(trails.join(''), 'L')).toBe(ids.length);
  });

  it('contours that overlap have another colour and a thicker outline', () => {
    const layers = withLayers('risk');
    const quiet = moving(aScene([anObject(1)], { layers, risk: risk(false) }));
    const overlapping = moving(aScene([anObject(1)], { layers, risk: risk(true) }));
    expect(quiet).toMatch(/stroke="--map-risk" stroke-width="1"/);
    expect(overlapping).toMatch(/stroke="--map-overlap" stroke-width="3"/);
    expect(moving(aScene([anObject(1)], { risk: risk(true) }))).not.toContain('--map-overlap');
  });

  it('a ghost stands where the vehicle believes itself, only when that is elsewhere', () => {
    const layers = withLayers('perceived');
    const there = moving(aScene([anObject(1, { pos: [0, 0, 1], posEst: [0, 0, 1] })], { layers }));
    const away = moving(aScene([anObject(1, { pos: [0, 0, 1], posEst: [1, 0, 1] })], { layers }));
    expect(there).not.toContain('dasharray="4 3"');
    expect(/<path d="([^"]*)"[^>]*dasharray="4 3"/.exec(away)?.[1]).toMatch(/^M200 150L300 150M/);
  });

  it('comfort zones are filled for the observer alone', () => {
    const objects = [anObject(1), anObject(2)];
    const svg = moving(aScene(objects, { layers: withLayers('comfort'), observer: 2 }));
    expect(count(svg, 'fill="--map-comfort-fill"')).toBe(1);
  });

  it('ranges show whether each was used, and by how much it is off', () => {
    const world = { run: 1, version: 1, seg: [], polys: [], anchors: [{ id: 9, pos: [1, 1, 2] as const }] };
    const item = { anchor: 9, measured: 2.5, expected: 2, used: true };
    const scene = (used: boolean) =>
      aScene([anObject(1)], {
        layers: withLayers('ranges'),
        world,
        ranges: { tUs: 1e6, run: 1, object: 1, items: [{ ...item, used }] },
      });
    expect(texts(moving(scene(true)))).toEqual(['+0.50']);
    expect(moving(scene(true))).not.toContain('dasharray="3 4"');
    expect(moving(scene(false))).toContain('dasharray="3 4"');
  });

  it('names all of a few, and of many only the chosen, the faulted and the nearest 30', () => {
    const layers = withLayers('labels');
    const few = Array.from({ length: 5 }, (_, id) => anObject(id));
    expect(texts(moving(aScene(few, { layers })))).toEqual(['Q0', 'Q1', 'Q2', 'Q3', 'Q4']);
    const many = Array.from({ length: 150 }, (_, id) => anObject(id, { flags: id === 140 ? 4 : 0 }));
    const named = texts(moving(aScene(many, { layers, observer: 0, pinned: [120] })));
    expect(named).toHaveLength(31 + 2); // itself and 30 others, and the two
    expect(named).toContain('Q120');
    expect(named).toContain('Q140');
    expect(named).toContain('Q30');
    expect(named).not.toContain('Q31');
  });
});

describe('marks', () => {
  it('letters stand for the faults that are active at the moment', () => {
    const faults = { tUs: 0, run: 1, items: [fault, { ...fault, probe: 'ClockId1', fromUs: 1.5e6 }] };
    expect(texts(moving(aScene([anObject(1)], { faults })))).toEqual(['P']);
    expect(texts(moving(aScene([anObject(1)], { faults, tUs: 1.6e6 })))).toEqual(['P', 'T']);
  });

  it('a collision has a cross and a ring once it has happened', () => {
    const collisions = [{ tUs: 2e6, a: 1, b: 2, terrain: false, x: 0, y: 0 }];
    const path = (svg: string) => /<path d="([^"]*)"[^>]*stroke="--map-overlap"/.exec(svg)?.[1];
    expect(path(moving(aScene([anObject(1)], { collisions })))).toBeUndefined();
    const after = path(moving(aScene([anObject(1)], { collisions, tUs: 2e6 }))) ?? '';
    expect([count(after, 'A'), count(after, 'L')]).toEqual([2, 2]);
  });

  it('the observer has a square, pinned ones a dashed one', () => {
    const svg = moving(aScene([anObject(1), anObject(2)], { observer: 1, pinned: [2] }));
    expect(svg).toMatch(/d="M[^"]*Z" fill="none" stroke="--accent" stroke-width="2.5"/);
    expect(svg).toMatch(/d="M[^"]*Z" fill="none" stroke="--accent" stroke-width="1.5"[^>]*dasharray/);
  });

  it('a measurement says its length', () => {
    const measure = { fromX: 0, fromY: 0, toX: 0.3, toY: 0.4 };
    expect(texts(moving(aScene([anObject(1)], { measure })))).toEqual(['0.5 m']);
  });
});

describe('what does not move', () => {
  const world = {
    run: 1,
    version: 1,
    seg: [[-1, 0, 1, 0] as const],
    anchors: [{ id: 4, pos: [1, 1, 0] as const }],
    polys: [
      {
        name: 'field',
        role: 0,
        pt: [
          [0, 0, 0],
          [1, 0, 0],
          [1, 1, 0],
        ] as [number, number, number][],
      },
    ],
  };

  it('terrain, anchors and areas follow their layers', () => {
    const all = still(aScene([], { world, layers: withLayers('terrain', 'anchors') }));
    expect(all).toContain('d="M100 150L300 150"');
    expect(texts(all)).toEqual(['field', 'Anchor 4', '1 m']);
    expect(texts(still(aScene([], { world })))).toEqual(['1 m']);
  });

  it('grid lines are multiples of their step, and none where numbers are too coarse', () => {
    expect(gridLines(-1.2, 2.1, 1)).toEqual([-1, 0, 1, 2]);
    expect(gridLines(1e30, 1e30 + 5, 1)).toEqual([]);
    expect(gridLines(Number.NaN, 1, 1)).toEqual([]);
  });

  it('the scale bar is as long as it says', () => {
    expect(still(aScene())).toContain('M280 280L280 284L380 284L380 280');
  });
});
