// How the case came to be: what shrinking left of it, and which of the two sequences is played.

import { type CaseInfo, Mode } from '../../../codec/messages';
import type { ViewerState } from '../model/viewer';
import { button, el, setHidden, setText } from '../shell/dom';
import { caseParams } from './case_params';
import { facts } from './facts';
import { act, type Context, type Panel } from './panel';

export function shrinkingPanel(context: Context): Panel {
  const { viewer } = context;
  const all = facts(['original / shrunk', 'shrink steps', 'property', 'seed', 'code']);
  let original = false; // asked for by the button
  let caseId = ''; // for which
  const load = button('Replay original', () => {
    const wanted = !original;
    void act(context, 'load', -1, [wanted ? 1 : 0], viewer.state.caseInfo?.caseId ?? '').then((ok) => {
      if (ok) original = wanted;
      update();
    });
  });
  const row = el('p', { class: 'row' }, load);
  const reason = el('p', { class: 'hint', role: 'note' });
  const element = el(
    'section',
    { class: 'section', 'aria-label': 'Shrinking' },
    el('h2', {}, 'Shrinking'),
    all.element,
    row,
    reason,
  );
  const update = (): void => {
    const { caseInfo } = viewer.state;
    element.hidden = caseInfo === null;
    if (caseInfo === null) return;
    if (caseInfo.caseId !== caseId) original = false;
    caseId = caseInfo.caseId;
    const params = caseParams(caseInfo);
    const shrunk = caseInfo.ncmdOriginal > 0;
    all.set('original / shrunk', shrunk ? `${caseInfo.ncmdOriginal} / ${caseInfo.commands.length}` : '');
    all.set('shrink steps', params.shrinkSteps === null ? '' : String(params.shrinkSteps));
    all.set('property', caseInfo.property);
    all.set('seed', caseInfo.seed);
    all.set('code', caseInfo.codeVersion);
    const why = original ? viewer.state.askReason : noOriginal(viewer.state);
    const label = original ? 'Replay shrunk' : 'Replay original';
    const offered = original || hasOriginal(caseInfo);
    setHidden(row, !offered);
    setText(load, label);
    load.disabled = why !== '';
    setText(reason, `${label}: ${why}.`);
    setHidden(reason, !offered || why === '');
  };
  return { element, topics: ['case', 'source', 'status'], everyMs: 250, update };
}

// Whether there is a longer sequence than the one that is shown.
function hasOriginal({ ncmdOriginal, commands }: CaseInfo): boolean {
  return ncmdOriginal !== 0 && ncmdOriginal !== commands.length;
}

// Why the original cannot be replayed, '' when it can.
export function noOriginal({
  caseInfo,
  status,
  askReason,
}: Pick<ViewerState, 'caseInfo' | 'status' | 'askReason'>): string {
  if (caseInfo === null || caseInfo.ncmdOriginal === 0) return 'this flight was not shrunk from another';
  if (caseInfo.ncmdOriginal === caseInfo.commands.length)
    return 'shrinking took nothing away: it is the original';
  if (askReason !== '') return askReason;
  return status?.mode === Mode.replay ? '' : 'needs a player that replays a case';
}
