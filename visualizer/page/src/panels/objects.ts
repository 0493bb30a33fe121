// The objects as a table that can be sorted; choosing one makes it the observer.

import { el, setClass, setText } from '../shell/dom';
import { type Column, columns, type Order, type Row, rowsOf } from './object_rows';
import type { Context, Panel } from './panel';

const titles: Readonly<Record<Column, string>> = {
  name: 'name',
  x: 'x',
  y: 'y',
  v: 'speed',
  error: 'error',
  state: 'state',
};

export function objectsPanel(context: Context): Panel {
  const { viewer, settings } = context;
  const order: Order = { column: 'name', descending: false };
  const caption = el('caption', {});
  const body = el('tbody', {});
  const heads = new Map(columns.map((column) => [column, head(column, () => sortBy(column))]));
  const table = el(
    'table',
    { class: 'objects' },
    caption,
    el('thead', {}, el('tr', {}, ...heads.values())),
    body,
  );
  const element = el('div', { class: 'tab-content' }, table);
  const rows: HTMLTableRowElement[] = [];

  const sortBy = (column: Column): void => {
    order.descending = order.column === column ? !order.descending : false;
    order.column = column;
    update();
  };
  const update = (): void => {
    if (element.hidden) return;
    const { frame, faults, tUs, observer } = viewer.state;
    const unit = settings.value.length;
    setText(caption, `Lengths in ${unit}, speed in ${unit}/s; error: from true to perceived`);
    for (const [column, cell] of heads) setSorted(cell, column, order);
    const all = rowsOf(frame?.objects ?? [], faults?.items ?? [], tUs, settings.value, order);
    while (rows.length < all.length) rows.push(newRow(body, context));
    while (rows.length > all.length) rows.pop()?.remove();
    for (const [i, row] of all.entries()) fill(rows[i], row, row.id === observer);
  };
  new MutationObserver(update).observe(element, { attributeFilter: ['hidden'] });
  return { element, topics: ['time', 'selection', 'faults', 'source'], everyMs: 200, update };
}

function head(column: Column, onClick: () => void): HTMLTableCellElement {
  const sort = el('button', { type: 'button' }, titles[column]);
  sort.addEventListener('click', onClick);
  return el('th', { scope: 'col' }, sort);
}

function setSorted(cell: HTMLElement, column: Column, order: Order): void {
  const direction = order.descending ? 'descending' : 'ascending';
  if (order.column === column) cell.setAttribute('aria-sort', direction);
  else cell.removeAttribute('aria-sort');
}

function newRow(body: HTMLElement, context: Context): HTMLTableRowElement {
  const choose = el('button', { type: 'button' });
  const row = el('tr', {}, el('th', { scope: 'row' }, choose), ...columns.slice(1).map(() => el('td', {})));
  const observe = (): void => context.viewer.observe(Number(row.dataset.id ?? -1));
  row.addEventListener('click', observe);
  body.append(row);
  return row;
}

function fill(row: HTMLTableRowElement | undefined, { id, cells }: Row, observed: boolean): void {
  if (row === undefined) return;
  row.dataset.id = String(id);
  setClass(row, 'current', observed);
  const choose = row.querySelector('button');
  if (choose !== null) {
    setText(choose, cells.name);
    choose.setAttribute('aria-pressed', String(observed));
  }
  for (const [i, column] of columns.entries()) {
    const cell = row.cells[i];
    if (i > 0 && cell !== undefined) setText(cell, cells[column]);
  }
  setClass(row, 'alarm', cells.state.startsWith('✖'));
}
