// Short lines at the lower edge of the map: answers of the player, what was saved, what went wrong.

import { el } from './dom';

const goodMs = 3000;
const badMs = 8000;
const mostShown = 4;

export interface Notices {
  readonly element: HTMLElement;
  show(line: string, bad?: boolean): void;
  clear(): void;
}

export function notices(): Notices {
  const element = el('div', {
    class: 'notices',
    role: 'log',
    'aria-live': 'polite',
    'aria-label': 'Notices',
  });
  return {
    element,
    show: (line, bad = false) => {
      if (element.lastElementChild?.textContent === line) element.lastElementChild.remove();
      const notice = el('p', { class: bad ? 'notice bad' : 'notice' }, line);
      element.append(notice);
      while (element.childElementCount > mostShown) element.firstElementChild?.remove();
      setTimeout(() => notice.remove(), bad ? badMs : goodMs);
    },
    clear: () => element.replaceChildren(),
  };
}
