// The map: selecting, following, measuring, layers, themes.

import { beforeEach, describe, expect, test } from 'vitest';
import { drawn, expectNoErrors, type Opened, openLog } from './harness';
import { sceneLog } from './scene';

let opened: Opened;
const map = () => opened.page.getByRole('img', { name: /^Map/ });
const picture = (): Promise<Buffer> => opened.page.locator('.map-host').screenshot();

// The picture once it no longer changes.
async function settled(): Promise<Buffer> {
  await drawn(opened.page);
  let before = await picture();
  for (let i = 0; i < 100; i += 1) {
    await drawn(opened.page);
    const now = await picture();
    if (now.equals(before)) return now;
    before = now;
  }
  throw new Error('the map does not come to rest');
}

async function centre(): Promise<{ x: number; y: number }> {
  const box = await opened.page.locator('.map-host').boundingBox();
  if (!box) throw new Error('no map');
  return { x: box.x + box.width / 2, y: box.y + box.height / 2 };
}

beforeEach(async () => {
  opened = await openLog(sceneLog(6));
  for (let i = 0; i < 2; i += 1) await opened.page.keyboard.press('Shift+ArrowRight');
  await opened.until((s) => s.tUs === 2_000_000 && s.frame?.tUs === 2_000_000);
});

describe('the observer', () => {
  test('is chosen by keys, and the map follows it', async () => {
    await opened.page.keyboard.press('n');
    await opened.until((s) => s.observer === 2);
    await opened.page.keyboard.press('Shift+N');
    await opened.until((s) => s.observer === 1);
    await opened.page.keyboard.press('c');
    await opened.until((s) => s.followed);
  });

  test('is chosen by a click on the map, double click follows', async () => {
    const { x, y } = await centre();
    // Copter 2 to the centre, then away from it with the choice only.
    await opened.page.keyboard.press('n');
    await opened.page.keyboard.press('c');
    await settled();
    await opened.page.keyboard.press('c');
    await opened.page.keyboard.press('Shift+N');
    await opened.until((s) => s.observer === 1 && !s.followed);
    await opened.page.mouse.click(x, y);
    await opened.until((s) => s.observer === 2);
    await opened.page.mouse.dblclick(x, y);
    await opened.until((s) => s.observer === 2 && s.followed);
    expectNoErrors(opened);
  });

  test('is chosen in the table of objects, which says what the map shows', async () => {
    await opened.page.getByRole('tab', { name: 'Objects' }).click();
    const table = opened.page.getByRole('table');
    await table.getByRole('button', { name: 'Q3' }).click();
    await opened.until((s) => s.observer === 3);
    expect(await table.getByRole('row').count()).toBe(1 + 6);
  });
});

test('an object that is pinned keeps its curves and its mark when another is observed', async () => {
  const legend = opened.page.locator('.curves-host');
  await opened.page.getByRole('button', { name: 'Pin curves' }).click();
  await opened.until((s) => s.pinned.join() === '1');
  expect(await legend.getByText('Q1 position error').count()).toBe(1);
  await opened.page.keyboard.press('n');
  await opened.until((s) => s.observer === 2);
  await legend.getByText('Q2 position error').waitFor();
  await legend.getByText('Q1 position error').waitFor();
  await opened.page.getByRole('button', { name: 'Unpin object 1' }).click();
  await legend.getByText('Q1 position error').waitFor({ state: 'detached' });
});

describe('looking around', () => {
  test('dragging pans, the wheel zooms, F fits all again', async () => {
    await map().focus();
    await opened.page.keyboard.press('f');
    const before = await settled();
    const { x, y } = await centre();
    await opened.page.mouse.move(x, y);
    await opened.page.mouse.down();
    await opened.page.mouse.move(x + 80, y + 40, { steps: 4 });
    await opened.page.mouse.up();
    const panned = await settled();
    expect(panned.equals(before)).toBe(false);
    await opened.page.mouse.wheel(0, -300);
    expect((await settled()).equals(panned)).toBe(false);
    await opened.page.keyboard.press('f');
    await opened.page.mouse.move(0, 0);
    expect((await settled()).equals(before)).toBe(true);
  });

  test('shift and drag measure, Esc clears', async () => {
    await map().focus();
    const before = await settled();
    const { x, y } = await centre();
    await opened.page.keyboard.down('Shift');
    await opened.page.mouse.move(x - 100, y + 90);
    await opened.page.mouse.down();
    await opened.page.mouse.move(x + 100, y + 90, { steps: 4 });
    await opened.page.mouse.up();
    await opened.page.keyboard.up('Shift');
    await opened.page.mouse.move(0, 0);
    expect((await settled()).equals(before)).toBe(false);
    await opened.page.keyboard.press('Escape');
    expect((await settled()).equals(before)).toBe(true);
  });
});

describe('layers', () => {
  const names = ['grid', 'terrain', 'risk', 'comfort', 'trails', 'perceived', 'anchors', 'ranges', 'labels'];
  test.each(names.map((name, i) => [name, i + 1] as const))(
    '%s goes and comes with key %i',
    async (name, key) => {
      const box = opened.page.getByRole('checkbox', { name, exact: true });
      const [before, checked] = [await settled(), await box.isChecked()];
      await opened.page.keyboard.press(String(key));
      expect(await box.isChecked()).toBe(!checked);
      expect((await settled()).equals(before)).toBe(false);
      await opened.page.keyboard.press(String(key));
      expect((await settled()).equals(before)).toBe(true);
    },
  );
});

test('an object that has collided looks different from one that has not', async () => {
  await opened.page.keyboard.press('5'); // no trails
  await opened.page.keyboard.press('n');
  await opened.page.keyboard.press('c');
  await opened.page.keyboard.press('=');
  await opened.page.keyboard.press('=');
  const before = await settled();
  await opened.page.keyboard.press('End');
  expect((await settled()).equals(before)).toBe(false);
  expect(await map().getAttribute('aria-label')).toMatch(/Objects has the same data/);
});
