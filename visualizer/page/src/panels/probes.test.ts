import { expect, test } from 'vitest';
import { anObject } from '../model/testing';
import { readParams } from './case_params';
import { isPosition, places } from './probes';

const world = { run: 1, version: 1, seg: [], anchors: [{ id: 3, pos: [0, 0, 1] as const }], polys: [] };

test('what the case tells is listed in its order', () => {
  const params = readParams('{"probes":["speed","PxId4"],"channels":["ITS_DATA4"]}');
  expect(places(params, [anObject(4)], world)).toEqual([
    { name: 'speed', where: 'probe', object: -1 },
    { name: 'PxId4', where: 'probe', object: 4 },
    { name: 'ITS_DATA4', where: 'channel', object: 4 },
  ]);
});

// Names from docs/copter_scenarios.md.
test('without being told, a quadcopter has its probes, those of each anchor, and its channel', () => {
  expect(
    places(readParams('{}'), [anObject(0), anObject(1, { kind: 1 })], world).map(({ name }) => name),
  ).toEqual([
    'PxId0',
    'PyId0',
    'RollId0',
    'PitchId0',
    'YawId0',
    'ClockId0',
    'RangeId0Anch3',
    'AnchXId0Anch3',
    'AnchYId0Anch3',
    'AnchZId0Anch3',
    'ITS_DATA0',
  ]);
});

test.each(['', '[]', '{"probes":7,"settings":{"a":"b"}}', '{"probes":[1]}'])(
  'parameters %j tell nothing',
  (text) => {
    const params = readParams(text);
    expect([params.probes, [...params.settings]]).toEqual([[], []]);
  },
);

test('the probes of a position are told from those of its anchors and other values', () => {
  expect(['PxId1', 'PyId12'].every(isPosition)).toBe(true);
  expect(['YawId1', 'AnchXId1Anch2', 'RangeId1Anch2', 'PxId', 'speed'].some(isPosition)).toBe(false);
});
