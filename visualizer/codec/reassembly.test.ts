import { describe, expect, test } from 'vitest';
import { packets } from './packet';
import { Random } from './random';
import { Reassembly } from './reassembly';

const fragments = (payload: Uint8Array, sequence = 1, size = 16): Uint8Array[] =>
  packets('VIZ_FRAME', payload, sequence, size);

// What came whole, and what was complained about.
function feed(reassembly: Reassembly, parts: Uint8Array[], sender = 'a:1') {
  const all = parts.map((part) => reassembly.accept(sender, part)).filter((result) => result !== null);
  return {
    complete: all.filter((result) => typeof result !== 'string'),
    problems: all.filter((result) => typeof result === 'string'),
  };
}

const edit = (packet: Uint8Array | undefined, at: number, value: number): Uint8Array => {
  const copy = Uint8Array.from(packet ?? []);
  new DataView(copy.buffer).setUint32(at, value);
  return copy;
};

describe('fragments', () => {
  test('in any order, some of them repeated, make the message exactly once', () => {
    for (let seed = 1; seed <= 200; seed += 1) {
      const random = new Random(seed);
      const payload = random.bytes(1 + random.below(300));
      const parts = fragments(payload);
      const repeated = random.shuffled([...parts, ...parts.filter(() => random.below(3) === 0)]);
      const { complete, problems } = feed(new Reassembly(), repeated);
      expect(complete).toEqual([{ channel: 'VIZ_FRAME', payload }]);
      expect(problems).toEqual([]);
    }
  });

  test('a lost fragment leaves its message out and the others whole', () => {
    for (let seed = 1; seed <= 100; seed += 1) {
      const random = new Random(seed);
      const first = fragments(random.bytes(100), 1);
      const second = random.bytes(80);
      first.splice(random.below(first.length), 1);
      const mixed = random.shuffled([...first, ...fragments(second, 2)]);
      expect(feed(new Reassembly(), mixed).complete).toEqual([{ channel: 'VIZ_FRAME', payload: second }]);
    }
  });

  test('of two senders with the same number are kept apart', () => {
    const reassembly = new Reassembly();
    const one = fragments(new Uint8Array(60).fill(1));
    const two = fragments(new Uint8Array(60).fill(2));
    const whole = one.flatMap((part, i) => [
      ...feed(reassembly, [part], 'a:1').complete,
      ...feed(reassembly, two.slice(i, i + 1), 'a:2').complete,
    ]);
    expect(whole.map(({ payload }) => payload[0])).toEqual([1, 2]);
  });

  test('that overlap or leave a gap make no message', () => {
    const [first, second, third] = fragments(new Uint8Array(20), 1, 12);
    const overlapping = edit(third, 12, 13);
    expect(feed(new Reassembly(), [first, second, overlapping] as Uint8Array[])).toEqual({
      complete: [],
      problems: ['fragment 2 begins at byte 13, not 14'],
    });
  });

  test('that disagree on size or count are forgotten', () => {
    const [first, second] = fragments(new Uint8Array(20), 1, 16);
    expect(feed(new Reassembly(), [first, edit(second, 8, 21)] as Uint8Array[]).problems).toEqual([
      'fragments disagree: 2 of 20 bytes, 2 of 21',
    ]);
  });

  test('that do not fill the message make none', () => {
    const only = edit(fragments(new Uint8Array(5), 1, 64)[0], 8, 6);
    expect(feed(new Reassembly(), [only]).problems).toEqual(['1 fragments hold 5 of 6 bytes']);
  });

  test('at most 64 messages are unfinished; the oldest goes and counts as lost', () => {
    const reassembly = new Reassembly();
    const messages = Array.from({ length: 65 }, (_, i) => fragments(new Uint8Array(20).fill(i), i + 1));
    for (const [first] of messages) if (first) reassembly.accept('a:1', first);
    expect(reassembly.lost).toBe(1);
    const rest = messages.slice(1).flatMap((parts) => feed(reassembly, parts.slice(1)).complete);
    expect(rest.map(({ payload }) => payload[0])).toEqual(Array.from({ length: 64 }, (_, i) => i + 1));
  });

  test('the bytes kept are limited, whatever the fragments claim', () => {
    const reassembly = new Reassembly({ bytes: 1000 });
    for (let i = 0; i < 20; i += 1) {
      const [first] = fragments(new Uint8Array(500), i, 300);
      if (first) reassembly.accept('a:1', first);
    }
    expect(reassembly.lost).toBe(17); // 290 bytes each: 3 of them stay
  });
});

describe('what got lost', () => {
  const small = (sequence: number): Uint8Array[] => packets('A', new Uint8Array(1), sequence);
  const lostAfter = (sequences: number[]): number => {
    const reassembly = new Reassembly();
    feed(reassembly, sequences.flatMap(small));
    return reassembly.lost;
  };

  test.each([
    ['nothing', [5, 6, 7], 0],
    ['two between 6 and 9', [5, 6, 9], 2],
    ['nothing at the end of the numbers', [0xffff_ffff, 0, 1], 0],
    ['one across the end of the numbers', [0xffff_fffe, 0], 1],
    ['nothing when a sender begins again', [70_000_000, 0, 1], 0],
    ['nothing more when an old one comes late', [1, 3, 2, 4], 1],
  ])('%s', (_, sequences, lost) => {
    expect(lostAfter(sequences)).toBe(lost);
  });

  test('is counted per sender', () => {
    const reassembly = new Reassembly();
    feed(reassembly, small(1), 'a:1');
    feed(reassembly, small(100), 'a:2');
    feed(reassembly, small(2), 'a:1');
    expect(reassembly.lost).toBe(0);
  });
});
