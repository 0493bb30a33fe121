import { expect, test } from 'vitest';
import { anObject } from '../model/testing';
import { type Order, rowsOf, stateText } from './object_rows';

const units = { length: 'm', angle: 'deg' } as const;
const byName: Order = { column: 'name', descending: false };
const objects = [
  anObject(1, { pos: [3, -1, 1], posEst: [3, -1, 1], vel: [3, 4, 0] }),
  anObject(2, { pos: [-2, 5, 1], posEst: [-2, 5.3, 1.4], flags: 2 }),
  anObject(10, { pos: [0, 0, 1], posEst: [0, 0, 1] }),
];
const fault = {
  object: 2,
  probe: 'PxId2',
  type: 'offset',
  params: '{}',
  fromUs: 100,
  toUs: 200,
  active: true,
  hits: 1,
};

test('a row tells what the map shows', () => {
  const [first, second] = rowsOf(objects, [fault], 150, units, byName);
  expect(first?.cells).toEqual({ name: 'Q1', x: '3.00', y: '-1.00', v: '5.00', error: '0.00', state: '' });
  expect(second?.cells).toEqual({
    name: 'Q2',
    x: '-2.00',
    y: '5.00',
    v: '0.00',
    error: '0.50',
    state: 'avoids P',
  });
});

test('faults are told only while they are active', () => {
  const states = [50, 100, 200].map((tUs) => rowsOf(objects, [fault], tUs, units, byName)[1]?.cells.state);
  expect(states).toEqual(['avoids', 'avoids P', 'avoids']);
});

test('rows are sorted by number, either way', () => {
  const ids = (order: Order): number[] => rowsOf(objects, [], 0, units, order).map(({ id }) => id);
  expect(ids(byName)).toEqual([1, 2, 10]);
  expect(ids({ column: 'name', descending: true })).toEqual([10, 2, 1]);
  expect(ids({ column: 'x', descending: false })).toEqual([2, 10, 1]);
  expect(ids({ column: 'error', descending: true })).toEqual([2, 1, 10]);
});

test('the worst state comes first', () => {
  expect(stateText(1 + 2 + 8 + 16, [])).toBe('✖ hit avoids manual stale');
  expect(stateText(4, [])).toBe('fault');
  expect(stateText(4, ['P', 'C'])).toBe('PC');
});
