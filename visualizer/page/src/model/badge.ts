// The badge of the header: in one word, what is shown (table of states in docs/visualizer.md).

import { Mode, type Status, Verdict } from '../../../codec/messages';
import type { Badge, SourceKind } from './viewer';

export interface BadgeFacts {
  readonly source: SourceKind;
  readonly connected: boolean;
  readonly everConnected: boolean;
  readonly hasFrames: boolean;
  readonly status: Status | null;
  readonly frameAgeS: number; // wall time since the last frame came
}

// Frames missing for longer than this while playing are stale.
export const STALE_S = 1;

export function badgeOf(facts: BadgeFacts): Badge {
  if (facts.source === 'file') return facts.hasFrames ? 'FILE' : 'NO DATA';
  if (facts.source === 'none') return 'NO DATA';
  if (!facts.connected) return facts.everConnected ? 'DISCONNECTED' : 'NO DATA';
  if (!facts.hasFrames) return 'NO DATA';
  const idle = facts.status !== null && (facts.status.paused || facts.status.mode === Mode.idle);
  if (!idle && facts.frameAgeS > STALE_S) return 'STALE';
  return facts.status?.mode === Mode.live || facts.status === null ? 'LIVE' : 'REPLAY';
}

// Why inject, steer and what else changes the run are disabled; '' when they are not.
export function controlReason(
  source: SourceKind,
  connected: boolean,
  status: Status | null,
  granted: boolean,
): string {
  if (source === 'none') return 'Nothing is connected.';
  if (source === 'file') return 'Read only: this is a file. Connect to a player to change a run.';
  if (!connected) return 'Disconnected.';
  if (!granted) return 'The bridge was started without --allow-control.';
  if (status === null) return 'No player answers.';
  if (!status.controlAllowed) return 'The player was started without control.';
  if (status.mode === Mode.replay) {
    return 'Read only: this is a replay. Fork it into a live run to change it.';
  }
  if (status.mode !== Mode.live) return 'The player is idle.';
  return status.verdict === Verdict.running ? '' : 'The flight is over: restart the run.';
}
