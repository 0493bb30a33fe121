import { expect, test } from 'vitest';
import { aCase, aStatus } from '../model/testing';
import { noOriginal } from './shrinking';

test('the original can be replayed where there is one and the player may be asked', () => {
  const caseInfo = { ...aCase([0, 1]), ncmdOriginal: 9 };
  const shown = { caseInfo, status: aStatus({ mode: 2 }), askReason: '' };
  expect(noOriginal(shown)).toBe('');
  expect(noOriginal({ ...shown, askReason: 'no control' })).toBe('no control');
  expect(noOriginal({ ...shown, caseInfo: { ...caseInfo, ncmdOriginal: 2 } })).toContain('nothing away');
  expect(noOriginal({ ...shown, caseInfo: { ...caseInfo, ncmdOriginal: 0 } })).toContain('not shrunk');
  expect(noOriginal({ ...shown, status: aStatus({ mode: 1 }) })).toContain('replays a case');
});
