// The fault models of libfaultcheck as fields of a form, and the filled form as the text of `inject'.
// Models and parameters come from generated/fault_models.json; parameters are sent by the names of
// fc_named.h (docs/faults.md, "By name").

import catalogue from './generated/fault_models.json';

export interface FaultModel {
  name: string;
  class: string; // probe, sensor, communication
  stage: string; // probe, put, get
  parameters: { name: string; kind: string }[];
  meaning: string;
  standard: string;
}

export interface Field {
  name: string; // as sent
  label: string;
  hint: string; // unit or range
  kind: 'number' | 'whole' | 'text' | 'choice';
  optional: boolean;
  choices: readonly string[];
  initial: string;
  check: (text: string) => string; // '' when right, else what would be right
}

export const faultModels: readonly FaultModel[] = catalogue.models;

// A probe takes models of probes, a channel those of communication.
export function modelsOf(where: 'probe' | 'channel'): readonly FaultModel[] {
  return faultModels.filter((model) => (model.class === 'communication') === (where === 'channel'));
}

export function findModel(where: 'probe' | 'channel', name: string): FaultModel | null {
  return modelsOf(where).find((model) => model.name === name) ?? null;
}

// `unit' is that of the probe, '' when unknown; `applied' is the model chosen in the field `apply'.
export function fieldsOf(model: FaultModel, unit: string, applied = ''): readonly Field[] {
  const most = mostNatural[model.name] ?? MOST_WHOLE;
  return model.parameters.flatMap(({ name, kind }) => fieldsOfParameter(name, kind, unit, applied, most));
}

// Beyond, libfaultcheck takes no number for a whole one.
const MOST_WHOLE = 2 ** 53;

// What player (copter_hand.erl) and libfaultcheck take at most.
const mostNatural: Readonly<Record<string, number>> = {
  corruption: 2 ** 31 - 1,
  extend: 65536,
  repeat: 10000,
};

const whole = (name: string, low: number, high: number, initial: string, hint = ''): Field => ({
  ...plain(name, 'whole', initial, hint === '' && high < MOST_WHOLE ? `${low} to ${high}` : hint),
  check: (text) =>
    /^\d+$/.test(text) && Number(text) >= low && Number(text) <= high
      ? ''
      : `a whole number from ${low}${Number(text) > high || high < MOST_WHOLE ? ` to ${high}` : ' up'}`,
});

const number = (
  name: string,
  initial: string,
  hint: string,
  right: (n: number) => boolean,
  what: string,
): Field => ({
  ...plain(name, 'number', initial, hint),
  check: (text) => (right(numberOf(text)) ? '' : what),
});

const text = (name: string, hint: string, pattern: RegExp): Field => ({
  ...plain(name, 'text', '', hint),
  check: (given) => (pattern.test(given) ? '' : hint),
});

const choice = (name: string, choices: readonly string[]): Field => ({
  ...plain(name, 'choice', choices[0] ?? '', ''),
  choices,
  check: (given) => (choices.includes(given) ? '' : `one of ${choices.join(', ')}`),
});

const optional = (field: Field, hint: string): Field => ({
  ...field,
  optional: true,
  initial: '',
  hint,
  check: (given) => (given === '' ? '' : field.check(given)),
});

function plain(name: string, kind: Field['kind'], initial: string, hint: string): Field {
  const label = name.replaceAll('_', ' ');
  return { name, label, hint, kind, optional: false, choices: [], initial, check: () => '' };
}

const notNan = (n: number): boolean => !Number.isNaN(n);
const probeModels = faultModels.filter((model) => model.class !== 'communication').map((model) => model.name);
const fieldTypes = ['f32', 'f64', 'i8', 'i16', 'i32', 'i64', 'u8', 'u16', 'u32', 'u64', 'bool', 'bytes'];

function fieldsOfParameter(
  parameter: string,
  kind: string,
  unit: string,
  applied: string,
  most: number,
): readonly Field[] {
  const name = parameter.toLowerCase();
  switch (kind) {
    case 'bit':
      return [whole(name, 0, 1023, '0', '0: the least significant')];
    case 'bit_of_byte':
      return [whole(name, 0, 7, '0')];
    case 'bit_value':
      return [choice(name, ['0', '1'])];
    case 'byte':
      return [whole(name, 0, 255, '0')];
    case 'natural':
      return [whole(name, 0, most, name === 'packets' ? '1' : '0')];
    case 'count':
      return [whole(name, 1, MOST_WHOLE, name === 'ns' ? '100000000' : '10', name === 'ns' ? 'ns' : '')];
    case 'any_real':
      return [{ ...number(name, '1', hintOf(name, unit), () => true, ''), check: anyReal }];
    case 'real':
      return [number(name, '0.1', hintOf(name, unit), notNan, 'a number, inf or -inf')];
    case 'positive':
      return [number(name, '0.1', unit, (n) => n > 0, 'a number above 0')];
    case 'probability':
      return [number(name, '0.1', '0 to 1', (n) => n >= 0 && n <= 1, 'a number from 0 to 1')];
    case 'limit':
      return [
        optional(
          number(name, '', unit, (n) => n >= 0, 'a number from 0 up, or nothing'),
          unit || 'none',
        ),
      ];
    case 'dropout_mode':
      return [choice(name, ['hold', 'zero', 'nan'])];
    case 'name':
      return [text(name, 'name of a channel', /^\S+$/)];
    case 'data':
      return [text(name, 'bytes in hexadecimal', /^([0-9a-fA-F]{2})+$/)];
    case 'receivers':
      return [text(name, 'names between commas', /^[^,\s]+(\s*,\s*[^,\s]+)*$/)];
    case 'delay':
      return [whole('calls', 1, MOST_WHOLE, '10', 'probe calls')];
    case 'channel_delay':
      return [whole('ns', 0, MOST_WHOLE, '200000000', 'ns')];
    case 'field':
    case 'part':
      return partFields(kind === 'part');
    case 'model':
      return appliedFields(unit, applied);
    default:
      throw new Error(`generated/fault_models.json: unknown kind of parameter: ${kind}`);
  }
}

