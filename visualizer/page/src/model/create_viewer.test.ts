import { describe, expect, it } from 'vitest';
import { createViewer } from './create_viewer';
import { aCase, aFrame, anEvent, anObject, aRisk, aStatus, testWorld } from './testing';
import type { Topic } from './viewer';

const S = 1e6;

async function fileViewer() {
  const world = testWorld();
  world.log = [{ channel: 'VIZ_CASE', value: aCase([0, 1 * S, 2 * S]) }];
  for (let i = 0; i <= 30; i++) world.log.push(aFrame(i * 0.1 * S));
  world.log.push({ channel: 'VIZ_RISK', value: aRisk(2, 0) });
  const collision = anEvent({ kind: 'collision', seq: 1, tUs: 1.5 * S, a: 1, b: 2 });
  world.log.push({ channel: 'VIZ_EVENT', value: collision });
  const viewer = createViewer(world);
  await viewer.openLog(new ArrayBuffer(0), 'run.lcm');
  world.pass(10);
  return { world, viewer };
}

function liveViewer(mode = 1) {
  const world = testWorld();
  const viewer = createViewer(world);
  viewer.connect('ws://x');
  world.listener?.connection({ connected: true });
  world.listener?.granted(true);
  world.listener?.message({ channel: 'VIZ_STATUS', value: aStatus({ mode, durationUs: 9 * S }) });
  for (let i = 0; i <= 20; i++) world.listener?.message(aFrame(i * 0.1 * S));
  world.pass(10);
  return { world, viewer };
}

describe('a file', () => {
  it('shows its start, its case and the observer whose contours it holds', async () => {
    const { viewer } = await fileViewer();
    const { badge, tUs, toUs, durationUs, observer, currentCommand, failingCommand } = viewer.state;
    expect({ badge, tUs, toUs, durationUs, observer, currentCommand, failingCommand }).toEqual({
      badge: 'FILE',
      tUs: 0,
      toUs: 3 * S,
      durationUs: 3 * S,
      observer: 2,
      currentCommand: 0,
      failingCommand: 1,
    });
    expect(viewer.state.risk).toEqual(aRisk(2, 0));
    expect(viewer.state.controlAllowed).toBe(false);
  });

  it('plays in wall time and stops at the collision', async () => {
    const { world, viewer } = await fileViewer();
    viewer.play();
    world.pass(1000);
    expect(viewer.state.tUs / S).toBeCloseTo(1, 1);
    expect(viewer.state.frame?.tUs).toBe(Math.floor(viewer.state.tUs / (0.1 * S) + 1e-9) * 0.1 * S);
    world.pass(1000);
    expect([viewer.state.tUs, viewer.state.playing]).toEqual([1.5 * S, false]);
  });

  it('shows a collision from a second before', async () => {
    const { viewer } = await fileViewer();
    viewer.showCollision(0);
    expect(viewer.state.tUs).toBe(0.5 * S);
  });

  it('refuses what has no frame, and keeps what was shown', async () => {
    const { world, viewer } = await fileViewer();
    world.log = [];
    await expect(viewer.openLog(new ArrayBuffer(0), 'b.lcm')).rejects.toThrow('b.lcm: a log without any');
    expect(viewer.state.connection.fileName).toBe('run.lcm');
    expect(viewer.state.toUs).toBe(3 * S);
  });

  it('gives back what it holds in order of time', async () => {
    const { viewer } = await fileViewer();
    const held = viewer.held();
    const times = held.slice(1).map((message) => ('tUs' in message.value ? message.value.tUs : NaN));
    expect(held[0]?.channel).toBe('VIZ_CASE');
    expect(times).toEqual([...times].sort((a, b) => a - b));
    expect(held.filter((message) => message.channel === 'VIZ_FRAME')).toHaveLength(31);
  });

  it('tells listeners at most once an animation frame, and no more once they left', async () => {
    const { world, viewer } = await fileViewer();
    const heard: Topic[][] = [];
    const leave = viewer.listen((changed) => heard.push([...changed].sort()));
    viewer.seek(1 * S);
    viewer.pin(1, true);
    expect(heard).toEqual([]);
    world.pass(10);
    expect(heard).toEqual([['playback', 'selection', 'time']]);
    leave();
    viewer.seek(2 * S);
    world.pass(10);
    expect(heard).toHaveLength(1);
  });
});

