// What VIZ_CASE tells beside the commands (docs/visualizer.md); each part may be missing.

import type { CaseInfo } from '../../../codec/messages';

export interface CaseParams {
  readonly summary: string;
  readonly probes: readonly string[];
  readonly channels: readonly string[];
  readonly settings: ReadonlyMap<string, number>;
  readonly scenarios: readonly string[];
  readonly shrinkSteps: number | null;
  readonly recorded: string;
}

const cache = new WeakMap<CaseInfo, CaseParams>();

export function caseParams(info: CaseInfo | null): CaseParams {
  if (info === null) return readParams('{}');
  let params = cache.get(info);
  if (params === undefined) {
    params = readParams(info.params);
    cache.set(info, params);
  }
  return params;
}

export function readParams(text: string): CaseParams {
  const given = objectOf(text);
  const steps = given.get('shrink_steps');
  return {
    summary: word(given.get('summary')),
    probes: words(given.get('probes')),
    channels: words(given.get('channels')),
    settings: numbers(given.get('settings')),
    scenarios: words(given.get('scenarios')),
    shrinkSteps: typeof steps === 'number' ? steps : null,
    recorded: word(given.get('recorded')),
  };
}

function objectOf(text: string): ReadonlyMap<string, unknown> {
  try {
    return entries(JSON.parse(text));
  } catch {
    return new Map();
  }
}

function entries(value: unknown): ReadonlyMap<string, unknown> {
  const isObject = typeof value === 'object' && value !== null && !Array.isArray(value);
  return isObject ? new Map(Object.entries(value)) : new Map();
}

function word(value: unknown): string {
  return typeof value === 'string' ? value : '';
}

function words(value: unknown): string[] {
  return Array.isArray(value) ? value.filter((item): item is string => typeof item === 'string') : [];
}

function numbers(value: unknown): Map<string, number> {
  const all = [...entries(value)];
  return new Map(all.filter((entry): entry is [string, number] => typeof entry[1] === 'number'));
}
