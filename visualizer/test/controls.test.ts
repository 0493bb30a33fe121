// What the columns do to a live run, heard by a player; and reports, pictures and dropped files.

import { readFileSync } from 'node:fs';
import type { Page } from 'playwright-core';
import { describe, expect, test } from 'vitest';
import type { Control } from '../codec/messages';
import {
  type BridgeProcess,
  expectNoErrors,
  joinPlayer,
  openLog,
  openPage,
  type Opened,
  type Player,
  startBridge,
  temporaryFolder,
  testPage,
} from './harness';
import { caseId, collisionUs, messagesAt, sceneLog, status } from './scene';

interface Live {
  bridge: BridgeProcess;
  player: Player;
  opened: Opened;
  page: Page;
  asked(verb: string, fits?: (control: Control) => boolean): Promise<Control>;
}

// A live run with control and a page that watches it.
async function live(): Promise<Live> {
  const bridge = await startBridge({ control: true });
  const player = await joinPlayer(bridge);
  player.answerAll();
  const opened = await openPage(bridge.url);
  await opened.until((s) => s.connection.connected);
  await player.publish(...messagesAt(0, 4, -1));
  await player.publish({
    channel: 'VIZ_STATUS',
    value: status(0, { mode: 1, paused: true, controlAllowed: true }),
  });
  await opened.until((s) => s.frame !== null && s.controlAllowed && s.observer >= 0);
  return {
    bridge,
    player,
    opened,
    page: opened.page,
    asked: (verb, fits = () => true) =>
      player.heard.until(() => player.controls.find((one) => one.verb === verb && fits(one)), verb),
  };
}

describe('steering', () => {
  const lastOf = ({ player }: Live): Control | undefined =>
    player.controls.filter((c) => c.verb === 'steer').at(-1);
  const released = (control: Control | undefined): boolean =>
    control?.args.every((arg) => arg === 0) ?? false;

  test('repeats while a key is held, and ends with its release', async () => {
    const run = await live();
    await run.page.locator('.map-host canvas').last().focus();
    await run.page.keyboard.down('w');
    await run.asked('steer', ({ args }) => (args[0] ?? 0) > 0.1 && args[1] === 0 && args[2] === 0);
    const count = () => run.player.controls.filter((c) => c.verb === 'steer').length;
    const before = count();
    await run.player.heard.until(() => count() >= before + 3, 'three repeats');
    await run.page.keyboard.up('w');
    await run.player.heard.until(() => released(lastOf(run)), 'zero steering');
    const { object } = lastOf(run) ?? { object: -1 };
    expect(object).toBe(await run.opened.state((s) => s.observer));
    expectNoErrors(run.opened);
  });

  test.each<[string, (page: Page) => Promise<unknown>]>([
    ['Escape', (page) => page.keyboard.press('Escape')],
    ['another window', (page) => page.evaluate(() => window.dispatchEvent(new Event('blur')))],
    ['another field', (page) => page.getByLabel('Start in').focus()],
  ])('ends with %s too', async (_name, leave) => {
    const run = await live();
    await run.page.locator('.map-host canvas').last().focus();
    await run.page.keyboard.down('d');
    await run.asked('steer', ({ args }) => (args[1] ?? 0) > 0.1);
    await leave(run.page);
    await run.player.heard.until(() => released(lastOf(run)), 'zero steering');
    expect(await run.page.locator('html').getAttribute('data-theme')).toBe('light'); // D steered
  });

  test('by the buttons of the pad', async () => {
    const run = await live();
    const turn = run.page.getByRole('button', { name: 'turn left (Q)' });
    await turn.and(run.page.locator(':enabled')).hover();
    await run.page.mouse.down();
    await run.asked('steer', ({ args }) => (args[2] ?? 0) > 0.1);
    await run.page.mouse.up();
    await run.player.heard.until(() => released(lastOf(run)), 'zero steering');
  });
});

