// The faults that are active at the moment shown, with the letters of the map.

import type { Fault } from '../../../codec/messages';
import { activeAt, faultLetter, faultText } from '../model/faults';
import { el } from '../shell/dom';
import { secondsText } from './format';
import type { Context, Panel } from './panel';

export function activeFaultsPanel({ viewer }: Context): Panel {
  const list = el('ul', { class: 'faults' });
  const none = el('p', { class: 'none' }, 'None.');
  const element = el(
    'section',
    { class: 'section', 'aria-label': 'Active faults' },
    el('h2', {}, 'Active faults'),
    list,
    none,
  );
  let shown = '';
  const update = (): void => {
    const { faults, tUs } = viewer.state;
    const active = (faults?.items ?? []).filter((fault) => activeAt(fault, tUs));
    const now = JSON.stringify(active);
    none.hidden = active.length > 0;
    if (now === shown) return;
    shown = now;
    list.replaceChildren(...active.map(item));
  };
  return { element, topics: ['faults', 'time', 'source'], everyMs: 100, update };
}

function item(fault: Fault): HTMLElement {
  const until = fault.toUs < 0 ? 'no end known' : `until ${secondsText(fault.toUs, 2)} s`;
  const hits = fault.hits < 0 ? '' : `, ${fault.hits} hit${fault.hits === 1 ? '' : 's'}`;
  return el(
    'li',
    {
      title: `${faultText(fault)}\nfrom ${secondsText(fault.fromUs, 2)} s, ${until}${hits}\n${fault.params}`,
    },
    el('b', { class: 'letter' }, faultLetter(fault)),
    el('span', {}, faultText(fault)),
    el('span', { class: 'aside' }, hits.slice(2)),
  );
}