// Without a type, `part' is the whole packet.
function partFields(mayBeWhole: boolean): readonly Field[] {
  const type = choice('type', mayBeWhole ? ['', ...fieldTypes] : fieldTypes);
  return [
    { ...type, optional: mayBeWhole, hint: mayBeWhole ? 'none: the whole packet' : '' },
    { ...whole('byte', 0, MOST_WHOLE, '0'), hint: 'where it begins' },
    { ...choice('big_endian', ['0', '1']), hint: '1: yes' },
    optional(whole('length', 0, MOST_WHOLE, ''), 'of bytes; all'),
  ];
}

function appliedFields(unit: string, applied: string): readonly Field[] {
  const inner = findModel('probe', applied === '' ? (probeModels[0] ?? '') : applied);
  return [choice('apply', probeModels), ...(inner === null ? [] : fieldsOf(inner, unit))];
}

const dimensionless = new Set(['factor']);

function hintOf(name: string, unit: string): string {
  if (dimensionless.has(name)) return '×';
  return unit !== '' && name === 'rate' ? `${unit} each` : unit;
}

function anyReal(given: string): string {
  return Number.isNaN(numberOf(given)) && given !== 'nan' ? 'a number, inf, -inf or nan' : '';
}

// What is written as a number; NaN for what is not.
function numberOf(given: string): number {
  if (given === 'inf') return Infinity;
  if (given === '-inf') return -Infinity;
  return /^[+-]?(\d+\.?\d*|\.\d+)(e[+-]?\d+)?$/i.test(given) ? Number(given) : Number.NaN;
}

// ---- what is sent

export interface Timing {
  unit: 's' | 'calls';
  from: string;
  length: string; // '' without end
}

export type Injection = { ok: true; text: string } | { ok: false; error: string };

export function injection(
  probe: string,
  model: FaultModel,
  fields: readonly Field[],
  values: ReadonlyMap<string, string>,
  timing: Timing,
): Injection {
  if (probe === '') return { ok: false, error: 'probe: choose one' };
  const params: Record<string, number | string> = {};
  for (const field of fields) {
    const value = (values.get(field.name) ?? field.initial).trim();
    const wrong = value === '' && !field.optional ? field.check(value) || 'a value' : field.check(value);
    if (wrong !== '') return { ok: false, error: `${field.label}: expected ${wrong}, got "${value}"` };
    if (value !== '') params[field.name] = paramOf(field, value);
  }
  const when = timingOf(timing);
  if (typeof when === 'string') return { ok: false, error: when };
  return { ok: true, text: JSON.stringify({ probe, model: model.name, params, ...when }) };
}

// JSON has no infinities: they are sent as texts. A choice of 0 or 1 is a number.
function paramOf(field: Field, value: string): number | string {
  if (field.kind === 'text') return value;
  const n = numberOf(value);
  return Number.isFinite(n) ? n : value;
}

function timingOf({ unit, from, length }: Timing): Record<string, number> | string {
  const calls = unit === 'calls';
  const right = calls ? /^\d+$/ : /^\d+(\.\d*)?$|^\.\d+$/;
  const expected = calls ? 'a whole number of calls' : 'seconds';
  if (!right.test(from)) return `start: expected ${expected}, got "${from}"`;
  const when = { [calls ? 'from_calls' : 'from_s']: Number(from) };
  if (length === '') return when;
  if (!right.test(length) || Number(length) <= 0)
    return `duration: expected ${expected} above 0, got "${length}"`;
  return { ...when, [calls ? 'for_calls' : 'for_s']: Number(length) };
}

// Units of the simulator's probes by the beginning of their names (docs/coptersim.md, section 11).
const probeUnits: readonly (readonly [RegExp, string])[] = [
  [/^(Range|P[xy]|Anch[XYZ])Id/, 'm'],
  [/^(Roll|Pitch|Yaw)Id/, '°'],
];

export function probeUnit(probe: string): string {
  return probeUnits.find(([pattern]) => pattern.test(probe))?.[1] ?? '';
}
