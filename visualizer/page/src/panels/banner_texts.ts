// What the banners over the map say, from the state. No DOM.

import { Verdict } from '../../../codec/messages';
import type { Collision, ViewerState } from '../model/viewer';
import { caseParams } from './case_params';
import { objectName, secondsText } from './format';

export interface BannerText {
  kind: 'failed' | 'differs' | 'stale' | 'disconnected' | 'problem';
  text: string;
  show: 'collision' | 'command' | null; // where its button leads
}

type Seen = Pick<
  ViewerState,
  'badge' | 'badgeAgeS' | 'connection' | 'status' | 'collisions' | 'caseInfo' | 'failingCommand' | 'frame'
>;

// The most urgent first.
export function bannersOf(state: Seen): BannerText[] {
  const { connection } = state;
  const all: (BannerText | null)[] = [
    connection.error === '' ? null : { kind: 'problem', text: connection.error, show: null },
    differs(state),
    failed(state),
    disconnected(state),
    state.badge === 'STALE'
      ? { kind: 'stale', text: `No frames for ${state.badgeAgeS.toFixed(1)} s`, show: null }
      : null,
  ];
  return all.filter((banner) => banner !== null);
}

function failed(state: Seen): BannerText | null {
  const [collision] = state.collisions;
  if (collision !== undefined) {
    return { kind: 'failed', text: collisionText(collision, state.frame?.objects ?? []), show: 'collision' };
  }
  if (state.status?.verdict !== Verdict.failed && state.failingCommand < 0) return null;
  const why = state.status?.message ?? '';
  const show = state.failingCommand >= 0 ? 'command' : null;
  return { kind: 'failed', text: why === '' ? 'Failed' : `Failed: ${why}`, show };
}

export function collisionText(
  { a, b, terrain, tUs }: Collision,
  objects: readonly { id: number; kind: number }[],
): string {
  const name = (id: number): string => objectName(objects.find((o) => o.id === id) ?? { id, kind: -1 });
  const other = terrain ? 'terrain' : name(b);
  return `Collision · ${name(a)} ↔ ${other} · t = ${secondsText(tUs, 2)} s`;
}

function differs(state: Seen): BannerText | null {
  if (state.status?.verdict !== Verdict.differs) return null;
  const recorded = caseParams(state.caseInfo).recorded;
  const verdicts = [
    ...(recorded === '' ? [] : [`recorded: ${recorded}`]),
    ...(state.status.message === '' ? [] : [`now: ${state.status.message}`]),
  ];
  return {
    kind: 'differs',
    text: ['This build does not end as recorded', ...verdicts].join(' · '),
    show: null,
  };
}

function disconnected({ badge, connection }: Seen): BannerText | null {
  if (badge !== 'DISCONNECTED') return null;
  const retry = connection.retryInS > 0 ? `next try in ${connection.retryInS.toFixed(1)} s` : 'trying again…';
  return { kind: 'disconnected', text: `Disconnected from the bridge · ${retry}`, show: null };
}
