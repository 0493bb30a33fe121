// The commands of the case: the current one is highlighted, a click seeks, the failing one is marked.

import type { CaseInfo, Command } from '../../../codec/messages';
import { button, el, setClass, setText } from '../shell/dom';
import { icon } from '../shell/icons';
import { commandsTerm, commandTerm, commandText } from './erlang_term';
import { secondsText } from './format';
import type { Context, Panel } from './panel';

export function commandsPanel(context: Context): Panel {
  const { viewer } = context;
  const list = el('ol', { class: 'commands' });
  const none = el('p', { class: 'none' }, 'No commands are known.');
  const copyAll = button('Copy all as Erlang term', () => copy(context, viewer.state.caseInfo));
  const element = el('div', { class: 'tab-content' }, list, none, el('p', { class: 'row' }, copyAll));
  let shown: readonly Command[] = [];
  let rows: HTMLElement[] = [];
  let current = -2;
  copyAll.hidden = true;

  const rebuild = (info: CaseInfo | null): void => {
    shown = info?.commands ?? [];
    rows = shown.map((command) => row(context, command, info?.property ?? ''));
    list.replaceChildren(...rows);
    none.hidden = shown.length > 0;
    copyAll.hidden = shown.length === 0;
    current = -2;
  };
  const update = (): void => {
    const { caseInfo, currentCommand, failingCommand } = viewer.state;
    if (!sameCommands(caseInfo?.commands ?? [], shown)) rebuild(caseInfo);
    for (const [i, item] of rows.entries()) mark(item, i === failingCommand);
    if (currentCommand === current) return;
    current = currentCommand;
    for (const [i, item] of rows.entries()) highlight(item, i === current);
    if (!list.matches(':hover, :focus-within')) rows[current]?.scrollIntoView({ block: 'nearest' });
  };
  return { element, topics: ['case', 'time', 'events', 'source', 'status'], everyMs: 60, update };
}

// The case comes again each second.
function sameCommands(a: readonly Command[], b: readonly Command[]): boolean {
  if (a === b) return true;
  return a.length === b.length && a.every((one, i) => sameCommand(one, b[i]));
}

function sameCommand(a: Command, b: Command | undefined): boolean {
  return b !== undefined && a.tUs === b.tUs && a.name === b.name && a.args === b.args;
}

function row(context: Context, command: Command, property: string): HTMLElement {
  const text = commandText(command);
  const seek = el(
    'button',
    {
      type: 'button',
      class: 'command',
      title: `${text}\nat ${secondsText(command.tUs)} s: click to go there`,
    },
    el('span', { class: 'index' }, String(command.index + 1)),
    el('span', { class: 'time' }, secondsText(command.tUs, 2)),
    el('span', { class: 'text' }, text),
    el('span', { class: 'mark', 'aria-label': '' }),
  );
  seek.addEventListener('click', () => context.viewer.seek(command.tUs));
  const copyOne = el('button', {
    type: 'button',
    class: 'copy',
    'aria-label': `Copy ${text} as Erlang term`,
  });
  copyOne.append(icon('copy'));
  copyOne.addEventListener('click', () => void toClipboard(context, commandTerm(command, property)));
  const kind = /^fault/.test(command.name) ? 'fault' : '';
  return el('li', { class: kind }, seek, copyOne);
}

function highlight(item: HTMLElement, on: boolean): void {
  setClass(item, 'current', on);
  if (on) item.firstElementChild?.setAttribute('aria-current', 'step');
  else item.firstElementChild?.removeAttribute('aria-current');
}

function mark(item: HTMLElement, failing: boolean): void {
  if (item.classList.contains('failing') === failing) return;
  setClass(item, 'failing', failing);
  const sign = item.querySelector('.mark');
  if (sign === null) return;
  setText(sign, failing ? '✖ failed' : '');
}

function copy(context: Context, info: CaseInfo | null): void {
  if (info !== null) void toClipboard(context, commandsTerm(info));
}

async function toClipboard(context: Context, text: string): Promise<void> {
  try {
    await navigator.clipboard.writeText(text);
    context.notify('copied');
  } catch {
    context.notify('the browser does not allow copying here', true);
  }
}
