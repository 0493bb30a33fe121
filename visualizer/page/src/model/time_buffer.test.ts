import { describe, expect, it } from 'vitest';
import { TimeBuffer } from './time_buffer';

const item = (tUs: number, bytes = 1) => ({ tUs, bytes });
const times = (buffer: TimeBuffer<{ tUs: number; bytes: number }>) =>
  buffer.between(-Infinity, Infinity).map((one) => one.tUs);

describe('TimeBuffer', () => {
  it('finds the last item at or before a time', () => {
    const buffer = new TimeBuffer<{ tUs: number; bytes: number }>(1000);
    for (const t of [10, 20, 30]) buffer.add(item(t));
    expect([5, 10, 19, 20, 99].map((t) => buffer.indexAt(t))).toEqual([-1, 0, 0, 1, 2]);
  });

  it('agrees with a linear search for random times', () => {
    const buffer = new TimeBuffer<{ tUs: number; bytes: number }>(1e6);
    let seed = 12345;
    const random = () => (seed = (seed * 1103515245 + 12345) % 2147483648);
    const added = new Set<number>();
    for (let i = 0; i < 500; i++) {
      const t = random() % 2000;
      added.add(t);
      buffer.add(item(t));
    }
    const sorted = [...added].sort((a, b) => a - b);
    expect(times(buffer)).toEqual(sorted);
    for (let t = -1; t < 2001; t += 7) {
      expect(buffer.indexAt(t)).toBe(sorted.filter((one) => one <= t).length - 1);
    }
  });

  it('puts a late item in its place and replaces one of the same time', () => {
    const buffer = new TimeBuffer<{ tUs: number; bytes: number }>(1000);
    for (const t of [10, 30, 20]) buffer.add(item(t));
    buffer.add(item(20, 5));
    expect(times(buffer)).toEqual([10, 20, 30]);
    expect(buffer.bytes).toBe(1 + 5 + 1);
  });

  it('gives what lies between two times, both included', () => {
    const buffer = new TimeBuffer<{ tUs: number; bytes: number }>(1000);
    for (const t of [10, 20, 30, 40]) buffer.add(item(t));
    expect(buffer.between(20, 30).map((one) => one.tUs)).toEqual([20, 30]);
    expect(buffer.between(21, 29)).toEqual([]);
    expect(buffer.between(0, 10).map((one) => one.tUs)).toEqual([10]);
  });

  it('thins the oldest to ten a second when it is full, and leaves the newest whole', () => {
    const buffer = new TimeBuffer<{ tUs: number; bytes: number }>(500);
    for (let i = 0; i < 600; i++) buffer.add(item(i * 16_667));
    const kept = times(buffer);
    expect(buffer.thinned).toBe(true);
    expect(buffer.bytes).toBeLessThanOrEqual(500);
    expect(buffer.bytes).toBe(kept.length);
    expect(kept[0]).toBe(0);
    expect((kept[1] ?? 0) - 0).toBeGreaterThanOrEqual(83_335);
    expect((kept[2] ?? 0) - (kept[1] ?? 0)).toBeGreaterThanOrEqual(83_335);
    const newest = kept.slice(-200);
    for (let i = 1; i < newest.length; i++) {
      expect((newest[i] ?? 0) - (newest[i - 1] ?? 0)).toBe(16_667);
    }
  });

  it('drops the oldest when even thinning is not enough', () => {
    const buffer = new TimeBuffer<{ tUs: number; bytes: number }>(50);
    for (let i = 0; i < 1000; i++) buffer.add(item(i * 100_000));
    expect(buffer.bytes).toBeLessThanOrEqual(50);
    expect(buffer.last?.tUs).toBe(99_900_000);
    expect(buffer.first?.tUs).toBeGreaterThan(90_000_000);
  });

  it('is empty again after clear', () => {
    const buffer = new TimeBuffer<{ tUs: number; bytes: number }>(2);
    for (let i = 0; i < 9; i++) buffer.add(item(i));
    buffer.clear();
    expect([buffer.length, buffer.bytes, buffer.thinned, buffer.first, buffer.last]).toEqual([
      0,
      0,
      false,
      null,
      null,
    ]);
  });
});
