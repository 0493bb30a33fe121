// For tests: messages with what a test does not care about filled in, and a world in which time
// passes when the test says so.

import type { CaseInfo, Message, Risk, Status, VizEvent, VizObject } from '../../../codec/messages';
import type { Asked, LinkListener, Surroundings } from './create_viewer';

export function anObject(id: number, change: Partial<VizObject> = {}): VizObject {
  return {
    id,
    kind: 0,
    flags: 0,
    pos: [id, 0, 1],
    vel: [0, 0, 0],
    yaw: 0,
    roll: 0,
    pitch: 0,
    posEst: [id, 0, 1],
    velEst: [0, 0, 0],
    comfort: 0.5,
    steer: [0, 0],
    ...change,
  };
}

export function aFrame(tUs: number, objects: VizObject[] = [anObject(1), anObject(2)], run = 1): Message {
  return { channel: 'VIZ_FRAME', value: { tUs, run, seq: Math.round(tUs / 1000), objects } };
}

export function anEvent(change: Partial<VizEvent>): VizEvent {
  return { tUs: 0, run: 1, seq: 0, kind: 'log', a: -1, b: -1, x: 0, y: 0, text: '', ...change };
}

export function aRisk(observer: number, tUs: number, run = 1): Risk {
  const ellipse = { about: 2, kind: 0, overlap: true, x: 1, y: 2, rx: 3, ry: 1, theta: 0.5, age: 0.25 };
  return { tUs, run, observer, ellipses: [ellipse] };
}

export function aStatus(change: Partial<Status> = {}): Status {
  return {
    mode: 2,
    paused: false,
    speed: 1,
    tUs: 0,
    durationUs: -1,
    run: 1,
    verdict: 0,
    controlAllowed: true,
    message: '',
    ...change,
  };
}

export function aCase(timesUs: readonly number[]): CaseInfo {
  return {
    caseId: 'c',
    property: 'p',
    seed: 's',
    codeVersion: 'v',
    ncmdOriginal: timesUs.length,
    params: '{}',
    commands: timesUs.map((tUs, index) => ({ tUs, index, name: 'iterate', args: String(index) })),
  };
}

export interface TestWorld extends Surroundings {
  log: Message[]; // what readLog reads
  problem: string; // why it ended early
  sent: Asked[];
  listener: LinkListener | null; // of the link that was opened last
  pass(ms: number): void; // time in steps of 10 ms with an animation frame each
}

export function testWorld(): TestWorld {
  let nowMs = 0;
  let frames: (() => void)[] = [];
  let timers: { dueMs: number; callback: () => void }[] = [];
  const step = (): void => {
    nowMs += 10;
    const due = timers.filter((timer) => timer.dueMs <= nowMs);
    timers = timers.filter((timer) => timer.dueMs > nowMs);
    for (const timer of due) timer.callback();
    const run = frames;
    frames = [];
    for (const callback of run) callback();
  };
  const world: TestWorld = {
    log: [],
    problem: '',
    sent: [],
    listener: null,
    firstSeq: 7,
    now: () => nowMs,
    animationFrame: (callback) => void frames.push(callback),
    later: (ms, callback) => void timers.push({ dueMs: nowMs + ms, callback }),
    readLog: async (_bytes, take) => {
      for (const message of world.log) take(message);
      return world.problem;
    },
    openLink: (_url, listener) => {
      world.listener = listener;
      return { send: (control) => void world.sent.push(control), close: () => undefined };
    },
    pass: (ms) => {
      for (let passed = 0; passed < ms; passed += 10) step();
    },
  };
  return world;
}
