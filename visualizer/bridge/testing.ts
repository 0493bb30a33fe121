// What the bridge's tests share: a bridge on free ports, a sender of packets, pages that record what they get.

import { createSocket } from 'node:dgram';
import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { request } from 'node:http';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { WebSocket } from 'ws';
import type { Control, Message } from '../codec/messages';
import { packets } from '../codec/packet';
import { unwrap } from '../codec/protocol';
import { Reassembly } from '../codec/reassembly';
import { decodeControl, decodeMessage, encodeMessage } from '../codec/viz';
import { Bridge } from './bridge';
import type { Group } from './group';
import { Journal } from './journal';

// Settles when something else has happened: whoever waits is asked again after each change.
export class Changes {
  private waiting: (() => void)[] = [];
  private readonly always: (() => void)[] = [];

  // Calls back after each change, for good.
  each(look: () => void): void {
    this.always.push(look);
  }

  changed(): void {
    for (const look of this.always) look();
    for (const look of this.waiting.splice(0)) look();
  }

  // Resolves with the first answer that is neither undefined nor false.
  until<T>(look: () => T | undefined | false, what: string, limitMs = 30_000): Promise<T> {
    return new Promise((resolve, reject) => {
      const late = setTimeout(() => reject(new Error(`${what}: not within ${limitMs} ms`)), limitMs);
      const ask = (): void => {
        const found = look();
        if (found === undefined || found === false) this.waiting.push(ask);
        else {
          clearTimeout(late);
          resolve(found);
        }
      };
      ask();
    });
  }
}

// A page without a browser.
export class TestPage extends Changes {
  readonly binary: Uint8Array[] = [];
  readonly texts: Record<string, unknown>[] = [];
  closed: number | null = null; // code
  readonly socket: WebSocket;

  constructor(socket: WebSocket) {
    super();
    this.socket = socket;
    socket.on('message', (data, isBinary) => {
      if (isBinary) this.binary.push(data as Buffer);
      else this.texts.push(JSON.parse(String(data)) as Record<string, unknown>);
      this.changed();
    });
    socket.on('error', () => this.changed());
    socket.on('close', (code) => {
      this.closed = code;
      this.changed();
    });
  }

  messages(): Message[] {
    return this.binary.map((bytes) => {
      const whole = unwrap(bytes);
      if (typeof whole === 'string') throw new Error(whole);
      const decoded = decodeMessage(whole.channel, whole.payload);
      if (!decoded.ok) throw new Error(decoded.error);
      return decoded.message;
    });
  }

  text<T>(member: string): Promise<T> {
    return this.until(() => this.texts.find((text) => member in text)?.[member] as T | undefined, member);
  }

  // So many binary messages have come.
  count(count: number): Promise<true> {
    return this.until(() => this.binary.length >= count, `${count} messages`);
  }

  send(request: object): void {
    this.socket.send(JSON.stringify(request));
  }
}

export interface Answer {
  status: number;
  body: string;
  headers: NodeJS.Dict<string | string[]>;
}

export interface TestBridge extends AsyncDisposable {
  port: number;
  lines: string[]; // what the bridge said
  said: Changes;
  cases: string; // folder
  token: string | null;
  line(pattern: RegExp): Promise<string>;
  page(headers?: Record<string, string>): Promise<TestPage>;
  refusedPage(headers: Record<string, string>, path?: string, protocols?: string[]): Promise<number>;
  get(path: string, headers?: Record<string, string>, method?: string): Promise<Answer>;
  publish(...messages: Message[]): Promise<void>;
  datagram(bytes: Uint8Array): Promise<void>;
  controls: Control[]; // what came to the player
  heard: Changes;
}

export function freePort(): Promise<number> {
  return new Promise((resolve) => {
    const socket = createSocket('udp4').bind(0, '127.0.0.1', () => {
      const { port } = socket.address();
      socket.close(() => resolve(port));
    });
  });
}

