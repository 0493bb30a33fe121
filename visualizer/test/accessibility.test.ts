// The page without a mouse, without colours, in small windows, as a screen reader hears it.

import type { Page } from 'playwright-core';
import { describe, expect, test } from 'vitest';
import { expectNoErrors, openLog } from './harness';
import { focused, leastContrast, seenControls } from './on_page';
import { collisionUs, sceneLog } from './scene';

// Goes through the page by Tab until it comes round; answers what had the focus, in order.
async function walk(page: Page): Promise<{ what: string; visible: boolean }[]> {
  const met: { what: string; visible: boolean }[] = [];
  await page.evaluate(() => {
    (document.activeElement as HTMLElement | null)?.blur();
  });
  for (let steps = 0; steps < 300; steps++) {
    await page.keyboard.press('Tab');
    const now = await page.evaluate(focused);
    if (now !== null && now.what === met[0]?.what) return met;
    if (now !== null) met.push(now);
  }
  throw new Error('Tab does not come round');
}

interface AxNode {
  ignored: boolean;
  role?: { value?: unknown };
  name?: { value?: unknown };
  properties?: { name: string; value: { value?: unknown } }[];
}

async function accessibilityTree(page: Page): Promise<AxNode[]> {
  const session = await page.context().newCDPSession(page);
  const { nodes } = await session.send('Accessibility.getFullAXTree');
  return nodes.filter((node) => !node.ignored);
}

describe('without a mouse', () => {
  test('Tab reaches every control, and shows where it is', async () => {
    const opened = await openLog(sceneLog());
    const { page } = opened;
    for (const summary of await page.locator('summary').all()) await summary.click();
    const wanted = (await page.evaluate(seenControls)).map(({ what }) => what);
    const met = await walk(page);
    expect(wanted.length).toBeGreaterThan(40);
    expect(wanted.filter((what) => !met.some((one) => one.what === what))).toEqual([]);
    expect(met.filter(({ visible }) => !visible)).toEqual([]);
    expectNoErrors(opened);
  });

  test('a collision is found, looked at and measured by keys alone', async () => {
    const opened = await openLog(sceneLog());
    const { page, until, state } = opened;
    await page.keyboard.press(' ');
    await until((s) => s.playing && s.tUs > 100_000);
    await page.keyboard.press(' ');
    await until((s) => !s.playing);
    await page.keyboard.press('Home');
    await until((s) => s.tUs === 0);
    await page.keyboard.press('Shift+ArrowRight');
    await until((s) => s.tUs === 1_000_000);
    await page.keyboard.press('ArrowLeft');
    await until((s) => Math.abs(s.tUs - 900_000) < 1 && (s.frame?.tUs ?? Infinity) <= s.tUs);
    const before = await state((s) => s.frame?.seq ?? 0);
    await page.keyboard.press('.');
    await until(`(s) => s.frame?.seq === ${before + 1}`);
    await page.keyboard.press('End');
    await until((s) => s.tUs === 4_000_000);
    for (let presses = 0; presses < 9 && (await state((s) => s.tUs)) !== collisionUs; presses++) {
      await page.keyboard.press('[');
    }
    expect(await state((s) => s.tUs)).toBe(collisionUs);
    const observer = await state((s) => s.observer);
    await page.keyboard.press('n');
    await until(`(s) => s.observer !== -1 && s.observer !== ${observer}`);
    await page.keyboard.press('c');
    await until((s) => s.followed);
    await page.keyboard.press("'");
    await until((s) => s.speed === 2);
    await page.keyboard.press('l');
    await until((s) => s.loop !== null);
    expectNoErrors(opened);
  });

  test('keys typed into a field are text', async () => {
    const { page, state } = await openLog(sceneLog());
    const field = page.getByLabel('Start in');
    await field.focus();
    await page.keyboard.press('Control+A');
    await page.keyboard.type('1 d?n');
    expect(await field.inputValue()).toBe('1 d?n');
    expect(await state((s) => s.playing)).toBe(false);
    expect(await page.locator('dialog[open]').count()).toBe(0);
    expect(await page.locator('html').getAttribute('data-theme')).toBe('light');
  });

  test('? lists the keys; Escape closes the list', async () => {
    const { page } = await openLog(sceneLog());
    await page.keyboard.press('?');
    const dialog = page.getByRole('dialog', { name: 'Keys' });
    await dialog.waitFor();
    expect(await dialog.getByRole('row').count()).toBeGreaterThan(15);
    await page.keyboard.press('Escape');
    await dialog.waitFor({ state: 'hidden' });
  });
});

