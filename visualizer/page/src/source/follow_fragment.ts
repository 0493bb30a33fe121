// Keeps the page's address in step with what is shown, and goes where an address says, once.

import type { Viewer } from '../model/viewer';
import { formatFragment, parseFragment } from './fragment';

export function followFragment(viewer: Viewer, page: Window): void {
  let wanted: ReturnType<typeof parseFragment> | null = parseFragment(page.location.hash);
  const goThere = (): void => {
    const { frame, caseInfo } = viewer.state;
    if (wanted === null || frame === null) return;
    const { caseId, tUs, observer } = wanted;
    if (caseId !== null && caseInfo !== null && caseInfo.caseId !== caseId) {
      wanted = { ...wanted, caseId: null };
      void viewer.control('load', -1, [0], caseId);
      return;
    }
    wanted = null;
    if (observer !== null) viewer.observe(observer);
    if (tUs === null) return;
    viewer.pause();
    viewer.seek(tUs);
  };
  viewer.listen((changed) => {
    if (wanted !== null) goThere();
    else if (changed.has('playback') || changed.has('selection') || changed.has('case')) write();
  });
  page.addEventListener('hashchange', () => {
    wanted = parseFragment(page.location.hash);
    goThere();
  });
  // While playing the address stands still: browsers do not like it to change 60 times a second.
  const write = (): void => {
    const { playing, tUs, observer, caseInfo, frame } = viewer.state;
    if (playing || frame === null) return;
    const next = formatFragment({ caseId: caseInfo?.caseId ?? null, tUs, observer });
    if (next !== page.location.hash) page.history.replaceState(null, '', next);
  };
}
