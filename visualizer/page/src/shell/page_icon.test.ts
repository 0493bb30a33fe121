import { expect, test } from 'vitest';
import { aStatus } from '../model/testing';
import { alarmOf, iconOf, titleOf } from './page_icon';

const calm = { status: aStatus(), collisions: [], failingCommand: -1 };
const collision = { tUs: 1, a: 1, b: 2, terrain: false, x: 0, y: 0 };

test('a collision, a failed verdict and a failing command raise the alarm; a differing end its own', () => {
  expect(alarmOf(calm)).toBe('none');
  expect(alarmOf({ ...calm, collisions: [collision] })).toBe('failed');
  expect(alarmOf({ ...calm, status: aStatus({ verdict: 2 }) })).toBe('failed');
  expect(alarmOf({ ...calm, failingCommand: 0 })).toBe('failed');
  expect(alarmOf({ ...calm, collisions: [collision], status: aStatus({ verdict: 3 }) })).toBe('differs');
  expect(alarmOf({ ...calm, status: null })).toBe('none');
});

test('title and icon of a failure are others than those of calm', () => {
  expect(titleOf('none', 'case 7', '')).toBe('case 7 – FaultCheck visualizer');
  expect(titleOf('failed', 'case 7', 'Collision')).toBe('✖ Collision · case 7 – FaultCheck visualizer');
  expect(titleOf('none', '', '')).toBe('FaultCheck visualizer');
  expect(new Set([iconOf('none'), iconOf('failed'), iconOf('differs')]).size).toBe(3);
});
