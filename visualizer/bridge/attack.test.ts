// What a bridge under attack does: it refuses, says so in one line, and serves everyone else as before.

import { mkdirSync, symlinkSync, writeFileSync } from 'node:fs';
import { connect } from 'node:net';
import { join } from 'node:path';
import { describe, expect, test } from 'vitest';
import type { Message } from '../codec/messages';
import { Random } from '../codec/random';
import { sampleMessages } from '../codec/samples';
import { maxClients } from './hub';
import { startBridge, type TestBridge, type TestPage } from './testing';

const event = sampleMessages.find(({ channel }) => channel === 'VIZ_EVENT') as Message;

// The other page still gets what comes.
async function unaffected(bridge: TestBridge, page: TestPage): Promise<void> {
  const before = page.binary.length;
  await bridge.publish(event);
  await page.count(before + 1);
  expect(page.messages().at(-1)).toEqual(event);
  expect(page.closed).toBeNull();
}

// Sends bytes to the web server as they are; answers with all that comes back.
function raw(port: number, bytes: string | Uint8Array): Promise<string> {
  return new Promise((resolve) => {
    let answer = '';
    const socket = connect(port, '127.0.0.1', () => socket.write(bytes));
    socket.on('data', (data) => {
      answer += String(data);
    });
    socket.on('error', () => undefined);
    socket.on('close', () => resolve(answer));
  });
}

describe('requests of other sites', () => {
  const foreign = [
    'http://evil.example',
    'http://127.0.0.1:1',
    'http://127.0.0.1:PORT.evil.example',
    'http://127.0.0.1:PORT@evil.example',
    'https://127.0.0.1:PORT',
    'http://127.0.0.1:PORT/',
    'null',
    '',
  ];

  test.each(foreign)('a WebSocket with Origin "%s" is refused with 403 and one line', async (origin) => {
    await using bridge = await startBridge();
    const page = await bridge.page();
    const named = origin.replace('PORT', String(bridge.port));
    expect(await bridge.refusedPage({ Origin: named })).toBe(403);
    expect(bridge.lines).toEqual([`bridge: refused: WebSocket /ws: Origin "${named}" (403 Forbidden)`]);
    await unaffected(bridge, page);
  });

  test('a WebSocket without Origin is refused', async () => {
    await using bridge = await startBridge();
    expect(await bridge.refusedPage({})).toBe(403);
  });

  test('localhost is as good as 127.0.0.1', async () => {
    await using bridge = await startBridge();
    await bridge.page({ Origin: `http://localhost:${bridge.port}`, Host: `localhost:${bridge.port}` });
    expect((await bridge.get('/', { Host: `LOCALHOST:${bridge.port}` })).status).toBe(200);
  });

  test.each([
    'evil.example',
    'evil.example:PORT',
    '127.0.0.1',
    '127.0.0.1:1',
    'localhost.:PORT',
    '127.0.0.1:PORT0',
  ])('a request for Host "%s" is refused, as a rebound name would make it', async (host) => {
    await using bridge = await startBridge();
    const named = host.replace('PORT', String(bridge.port));
    for (const path of ['/', '/cases', '/healthz']) {
      const answer = await bridge.get(path, { Host: named });
      expect([answer.status, answer.body]).toEqual([403, `Host "${named}"\n`]);
    }
    expect(await bridge.refusedPage({ Host: named, Origin: `http://127.0.0.1:${bridge.port}` })).toBe(403);
    expect(bridge.lines.length).toBe(4);
  });

  test('another path, subprotocol or method is refused', async () => {
    await using bridge = await startBridge();
    const origin = { Origin: `http://127.0.0.1:${bridge.port}` };
    expect(await bridge.refusedPage(origin, '/other')).toBe(404);
    expect(await bridge.refusedPage(origin, '/ws', ['viz.v2'])).toBe(400);
    expect((await bridge.get('/other')).status).toBe(404);
    expect((await bridge.get('/', {}, 'POST')).status).toBe(405);
    expect(bridge.lines.length).toBe(4);
  });
});

