// What the page says of the state it is in: badge, banners, title and icon of the tab.

import { describe, expect, test } from 'vitest';
import type { Message, Status } from '../codec/messages';
import {
  atEnd,
  expectNoErrors,
  joinPlayer,
  limitMs,
  type Opened,
  openLog,
  openPage,
  type Player,
  startBridge,
  testPage,
} from './harness';
import { caseInfo, events, frame, messagesAt, sceneLog, status, times } from './scene';

async function connected(): Promise<{ opened: Opened; player: Player }> {
  const bridge = await startBridge();
  const player = await joinPlayer(bridge);
  const opened = await openPage(bridge.url);
  await opened.until((s) => s.connection.connected);
  return { opened, player };
}

const says = (tUs: number, change: Partial<Status>): Message => ({
  channel: 'VIZ_STATUS',
  value: status(tUs, change),
});
const shows = (tUs: number): Message => ({ channel: 'VIZ_FRAME', value: frame(tUs, 4) });
// A player that goes on sending, so that what is shown does not get old before the test has looked at it.
function keepShowing(player: Player, tUs: number): void {
  const timer = setInterval(() => void player.publish(shows(tUs)), 200);
  atEnd(() => clearInterval(timer));
}

const badge = ({ page }: Opened): Promise<string | null> => page.locator('.badge').textContent();

describe('the badge', () => {
  test('is LIVE while a live run comes; scrubbing back says how far behind, and a button leads back', async () => {
    const { opened, player } = await connected();
    await player.publish(says(0, { mode: 1, durationUs: -1, verdict: 0 }));
    for (const tUs of times.slice(0, 121)) await player.publish(shows(tUs));
    keepShowing(player, 2_000_000);
    await opened.until((s) => s.badge === 'LIVE' && s.following && s.tUs === 2_000_000);
    await opened.page.keyboard.press('Space');
    await opened.page.keyboard.press('Shift+ArrowLeft');
    await opened.page.getByText('behind live by 1.0 s').waitFor();
    await opened.page.getByRole('button', { name: 'Go live' }).click();
    await opened.until((s) => s.following && s.tUs === 2_000_000);
    expectNoErrors(opened);
  });

  test('is REPLAY for a stored case, with its whole time axis', async () => {
    const { opened, player } = await connected();
    await player.publish(says(0, { mode: 2 }), shows(0));
    keepShowing(player, 0);
    await opened.until((s) => s.badge === 'REPLAY');
    expect(await opened.state((s) => s.durationUs)).toBe(4_000_000);
    expect(await opened.page.getByRole('button', { name: 'Inject' }).isDisabled()).toBe(true);
  });

  test('is STALE with an age when frames stay out for a second, and recovers', async () => {
    const { opened, player } = await connected();
    await player.publish(says(0, { mode: 1, verdict: 0 }), shows(0));
    await opened.until((s) => s.badge === 'STALE');
    await expect.poll(() => badge(opened), { timeout: limitMs }).toMatch(/^STALE \d/);
    keepShowing(player, times[1] ?? 0);
    await opened.until((s) => s.badge === 'LIVE');
  });

  test('is not STALE while the player is paused', async () => {
    const { opened, player } = await connected();
    await player.publish(says(0, { mode: 2, paused: true }), shows(0));
    await opened.until((s) => s.badge === 'REPLAY' && s.badgeAgeS > 1.2);
  });
});

describe('a failure', () => {
  test('has a banner with names and time, and changes title and icon of the tab', async () => {
    const before = await openPage(`file://${testPage}`);
    const icon = await before.page.locator('#icon').getAttribute('href');
    const opened = await openLog(sceneLog());
    await opened.page.getByRole('alert').getByText('Collision · Quad 1 ↔ Quad 2 · t = 3.00 s').waitFor();
    expect(await opened.page.title()).toMatch(/^✖ Collision/);
    expect(await opened.page.locator('#icon').getAttribute('href')).not.toBe(icon);
    expect(await opened.state((s) => s.collisions)).toEqual([
      { tUs: 3_000_000, a: 1, b: 2, terrain: false, x: 0, y: 0 },
    ]);
  });

  test('that does not come again is told in amber, with both verdicts', async () => {
    const { opened, player } = await connected();
    const info = caseInfo(4);
    const params = JSON.stringify({ ...(JSON.parse(info.params) as object), recorded: 'failed' });
    await player.publish(
      { channel: 'VIZ_CASE', value: { ...info, params } },
      says(0, { verdict: 3, message: 'passed' }),
      shows(0),
    );
    const banner = opened.page.getByRole('alert');
    await banner.getByText(/This build does not end as recorded/).waitFor();
    expect(await banner.textContent()).toMatch(/recorded: failed.*now: passed/);
    await expect.poll(() => opened.page.title(), { timeout: limitMs }).toMatch(/^≠ /);
  });
});

describe('runs', () => {
  test('messages of a run before are dropped, a new run begins empty', async () => {
    const { opened, player } = await connected();
    for (const [i, tUs] of times.slice(0, 70).entries())
      await player.publish(...messagesAt(tUs, 4, times[i - 1] ?? -1));
    await opened.until((s) => s.events.length === 3);
    await player.publish(says(0, { run: 2 }), { channel: 'VIZ_FRAME', value: frame(0, 4, 2) });
    await opened.until((s) => s.run === 2 && s.events.length === 0 && s.toUs === 0);
    const late = events.find(({ kind }) => kind === 'collision');
    if (late) await player.publish({ channel: 'VIZ_EVENT', value: late });
    await player.publish({ channel: 'VIZ_EVENT', value: { ...events[0], run: 2 } as (typeof events)[0] });
    await opened.until((s) => s.events.length === 1);
    expect(await opened.state((s) => s.collisions.length)).toBe(0);
  });

  test('a message of another layout: "type mismatch: rebuild", and the rest goes on', async () => {
    const { opened, player } = await connected();
    await player.datagram(
      Buffer.concat([Buffer.from('4c43303200000000', 'hex'), Buffer.from('VIZ_RISK\0other layout')]),
    );
    await opened.page
      .getByText(/type mismatch: rebuild/)
      .first()
      .waitFor();
    await player.publish(says(0, {}), shows(0));
    await opened.until((s) => s.frame !== null);
  });
});
