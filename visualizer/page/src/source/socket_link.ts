// The WebSocket to the bridge (viz.v1): decodes what comes, sends what is asked, and connects again
// by itself. What the viewer holds is not touched by losing the connection.

import type { Ack } from '../../../codec/messages';
import { parseHello, parseServerText, subprotocol, unwrap } from '../../../codec/protocol';
import { decodeMessage } from '../../../codec/viz';
import type { Asked, Link, LinkListener } from '../model/create_viewer';

// What of the browser is used; tests bring their own.
export type Socket = Pick<WebSocket, 'binaryType' | 'onmessage' | 'onclose' | 'send' | 'close'>;

export interface SocketWorld {
  open(url: string, protocol: string): Socket;
  now(): number; // ms
  every(ms: number, callback: () => void): () => void; // answers how to stop
}

const RETRY_S = [0.5, 1, 2, 4, 5] as const;
const COUNTDOWN_MS = 100;

// Seconds to wait before the try of that number, 0 the first.
export function retryDelayS(attempt: number): number {
  return RETRY_S[Math.min(Math.max(attempt, 0), RETRY_S.length - 1)] ?? 5;
}

export function openSocketLink(url: string, listener: LinkListener, world: SocketWorld): Link {
  return new SocketLink(url, listener, world);
}

class SocketLink implements Link {
  private socket: Socket | null = null;
  private attempt = 0;
  private token: string | null = null;
  private client = '';
  private greeted = false;
  private closed = false;
  private stopCountdown: () => void = () => undefined;

  constructor(
    private readonly url: string,
    private readonly listener: LinkListener,
    private readonly world: SocketWorld,
  ) {
    this.open();
  }

  send(asked: Asked): void {
    if (!this.greeted || this.socket === null) {
      this.refuse(asked.seq, 'disconnected from the bridge');
      return;
    }
    this.socket.send(JSON.stringify({ ...asked, token: this.token ?? '' }));
  }

  close(): void {
    this.closed = true;
    this.stopCountdown();
    this.socket?.close();
  }

  private open(): void {
    this.stopCountdown();
    const socket = this.world.open(this.url, subprotocol);
    socket.binaryType = 'arraybuffer';
    socket.onmessage = (event: MessageEvent<unknown>) => {
      if (this.socket === socket && !this.closed) this.received(event.data);
    };
    socket.onclose = () => {
      if (this.socket === socket) this.lost();
    };
    this.socket = socket;
  }

  private lost(): void {
    this.socket = null;
    this.greeted = false;
    if (this.closed) return;
    const dueMs = this.world.now() + retryDelayS(this.attempt) * 1000;
    this.attempt += 1;
    const leftS = (): number => Math.max(0, (dueMs - this.world.now()) / 1000);
    this.listener.granted(false);
    this.listener.connection({ connected: false, retryInS: leftS() });
    this.stopCountdown = this.world.every(COUNTDOWN_MS, () => {
      if (leftS() > 0) this.listener.connection({ retryInS: leftS() });
      else this.open();
    });
  }

  private received(data: unknown): void {
    if (data instanceof ArrayBuffer) this.receivedBytes(new Uint8Array(data));
    else if (typeof data === 'string' && this.greeted) this.receivedText(data);
    else if (typeof data === 'string') this.hello(data);
  }

  private hello(text: string): void {
    const hello = parseHello(text);
    if (typeof hello === 'string') {
      this.listener.connection({ error: hello });
      return;
    }
    this.greeted = true;
    this.attempt = 0;
    this.token = hello.token;
    this.client = hello.client;
    const { group, tiles } = hello;
    this.listener.connection({ connected: true, retryInS: 0, group, tiles, error: '' });
    this.listener.granted(hello.control && hello.token !== null);
  }

  private receivedText(text: string): void {
    const told = parseServerText(text);
    if (told === null) return;
    if ('refused' in told) {
      this.refuse(told.refused.seq, told.refused.text);
      return;
    }
    const { udp, lost, dropped, bytesPerSec } = told.stats;
    this.listener.connection({ packets: udp, lost, dropped, bytesPerSec });
  }

  private receivedBytes(bytes: Uint8Array): void {
    const parts = unwrap(bytes);
    if (typeof parts === 'string') {
      this.listener.connection({ error: parts });
      return;
    }
    const decoded = decodeMessage(parts.channel, parts.payload);
    if (!decoded.ok) {
      this.listener.connection({ error: decoded.error });
      return;
    }
    const { message } = decoded;
    if (message.channel === 'VIZ_ACK' && message.value.client !== this.client) return;
    this.listener.message(message);
  }

  private refuse(seq: number, text: string): void {
    const value: Ack = { client: this.client, seq, ok: false, text };
    this.listener.message({ channel: 'VIZ_ACK', value });
  }
}
