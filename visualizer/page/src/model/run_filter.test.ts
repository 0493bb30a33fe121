import { expect, it } from 'vitest';
import { RunFilter } from './run_filter';

it('follows rising runs and drops what is left of older ones', () => {
  const filter = new RunFilter();
  expect(filter.judge(4, false)).toBe('new');
  expect(filter.judge(4, false)).toBe('same');
  expect(filter.judge(5, false)).toBe('new');
  expect(filter.judge(4, false)).toBe('drop');
  expect(filter.current).toBe(5);
});

it('believes a lower run only when the status keeps saying it', () => {
  const filter = new RunFilter();
  filter.judge(9, false);
  expect([filter.judge(1, true), filter.judge(1, false), filter.judge(1, true)]).toEqual([
    'drop',
    'drop',
    'drop',
  ]);
  expect(filter.judge(1, true)).toBe('new');
  expect(filter.judge(1, false)).toBe('same');
});

it('does not believe late statuses of an older run while the new one goes on', () => {
  const filter = new RunFilter();
  filter.judge(9, false);
  for (let i = 0; i < 9; i++) {
    expect(filter.judge(8, true)).toBe('drop');
    expect(filter.judge(9, false)).toBe('same');
  }
});
