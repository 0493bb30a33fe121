// What Erlang makes of a recording (apps/replay: MCAP, CSV) against two independent readers: MCAP's
// own library, and this codec, which reads the recording itself.

import { execFileSync } from 'node:child_process';
import { existsSync, mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join, resolve } from 'node:path';
import { McapIndexedReader } from '@mcap/core';
import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import { readLog } from './log';
import type { Frame, Message } from './messages';
import { decodeMessage } from './viz';

const root = resolve(import.meta.dirname, '../..');
const folder = mkdtempSync(join(tmpdir(), 'exports-'));

// A stored flight in which two copters collide, recorded and exported.
const script = `
  {ok, _} = application:ensure_all_started(c_bridge),
  [Dir] = init:get_plain_arguments(),
  {ok, View} = copter_view:open({named, "jump"}),
  {ok, _} = replay_recording:write({copter_view, View}, filename:join(Dir, "run.lcm")),
  [{ok, [_ | _]} = replay_export:write(Dir, #{format => F}) || F <- [mcap, csv, svg]],
  halt(0).`;

interface Pose {
  position: { x: number; y: number; z: number };
}

let messages: Message[] = [];
let frames: Frame[] = [];
let reader: McapIndexedReader;

function recorded(): Message[] {
  const log = readLog(readFileSync(join(folder, 'run.lcm')));
  expect(log.problem).toBe('');
  return log.messages.map(({ channel, data }) => {
    const decoded = decodeMessage(channel, data);
    if (!decoded.ok) throw new Error(decoded.error);
    return decoded.message;
  });
}

beforeAll(async () => {
  const built = ['default', 'test']
    .map((profile) => join(root, '_build', profile, 'lib'))
    .find((lib) => existsSync(join(lib, 'replay/ebin/replay_export.beam')));
  if (built === undefined) throw new Error('the Erlang side is not built; run: make compile');
  execFileSync('erl', ['-noinput', '-boot', 'no_dot_erlang', '-eval', script, '-extra', folder], {
    cwd: root,
    env: { ...process.env, ERL_LIBS: built },
    timeout: 60_000,
  });
  messages = recorded();
  frames = messages.flatMap((message) => (message.channel === 'VIZ_FRAME' ? [message.value] : []));
  const file = readFileSync(join(folder, 'run.mcap'));
  reader = await McapIndexedReader.Initialize({
    readable: {
      size: () => Promise.resolve(BigInt(file.byteLength)),
      read: (offset, size) => Promise.resolve(file.subarray(Number(offset), Number(offset + size))),
    },
  });
}, 90_000);

afterAll(() => rmSync(folder, { recursive: true, force: true }));

// All messages of a topic: time (us) and content.
async function topic<T>(name: string): Promise<{ tUs: number; value: T }[]> {
  const found: { tUs: number; value: T }[] = [];
  for await (const { logTime, data } of reader.readMessages({ topics: [name] })) {
    found.push({ tUs: Number(logTime) / 1000, value: JSON.parse(new TextDecoder().decode(data)) });
  }
  return found;
}

const near = (a: number, b: number): boolean => Math.abs(a - b) <= 1e-6;

function distance(a: readonly number[], b: readonly number[]): number {
  return Math.hypot(...a.map((value, axis) => value - (b[axis] ?? NaN)));
}

