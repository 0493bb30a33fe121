// What the page says about injected faults: their letter, a short text, whether one is active.

import type { Fault } from '../../../codec/messages';

export type FaultLetter = 'P' | 'A' | 'G' | 'R' | 'N' | 'C' | 'T' | 'Y' | 'W' | 'F';

// Names of probes by kind of quantity; the first that fits counts. F: any other.
const LETTERS: readonly [FaultLetter, RegExp][] = [
  ['W', /slip|wheel/i],
  ['R', /rang|dist|uwb|flow/i],
  ['N', /anch/i],
  ['C', /its_data|comm|packet|radio|message|channel/i],
  ['T', /time|clock|stamp/i],
  ['G', /gain|^k[pid]?\b|pid/i],
  ['Y', /yaw|psi|heading/i],
  ['A', /angle|roll|pitch|phi|theta|gyro|rate|attitude/i],
  ['P', /pos|^p[xyz]|acc|vel|gps/i],
];

// The letter that stands for a fault on the map, the timeline and in lists: by what it alters, and G
// for a wrong gain of that.
export function faultLetter(fault: Pick<Fault, 'probe' | 'type'>): FaultLetter {
  if (/amplification|gain/i.test(fault.type)) return 'G';
  const { probe } = fault;
  return LETTERS.find(([, pattern]) => pattern.test(probe))?.[0] ?? 'F';
}

// Whether a fault is active at a time; the message's own flag tells only of the moment it was sent.
export function activeAt(fault: Fault, tUs: number): boolean {
  return fault.fromUs <= tUs && (fault.toUs < 0 || tUs < fault.toUs);
}

// 'PxId4 offset 1.5', without what is not a number or a word in the parameters.
export function faultText(fault: Fault): string {
  const values = paramTexts(fault.params);
  return [fault.probe, fault.type, ...values].join(' ');
}

function paramTexts(params: string): string[] {
  let parsed: unknown;
  try {
    parsed = JSON.parse(params);
  } catch {
    return [];
  }
  if (typeof parsed !== 'object' || parsed === null) return [];
  const values: string[] = [];
  for (const value of Object.values(parsed)) {
    if (typeof value === 'number') values.push(String(Number(value.toPrecision(4))));
    else if (typeof value === 'string') values.push(value);
  }
  return values;
}
