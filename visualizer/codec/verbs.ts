// What may be asked of the player: each verb with its arguments and their ranges. Page and bridge both check with
// this, and the player once more.

import type { ControlRequest } from './protocol';

interface Argument {
  name: string;
  min: number;
  max: number;
  whole?: boolean;
}

type TextRule = 'none' | 'case' | 'file' | 'name' | 'json' | 'json or none';

interface Rule {
  args: readonly Argument[];
  object: 'none' | 'one' | 'one or all';
  text: TextRule;
}

const metres = 1e5;
const tilt = Math.PI / 2;

const nothing: Rule = { args: [], object: 'none', text: 'none' };

export const verbs: Readonly<Record<string, Rule>> = {
  play: nothing,
  pause: nothing,
  restart: nothing,
  speed: { ...nothing, args: [{ name: 'factor', min: 0.05, max: 20 }] },
  step: { ...nothing, args: [{ name: 'frames', min: -100_000, max: 100_000, whole: true }] },
  seek: { ...nothing, args: [{ name: 'seconds', min: 0, max: 1e6 }] },
  // a part to be repeated; one of no length ends that
  loop: {
    ...nothing,
    args: [
      { name: 'from (s)', min: 0, max: 1e6 },
      { name: 'to (s)', min: 0, max: 1e6 },
    ],
  },
  observe: { ...nothing, object: 'one or all' },
  load: { ...nothing, text: 'case', args: [{ name: 'original', min: 0, max: 1, whole: true }] },
  steer: {
    args: [
      { name: 'roll (rad)', min: -tilt, max: tilt },
      { name: 'pitch (rad)', min: -tilt, max: tilt },
      { name: 'yaw rate (rad/s)', min: -10, max: 10 },
    ],
    object: 'one',
    text: 'none',
  },
  set: { args: [{ name: 'value', min: -1e9, max: 1e9 }], object: 'one or all', text: 'name' },
  inject: { args: [], object: 'one or all', text: 'json' },
  clear_faults: { args: [], object: 'one or all', text: 'json or none' },
  add_object: {
    ...nothing,
    args: [
      { name: 'x (m)', min: -metres, max: metres },
      { name: 'y (m)', min: -metres, max: metres },
    ],
  },
  remove_object: { ...nothing, object: 'one' },
  scenario: { ...nothing, text: 'file' },
  fork: nothing,
  stop_all: nothing,
};

export const caseIdPattern = /^[A-Za-z0-9_-]{1,64}$/;

const textRules: Record<TextRule, { fits: (text: string) => boolean; wanted: string }> = {
  none: { fits: (text) => text === '', wanted: 'no text' },
  case: { fits: (text) => caseIdPattern.test(text), wanted: 'a case id: 1 to 64 letters, digits, - and _' },
  file: {
    fits: (text) => /^[A-Za-z0-9_-][A-Za-z0-9_.-]{0,63}$/.test(text),
    wanted: 'a file name without a folder',
  },
  name: {
    fits: (text) => /^[A-Za-z0-9_.-]{1,64}$/.test(text),
    wanted: 'a name: 1 to 64 letters, digits, . - and _',
  },
  json: { fits: isJsonObject, wanted: 'a JSON object' },
  'json or none': { fits: (text) => text === '' || isJsonObject(text), wanted: 'a JSON object or nothing' },
};

function isJsonObject(text: string): boolean {
  try {
    const value: unknown = JSON.parse(text);
    return typeof value === 'object' && value !== null && !Array.isArray(value);
  } catch {
    return false;
  }
}

// One line saying what is wrong with a request, '' when nothing is.
export function checkVerb({ verb, object, args, text }: Omit<ControlRequest, 'seq' | 'token'>): string {
  const rule = Object.hasOwn(verbs, verb) ? verbs[verb] : undefined;
  if (!rule) return `verb: expected one of ${Object.keys(verbs).join(', ')}`;
  if (rule.object === 'one' && object < 0) return `${verb}: expected an object`;
  if (args.length !== rule.args.length)
    return `${verb}: expected ${rule.args.length} arguments, got ${args.length}`;
  for (const [i, argument] of rule.args.entries()) {
    const problem = checkArgument(argument, args[i] ?? Number.NaN);
    if (problem) return `${verb}: ${problem}`;
  }
  const { fits, wanted } = textRules[rule.text];
  return fits(text) ? '' : `${verb}: text: expected ${wanted}`;
}

function checkArgument({ name, min, max, whole }: Argument, value: number): string {
  const kind = whole ? 'a whole number' : 'a number';
  const good = value >= min && value <= max && (!whole || Number.isInteger(value));
  return good ? '' : `${name}: expected ${kind} from ${+min.toFixed(4)} to ${+max.toFixed(4)}, got ${value}`;
}
