import { describe, expect, test } from 'vitest';
import type { Hello } from '../codec/protocol';
import type { Message, Status, VizEvent } from '../codec/messages';
import { sampleFrame, sampleMessages } from '../codec/samples';
import { startBridge } from './testing';

const event = (seq: number, run = 1, text = `event ${seq}`): Message => ({
  channel: 'VIZ_EVENT',
  value: { tUs: seq, run, seq, kind: 'log', a: -1, b: -1, x: 0, y: 0, text } satisfies VizEvent,
});
const status = (run: number): Message => ({
  channel: 'VIZ_STATUS',
  value: {
    mode: 2,
    paused: false,
    speed: 1,
    tUs: 0,
    durationUs: -1,
    run,
    verdict: 0,
    controlAllowed: false,
    message: '',
  } satisfies Status,
});
const frame = (count: number, seq: number): Message => ({
  channel: 'VIZ_FRAME',
  value: sampleFrame(count, seq),
});

describe('messages on their way to pages', () => {
  test('come as they were sent, fragments put together', async () => {
    await using bridge = await startBridge();
    const page = await bridge.page();
    const large = frame(1000, 1); // 78 kB: two packets
    await bridge.publish(...sampleMessages, large);
    await page.count(sampleMessages.length + 1);
    expect(page.messages()).toEqual([...sampleMessages, large]);
  });

  test('come from a multicast group too', async () => {
    await using bridge = await startBridge({
      group: (port) => ({
        host: '239.255.76.67',
        port,
        multicast: true,
        ttl: 0,
        receiveBuffer: 2 ** 21,
        network: false,
      }),
    });
    const page = await bridge.page();
    await bridge.publish(event(1));
    await page.count(1);
    expect(page.messages()).toEqual([event(1)]);
  });

  test('the first is the hello', async () => {
    await using bridge = await startBridge();
    const [hello] = (await bridge.page()).texts as unknown as Hello[];
    expect(hello).toMatchObject({ v: 1, control: false, token: null, client: 'page-1' });
    expect(hello?.channels.VIZ_CASE).toBe('viz.case_info');
  });

  test('a late page gets the newest world, case, faults and status, and all events of the run', async () => {
    await using bridge = await startBridge();
    const witness = await bridge.page();
    const kept = sampleMessages.filter(({ channel }) => /WORLD|CASE|FAULTS/.test(channel));
    await bridge.publish(
      event(1, 1),
      event(2, 1),
      ...kept,
      ...kept,
      status(7),
      event(1, 7),
      event(2, 7),
      status(7),
    );
    await witness.count(2 + 6 + 4);
    const late = await bridge.page();
    await late.count(6);
    expect(late.messages()).toEqual([
      ...['VIZ_WORLD', 'VIZ_CASE', 'VIZ_FAULTS'].map((name) => kept.find(({ channel }) => channel === name)),
      status(7),
      event(1, 7),
      event(2, 7),
    ]);
  });

  test('an event that is told again counts once', async () => {
    await using bridge = await startBridge();
    const witness = await bridge.page();
    await bridge.publish(event(1, 7), event(2, 7), event(1, 7), event(2, 7), event(3, 7), event(1, 7));
    await witness.count(6);
    const late = await bridge.page();
    await late.count(3);
    await bridge.publish(event(4, 7));
    await late.count(4);
    expect(late.messages()).toEqual([event(1, 7), event(2, 7), event(3, 7), event(4, 7)]);
  });

  test('statistics come each second: messages, and what is missing by the numbers of the sender', async () => {
    await using bridge = await startBridge();
    const page = await bridge.page();
    const numbered = (n: number): Uint8Array =>
      Uint8Array.from([0x4c, 0x43, 0x30, 0x32, 0, 0, 0, n, 65, 0, 1, 2, 3]);
    for (const n of [1, 2, 5]) await bridge.datagram(numbered(n));
    expect(await page.text('stats')).toEqual({ udp: 3, lost: 2, dropped: 0, bytesPerSec: 9 });
    expect(page.binary).toEqual([]); // a channel that is not ours goes nowhere
  });

  test('what pages ask of the player, with its token, is never passed to pages', async () => {
    await using bridge = await startBridge();
    const page = await bridge.page();
    const packet = Buffer.concat([
      Buffer.from('4c43303200000001', 'hex'),
      Buffer.from('VIZ_CONTROL\0secret'),
    ]);
    await bridge.datagram(packet);
    await bridge.publish(event(1));
    await page.count(1);
    expect(page.messages()).toEqual([event(1)]);
  });
});

