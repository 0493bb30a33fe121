import { describe, expect, it } from 'vitest';
import type { Status } from '../../../codec/messages';
import { createViewer } from '../model/create_viewer';
import { aStatus, testWorld } from '../model/testing';
import { beginAgain } from './begin_again';

const S = 1e6;

// What a page asks for that comes when the player says this.
async function asked(...statuses: Partial<Status>[]): Promise<string[]> {
  const world = testWorld();
  const viewer = createViewer(world);
  beginAgain(viewer);
  viewer.connect('ws://x');
  world.listener?.connection({ connected: true });
  world.listener?.granted(true);
  for (const change of statuses) {
    world.listener?.message({ channel: 'VIZ_STATUS', value: aStatus({ durationUs: 8 * S, ...change }) });
    world.pass(20);
  }
  for (let answered = 0; answered < world.sent.length; answered++) {
    const seq = world.sent[answered]?.seq ?? -1;
    world.listener?.message({ channel: 'VIZ_ACK', value: { client: 'a', seq, ok: true, text: '' } });
    for (let i = 0; i < 5; i++) await Promise.resolve();
  }
  return world.sent.map(({ verb }) => verb);
}

describe('a page that comes to a replay', () => {
  it('begins it again when it has ended, by its verdict or its time', async () => {
    expect(await asked({ paused: true, verdict: 2, tUs: 3 * S })).toEqual(['restart', 'play']);
    expect(await asked({ paused: true, tUs: 8 * S })).toEqual(['restart', 'play']);
  });

  it('leaves it alone while it plays, or where somebody paused it', async () => {
    expect(await asked({ tUs: 3 * S })).toEqual([]);
    expect(await asked({ paused: true, tUs: 3 * S })).toEqual([]);
  });

  it('leaves a live flight alone that is over', async () => {
    expect(await asked({ mode: 1, paused: true, verdict: 2, durationUs: -1 })).toEqual([]);
  });

  it('does so at the first status only', async () => {
    expect(await asked({ tUs: 3 * S }, { paused: true, verdict: 2, tUs: 8 * S })).toEqual([]);
  });
});
