import { expect, test } from 'vitest';
import { NOT_CONNECTED } from '../model/viewer';
import { aCase, anObject } from '../model/testing';
import { caseOptions, caseTitle, connectionText, summaryText, toneOf } from './header';

const shown = {
  ...aCase([0, 1]),
  caseId: '0042',
  property: 'copter_eqc:prop_no_collision',
  ncmdOriginal: 212,
};
const socket = { ...NOT_CONNECTED, kind: 'socket' as const, connected: true, bytesPerSec: 260_000 };

test('a case is named by its id, property and counts', () => {
  expect(caseTitle(shown)).toBe('case 0042 · no_collision · 2/212');
});

test('a flight by hand has no counts, and is not named twice', () => {
  const flown = { ...shown, caseId: 'flown by hand', property: 'flown by hand', ncmdOriginal: 0 };
  expect(caseTitle(flown)).toBe('case flown by hand');
});

test('the case shown comes first, once', () => {
  const known = [
    { id: '0041', title: 'older' },
    { id: '0042', title: 'this' },
  ];
  expect(caseOptions(known, shown, '').map(({ value }) => value)).toEqual(['0042', '0041']);
  expect(caseOptions(known, null, 'run.lcm').map(({ label }) => label)).toEqual(['run.lcm', 'older', 'this']);
});

test('the summary is what the case says, else the number of objects', () => {
  expect(summaryText({ caseInfo: { ...shown, params: '{"summary":"12 copters"}' }, frame: null })).toBe(
    '12 copters',
  );
  expect(summaryText({ caseInfo: null, frame: { tUs: 0, run: 1, seq: 0, objects: [anObject(1)] } })).toBe(
    '1 object',
  );
});

test('the connection tells rate and losses', () => {
  expect(connectionText({ badge: 'LIVE', connection: socket }, 60)).toBe('connected · 60 Hz · 260 kB/s');
  const lossy = { ...socket, lost: 3, dropped: 2 };
  expect(connectionText({ badge: 'LIVE', connection: lossy }, 60)).toBe(
    'connected · 60 Hz · 260 kB/s · 3 lost · 2 dropped',
  );
  const gone = { ...socket, connected: false, retryInS: 4 };
  expect(connectionText({ badge: 'DISCONNECTED', connection: gone }, 0)).toBe(
    'disconnected · retry in 4.0 s',
  );
  expect(toneOf({ badge: 'DISCONNECTED', connection: gone })).toBe('bad');
  expect(toneOf({ badge: 'STALE', connection: socket })).toBe('warn');
  expect(toneOf({ badge: 'LIVE', connection: socket })).toBe('good');
});
