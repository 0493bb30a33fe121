// Map tiles: what the bridge serves of a folder, and what it refuses.

import { mkdirSync, mkdtempSync, rmSync, symlinkSync, truncateSync, writeFileSync } from 'node:fs';
import { connect } from 'node:net';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { afterEach, beforeEach, describe, expect, test } from 'vitest';
import type { Hello } from '../codec/protocol';
import { UsageError } from './options';
import { startBridge, type TestBridge } from './testing';
import { largestTile, readTileFolder } from './tiles';

const set = { origin: [11.97, 57.69], minzoom: 2, maxzoom: 3, attribution: '© somebody' };

// A folder with the tile 3/5/2, and a secret beside it that links lead to.
function fill(folder: string, description: object = set, tile = '3/5/2.png'): void {
  const secret = join(folder, '..', 'secret.png');
  mkdirSync(join(folder, tile, '..'), { recursive: true });
  writeFileSync(join(folder, 'tiles.json'), JSON.stringify(description));
  writeFileSync(join(folder, tile), 'picture');
  writeFileSync(secret, 'secret');
  symlinkSync(secret, join(folder, '3/5/3.png'));
  mkdirSync(join(folder, '3/5/4.png'));
  mkdirSync(join(folder, '..', '6'));
  writeFileSync(join(folder, '..', '6', '0.png'), 'secret');
  symlinkSync(join(folder, '..', '6'), join(folder, '3/6'));
}

describe('tiles of a folder', () => {
  test('are served as they are, with the type of the format', async () => {
    await using bridge = await startBridge({ tiles: fill });
    const { status, body, headers } = await bridge.get('/tiles/3/5/2');
    expect([status, body]).toEqual([200, 'picture']);
    expect(headers).toMatchObject({
      'content-type': 'image/png',
      'content-length': '7',
      'x-content-type-options': 'nosniff',
    });
    expect((await bridge.get('/tiles/3/5/2', {}, 'HEAD')).body).toBe('');
    expect(bridge.lines).toEqual([]);
  });

  test.each([
    ['jpg', 'image/jpeg'],
    ['jpeg', 'image/jpeg'],
    ['webp', 'image/webp'],
  ])('may be %s', async (format, type) => {
    await using bridge = await startBridge({
      tiles: (folder) => fill(folder, { ...set, format }, `3/5/2.${format}`),
    });
    const { status, headers } = await bridge.get('/tiles/3/5/2');
    expect([status, headers['content-type']]).toEqual([200, type]);
  });

  test('may be numbered from the south', async () => {
    await using bridge = await startBridge({ tiles: (folder) => fill(folder, { ...set, scheme: 'tms' }) });
    expect((await bridge.get('/tiles/3/5/5')).body).toBe('picture');
    expect((await bridge.get('/tiles/3/5/2')).status).not.toBe(200);
  });

  test('are told in the hello, null when there are none', async () => {
    const tilesOf = async (bridge: TestBridge) =>
      ((await bridge.page()).texts as unknown as Hello[])[0]?.tiles;
    await using bridge = await startBridge({ tiles: fill });
    expect(await tilesOf(bridge)).toEqual(set);
    await using without = await startBridge();
    expect(await tilesOf(without)).toBeNull();
    expect((await without.get('/tiles/3/5/2')).status).toBe(404);
  });

  test('that are not there are empty answers without a complaint', async () => {
    await using bridge = await startBridge({ tiles: fill });
    for (const path of ['/tiles/3/0/0', '/tiles/2/3/3', '/tiles/3/5/1']) {
      const { status, body } = await bridge.get(path);
      expect([status, body]).toEqual([204, '']);
    }
    expect(bridge.lines).toEqual([]);
  });

  test('may be large up to a limit', async () => {
    await using bridge = await startBridge({
      tiles: (folder) => {
        fill(folder);
        truncateSync(join(folder, '3/5/2.png'), largestTile);
        writeFileSync(join(folder, '3/5/0.png'), '');
        truncateSync(join(folder, '3/5/0.png'), largestTile + 1);
      },
    });
    expect((await bridge.get('/tiles/3/5/2')).body.length).toBe(largestTile);
    expect((await bridge.get('/tiles/3/5/0')).status).toBe(404);
    expect(bridge.lines).toEqual(['bridge: refused: GET /tiles/3/5/0: no such tile (404)']);
  });

  test('are for requests of our own alone', async () => {
    await using bridge = await startBridge({ tiles: fill });
    const foreign = await bridge.get('/tiles/3/5/2', { Host: 'evil.example' });
    expect([foreign.status, foreign.body]).toEqual([403, 'Host "evil.example"\n']);
    expect((await bridge.get('/tiles/3/5/2', { Origin: 'http://evil.example' })).status).toBe(403);
    expect((await bridge.get('/tiles/3/5/2', {}, 'POST')).status).toBe(405);
  });

  test.each([
    '/tiles/3/5/3', // a link out of the folder
    '/tiles/3/6/0', // through a folder that is one
    '/tiles/3/5/4', // a folder
    '/tiles/1/0/0', // above minzoom
    '/tiles/4/0/0', // below maxzoom
    '/tiles/3/8/0', // no such column
    '/tiles/3/0/8', // no such row
    '/tiles/3/5/2.png',
    '/tiles/3/5/02',
    '/tiles/3/5/-1',
    '/tiles/3/5/2.0',
    '/tiles/3/5/1e0',
    '/tiles/3/5/99999999999999999999',
    '/tiles/3/5/',
    '/tiles/3/5',
    '/tiles/3/5/2/2',
    '/tiles/3/../tiles.json',
    '/tiles/../secret.png',
    '/tiles/..%2Fsecret',
    '/tiles/3/5/%2e%2e',
    '/tiles//etc/passwd',
    '/tiles.json',
  ])('%s is refused with 404 and one line', async (path) => {
    await using bridge = await startBridge({ tiles: fill });
    const answer = await raw(bridge.port, path);
    expect(answer).toMatch(/^HTTP\/1\.1 404 /);
    expect(answer).not.toMatch(/secret/);
    expect(bridge.lines).toEqual([expect.stringMatching(/^bridge: refused: GET \/tiles.* \(404\)$/)]);
  });
});

