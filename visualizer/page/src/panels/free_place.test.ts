import { expect, test } from 'vitest';
import { anObject } from '../model/testing';
import { freePlace } from './free_place';

test('a copter is added at the origin when nothing is there', () => {
  expect(freePlace([], null)).toEqual([0, 0]);
});

test('else at least 2.6 m from every copter, however many were added so', () => {
  const added = [anObject(1, { pos: [0, 0, 1] })];
  for (let id = 2; id <= 12; id++) {
    const [x, y] = freePlace(added, null);
    for (const { pos } of added) expect(Math.hypot(pos[0] - x, pos[1] - y)).toBeGreaterThanOrEqual(2.6);
    added.push(anObject(id, { pos: [x, y, 1] }));
  }
});

test('and off the lines of terrain', () => {
  const world = { run: 1, version: 1, seg: [[-9, 0, 9, 0] as const], anchors: [], polys: [] };
  const [x, y] = freePlace([], world);
  expect(Math.abs(y)).toBeGreaterThanOrEqual(1.3);
  expect(Math.abs(x)).toBeLessThanOrEqual(1.5);
});
