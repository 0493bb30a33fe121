import { expect, it } from 'vitest';
import { createTimeAxis, marks, roomFor, wholeSpan } from './time_axis';

const S = 1e6;

it('zooms inside the whole, refuses clicks, and resets', () => {
  const axis = createTimeAxis();
  let heard = 0;
  const leave = axis.listen(() => (heard += 1));
  axis.setWhole({ fromUs: 0, toUs: 8 * S });
  axis.zoom({ fromUs: 5 * S, toUs: 3 * S });
  expect([axis.span, axis.zoomed]).toEqual([{ fromUs: 3 * S, toUs: 5 * S }, true]);
  axis.zoom({ fromUs: -1 * S, toUs: 99 * S });
  expect(axis.span).toEqual({ fromUs: 0, toUs: 8 * S });
  axis.zoom({ fromUs: 3 * S, toUs: 3 * S + 10 });
  expect(axis.span).toEqual({ fromUs: 0, toUs: 8 * S });
  axis.reset();
  expect([axis.zoomed, heard]).toEqual([false, 4]);
  leave();
  axis.setWhole({ fromUs: 0, toUs: 9 * S });
  expect(heard).toBe(4);
});

it('keeps a zoomed part while the whole grows, gives it up when it is gone', () => {
  const axis = createTimeAxis();
  axis.setWhole({ fromUs: 0, toUs: 10 * S });
  axis.zoom({ fromUs: 2 * S, toUs: 4 * S });
  axis.setWhole({ fromUs: 0, toUs: 20 * S });
  expect(axis.span).toEqual({ fromUs: 2 * S, toUs: 4 * S });
  axis.setWhole({ fromUs: 0, toUs: 3 * S });
  expect(axis.span).toEqual({ fromUs: 0, toUs: 3 * S });
});

it('marks are round and far enough apart', () => {
  expect(marks({ fromUs: 0, toUs: 8 * S }, 0.9 * S)).toEqual({
    timesUs: [0, 1, 2, 3, 4, 5, 6, 7, 8].map((t) => t * S),
    stepUs: S,
  });
  expect(marks({ fromUs: 0.3 * S, toUs: 1 * S }, 0.15 * S).timesUs).toEqual([
    0.4 * S,
    0.6 * S,
    0.8 * S,
    1 * S,
  ]);
  expect(marks({ fromUs: 0, toUs: 100 * S }, 21 * S).stepUs).toBe(50 * S);
});

it('growing data get room, known ones none', () => {
  expect([roomFor(0), roomFor(10 * S), roomFor(11 * S), roomFor(700 * S)]).toEqual([
    10 * S,
    10 * S,
    15 * S,
    900 * S,
  ]);
  expect(wholeSpan(true, 0, 8 * S)).toEqual({ fromUs: 0, toUs: 8 * S });
  expect(wholeSpan(false, 0, 8 * S)).toEqual({ fromUs: 0, toUs: 10 * S });
});
