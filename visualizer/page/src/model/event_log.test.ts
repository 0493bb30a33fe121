import { describe, expect, it } from 'vitest';
import { commandAt, EventLog, failingCommand, failureUs } from './event_log';
import { aCase, anEvent } from './testing';

describe('EventLog', () => {
  it('keeps order and drops repeats', () => {
    const log = new EventLog();
    expect(log.add(anEvent({ seq: 1, tUs: 10 }))).toBe(true);
    expect(log.add(anEvent({ seq: 3, tUs: 30 }))).toBe(true);
    expect(log.add(anEvent({ seq: 2, tUs: 10 }))).toBe(true);
    expect(log.add(anEvent({ seq: 3, tUs: 30 }))).toBe(false);
    expect(log.events.map((event) => event.seq)).toEqual([1, 2, 3]);
  });

  it('finds the neighbours of a moment', () => {
    const log = new EventLog();
    for (const [seq, tUs] of [
      [1, 10],
      [2, 20],
      [3, 20],
    ] as const)
      log.add(anEvent({ seq, tUs }));
    expect(log.neighbour(10, 1)).toBe(20);
    expect(log.neighbour(20, -1)).toBe(10);
    expect(log.neighbour(20, 1)).toBeNull();
  });

  it('tells a collision with terrain from one of two objects', () => {
    const log = new EventLog();
    log.add(anEvent({ seq: 1, tUs: 20, kind: 'collision', a: 1, b: 0, text: 'copter 1 and terrain 0' }));
    log.add(anEvent({ seq: 2, tUs: 10, kind: 'collision', a: 1, b: 2, text: 'copter 1 and copter 2' }));
    expect(log.collisions.map(({ tUs, terrain }) => [tUs, terrain])).toEqual([
      [10, false],
      [20, true],
    ]);
  });
});

describe('commands', () => {
  const info = aCase([0, 0, 2_000_000, 5_000_000]);

  it('of several at one time the last is the current one', () => {
    expect([-1, 0, 1_999_999, 2_000_000, 9e9].map((t) => commandAt(info, t))).toEqual([-1, 1, 1, 2, 3]);
    expect(commandAt(null, 5)).toBe(-1);
  });

  it('the failing one is that which ran when the verdict failed', () => {
    const verdict = anEvent({ kind: 'verdict', tUs: 3_000_000, text: 'failed: no_collision' });
    expect(failingCommand(info, [verdict], [])).toBe(2);
    expect(failingCommand(info, [anEvent({ kind: 'verdict', tUs: 3_000_000, text: 'passed' })], [])).toBe(-1);
  });

  it('a failure when a command begins belongs to the one before', () => {
    const verdict = anEvent({ kind: 'verdict', tUs: 5_000_000, text: 'failed' });
    expect(failingCommand(info, [verdict], [])).toBe(2);
  });

  it('a collision counts before a verdict that comes later', () => {
    const verdict = anEvent({ kind: 'verdict', tUs: 8_000_000, text: 'failed: no_collision' });
    const collision = { tUs: 3_000_000, a: 1, b: 2, terrain: false, x: 0, y: 0 };
    expect(failureUs([verdict], [collision])).toBe(3_000_000);
    expect(failureUs([], [])).toBeNull();
  });

  it('without a verdict the first collision counts', () => {
    const collision = { tUs: 6_000_000, a: 1, b: 2, terrain: false, x: 0, y: 0 };
    expect(failureUs([], [collision])).toBe(6_000_000);
    expect(failingCommand(info, [], [collision])).toBe(3);
  });
});
