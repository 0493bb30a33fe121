// The inspector of the observer: choosing it, its numbers, pinning its curves.

import { MAX_PINNED } from '../model/selection';
import { button, el, labelled, setHidden, setOptions } from '../shell/dom';
import { facts } from './facts';
import { objectName } from './format';
import { factsOf, observerFacts } from './observer_facts';
import type { Context, Panel } from './panel';

export function observerPanel(context: Context): Panel {
  const { viewer, settings } = context;
  const choose = el('select', {});
  choose.addEventListener('change', () => viewer.observe(Number(choose.value)));
  const all = facts(observerFacts);
  const pin = button('Pin curves', () => viewer.pin(viewer.state.observer, !isPinned()));
  const isPinned = (): boolean => viewer.state.pinned.includes(viewer.state.observer);
  const pins = el('p', { class: 'chips' });
  const observed = labelled('Observer', choose, 'field beside');
  observed.append(pin);
  const element = el(
    'section',
    { class: 'section', 'aria-label': 'Selected object' },
    el('h2', {}, 'Selected object'),
    observed,
    all.element,
    pins,
  );
  let pinned = '';

  const update = (): void => {
    const { frame, risk, observer } = viewer.state;
    const objects = frame?.objects ?? [];
    const none = { value: '-1', label: objects.length === 0 ? 'none' : 'choose…' };
    const options = objects.map((o) => ({ value: String(o.id), label: objectName(o) }));
    const object = objects.find((o) => o.id === observer);
    setOptions(choose, object === undefined ? [none, ...options] : options, String(object?.id ?? -1));
    choose.disabled = objects.length === 0;
    if (object === undefined) for (const name of observerFacts) all.set(name, '–');
    else {
      for (const [name, { text, bad }] of factsOf(object, objects, risk, settings.value)) {
        all.set(name, text, bad === true ? 'bad' : '');
      }
    }
    pin.disabled = object === undefined || (!isPinned() && viewer.state.pinned.length >= MAX_PINNED);
    pin.setAttribute('aria-pressed', String(isPinned()));
    showPins();
  };
  const showPins = (): void => {
    const now = viewer.state.pinned.join();
    if (now === pinned) return;
    pinned = now;
    pins.replaceChildren(...viewer.state.pinned.map((id) => unpin(context, id)));
    setHidden(pins, viewer.state.pinned.length === 0);
  };
  setHidden(pins, true);
  return { element, topics: ['time', 'selection', 'source'], everyMs: 60, update };
}

function unpin({ viewer }: Context, id: number): HTMLElement {
  return button(`${id} ×`, () => viewer.pin(id, false), {
    class: 'chip',
    'aria-label': `Unpin object ${id}`,
  });
}
