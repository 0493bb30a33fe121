import { expect, it } from 'vitest';
import { createViewer } from '../model/create_viewer';
import { aCase, aFrame, testWorld } from '../model/testing';
import { followFragment } from './follow_fragment';

const S = 1e6;

async function setUp(fragment: string, caseId = 'c') {
  const world = testWorld();
  world.log = [{ channel: 'VIZ_CASE', value: { ...aCase([0]), caseId } }];
  for (let i = 0; i <= 30; i++) world.log.push(aFrame(i * 0.1 * S));
  const viewer = createViewer(world);
  let hash = fragment;
  let changed = (): void => undefined;
  const loaded: string[] = [];
  let canLoad = true;
  const address = {
    read: () => hash,
    replace: (next: string) => {
      hash = next;
    },
    onChange: (callback: () => void) => {
      changed = callback;
    },
  };
  const load = async (id: string): Promise<void> => {
    loaded.push(id);
    if (!canLoad) throw new Error('no such case');
    world.log = world.log.map((message) =>
      message.channel === 'VIZ_CASE' ? { ...message, value: { ...message.value, caseId: id } } : message,
    );
    await viewer.openLog(new ArrayBuffer(0), id);
  };
  const notices: string[] = [];
  followFragment(viewer, address, load, world.later, (line) => notices.push(line));
  const go = (next: string): void => {
    hash = next;
    changed();
  };
  const settle = async (ms = 20): Promise<void> => {
    for (let i = 0; i < 5; i++) await Promise.resolve();
    world.pass(ms);
    for (let i = 0; i < 5; i++) await Promise.resolve();
    world.pass(20);
  };
  const refuse = (): void => {
    canLoad = false;
  };
  return {
    viewer,
    loaded,
    notices,
    go,
    settle,
    refuse,
    hash: () => hash,
    open: () => viewer.openLog(new ArrayBuffer(0), 'f'),
  };
}

it('goes to the moment and the observer of an address', async () => {
  const { viewer, open, settle, loaded } = await setUp('#t=1.500&obs=2');
  await open();
  await settle();
  expect([viewer.state.tUs, viewer.state.observer, loaded]).toEqual([1.5 * S, 2, []]);
});

it('loads the case of an address first, and only then goes to its moment', async () => {
  const { viewer, open, settle, loaded } = await setUp('#case=other&t=2.000&obs=2');
  await open();
  await settle();
  expect(loaded).toEqual(['other']);
  expect([viewer.state.caseInfo?.caseId, viewer.state.tUs]).toEqual(['other', 2 * S]);
});

it('does not wait for a player that is not there', async () => {
  const { viewer, settle, loaded } = await setUp('#case=other&t=2.000');
  await settle(1000);
  expect(loaded).toEqual([]);
  await settle(1000);
  expect([loaded, viewer.state.tUs]).toEqual([['other'], 2 * S]);
});

it('says that a case cannot be had, and leaves what is shown as it is', async () => {
  const { viewer, open, settle, refuse, loaded, notices, hash } = await setUp('#case=gone&t=1.000&obs=2');
  refuse();
  await open();
  viewer.play();
  await settle();
  expect([loaded, notices]).toEqual([['gone'], ['no case gone here']]);
  expect([viewer.state.playing, viewer.state.observer]).toEqual([true, 1]);
  expect(viewer.state.tUs).toBeLessThan(0.5 * S);
  viewer.pause();
  await settle();
  expect(hash()).toMatch(/^#case=c&t=0\.\d+&obs=1$/);
});

it('writes where it is, not while playing', async () => {
  const { viewer, open, settle, hash } = await setUp('');
  await open();
  await settle();
  viewer.seek(1.25 * S);
  await settle();
  expect(hash()).toBe('#case=c&t=1.250&obs=1');
  viewer.play();
  await settle(500);
  expect(hash()).toBe('#case=c&t=1.250&obs=1');
  viewer.pause();
  await settle();
  expect(hash()).not.toBe('#case=c&t=1.250&obs=1');
});

it('follows an address that the user changes', async () => {
  const { viewer, open, settle, go } = await setUp('');
  await open();
  await settle();
  go('#t=0.700');
  await settle();
  expect(viewer.state.tUs).toBe(0.7 * S);
});
