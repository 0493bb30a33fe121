import { expect, it } from 'vitest';
import { badgeOf, controlReason } from './badge';
import { aStatus } from './testing';

const facts = {
  source: 'socket',
  connected: true,
  everConnected: true,
  hasFrames: true,
  status: aStatus(),
  frameAgeS: 0.1,
} as const;

it('says what is shown, for each state of the table', () => {
  expect(badgeOf({ ...facts, source: 'none' })).toBe('NO DATA');
  expect(badgeOf({ ...facts, hasFrames: false })).toBe('NO DATA');
  expect(badgeOf({ ...facts, source: 'file' })).toBe('FILE');
  expect(badgeOf(facts)).toBe('REPLAY');
  expect(badgeOf({ ...facts, status: aStatus({ mode: 1 }) })).toBe('LIVE');
  expect(badgeOf({ ...facts, status: null })).toBe('LIVE');
  expect(badgeOf({ ...facts, connected: false })).toBe('DISCONNECTED');
  expect(badgeOf({ ...facts, connected: false, everConnected: false })).toBe('NO DATA');
});

it('is stale when frames are missing for over a second while playing', () => {
  expect(badgeOf({ ...facts, frameAgeS: 1.1 })).toBe('STALE');
  expect(badgeOf({ ...facts, frameAgeS: 1.1, status: aStatus({ paused: true }) })).toBe('REPLAY');
  expect(badgeOf({ ...facts, frameAgeS: 1.1, status: aStatus({ mode: 0 }) })).toBe('REPLAY');
});

it('gives the reason why control is disabled, none when it is not', () => {
  expect(controlReason('socket', true, aStatus({ mode: 1 }), true)).toBe('');
  const others = [
    controlReason('none', false, null, false),
    controlReason('file', false, null, false),
    controlReason('socket', false, aStatus({ mode: 1 }), true),
    controlReason('socket', true, aStatus({ mode: 1 }), false),
    controlReason('socket', true, null, true),
    controlReason('socket', true, aStatus({ mode: 1, controlAllowed: false }), true),
    controlReason('socket', true, aStatus({ mode: 2 }), true),
    controlReason('socket', true, aStatus({ mode: 0 }), true),
    controlReason('socket', true, aStatus({ mode: 1, verdict: 2 }), true),
  ];
  expect(others.every((reason) => reason.length > 5)).toBe(true);
  expect(new Set(others).size).toBe(others.length);
});
