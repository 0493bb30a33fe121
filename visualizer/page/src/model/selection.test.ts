import { describe, expect, it } from 'vitest';
import { PendingControl } from './pending_control';
import { MAX_PINNED, Selection } from './selection';

describe('a selection', () => {
  it('goes round the objects in both directions', () => {
    const selection = new Selection();
    const ids = Int32Array.of(2, 5, 9);
    expect([selection.neighbour(ids, 1), selection.neighbour(ids, -1)]).toEqual([2, 9]);
    selection.observe(9);
    expect([selection.neighbour(ids, 1), selection.neighbour(ids, -1)]).toEqual([2, 5]);
    expect(selection.neighbour(new Int32Array(), 1)).toBe(-1);
  });

  it('pins up to six, which stay when another is observed', () => {
    const selection = new Selection();
    selection.observe(2);
    for (let id = 2; id < 2 + MAX_PINNED; id++) expect(selection.pin(id, true)).toBe(true);
    expect(selection.pin(50, true)).toBe(false);
    expect(selection.pin(3, false)).toBe(true);
    expect(selection.pinned).toEqual([2, 4, 5, 6, 7]);
    selection.observe(4);
    expect(selection.pinned).toEqual([2, 4, 5, 6, 7]);
    expect(selection.pin(4, true)).toBe(false);
  });

  it('follows nobody once there is no observer', () => {
    const selection = new Selection();
    selection.observe(1);
    selection.followed = true;
    expect(selection.observe(1)).toBe(false);
    expect(selection.observe(-1)).toBe(true);
    expect(selection.followed).toBe(false);
  });
});

describe('controls that wait for an answer', () => {
  it('have numbers of their own, which begin anew at the end of 32 bits', () => {
    const pending = new PendingControl(0x7fffffff);
    expect([pending.begin(0).seq, pending.begin(0).seq]).toEqual([0x7fffffff, 1]);
  });

  it('are answered once, or given up after a second', async () => {
    const pending = new PendingControl(1);
    const first = pending.begin(0);
    const second = pending.begin(500);
    pending.answered({ client: 'a', seq: first.seq, ok: true, text: 'done' });
    pending.expire(1400);
    expect(pending.empty).toBe(false);
    pending.expire(1500);
    expect(pending.empty).toBe(true);
    expect((await first.answer).text).toBe('done');
    expect((await second.answer).ok).toBe(false);
  });
});