describe('stored cases', () => {
  const log = 'as it is on disk';
  function store(bridge: TestBridge): void {
    const outside = join(bridge.cases, '..', 'outside');
    for (const folder of [join(bridge.cases, 'copter_1a2b3c4d'), join(bridge.cases, 'no_log'), outside])
      mkdirSync(folder, { recursive: true });
    writeFileSync(join(bridge.cases, 'copter_1a2b3c4d', 'run.lcm'), log);
    writeFileSync(join(outside, 'run.lcm'), 'secret');
    symlinkSync(outside, join(bridge.cases, 'link'));
    mkdirSync(join(bridge.cases, 'file_link'));
    symlinkSync(join(outside, 'run.lcm'), join(bridge.cases, 'file_link', 'run.lcm'));
  }

  test('are listed and sent as they are', async () => {
    await using bridge = await startBridge();
    store(bridge);
    const list = JSON.parse((await bridge.get('/cases')).body) as unknown;
    expect(list).toMatchObject({ cases: [{ id: 'copter_1a2b3c4d', bytes: log.length }] });
    const answer = await bridge.get('/cases/copter_1a2b3c4d.lcm');
    expect([answer.status, answer.body]).toEqual([200, log]);
  });

  test('no folder of cases is an empty list', async () => {
    await using bridge = await startBridge();
    expect((await bridge.get('/cases')).body).toBe('{"cases":[]}');
  });

  test.each([
    '/cases/../outside.lcm',
    '/cases/..%2Foutside.lcm',
    '/cases/%2e%2e.lcm',
    '/cases/....lcm',
    '/cases/.lcm',
    '/cases/link.lcm',
    '/cases/file_link.lcm',
    '/cases/no_log.lcm',
    '/cases/missing.lcm',
    `/cases/${'a'.repeat(65)}.lcm`,
    '/cases/copter_1a2b3c4d',
    '/cases/copter_1a2b3c4d%00.lcm',
    '/cases//etc/passwd.lcm',
  ])('%s is refused with 404 and one line', async (path) => {
    await using bridge = await startBridge();
    store(bridge);
    const answer = await raw(
      bridge.port,
      `GET ${path} HTTP/1.1\r\nHost: 127.0.0.1:${bridge.port}\r\nConnection: close\r\n\r\n`,
    );
    expect(answer).toMatch(/^HTTP\/1\.1 404 /);
    expect(answer).not.toMatch(/secret/);
    expect(bridge.lines.length).toBe(1);
    expect(bridge.lines[0]).toMatch(/^bridge: refused: GET \/cases.* \(404\)$/);
  });
});

describe('malformed WebSockets', () => {
  const open = (port: number, frames: Uint8Array): Promise<string> =>
    raw(
      port,
      Buffer.concat([
        Buffer.from(
          [
            'GET /ws HTTP/1.1',
            `Host: 127.0.0.1:${port}`,
            `Origin: http://127.0.0.1:${port}`,
            'Connection: Upgrade',
            'Upgrade: websocket',
            'Sec-WebSocket-Version: 13',
            'Sec-WebSocket-Key: MDEyMzQ1Njc4OWFiY2RlZg==',
            'Sec-WebSocket-Protocol: viz.v1',
            '\r\n',
          ].join('\r\n'),
        ),
        frames,
      ]),
    );

  // RFC 6455, section 5: first byte FIN, RSV and opcode, second MASK and length.
  test.each([
    ['not masked', [0x81, 0x01, 0x41]],
    ['with reserved bits', [0xf1, 0x80, 0, 0, 0, 0]],
    ['of an unknown kind', [0x83, 0x80, 0, 0, 0, 0]],
    ['that continues nothing', [0x80, 0x80, 0, 0, 0, 0]],
    ['with a ping of 126 bytes', [0x89, 0xfe, 0, 126, 0, 0, 0, 0]],
    ['that claims 2^63 bytes', [0x81, 0xff, 0x80, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0]],
    ['that claims 1 MiB', [0x81, 0xff, 0, 0, 0, 0, 0, 0x10, 0, 0, 0, 0, 0, 0]],
    ['with text that is no UTF-8', [0x81, 0x82, 0, 0, 0, 0, 0xff, 0xff]],
  ])('a frame %s ends its connection with one line', async (_, bytes) => {
    await using bridge = await startBridge();
    const page = await bridge.page();
    await open(bridge.port, Uint8Array.from(bytes));
    expect(await bridge.line(/refused/)).toMatch(/^bridge: refused: page-2: /);
    await unaffected(bridge, page);
    expect(bridge.lines.length).toBe(1);
  });

  test('random bytes in place of frames end the connection or are refused', async () => {
    await using bridge = await startBridge();
    const page = await bridge.page();
    for (let seed = 1; seed <= 20; seed += 1) {
      const random = new Random(seed);
      await open(bridge.port, Buffer.concat([random.bytes(200), Uint8Array.from([0x81, 0x00])]));
    }
    await unaffected(bridge, page);
  });

  test('what is no HTTP is answered with 400 and one line', async () => {
    await using bridge = await startBridge();
    expect(await raw(bridge.port, 'NONSENSE\r\n\r\n')).toMatch(/^HTTP\/1\.1 400 /);
    expect(bridge.lines).toEqual([expect.stringMatching(/^bridge: refused: a malformed request: /)]);
  });

  test('a header without end is refused', async () => {
    await using bridge = await startBridge();
    await raw(bridge.port, `GET / HTTP/1.1\r\nX: ${'x'.repeat(20_000)}`);
    expect(bridge.lines.length).toBe(1);
  });
});

