import { expect, test } from 'vitest';
import {
  ageText,
  angleText,
  bytesText,
  distance,
  lengthText,
  objectName,
  positionText,
  rateText,
  secondsText,
  shortName,
  speedFactorText,
  speedText,
} from './format';

const metric = { length: 'm', angle: 'deg' } as const;
const fine = { length: 'mm', angle: 'rad' } as const;

test('lengths are told in the chosen unit', () => {
  expect(lengthText(1.2345, metric)).toBe('1.23 m');
  expect(lengthText(0.0266, metric, 3)).toBe('0.027 m');
  expect(lengthText(0.0266, fine, 3)).toBe('27 mm');
  expect(positionText(-4.6, -0.014, metric)).toBe('-4.60, -0.01 m');
  expect(positionText(-4.6, -0.014, fine)).toBe('-4600, -14 mm');
  expect(speedText(0.25, metric)).toBe('0.25 m/s');
  expect(speedText(0.25, fine)).toBe('250 mm/s');
});

test('angles are told in the chosen unit', () => {
  expect(angleText(Math.PI / 2, metric)).toBe('90.0°');
  expect(angleText(Math.PI / 2, fine)).toBe('1.571 rad');
  expect(rateText(-Math.PI / 4, metric)).toBe('-45.0°/s');
});

test('what is not a number is told as such', () => {
  expect(lengthText(Number.NaN, metric)).toBe('– m');
  expect(angleText(Number.POSITIVE_INFINITY, metric)).toBe('–');
});

test('times, sizes and speeds', () => {
  expect(secondsText(7_420_000)).toBe('7.420');
  expect(secondsText(7_420_000, 2)).toBe('7.42');
  expect(ageText(2.34)).toBe('2.3 s');
  expect(ageText(125)).toBe('2 min');
  expect([bytesText(640), bytesText(262_144), bytesText(2_600_000)]).toEqual(['640 B', '262 kB', '2.6 MB']);
  expect([speedFactorText(0.05), speedFactorText(1), speedFactorText(20)]).toEqual(['0.05×', '1×', '20×']);
});

test('objects are named by their kind', () => {
  expect([objectName({ id: 4, kind: 0 }), shortName({ id: 4, kind: 0 })]).toEqual(['Quad 4', 'Q4']);
  expect([objectName({ id: 1, kind: 1 }), shortName({ id: 1, kind: 1 })]).toEqual(['Car 1', 'C1']);
  expect([objectName({ id: 1, kind: 9 }), shortName({ id: 1, kind: 9 })]).toEqual(['Object 1', 'O1']);
});

test('distances are those of space', () => {
  expect(distance([0, 0, 0], [2, 3, 6])).toBe(7);
});
