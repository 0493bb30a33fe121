import { describe, expect, it } from 'vitest';
import { wrap } from '../../../codec/protocol';
import { encodeMessage } from '../../../codec/viz';
import type { Message } from '../../../codec/messages';
import { aFrame } from '../model/testing';
import { openSocketLink, retryDelayS, type Socket } from './socket_link';

type Change = { connected?: boolean; retryInS?: number; error?: string; packets?: number };

function setUp() {
  let nowMs = 0;
  let timers: { everyMs: number; dueMs: number; callback: () => void }[] = [];
  const sockets: (Socket & { sent: string[]; closed: boolean })[] = [];
  const messages: Message[] = [];
  const changes: Change[] = [];
  const granted: boolean[] = [];
  const world = {
    open: () => {
      const socket = {
        binaryType: 'blob' as BinaryType,
        onmessage: null,
        onclose: null,
        sent: [] as string[],
        closed: false,
        send: (text: unknown) => void socket.sent.push(String(text)),
        close: () => {
          socket.closed = true;
        },
      };
      sockets.push(socket);
      return socket;
    },
    now: () => nowMs,
    every: (everyMs: number, callback: () => void) => {
      const timer = { everyMs, dueMs: nowMs + everyMs, callback };
      timers.push(timer);
      return () => {
        timers = timers.filter((other) => other !== timer);
      };
    },
  };
  const pass = (ms: number): void => {
    const until = nowMs + ms;
    for (; nowMs < until; nowMs += 10) {
      for (const timer of [...timers]) {
        if (nowMs < timer.dueMs || !timers.includes(timer)) continue;
        timer.dueMs = nowMs + timer.everyMs;
        timer.callback();
      }
    }
  };
  const listener = {
    message: (message: Message) => void messages.push(message),
    connection: (change: Change) => void changes.push(change),
    granted: (control: boolean) => void granted.push(control),
  };
  const link = openSocketLink('ws://x/ws', listener, world);
  const last = () => {
    const socket = sockets[sockets.length - 1];
    if (socket === undefined) throw new Error('no socket was opened');
    return socket;
  };
  const receive = (data: string | ArrayBuffer): void =>
    void last().onmessage?.call(last() as unknown as WebSocket, { data } as MessageEvent);
  const lose = (): void => void last().onclose?.call(last() as unknown as WebSocket, {} as CloseEvent);
  return { link, pass, sockets, last, receive, lose, messages, changes, granted };
}

const hello = (token: string | null) =>
  JSON.stringify({
    v: 1,
    start: 's',
    control: token !== null,
    token,
    client: 'me',
    group: '239.255.76.67:7667',
    channels: {},
  });
const binary = (message: Message): ArrayBuffer => wrap(message.channel, encodeMessage(message)).buffer;
const ack = (client: string) =>
  ({ channel: 'VIZ_ACK', value: { client, seq: 1, ok: true, text: '' } }) as const;

describe('a link', () => {
  it('greets, decodes, and counts', () => {
    const { receive, messages, changes, granted } = setUp();
    receive(hello(null));
    receive(binary(aFrame(7)));
    receive('{"stats":{"udp":5,"lost":1,"dropped":2,"bytesPerSec":3}}');
    expect(changes[0]).toEqual({
      connected: true,
      retryInS: 0,
      group: '239.255.76.67:7667',
      tiles: null,
      error: '',
    });
    expect(granted).toEqual([false]);
    expect(messages.map((message) => message.channel)).toEqual(['VIZ_FRAME']);
    expect(changes[1]).toEqual({ packets: 5, lost: 1, dropped: 2, bytesPerSec: 3 });
  });

  it('sends with its token, and only once it is greeted', () => {
    const { link, receive, last, messages } = setUp();
    const asked = { seq: 1, verb: 'seek', object: -1, args: [7.42], text: '' };
    link.send(asked);
    expect(messages[0]?.value).toMatchObject({ seq: 1, ok: false });
    receive(hello('abc'));
    link.send(asked);
    expect(last().sent.map((text) => JSON.parse(text))).toEqual([{ ...asked, token: 'abc' }]);
  });

  it('answers to other pages are not ours; a refusal of the bridge is an answer', () => {
    const { receive, messages } = setUp();
    receive(hello('abc'));
    receive(binary(ack('other')));
    receive(binary(ack('me')));
    receive('{"refused":{"seq":9,"text":"no"}}');
    expect(messages.map((message) => message.value)).toEqual([
      ack('me').value,
      { client: 'me', seq: 9, ok: false, text: 'no' },
    ]);
  });

  it('says what it cannot understand, and goes on', () => {
    const { receive, changes, messages } = setUp();
    receive(hello(null));
    receive(new Uint8Array([200, 1]).buffer);
    const bad = new Uint8Array(binary(aFrame(7)));
    bad[10] = (bad[10] ?? 0) ^ 1;
    receive(bad.buffer);
    receive(binary(aFrame(8)));
    expect(changes[1]?.error).toContain('2 bytes');
    expect(changes[2]?.error).toContain('type mismatch: rebuild');
    expect(messages).toHaveLength(1);
  });

  it('connects again after 0.5, 1, 2, 4, 5, 5 s, counting down', () => {
    const { lose, pass, sockets, changes } = setUp();
    expect([0, 1, 2, 3, 4, 5].map(retryDelayS)).toEqual([0.5, 1, 2, 4, 5, 5]);
    lose();
    expect(changes[0]).toEqual({ connected: false, retryInS: 0.5 });
    pass(250);
    expect(changes[1]?.retryInS).toBeCloseTo(0.4, 1);
    expect(sockets).toHaveLength(1);
    pass(400);
    expect(sockets).toHaveLength(2);
    lose();
    pass(800);
    expect(sockets).toHaveLength(2);
    pass(400);
    expect(sockets).toHaveLength(3);
  });

  it('begins at 0.5 s again after a good connection', () => {
    const { lose, pass, receive, sockets, changes } = setUp();
    lose();
    pass(700);
    receive(hello(null));
    lose();
    expect(changes[changes.length - 1]).toEqual({ connected: false, retryInS: 0.5 });
    pass(700);
    expect(sockets).toHaveLength(3);
  });

  it('does not come back once it was closed', () => {
    const { link, lose, pass, sockets, last } = setUp();
    link.close();
    lose();
    pass(10_000);
    expect([sockets.length, last().closed]).toEqual([1, true]);
  });
});