describe('pages that read slowly', () => {
  test('lose frames, of which they get the newest, and no event; the others lose nothing', async () => {
    await using bridge = await startBridge();
    const slow = await bridge.page();
    const quick = await bridge.page();
    slow.socket.pause();
    const frames = 400; // 31 MB: more than the sockets' buffers and 1 MiB hold
    for (let seq = 1; seq <= frames; seq += 1) {
      await bridge.publish(frame(1000, seq), event(seq));
      await quick.count(2 * seq);
    }
    slow.socket.resume();
    const of = (channel: string): Uint8Array[] =>
      slow.binary.filter((bytes) => String(bytes.subarray(1, 1 + channel.length)) === channel);
    await slow.until(() => of('VIZ_EVENT').length === frames, 'all events', 15_000);
    const seqOf = (bytes: Uint8Array | undefined): number | undefined =>
      bytes && Buffer.from(bytes).readInt32BE(30);
    await slow.until(() => seqOf(of('VIZ_FRAME').at(-1)) === frames, 'the newest frame', 15_000);
    const seen = of('VIZ_FRAME').length;
    expect(seen).toBeLessThan(frames);
    const dropped = (): number | undefined =>
      slow.texts
        .map(({ stats }) => (stats as { dropped: number } | undefined)?.dropped)
        .findLast((n) => n !== undefined);
    await slow.until(() => dropped() === frames - seen, 'statistics');
  }, 30_000);

  test('a hundred pages get every event', async () => {
    await using bridge = await startBridge();
    const pages = await Promise.all(Array.from({ length: 100 }, () => bridge.page()));
    const events = Array.from({ length: 20 }, (_, i) => event(i));
    await bridge.publish(...events);
    await Promise.all(pages.map((page) => page.count(20)));
    expect(pages.map((page) => page.messages())).toEqual(pages.map(() => events));
  });
});

describe('control', () => {
  const token = '0123456789abcdef'.repeat(4);
  const seek = { seq: 5, verb: 'seek', object: -1, args: [7.42], text: '', token };

  test('a request goes to the player with token and name of the page; the answer comes back', async () => {
    await using bridge = await startBridge({ token });
    const page = await bridge.page();
    expect(page.texts[0]).toMatchObject({ control: true, token });
    await bridge.publish(status(1));
    await page.count(1);
    page.send(seek);
    await bridge.heard.until(() => bridge.controls.length > 0, 'control');
    expect(bridge.controls).toEqual([{ ...seek, client: 'page-1' }]);
    await bridge.publish({ channel: 'VIZ_ACK', value: { client: 'page-1', seq: 5, ok: true, text: '' } });
    await page.count(2);
    expect(page.messages()[1]).toMatchObject({ channel: 'VIZ_ACK', value: { client: 'page-1', seq: 5 } });
  });

  test.each([
    ['without a token', { ...seek, token: undefined }, -1, 'token: expected a string'],
    ['with a wrong token', { ...seek, token: 'x' }, 5, 'a wrong token: load the page again'],
    ['with an unknown verb', { ...seek, verb: 'explode' }, 5, /^verb: expected one of/],
    ['out of range', { ...seek, args: [-1] }, 5, /^seek: seconds: expected a number from 0/],
  ])('%s is refused: an answer, one line, nothing to the player', async (_, request, seq, text) => {
    await using bridge = await startBridge({ token });
    const page = await bridge.page();
    await bridge.publish(status(1));
    await page.count(1);
    page.send(request);
    expect(await page.text('refused')).toEqual({ seq, text: expect.stringMatching(text) as string });
    page.send(seek); // what comes after it is the first that the player hears
    await bridge.heard.until(() => bridge.controls.length > 0, 'control');
    expect(bridge.controls.map(({ seq: heard }) => heard)).toEqual([5]);
    expect(bridge.controls[0]?.verb).toBe('seek');
    expect(bridge.lines.length).toBe(1);
    expect(bridge.lines[0]).toMatch(/^bridge: refused: page-1: /);
  });

  test('a bridge without control refuses whatever the token', async () => {
    await using bridge = await startBridge();
    const page = await bridge.page();
    await bridge.publish(status(1));
    page.send(seek);
    expect(await page.text('refused')).toMatchObject({
      text: expect.stringMatching(/^control is off/) as string,
    });
    expect(bridge.controls).toEqual([]);
  });

  test('more than 50 requests a second are refused', async () => {
    await using bridge = await startBridge({ token });
    const page = await bridge.page();
    await bridge.publish(status(1));
    await page.count(1);
    for (let seq = 0; seq < 60; seq += 1) page.send({ ...seek, seq });
    expect(await page.text('refused')).toEqual({ seq: -1, text: 'more than 50 requests a second' });
    await bridge.heard.until(() => bridge.controls.length >= 50, 'the others');
  });
});
