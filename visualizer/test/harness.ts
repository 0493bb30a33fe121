// What every browser test begins with: pages in a browser, the real bridge as a program, a player that does what the
// test says. Everything is taken down at the end of the test that asked for it.

import { type ChildProcess, spawn } from 'node:child_process';
import { existsSync, mkdirSync, mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { createServer } from 'node:http';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { type Browser, type BrowserContextOptions, chromium, type Page } from 'playwright-core';
import { afterAll, afterEach, beforeAll, expect, inject } from 'vitest';
import { Changes, freePort, startPlayer } from '../bridge/testing';
import type { Control } from '../codec/messages';
import type { ViewerState } from '../page/src/model/viewer';
import type { MapView } from '../page/src/map/map_view';

const root = fileURLToPath(new URL('../..', import.meta.url));
export const testPage = join(root, '_build/visualizer/page.html');
const bridgeProgram = join(root, 'visualizer/dist/bridge.mjs');
// The system's Node, which is what users have; it is older than the one that runs the tests.
const node = existsSync('/usr/bin/node') ? '/usr/bin/node' : process.execPath;

let browser: Browser;
const endings: (() => Promise<void> | void)[] = [];

beforeAll(async () => {
  browser = await chromium.connect(inject('browser'));
});
afterAll(() => browser.close());
afterEach(async () => {
  for (const end of endings.splice(0).reverse()) await end();
});

// Nothing here takes so long; a machine that others use as well is waited for, and it costs nothing when all is well.
export const limitMs = 30_000;

export const atEnd = (end: () => Promise<void> | void): void => void endings.push(end);

export function temporaryFolder(): string {
  const folder = mkdtempSync(join(tmpdir(), 'viz-'));
  atEnd(() => rmSync(folder, { recursive: true }));
  return folder;
}

// A page, with what it wrote to its console and what it asked of the network.
export interface Opened {
  page: Page;
  errors: string[]; // of the console and uncaught ones
  requests: string[];
  state<T>(look: (state: ViewerState) => T): Promise<T>;
  until(look: ((state: ViewerState) => unknown) | string, limitMs?: number): Promise<void>; // look must be self-contained
  stats(): Promise<MapStats>;
  renderer(): Promise<number>; // process id of the page
}

type MapStats = ReturnType<MapView['stats']>;

interface Viz {
  state(): ViewerState;
  stats(): MapStats;
}

export async function openPage(url: string, options: BrowserContextOptions = {}): Promise<Opened> {
  const context = await browser.newContext({ viewport: { width: 1440, height: 900 }, ...options });
  atEnd(() => context.close());
  context.setDefaultTimeout(limitMs);
  const page = await context.newPage();
  const errors: string[] = [];
  const requests: string[] = [];
  page.on('console', (message) => {
    if (message.type() === 'error' || message.type() === 'warning') errors.push(message.text());
  });
  page.on('pageerror', (error) => errors.push(error.message));
  page.on('request', (request) => requests.push(request.url()));
  await page.goto(url);
  // As text, which the browser evaluates beyond the page's content security policy.
  const state = <T>(look: (state: ViewerState) => T): Promise<T> =>
    page.evaluate(`(${String(look)})(window.__viz.state())`);
  return {
    page,
    errors,
    requests,
    state,
    until: async (look, limit = limitMs) => {
      const found = await page.evaluate(untilInPage(String(look), limit));
      if (found !== '') throw new Error(`not within ${limit} ms: ${String(look)}; ${String(found)}`);
    },
    stats: () => page.evaluate(() => (window as unknown as { __viz: Viz }).__viz.stats()),
    renderer: () => rendererOf(page),
  };
}

// Looks at each animation frame. Ends with '' or, when it is too late, with what the state was.
const untilInPage = (look: string, limitMs: number): string => `new Promise((resolve) => {
  const end = performance.now() + ${limitMs};
  const ask = () => {
    const state = window.__viz?.state();
    if (state && (${look})(state)) resolve('');
    else if (performance.now() < end) requestAnimationFrame(ask);
    else {
      const { badge, tUs, fromUs, toUs, run, playing, following, observer, events, connection } = state ?? {};
      resolve(JSON.stringify({ badge, tUs, fromUs, toUs, run, playing, following, observer, events: events?.length, connection }));
    }
  };
  ask();
})`;

// The process of a page: the one that spins when the page does. Chromium does not say which it is.
async function rendererOf(page: Page): Promise<number> {
  const session = await browser.newBrowserCDPSession();
  const times = async (): Promise<Map<number, number>> => {
    const { processInfo } = await session.send('SystemInfo.getProcessInfo');
    return new Map(
      processInfo.filter(({ type }) => type === 'renderer').map(({ id, cpuTime }) => [id, cpuTime]),
    );
  };
  const before = await times();
  await page.evaluate('{ const end = performance.now() + 300; while (performance.now() < end); }');
  const after = await times();
  await session.detach();
  const busiest = [...after].map(([id, time]) => ({ id, spent: time - (before.get(id) ?? 0) }));
  return busiest.toSorted((a, b) => b.spent - a.spent)[0]?.id ?? 0;
}

// The page of the tests opened as a file, without any bridge, with this log in it.
export async function openLog(log: Uint8Array, options: BrowserContextOptions = {}): Promise<Opened> {
  const opened = await openPage(`file://${testPage}`, options);
  await opened.page
    .locator('input[type=file]')
    .setInputFiles({ name: 'scene.lcm', mimeType: 'application/octet-stream', buffer: Buffer.from(log) });
  await opened.until((state) => state.badge === 'FILE' && state.frame !== null);
  await drawn(opened.page);
  return opened;
}

// Once everything that was asked for before is on the screen.
export async function drawn(page: Page): Promise<void> {
  await page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
}

export interface BridgeProcess {
  url: string;
  port: number;
  group: string;
  cases: string;
  tokenFile: string;
  lines: string[];
  said: Changes;
  pid(): number;
  kill(): Promise<void>;
  restart(): Promise<void>; // on the same port
}

export interface BridgeSettings {
  control?: boolean;
  cases?: Record<string, Uint8Array>; // id: log
  tiles?: string; // folder
}

export async function startBridge(settings: BridgeSettings = {}): Promise<BridgeProcess> {
  const folder = temporaryFolder();
  const cases = join(folder, 'cases');
  for (const [id, log] of Object.entries(settings.cases ?? {})) {
    mkdirSync(join(cases, id), { recursive: true });
    writeFileSync(join(cases, id, 'run.lcm'), log);
  }
  const tokenFile = join(folder, 'token');
  const group = `239.255.76.67:${await freePort()}`;
  const lines: string[] = [];
  const said = new Changes();
  let child: ChildProcess | null = null;
  const start = async (port: number): Promise<number> => {
    const control = settings.control ? ['--allow-control', '--token-file', tokenFile] : [];
    const tiles = settings.tiles === undefined ? [] : ['--tiles', settings.tiles];
    const before = lines.length;
    const program = spawn(
      node,
      [
        bridgeProgram,
        '--port',
        String(port),
        '--group',
        group,
        '--cases',
        cases,
        '--page',
        testPage,
        ...control,
        ...tiles,
      ],
      { stdio: ['ignore', 'pipe', 'pipe'] },
    );
    child = program;
    for (const stream of [program.stdout, program.stderr])
      stream.on('data', (data: Buffer) => {
        lines.push(...String(data).split('\n').filter(Boolean));
        said.changed();
      });
    const ready = await said.until(
      () => lines.slice(before).find((line) => line.includes('http://')),
      'the bridge',
    );
    return Number(/:(\d+)\/ /.exec(ready)?.[1]);
  };
  const kill = async (): Promise<void> => {
    const program = child;
    child = null;
    if (!program || program.exitCode !== null) return;
    const gone = new Promise((resolve) => program.once('exit', resolve));
    program.kill('SIGKILL');
    await gone;
  };
  atEnd(kill);
  const port = await start(0);
  const restart = async (): Promise<void> => {
    await kill();
    await start(port);
  };
  return {
    url: `http://127.0.0.1:${port}/`,
    port,
    group,
    cases,
    tokenFile,
    lines,
    said,
    pid: () => child?.pid ?? 0,
    kill,
    restart,
  };
}

export interface Program {
  kill(): Promise<void>;
}

// The real player, bin/faultcheck play, for this bridge; it may be controlled. Needs the Erlang side built.
export function startProgram({ group, cases, tokenFile }: BridgeProcess, ...options: string[]): Program {
  const place = ['--group', `udpm://${group}?ttl=0`, '--cases', cases];
  const control = ['--allow-control', '--token-file', tokenFile];
  const program = spawn(join(root, 'bin/faultcheck'), ['play', ...place, ...control, ...options], {
    stdio: 'ignore',
  });
  const gone = new Promise<void>((resolve) => program.once('exit', () => resolve()));
  const kill = (): Promise<void> => {
    program.kill('SIGKILL');
    return gone;
  };
  atEnd(kill);
  return { kill };
}

export type Player = Awaited<ReturnType<typeof startPlayer>> & { answerAll(): void };

// Publishes to the bridge's group, and hears what pages ask.
export async function joinPlayer({ group }: Pick<BridgeProcess, 'group'>): Promise<Player> {
  const [host = '', port = ''] = group.split(':');
  const player = await startPlayer({
    host,
    port: Number(port),
    multicast: true,
    ttl: 0,
    receiveBuffer: 2 ** 21,
    network: false,
  });
  atEnd(() => void player.close());
  let answered = 0;
  // Says yes to whatever has been asked and whatever will be.
  const answerAll = (): void => {
    const answer = ({ client, seq }: Control) =>
      player.publish({ channel: 'VIZ_ACK', value: { client, seq, ok: true, text: '' } });
    const next = async (): Promise<void> => {
      for (const control of player.controls.slice(answered)) {
        answered += 1;
        await answer(control);
      }
    };
    player.heard.each(() => void next());
  };
  return { ...player, answerAll };
}

// A web site of somebody else on this host.
export async function foreignSite(): Promise<string> {
  const server = createServer((_, response) => {
    response.setHeader('Content-Type', 'text/html');
    response.end('<!doctype html><title>foreign</title>');
  });
  await new Promise<void>((resolve) => server.listen(0, '127.0.0.1', resolve));
  atEnd(() => void server.close());
  const address = server.address();
  return `http://127.0.0.1:${typeof address === 'object' && address ? address.port : 0}/`;
}

// A page that is used as it should be has nothing to complain about.
export function expectNoErrors({ errors }: Opened): void {
  expect(errors).toEqual([]);
}