describe('the forms', () => {
  test('inject a fault with its parameters, in probe calls', async () => {
    const run = await live();
    const { page } = run;
    await page.getByLabel('Object', { exact: true }).selectOption('1');
    await page.getByLabel('Probe', { exact: true }).selectOption('PyId1');
    await page.getByLabel('Model', { exact: true }).selectOption('random_offset');
    await page.getByLabel('low', { exact: true }).fill('-0.5');
    await page.getByLabel('high', { exact: true }).fill('1.5');
    await page.getByLabel('For', { exact: true }).fill('20');
    await page.getByLabel('Counted in').selectOption('calls');
    await page.getByRole('button', { name: 'Inject', exact: true }).click();
    const { text, object } = await run.asked('inject');
    expect(object).toBe(1);
    expect(JSON.parse(text)).toEqual({
      probe: 'PyId1',
      model: 'random_offset',
      params: { low: -0.5, high: 1.5 },
      from_calls: 0,
      for_calls: 20,
    });
    await page.getByText('inject: done').waitFor();
    await page.getByRole('button', { name: 'Clear all' }).click();
    await run.asked('clear_faults');
    expectNoErrors(run.opened);
  });

  test('tell in one line what is wrong, and send nothing', async () => {
    const { page, player } = await live();
    await page.getByLabel('constant').fill('much');
    await page.getByRole('button', { name: 'Inject', exact: true }).click();
    await page.getByText('constant: expected a number, inf, -inf or nan, got "much"').waitFor();
    expect(player.controls.filter(({ verb }) => verb === 'inject')).toEqual([]);
  });

  test('wait for a probe, and keep what was typed before one was known', async () => {
    const bridge = await startBridge({ control: true });
    const player = await joinPlayer(bridge);
    const opened = await openPage(bridge.url);
    await opened.until((s) => s.connection.connected);
    const flying = status(0, { mode: 1, paused: true, controlAllowed: true });
    await player.publish({ channel: 'VIZ_STATUS', value: flying });
    const form = opened.page.getByRole('region', { name: 'Inject fault' });
    const inject = form.getByRole('button', { name: 'Inject', exact: true });
    await form.getByText('No probe is known yet.').waitFor();
    expect(await inject.isDisabled()).toBe(true);
    const [constant, length] = [form.getByLabel('constant'), form.getByLabel('For', { exact: true })];
    await length.fill(''); // as it was: no end
    await constant.fill('-'); // the beginning of a number
    await player.publish(...messagesAt(0, 4, -1), { channel: 'VIZ_STATUS', value: flying });
    await inject.and(opened.page.locator(':enabled')).waitFor();
    expect(await form.getByLabel('Probe').inputValue()).toBe('PxId1');
    expect([await constant.inputValue(), await length.inputValue()]).toEqual(['-', '']);
    expect(await form.getByLabel('Counted in').inputValue()).toBe('s');
    await opened.page.keyboard.type('1.5'); // still in that field
    expect(await constant.inputValue()).toBe('-1.5');
    await form.getByLabel('Probe').selectOption('PyId1');
    expect([await constant.inputValue(), await length.inputValue()]).toEqual(['-1.5', '']);
    await inject.click();
    const sent = await player.heard.until(
      () => player.controls.find(({ verb }) => verb === 'inject'),
      'inject',
    );
    expect(JSON.parse(sent.text)).toEqual({
      probe: 'PyId1',
      model: 'offset',
      params: { constant: -1.5 },
      from_s: 0,
    });
    expectNoErrors(opened);
  });

  test('change parameters, add and remove objects, start scenarios, stop all', async () => {
    const run = await live();
    const { page } = run;
    for (const summary of await page.locator('summary').all()) await summary.click();
    await page.getByLabel('Name', { exact: true }).fill('pos_p');
    await page.getByLabel('Value', { exact: true }).fill('1.25');
    await page.getByRole('button', { name: 'Set', exact: true }).click();
    expect(await run.asked('set')).toMatchObject({ object: -1, args: [1.25], text: 'pos_p' });
    await page.getByLabel('x in m').fill('-2');
    await page.getByLabel('y in m').fill('3.5');
    await page.getByRole('button', { name: 'Add', exact: true }).click();
    expect(await run.asked('add_object')).toMatchObject({ args: [-2, 3.5] });
    await page.getByRole('button', { name: /^Remove Quad/ }).click();
    expect((await run.asked('remove_object')).object).toBe(await run.opened.state((s) => s.observer));
    await page.getByLabel('File', { exact: true }).fill('crossing.json');
    await page.getByRole('button', { name: 'Start', exact: true }).click();
    expect(await run.asked('scenario')).toMatchObject({ text: 'crossing.json' });
    await page.getByRole('button', { name: 'Stop all' }).click();
    await run.asked('stop_all');
  });

  test('are disabled in a replay, with the reason, and fork asks the player', async () => {
    const run = await live();
    await run.player.publish({
      channel: 'VIZ_STATUS',
      value: status(0, { mode: 2, paused: true, controlAllowed: true }),
    });
    await run.opened.until((s) => !s.controlAllowed);
    const form = run.page.getByRole('region', { name: 'Inject fault' });
    await form.getByText('Fork it into a live run').waitFor();
    for (const name of ['Inject', 'Clear all'])
      expect(await form.getByRole('button', { name, exact: true }).isDisabled()).toBe(true);
    await form.getByRole('button', { name: 'Fork from here' }).click();
    await run.asked('fork');
  });
});

test('a fork begins at the moment that is looked at, where the player goes first', async () => {
  const run = await live();
  const { player, opened, page } = run;
  for (const tUs of [250_000, 500_000, 750_000, 1_000_000])
    await player.publish(...messagesAt(tUs, 4, tUs - 1));
  const there = { mode: 2, paused: true, controlAllowed: true };
  await player.publish({ channel: 'VIZ_STATUS', value: status(1_000_000, there) });
  await opened.until((s) => s.toUs === 1_000_000 && s.status?.tUs === 1_000_000 && !s.controlAllowed);
  await page.keyboard.press('Home');
  await page.keyboard.press('.');
  await opened.until((s) => s.tUs === 250_000);
  await page.getByRole('button', { name: 'Fork from here' }).click();
  expect((await run.asked('seek')).args).toEqual([0.25]);
  expect(player.controls.some(({ verb }) => verb === 'fork')).toBe(false);
  await player.publish({ channel: 'VIZ_STATUS', value: status(250_000, there) });
  await run.asked('fork');
});

