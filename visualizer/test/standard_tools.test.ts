// The tools of LCM itself: lcm-logger records what is published, lcm-logplayer plays it, the page shows the same.

import { spawn } from 'node:child_process';
import { existsSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { expect, test } from 'vitest';
import { readLog } from '../codec/log';
import { atEnd, expectNoErrors, joinPlayer, openPage, startBridge, temporaryFolder } from './harness';
import { frame, frameHz, messagesAt, sceneLog, times } from './scene';

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
  const log = join(temporaryFolder(), 'recorded.lcm');
  const logger = spawn('lcm-logger', [`--lcm-url=udpm://${bridge.group}?ttl=0&recv_buf_size=2097152`, log], {
    stdio: 'ignore',
  });
  atEnd(() => void logger.kill());
  // It is listening once it has written something.
  const hello = messagesAt(0, 4, -1);
  const pause = (ms: number): Promise<void> => new Promise((resolve) => setTimeout(resolve, ms));
  while (!existsSync(log) || readFileSync(log).length === 0) {
    await player.publish(...hello);
    await pause(10);
  }
  // As fast as the flight: the logger keeps few messages that wait.
  for (const [i, tUs] of times.entries()) {
    if (i > 0) await player.publish(...messagesAt(tUs, 4, times[i - 1] ?? -1));
    await pause(1000 / frameHz);
  }
  const ended = new Promise((resolve) => logger.once('exit', resolve));
  const last = Buffer.from(readLog(sceneLog()).messages.at(-1)?.data ?? []);
  // It writes to the disk when another message comes.
  while (!readFileSync(log).includes(last)) {
    await player.publish(...hello);
    await pause(20);
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

// As 32-bit numbers hold it.
function rounded<T>(value: T): T {
  return JSON.parse(JSON.stringify(value), (_, member: unknown) =>
    typeof member === 'number' ? Math.fround(member) : member,
  ) as T;
}
