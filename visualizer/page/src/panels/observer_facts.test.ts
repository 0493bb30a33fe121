import { expect, test } from 'vitest';
import { anObject, aRisk } from '../model/testing';
import { factsOf, nearest, type ObserverFact } from './observer_facts';

const units = { length: 'm', angle: 'deg' } as const;
const observer = anObject(1, {
  pos: [0, 0, 1],
  posEst: [0.3, 0.4, 1],
  vel: [0, 0.25, 0],
  velEst: [0, 0.05, 0],
  comfort: 0.75,
  flags: 2,
});
const near = anObject(2, { pos: [0, 2, 1] });
const far = anObject(3, { pos: [9, 9, 1] });

test('the inspector tells the numbers of the observer', () => {
  const told = factsOf(observer, [observer, far, near], aRisk(1, 0), units);
  const text = (name: ObserverFact): string | undefined => told.get(name)?.text;
  expect(text('position error')).toBe('0.500 m');
  expect(text('velocity error')).toBe('0.20 m/s');
  expect(text('speed')).toBe('0.25 m/s');
  expect(text('height z')).toBe('1.00 m');
  expect(text('comfort radius')).toBe('0.75 m');
  expect(text('nearest')).toBe('Q2 · 2.00 m');
  expect(told.get('avoidance')).toEqual({ text: 'steering away', bad: true });
  expect(text('last heard')).toBe('Q2 0.3 s ago'); // age 0.25 s in aRisk
});

test('alone, nothing is near; of an unknown neighbour nothing was heard', () => {
  expect(nearest(observer, [observer])).toBeNull();
  expect(factsOf(observer, [observer], null, units).get('nearest')?.text).toBe('–');
  const stranger = anObject(7, { pos: [0, 1, 1] });
  expect(factsOf(observer, [observer, stranger], aRisk(1, 0), units).get('last heard')?.text).toBe(
    'Q7 not known',
  );
});
