// A list of names and values whose values change: a <dl>. What has no value ('') is not shown.

import { el, setClass, setHidden, setText } from '../shell/dom';

export interface Facts {
  readonly element: HTMLElement;
  set(name: string, value: string, className?: string): void;
}

export function facts(names: readonly string[]): Facts {
  const values = new Map(names.map((name) => [name, el('dd', {}, '–')]));
  const rows = new Map([...values].map(([name, cell]) => [name, el('div', {}, el('dt', {}, name), cell)]));
  return {
    element: el('dl', { class: 'facts' }, ...rows.values()),
    set: (name, value, className = '') => {
      const cell = values.get(name);
      const row = rows.get(name);
      if (cell === undefined || row === undefined) throw new Error(`no fact is called ${name}`);
      setText(cell, value);
      setHidden(row, value === '');
      for (const one of ['bad', 'good', 'warn']) setClass(cell, one, one === className);
    },
  };
}