// A unicast bridge unless a multicast group is named; tiles fills the folder of map tiles that it then has.
export async function startBridge(
  options: { token?: string; group?: (port: number) => Group; tiles?: (folder: string) => void } = {},
): Promise<TestBridge> {
  const folder = mkdtempSync(join(tmpdir(), 'bridge-'));
  const page = join(folder, 'page.html');
  writeFileSync(page, '<!doctype html><title>page</title>');
  const tokenFile = options.token === undefined ? null : join(folder, 'token');
  if (tokenFile) writeFileSync(tokenFile, `${options.token}\n`, { mode: 0o600 });
  const udpPort = await freePort();
  const group: Group = options.group?.(udpPort) ?? {
    host: '127.0.0.1',
    port: udpPort,
    multicast: false,
    ttl: 0,
    receiveBuffer: 2 ** 21,
    network: false,
  };
  const lines: string[] = [];
  const said = new Changes();
  const journal = new Journal((line) => {
    lines.push(line);
    said.changed();
  });
  const cases = join(folder, 'cases');
  const tiles = join(folder, 'tiles');
  options.tiles?.(tiles);
  const bridge = new Bridge(
    {
      port: 0,
      bind: '127.0.0.1',
      group,
      cases,
      tiles: options.tiles === undefined ? null : tiles,
      page,
      tokenFile,
    },
    page,
    journal,
  );
  const port = Number(new URL(await bridge.open()).port);
  const player = await startPlayer(group);
  const sockets: WebSocket[] = [];
  const origin = { Origin: `http://127.0.0.1:${port}` };
  const connect = (headers: Record<string, string>, path: string, protocols: string[]): WebSocket => {
    const socket = new WebSocket(`ws://127.0.0.1:${port}${path}`, protocols, { headers });
    sockets.push(socket);
    return socket;
  };
  return {
    port,
    lines,
    said,
    cases,
    token: options.token ?? null,
    controls: player.controls,
    heard: player.heard,
    line: (pattern) => said.until(() => lines.find((line) => pattern.test(line)), String(pattern)),
    page: async (headers = origin) => {
      const opened = new TestPage(connect(headers, '/ws', ['viz.v1']));
      await opened.until(() => opened.texts.length > 0, 'hello');
      return opened;
    },
    refusedPage: (headers, path = '/ws', protocols = ['viz.v1']) =>
      new Promise((resolve, reject) => {
        const socket = connect(headers, path, protocols);
        socket.on('unexpected-response', (_, response) => resolve(response.statusCode ?? 0));
        socket.on('open', () => reject(new Error('it was let in')));
        socket.on('error', () => undefined);
      }),
    get: (path, headers = {}, method = 'GET') => get(port, path, headers, method),
    publish: player.publish,
    datagram: player.datagram,
    [Symbol.asyncDispose]: async () => {
      for (const socket of sockets) socket.terminate();
      player.close();
      await bridge.close();
      rmSync(folder, { recursive: true });
    },
  };
}

function get(port: number, path: string, headers: Record<string, string>, method: string): Promise<Answer> {
  return new Promise((resolve, reject) => {
    const asked = request({ host: '127.0.0.1', port, path, method, headers, agent: false }, (response) => {
      const chunks: Buffer[] = [];
      response.on('data', (chunk: Buffer) => chunks.push(chunk));
      response.on('end', () =>
        resolve({
          status: response.statusCode ?? 0,
          body: String(Buffer.concat(chunks)),
          headers: response.headers,
        }),
      );
    });
    asked.on('error', reject);
    asked.end();
  });
}

// Sends to the group as a player does, and records what is asked of it; onMessage gets everything that comes.
export async function startPlayer(group: Group, onMessage?: (channel: string, payload: Uint8Array) => void) {
  const socket = createSocket({ type: 'udp4', reuseAddr: group.multicast });
  await new Promise<void>((resolve) =>
    group.multicast
      ? socket.bind(group.port, group.host, () => {
          socket.addMembership(group.host, '127.0.0.1');
          socket.setMulticastInterface('127.0.0.1');
          socket.setMulticastTTL(0);
          resolve();
        })
      : socket.bind(0, '127.0.0.1', () => resolve()),
  );
  const controls: Control[] = [];
  const heard = new Changes();
  const reassembly = new Reassembly();
  socket.on('message', (bytes, { address, port }) => {
    const whole = reassembly.accept(`${address}:${port}`, bytes);
    if (!whole || typeof whole === 'string') return;
    onMessage?.(whole.channel, whole.payload);
    if (whole.channel === 'VIZ_CONTROL') {
      controls.push(decodeControl(whole.payload));
      heard.changed();
    }
  });
  let sequence = 0;
  const datagram = (bytes: Uint8Array): Promise<void> =>
    new Promise((resolve, reject) =>
      socket.send(bytes, group.port, group.host, (error) => (error ? reject(error) : resolve())),
    );
  const publish = async (...messages: Message[]): Promise<void> => {
    for (const message of messages) {
      for (const packet of packets(message.channel, encodeMessage(message), sequence)) await datagram(packet);
      sequence += 1;
    }
  };
  return { controls, heard, publish, datagram, close: () => socket.close() };
}
