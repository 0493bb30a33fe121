// The list of keys, as a dialog.

import { button, el } from './dom';
import { keyList } from './keys';

export function helpDialog(): HTMLDialogElement {
  const rows = keyList.map(([keys, what]) =>
    el(
      'tr',
      {},
      el('th', { scope: 'row' }, ...keys.split(/ +/).map((key) => el('kbd', {}, key))),
      el('td', {}, what),
    ),
  );
  const dialog = el(
    'dialog',
    { class: 'help', 'aria-labelledby': 'help-title' },
    el('h1', { id: 'help-title' }, 'Keys'),
    el('table', {}, el('tbody', {}, ...rows)),
    el(
      'p',
      {},
      'On the map: drag to pan, wheel to zoom, click to choose, double click to centre and follow.',
    ),
    button('Close', () => dialog.close(), { class: 'primary' }),
  );
  dialog.addEventListener('click', (event) => {
    if (event.target === dialog) dialog.close();
  });
  return dialog;
}
