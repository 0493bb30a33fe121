// Changing a live run: gains and parameters, adding and removing objects, scenario files.

import { button, el, labelled, newId, setHidden, setText } from '../shell/dom';
import { caseParams } from './case_params';
import { objectName } from './format';
import { freePlace } from './free_place';
import { act, type Context, type Panel } from './panel';

export function runControlsPanel(context: Context): Panel {
  const parts = [parameters(context), objects(context), scenarios(context)];
  const reason = el('p', { class: 'hint', role: 'note' });
  const element = el(
    'section',
    { class: 'section', 'aria-label': 'Change the run' },
    el('h2', {}, 'Change the run'),
    ...parts.map((part) => part.element),
    reason,
  );
  const update = (): void => {
    const { controlAllowed, controlReason } = context.viewer.state;
    for (const part of parts) part.update(controlAllowed);
    setText(reason, controlReason);
    setHidden(reason, controlReason === '');
  };
  return { element, topics: ['source', 'status', 'case', 'selection'], everyMs: 200, update };
}

interface Part {
  element: HTMLElement;
  update(allowed: boolean): void;
}

const input = (attributes: Record<string, string>): HTMLInputElement =>
  el('input', { type: 'text', autocomplete: 'off', ...attributes });

function parameters(context: Context): Part {
  const { viewer } = context;
  const list = el('datalist', { id: newId('names') });
  const name = input({ list: list.id, size: '12' });
  const value = input({ inputmode: 'decimal', size: '6' });
  const whom = el(
    'select',
    {},
    el('option', { value: 'all' }, 'all objects'),
    el('option', { value: 'one' }, 'observer'),
  );
  const set = el('button', { type: 'submit' }, 'Set');
  const fill = (): void => {
    const present = caseParams(viewer.state.caseInfo).settings.get(name.value);
    if (present !== undefined) value.value = String(present);
  };
  name.addEventListener('input', fill);
  value.addEventListener('focus', () => value.select());
  const submit = (): void => {
    const number = Number(value.value);
    if (name.value === '') context.notify('name: expected that of a gain or parameter', true);
    else if (value.value.trim() === '' || !Number.isFinite(number)) {
      context.notify(`value: expected a number, got "${value.value}"`, true);
    } else void act(context, 'set', whom.value === 'all' ? -1 : viewer.state.observer, [number], name.value);
  };
  let known = '';
  return {
    element: form('Gains and parameters', submit, [
      labelled('Name', name, 'field beside'),
      labelled('Value', value, 'field beside'),
      labelled('Of', whom, 'field beside'),
      el('p', { class: 'row' }, set),
      list,
    ]),
    update: (allowed) => {
      const settings = caseParams(viewer.state.caseInfo).settings;
      const now = [...settings].join();
      if (now !== known)
        list.replaceChildren(...[...settings].map(([key, v]) => el('option', { value: key }, String(v))));
      known = now;
      set.disabled = !allowed || (whom.value === 'one' && viewer.state.observer < 0);
    },
  };
}

function objects(context: Context): Part {
  const { viewer } = context;
  const x = input({ inputmode: 'decimal', size: '5', value: '0' });
  const y = input({ inputmode: 'decimal', size: '5', value: '0' });
  const add = el('button', { type: 'submit' }, 'Add');
  const remove = button('Remove observer', () => void act(context, 'remove_object', viewer.state.observer));
  let chosen = false; // by the user; else a free place is proposed
  for (const one of [x, y]) {
    one.addEventListener('input', () => {
      chosen = true;
    });
  }
  const submit = (): void => {
    const at = [Number(x.value), Number(y.value)];
    if (at.every(Number.isFinite)) {
      chosen = false;
      void act(context, 'add_object', -1, at);
    } else context.notify(`position: expected two numbers in m, got "${x.value}" and "${y.value}"`, true);
  };
  const propose = (): void => {
    const [freeX, freeY] = freePlace(viewer.state.frame?.objects ?? [], viewer.state.world);
    x.value = String(freeX);
    y.value = String(freeY);
  };
  const element = form('Objects', submit, [
    el('div', { class: 'two' }, labelled('x in m', x), labelled('y in m', y)),
    el('p', { class: 'row' }, add, remove),
  ]);
  return {
    element,
    update: (allowed) => {
      const object = viewer.state.frame?.objects.find((o) => o.id === viewer.state.observer);
      add.disabled = !allowed;
      if (allowed && !chosen && document.activeElement !== x && document.activeElement !== y) propose();
      remove.disabled = !allowed || object === undefined;
      setText(remove, object === undefined ? 'Remove observer' : `Remove ${objectName(object)}`);
    },
  };
}

function scenarios(context: Context): Part {
  const list = el('datalist', { id: newId('scenarios') });
  const name = input({ list: list.id, size: '16', placeholder: 'file in the scenario folder' });
  const start = el('button', { type: 'submit' }, 'Start');
  const submit = (): void => {
    if (name.value === '') context.notify('scenario: expected the name of a file', true);
    else void act(context, 'scenario', -1, [], name.value);
  };
  let known = '';
  return {
    element: form('Scenario', submit, [
      labelled('File', name, 'field beside'),
      el('p', { class: 'row' }, start),
      list,
    ]),
    update: (allowed) => {
      const names = caseParams(context.viewer.state.caseInfo).scenarios;
      if (names.join() !== known) list.replaceChildren(...names.map((one) => el('option', { value: one })));
      known = names.join();
      start.disabled = !allowed;
    },
  };
}

function form(title: string, submit: () => void, content: readonly HTMLElement[]): HTMLElement {
  const made = el('form', { novalidate: true }, ...content);
  made.addEventListener('submit', (event) => {
    event.preventDefault();
    submit();
  });
  return el('details', {}, el('summary', {}, title), made);
}
