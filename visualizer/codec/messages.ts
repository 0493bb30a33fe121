// The messages of lcm/*.lcm as TypeScript types. Units and frames are stated in those files:
// SI units, radians, x east, y north, z up. 64-bit times are numbers of microseconds (safe
// integers: 285 years); a decoder refuses larger ones.

export type Vec3 = readonly [number, number, number];

export interface VizObject {
  id: number;
  kind: number; // ObjectKind
  flags: number; // sum of ObjectFlag
  pos: Vec3;
  vel: Vec3;
  yaw: number;
  roll: number;
  pitch: number;
  posEst: Vec3;
  velEst: Vec3;
  comfort: number;
  steer: readonly [number, number];
}

export const ObjectKind = { copter: 0, car: 1, other: 2 } as const;
export const ObjectFlag = { collided: 1, avoiding: 2, faulted: 4, stale: 8, manual: 16 } as const;

export interface Frame {
  tUs: number;
  run: number;
  seq: number;
  objects: VizObject[];
}

export interface Ellipse {
  about: number;
  kind: number; // 0 object, 1 terrain
  overlap: boolean;
  x: number;
  y: number;
  rx: number;
  ry: number;
  theta: number;
  age: number;
}

export interface Risk {
  tUs: number;
  run: number;
  observer: number;
  ellipses: Ellipse[];
}

export interface Anchor {
  id: number;
  pos: Vec3;
}

export interface Poly {
  name: string;
  role: number; // 0 allowed, 1 forbidden, 2 route, 3 recovery
  pt: Vec3[];
}

export interface World {
  run: number;
  version: number;
  seg: (readonly [number, number, number, number])[];
  anchors: Anchor[];
  polys: Poly[];
}

export interface Range {
  anchor: number;
  measured: number;
  expected: number;
  used: boolean;
}

export interface Ranges {
  tUs: number;
  run: number;
  object: number;
  items: Range[];
}

export interface Fault {
  object: number;
  probe: string;
  type: string;
  params: string; // JSON object
  fromUs: number;
  toUs: number; // -1: no end known
  active: boolean;
  hits: number;
}

export interface Faults {
  tUs: number;
  run: number;
  items: Fault[];
}

export interface VizEvent {
  tUs: number;
  run: number;
  seq: number;
  kind: string; // command, fault, collision, verdict, log
  a: number;
  b: number;
  x: number;
  y: number;
  text: string;
}

export interface Command {
  tUs: number;
  index: number;
  name: string;
  args: string;
}

export interface CaseInfo {
  caseId: string;
  property: string;
  seed: string;
  codeVersion: string;
  ncmdOriginal: number;
  commands: Command[];
  params: string; // JSON object
}

export interface Status {
  mode: number; // Mode
  paused: boolean;
  speed: number;
  tUs: number;
  durationUs: number; // -1: not known
  run: number;
  verdict: number; // Verdict
  controlAllowed: boolean;
  message: string;
}

export const Mode = { idle: 0, live: 1, replay: 2 } as const;
export const Verdict = { running: 0, passed: 1, failed: 2, differs: 3 } as const;

export interface Ack {
  client: string;
  seq: number;
  ok: boolean;
  text: string;
}

// What a page asks of the player, as the bridge passes it on.
export interface Control {
  client: string;
  token: string;
  seq: number;
  verb: string;
  object: number; // -1: none or all
  args: number[];
  text: string;
}

// What comes through a channel, decoded.
export type Message =
  | { channel: 'VIZ_FRAME'; value: Frame }
  | { channel: 'VIZ_RISK'; value: Risk }
  | { channel: 'VIZ_WORLD'; value: World }
  | { channel: 'VIZ_RANGE'; value: Ranges }
  | { channel: 'VIZ_FAULTS'; value: Faults }
  | { channel: 'VIZ_EVENT'; value: VizEvent }
  | { channel: 'VIZ_CASE'; value: CaseInfo }
  | { channel: 'VIZ_STATUS'; value: Status }
  | { channel: 'VIZ_ACK'; value: Ack };

export type Channel = Message['channel'];
