// How the case came to be: what shrinking left of it, and which of the two sequences is played.

import { Mode } from '../../../codec/messages';
import { button, el, setText } from '../shell/dom';
import { caseParams } from './case_params';
import { facts } from './facts';
import { act, type Context, type Panel } from './panel';

export function shrinkingPanel(context: Context): Panel {
  const { viewer } = context;
  const all = facts(['original / shrunk', 'shrink steps', 'property', 'seed', 'replays same', 'code']);
  let original = false; // asked for by the button
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
    const { caseInfo, connection, status } = viewer.state;
    element.hidden = caseInfo === null;
    if (caseInfo === null) return;
    const params = caseParams(caseInfo);
    const shrunk = caseInfo.ncmdOriginal > 0;
    all.set('original / shrunk', shrunk ? `${caseInfo.ncmdOriginal} / ${caseInfo.commands.length}` : '–');
    all.set('shrink steps', params.shrinkSteps === null ? '–' : String(params.shrinkSteps));
    all.set('property', caseInfo.property || '–');
    all.set('seed', caseInfo.seed || '–');
    all.set('replays same', params.sameAgain || '–');
    all.set('code', caseInfo.codeVersion || '–');
    const can = connection.kind === 'socket' && connection.connected && status?.mode === Mode.replay;
    setText(load, original ? 'Replay shrunk' : 'Replay original');
    load.disabled = !can;
    load.title = can ? '' : 'Needs a player that replays a case';
  };
  return { element, topics: ['case', 'source', 'status'], everyMs: 250, update };
}
