// Asking the player: steering by keys, faults by the form, refusals. The player is one that says yes to everything.

import { beforeEach, describe, expect, test } from 'vitest';
import type { Message } from '../codec/messages';
import {
  atEnd,
  expectNoErrors,
  joinPlayer,
  type Opened,
  openPage,
  type Player,
  startBridge,
} from './harness';
import { caseInfo, frame, status, times } from './scene';

let opened: Opened;
let player: Player;

const verbs = (): string[] => player.controls.map(({ verb }) => verb);
const asked = (verb: string, count = 1) =>
  player.heard.until(() => player.controls.filter((control) => control.verb === verb).length >= count, verb);

beforeEach(async () => {
  const bridge = await startBridge({ control: true });
  player = await joinPlayer(bridge);
  player.answerAll();
  opened = await openPage(bridge.url);
  await opened.until((s) => s.connection.connected);
  const live = (tUs: number): Message[] => [
    {
      channel: 'VIZ_STATUS',
      value: status(tUs, { mode: 1, verdict: 0, controlAllowed: true, durationUs: -1 }),
    },
    { channel: 'VIZ_FRAME', value: frame(tUs, 4) },
  ];
  await player.publish({ channel: 'VIZ_CASE', value: caseInfo(4) });
  let i = 0;
  const clock = setInterval(() => {
    void player.publish(...live(times[i % times.length] ?? 0));
    i += 1;
  }, 50);
  atEnd(() => clearInterval(clock));
  await opened.until((s) => s.controlAllowed && s.observer >= 0);
});

describe('steering', () => {
  test('by keys repeats ten times a second while held, and is zero once released', async () => {
    await opened.page.getByRole('img', { name: /^Map/ }).focus();
    await opened.page.keyboard.down('w');
    await asked('steer', 4);
    await opened.page.keyboard.up('w');
    const released = () =>
      player.controls.findLast(({ verb }) => verb === 'steer')?.args.every((arg) => arg === 0);
    await player.heard.until(released, 'release');
    const steer = player.controls.filter(({ verb }) => verb === 'steer');
    expect(steer[0]?.object).toBe(1);
    expect(steer[0]?.args[0]).toBeGreaterThan(0);
    expect(steer.every(({ token, client }) => token !== '' && client === 'page-1')).toBe(true);
    expectNoErrors(opened);
  });

  test('ends when the map loses the focus', async () => {
    await opened.page.getByRole('img', { name: /^Map/ }).focus();
    await opened.page.keyboard.down('a');
    await asked('steer', 2);
    await opened.page.getByRole('tab', { name: 'Objects' }).focus();
    const released = () =>
      player.controls.findLast(({ verb }) => verb === 'steer')?.args.every((arg) => arg === 0);
    await player.heard.until(released, 'release');
  });

  test('ends when the page goes away: nothing more comes', async () => {
    await opened.page.getByRole('img', { name: /^Map/ }).focus();
    await opened.page.keyboard.down('d');
    await asked('steer', 2);
    await opened.page.close();
    const last = await openPage('about:blank'); // a while passes
    await last.page.close();
    const before = player.controls.length;
    await (await openPage('about:blank')).page.close();
    expect(player.controls.length).toBe(before);
  });

  test('"Stop all" asks for it', async () => {
    await opened.page.getByRole('button', { name: 'Stop all' }).click();
    await asked('stop_all');
  });
});

describe('faults', () => {
  test('are injected by the form: probe, model, parameter, start and duration', async () => {
    const form = opened.page.getByRole('region', { name: 'Inject fault' });
    await form.getByLabel('Probe').selectOption({ index: 1 });
    await form.getByRole('textbox', { name: 'constant' }).fill('1.5');
    await form.getByRole('textbox', { name: 'Start in' }).fill('0.5');
    await form.getByRole('textbox', { name: 'For' }).fill('2');
    await form.getByRole('button', { name: 'Inject' }).click();
    await asked('inject');
    const text = player.controls.find(({ verb }) => verb === 'inject')?.text ?? '';
    expect(JSON.parse(text)).toMatchObject({
      probe: expect.stringMatching(/^P[xy]Id1$/) as string,
      model: 'offset',
      params: { constant: 1.5 },
      from_s: 0.5,
      for_s: 2,
    });
    expectNoErrors(opened);
  });

  test('are cleared', async () => {
    await opened.page.getByRole('button', { name: 'Clear all' }).click();
    await asked('clear_faults');
  });
});

describe('without an answer', () => {
  test('a page says so after a second', async () => {
    const bridge = await startBridge({ control: true });
    const silent = await joinPlayer(bridge);
    const page = await openPage(bridge.url);
    await page.until((s) => s.connection.connected);
    await silent.publish(
      { channel: 'VIZ_STATUS', value: status(0, { mode: 1, verdict: 0, controlAllowed: true }) },
      { channel: 'VIZ_FRAME', value: frame(0, 4) },
    );
    await page.until((s) => s.controlAllowed);
    await page.page.getByRole('button', { name: 'Stop all' }).click();
    await page.page
      .getByRole('log')
      .getByText(/stop_all/)
      .waitFor();
    expect(silent.controls.map(({ verb }) => verb)).toContain('stop_all');
    expect(verbs()).not.toContain('stop_all');
  });
});
