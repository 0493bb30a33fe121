// Keeps the page's address in step with what is shown, and goes where an address says, once.

import type { Viewer } from '../model/viewer';
import { formatFragment, type Place, parseFragment } from './fragment';

// The part of the address after #.
export interface Address {
  read(): string;
  replace(fragment: string): void; // without a step in the history
  onChange(callback: () => void): void; // by the user
}

// Without any frame for so long, the case of an address is loaded without waiting for a player.
const NO_PLAYER_MS = 1500;

// `loadCase' shows a stored case; it rejects when it cannot. Then `notify' is told, and moment and
// observer, which were that case's, are forgotten.
export function followFragment(
  viewer: Viewer,
  address: Address,
  loadCase: (id: string) => Promise<void>,
  later: (ms: number, callback: () => void) => void,
  notify: (line: string) => void,
): void {
  let wanted: Place | null = parseFragment(address.read());
  let asked = false;
  const load = (id: string): void => {
    asked = true;
    void loadCase(id).catch(() => {
      notify(`no case ${id} here`);
      if (wanted?.caseId !== id) return; // the address has changed meanwhile
      wanted = null;
      write(viewer, address);
    });
  };
  const goThere = (patient: boolean): void => {
    const { frame, caseInfo } = viewer.state;
    if (wanted === null) return;
    const { caseId } = wanted;
    if (caseId !== null && caseInfo?.caseId !== caseId) {
      const known = frame !== null && caseInfo !== null;
      if (!asked && (known || !patient)) load(caseId);
    } else if (frame !== null) {
      show(viewer, wanted);
      wanted = null;
    }
  };
  viewer.listen((changed) => {
    if (wanted !== null) goThere(true);
    else if (changed.has('playback') || changed.has('selection') || changed.has('case')) {
      write(viewer, address);
    }
  });
  address.onChange(() => {
    wanted = parseFragment(address.read());
    asked = false;
    goThere(false);
  });
  later(NO_PLAYER_MS, () => goThere(false));
}

function show(viewer: Viewer, { tUs, observer }: Place): void {
  if (observer !== null) viewer.observe(observer);
  if (tUs === null) return;
  viewer.pause();
  viewer.seek(tUs);
}

// While playing the address stands still: browsers do not like it to change 60 times a second.
function write(viewer: Viewer, address: Address): void {
  const { playing, tUs, observer, caseInfo, frame } = viewer.state;
  if (playing || frame === null) return;
  const next = formatFragment({ caseId: caseInfo?.caseId ?? null, tUs, observer });
  if (next !== address.read()) address.replace(next);
}

export function browserAddress(page: Window): Address {
  return {
    read: () => page.location.hash,
    replace: (fragment) => page.history.replaceState(null, '', fragment),
    onChange: (callback) => page.addEventListener('hashchange', callback),
  };
}
