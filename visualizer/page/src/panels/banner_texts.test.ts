import { expect, test } from 'vitest';
import { NOT_CONNECTED } from '../model/viewer';
import { aCase, anObject, aStatus } from '../model/testing';
import { bannersOf } from './banner_texts';

type State = Parameters<typeof bannersOf>[0];
const calm: State = {
  badge: 'REPLAY',
  badgeAgeS: 0,
  connection: NOT_CONNECTED,
  status: aStatus(),
  collisions: [],
  caseInfo: aCase([0]),
  failingCommand: -1,
  frame: { tUs: 0, run: 1, seq: 1, objects: [anObject(7), anObject(4)] },
};
const told = (change: Partial<State>): string[] =>
  bannersOf({ ...calm, ...change }).map(({ kind, text }) => `${kind}: ${text}`);
const hit = { tUs: 7_420_000, a: 7, b: 4, terrain: false, x: 0, y: 0 };

test('nothing to tell, no banner', () => {
  expect(told({})).toEqual([]);
});

test('a collision names both and the time', () => {
  expect(told({ collisions: [hit] })).toEqual(['failed: Collision · Quad 7 ↔ Quad 4 · t = 7.42 s']);
  expect(told({ collisions: [{ ...hit, b: 3, terrain: true }] })[0]).toContain('Quad 7 ↔ terrain');
});

test('a failure without a collision leads to the failing command', () => {
  const failed = bannersOf({
    ...calm,
    status: aStatus({ verdict: 2, message: 'deployed' }),
    failingCommand: 0,
  });
  expect(failed).toEqual([{ kind: 'failed', text: 'Failed: deployed', show: 'command' }]);
});

test('a run that ends otherwise tells both verdicts', () => {
  const caseInfo = { ...aCase([0]), params: '{"recorded":"collision at 7.42 s"}' };
  expect(told({ caseInfo, status: aStatus({ verdict: 3, message: 'no collision' }) })).toEqual([
    'differs: This build does not end as recorded · recorded: collision at 7.42 s · now: no collision',
  ]);
});

test('stale data tell their age, a lost connection the time to the next try', () => {
  expect(told({ badge: 'STALE', badgeAgeS: 3.25 })).toEqual(['stale: No frames for 3.3 s']);
  const connection = { ...NOT_CONNECTED, kind: 'socket' as const, retryInS: 1.5 };
  expect(told({ badge: 'DISCONNECTED', connection })).toEqual([
    'disconnected: Disconnected from the bridge · next try in 1.5 s',
  ]);
});

test('an error of the source is told as it is', () => {
  const connection = { ...NOT_CONNECTED, error: 'VIZ_FRAME: type mismatch: rebuild' };
  expect(told({ connection })).toEqual(['problem: VIZ_FRAME: type mismatch: rebuild']);
});