describe('MCAP', () => {
  it('names the well-known schemas, as JSON schemas', () => {
    const schemas = [...reader.schemasById.values()];
    expect(schemas.map(({ name }) => name).sort()).toEqual([
      'foxglove.Log',
      'foxglove.PosesInFrame',
      'foxglove.SceneUpdate',
      'viz.Number',
    ]);
    for (const { encoding, data } of schemas) {
      expect(encoding).toBe('jsonschema');
      expect(JSON.parse(new TextDecoder().decode(data))).toMatchObject({ type: 'object' });
    }
  });

  it('has the number of messages that its statistics tell', async () => {
    let count = 0n;
    for await (const message of reader.readMessages()) count += message.data.byteLength > 0 ? 1n : 0n;
    expect(count).toBe(reader.statistics?.messageCount);
    expect(count).toBeGreaterThan(BigInt(frames.length));
  });

  it('has the true and the perceived position of each object in each frame', async () => {
    for (const [name, pick] of [
      ['/poses', 'pos'],
      ['/poses_perceived', 'posEst'],
    ] as const) {
      const poses = await topic<{ poses: Pose[] }>(name);
      expect(poses.map(({ tUs }) => tUs)).toEqual(frames.map(({ tUs }) => tUs));
      for (const [index, { value }] of poses.entries()) {
        const objects = frames[index]?.objects ?? [];
        expect(value.poses).toHaveLength(objects.length);
        for (const [row, { position }] of value.poses.entries()) {
          const expected = objects[row]?.[pick] ?? [NaN, NaN, NaN];
          expect(
            [position.x, position.y, position.z].every((v, axis) => near(v, expected[axis] ?? NaN)),
          ).toBe(true);
        }
      }
    }
  });

  it('has every event as a line of the log, collisions as errors', async () => {
    const events = messages.flatMap((message) => (message.channel === 'VIZ_EVENT' ? [message.value] : []));
    const log = await topic<{ message: string; name: string; level: number }>('/log');
    expect(log.map(({ tUs, value }) => [tUs, value.name, value.message])).toEqual(
      events.map(({ tUs, kind, text }) => [tUs, kind, text]),
    );
    expect(log.filter(({ value }) => value.level === 4)).toHaveLength(
      events.filter(({ kind }) => kind === 'collision').length,
    );
    expect(events.some(({ kind }) => kind === 'collision')).toBe(true);
  });

  it('has curves for each object', async () => {
    const id = frames[0]?.objects[0]?.id ?? -1;
    const curve = await topic<{ value: number }>(`/objects/${id}/position_error`);
    expect(curve).toHaveLength(frames.length);
    for (const [index, { value }] of curve.entries()) {
      const object = frames[index]?.objects[0];
      expect(near(value.value, distance(object?.pos ?? [], object?.posEst ?? []))).toBe(true);
    }
  });

  it('can be read from the middle', async () => {
    const from = frames[Math.floor(frames.length / 2)]?.tUs ?? 0;
    const times: number[] = [];
    for await (const { logTime } of reader.readMessages({
      topics: ['/poses'],
      startTime: BigInt(from * 1000),
    })) {
      times.push(Number(logTime) / 1000);
    }
    expect(times).toEqual(frames.map(({ tUs }) => tUs).filter((tUs) => tUs >= from));
  });
});

describe('CSV', () => {
  it('has a line for each frame and object, with the curves', () => {
    const lines = readFileSync(join(folder, 'run.csv'), 'utf8').split('\r\n');
    expect(lines.at(-1)).toBe('');
    const [header = '', ...rows] = lines.slice(0, -1);
    const columns = header.split(',');
    const rowsExpected = frames.flatMap((frame) => frame.objects.map((object) => ({ frame, object })));
    expect(rows).toHaveLength(rowsExpected.length);
    for (const [index, row] of rows.entries()) {
      const fields = row.split(',');
      const field = (name: string): number => Number(fields[columns.indexOf(name)]);
      const { frame, object } = rowsExpected[index] ?? {};
      if (frame === undefined || object === undefined) throw new Error('a line too many');
      const others = frame.objects.filter(({ id }) => id !== object.id);
      const expected: Record<string, number> = {
        t_s: frame.tUs / 1e6,
        object: object.id,
        x_m: object.pos[0],
        y_est_m: object.posEst[1],
        vy_m_s: object.vel[1],
        yaw_rad: object.yaw,
        steer_pitch_rad: object.steer[1],
        comfort_m: object.comfort,
        collided: object.flags & 1,
        position_error_m: distance(object.pos, object.posEst),
        velocity_error_m_s: distance(object.vel, object.velEst),
        nearest_m: Math.min(...others.map(({ pos }) => distance(object.pos, pos))),
      };
      for (const [name, value] of Object.entries(expected)) {
        expect([index, name, near(field(name), value)]).toEqual([index, name, true]);
      }
    }
  });
});

describe('SVG', () => {
  it('shows the end of the flight: whoever collided has a mark', () => {
    const svg = readFileSync(join(folder, 'map.svg'), 'utf8');
    const collided = frames.at(-1)?.objects.filter(({ flags }) => flags & 1).length ?? 0;
    expect(collided).toBeGreaterThan(0);
    expect(svg.split('l26 26m0 -26l-26 26').length - 1).toBe(collided);
    expect(svg).toContain(`t = ${((frames.at(-1)?.tUs ?? 0) / 1e6).toFixed(3)} s`);
  });

  it('has a line for each object of the curves', () => {
    const svg = readFileSync(join(folder, 'position-error.svg'), 'utf8');
    const ids = new Set(frames.flatMap(({ objects }) => objects.map(({ id }) => id)));
    expect(svg.split('<polyline').length - 1).toBe(Math.min(5, ids.size));
  });
});
