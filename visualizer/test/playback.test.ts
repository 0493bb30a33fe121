// Playing what the page holds: speed, single frames, seeking, events, loop, the stop at a collision.

import { beforeEach, describe, expect, test } from 'vitest';
import { expectNoErrors, limitMs, type Opened, openLog } from './harness';
import { collisionUs, endUs, sceneLog, times } from './scene';

let opened: Opened;
const at = (): Promise<number> => opened.state((s) => s.tUs);
const play = (): Promise<void> => opened.page.getByRole('button', { name: 'Play (Space)' }).click();
const press = (key: string): Promise<void> => opened.page.keyboard.press(key);

beforeEach(async () => {
  opened = await openLog(sceneLog());
  expect(await opened.state((s) => [s.tUs, s.playing])).toEqual([0, false]);
});

// Simulated seconds for one of wall time, looked at within the page from fromUs on. null when the page got no animation
// frame for so long that this does not count as playing.
const measuredSpeed = (fromUs: number, ms: number): string => `new Promise((resolve) => {
  const look = () => ({ wall: performance.now(), sim: window.__viz.state().tUs / 1000 });
  let from = null;
  let before = look();
  let gap = 0;
  const ask = () => {
    const now = look();
    gap = Math.max(gap, now.wall - before.wall);
    before = now;
    if (from === null && now.sim > ${fromUs / 1000}) from = now;
    if (from === null || now.wall - from.wall < ${ms}) requestAnimationFrame(ask);
    else resolve(gap > 200 ? null : (now.sim - from.sim) / (now.wall - from.wall));
  };
  ask();
})`;

describe('playing', () => {
  test.each([0.25, 0.5, 1, 2])('at speed %f goes that fast, within 5 % of wall time', async (speed) => {
    await opened.page.getByLabel('Speed').selectOption(String(speed));
    let factor: number | null = null;
    for (let tries = 0; tries < 10 && factor === null; tries += 1) {
      await press('End'); // where it stops by itself
      await opened.until((s) => !s.playing);
      await press('Home');
      await opened.until((s) => s.tUs === 0);
      const measured = opened.page.evaluate<number | null>(measuredSpeed(50_000, 1200));
      await play();
      factor = await measured;
    }
    if (factor === null) throw new Error('the page gets no animation frames in time');
    expect(factor / speed).toBeGreaterThan(0.95);
    expect(factor / speed).toBeLessThan(1.05);
    expectNoErrors(opened);
  });

  test('stops where objects collide, and goes on when asked again', async () => {
    await opened.page.getByLabel('Speed').selectOption('5');
    await press('Space');
    await opened.until((s) => !s.playing && s.tUs > 0);
    expect(await at()).toBe(collisionUs);
    await press('Space');
    await opened.until((s) => !s.playing && s.tUs > 3_500_000);
    expect(await at()).toBe(endUs);
  });

  test('does not stop there when told so', async () => {
    await opened.page.getByLabel('stop at collision').uncheck();
    await opened.page.getByLabel('Speed').selectOption('5');
    await play();
    await opened.until((s) => !s.playing && s.tUs > 0);
    expect(await at()).toBe(endUs);
  });

  test('in a loop begins again', async () => {
    await opened.page.getByLabel('stop at collision').uncheck();
    await opened.page.getByLabel('Speed').selectOption('10');
    await press('l');
    await play();
    await opened.until((s) => s.tUs > 2_000_000);
    await opened.until((s) => s.playing && s.tUs < 1_500_000);
  });
});

describe('moving in time', () => {
  test('one frame on and back', async () => {
    await press('.');
    await opened.until((s) => s.frame?.seq === 1);
    expect(await at()).toBe(times[1]);
    await press('.');
    await press(',');
    await opened.until((s) => s.frame?.seq === 1);
  });

  test('0.1 s and, with shift, 1 s; to the end and the start', async () => {
    await press('ArrowRight');
    expect(await at()).toBe(100_000);
    await press('Shift+ArrowRight');
    expect(await at()).toBe(1_100_000);
    await press('ArrowLeft');
    expect(await at()).toBe(1_000_000);
    await press('End');
    expect(await at()).toBe(endUs);
    await press('Home');
    expect(await at()).toBe(0);
  });

  test('from event to event', async () => {
    const seen: number[] = [];
    for (let i = 0; i < 3; i += 1) {
      await press(']');
      seen.push(await at());
    }
    expect(seen).toEqual([1_000_000, 2_000_000, collisionUs]);
    await press('[');
    expect(await at()).toBe(2_000_000);
  });

  test('by dragging on the timeline; the shown frame is that of the moment', async () => {
    const slider = opened.page.getByRole('slider', { name: 'Time' });
    const box = await slider.boundingBox();
    if (!box) throw new Error('no timeline');
    const { mouse } = opened.page;
    await mouse.move(box.x + box.width * 0.3, box.y + box.height / 2);
    await mouse.down();
    await mouse.move(box.x + box.width * 0.6, box.y + box.height / 2, { steps: 5 });
    await mouse.up();
    const tUs = await at();
    expect(tUs).toBeGreaterThan(1_500_000);
    expect(tUs).toBeLessThan(endUs);
    await opened.until((s) => s.frame !== null && Math.abs(s.frame.tUs - s.tUs) < 20_000);
    const told = async () => Number(await slider.getAttribute('aria-valuenow'));
    await expect.poll(told, { timeout: limitMs }).toBeCloseTo(tUs / 1e6, 1);
    expect(await slider.getAttribute('aria-valuetext')).toMatch(/\d/);
  });

  test('by a click on a command', async () => {
    await opened.page.getByRole('button', { name: /3 2\.00 iterate/ }).click();
    expect(await at()).toBe(2_000_000);
    expect(await opened.state((s) => s.currentCommand)).toBe(2);
  });

  test('by the button of the collision banner: to 1 s before', async () => {
    await opened.page.getByRole('alert').getByRole('button', { name: 'Show' }).click();
    await opened.until((s) => s.tUs === 2_000_000);
  });
});
