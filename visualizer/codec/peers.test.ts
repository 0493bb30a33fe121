// Against what liblcm and the code of lcm-gen wrote (test/data/README.md).

import { readFileSync } from 'node:fs';
import { gunzipSync } from 'node:zlib';
import { describe, expect, test } from 'vitest';
import { readLog } from './log';
import type { Channel } from './messages';
import { packets } from './packet';
import { Reassembly } from './reassembly';
import { channelTypes, decodeControl, decodeMessage, encodeMessage, vizSchema } from './viz';

interface Fixture {
  types: Record<string, string>;
  messages: { channel: string; type: string; value: unknown; bytes: string }[];
  packets: string[];
}

const data = (name: string): Buffer =>
  gunzipSync(readFileSync(new URL(`../../test/data/${name}`, import.meta.url)));
const fixture = JSON.parse(String(data('viz_messages.json.gz'))) as Fixture;
const hex = (text: string): Uint8Array => new Uint8Array(Buffer.from(text, 'hex'));

const special: Record<string, number> = { inf: Infinity, neg_inf: -Infinity, nan: NaN };
const counts = new Set(['n', 'ncmd', 'nseg', 'nanchor', 'npoly', 'npt', 'nargs']);
const yesOrNo = new Set(['overlap', 'used', 'active', 'paused', 'control_allowed', 'ok']);
const texts = new Set([
  'name',
  'text',
  'message',
  'kind',
  'verb',
  'probe',
  'type',
  'params',
  'client',
  'token',
]);

// The fixture's value as our decoder gives it: camel case, no counts, yes or no as booleans.
function ours(value: unknown, key = ''): unknown {
  if (Array.isArray(value)) return value.map((item) => ours(item, key));
  if (typeof value === 'object' && value !== null) {
    const members = Object.entries(value).filter(([name]) => !counts.has(name));
    return Object.fromEntries(members.map(([name, member]) => [camel(name), ours(member, name)]));
  }
  if (yesOrNo.has(key)) return value !== 0;
  return typeof value === 'string' && value in special && !texts.has(key) ? special[value] : value;
}
const camel = (name: string): string => name.replace(/_./g, (match) => match.charAt(1).toUpperCase());

const isControl = (channel: string): boolean => channel === 'VIZ_CONTROL';
function decode(channel: string, bytes: Uint8Array): unknown {
  if (isControl(channel)) return decodeControl(bytes);
  const decoded = decodeMessage(channel, bytes);
  return decoded.ok ? decoded.message.value : decoded.error;
}

describe('what liblcm wrote', () => {
  test('fingerprints are those of lcm-gen', () => {
    const names = Object.keys(fixture.types);
    expect(names.length).toBe(vizSchema.names().length);
    for (const name of names)
      expect(vizSchema.fingerprint(`viz.${name}`).toString(16).padStart(16, '0')).toBe(fixture.types[name]);
  });

  test('every message is decoded to its values', () => {
    expect(new Set(fixture.messages.map(({ channel }) => channel)).size).toBe(
      Object.keys(channelTypes).length + 1,
    );
    for (const { channel, value, bytes } of fixture.messages)
      expect(decode(channel, hex(bytes))).toEqual(ours(value));
  });

  test('every message is encoded to the same bytes, where yes and no are 1 and 0', () => {
    const plain = fixture.messages.filter(
      ({ channel, value }) =>
        !isControl(channel) &&
        ![...JSON.stringify(value).matchAll(/"(\w+)":(-?\d+)/g)].some(
          ([, key = '', number]) => yesOrNo.has(key) && number !== '0' && number !== '1',
        ),
    );
    expect(plain.length).toBeGreaterThan(50);
    for (const { channel, bytes } of plain) {
      const decoded = decodeMessage(channel, hex(bytes));
      if (!decoded.ok) throw new Error(decoded.error);
      expect(Buffer.from(encodeMessage(decoded.message)).toString('hex')).toBe(bytes);
    }
  });

  test('a log holds the same messages', () => {
    const log = readLog(data('viz_messages.lcm.gz'));
    expect(log.problem).toBe('');
    expect(
      log.messages.map(({ number, timeUs, channel, data: bytes }) => [
        number,
        timeUs,
        channel,
        Buffer.from(bytes).toString('hex'),
      ]),
    ).toEqual(fixture.messages.map(({ channel, bytes }, i) => [i, 1000 * i, channel, bytes]));
  });

  test('packets, two of them fragments, are put together, and ours are the same bytes', () => {
    const reassembly = new Reassembly();
    const whole = fixture.packets.flatMap((packet) => reassembly.accept('127.0.0.1:1', hex(packet)) ?? []);
    const messages = whole.filter((one) => typeof one !== 'string');
    expect(messages.length).toBe(11);
    expect(reassembly.lost).toBe(0);
    expect(messages.slice(0, 10).map(({ payload }) => Buffer.from(payload).toString('hex'))).toEqual(
      fixture.messages.slice(0, 10).map(({ bytes }) => bytes),
    );
    const frame = decodeMessage('VIZ_FRAME', messages[10]?.payload ?? new Uint8Array());
    expect(
      frame.ok && (frame.message.value as { objects: { id: number }[] }).objects.map(({ id }) => id),
    ).toEqual(Array.from({ length: 1000 }, (_, i) => i));
    const again = messages.flatMap(({ channel, payload }, i) => packets(channel as Channel, payload, i));
    expect(again.map((packet) => Buffer.from(packet).toString('hex'))).toEqual(fixture.packets);
  });
});
