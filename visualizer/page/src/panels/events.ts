// What happened, in order: commands, faults, collisions, verdicts, messages. A click seeks.

import type { VizEvent } from '../../../codec/messages';
import { el } from '../shell/dom';
import { secondsText } from './format';
import type { Context, Panel } from './panel';

// Older ones are left out of the list, not of the run.
const mostShown = 500;

const signs: Readonly<Record<string, string>> = {
  command: '›',
  fault: '▲',
  collision: '✖',
  verdict: '■',
  log: '·',
};

export function eventsPanel(context: Context): Panel {
  const { viewer } = context;
  const list = el('ol', { class: 'events' });
  const none = el('p', { class: 'none' }, 'Nothing has happened yet.');
  const withCommands = el('input', { type: 'checkbox' });
  const filter = el('label', { class: 'check' }, withCommands, 'with commands');
  const element = el('div', { class: 'tab-content' }, el('p', { class: 'row' }, filter), list, none);
  let first: VizEvent | undefined;
  let shown = 0; // events looked at, in the order of the run

  const clear = (): void => {
    list.replaceChildren();
    shown = 0;
  };
  const update = (): void => {
    if (element.hidden) return;
    const { events } = viewer.state;
    if (events[0] !== first || events.length < shown) clear();
    first = events[0];
    for (const event of events.slice(Math.max(shown, events.length - mostShown))) {
      if (event.kind !== 'command' || withCommands.checked) list.append(row(context, event));
    }
    shown = events.length;
    while (list.childElementCount > mostShown) list.firstElementChild?.remove();
    none.hidden = list.childElementCount > 0;
  };
  withCommands.addEventListener('change', () => {
    clear();
    update();
  });
  new MutationObserver(update).observe(element, { attributeFilter: ['hidden'] });
  return { element, topics: ['events', 'source'], everyMs: 200, update };
}

function row(context: Context, event: VizEvent): HTMLElement {
  const seek = el(
    'button',
    { type: 'button', class: 'command' },
    el('span', { class: 'index', 'aria-hidden': 'true' }, signs[event.kind] ?? '·'),
    el('span', { class: 'time' }, secondsText(event.tUs, 2)),
    el('span', { class: 'text' }, event.kind === 'log' ? event.text : `${event.kind}: ${event.text}`),
  );
  seek.addEventListener('click', () => context.viewer.seek(event.tUs));
  return el('li', { class: event.kind }, seek);
}
