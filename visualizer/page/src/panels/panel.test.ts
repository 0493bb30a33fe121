import { expect, test } from 'vitest';
import type { Topic } from '../model/viewer';
import { type Panel, Updates } from './panel';
import { nextTab } from './tabs';

test('a panel is updated on its topics, and not more often than it asks for; the last change is not lost', () => {
  let nowMs = 0;
  const waiting: { atMs: number; callback: () => void }[] = [];
  const updated: number[] = [];
  const panel = { element: null as unknown as HTMLElement, topics: ['time'] as Topic[], everyMs: 100 };
  const panels: Panel[] = [{ ...panel, update: () => void updated.push(nowMs) }];
  const later = (ms: number, callback: () => void): void => void waiting.push({ atMs: nowMs + ms, callback });
  const updates = new Updates(panels, () => nowMs, later);
  for (nowMs = 0; nowMs < 250; nowMs += 10) {
    for (const due of waiting.splice(0)) {
      if (due.atMs <= nowMs) due.callback();
      else waiting.push(due);
    }
    updates.changed(new Set<Topic>(nowMs < 130 ? ['time'] : ['case']));
  }
  expect(updated).toEqual([0, 100, 200]);
});

test('arrow keys go round the tabs', () => {
  expect(nextTab('ArrowRight', 2, 3)).toBe(0);
  expect(nextTab('ArrowLeft', 0, 3)).toBe(2);
  expect([nextTab('Home', 1, 3), nextTab('End', 1, 3), nextTab('a', 1, 3)]).toEqual([0, 2, null]);
});