describe('a report', () => {
  test('opens without a network and shows the same', async () => {
    const { page, state } = await openLog(sceneLog(), { acceptDownloads: true });
    const [download] = await Promise.all([page.waitForEvent('download'), page.keyboard.press('r')]);
    expect(download.suggestedFilename()).toBe(`${caseId}.html`);
    const path = `${temporaryFolder()}/report.html`;
    await download.saveAs(path);
    const report = await openPage(`file://${path}`, { offline: true });
    await report.until((s) => s.frame !== null);
    const told = (s: Parameters<Parameters<typeof state>[0]>[0]) => ({
      times: [s.fromUs, s.toUs, s.durationUs],
      commands: s.caseInfo?.commands,
      events: s.events,
      collisions: s.collisions,
      faults: s.faults?.items,
    });
    expect(await report.state(told)).toEqual(await state(told));
    expect(report.requests.filter((url) => !/^(file|data|blob):/.test(url))).toEqual([]);
    expect(readFileSync(path, 'utf8')).not.toContain(process.env.HOME ?? '/root');
    expectNoErrors(report);
  });

  test('can be dropped on the page, as can a log; anything else is refused in one line', async () => {
    const { page } = await openPage(`file://${testPage}`);
    const drop = (name: string, bytes: Uint8Array) =>
      page.evaluate(
        ([fileName, content]) => {
          const data = new DataTransfer();
          data.items.add(new File([Uint8Array.from(content)], fileName));
          document.dispatchEvent(new DragEvent('drop', { dataTransfer: data, cancelable: true }));
        },
        [name, [...bytes]] as const,
      );
    await drop('letter.lcm', new TextEncoder().encode('Dear page, this is no log.'));
    await page.locator('.notice.bad', { hasText: 'letter.lcm' }).waitFor();
    await drop('page.html', new TextEncoder().encode('<p>hello'));
    await page.getByText('page.html: not an LCM log or a report').waitFor();
    await drop('scene.lcm', sceneLog());
    await page.locator('.badge[data-badge="FILE"]').waitFor();
  });
});

test('Show goes to one second before the collision', async () => {
  const { page, until } = await openLog(sceneLog());
  await page.getByRole('alert').getByRole('button', { name: 'Show' }).click();
  await until((s) => s.tUs === 2_000_000 && !s.playing);
  expect(await page.title()).toContain('✖ Collision');
  expect(await page.locator('#icon').getAttribute('href')).toContain(encodeURIComponent('#b01e2f'));
  expect(collisionUs).toBe(3_000_000);
});

test('a command that is clicked is gone to, highlighted, and copied as an Erlang term', async () => {
  const { page, until } = await openLog(sceneLog(), { permissions: ['clipboard-read', 'clipboard-write'] });
  await page.getByRole('button', { name: /^2 1\.00 inject/ }).click();
  await until((s) => s.tUs === 1_000_000);
  await page.locator('.commands li.current', { hasText: 'inject' }).waitFor();
  await page.getByRole('button', { name: /^Copy inject/ }).focus();
  await page.keyboard.press('Enter');
  await page.getByText('copied', { exact: true }).waitFor();
  expect(await page.evaluate(() => navigator.clipboard.readText())).toBe(
    '{inject, ["PyId1", {offset, 0.5}]}',
  );
});

test('a picture of the map is saved by P', async () => {
  const { page } = await openLog(sceneLog(), { acceptDownloads: true });
  const [download] = await Promise.all([page.waitForEvent('download'), page.keyboard.press('p')]);
  const path = `${temporaryFolder()}/map.png`;
  await download.saveAs(path);
  expect([...readFileSync(path).subarray(0, 8)]).toEqual([137, 80, 78, 71, 13, 10, 26, 10]);
});

test('the chosen speed is remembered', async () => {
  const { page, until } = await openLog(sceneLog());
  await page.getByLabel('Speed').selectOption('0.25');
  await until((s) => s.speed === 0.25);
  await page.reload();
  await page.locator('input[type=file]').setInputFiles({
    name: 'scene.lcm',
    mimeType: 'application/octet-stream',
    buffer: Buffer.from(sceneLog()),
  });
  await until((s) => s.badge === 'FILE' && s.speed === 0.25);
});

test('a stored case of the bridge is chosen at the top, and opened as a file when there is no player', async () => {
  const bridge = await startBridge({ cases: { [caseId]: sceneLog() } });
  const { page, until, errors } = await openPage(bridge.url);
  await until((s) => s.connection.connected);
  const chooser = page.getByLabel('Case', { exact: true }).and(page.locator('select'));
  await chooser.focus();
  await chooser.locator(`option[value="${caseId}"]`).waitFor({ state: 'attached' });
  await chooser.selectOption(caseId);
  await until((s) => s.badge === 'FILE' && s.collisions.length === 1);
  expect(errors).toEqual([]);
});
