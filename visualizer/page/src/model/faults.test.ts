import { expect, it } from 'vitest';
import { activeAt, faultLetter, faultText } from './faults';

const fault = {
  object: 4,
  probe: 'PxId4',
  type: 'offset',
  params: '{"value":1.5,"why":"wind","list":[1]}',
  fromUs: 10,
  toUs: 20,
  active: false,
  hits: 0,
};

it("letters of the simulator's probes", () => {
  const letter = (probe: string, type = 'offset') => faultLetter({ probe, type });
  expect(letter('PxId4')).toBe('P');
  expect(letter('PyId12')).toBe('P');
  expect(letter('RollId1')).toBe('A');
  expect(letter('PitchId1')).toBe('A');
  expect(letter('YawId1')).toBe('Y');
  expect(letter('RangeId3Anch7')).toBe('R');
  expect(letter('AnchXId3Anch7')).toBe('N');
  expect(letter('ITS_DATA3')).toBe('C');
  expect(letter('ClockId3')).toBe('T');
  expect(letter('WheelSlip')).toBe('W');
  expect(letter('RollId1', 'amplification')).toBe('G');
  expect(letter('something')).toBe('F');
});

it('is active from its begin until just before its end, if it has one', () => {
  expect([9, 10, 19, 20].map((t) => activeAt(fault, t))).toEqual([false, true, true, false]);
  expect(activeAt({ ...fault, toUs: -1 }, 1e12)).toBe(true);
});

it('its text has numbers and words of the parameters, and survives bad ones', () => {
  expect(faultText(fault)).toBe('PxId4 offset 1.5 wind');
  expect(faultText({ ...fault, params: '{oops' })).toBe('PxId4 offset');
  expect(faultText({ ...fault, params: 'null' })).toBe('PxId4 offset');
});
