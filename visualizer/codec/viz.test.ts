import { describe, expect, test } from 'vitest';
import type { Message } from './messages';
import { sampleFrame, sampleMessages } from './samples';
import {
  channels,
  channelTypes,
  decodeControl,
  decodeMessage,
  encodeControl,
  encodeMessage,
  vizSchema,
} from './viz';

const hex = (bytes: Uint8Array): string => Buffer.from(bytes).toString('hex');

function errorOf(channel: string, payload: Uint8Array): string {
  const decoded = decodeMessage(channel, payload);
  return decoded.ok ? 'decoded' : decoded.error;
}

describe('messages as bytes', () => {
  test('there is a sample of every channel', () => {
    expect(sampleMessages.map(({ channel }) => channel).sort()).toEqual([...channels].sort());
  });

  test.each(sampleMessages.map((message) => [message.channel, message] as const))(
    '%s comes back as it went',
    (channel, message) => {
      expect(decodeMessage(channel, encodeMessage(message))).toEqual({ ok: true, message });
    },
  );

  // By hand: fingerprint of lcm-gen, "page" + NUL with its length, 5, 1, empty text.
  test('an answer has the bytes that the LCM layout asks for', () => {
    const ack: Message = { channel: 'VIZ_ACK', value: { client: 'page', seq: 5, ok: true, text: '' } };
    expect(hex(encodeMessage(ack))).toBe(
      'c172967dd907c581' + '000000057061676500' + '00000005' + '01' + '0000000100',
    );
  });

  test.each(['VIZ_FRAME', 'VIZ_RISK'] as const)('%s read by hand is what the schema reads', (channel) => {
    const message = sampleMessages.find((sample) => sample.channel === channel);
    if (!message) throw new Error(channel);
    const payload = encodeMessage(message);
    expect(decodeMessage(channel, payload)).toEqual({
      ok: true,
      message: { channel, value: vizSchema.decode(channelTypes[channel], payload) },
    });
  });

  test('a control message comes back as it went', () => {
    const control = { client: 'c', token: 't', seq: 1, verb: 'seek', object: -1, args: [7.42], text: '' };
    expect(decodeControl(encodeControl(control))).toEqual(control);
  });
});

describe('what is no message', () => {
  test.each(sampleMessages.map((message) => [message.channel, message] as const))(
    '%s cut off anywhere is refused in one line, and so is a byte too many',
    (channel, message) => {
      const payload = encodeMessage(message);
      for (let size = 0; size < payload.length; size += 1)
        expect(errorOf(channel, payload.subarray(0, size))).toMatch(new RegExp(`^${channel}: [^\n]+$`));
      expect(errorOf(channel, new Uint8Array([...payload, 0]))).toMatch(/bytes/);
    },
  );

  test('another layout is a type mismatch', () => {
    const payload = encodeMessage({ channel: 'VIZ_FRAME', value: sampleFrame(1) });
    expect(errorOf('VIZ_RISK', payload)).toBe(
      'VIZ_RISK: type mismatch: rebuild (viz.risk has another layout here)',
    );
  });

  test('a channel that is not ours says so', () => {
    expect(errorOf('OTHER', new Uint8Array(8))).toBe('OTHER: no channel of the visualizer');
  });

  test.each([0x7fffffff, -1, 3])('a frame that claims %i objects takes no memory for them', (n) => {
    const payload = encodeMessage({ channel: 'VIZ_FRAME', value: sampleFrame(2) });
    new DataView(payload.buffer).setInt32(24, n);
    expect(errorOf('VIZ_FRAME', payload)).toBe(
      `VIZ_FRAME: frame.objects: ${n} of 78 bytes, 156 bytes are left`,
    );
  });

  test('an array that claims more items than there are bytes is refused', () => {
    const world = sampleMessages.find(({ channel }) => channel === 'VIZ_WORLD');
    if (!world) throw new Error('no world');
    const payload = encodeMessage(world);
    new DataView(payload.buffer).setInt32(16, 0x7fffffff);
    expect(errorOf('VIZ_WORLD', payload)).toMatch(
      /^VIZ_WORLD: world.seg at byte 20: 2147483647 items in \d+ bytes$/,
    );
  });

  test.each([
    [{ client: 'a', seq: 0.5, ok: true, text: '' }, 'ack.seq: 0.5 is no int32_t'],
    [{ client: 'a', seq: 2 ** 31, ok: true, text: '' }, 'ack.seq: 2147483648 is no int32_t'],
    [{ client: 1, seq: 1, ok: true, text: '' }, 'ack.client: expected a string'],
    [{ client: 'a', seq: 1, ok: true }, 'ack.text: expected a string'],
  ])('a value that does not fit is not encoded: %o', (value, line) => {
    expect(() => vizSchema.encode('viz.ack', value)).toThrow(line);
  });
});

test('a frame of 400 objects is read in less than 0.1 ms', () => {
  const payload = encodeMessage({ channel: 'VIZ_FRAME', value: sampleFrame(400) });
  const run = (): number => {
    const before = performance.now();
    for (let i = 0; i < 50; i += 1) decodeMessage('VIZ_FRAME', payload);
    return (performance.now() - before) / 50;
  };
  const times = Array.from({ length: 40 }, run);
  expect(Math.min(...times)).toBeLessThan(0.1);
});
