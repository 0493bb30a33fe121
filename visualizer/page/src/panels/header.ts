// The header: what is shown, which case, how good the connection is; opening, saving, help.

import type { CaseInfo } from '../../../codec/messages';
import type { ViewerState } from '../model/viewer';
import { button, el, type Option, setClass, setOptions, setText } from '../shell/dom';
import { type IconName, icon } from '../shell/icons';
import type { CaseName } from '../shell/parts';
import { caseParams } from './case_params';
import { ageText, bytesText } from './format';
import { FrameRate } from './frame_rate';
import type { Context, Panel } from './panel';

export interface HeaderActions {
  open(): void;
  report(): void;
  picture(): void;
  vector(): void;
  theme(): void;
  help(): void;
  drawer(side: 'left' | 'right'): 'true' | 'false'; // answers whether it is now open
  chooseCase(id: string): void;
  listCases: (() => Promise<readonly CaseName[]>) | undefined;
}

export function headerPanel(context: Context, actions: HeaderActions): Panel {
  const { viewer } = context;
  const badge = el('span', { class: 'badge', role: 'status' });
  const cases = el('select', { 'aria-label': 'Case', class: 'case' });
  const summary = el('span', { class: 'summary' });
  const dot = el('span', { class: 'dot', 'aria-hidden': 'true' });
  const connection = el('span', { class: 'connection-text' });
  const rate = new FrameRate();
  let known: readonly CaseName[] = [];

  const refresh = async (): Promise<void> => {
    try {
      known = (await actions.listCases?.()) ?? [];
    } catch {
      known = []; // the state of the connection is shown beside it
    }
    update();
  };
  if (actions.listCases === undefined) {
    cases.disabled = true;
    cases.title = 'Other cases need a bridge: this page was opened as a file';
  }
  cases.addEventListener('change', () => actions.chooseCase(cases.value));
  cases.addEventListener('pointerdown', () => void refresh());
  cases.addEventListener('focus', () => void refresh());
  const reportButton = button('Report…', actions.report, {
    title: 'Save one HTML file with the page and what it holds (R)',
  });
  const picture = button('Screenshot', actions.picture, { title: 'Save the map as PNG (P)' });
  const vector = button('SVG', actions.vector, { title: 'Save the map as SVG, to be enlarged without loss' });
  const element = el(
    'header',
    { class: 'header' },
    drawerButton('left', 'Case, commands, layers', actions),
    el('strong', { class: 'brand' }, 'Replay visualizer'),
    badge,
    cases,
    summary,
    el('span', { class: 'grow' }),
    el('span', { class: 'connection' }, dot, connection),
    button('Open…', actions.open, { title: 'Open a log (.lcm) or a report (.html)' }),
    reportButton,
    picture,
    vector,
    withIcon('theme', 'Dark or light (D)', actions.theme),
    button('?', actions.help, { class: 'icon-button', 'aria-label': 'Keys (?)', title: 'Keys (?)' }),
    drawerButton('right', 'Object and control', actions),
  );
  const update = (): void => {
    const { state } = viewer;
    showBadge(badge, state);
    setOptions(
      cases,
      caseOptions(known, state.caseInfo, state.connection.fileName),
      state.caseInfo?.caseId ?? '',
    );
    setText(summary, summaryText(state));
    const tone = toneOf(state);
    for (const one of ['good', 'warn', 'bad', 'none']) setClass(dot, one, one === tone);
    setText(
      connection,
      connectionText(state, rate.of(viewer.packed.frames.last?.seq ?? null, state.run, performance.now())),
    );
    for (const one of [reportButton, picture, vector]) one.disabled = state.frame === null;
  };
  return { element, topics: ['source', 'status', 'case', 'buffer', 'time'], everyMs: 200, update };
}

function showBadge(badge: HTMLElement, state: ViewerState): void {
  setText(badge, state.badge === 'STALE' ? `STALE ${ageText(state.badgeAgeS)}` : state.badge);
  badge.dataset.badge = state.badge;
}

// The case that is shown comes first, also when the bridge does not list it.
export function caseOptions(known: readonly CaseName[], shown: CaseInfo | null, fileName: string): Option[] {
  const id = shown?.caseId ?? '';
  const listed = known
    .filter((one) => one.id !== id)
    .map(({ id: value, title }) => ({ value, label: title }));
  if (shown === null) return [{ value: '', label: fileName === '' ? 'no case' : fileName }, ...listed];
  return [{ value: id, label: caseTitle(shown) }, ...listed];
}

// A flight that no test made has no sequence that it was shrunk from.
export function caseTitle(info: CaseInfo): string {
  const property = info.property.replace(/^[^:]*:/, '').replace(/^prop_/, '');
  const name = info.caseId === '' ? 'unnamed case' : `case ${info.caseId}`;
  const counts = info.ncmdOriginal > 0 ? `${info.commands.length}/${info.ncmdOriginal}` : '';
  return [name, property === info.caseId ? '' : property, counts].filter((part) => part !== '').join(' · ');
}

export function summaryText(state: Pick<ViewerState, 'caseInfo' | 'frame'>): string {
  const told = caseParams(state.caseInfo).summary;
  if (told !== '') return told;
  const count = state.frame?.objects.length ?? 0;
  return count === 0 ? '' : `${count} object${count === 1 ? '' : 's'}`;
}

type Tone = 'good' | 'warn' | 'bad' | 'none';

export function toneOf(state: Pick<ViewerState, 'badge' | 'connection'>): Tone {
  if (state.connection.kind !== 'socket') return 'none';
  if (!state.connection.connected) return 'bad';
  return state.badge === 'STALE' || state.connection.error !== '' ? 'warn' : 'good';
}

export function connectionText(state: Pick<ViewerState, 'badge' | 'connection'>, hz: number): string {
  const { kind, connected, lost, dropped, bytesPerSec, fileName, retryInS } = state.connection;
  if (kind === 'none') return 'not connected';
  if (kind === 'file') return fileName;
  if (!connected) return retryInS > 0 ? `disconnected · retry in ${retryInS.toFixed(1)} s` : 'connecting…';
  const parts = ['connected', `${hz} Hz`, `${bytesText(bytesPerSec)}/s`];
  if (lost > 0) parts.push(`${lost} lost`);
  if (dropped > 0) parts.push(`${dropped} dropped`);
  return parts.join(' · ');
}

function withIcon(name: IconName, label: string, onClick: () => void): HTMLButtonElement {
  const made = button('', onClick, { class: 'icon-button', 'aria-label': label, title: label });
  made.append(icon(name));
  return made;
}

function drawerButton(side: 'left' | 'right', label: string, actions: HeaderActions): HTMLButtonElement {
  const toggle = (): void => {
    made.ariaExpanded = actions.drawer(side);
  };
  const made = button('', toggle, {
    class: 'icon-button drawer-button',
    'aria-label': label,
    'aria-expanded': 'false',
  });
  made.append(icon(side));
  return made;
}
