import { afterEach, beforeEach, expect, test, vi } from 'vitest';
import { type Steer, SteerPad, steerOf, tilt, turn } from './steering';

beforeEach(() => void vi.useFakeTimers());
afterEach(() => void vi.useRealTimers());

test('opposite keys cancel, others add', () => {
  expect(steerOf(new Set(['w']))).toEqual({ roll: tilt, pitch: 0, yawRate: 0 });
  expect(steerOf(new Set(['s', 'd', 'q']))).toEqual({ roll: -tilt, pitch: tilt, yawRate: turn });
  expect(steerOf(new Set(['w', 's', 'e']))).toEqual({ roll: 0, pitch: 0, yawRate: -turn });
});

test('a held key is sent ten times a second, its release once', () => {
  const sent: Steer[] = [];
  const pad = new SteerPad(
    (steer) => sent.push(steer),
    () => undefined,
  );
  pad.press('w');
  pad.press('w'); // the keyboard repeats
  expect(sent).toHaveLength(1);
  vi.advanceTimersByTime(1000);
  expect(sent).toHaveLength(11);
  pad.release('w');
  expect(sent).toHaveLength(12);
  expect(sent.at(-1)).toEqual({ roll: 0, pitch: 0, yawRate: 0 });
  vi.advanceTimersByTime(1000);
  expect(sent).toHaveLength(12);
});

test('releasing one of two keys goes on with the other; releasing all ends it', () => {
  const sent: Steer[] = [];
  const pad = new SteerPad(
    (steer) => sent.push(steer),
    () => undefined,
  );
  pad.press('w');
  pad.press('d');
  pad.release('w');
  expect(sent.at(-1)).toEqual({ roll: 0, pitch: tilt, yawRate: 0 });
  pad.press('q');
  pad.releaseAll();
  expect(sent.at(-1)).toEqual({ roll: 0, pitch: 0, yawRate: 0 });
  const count = sent.length;
  vi.advanceTimersByTime(500);
  pad.releaseAll();
  expect(sent).toHaveLength(count);
});
