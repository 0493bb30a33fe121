// The whole chain: the real player (bin/faultcheck play), the real bridge, the page. Needs the Erlang side built.

import { describe, expect, test } from 'vitest';
import {
  type BridgeProcess,
  expectNoErrors,
  type Opened,
  openPage,
  type Program,
  startBridge,
  startProgram,
} from './harness';

async function chain(
  ...options: string[]
): Promise<{ opened: Opened; bridge: BridgeProcess; player: Program }> {
  const bridge = await startBridge({ control: true });
  const player = startProgram(bridge, ...options);
  const opened = await openPage(bridge.url);
  await opened.until((s) => s.frame !== null && s.status !== null);
  return { opened, bridge, player };
}

describe('a replay', () => {
  test('is played and recovers from a bridge and from a player that are killed', async () => {
    const { opened, bridge, player } = await chain();
    await opened.until((s) => s.badge === 'REPLAY' && s.caseInfo !== null && s.world !== null);
    const run = await opened.state((s) => s.run);
    await bridge.kill();
    await opened.until((s) => s.badge === 'DISCONNECTED');
    await bridge.restart();
    await opened.until((s) => s.connection.connected && s.badge !== 'DISCONNECTED');
    // a page that is opened now gets what happened before
    const fresh = await openPage(bridge.url);
    await fresh.until((s) => s.events.some(({ seq }) => seq === 0));
    await player.kill();
    startProgram(bridge);
    const later = `(s) => s.run !== ${run} && s.frame !== null && s.badge === 'REPLAY'`;
    await opened.until(later);
    expect(opened.errors.filter((line) => !/ERR_CONNECTION_REFUSED|WebSocket connection/.test(line))).toEqual(
      [],
    );
  });

  test('is forked into a live run that may be changed', async () => {
    const { opened } = await chain();
    await opened.until((s) => s.badge === 'REPLAY' && s.tUs > 200_000);
    expect(await opened.state((s) => s.controlReason)).toMatch(/replay/);
    await opened.page.getByRole('button', { name: 'Fork from here' }).click();
    await opened.until((s) => s.badge === 'LIVE' && s.controlAllowed);
    expectNoErrors(opened);
  });

  test('is forked where the page looks, also when the player is elsewhere', async () => {
    const { opened } = await chain();
    await opened.until((s) => s.badge === 'REPLAY' && s.tUs > 1_500_000);
    // Else the page may have caught up with a player that has come to its end before this is looked at.
    await opened.page.keyboard.press('Space');
    await opened.until((s) => !s.playing && s.status?.paused);
    await opened.page.getByRole('slider', { name: 'Time' }).focus();
    await opened.page.keyboard.press('Shift+ArrowLeft');
    await opened.until((s) => !s.following && s.tUs < (s.status?.tUs ?? 0) - 500_000);
    await opened.page.getByRole('button', { name: 'Fork from here' }).click();
    await opened.until((s) => s.badge === 'LIVE' && s.controlAllowed);
  });
});

// An empty world with one copter that the page has added.
async function flight(): Promise<Opened> {
  const { opened } = await chain('--live');
  await opened.until((s) => s.badge === 'LIVE' && s.controlAllowed);
  await opened.page.getByText('Objects', { exact: true }).last().click(); // unfolds the form
  await opened.page.getByRole('button', { name: 'Add', exact: true }).click();
  await opened.until((s) => s.frame?.objects.length === 1);
  await opened.page.keyboard.press('Escape');
  await opened.page.evaluate('document.activeElement.blur()');
  if ((await opened.state((s) => s.observer)) < 0) await opened.page.keyboard.press('n');
  await opened.until((s) => s.observer >= 0);
  return opened;
}

describe('a live flight', () => {
  test('shows what steering does, and marks who is steered until the key is released', async () => {
    const opened = await flight();
    await opened.page.getByRole('img', { name: /^Map/ }).focus();
    await opened.page.keyboard.down('w');
    const observed = `s.frame?.objects.find(({ id }) => id === s.observer)`;
    await opened.until(
      `(s) => { const o = ${observed}; return (o?.flags & 16) && Math.hypot(o.vel[0], o.vel[1]) > 0.05; }`,
    );
    await opened.page.keyboard.up('w');
    await opened.until(`(s) => { const o = ${observed}; return o && !(o.flags & 16); }`);
    expectNoErrors(opened);
  });

  test('shows a fault that the form injects: in the list, on the copter, in what it perceives', async () => {
    const opened = await flight();
    const form = opened.page.getByRole('region', { name: 'Inject fault' });
    await form.getByRole('combobox', { name: 'Probe' }).selectOption('PxId0'); // once the form knows the copter
    await form.getByRole('textbox', { name: 'constant' }).fill('2');
    await form.getByRole('textbox', { name: 'For' }).fill(''); // not for one call only, but until it is cleared
    await form.getByRole('button', { name: 'Inject' }).click();
    await opened.until((s) => (s.faults?.items.length ?? 0) === 1 && s.faults?.items[0]?.type === 'offset');
    await opened.until((s) => s.frame?.objects.some(({ flags }) => (flags & 4) !== 0) ?? false);
    await form.getByRole('button', { name: 'Clear all' }).click();
    await opened.until((s) => s.frame?.objects.every(({ flags }) => (flags & 4) === 0) ?? false);
    expectNoErrors(opened);
  });
});
