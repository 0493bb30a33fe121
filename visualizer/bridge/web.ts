// The web server: the page, stored cases, map tiles, and the way to the WebSocket.

import { createServer, type IncomingMessage, type Server, type ServerResponse } from 'node:http';
import type { Duplex } from 'node:stream';
import { pipeline } from 'node:stream/promises';
import { WebSocketServer } from 'ws';
import { maxRequestBytes, subprotocol } from '../codec/protocol';
import { listCases, openCase } from './cases';
import { type Hub, maxClients } from './hub';
import type { Journal } from './journal';
import type { OpenedFile } from './inside';
import { Origins } from './origins';
import { openTile, type TileFolder } from './tiles';

export interface WebOptions {
  port: number;
  bind: string;
  cases: string;
  tiles: TileFolder | null;
  page: Buffer;
  hub: Hub;
  journal: Journal;
}

const security = {
  'X-Content-Type-Options': 'nosniff',
  'Referrer-Policy': 'no-referrer',
  'Cross-Origin-Resource-Policy': 'same-origin',
  'Cross-Origin-Opener-Policy': 'same-origin',
  'Cache-Control': 'no-store',
  // The page's own policy is in the page; this adds what only a header can say.
  'Content-Security-Policy': "frame-ancestors 'none'",
};

// Whole numbers as they are written, of as many digits as the deepest zoom has.
const tilePath = /^\/tiles\/(0|[1-9]\d{0,9})\/(0|[1-9]\d{0,9})\/(0|[1-9]\d{0,9})$/;

const inUse = (port: number): string =>
  `port ${port} is in use; choose another: --port N (make visualizer PORT=N)`;

export class Web {
  private readonly options: WebOptions;
  private readonly server: Server;
  private readonly sockets: WebSocketServer;
  private origins = new Origins('127.0.0.1', 0);

  constructor(options: WebOptions) {
    this.options = options;
    this.server = createServer({ maxHeaderSize: 16_384, requestTimeout: 10_000 }, (request, response) => {
      this.answer(request, response).catch((error: Error) => this.broken(response, error));
    });
    this.server.maxConnections = 2 * maxClients;
    this.sockets = new WebSocketServer({
      noServer: true,
      maxPayload: 4 * maxRequestBytes, // beyond it ws closes by itself
      perMessageDeflate: false,
      handleProtocols: (protocols) => (protocols.has(subprotocol) ? subprotocol : false),
    });
    this.server.on('upgrade', (request, socket, head) => this.upgrade(request, socket, head));
    this.server.on('clientError', (error, socket) => {
      options.journal.refused('request', `a malformed request: ${error.message}`);
      if (socket.writable) socket.end('HTTP/1.1 400 Bad Request\r\nConnection: close\r\n\r\n');
      else socket.destroy();
    });
  }

  // Answers with the port. Rejects with one line when the address cannot be used.
  open(): Promise<number> {
    const { port, bind } = this.options;
    return new Promise((resolve, reject) => {
      this.server.once('error', (error: NodeJS.ErrnoException) => {
        reject(error.code === 'EADDRINUSE' ? new Error(inUse(port)) : error);
      });
      this.server.listen(port, bind, () => {
        const address = this.server.address();
        const taken = typeof address === 'object' && address ? address.port : port;
        this.origins = new Origins(bind, taken);
        resolve(taken);
      });
    });
  }

  close(): void {
    this.server.close();
    this.server.closeAllConnections();
  }

  // What is wrong with where a request comes from, '' when nothing is. A page of ours always names its origin when it
  // opens a WebSocket.
  private foreign({ headers }: IncomingMessage, originNeeded: boolean): string {
    const { host, origin } = headers;
    if (!this.origins.isOurHost(host)) return `Host "${host ?? ''}"`;
    if (origin === undefined ? originNeeded : !this.origins.isOurOrigin(origin))
      return `Origin "${origin ?? ''}"`;
    return '';
  }