describe('floods', () => {
  test('a request of more than 4 KiB is refused, its page stays', async () => {
    await using bridge = await startBridge();
    const page = await bridge.page();
    page.socket.send('x'.repeat(4097));
    expect(await page.text('refused')).toEqual({ seq: -1, text: 'a request of more than 4096 bytes' });
    await unaffected(bridge, page);
  });

  test('a page with a hundred refusals is shown out, the others stay', async () => {
    await using bridge = await startBridge();
    const page = await bridge.page();
    const bad = await bridge.page();
    for (let i = 0; i < 200; i += 1) bad.socket.send('nonsense');
    expect(await bad.until(() => bad.closed ?? undefined, 'closed')).toBe(1008);
    await unaffected(bridge, page);
    expect(bridge.lines.length).toBeLessThan(30); // the rest is summed up
  });

  test(`page ${maxClients + 1} is refused until another one leaves`, async () => {
    await using bridge = await startBridge();
    const pages = await Promise.all(Array.from({ length: maxClients }, () => bridge.page()));
    const origin = { Origin: `http://127.0.0.1:${bridge.port}` };
    expect(await bridge.refusedPage(origin)).toBe(503);
    pages[0]?.socket.close();
    await pages[0]?.until(() => pages[0]?.closed ?? undefined, 'closed');
    await unaffected(bridge, await bridge.page());
  });

  test('malformed packets are refused with a line each, and many of them with few', async () => {
    await using bridge = await startBridge();
    const page = await bridge.page();
    await bridge.datagram(Buffer.from('nonsense'));
    expect(await bridge.line(/packet/)).toMatch(
      /a packet of 127\.0\.0\.1:\d+: 6e6f6e73 begins no LCM packet$/,
    );
    for (let seed = 1; seed <= 500; seed += 1) {
      const random = new Random(seed);
      const magic = Buffer.from(random.pick(['4c433032', '4c433033', '']), 'hex');
      await bridge.datagram(Buffer.concat([magic, random.bytes(random.below(100))]));
    }
    await unaffected(bridge, page);
    expect(bridge.lines.length).toBeLessThan(100);
  });

  test('a message of another type is named, and passed on: the page says what to do', async () => {
    await using bridge = await startBridge();
    const page = await bridge.page();
    await bridge.datagram(
      Buffer.from(`4c43303200000001${Buffer.from('VIZ_STATUS\0wrong layout').toString('hex')}`, 'hex'),
    );
    await page.count(1);
    expect(await bridge.line(/VIZ_STATUS/)).toMatch(/type mismatch: rebuild/);
  });
});