// The answer to a path as it is, which a client would tidy up.
function raw(port: number, path: string): Promise<string> {
  return new Promise((resolve, reject) => {
    let answer = '';
    const socket = connect(port, '127.0.0.1', () =>
      socket.write(`GET ${path} HTTP/1.1\r\nHost: 127.0.0.1:${port}\r\nConnection: close\r\n\r\n`),
    );
    socket.on('data', (data) => {
      answer += String(data);
    });
    socket.on('error', reject);
    socket.on('close', () => resolve(answer));
  });
}

describe('a description of tiles', () => {
  let folder: string;
  beforeEach(() => {
    folder = mkdtempSync(join(tmpdir(), 'tiles-'));
  });
  afterEach(() => rmSync(folder, { recursive: true }));

  test('has png from the north unless it says otherwise', () => {
    writeFileSync(join(folder, 'tiles.json'), JSON.stringify(set));
    expect(readTileFolder(folder)).toEqual({ folder, set, extension: 'png', fromSouth: false });
  });

  test('that is not there is one line', () => {
    expect(() => readTileFolder(folder)).toThrow(UsageError);
    expect(() => readTileFolder(folder)).toThrow(
      `--tiles: ${folder}/tiles.json: cannot be read (ENOENT); expected a description of the tiles`,
    );
  });

  test.each([
    ['{', 'expected a JSON object, got no JSON'],
    ['[]', 'expected a JSON object'],
    ['{}', /origin: expected \[longitude, latitude\] in degrees, .*, got none$/],
    [
      JSON.stringify({ ...set, maxzoom: 1 }),
      'maxzoom: expected a whole number from 2 (minzoom) to 30, got 1',
    ],
    [JSON.stringify({ ...set, format: 'pbf' }), 'format: expected png, jpg, jpeg, webp, got "pbf"'],
    [JSON.stringify({ ...set, scheme: 1 }), 'scheme: expected xyz or tms, got 1'],
  ])('%s is refused in one line', (text, line) => {
    writeFileSync(join(folder, 'tiles.json'), text);
    expect(() => readTileFolder(folder)).toThrow(UsageError);
    expect(() => readTileFolder(folder)).toThrow(line);
    expect(() => readTileFolder(folder)).toThrow(`--tiles: ${folder}/tiles.json: `);
  });
});
