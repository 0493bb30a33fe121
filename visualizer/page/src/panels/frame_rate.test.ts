import { expect, test } from 'vitest';
import { FrameRate } from './frame_rate';

test('counts the frames that came, not those before the page', () => {
  const rate = new FrameRate();
  expect(rate.of(null, 1, 0)).toBe(0);
  expect(rate.of(2000, 1, 200)).toBe(0);
  expect(rate.of(2010, 1, 400)).toBe(50);
  expect(rate.of(2060, 1, 1400)).toBe(50);
  expect(rate.of(3, 2, 1600)).toBe(0); // another run
  expect(rate.of(9, 2, 1700)).toBe(60);
});
