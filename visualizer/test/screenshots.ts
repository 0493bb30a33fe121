// Takes the pictures of docs/: the built page with a recording, in both themes. Run by scripts/screenshots.sh:
//   node test/screenshots.ts RECORDING.lcm FOLDER

import { existsSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { chromium } from 'playwright-core';
import { smallerPng } from './png.ts';

const [recording, folder] = process.argv.slice(2);
if (recording === undefined || folder === undefined) {
  process.stderr.write('screenshots: expected a recording and a folder\n');
  process.exit(2);
}
const page = fileURLToPath(new URL('../dist/page.html', import.meta.url));
const names = ['/usr/bin/chromium', '/usr/bin/chromium-browser', '/usr/bin/google-chrome'];
const executablePath = process.env.CHROMIUM ?? names.find((name) => existsSync(name));
if (executablePath === undefined) {
  process.stderr.write('screenshots: no chromium; run: scripts/setup.sh test\n');
  process.exit(3);
}

// Shortly before the collision of examples/copter/crowd.json, as seen by the copter whose position jumped.
const moment = '#t=6.3&obs=7';

const browser = await chromium.launch({
  executablePath,
  args: ['--headless=new', '--no-sandbox', '--disable-gpu'],
});
for (const colorScheme of ['light', 'dark'] as const) {
  const tab = await browser.newPage({ viewport: { width: 1440, height: 900 }, colorScheme });
  await tab.goto(`file://${page}${moment}`);
  await tab.locator('input[type=file]').setInputFiles(recording);
  await tab.getByText('6.300').first().waitFor();
  await tab.locator('.objects').waitFor({ state: 'attached' });
  await tab.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
  const picture = smallerPng(await tab.screenshot());
  writeFileSync(join(folder, `visualizer-${colorScheme}.png`), picture);
  await tab.close();
}
await browser.close();
