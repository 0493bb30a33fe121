// The state that the page reads, as getters over the parts of the viewer.

import type { Frame, Risk } from '../../../codec/messages';
import { commandAt } from './event_log';
import { type PackedFrame, unpackFrame } from './packed_frame';
import { type PackedRisk, unpackRisk } from './packed_risk';
import type { Playback } from './playback';
import type { RunData } from './run_data';
import type { Selection } from './selection';
import type { Badge, Connection, ViewerState } from './viewer';

// What the state is made of; data, connection and the frame shown are replaced as time goes on.
export interface Model {
  readonly data: RunData;
  readonly connection: Connection;
  readonly shown: PackedFrame | null;
  readonly risk: PackedRisk | null; // of the observer at the moment shown
  readonly playback: Playback;
  readonly selection: Selection;
  readonly badge: Badge;
  readonly frameAgeS: number; // wall time since the latest frame came
  readonly reason: string; // why a run cannot be changed, '' when it can
  readonly askReason: string; // why the player takes no wishes, '' when it does
  readonly producing: boolean; // frames are coming
  readonly startUs: number;
  readonly durationUs: number;
}

// Frame and contours are unpacked when they are asked for, once.
export function stateOf(model: Model): ViewerState {
  let frameOf: PackedFrame | null = null;
  let frame: Frame | null = null;
  let riskOf: PackedRisk | null = null;
  let risk: Risk | null = null;
  return {
    get badge() {
      return model.badge;
    },
    get badgeAgeS() {
      return model.frameAgeS;
    },
    get connection() {
      return model.connection;
    },
    get status() {
      return model.data.status;
    },
    get controlAllowed() {
      return model.reason === '';
    },
    get controlReason() {
      return model.reason;
    },
    get askReason() {
      return model.askReason;
    },
    get run() {
      return model.data.run;
    },
    get caseInfo() {
      return model.data.caseInfo;
    },
    get world() {
      return model.data.world;
    },
    get faults() {
      return model.data.faults;
    },
    get events() {
      return model.data.log.events;
    },
    get collisions() {
      return model.data.log.collisions;
    },
    get tUs() {
      return model.playback.tUs;
    },
    get frame() {
      if (model.shown !== frameOf) frame = model.shown === null ? null : unpackFrame(model.shown);
      frameOf = model.shown;
      return frame;
    },
    get risk() {
      const packed = model.risk;
      if (packed !== riskOf) risk = packed === null ? null : unpackRisk(packed);
      riskOf = packed;
      return risk;
    },
    get ranges() {
      return model.data.rangesAt(model.selection.observer, model.playback.tUs);
    },
    get fromUs() {
      return model.data.frames.first?.tUs ?? 0;
    },
    get startUs() {
      return model.startUs;
    },
    get toUs() {
      return model.data.frames.last?.tUs ?? 0;
    },
    get durationUs() {
      return model.durationUs;
    },
    get thinned() {
      return model.data.frames.thinned;
    },
    get following() {
      return model.playback.following;
    },
    get behindS() {
      if (!model.producing || model.playback.following) return 0;
      return Math.max(0, ((model.data.frames.last?.tUs ?? 0) - model.playback.tUs) / 1e6);
    },
    get playing() {
      return model.playback.playing;
    },
    get speed() {
      return model.playback.speed;
    },
    get loop() {
      return model.playback.loop;
    },
    get stopAtCollision() {
      return model.playback.stopAtCollision;
    },
    get currentCommand() {
      return commandAt(model.data.caseInfo, model.playback.tUs);
    },
    get failingCommand() {
      return model.data.failing;
    },
    get observer() {
      return model.selection.observer;
    },
    get followed() {
      return model.selection.followed;
    },
    get pinned() {
      return model.selection.pinned;
    },
  };
}
