// A made-up flight for the browser tests: copters on parallel tracks, of which 1 and 2 meet and collide at 3 s.

import type {
  CaseInfo,
  Faults,
  Frame,
  Message,
  Ranges,
  Risk,
  Status,
  VizEvent,
  VizObject,
  World,
} from '../codec/messages';
import { writeLog } from '../codec/log';
import { encodeMessage } from '../codec/viz';

export const collisionUs = 3_000_000;
export const endUs = 4_000_000;
export const frameHz = 60;
export const caseId = 'prop_no_collision_1a2b3c4d';

const speed = 2; // m/s
const faultFromUs = 1_000_000;
const faultToUs = 2_500_000;

// Copter 1 comes from the west, copter 2 from the east; they meet at x = 0, y = 0. The others fly north.
export function object(id: number, tUs: number, count: number): VizObject {
  const t = tUs / 1e6;
  const toMeeting = speed * (collisionUs / 1e6 - t);
  const column = ((id - 3) % 20) - 10;
  const row = Math.floor((id - 3) / 20);
  const pos: [number, number, number] =
    id === 1 ? [-toMeeting, 0, 1] : id === 2 ? [toMeeting, 0, 1] : [3 * column, 3 * row + 3 + t, 1];
  const faulted = id === 1 && tUs >= faultFromUs && tUs < faultToUs;
  const collided = id <= 2 && tUs >= collisionUs && count >= 2;
  return {
    id,
    kind: 0,
    flags: (collided ? 1 : 0) + (faulted ? 4 : 0),
    pos,
    vel: id === 1 ? [speed, 0, 0] : id === 2 ? [-speed, 0, 0] : [0, 1, 0],
    yaw: id === 2 ? Math.PI : id === 1 ? 0 : Math.PI / 2,
    roll: 0.1,
    pitch: 0,
    posEst: faulted ? [pos[0], pos[1] + 0.5, pos[2]] : pos,
    velEst: [0, 0, 0],
    comfort: 0.6,
    steer: [0.1, 0],
  };
}

export function frame(tUs: number, count: number, run = 1): Frame {
  const objects = Array.from({ length: count }, (_, i) => object(i + 1, tUs, count));
  return { tUs, run, seq: Math.round((tUs * frameHz) / 1e6), objects };
}

export function risk(tUs: number, count: number, observer = 1, run = 1): Risk {
  const others = Array.from({ length: count }, (_, i) => i + 1).filter((id) => id !== observer);
  return {
    tUs,
    run,
    observer,
    ellipses: others.map((about) => {
      const { pos } = object(about, tUs, count);
      const near = about <= 2 && tUs > 2_500_000;
      return { about, kind: 0, overlap: near, x: pos[0], y: pos[1], rx: 1.2, ry: 0.8, theta: 0.3, age: 0.1 };
    }),
  };
}

export function ranges(tUs: number, run = 1): Ranges {
  const items = [100, 101].map((anchor, i) => ({ anchor, measured: 5 + i, expected: 5, used: i === 0 }));
  return { tUs, run, object: 1, items };
}

export const world = (run = 1): World => ({
  run,
  version: 1,
  seg: [
    [-12, -4, 12, -4],
    [12, -4, 12, 12],
  ],
  anchors: [
    { id: 100, pos: [-10, -3, 2] },
    { id: 101, pos: [10, -3, 2] },
  ],
  polys: [],
});

export const faults = (tUs: number, run = 1): Faults => ({
  tUs,
  run,
  items: [
    {
      object: 1,
      probe: 'PyId1',
      type: 'offset',
      params: '{"value":0.5}',
      fromUs: faultFromUs,
      toUs: faultToUs,
      active: tUs >= faultFromUs && tUs < faultToUs,
      hits: 10,
    },
  ],
});

export const caseInfo = (count: number): CaseInfo => ({
  caseId,
  property: 'prop_no_collision',
  seed: '{1,2,3}',
  codeVersion: 'test',
  ncmdOriginal: 12,
  commands: [0, 1, 2, 3].map((index) => ({
    tUs: index * 1_000_000,
    index,
    name: index === 1 ? 'inject' : 'iterate',
    args: index === 1 ? '"PyId1", {offset, 0.5}' : `${1000 * index}`,
  })),
  params: JSON.stringify({ summary: `${count} copters`, probes: ['PxId1', 'PyId1', 'PxId2'], channels: [] }),
});

const noted = (seq: number, tUs: number, kind: string, a: number, b: number, text: string): VizEvent => ({
  tUs,
  run: 1,
  seq,
  kind,
  a,
  b,
  x: 0,
  y: 0,
  text,
});

export const events: readonly VizEvent[] = [
  noted(1, 0, 'command', 0, -1, 'iterate(0)'),
  noted(2, 1_000_000, 'command', 1, -1, 'inject("PyId1", {offset, 0.5})'),
  noted(3, faultFromUs, 'fault', 1, -1, 'offset on PyId1'),
  noted(4, 2_000_000, 'command', 2, -1, 'iterate(2000)'),
  noted(5, collisionUs, 'collision', 1, 2, '1 and 2 collide'),
  noted(6, collisionUs, 'verdict', -1, -1, 'failed'),
];

export const status = (tUs: number, change: Partial<Status> = {}): Status => ({
  mode: 2,
  paused: false,
  speed: 1,
  tUs,
  durationUs: endUs,
  run: 1,
  verdict: tUs >= collisionUs ? 2 : 0,
  controlAllowed: false,
  message: '',
  ...change,
});

// What goes out at this moment besides the frame: at the start and once a second what does not change.
export function messagesAt(tUs: number, count: number, sinceUs: number): Message[] {
  const due = (periodUs: number): boolean => Math.floor(tUs / periodUs) !== Math.floor(sinceUs / periodUs);
  const everySecond: Message[] = [
    { channel: 'VIZ_CASE', value: caseInfo(count) },
    { channel: 'VIZ_WORLD', value: world() },
    { channel: 'VIZ_FAULTS', value: faults(tUs) },
  ];
  const happened = events.filter((event) => event.tUs <= tUs && event.tUs > sinceUs);
  return [
    ...(due(1_000_000) ? everySecond : []),
    ...(due(200_000) ? [{ channel: 'VIZ_STATUS', value: status(tUs) } as const] : []),
    ...(due(100_000) ? [{ channel: 'VIZ_RANGE', value: ranges(tUs) } as const] : []),
    ...happened.map((value) => ({ channel: 'VIZ_EVENT', value }) as const),
    { channel: 'VIZ_FRAME', value: frame(tUs, count) },
    { channel: 'VIZ_RISK', value: risk(tUs, count) },
  ];
}

// The moments of the frames.
export const times: readonly number[] = Array.from({ length: (endUs / 1e6) * frameHz + 1 }, (_, i) =>
  Math.round((i * 1e6) / frameHz),
);

export function sceneLog(count = 4): Uint8Array<ArrayBuffer> {
  const messages = times.flatMap((tUs, i) =>
    messagesAt(tUs, count, times[i - 1] ?? -1).map((m) => ({ tUs, m })),
  );
  return writeLog(
    messages.map(({ tUs, m }) => ({ timeUs: tUs, channel: m.channel, data: encodeMessage(m) })),
  );
}