describe('a screen reader', () => {
  const spoken = [
    'button',
    'combobox',
    'textbox',
    'checkbox',
    'tab',
    'slider',
    'dialog',
    'table',
    'tabpanel',
  ];

  test('hears a name for everything that can be used', async () => {
    const { page } = await openLog(sceneLog());
    for (const summary of await page.locator('summary').all()) await summary.click();
    const nodes = await accessibilityTree(page);
    const used = nodes.filter((node) => spoken.includes(String(node.role?.value)));
    expect(used.length).toBeGreaterThan(50);
    expect(
      used.filter((node) => String(node.name?.value ?? '').trim() === '').map(({ role }) => role?.value),
    ).toEqual([]);
    const focusable = nodes.filter((node) =>
      node.properties?.some((p) => p.name === 'focusable' && p.value.value),
    );
    const named = focusable.filter((node) => node.role?.value !== 'RootWebArea');
    expect(named.filter((node) => ['generic', 'none', ''].includes(String(node.role?.value)))).toEqual([]);
  });

  test('finds banner, columns, time and a table with the objects of the map', async () => {
    const { page, state } = await openLog(sceneLog(6));
    await page.getByRole('alert').getByText('Collision · Quad 1 ↔ Quad 2').waitFor();
    for (const name of ['Case', 'Object and control'])
      await page.getByRole('complementary', { name }).waitFor();
    await page.getByRole('banner').waitFor();
    await page.getByRole('main').waitFor();
    await page.getByRole('slider').first().waitFor();
    await page.getByRole('tab', { name: 'Objects' }).click();
    const rows = page.getByRole('table').locator('tbody tr');
    await rows.nth(5).waitFor();
    const shown = await rows.allInnerTexts();
    const objects = await state((s) => (s.frame?.objects ?? []).map(({ id, pos }) => [id, pos[0], pos[1]]));
    expect(shown.map((row) => row.split(/\s+/).slice(0, 3))).toEqual(
      objects.map(([id, x, y]) => [`Q${id}`, Number(x).toFixed(2), Number(y).toFixed(2)]),
    );
  });

  test('the table is sorted by its heads and chooses the observer', async () => {
    const { page, until } = await openLog(sceneLog(6));
    await page.getByRole('tab', { name: 'Objects' }).click();
    const head = page.getByRole('columnheader', { name: 'x' });
    await head.getByRole('button').click();
    expect(await head.getAttribute('aria-sort')).toBe('ascending');
    const xs = (await page.locator('.objects tbody td:nth-child(2)').allInnerTexts()).map(Number);
    expect(xs).toEqual([...xs].sort((a, b) => a - b));
    await page.getByRole('button', { name: 'Q3', exact: true }).click();
    await until((s) => s.observer === 3);
  });
});

describe('in a small window', () => {
  test('the columns are drawers that open, close by Escape and leave the map free', async () => {
    const { page } = await openLog(sceneLog(), { viewport: { width: 1000, height: 700 } });
    const column = page.getByRole('complementary', { name: 'Object and control' });
    await column.waitFor({ state: 'hidden' });
    expect((await page.locator('.stage').boundingBox())?.width).toBe(1000);
    const toggle = page.getByRole('button', { name: 'Object and control' });
    await toggle.click();
    await column.waitFor();
    expect(await toggle.getAttribute('aria-expanded')).toBe('true');
    expect(await column.evaluate((drawer) => drawer.contains(document.activeElement))).toBe(true);
    await page.keyboard.press('Escape');
    await column.waitFor({ state: 'hidden' });
    expect(await toggle.getAttribute('aria-expanded')).toBe('false');
  });

  test.each([
    [800, 600],
    [1099, 700],
    [1100, 700],
    [1440, 900],
  ])('of %i x %i pixels nothing is cut off and every target is at least 24 pixels', async (width, height) => {
    const { page } = await openLog(sceneLog(), { viewport: { width, height } });
    const size = await page.evaluate(() => [
      document.documentElement.scrollWidth,
      document.documentElement.scrollHeight,
    ]);
    expect(size).toEqual([width, height]);
    const controls = await page.evaluate(seenControls);
    expect(controls.filter((control) => control.width < 24 || control.height < 24)).toEqual([]);
    const cut = await page.evaluate(() =>
      [...document.querySelectorAll('.header button, .transport button, .transport select')]
        .filter((one) => one.checkVisibility())
        .map((one) => ({ name: one.textContent, right: one.getBoundingClientRect().right }))
        .filter(({ right }) => right > window.innerWidth),
    );
    expect(cut).toEqual([]);
  });

  test('at 1440 x 900 the places have their sizes', async () => {
    const { page } = await openLog(sceneLog());
    const box = (selector: string) => page.locator(selector).boundingBox();
    expect((await box('.header'))?.height).toBe(44);
    expect((await box('.column.left'))?.width).toBe(268);
    expect((await box('.column.right'))?.width).toBe(300);
    expect((await box('.bottom'))?.height).toBe(286);
  });
});

describe.each(['light', 'dark'] as const)('where the system is %s', (colorScheme) => {
  const other = colorScheme === 'light' ? 'dark' : 'light';

  test('so is the page, until it is told otherwise, which it remembers', async () => {
    const { page } = await openLog(sceneLog(), { colorScheme });
    const theme = () => page.locator('html').getAttribute('data-theme');
    expect(await theme()).toBe(colorScheme);
    await page.keyboard.press('d');
    expect(await theme()).toBe(other);
    await page.reload();
    expect(await theme()).toBe(other);
  });

  test('all text can be read', async () => {
    const { page } = await openLog(sceneLog(), { colorScheme });
    for (const tab of ['Commands', 'Objects', 'Events']) {
      await page.getByRole('tab', { name: tab }).click();
      const { ratio, text } = await page.evaluate(leastContrast);
      expect(ratio, text).toBeGreaterThanOrEqual(4.5);
    }
  });
});

test('with less motion nothing slides, and nothing plays by itself', async () => {
  const { page, state } = await openLog(sceneLog(), { reducedMotion: 'reduce' });
  expect(
    await page.locator('.column.left').evaluate((column) => getComputedStyle(column).transitionDuration),
  ).toBe('0s');
  expect(await state((s) => s.playing)).toBe(false);
});
