// A list of names and values whose values change: a <dl>.

import { el, setClass, setText } from '../shell/dom';

export interface Facts {
  readonly element: HTMLElement;
  set(name: string, value: string, className?: string): void;
}

export function facts(names: readonly string[]): Facts {
  const values = new Map(names.map((name) => [name, el('dd', {}, '–')]));
  const rows = [...values].map(([name, value]) => el('div', {}, el('dt', {}, name), value));
  return {
    element: el('dl', { class: 'facts' }, ...rows),
    set: (name, value, className = '') => {
      const cell = values.get(name);
      if (cell === undefined) throw new Error(`no fact is called ${name}`);
      setText(cell, value);
      for (const one of ['bad', 'good', 'warn']) setClass(cell, one, one === className);
    },
  };
}
