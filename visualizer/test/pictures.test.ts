// The page looks as in the stored pictures of both themes, within a tolerance that other fonts do not exceed and that
// whatever is missing, shifted or of another colour does (reference/README.md).

import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { describe, expect, test } from 'vitest';
import { drawn, type Opened, openLog } from './harness';
import { type Comparison, compare, regions, type Scaled, shrunk } from './likeness';
import { type Picture, readPng, writePng } from './png';
import { sceneLog } from './scene';

type Theme = 'light' | 'dark';

const stored = (theme: Theme): string => fileURLToPath(new URL(`reference/${theme}.png`, import.meta.url));
const reports = fileURLToPath(new URL('../../_build/reports', import.meta.url));
const renew = process.env.RENEW_PICTURES === '1';
const patienceMs = 15_000; // for panels that are drawn a little later than the map

// Shortly before the collision, near the two who collide, with distances to anchors. Names of objects are left out.
async function scene(theme: Theme): Promise<Opened> {
  const opened = await openLog(sceneLog(6), { colorScheme: theme, bypassCSP: true });
  for (let i = 0; i < 2; i += 1) await opened.page.keyboard.press('Shift+ArrowRight');
  for (let i = 0; i < 4; i += 1) await opened.page.keyboard.press('ArrowRight');
  for (const key of ['8', '9', 'c', '=', '=', '=']) await opened.page.keyboard.press(key);
  await opened.until((s) => s.tUs === 2_400_000 && s.frame?.tUs === 2_400_000 && s.followed);
  await panelsDrawn(opened); // so that what a test changes is not mixed with what they still had to show
  return opened;
}

// No panel waits for longer than these frames, half a second.
async function panelsDrawn({ page }: Opened): Promise<void> {
  for (let i = 0; i < 15; i += 1) await drawn(page); // two frames each
}

async function photo({ page }: Opened): Promise<Picture> {
  await drawn(page);
  return readPng(await page.screenshot());
}

// Once it no longer changes.
async function settled(opened: Opened): Promise<Picture> {
  let before = await photo(opened);
  for (;;) {
    await panelsDrawn(opened);
    const now = await photo(opened);
    if (Buffer.compare(now.bytes, before.bytes) === 0) return now;
    before = now;
  }
}

function reference(theme: Theme): Scaled {
  return { picture: readPng(readFileSync(stored(theme))), scale: 0.5 };
}

// Compares until what is found is what is looked for, or it is too late.
async function compared(
  opened: Opened,
  wanted: Scaled,
  isRight: (found: Comparison) => boolean,
): Promise<{ found: Comparison; picture: Picture }> {
  const end = performance.now() + patienceMs;
  for (;;) {
    const picture = await photo(opened);
    const found = compare(wanted, { picture, scale: 1 });
    if (isRight(found) || performance.now() > end) return { found, picture };
  }
}

const isAlike = ({ unlike }: Comparison): boolean => unlike.length === 0;

// Hides or moves a part of the page, by the style sheet of the page's own that it would be hidden or moved by.
const hidden = (selector: string): string => `${selector} { visibility: hidden; }`;
const moved = (selector: string, x: number, y: number): string =>
  `${selector} { transform: translate(${x}px, ${y}px); }`;

// What must be noticed, and where.
const mistakes: readonly (readonly [what: string, css: string, region: string])[] = [
  ['no left column', hidden('.column.left'), 'layers'],
  ['no right column', hidden('.column.right'), 'object'],
  ['no banner', hidden('.banners'), 'banner'],
  ['blank timeline', hidden('.timeline-host'), 'timeline'],
  ['blank curves', hidden('.curves-host canvas'), 'curves'],
  ['header 20 px to the right', moved('.header', 20, 0), 'header'],
  ['left column 20 px to the right', moved('.column.left', 20, 0), 'commands'],
  ['left column 20 px down', moved('.column.left', 0, 20), 'shrinking'],
  ['a part of it 20 px down', moved('.column.left > :last-child', 0, 20), 'layers'],
  ['right column 20 px to the left', moved('.column.right', -20, 0), 'inject'],
  ['right column 20 px down', moved('.column.right', 0, 20), 'steer'],
  ['a part of it 20 px down', moved('.column.right > :nth-child(3)', 0, 20), 'inject'],
  ['map 20 px to the right', moved('.map-host', 20, 0), 'map'],
  ['map 20 px down', moved('.map-host', 0, 20), 'map'],
  ['map buttons 20 px to the right', moved('.map-buttons', 20, 0), 'map buttons'],
  ['playback, timeline and curves 20 px down', moved('.bottom', 0, 20), 'playback'],
  ['curves 20 px to the right', moved('.curves-host', 20, 0), 'curves'],
];

// What draws letters otherwise, each more than another version of Chromium or of a font does.
const fonts: readonly (readonly [what: string, css: string])[] = [
  ['with serifs', ':root { --font: "DejaVu Serif", serif !important; }'],
  ['farther apart', '* { letter-spacing: 0.2px !important; }'],
  ['in their exact places', '* { text-rendering: geometricPrecision !important; }'],
];

describe.each(['light', 'dark'] as const)('%s', (theme) => {
  const other = theme === 'light' ? 'dark' : 'light';

  test('the page looks as in the stored picture', async () => {
    const opened = await scene(theme);
    if (renew) writeFileSync(stored(theme), writePng(shrunk(await settled(opened), 2)));
    const { found, picture } = await compared(opened, reference(theme), isAlike);
    if (isAlike(found)) return;
    mkdirSync(reports, { recursive: true });
    const [seen, difference] = ['seen', 'difference'].map((what) =>
      join(reports, `page-${theme}-${what}.png`),
    );
    writeFileSync(seen ?? '', writePng(picture));
    writeFileSync(difference ?? '', writePng(found.marked()));
    expect.fail(`not as in ${stored(theme)}: ${found.shares}; see ${seen} and ${difference}`);
  });

  test.each(fonts)('so it does where letters are drawn %s', async (_what, css) => {
    const opened = await scene(theme);
    await opened.page.addStyleTag({ content: css });
    const { found } = await compared(opened, reference(theme), isAlike);
    expect(found.unlike, found.shares).toEqual([]);
  });

  test('what is missing, shifted or of another colour is noticed', async () => {
    const opened = await scene(theme);
    const wanted = reference(theme);
    const notices = async (what: string, where: string): Promise<void> => {
      const { found } = await compared(opened, wanted, ({ unlike }) => unlike.includes(where));
      expect(found.unlike, `${what}: ${found.shares}`).toContain(where);
    };
    const isAgainAlike = async (): Promise<void> => {
      const { found } = await compared(opened, wanted, isAlike);
      expect(found.unlike, found.shares).toEqual([]);
    };
    // Where a part is does not depend on the theme, how well it is seen does.
    const made = theme === 'light' ? mistakes : mistakes.filter(([, css]) => css.includes('hidden'));
    for (const [what, css, where] of made) {
      const style = await opened.page.addStyleTag({ content: css });
      await notices(what, where);
      await style.evaluate((element) => element.parentNode?.removeChild(element));
    }
    await isAgainAlike();
    for (const key of '123456789') {
      await opened.page.keyboard.press(key);
      await notices(`layer ${key}`, 'map');
      await opened.page.keyboard.press(key);
    }
    await isAgainAlike();
    await opened.page.keyboard.press('d');
    for (const { name } of regions) await notices(`the theme ${other}`, name);
  });
});
