import { describe, expect, test } from 'vitest';
import { packets, parsePacket } from './packet';

const hex = (text: string): Uint8Array => new Uint8Array(Buffer.from(text.replaceAll(' ', ''), 'hex'));
const view = (packet: Uint8Array): DataView => new DataView(packet.buffer, packet.byteOffset);

// All bytes in this file are written out by hand from the packet layout.
describe('packets', () => {
  test('a small message', () => {
    expect(parsePacket(hex('4c433032 00000102 414200 0506'))).toEqual({
      kind: 'small',
      sequence: 258,
      channel: 'AB',
      payload: hex('0506'),
    });
    expect(packets('AB', hex('0506'), 258)).toEqual([hex('4c433032 00000102 414200 0506')]);
  });

  test('fragments: the first carries the channel', () => {
    expect(packets('AB', hex('0102030405'), 7, 4)).toEqual([
      hex('4c433033 00000007 00000005 00000000 0000 0002 414200 01'),
      hex('4c433033 00000007 00000005 00000001 0001 0002 02030405'),
    ]);
    expect(parsePacket(hex('4c433033 00000007 00000005 00000001 0001 0002 02030405'))).toEqual({
      kind: 'fragment',
      sequence: 7,
      total: 5,
      offset: 1,
      number: 1,
      count: 2,
      channel: '',
      data: hex('02030405'),
    });
  });

  test('a payload of more than 64 kB is split as liblcm does', () => {
    const parts = packets('VIZ_FRAME', new Uint8Array(78_028), 1);
    expect(parts.map(({ length }) => length)).toEqual([20 + 65_487, 20 + 78_028 - (65_487 - 10)]);
    expect(packets('VIZ_FRAME', new Uint8Array(65_489), 1).length).toBe(1);
    expect(packets('VIZ_FRAME', new Uint8Array(65_490), 1).length).toBe(2);
  });
});

describe('what is no packet', () => {
  test.each([
    ['4c4330', '3 bytes are no LCM packet'],
    ['4c433034 00000000', '4c433034 begins no LCM packet'],
    ['4c433032 00000000 4142', 'no channel of at most 63 bytes with a NUL after it'],
    [`4c433032 00000000 ${'41'.repeat(64)}00`, 'no channel of at most 63 bytes with a NUL after it'],
    ['4c433032 00000000 00 01', 'a channel without a name'],
    ['4c433033 00000000 00000001', 'a fragment of 12 bytes has no header'],
    [
      '4c433033 00000000 01000001 00000000 0000 0001 4100 01',
      'a message of 16777217 bytes, at most 16777216 are taken',
    ],
    ['4c433033 00000000 00000001 00000000 0001 0001 01', 'fragment 1 of 1'],
    ['4c433033 00000000 00000001 00000000 0000 0000 4100 01', 'fragment 0 of 0'],
    ['4c433033 00000000 00000001 00000001 0001 0002', 'fragment 1 of 2 is empty'],
    ['4c433033 00000000 00000002 00000001 0001 0002 0102', 'fragment 1 ends at byte 3 of a message of 2'],
    [
      '4c433033 00000000 00000002 ffffffff 0001 0002 0102',
      'fragment 1 ends at byte 4294967297 of a message of 2',
    ],
  ])('%s', (bytes, line) => {
    expect(parsePacket(hex(bytes))).toBe(line);
  });

  test.each(['', 'A'.repeat(64), 'A\0B'])('channel "%s" is not sent', (channel) => {
    expect(() => packets(channel, new Uint8Array(1), 0)).toThrow('a channel has 1 to 63 bytes');
  });

  test('a packet may lie anywhere in a larger buffer', () => {
    const whole = new Uint8Array([9, 9, 9, ...hex('4c433032 00000001 4100 07')]);
    expect(parsePacket(whole.subarray(3))).toMatchObject({ sequence: 1, payload: hex('07') });
    expect(view(whole.subarray(3)).getUint32(4)).toBe(1);
  });
});
