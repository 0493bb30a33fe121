import { describe, expect, test } from 'vitest';
import { readLog, writeLog } from './log';

const text = (value: string): Uint8Array => new TextEncoder().encode(value);
const messages = [
  { timeUs: 1_700_000_000_000_001, channel: 'VIZ_EVENT', data: text('one') },
  { timeUs: 1_700_000_000_000_002, channel: 'X', data: text('') },
  { timeUs: 1_700_000_000_000_003, channel: 'VIZ_FRAME', data: text('three') },
];

describe('log files', () => {
  test('what is written is read', () => {
    const log = readLog(writeLog(messages));
    expect(log.problem).toBe('');
    expect(log.messages.map(({ number, timeUs, channel }) => [number, timeUs, channel])).toEqual([
      [0, 1_700_000_000_000_001, 'VIZ_EVENT'],
      [1, 1_700_000_000_000_002, 'X'],
      [2, 1_700_000_000_000_003, 'VIZ_FRAME'],
    ]);
    expect(log.messages.map(({ data }) => Buffer.from(data).toString())).toEqual(['one', '', 'three']);
  });

  // By hand from the layout in the LCM log file format.
  test('a message is header, channel and data', () => {
    expect(Buffer.from(writeLog([{ timeUs: 258, channel: 'AB', data: text('xyz') }])).toString('hex')).toBe(
      'eda1da01' + '0000000000000000' + '0000000000000102' + '00000002' + '00000003' + '4142' + '78797a',
    );
  });

  test('a file cut off anywhere keeps the whole messages before, and says where it stopped', () => {
    const whole = writeLog(messages);
    const ends = [0, 28 + 9 + 3, 28 + 9 + 3 + 29, whole.length];
    for (let size = 0; size <= whole.length; size += 1) {
      const log = readLog(whole.subarray(0, size));
      const kept = ends.filter((end) => end > 0 && end <= size).length;
      expect(log.messages.length).toBe(kept);
      expect(log.problem).toBe(
        ends.includes(size)
          ? ''
          : `the log is read up to byte ${ends[kept]} (${kept} messages): it ends within a message`,
      );
    }
  });

  test.each([
    [0, 0x12345678, 'expected the sync word eda1da01, got 12345678'],
    [20, 0, "a channel's name of 0 bytes"],
    [20, 64, "a channel's name of 64 bytes"],
    [24, -1, '-1 bytes of data'],
    [24, 0x7fffffff, '2147483647 bytes of data'],
  ])('a bad header (byte %i: %i) ends reading', (at, value, why) => {
    const bytes = writeLog(messages);
    const second = 28 + 9 + 3;
    new DataView(bytes.buffer).setInt32(second + at, value);
    const log = readLog(bytes);
    expect(log.messages.length).toBe(1);
    expect(log.problem).toBe(`the log is read up to byte 40 (1 messages): ${why}`);
  });
});
