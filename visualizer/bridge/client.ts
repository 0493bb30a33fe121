// One page: what is sent to it, however slow it reads, and what it may ask.

import type { WebSocket } from 'ws';
import {
  type ControlRequest,
  type Hello,
  maxRequestBytes,
  parseRequest,
  type Refused,
  type ServerText,
} from '../codec/protocol';
import { checkVerb } from '../codec/verbs';
import type { Journal } from './journal';
import { sameToken } from './token';

// Beyond this a page gets no more frames, of which the newest is kept for when it has caught up.
const slowBytes = 1024 * 1024;
// A page that is this far behind with what must not be lost reads nothing at all: it is shown out.
const deadBytes = 32 * 1024 * 1024;

const droppable: ReadonlySet<string> = new Set(['VIZ_FRAME', 'VIZ_RISK', 'VIZ_RANGE']);

const requestsPerSecond = 50;
// So many refusals at once, and one a second after that, are borne.
const refusalsBorne = 100;

export interface ClientEvents {
  control: (client: Client, request: ControlRequest) => void;
  closed: (client: Client) => void;
}

export class Client {
  readonly name: string;
  dropped = 0; // messages not sent because the page was slow
  private readonly socket: WebSocket;
  private readonly journal: Journal;
  private readonly token: string | null;
  private readonly waiting = new Map<string, Uint8Array>(); // channel: newest that was held back
  private readonly requests = new Budget(requestsPerSecond, requestsPerSecond);
  private readonly refusals = new Budget(refusalsBorne, 1);

  constructor(socket: WebSocket, name: string, token: string | null, journal: Journal, events: ClientEvents) {
    this.socket = socket;
    this.name = name;
    this.token = token;
    this.journal = journal;
    socket.on('message', (data, binary) => this.request(data as Buffer, binary, events));
    socket.on('close', () => events.closed(this));
    socket.on('error', (error) => journal.refused('request', `${name}: ${error.message}`));
  }

  hello(hello: Hello): void {
    this.socket.send(JSON.stringify(hello));
  }

  text(message: ServerText): void {
    if (this.socket.bufferedAmount < deadBytes) this.socket.send(JSON.stringify(message));
  }

  // A message made by wrap(), of this channel.
  forward(channel: string, message: Uint8Array): void {
    if (droppable.has(channel) && this.socket.bufferedAmount > slowBytes) {
      if (this.waiting.has(channel)) this.dropped += 1;
      this.waiting.set(channel, message);
      return;
    }
    if (this.socket.bufferedAmount > deadBytes) {
      this.journal.refused('request', `${this.name} reads nothing: closed`);
      this.socket.terminate();
      return;
    }
    if (this.waiting.delete(channel)) this.dropped += 1; // a newer one goes in its place
    this.send(message);
  }

  close(): void {
    this.socket.close(1001, 'the bridge ends');
  }

  terminate(): void {
    this.socket.terminate();
  }

  private send(message: Uint8Array): void {
    this.socket.send(message, () => this.catchUp());
  }

  // Called when a message has gone out: is there room again for what was held back?
  private catchUp(): void {
    if (this.waiting.size === 0 || this.socket.bufferedAmount > slowBytes) return;
    const held = [...this.waiting.values()];
    this.waiting.clear();
    for (const message of held) this.send(message);
  }

  private request(data: Buffer, binary: boolean, events: ClientEvents): void {
    if (binary) return this.refuse(-1, 'a binary message, expected text');
    if (data.length > maxRequestBytes)
      return this.refuse(-1, `a request of more than ${maxRequestBytes} bytes`);
    if (!this.requests.take()) return this.refuse(-1, `more than ${requestsPerSecond} requests a second`);
    const request = parseRequest(data.toString('utf8'));
    if (typeof request === 'string') return this.refuse(-1, request);
    const problem = this.problemOf(request);
    if (problem) return this.refuse(request.seq, problem);
    events.control(this, request);
  }

  private problemOf(request: ControlRequest): string {
    if (this.token === null) return 'control is off: start bridge and player with --allow-control';
    if (!sameToken(request.token, this.token)) return 'a wrong token: load the page again';
    return checkVerb(request);
  }

  // One line in the journal, one answer to the page; a page that does nothing else is shown out.
  refuse(seq: number, text: string): void {
    this.journal.refused('control', `${this.name}: ${text}`);
    const refused: Refused = { seq, text };
    this.text({ refused });
    if (!this.refusals.take()) this.socket.close(1008, 'too many requests were refused');
  }
}

// So many at once, evenly refilled.
class Budget {
  private left: number;
  private filledMs = performance.now();
  private readonly most: number;
  private readonly perSecond: number;

  constructor(most: number, perSecond: number) {
    this.most = most;
    this.perSecond = perSecond;
    this.left = most;
  }

  take(): boolean {
    const now = performance.now();
    this.left = Math.min(this.most, this.left + ((now - this.filledMs) / 1000) * this.perSecond);
    this.filledMs = now;
    if (this.left < 1) return false;
    this.left -= 1;
    return true;
  }
}