describe('live', () => {
  it('follows the trailing edge; scrubbing back says how far behind; back to live', () => {
    const { world, viewer } = liveViewer();
    expect([viewer.state.badge, viewer.state.tUs, viewer.state.following]).toEqual(['LIVE', 2 * S, true]);
    viewer.seek(0.5 * S);
    world.pass(10);
    expect(viewer.state.following).toBe(false);
    expect(viewer.state.behindS).toBeCloseTo(1.5, 1);
    viewer.toLive();
    expect([viewer.state.following, viewer.state.behindS]).toEqual([true, 0]);
    expect(world.sent).toEqual([]);
  });

  it('starts anew with a new run and drops what is late', () => {
    const { world, viewer } = liveViewer();
    viewer.observe(2);
    world.listener?.message(aFrame(0.3 * S, [anObject(2), anObject(5)], 2));
    world.listener?.message(aFrame(9 * S, [anObject(1)], 1));
    world.pass(10);
    expect([viewer.state.run, viewer.state.toUs, viewer.state.tUs]).toEqual([2, 0.3 * S, 0.3 * S]);
    expect(viewer.state.observer).toBe(2);
  });

  it('becomes stale, then disconnected, and keeps what it holds', () => {
    const { world, viewer } = liveViewer();
    world.pass(1500);
    expect(viewer.state.badge).toBe('STALE');
    expect(viewer.state.badgeAgeS).toBeGreaterThan(1.4);
    world.listener?.connection({ connected: false, retryInS: 0.5 });
    expect(viewer.state.badge).toBe('DISCONNECTED');
    expect(viewer.state.frame?.tUs).toBe(2 * S);
    viewer.seek(1 * S);
    world.pass(10);
    expect(viewer.state.frame?.tUs).toBe(1 * S);
  });

  it('plays what it holds while disconnected, and follows again once it is back', () => {
    const { world, viewer } = liveViewer();
    world.listener?.connection({ connected: false, retryInS: 0.5 });
    world.listener?.granted(false);
    viewer.seek(1.5 * S);
    viewer.pause();
    viewer.play();
    world.pass(300);
    expect(viewer.state.tUs / S).toBeCloseTo(1.8, 1);
    world.pass(500);
    expect([viewer.state.tUs, viewer.state.playing]).toEqual([2 * S, false]);
    world.listener?.connection({ connected: true });
    world.listener?.message(aFrame(2.1 * S));
    viewer.toLive();
    world.pass(10);
    expect([viewer.state.tUs, viewer.state.badge]).toEqual([2.1 * S, 'LIVE']);
  });

  it('resumes a live flight that was paused', () => {
    const { world, viewer } = liveViewer();
    const says = (paused: boolean) =>
      world.listener?.message({ channel: 'VIZ_STATUS', value: aStatus({ mode: 1, paused }) });
    says(false);
    viewer.pause();
    says(true);
    world.pass(50);
    viewer.play();
    expect(world.sent.map((control) => control.verb)).toEqual(['pause', 'play']);
    says(false);
    world.listener?.message(aFrame(2.1 * S));
    world.pass(10);
    expect([viewer.state.playing, viewer.state.tUs]).toEqual([true, 2.1 * S]);
  });

  it('a replay that had ended: its beginning, and a collision, can be had', () => {
    const world = testWorld();
    const viewer = createViewer(world);
    viewer.connect('ws://x');
    world.listener?.connection({ connected: true });
    world.listener?.granted(true);
    const ended = aStatus({ paused: true, verdict: 2, tUs: 8 * S, durationUs: 8 * S });
    world.listener?.message({ channel: 'VIZ_STATUS', value: ended });
    world.listener?.message(aFrame(8 * S));
    const collision = anEvent({ kind: 'collision', seq: 1, tUs: 3 * S, a: 1, b: 2 });
    world.listener?.message({ channel: 'VIZ_EVENT', value: collision });
    world.pass(200);
    expect(viewer.state.startUs).toBe(0);
    viewer.showCollision(0);
    viewer.play();
    expect(world.sent.map(({ verb, args }) => [verb, ...args])).toEqual([['seek', 2], ['restart'], ['play']]);
  });

  it('sends at most one seek in 150 ms, and the last one in any case', () => {
    const { world, viewer } = liveViewer(2);
    for (let i = 0; i < 20; i++) {
      viewer.seek((3 + i * 0.1) * S);
      world.pass(10);
    }
    world.pass(500);
    const seeks = world.sent.filter((control) => control.verb === 'seek');
    expect(seeks.length).toBeLessThanOrEqual(4);
    expect(seeks[seeks.length - 1]?.args).toEqual([((3 + 19 * 0.1) * S) / S]);
  });

  it('resolves a control with the answer to it', async () => {
    const { world, viewer } = liveViewer();
    const answer = viewer.control('steer', 1, [0, 0.1, 0]);
    const seq = world.sent[0]?.seq ?? -1;
    expect(world.sent).toEqual([{ seq: 7, verb: 'steer', object: 1, args: [0, 0.1, 0], text: '' }]);
    viewer.feed({ channel: 'VIZ_ACK', value: { client: 'b', seq: seq + 1, ok: false, text: 'other' } }, 0);
    viewer.feed({ channel: 'VIZ_ACK', value: { client: 'a', seq, ok: true, text: '' } }, 0);
    expect((await answer).ok).toBe(true);
  });

  it('gives a control up after a second without answer', async () => {
    const { world, viewer } = liveViewer();
    const answer = viewer.control('steer', 1, [0, 0.1, 0]);
    world.pass(1300);
    expect((await answer).text).toContain('no answer');
  });

  it('asks a player that was killed and came back for what it showed', async () => {
    const { world, viewer } = liveViewer(2);
    const lines: string[] = [];
    viewer.onRefusal((line) => lines.push(line));
    const says = (run: number) => ({ mode: 2, paused: true, speed: 0.5, run, durationUs: 9 * S });
    world.listener?.message({ channel: 'VIZ_CASE', value: aCase([0, 1 * S]) });
    world.listener?.message({ channel: 'VIZ_STATUS', value: aStatus(says(1)) });
    viewer.seek(1.5 * S);
    viewer.setSpeed(0.5);
    world.pass(2000);
    world.sent.length = 0;
    world.listener?.message({ channel: 'VIZ_STATUS', value: aStatus(says(700)) });
    for (let i = 0; i < 4; i++) {
      const seq = world.sent[i]?.seq ?? -1;
      world.listener?.message({ channel: 'VIZ_ACK', value: { client: 'a', seq, ok: true, text: '' } });
      for (let turn = 0; turn < 5; turn++) await Promise.resolve();
    }
    expect(world.sent.map(({ verb, args, text }) => [verb, args, text])).toEqual([
      ['load', [1], 'c'],
      ['speed', [0.5], ''],
      ['pause', [], ''],
      ['seek', [1.5], ''],
    ]);
    expect(lines[0]).toBe('player restarted');
  });

  it('asks nothing when the same player begins another run', () => {
    const { world } = liveViewer(2);
    world.listener?.message({ channel: 'VIZ_CASE', value: aCase([0]) });
    world.pass(2000);
    world.listener?.message({ channel: 'VIZ_STATUS', value: aStatus({ run: 2 }) });
    expect(world.sent).toEqual([]);
  });

  it('tells of a refused seek, and does not send without control', async () => {
    const { world, viewer } = liveViewer(2);
    world.listener?.granted(false);
    const lines: string[] = [];
    viewer.onRefusal((line) => lines.push(line));
    viewer.seek(7 * S);
    viewer.pause();
    await Promise.resolve();
    await Promise.resolve();
    expect(lines).toEqual(['seek: the bridge was started without --allow-control']);
    expect(world.sent).toEqual([]);
  });
});
