// What the page knows and can do, without any DOM: the one thing that the map, the timeline, the
// curves and the panels share. They read `state`, listen, and call the actions; they never talk to
// one another. createViewer() in create_viewer.ts makes one.
//
// Times are simulated microseconds; lengths metres; angles radians.

import type {
  Ack,
  CaseInfo,
  Faults,
  Frame,
  Message,
  Ranges,
  Risk,
  Status,
  VizEvent,
  World,
} from '../../../codec/messages';
import type { TileSet } from '../../../codec/tile_set';
import type { PackedFrame } from './packed_frame';
import type { PackedRisk } from './packed_risk';
import type { TimeBuffer } from './time_buffer';

// Where the data comes from.
export type SourceKind = 'none' | 'file' | 'socket';

// The badge in the header, which says in one word what is shown (table of states).
export type Badge = 'NO DATA' | 'LIVE' | 'REPLAY' | 'FILE' | 'STALE' | 'DISCONNECTED';

export interface Connection {
  kind: SourceKind;
  connected: boolean;
  retryInS: number; // until the next try; 0 when connected
  group: string; // of LCM, as the bridge calls it
  tiles: TileSet | null; // of the map, which the bridge has
  packets: number; // seen so far
  lost: number;
  dropped: number;
  bytesPerSec: number;
  fileName: string; // of a file, '' otherwise
  error: string; // one line, '' for none: 'type mismatch: rebuild' and the like
}

export const NOT_CONNECTED: Connection = {
  kind: 'none',
  connected: false,
  retryInS: 0,
  group: '',
  tiles: null,
  packets: 0,
  lost: 0,
  dropped: 0,
  bytesPerSec: 0,
  fileName: '',
  error: '',
};

export interface Collision {
  tUs: number;
  a: number; // object
  b: number; // object, or line of terrain when terrain is true
  terrain: boolean;
  x: number;
  y: number;
}

export interface ViewerState {
  badge: Badge;
  badgeAgeS: number; // of the latest frame, for STALE
  connection: Connection;
  status: Status | null; // of the player, or made up for a file
  controlAllowed: boolean;
  controlReason: string; // why inject and steer are disabled, '' when they are not
  askReason: string; // why the player takes no wishes, be it live or a replay; '' when it does

  run: number;
  caseInfo: CaseInfo | null;
  world: World | null;
  faults: Faults | null;
  events: readonly VizEvent[]; // of this run, in order
  collisions: readonly Collision[];

  // The moment that is shown.
  tUs: number;
  frame: Frame | null;
  risk: Risk | null; // of the observer at that moment
  ranges: Ranges | null;
  fromUs: number; // what the buffer holds
  toUs: number;
  startUs: number; // the earliest moment that can be had: of a player's replay its beginning
  durationUs: number; // end of the time axis
  thinned: boolean; // old frames were thinned to 10 Hz
  following: boolean; // the trailing edge of live data is shown
  behindS: number; // behind live, 0 when following

  playing: boolean;
  speed: number; // 0.05 to 20
  loop: { fromUs: number; toUs: number } | null;
  stopAtCollision: boolean; // a replay stops at each collision until it is told to play on
  currentCommand: number; // index into caseInfo.commands, -1 before the first
  failingCommand: number; // the same, -1 when none failed

  observer: number; // id, -1: none
  followed: boolean; // the map follows the observer
  pinned: readonly number[]; // ids with curves, whoever is observed; up to 6
}

// What changed since the listener was last called.
export type Topic =
  | 'source'
  | 'status'
  | 'case'
  | 'world'
  | 'faults'
  | 'events'
  | 'time'
  | 'buffer'
  | 'playback'
  | 'selection';

export interface Viewer {
  readonly state: Readonly<ViewerState>;
  // At most once per animation frame. Answers how to stop listening.
  listen(listener: (changed: ReadonlySet<Topic>) => void): () => void;

  // Sources
  openLog(bytes: ArrayBuffer, name: string): Promise<void>; // rejects with one line
  connect(url: string): void;
  feed(message: Message, receivedMs: number): void; // what a source calls

  // Playback; what the buffer holds is played without asking the player
  play(): void;
  pause(): void;
  restart(): void;
  step(frames: number): void;
  seek(tUs: number): void;
  seekEvent(direction: 1 | -1): void;
  setSpeed(factor: number): void;
  setLoop(range: { fromUs: number; toUs: number } | null): void;
  setStopAtCollision(on: boolean): void;
  toLive(): void;
  showCollision(index: number): void; // seeks to 1 s before

  // Selection
  observe(id: number): void;
  nextObject(direction: 1 | -1): void;
  setFollowed(on: boolean): void;
  pin(id: number, on: boolean): void;

  // To the player; resolves with its answer, or one that is not ok after 1 s without any.
  control(verb: string, object?: number, args?: readonly number[], text?: string): Promise<Ack>;

  // Told in one line of what the player refused that was asked by playing, seeking and observing, and
  // of its being started anew.
  onRefusal(listener: (line: string) => void): () => void;

  // For drawings: the run's frames in columns (packed_frame.ts), the one shown, and the observer's
  // contours at that moment; reading them allocates nothing.
  readonly packed: {
    readonly frames: TimeBuffer<PackedFrame>;
    readonly shown: PackedFrame | null;
    readonly risk: PackedRisk | null;
  };

  // The frames of the run from fromUs to toUs, oldest first.
  framesBetween(fromUs: number, toUs: number): readonly Frame[];

  // All that is held of the run, as it would stand in a log, oldest first: for reports and exports.
  held(): readonly Message[];
}
