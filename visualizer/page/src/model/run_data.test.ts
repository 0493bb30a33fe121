import { describe, expect, it } from 'vitest';
import type { Message, World } from '../../../codec/messages';
import { RunData } from './run_data';
import { aCase, aFrame, anEvent, aRisk, aStatus } from './testing';
import type { Topic } from './viewer';

const S = 1e6;
const world = (run: number, version: number): Message => {
  const value: World = { run, version, seg: [[0, 0, 1, 1]], anchors: [], polys: [] };
  return { channel: 'VIZ_WORLD', value };
};
const ranges = (object: number, tUs: number): Message => {
  const item = { anchor: 1, measured: 2, expected: 1, used: true };
  return { channel: 'VIZ_RANGE', value: { tUs, run: 1, object, items: [item] } };
};
const fault = {
  object: 1,
  probe: 'PxId1',
  type: 'offset',
  params: '{}',
  fromUs: 0,
  toUs: -1,
  active: true,
  hits: 0,
};

function take(data: RunData, ...messages: readonly Message[]): Topic[] {
  const changed = new Set<Topic>();
  for (const message of messages) data.take(message, changed);
  return [...changed].sort();
}

describe('contours and ranges', () => {
  it('are those of one observer at or shortly before a moment', () => {
    const data = new RunData();
    take(data, { channel: 'VIZ_RISK', value: aRisk(2, S) }, { channel: 'VIZ_RISK', value: aRisk(3, S) });
    expect(data.observers).toEqual([2, 3]);
    expect(data.riskAt(3, 1.2 * S)?.observer).toBe(3);
    expect(data.riskAt(3, 1.3 * S)).toBeNull();
    expect(data.riskAt(3, 0.9 * S)).toBeNull();
    expect(data.riskAt(4, S)).toBeNull();
    take(data, ranges(2, S));
    expect(data.rangesAt(2, 1.4 * S)?.items).toHaveLength(1);
    expect(data.rangesAt(2, 1.6 * S)).toBeNull();
    expect(data.rangesAt(3, S)).toBeNull();
  });
});

describe('repeats', () => {
  it('of what is known change nothing', () => {
    const data = new RunData();
    const info: Message = { channel: 'VIZ_CASE', value: aCase([0, S]) };
    expect(take(data, world(1, 1), info)).toContain('world');
    expect(take(data, world(1, 1), info)).toEqual([]);
    expect(take(data, world(1, 2))).toEqual(['world']);
    expect(take(data, { channel: 'VIZ_CASE', value: aCase([0, 2 * S]) })).toEqual(['case']);
    const event: Message = { channel: 'VIZ_EVENT', value: anEvent({ seq: 4 }) };
    expect(take(data, event)).toEqual(['events']);
    expect(take(data, event)).toEqual([]);
  });
});

describe('a new run', () => {
  it('forgets what was of the old one, and keeps world and case until theirs come', () => {
    const data = new RunData();
    const verdict = anEvent({ kind: 'verdict', text: 'failed', tUs: 1.5 * S });
    take(data, world(1, 1), { channel: 'VIZ_CASE', value: aCase([0, S]) }, aFrame(S));
    take(data, { channel: 'VIZ_EVENT', value: verdict }, { channel: 'VIZ_RISK', value: aRisk(1, S) });
    take(data, { channel: 'VIZ_FAULTS', value: { tUs: S, run: 1, items: [fault] } });
    expect(data.failing).toBe(1);
    expect(take(data, aFrame(0, [], 2))).toEqual(['buffer', 'case', 'events', 'faults']);
    expect([data.run, data.runs, data.frames.length, data.failing]).toEqual([2, 2, 1, -1]);
    expect([data.faults, data.log.events.length, data.riskAt(1, S)]).toEqual([null, 0, null]);
    expect([data.world?.version, data.caseInfo?.caseId]).toEqual([1, 'c']);
  });
});

it('what is held stands in order, what describes the run first', () => {
  const data = new RunData();
  take(data, aFrame(2 * S), aFrame(S), world(1, 1), ranges(1, 1.5 * S));
  take(data, { channel: 'VIZ_STATUS', value: aStatus({ tUs: 3 * S }) });
  expect(data.held().map((message) => message.channel)).toEqual([
    'VIZ_WORLD',
    'VIZ_FRAME',
    'VIZ_RANGE',
    'VIZ_FRAME',
    'VIZ_STATUS',
  ]);
  expect(data.framesBetween(S, 1.5 * S).map((frame) => frame.tUs)).toEqual([S]);
});
