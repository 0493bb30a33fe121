// The side columns, which are drawers over the map where the window is narrow: one open at a time.

import { el, setClass } from './dom';

export interface Drawers {
  readonly left: HTMLElement;
  readonly right: HTMLElement;
  toggle(side: 'left' | 'right'): 'true' | 'false';
  close(): void;
}

export function drawers(): Drawers {
  const left = el('aside', { class: 'column left', 'aria-label': 'Case' });
  const right = el('aside', { class: 'column right', 'aria-label': 'Object and control' });
  const close = (): void => {
    for (const side of [left, right]) setClass(side, 'open', false);
    for (const one of document.querySelectorAll('.drawer-button')) one.setAttribute('aria-expanded', 'false');
  };
  return {
    left,
    right,
    close,
    toggle: (side) => {
      const drawer = side === 'left' ? left : right;
      const open = !drawer.classList.contains('open');
      close();
      setClass(drawer, 'open', open);
      if (open) drawer.querySelector<HTMLElement>('button, select, input')?.focus();
      return open ? 'true' : 'false';
    },
  };
}
