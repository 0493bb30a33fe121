// Where data comes from: a file, a bridge, and what happens when the bridge goes away.

import { describe, expect, test } from 'vitest';
import { expectNoErrors, foreignSite, joinPlayer, openLog, openPage, startBridge } from './harness';
import { caseId, collisionUs, messagesAt, sceneLog, times } from './scene';

describe('a log file', () => {
  test('is shown without a bridge and without a single request', async () => {
    const opened = await openLog(sceneLog());
    expect(
      await opened.state((s) => [s.events.length, s.collisions.length, s.durationUs, s.caseInfo?.caseId]),
    ).toEqual([6, 1, 4_000_000, caseId]);
    expect(opened.requests.filter((url) => !url.startsWith('file:') && !url.startsWith('blob:'))).toEqual([]);
    expectNoErrors(opened);
  });

  test('that is cut off is shown up to there, and says so', async () => {
    const log = sceneLog();
    const opened = await openLog(log.subarray(0, Math.floor(log.length / 2)));
    expect(await opened.state((s) => s.connection.error)).toMatch(/ends within a message/);
    expect(await opened.state((s) => s.toUs)).toBeGreaterThan(1_000_000);
    expectNoErrors(opened);
  });
});

describe('a bridge', () => {
  test('without a player: NO DATA, with the group and the packets seen', async () => {
    const bridge = await startBridge();
    const opened = await openPage(bridge.url);
    await opened.until((s) => s.connection.connected);
    expect(await opened.state((s) => s.badge)).toBe('NO DATA');
    await opened.page.getByText(`${bridge.group}: 0 packets`).waitFor();
    expectNoErrors(opened);
  });

  test('passes on what a player sends; a late page has the whole state', async () => {
    const bridge = await startBridge();
    const player = await joinPlayer(bridge);
    const first = await openPage(bridge.url);
    await first.until((s) => s.connection.connected);
    for (const [i, tUs] of times.entries()) await player.publish(...messagesAt(tUs, 4, times[i - 1] ?? -1));
    await first.until((s) => s.toUs === 4_000_000);
    expect(await first.state((s) => [s.badge, s.events.length, s.connection.lost])).toEqual(['REPLAY', 6, 0]);
    const late = await openPage(bridge.url);
    await late.until((s) => s.events.length === 6 && s.caseInfo && s.world && s.faults);
    expect(
      await late.state((s) => [s.caseInfo?.caseId, s.world?.anchors.length, s.faults?.items.length]),
    ).toEqual([caseId, 2, 1]);
    expectNoErrors(first);
    expectNoErrors(late);
  });

  test('that goes away: DISCONNECTED with a countdown, the last frame kept; back again, all is well', async () => {
    const bridge = await startBridge();
    const player = await joinPlayer(bridge);
    const opened = await openPage(bridge.url);
    await opened.until((s) => s.connection.connected);
    await player.publish(...messagesAt(0, 4, -1));
    await opened.until((s) => s.frame !== null);
    await bridge.kill();
    await opened.until((s) => s.badge === 'DISCONNECTED');
    expect(await opened.state((s) => s.frame?.objects.length)).toBe(4);
    await opened.page.getByText(/Disconnected from the bridge/).waitFor();
    await bridge.restart();
    await opened.until((s) => s.connection.connected);
    const next = times.findIndex((tUs) => tUs > collisionUs);
    for (const [i, tUs] of times.entries())
      if (i >= next) await player.publish(...messagesAt(tUs, 4, times[i - 1] ?? -1));
    await opened.until((s) => s.toUs === 4_000_000 && s.badge === 'REPLAY');
    // A refused connection is an error of the browser's own.
    expect(opened.errors.filter((line) => !/ERR_CONNECTION_REFUSED|WebSocket connection/.test(line))).toEqual(
      [],
    );
  });

  test('lists stored cases, and a page shows one', async () => {
    const bridge = await startBridge({ cases: { [caseId]: sceneLog() } });
    const opened = await openPage(bridge.url);
    await opened.until((s) => s.connection.connected);
    const choice = opened.page.locator('select[aria-label=Case]');
    await choice.focus();
    await choice.selectOption(caseId);
    await opened.until((s) => s.caseInfo !== null && s.events.length === 6);
    expect(await opened.state((s) => s.badge)).toBe('FILE');
    expectNoErrors(opened);
  });

  test('lets no foreign page in', async () => {
    const bridge = await startBridge();
    const { page } = await openPage(await foreignSite());
    const outcome = await page.evaluate(
      (port) =>
        new Promise((resolve) => {
          const socket = new WebSocket(`ws://127.0.0.1:${port}/ws`, 'viz.v1');
          socket.onopen = () => resolve('open');
          socket.onerror = () => resolve('refused');
        }),
      bridge.port,
    );
    expect(outcome).toBe('refused');
    const refused = () => bridge.lines.some((line) => line.includes('refused'));
    await bridge.said.until(refused, 'the line of the refusal');
    expect(bridge.lines.filter((line) => line.includes('refused'))).toEqual([
      expect.stringMatching(
        /^bridge: refused: WebSocket \/ws: Origin "http:\/\/127\.0\.0\.1:\d+" \(403 Forbidden\)$/,
      ),
    ]);
    const read = await page.evaluate(
      (url) =>
        fetch(url).then(
          () => 'read',
          () => 'refused',
        ),
      `${bridge.url}cases`,
    );
    expect(read).toBe('refused');
  });

  test('without control refuses what a page asks', async () => {
    const bridge = await startBridge();
    const opened = await openPage(bridge.url);
    await opened.until((s) => s.connection.connected);
    const answer = await opened.page.evaluate(
      (port) =>
        new Promise((resolve) => {
          const socket = new WebSocket(`ws://127.0.0.1:${port}/ws`, 'viz.v1');
          socket.onopen = () =>
            socket.send('{"seq":1,"verb":"stop_all","object":-1,"args":[],"text":"","token":"guessed"}');
          socket.onmessage = ({ data }) => {
            if (typeof data === 'string' && data.includes('refused')) resolve(data);
          };
        }),
      bridge.port,
    );
    expect(answer).toMatch(/control is off/);
    expectNoErrors(opened);
  });
});
