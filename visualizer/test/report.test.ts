// A report saved by the page: what may run in it, hostile text, a report of a report.

import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import type { Page } from 'playwright-core';
import { describe, expect, test } from 'vitest';
import { drawn, expectNoErrors, limitMs, type Opened, openLog, openPage, temporaryFolder } from './harness';
import { sceneLog } from './scene';

const facts = (opened: Opened): Promise<unknown> =>
  opened.state((s) => ({
    badge: s.badge,
    case: s.caseInfo,
    world: s.world,
    events: s.events,
    collisions: s.collisions,
    toUs: s.toUs,
    frame: s.frame,
  }));

async function saved(opened: Opened, key: string): Promise<string> {
  await opened.until((s) => s.frame !== null);
  const [download] = await Promise.all([
    opened.page.waitForEvent('download'),
    opened.page.keyboard.press(key),
  ]);
  const file = join(temporaryFolder(), download.suggestedFilename());
  await download.saveAs(file);
  return file;
}

describe('a report', () => {
  test('of a report is a report again', async () => {
    const first = await saved(await openLog(sceneLog()), 'r');
    const report = await openPage(`file://${first}`);
    await report.until((s) => s.frame !== null);
    const again = await openPage(`file://${await saved(report, 'r')}`);
    await again.until((s) => s.frame !== null);
    expect(await facts(again)).toEqual(await facts(report));
  });

  test('runs only what its content security policy lists', async () => {
    const opened = await openLog(sceneLog());
    const file = await saved(opened, 'r');
    const text = readFileSync(file, 'utf8');
    expect(text).toMatch(/default-src 'none'; script-src 'sha256-[^' ]+'; style-src 'sha256-[^' ]+';/);
    const report = await openPage(`file://${file}`);
    const ran = await report.page.evaluate(() => {
      const script = document.createElement('script');
      script.textContent = 'window.injected = true';
      document.head.append(script);
      return 'injected' in window;
    });
    expect(ran).toBe(false);
  });

  test('shows hostile text as text', async () => {
    const opened = await openPage('about:blank');
    const hostile = '<img src=x onerror="window.injected=1"></script><script>window.injected=1</script>';
    const { caseInfo, frame, status } = await import('./scene');
    const { encodeMessage } = await import('../codec/viz');
    const { writeLog } = await import('../codec/log');
    const info = {
      ...caseInfo(2),
      property: hostile,
      commands: [{ tUs: 0, index: 0, name: hostile, args: hostile }],
    };
    const log = writeLog([
      { timeUs: 0, channel: 'VIZ_CASE', data: encodeMessage({ channel: 'VIZ_CASE', value: info }) },
      {
        timeUs: 0,
        channel: 'VIZ_STATUS',
        data: encodeMessage({ channel: 'VIZ_STATUS', value: status(0, { message: hostile }) }),
      },
      { timeUs: 0, channel: 'VIZ_FRAME', data: encodeMessage({ channel: 'VIZ_FRAME', value: frame(0, 2) }) },
    ]);
    await opened.page.close();
    const page = await openLog(log);
    const report = await openPage(`file://${await saved(page, 'r')}`);
    await report.until((s) => s.frame !== null);
    for (const one of [page, report]) {
      expect(await one.page.locator('img').count()).toBe(0);
      expect(await one.page.evaluate(() => 'injected' in window)).toBe(false);
      expect(await one.state((s) => s.caseInfo?.property)).toBe(hostile);
    }
  });

  test('offers nothing that needs a player: what can be pressed does something, the rest says why it cannot', async () => {
    const file = await saved(await openLog(sceneLog()), 'r');
    const opened = await openPage(`file://${file}`, { permissions: ['clipboard-read', 'clipboard-write'] });
    const { page } = opened;
    await opened.until((s) => s.frame !== null);
    for (const summary of await page.locator('summary').all()) await summary.click();
    await page.evaluate(noteRefusals);
    let answers = 0; // outside of the page: downloads, the dialog for a file
    for (const event of ['download', 'filechooser'] as const)
      page.on(event as 'download', () => (answers += 1));
    const pressed: string[] = [];
    const idle: string[] = [];
    for (const tab of ['Commands', 'Objects', 'Events']) {
      await page.getByRole('tab', { name: tab }).click();
      for (const button of await page.$$('button:enabled')) {
        if (!(await button.isVisible())) continue; // of another tab, or gone with its banner
        const name = await button.evaluate(
          (one: HTMLElement | SVGElement) =>
            `${one.ariaLabel ?? one.textContent}: ${one.getAttribute('title')}`,
        );
        if (await button.evaluate((one) => one.matches('[role=tab], [aria-pressed=true]'))) continue;
        if (pressed.includes(name)) continue;
        await somewhere(opened);
        const [before, answered] = [await seen(page), answers];
        await button.click();
        pressed.push(name);
        const done = async () => answers > answered || (await seen(page)) !== before;
        await expect
          .poll(done, { timeout: limitMs })
          .toBe(true)
          .catch(() => idle.push(name));
        await page.keyboard.press('Escape');
      }
    }
    expect(idle).toEqual([]);
    expect(pressed.length).toBeGreaterThan(30);
    expect(await page.evaluate('window.refusals')).toEqual([]);
    expect(await page.evaluate(disabledWithoutReason)).toEqual([]);
    expect(await page.getByText('Replay original: no player is connected.').isVisible()).toBe(true);
    expectNoErrors(opened);
  });
});

// A moment between events, from which every control of time leads somewhere else; nothing plays.
async function somewhere({ page, until }: Opened): Promise<void> {
  await page.evaluate('document.activeElement.blur()'); // tabs and lists have keys of their own
  await page.keyboard.press('f');
  await page.keyboard.press('=');
  await page.evaluate('{ const { viewer } = window.__viz; viewer.pause(); viewer.seek(1_500_000); }');
  await until((s) => !s.playing && s.tUs === 1_500_000 && s.frame?.tUs === 1_500_000);
  await drawn(page);
}

// All that the page says and draws, apart from what only the pointer and the focus change.
function seen(page: Page): Promise<string> {
  return page.evaluate(() => {
    const drawings = [...document.querySelectorAll('canvas')].map((canvas) => canvas.toDataURL());
    const chosen = [...document.querySelectorAll('select, input')].map(
      (one) => (one as HTMLInputElement).value,
    );
    return [document.documentElement.outerHTML, ...drawings, ...chosen].join();
  });
}

// Keeps each line that tells of something that did not work; lines go after a while.
function noteRefusals(): void {
  const refusals: (string | null)[] = [];
  Object.assign(window, { refusals });
  const look = (): void => {
    for (const notice of document.querySelectorAll('.notice.bad')) refusals.push(notice.textContent);
  };
  new MutationObserver(look).observe(document.querySelector('.notices') as Element, { childList: true });
}

// What is shown and disabled without a word on why: beside it in its section, or as its title.
function disabledWithoutReason(): string[] {
  const why = /player|bridge/;
  const off = [...document.querySelectorAll<HTMLElement>('button:disabled, select:disabled, input:disabled')];
  return off
    .filter((one) => one.checkVisibility())
    .filter((one) => {
      const notes = [...(one.closest('section')?.querySelectorAll<HTMLElement>('[role=note]') ?? [])];
      return (
        !why.test(one.title) &&
        !notes.some((note) => note.checkVisibility() && why.test(note.textContent ?? ''))
      );
    })
    .map((one) => one.ariaLabel ?? one.textContent ?? '');
}
