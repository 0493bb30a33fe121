import { describe, expect, test } from 'vitest';
import { fieldsOf, findModel, injection, modelsOf, probeUnit, type Timing } from './fault_catalogue';

const always: Timing = { unit: 's', from: '0', length: '' };

function made(where: 'probe' | 'channel', name: string, values: Record<string, string>, timing = always) {
  const model = findModel(where, name);
  if (model === null) throw new Error(`no model ${name}`);
  const fields = fieldsOf(model, 'm', values.apply);
  const answer = injection('PxId4', model, fields, new Map(Object.entries(values)), timing);
  return answer.ok ? JSON.parse(answer.text) : answer.error;
}

describe('the form', () => {
  // Counted in docs/faults.md.
  test('knows every model of the catalogue', () => {
    expect(modelsOf('probe')).toHaveLength(21);
    expect(modelsOf('channel')).toHaveLength(17);
    for (const where of ['probe', 'channel'] as const) {
      for (const model of modelsOf(where)) expect(() => fieldsOf(model, 'm'), model.name).not.toThrow();
    }
  });

  test('begins with values that are right, where a value can be guessed', () => {
    const asked = ['insert', 'masquerade', 'misroute', 'asymmetric', 'subset'];
    for (const where of ['probe', 'channel'] as const) {
      for (const { name } of modelsOf(where).filter((m) => !asked.includes(m.name))) {
        expect(made(where, name, {}), name).toMatchObject({ probe: 'PxId4', model: name });
      }
    }
    for (const name of asked) expect(made('channel', name, {}), name).toMatch(/expected .*, got ""/);
  });

  test('sends parameters by the names of fc_named.h', () => {
    expect(made('probe', 'offset', { constant: '1.5' })).toEqual({
      probe: 'PxId4',
      model: 'offset',
      params: { constant: 1.5 },
      from_s: 0,
    });
    expect(made('probe', 'delay', { calls: '12' })).toMatchObject({ params: { calls: 12 } });
    expect(made('probe', 'drift_timed', { rate: '0.1', limit: '5' })).toMatchObject({
      params: { rate: 0.1, limit: 5 },
    });
    expect(made('probe', 'drift_timed', { rate: '0.1' }).params).toEqual({ rate: 0.1 });
    expect(made('probe', 'stuck_bit', { bit: '3', value: '1' })).toMatchObject({
      params: { bit: 3, value: 1 },
    });
    expect(made('probe', 'dropout', { probability: '0.5', mode: 'nan' }).params).toEqual({
      probability: 0.5,
      mode: 'nan',
    });
    expect(made('channel', 'insert', { packet: '00ff', times: '2' }).params).toEqual({
      packet: '00ff',
      times: 2,
    });
    expect(made('channel', 'subset', { receivers: 'a, b' }).params).toEqual({ receivers: 'a, b' });
  });

  test('a model inside a model brings its own parameters', () => {
    const { params } = made('channel', 'field', {
      type: 'i16',
      byte: '2',
      big_endian: '1',
      apply: 'drift',
      rate: '1',
    });
    expect(params).toEqual({ type: 'i16', byte: 2, big_endian: 1, apply: 'drift', rate: 1 });
  });

  test('infinities and nan are sent as texts, since JSON has none', () => {
    expect(made('probe', 'set_to', { value: 'nan' })).toMatchObject({ params: { value: 'nan' } });
    expect(made('probe', 'set_to', { value: '-inf' })).toMatchObject({ params: { value: '-inf' } });
  });

  test.each([
    ['offset', { constant: 'much' }, 'constant: expected a number, inf, -inf or nan, got "much"'],
    ['offset', { constant: '' }, 'constant: expected a number, inf, -inf or nan, got ""'],
    ['noise_gauss', { deviation: 'nan' }, 'deviation: expected a number, inf or -inf, got "nan"'],
    ['quantise', { step: '0' }, 'step: expected a number above 0, got "0"'],
    ['dropout', { probability: '1.1' }, 'probability: expected a number from 0 to 1, got "1.1"'],
    [
      'delay',
      { calls: '9007199254740993000' },
      'calls: expected a whole number from 1 to 9007199254740992, got "9007199254740993000"',
    ],
    ['delay', { calls: '1.5' }, 'calls: expected a whole number from 1 up, got "1.5"'],
  ])('tells what is wrong with %s %j', (name, values, line) => {
    expect(made('probe', name, values)).toBe(line);
  });

  test('start and duration count in seconds or in probe calls', () => {
    expect(made('probe', 'stuck', {}, { unit: 's', from: '0.5', length: '2' })).toMatchObject({
      from_s: 0.5,
      for_s: 2,
    });
    const calls = made('probe', 'stuck', {}, { unit: 'calls', from: '10', length: '1' });
    expect(calls).toEqual({ probe: 'PxId4', model: 'stuck', params: {}, from_calls: 10, for_calls: 1 });
    expect(made('probe', 'stuck', {}, { unit: 'calls', from: '0.5', length: '' })).toMatch(
      /^start: expected a whole/,
    );
    expect(made('probe', 'stuck', {}, { unit: 's', from: '0', length: '0' })).toMatch(
      /^duration: expected seconds/,
    );
    expect(made('probe', 'stuck', {}, { unit: 's', from: '-1', length: '' })).toMatch(
      /^start: expected seconds/,
    );
  });
});

test('probes tell their unit', () => {
  expect(['PxId4', 'RangeId2Anch1', 'AnchZId0Anch3', 'RollId1', 'speed'].map(probeUnit)).toEqual([
    'm',
    'm',
    'm',
    '°',
    '',
  ]);
});
