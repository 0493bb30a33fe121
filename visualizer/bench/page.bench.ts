// The page alone: frames drawn from a file, size of its script, size of a report and how long that takes to open.

import { spawnSync } from 'node:child_process';
import { readFileSync, statSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { gzipSync } from 'node:zlib';
import { expect, test } from 'vitest';
import { openLog, openPage, temporaryFolder, testPage } from '../test/harness';
import { report } from './measure';
import { recorded, root } from './scenarios';

const playedMs = 6000;
const builtPage = join(root, 'visualizer/dist/page.html');

test.each([40, 400])('frames a second drawn with %i objects', async (count) => {
  const opened = await openLog(recorded(temporaryFolder(), count, 12));
  await opened.page.keyboard.press('Home');
  if (!(await opened.state((s) => s.playing))) await opened.page.keyboard.press('Space');
  await opened.until((s) => s.tUs > 500_000);
  const before = await opened.stats();
  const began = performance.now();
  await opened.page.waitForTimeout(playedMs);
  const after = await opened.stats();
  expect(await opened.state((s) => s.playing)).toBe(true);
  report(`viz_fps_${count}`, (1000 * (after.drawn - before.drawn)) / (performance.now() - began), '1/s');
});

test('size of the script', () => {
  const script =
    /<script type="module"[^>]*>([\s\S]*?)<\/script>/.exec(readFileSync(builtPage, 'utf8'))?.[1] ?? '';
  expect(script.length).toBeGreaterThan(10_000);
  report('viz_page_kb', gzipSync(script, { level: 9 }).length / 1000, 'kB');
});

// As the runner of properties writes it.
function writeReport(page: string, log: string, file: string): void {
  const text = (name: string): string => JSON.stringify(name);
  const program = `
    {ok, Page} = file:read_file(${text(page)}), {ok, Log} = file:read_file(${text(log)}),
    {Html, _} = replay_report:format(Page, Log, "bench"), ok = file:write_file(${text(file)}, Html), halt().`;
  const paths = ['replay', 'faultcheck', 'c_bridge'].map((app) =>
    join(root, '_build/default/lib', app, 'ebin'),
  );
  const run = spawnSync('erl', ['-noinput', '-pa', ...paths, '-eval', program], { encoding: 'utf8' });
  if (run.status !== 0) throw new Error(`${run.stdout}${run.stderr}`);
}

test('a report of 30 s and 10 copters: its size, and how long it takes to open', async () => {
  const folder = temporaryFolder();
  const log = join(folder, 'run.lcm');
  writeFileSync(log, recorded(folder, 10, 30));
  const file = join(folder, 'report.html');
  writeReport(builtPage, log, file);
  report('viz_report_mb', statSync(file).size / 1e6, 'MB');
  writeReport(testPage, log, file); // the same with window.__viz
  const opened = await openPage('about:blank');
  const took: number[] = [];
  for (let i = 0; i < 3; i += 1) {
    const began = performance.now();
    await opened.page.goto(`file://${file}`);
    await opened.until((s) => s.badge === 'FILE' && s.frame !== null);
    took.push((performance.now() - began) / 1000);
    await opened.page.goto('about:blank');
  }
  report('viz_report_open_s', Math.min(...took), 's');
});
