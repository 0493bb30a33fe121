// Forking a replay where it is looked at: the player may stand elsewhere, since what the page holds is played
// without it.

import type { Viewer } from '../model/viewer';
import { act, type Context } from './panel';

// Nearer than this the player is there: a few frames.
const nearUs = 50_000;
// A seek simulates the flight again from its start.
const patienceMs = 30_000;

export async function forkHere(context: Context): Promise<void> {
  const { viewer } = context;
  const { tUs, following, status } = viewer.state;
  // Who follows looks at where the player is. Else it is held there: a player that plays on is soon past it.
  if (!following && !isAt(viewer, tUs)) {
    if (status?.paused === false && !(await act(context, 'pause'))) return;
    if (!(await act(context, 'seek', -1, [tUs / 1e6]))) return;
    if (!(await arrival(viewer, tUs))) {
      context.notify(`fork: the player did not get there within ${patienceMs / 1000} s`, true);
      return;
    }
  }
  if (await act(context, 'fork')) viewer.toLive();
}

function isAt({ state }: Viewer, tUs: number): boolean {
  return state.status !== null && Math.abs(state.status.tUs - tUs) <= nearUs;
}

// Whether the player says in time that it is there.
function arrival(viewer: Viewer, tUs: number): Promise<boolean> {
  return new Promise((resolve) => {
    const end = (there: boolean): void => {
      stop();
      clearTimeout(late);
      resolve(there);
    };
    const stop = viewer.listen((changed) => {
      if (changed.has('status') && isAt(viewer, tUs)) end(true);
    });
    const late = setTimeout(() => end(false), patienceMs);
  });
}
