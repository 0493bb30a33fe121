// A report saved by the page: what may run in it, hostile text, a report of a report.

import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { describe, expect, test } from 'vitest';
import { type Opened, openLog, openPage, temporaryFolder } from './harness';
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
});
