import { gzipSync } from 'node:zlib';
import { describe, expect, it } from 'vitest';
import { writeLog } from '../../../codec/log';
import type { Message } from '../../../codec/messages';
import { encodeMessage } from '../../../codec/viz';
import { aFrame, aRisk } from '../model/testing';
import { bridgeUrl } from './browser';
import { parseCases } from './case_list';
import { unpacked } from './embedded_log';
import { formatFragment, parseFragment } from './fragment';
import { readVizLog } from './read_viz_log';

const part = (channel: string, data: Uint8Array) => ({ timeUs: 1, channel, data });
const logOf = (messages: readonly Message[]) =>
  messages.map((message) => part(message.channel, encodeMessage(message)));

async function read(bytes: Uint8Array<ArrayBuffer>) {
  const taken: Message[] = [];
  let pauses = 0;
  const problem = await readVizLog(
    bytes.buffer.slice(0, bytes.byteLength),
    (m) => taken.push(m),
    async () => {
      pauses += 1;
    },
  );
  return { taken, problem, pauses };
}

describe('a log', () => {
  const messages = [aFrame(5), { channel: 'VIZ_RISK', value: aRisk(1, 5) } as const];

  it('gives its messages and leaves other channels alone', async () => {
    const bytes = writeLog([part('OTHER', new Uint8Array(3)), ...logOf(messages)]);
    const { taken, problem } = await read(bytes);
    expect(taken.map((message) => message.channel)).toEqual(['VIZ_FRAME', 'VIZ_RISK']);
    expect(taken[0]?.value).toMatchObject({ tUs: 5, run: 1 });
    expect(problem).toBe('');
  });

  it('a long one is read in turns', async () => {
    const { taken, pauses } = await read(writeLog(logOf(Array.from({ length: 4500 }, (_, i) => aFrame(i)))));
    expect([taken.length, pauses]).toEqual([4500, 2]);
  });

  it('a cut one gives what is whole, and says where it ends', async () => {
    const whole = writeLog(logOf(messages));
    const { taken, problem } = await read(whole.slice(0, whole.length - 5));
    expect(taken).toHaveLength(1);
    expect(problem).toContain('ends within a message');
  });

  it('one of another layout is a mismatch, never a guess', async () => {
    const data = encodeMessage(aFrame(5));
    data[0] = (data[0] ?? 0) ^ 1;
    await expect(read(writeLog([part('VIZ_FRAME', data)]))).rejects.toThrow('type mismatch: rebuild');
  });

  it('something else is refused in one line', async () => {
    await expect(
      read(new TextEncoder().encode('<html>not a log at all, but long enough</html>')),
    ).rejects.toThrow('not an LCM log or a report');
    await expect(read(new Uint8Array(0))).rejects.toThrow('not an LCM log or a report');
  });
});

describe('the log in a report', () => {
  const text = 'a log '.repeat(1000);
  const base64 = gzipSync(text).toString('base64');

  it('comes back as it was, also wrapped into lines', async () => {
    const lines = base64.replace(/(.{20})/g, '$1\n  ');
    expect(new TextDecoder().decode(await unpacked(lines, 1e6))).toBe(text);
  });

  it('is refused when damaged or too large', async () => {
    await expect(unpacked('***', 1e6)).rejects.toThrow('not base64');
    await expect(unpacked(base64.slice(0, 24), 1e6)).rejects.toThrow('not whole gzip');
    await expect(unpacked(base64, 100)).rejects.toThrow('over 100 bytes');
  });
});

describe('the address', () => {
  it('goes there and back', () => {
    const place = { caseId: 'c_1-2', tUs: 7_420_000, observer: 4 };
    expect(formatFragment(place)).toBe('#case=c_1-2&t=7.420&obs=4');
    expect(parseFragment('#case=c_1-2&t=7.420&obs=4')).toEqual(place);
    expect(formatFragment({ caseId: null, tUs: null, observer: -1 })).toBe('');
  });

  it('leaves out what makes no sense', () => {
    const nothing = { caseId: null, tUs: null, observer: null };
    expect(parseFragment('')).toEqual(nothing);
    expect(parseFragment('#case=../etc&t=-1&obs=1.5')).toEqual(nothing);
    expect(parseFragment('#t=abc&obs=')).toEqual(nothing);
    expect(parseFragment('#t=1e99')).toEqual(nothing);
  });
});

it('the list of cases keeps what is one', () => {
  expect(parseCases([{ id: 'a', title: 'A' }, { id: 'b' }, 'c', 7, null, { title: 'x' }])).toEqual([
    { id: 'a', title: 'A' },
    { id: 'b', title: 'b' },
    { id: 'c', title: 'c' },
  ]);
  expect(parseCases({})).toEqual([]);
});

it('a bridge is where the page came from, a file has none', () => {
  expect(bridgeUrl({ protocol: 'http:', host: '127.0.0.1:8765' })).toBe('ws://127.0.0.1:8765/ws');
  expect(bridgeUrl({ protocol: 'file:', host: '' })).toBeNull();
});
