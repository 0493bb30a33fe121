// A page that asks and goes away, and a player that does not answer.

import { expect, test } from 'vitest';
import { joinPlayer, type Opened, openPage, type Player, startBridge } from './harness';
import { frame, status } from './scene';

// A live run that may be controlled, paused so that its one frame does not get old.
async function live(): Promise<{ opened: Opened; player: Player }> {
  const bridge = await startBridge({ control: true });
  const player = await joinPlayer(bridge);
  const opened = await openPage(bridge.url);
  await opened.until((s) => s.connection.connected);
  const change = { mode: 1, paused: true, verdict: 0, controlAllowed: true, durationUs: -1 };
  await player.publish(
    { channel: 'VIZ_STATUS', value: status(0, change) },
    { channel: 'VIZ_FRAME', value: frame(0, 4) },
  );
  await opened.until((s) => s.controlAllowed && s.observer >= 0);
  return { opened, player };
}

test('steering ends when the page goes away: nothing more comes', async () => {
  const { opened, player } = await live();
  player.answerAll();
  await opened.page.getByRole('img', { name: /^Map/ }).focus();
  await opened.page.keyboard.down('d');
  const steered = () => player.controls.filter(({ verb }) => verb === 'steer').length >= 2;
  await player.heard.until(steered, 'steer');
  await opened.page.close();
  // Opening pages takes several times the 0.1 s in which a held key is repeated.
  await (await openPage('about:blank')).page.close();
  const before = player.controls.length;
  await (await openPage('about:blank')).page.close();
  expect(player.controls.length).toBe(before);
});

test('a page says so when the player does not answer within a second', async () => {
  const { opened, player } = await live();
  await opened.page.getByRole('button', { name: 'Stop all' }).click();
  await opened.page
    .getByRole('log')
    .getByText(/stop_all/)
    .waitFor();
  expect(player.controls.map(({ verb }) => verb)).toEqual(['stop_all']);
});
