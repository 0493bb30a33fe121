// The tools of LCM itself: lcm-logger records what is published, lcm-logplayer plays it, the page shows the same.

import { spawn } from 'node:child_process';
import { closeSync, openSync, readFileSync, readSync, statSync, watch, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { expect, test } from 'vitest';
import { Changes } from '../bridge/testing';
import { readLog } from '../codec/log';
import type { Message } from '../codec/messages';
import { atEnd, expectNoErrors, joinPlayer, openPage, startBridge, temporaryFolder } from './harness';
import { encodeMessage } from '../codec/viz';
import { frame, messagesAt, risk, sceneLog, times } from './scene';

test('lcm-logplayer: the page shows the last frame of the log, and all events', async () => {
  const bridge = await startBridge();
  const opened = await openPage(bridge.url);
  await opened.until((s) => s.connection.connected);
  const log = join(temporaryFolder(), 'run.lcm');
  writeFileSync(log, sceneLog());
  const player = spawn('lcm-logplayer', [`--lcm-url=udpm://${bridge.group}?ttl=0`, '--speed=4', log], {
    stdio: 'ignore',
  });
  atEnd(() => void player.kill());
  await opened.until((s) => s.toUs === 4_000_000 && s.events.length === 6);
  await opened.page.getByLabel('stop at collision').uncheck();
  await opened.page.keyboard.press('End');
  await opened.until((s) => s.frame?.tUs === 4_000_000);
  const shown = await opened.state((s) => s.frame);
  expect(shown).toEqual(rounded(frame(4_000_000, 4)));
  expect(await opened.state((s) => s.connection.lost)).toBe(0);
  expectNoErrors(opened);
});

test('lcm-logger: records every message, with the same bytes', async () => {
  const bridge = await startBridge();
  const player = await joinPlayer(bridge);
  const folder = temporaryFolder();
  const log = join(folder, 'recorded.lcm');
  const members = membersOfGroup();
  const logger = spawn(
    'lcm-logger',
    [`--lcm-url=udpm://${bridge.group}?ttl=0&recv_buf_size=2097152`, '--flush-interval=1', log],
    { stdio: 'ignore' },
  );
  atEnd(() => void logger.kill());
  const ended = new Promise((resolve) => logger.once('exit', resolve));
  const written = new Changes();
  const watcher = watch(folder, () => written.changed());
  atEnd(() => watcher.close());
  const running = (): boolean => logger.exitCode === null;
  // What it has heard goes to the disk with a message that comes a millisecond later or more: this one, again and again.
  const untilWritten = async (look: () => boolean, again: Message): Promise<void> => {
    while (running() && !look()) {
      await player.publish(again);
      await written.until(look, 'lcm-logger', 10).catch(() => undefined);
    }
  };
  while (running() && membersOfGroup() === members) await new Promise((resolve) => setImmediate(resolve));
  // Once it is a member it still tests the network; what it hears of ours it writes.
  await untilWritten(() => endOf(log, 1).length > 0, { channel: 'VIZ_FRAME', value: frame(0, 4) });
  // It keeps few messages that wait: each moment's are sent when those before have been written.
  for (const [i, tUs] of times.entries()) {
    await player.publish(...messagesAt(tUs, 4, times[i - 1] ?? -1));
    const last = Buffer.from(encodeMessage({ channel: 'VIZ_RISK', value: risk(tUs, 4) }));
    await untilWritten(() => endOf(log, 16_384).includes(last), {
      channel: 'VIZ_FRAME',
      value: frame(tUs, 4),
    });
  }
  logger.kill('SIGINT');
  await ended;
  const recorded = readLog(readFileSync(log));
  expect(recorded.problem).toBe('');
  const wanted = readLog(sceneLog()).messages.filter(({ channel }) => channel !== 'VIZ_STATUS');
  const bytes = new Set(
    recorded.messages.map(({ channel, data }) => channel + Buffer.from(data).toString('hex')),
  );
  const missing = wanted.filter(
    ({ channel, data }) => !bytes.has(channel + Buffer.from(data).toString('hex')),
  );
  expect(missing.length).toBe(0);
});

// How many sockets of this network namespace have joined the group of LCM.
function membersOfGroup(): number {
  const group = '434CFFEF'; // 239.255.76.67, as a little-endian machine prints it
  const line = readFileSync('/proc/net/igmp', 'utf8')
    .split('\n')
    .find((one) => one.includes(group));
  return Number(line?.trim().split(/\s+/)[1] ?? 0);
}

// The last bytes of a file, none of one that is not there yet.
function endOf(file: string, count: number): Buffer {
  const size = statSync(file, { throwIfNoEntry: false })?.size ?? 0;
  const bytes = Buffer.alloc(Math.min(size, count));
  if (bytes.length === 0) return bytes;
  const open = openSync(file, 'r');
  readSync(open, bytes, 0, bytes.length, size - bytes.length);
  closeSync(open);
  return bytes;
}

// As 32-bit numbers hold it.
function rounded<T>(value: T): T {
  return JSON.parse(JSON.stringify(value), (_, member: unknown) =>
    typeof member === 'number' ? Math.fround(member) : member,
  ) as T;
}
