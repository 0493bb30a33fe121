// How the case came to be: what shrinking left of it, and which of the two sequences is played.

import { Mode } from '../../../codec/messages';
import type { ViewerState } from '../model/viewer';
import { button, el, setText } from '../shell/dom';
import { caseParams } from './case_params';
import { facts } from './facts';
import { act, type Context, type Panel } from './panel';

export function shrinkingPanel(context: Context): Panel {
  const { viewer } = context;
  const all = facts(['original / shrunk', 'shrink steps', 'property', 'seed', 'replays same', 'code']);
  let original = false; // asked for by the button
  let caseId = ''; // for which
  const load = button('Replay original', () => {
    const wanted = !original;
    void act(context, 'load', -1, [wanted ? 1 : 0], viewer.state.caseInfo?.caseId ?? '').then((ok) => {
      if (ok) original = wanted;
      update();
    });
  });
  const element = el(
    'section',
    { class: 'section', 'aria-label': 'Shrinking' },
    el('h2', {}, 'Shrinking'),
    all.element,
    el('p', { class: 'row' }, load),
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
    all.set('replays same', params.sameAgain);
    all.set('code', caseInfo.codeVersion);
    const why = original ? viewer.state.askReason : noOriginal(viewer.state);
    setText(load, original ? 'Replay shrunk' : 'Replay original');
    load.disabled = why !== '';
    load.title = why;
  };
  return { element, topics: ['case', 'source', 'status'], everyMs: 250, update };
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