  private async answer(request: IncomingMessage, response: ServerResponse): Promise<void> {
    const foreign = this.foreign(request, false);
    if (foreign) return this.refuse(request, response, 403, foreign);
    if (request.method !== 'GET' && request.method !== 'HEAD')
      return this.refuse(request, response, 405, `${request.method}, expected GET`);
    const path = (request.url ?? '').split('?')[0] ?? '';
    if (path === '/') return this.send(response, 'text/html; charset=utf-8', this.options.page);
    if (path === '/healthz') return this.json(response, { ok: true, pages: this.options.hub.size });
    if (path === '/cases') return this.json(response, { cases: await listCases(this.options.cases) });
    const id = /^\/cases\/([^/]*)\.lcm$/.exec(path)?.[1];
    if (id !== undefined) return this.log(request, response, id);
    const tile = tilePath.exec(path);
    if (tile && this.options.tiles) return this.tile(request, response, this.options.tiles, tile);
    return this.refuse(request, response, 404, 'no such path');
  }

  private async log(request: IncomingMessage, response: ServerResponse, id: string): Promise<void> {
    const found = await openCase(this.options.cases, id);
    if (!found) return this.refuse(request, response, 404, 'no such case');
    await this.stream(request, response, 'application/octet-stream', found);
  }

  // A place without a tile is nothing wrong, and a browser would complain of a 404: the answer is empty.
  private async tile(
    request: IncomingMessage,
    response: ServerResponse,
    tiles: TileFolder,
    [, z, x, y]: RegExpExecArray,
  ): Promise<void> {
    const found = await openTile(tiles, Number(z), Number(x), Number(y));
    if (found === 'refused') return this.refuse(request, response, 404, 'no such tile');
    if (found !== 'missing') return this.stream(request, response, found.type, found);
    response.writeHead(204, security);
    response.end();
  }

  private async stream(
    { method }: IncomingMessage,
    response: ServerResponse,
    type: string,
    { file, size }: OpenedFile,
  ): Promise<void> {
    response.writeHead(200, { ...security, 'Content-Type': type, 'Content-Length': size });
    if (method === 'HEAD' || size === 0) {
      await file.close();
      response.end();
    } else await pipeline(file.createReadStream({ end: size - 1 }), response);
  }

  private json(response: ServerResponse, value: object): void {
    this.send(response, 'application/json', Buffer.from(JSON.stringify(value)));
  }

  private send(response: ServerResponse, type: string, body: Buffer): void {
    response.writeHead(200, { ...security, 'Content-Type': type, 'Content-Length': body.length });
    response.end(body);
  }

  private refuse(request: IncomingMessage, response: ServerResponse, status: number, why: string): void {
    this.options.journal.refused('request', `${request.method} ${request.url}: ${why} (${status})`);
    response.writeHead(status, { ...security, 'Content-Type': 'text/plain', Connection: 'close' });
    response.end(`${why}\n`);
  }

  // A log that vanished while it was sent, or a page that went away meanwhile.
  private broken(response: ServerResponse, error: Error): void {
    this.options.journal.refused('request', `an answer broke off: ${error.message}`);
    response.destroy();
  }

  private upgrade(request: IncomingMessage, socket: Duplex, head: Buffer): void {
    socket.on('error', () => socket.destroy());
    const refusal = this.refusalOf(request);
    if (refusal) {
      this.options.journal.refused('request', `WebSocket ${request.url}: ${refusal.why} (${refusal.status})`);
      socket.end(`HTTP/1.1 ${refusal.status}\r\nConnection: close\r\nContent-Length: 0\r\n\r\n`);
      return;
    }
    this.sockets.handleUpgrade(request, socket, head, (webSocket) => this.options.hub.add(webSocket));
  }

  private refusalOf(request: IncomingMessage): { status: string; why: string } | null {
    const foreign = this.foreign(request, true);
    if (foreign) return { status: '403 Forbidden', why: foreign };
    if (request.url !== '/ws') return { status: '404 Not Found', why: 'expected /ws' };
    const asked = (request.headers['sec-websocket-protocol'] ?? '').split(',').map((name) => name.trim());
    if (!asked.includes(subprotocol))
      return { status: '400 Bad Request', why: `expected subprotocol ${subprotocol}` };
    if (this.options.hub.full)
      return { status: '503 Service Unavailable', why: `${maxClients} pages are open` };
    return null;
  }
}
