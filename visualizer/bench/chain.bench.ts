// Simulator, bridge and page together: frames drawn, events lost, latency, processor time, memory.

import { spawn } from 'node:child_process';
import { expect, test } from 'vitest';
import { startPlayer } from '../bridge/testing';
import {
  atEnd,
  type BridgeProcess,
  type Opened,
  openPage,
  startBridge,
  startProgram,
  temporaryFolder,
} from '../test/harness';
import { cpuSeconds, median, proportionalMiB, report } from './measure';
import { recorded, streamProgram, writeScenario } from './scenarios';
import { readLog } from '../codec/log';

const seconds = 20;

// Publishes a scenario to the bridge's group; resolves when it is over.
function stream({ group }: BridgeProcess, scenario: string, speed = 1): Promise<void> {
  return new Promise((resolve, reject) => {
    const program = spawn(
      streamProgram,
      [`--lcm-url=udpm://${group}?ttl=0`, '--speed', String(speed), scenario],
      {
        stdio: ['ignore', 'ignore', 'pipe'],
      },
    );
    let said = '';
    program.stderr.on('data', (data: Buffer) => {
      said += String(data);
    });
    program.once('exit', (status) =>
      status === 0 ? resolve() : reject(new Error(`coptersim_stream: ${said}`)),
    );
  });
}

const eventsOf = (log: Uint8Array): number =>
  readLog(log).messages.filter(({ channel }) => channel === 'VIZ_EVENT').length;

// Notes in the page when each frame comes out of the WebSocket, in ms since 1970 by the number of the frame.
const noteArrivals = `{
  window.__arrivals = {};
  const Original = window.WebSocket;
  window.WebSocket = class extends Original {
    constructor(...all) {
      super(...all);
      this.addEventListener('message', ({ data }) => {
        const now = performance.timeOrigin + performance.now();
        if (typeof data === 'string') return;
        const read = (bytes) => {
          const view = new DataView(bytes);
          if (view.getUint8(0) === 9 && view.getUint8(5) === 70 && view.getUint8(6) === 82)
            window.__arrivals[view.getInt32(30)] = now;
        };
        if (data instanceof Blob) void data.arrayBuffer().then(read);
        else read(data);
      });
    }
  };
}`;

// When each frame left the simulator: seen on the group by a process that does nothing else meanwhile.
async function noteDepartures({ group }: BridgeProcess): Promise<Map<number, number>> {
  const [host = '', port = ''] = group.split(':');
  const departures = new Map<number, number>();
  const listener = await startPlayer(
    { host, port: Number(port), multicast: true, ttl: 0, receiveBuffer: 2 ** 21, network: false },
    (channel, payload) => {
      if (channel === 'VIZ_FRAME')
        departures.set(Buffer.from(payload).readInt32BE(20), performance.timeOrigin + performance.now());
    },
  );
  atEnd(() => void listener.close());
  return departures;
}

test.each([40, 400])('%i objects at 60 Hz for 20 s, from the player', async (count) => {
  const bridge = await startBridge({ control: true });
  const opened = await openPage(bridge.url);
  await opened.until((s) => s.connection.connected);
  startProgram(bridge, '--scenario', writeScenario(temporaryFolder(), count, 10 * seconds));
  await opened.until((s) => s.tUs > 500_000, 30_000);
  const [drawn, cpu, began] = [(await opened.stats()).drawn, cpuSeconds(bridge.pid()), performance.now()];
  await opened.page.waitForTimeout(1000 * seconds);
  const tookS = (performance.now() - began) / 1000;
  report(`viz_chain_fps_${count}`, ((await opened.stats()).drawn - drawn) / tookS, '1/s');
  if (count === 400) report('viz_bridge_cpu_pct', (100 * (cpuSeconds(bridge.pid()) - cpu)) / tookS, '%');
  // Each second of the flight has a command; the numbers of events have no gap.
  const seqs = await opened.state((s) => s.events.map(({ seq }) => seq));
  expect(seqs.length).toBeGreaterThan(0.9 * seconds);
  expect(seqs).toEqual(seqs.map((_, i) => (seqs[0] ?? 0) + i));
  expect(await opened.state((s) => s.connection.lost)).toBe(0);
});

test('latency from the simulator to the page with 40 objects, and no event lost', async () => {
  const folder = temporaryFolder();
  const scenario = writeScenario(folder, 40, seconds);
  const events = eventsOf(recorded(folder, 40, seconds));
  const bridge = await startBridge();
  const opened = await openPage('about:blank');
  await opened.page.addInitScript(noteArrivals);
  await opened.page.goto(bridge.url);
  await opened.until((s) => s.connection.connected);
  const departures = await noteDepartures(bridge);
  await stream(bridge, scenario);
  await expect
    .poll(() => opened.state((s) => [s.events.length, s.connection.lost]), { timeout: 10_000 })
    .toEqual([events, 0]);
  report('viz_latency_p50_ms', await latency(opened, departures), 'ms');
});

async function latency(opened: Opened, departures: ReadonlyMap<number, number>): Promise<number> {
  const arrivals = await opened.page.evaluate<Record<string, number>>('window.__arrivals');
  const took = Object.entries(arrivals).flatMap(([seq, at]) => {
    const left = departures.get(Number(seq));
    return left === undefined ? [] : [at - left];
  });
  expect(took.length).toBeGreaterThan(1000);
  return median(took);
}

test('memory of the page after ten minutes of 40 objects, which come ten times as fast', async () => {
  const bridge = await startBridge();
  const opened = await openPage(bridge.url);
  await opened.until((s) => s.connection.connected);
  await stream(bridge, writeScenario(temporaryFolder(), 40, 600), 10);
  await opened.until((s) => s.toUs >= 599_000_000);
  expect(await opened.state((s) => s.toUs - s.fromUs)).toBeGreaterThan(590_000_000);
  report('viz_page_mib', proportionalMiB(await opened.renderer()), 'MiB');
});
