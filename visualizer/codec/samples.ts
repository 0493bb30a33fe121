// Messages for tests: one of each kind, every member other than zero.

import type { Frame, Message, Vec3, VizObject } from './messages';

// Values that a 32-bit float holds exactly, so that they come back as they went.
const exact = (k: number): number => k * 0.25;
const vec = (k: number): Vec3 => [exact(k), exact(k + 1), -exact(k + 2)];

export const sampleObject = (id: number): VizObject => ({
  id,
  kind: id % 3,
  flags: id % 32,
  pos: vec(id + 1),
  vel: vec(id + 2),
  yaw: exact(id + 3),
  roll: exact(id + 4),
  pitch: exact(id + 5),
  posEst: vec(id + 6),
  velEst: vec(id + 7),
  comfort: exact(id + 8),
  steer: [exact(id + 9), exact(id + 10)],
});

export const sampleFrame = (count: number, seq = 7): Frame => ({
  tUs: 1_250_000,
  run: 3,
  seq,
  objects: Array.from({ length: count }, (_, i) => sampleObject(i)),
});

const ellipse = { about: 4, kind: 1, overlap: true, x: 1.5, y: -2.5, rx: 3, ry: 0.5, theta: 0.25, age: 2 };

export const sampleMessages: Message[] = [
  { channel: 'VIZ_FRAME', value: sampleFrame(2) },
  {
    channel: 'VIZ_RISK',
    value: { tUs: 5, run: 3, observer: 1, ellipses: [ellipse, { ...ellipse, overlap: false }] },
  },
  {
    channel: 'VIZ_WORLD',
    value: {
      run: 3,
      version: 2,
      seg: [[1, 2, 3, 4]],
      anchors: [{ id: 9, pos: vec(1) }],
      polys: [{ name: 'Straße', role: 2, pt: [vec(1), vec(2)] }],
    },
  },
  {
    channel: 'VIZ_RANGE',
    value: { tUs: 6, run: 3, object: 1, items: [{ anchor: 9, measured: 2.5, expected: 2.25, used: true }] },
  },
  {
    channel: 'VIZ_FAULTS',
    value: {
      tUs: 7,
      run: 3,
      items: [
        {
          object: -1,
          probe: 'copter.pos',
          type: 'offset',
          params: '{"by":1}',
          fromUs: 1,
          toUs: -1,
          active: true,
          hits: 12,
        },
      ],
    },
  },
  {
    channel: 'VIZ_EVENT',
    value: {
      tUs: 8,
      run: 3,
      seq: 1,
      kind: 'collision',
      a: 1,
      b: 2,
      x: 0.5,
      y: -0.5,
      text: '1 and 2 collide',
    },
  },
  {
    channel: 'VIZ_CASE',
    value: {
      caseId: 'copter_1',
      property: 'prop_no_collision',
      seed: '{1,2,3}',
      codeVersion: 'abc',
      ncmdOriginal: 20,
      commands: [{ tUs: 100, index: 0, name: 'fly', args: '1, {0.5, 2}' }],
      params: '{}',
    },
  },
  {
    channel: 'VIZ_STATUS',
    value: {
      mode: 2,
      paused: true,
      speed: 0.5,
      tUs: 9,
      durationUs: -1,
      run: 3,
      verdict: 2,
      controlAllowed: true,
      message: 'steht',
    },
  },
  { channel: 'VIZ_ACK', value: { client: 'page-1', seq: 4, ok: true, text: '' } },
];
