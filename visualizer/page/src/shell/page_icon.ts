// Title and icon of the browser's tab: they tell of a failure when the page is not looked at.

import { Verdict } from '../../../codec/messages';
import type { ViewerState } from '../model/viewer';

export type Alarm = 'none' | 'failed' | 'differs';

export function alarmOf(state: Pick<ViewerState, 'status' | 'collisions' | 'failingCommand'>): Alarm {
  if (state.status?.verdict === Verdict.differs) return 'differs';
  const failed = state.status?.verdict === Verdict.failed || state.collisions.length > 0;
  return failed || state.failingCommand >= 0 ? 'failed' : 'none';
}

export function titleOf(alarm: Alarm, name: string, what: string): string {
  const page = name === '' ? 'FaultCheck visualizer' : `${name} – FaultCheck visualizer`;
  if (alarm === 'none') return page;
  return `${alarm === 'failed' ? '✖' : '≠'} ${what} · ${page}`;
}

// A square with the sign of the state; the sign differs as well as the colour.
export function iconOf(alarm: Alarm): string {
  const [colour, sign] = signs[alarm];
  const svg = `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 16 16"><rect width="16" height="16" rx="3" fill="${colour}"/><path d="${sign}" stroke="#fff" stroke-width="2" fill="none"/></svg>`;
  return `data:image/svg+xml,${encodeURIComponent(svg)}`;
}

const signs: Readonly<Record<Alarm, readonly [string, string]>> = {
  none: ['#0a5ba8', 'M4 4l8 8M12 4l-8 8M3 4h2M11 4h2M3 12h2M11 12h2'],
  failed: ['#b01e2f', 'M3.5 3.5l9 9M12.5 3.5l-9 9'],
  differs: ['#8a4700', 'M3 6h10M3 10h10M10.5 3l-5 10'],
};

export function showAlarm(alarm: Alarm, name: string, what: string): void {
  const title = titleOf(alarm, name, what);
  if (document.title !== title) document.title = title;
  const link = document.querySelector('#icon');
  const href = iconOf(alarm);
  if (link !== null && link.getAttribute('href') !== href) link.setAttribute('href', href);
}
