// Tabs after the ARIA pattern: one is in the tab order, arrow keys go to the others.

import { el, newId, setHidden } from '../shell/dom';

export interface Tab {
  label: string;
  content: HTMLElement;
}

export function tabs(label: string, all: readonly Tab[]): HTMLElement {
  const buttons = all.map(({ label: text, content }) => {
    const id = newId('tab');
    content.id = newId('tabpanel');
    content.setAttribute('role', 'tabpanel');
    content.setAttribute('aria-labelledby', id);
    return el('button', { type: 'button', role: 'tab', id, 'aria-controls': content.id }, text);
  });
  const show = (index: number): void => {
    for (const [i, button] of buttons.entries()) {
      button.setAttribute('aria-selected', String(i === index));
      button.tabIndex = i === index ? 0 : -1;
    }
    for (const [i, { content }] of all.entries()) setHidden(content, i !== index);
  };
  const move = (event: KeyboardEvent): void => {
    const now = buttons.findIndex((button) => button.matches(':focus'));
    const next = nextTab(event.key, now, buttons.length);
    if (next === null) return;
    event.preventDefault();
    show(next);
    buttons[next]?.focus();
  };
  for (const [i, button] of buttons.entries()) button.addEventListener('click', () => show(i));
  const list = el('div', { role: 'tablist', class: 'tabs', 'aria-label': label }, ...buttons);
  list.addEventListener('keydown', move);
  show(0);
  return el('div', { class: 'tabbed' }, list, ...all.map(({ content }) => content));
}

export function nextTab(key: string, now: number, count: number): number | null {
  if (key === 'ArrowRight') return (now + 1) % count;
  if (key === 'ArrowLeft') return (now + count - 1) % count;
  if (key === 'Home') return 0;
  return key === 'End' ? count - 1 : null;
}
