// A page that comes to a replay that has ended shows it from its beginning: its last moment alone
// tells little.

import { Mode, type Status, Verdict } from '../../../codec/messages';
import { END_US } from '../model/playback';
import type { Viewer } from '../model/viewer';

// Asks the player once, at the first status that comes; without control the page stays where it is.
export function beginAgain(viewer: Viewer): void {
  const leave = viewer.listen(() => {
    const { status, connection } = viewer.state;
    if (connection.kind !== 'socket' || status === null) return;
    leave();
    if (standsAtEnd(status)) void restart(viewer);
  });
}

function standsAtEnd({ mode, paused, tUs, durationUs, verdict }: Status): boolean {
  if (mode !== Mode.replay || !paused) return false;
  return verdict !== Verdict.running || (durationUs > 0 && tUs >= durationUs - END_US);
}

async function restart(viewer: Viewer): Promise<void> {
  const ack = await viewer.control('restart');
  if (ack.ok) await viewer.control('play');
}
