// Fuzz targets for everything that reads bytes of others: packets, fragments, logs, messages, the WebSocket.
//
// A target gets bytes and throws when something that must always hold does not. Inputs are made from valid ones by
// seeded mutation, so a finding is repeated by its seed.

import { readLog, writeLog } from '../codec/log';
import { packets, parsePacket } from '../codec/packet';
import { checkVerb } from '../codec/verbs';
import { parseHello, parseRequest, parseServerText, unwrap, wrap } from '../codec/protocol';
import { Random } from '../codec/random';
import { Reassembly } from '../codec/reassembly';
import { sampleMessages } from '../codec/samples';
import { decodeMessage, encodeMessage } from '../codec/viz';

export interface FuzzTarget {
  corpus: Uint8Array[];
  run: (input: Uint8Array) => void;
}

function hold(truth: boolean, what: string): void {
  if (!truth) throw new Error(what);
}

// Channels are bytes, each read as one character; only ASCII is written the same way.
const isAscii = (channel: string): boolean => /^[\x20-\x7e]*$/.test(channel);

const utf8 = new TextEncoder();
const oneLine = (text: string): boolean => text !== '' && !text.includes('\n');
const payloads = sampleMessages.map((message) => ({
  channel: message.channel,
  data: encodeMessage(message),
}));

function packet(input: Uint8Array): void {
  const parsed = parsePacket(input);
  if (typeof parsed === 'string') return hold(oneLine(parsed), 'an error is one line');
  const bytes = parsed.kind === 'small' ? parsed.payload : parsed.data;
  hold(bytes.length < input.length, 'a packet holds no more than its own bytes');
  if (parsed.kind === 'fragment') hold(parsed.offset + bytes.length <= parsed.total, 'a fragment is inside');
  else {
    const again = packets(parsed.channel, parsed.payload, parsed.sequence)[0];
    // Channels are bytes, here read as Latin-1; only ASCII is written the same way.
    if (/^[\x20-\x7e]+$/.test(parsed.channel))
      hold(same(again, input), 'a small packet is written as it was read');
  }
}

const same = (a: Uint8Array | undefined, b: Uint8Array): boolean =>
  a?.length === b.length && a.every((v, i) => v === b[i]);

// The input is cut into datagrams: u16 size, bytes.
function fragments(input: Uint8Array): void {
  const reassembly = new Reassembly({ unfinished: 4, bytes: 4096 });
  for (let at = 0; at + 2 <= input.length; ) {
    const size = ((input[at] ?? 0) << 8) | (input[at + 1] ?? 0);
    const result = reassembly.accept('a:1', input.subarray(at + 2, at + 2 + size));
    if (typeof result === 'string') hold(oneLine(result), 'an error is one line');
    else if (result) hold(result.payload.length <= input.length, 'a message is made of what has arrived');
    at += 2 + size;
  }
  hold(reassembly.lost >= 0, 'nothing is lost less than never');
}

function log(input: Uint8Array): void {
  const { messages, problem } = readLog(input);
  hold(problem === '' || oneLine(problem), 'a problem is one line');
  const size = messages.reduce((sum, { channel, data }) => sum + 28 + channel.length + data.length, 0);
  hold(
    problem === '' ? size === input.length : size <= input.length,
    'messages lie side by side in the file',
  );
  if (messages.every(({ channel }) => isAscii(channel)))
    hold(writeLog(messages).length === size, 'what was read can be written');
  for (const { channel, data } of messages) decodeMessage(channel, data);
}

// First byte: which channel.
function message(input: Uint8Array): void {
  const { channel } = payloads[(input[0] ?? 0) % payloads.length] ?? { channel: '' };
  const decoded = decodeMessage(channel, input.subarray(1));
  if (!decoded.ok) return hold(oneLine(decoded.error), 'an error is one line');
  const again = decodeMessage(channel, encodeMessage(decoded.message));
  hold(JSON.stringify(again) === JSON.stringify(decoded), 'what was decoded comes back as it went');
}

function protocol(input: Uint8Array): void {
  const whole = unwrap(input);
  if (typeof whole === 'string') hold(oneLine(whole), 'an error is one line');
  else if (isAscii(whole.channel))
    hold(same(wrap(whole.channel, whole.payload), input), 'what was unwrapped is wrapped alike');
  const text = new TextDecoder().decode(input);
  parseServerText(text);
  const hello = parseHello(text);
  if (typeof hello === 'string') hold(oneLine(hello), 'an error is one line');
  const request = parseRequest(text);
  if (typeof request === 'string') return hold(oneLine(request), 'an error is one line');
  const problem = checkVerb(request);
  hold(!problem.includes('\n') || request.verb.includes('\n'), 'a problem is one line');
  hold(problem !== '' || request.args.every(Number.isFinite), 'what is passed on has finite numbers');
}

const framed = (parts: Uint8Array[]): Uint8Array =>
  Uint8Array.from(parts.flatMap((part) => [part.length >> 8, part.length & 0xff, ...part]));

const request = { seq: 1, verb: 'steer', object: 3, args: [0.1, -0.1, 0.5], text: '', token: 'abc' };
const hello = {
  v: 1,
  start: 's',
  control: true,
  token: 't',
  client: 'c',
  group: 'g',
  channels: { A: 'viz.a' },
};
const stats = { stats: { udp: 1, lost: 2, dropped: 3, bytesPerSec: 4 } };

export const fuzzTargets: Readonly<Record<string, FuzzTarget>> = {
  packet: {
    run: packet,
    corpus: payloads.flatMap(({ channel, data }) => [
      ...packets(channel, data, 7),
      ...packets(channel, data, 7, 32),
    ]),
  },
  fragments: {
    run: fragments,
    corpus: payloads.map(({ channel, data }) => framed(packets(channel, data, 7, 32))),
  },
  log: { run: log, corpus: [writeLog(payloads.map((payload, i) => ({ ...payload, timeUs: i })))] },
  message: { run: message, corpus: payloads.map(({ data }, i) => Uint8Array.from([i, ...data])) },
  protocol: {
    run: protocol,
    corpus: [
      ...[request, { ...request, verb: 'inject', args: [], text: '{"probe":"p"}' }, hello, stats].map(
        (value) => utf8.encode(JSON.stringify(value)),
      ),
      ...payloads.map(({ channel, data }) => wrap(channel, data)),
    ],
  },
};

const extremes = [0, 1, 0x7f, 0x80, 0xff, 0x7fffffff, 0x80000000, 0xffffffff];

// Changes one thing: a bit, a byte, a 32-bit number, the length, or a stretch copied from another input.
function mutateOnce(
  input: Uint8Array<ArrayBuffer>,
  corpus: readonly Uint8Array[],
  random: Random,
): Uint8Array<ArrayBuffer> {
  const at = random.below(input.length + 1);
  const out = input.slice();
  switch (random.below(6)) {
    case 0:
      if (at < out.length) out[at] = (out[at] ?? 0) ^ (1 << random.below(8));
      return out;
    case 1:
      if (at < out.length) out[at] = random.below(256);
      return out;
    case 2:
      if (at + 4 <= out.length) new DataView(out.buffer).setUint32(at, random.pick(extremes));
      return out;
    case 3:
      return out.slice(0, at);
    case 4:
      return Uint8Array.from([
        ...out.subarray(0, at),
        ...random.bytes(1 + random.below(8)),
        ...out.subarray(at),
      ]);
    default: {
      const other = random.pick(corpus);
      const from = random.below(other.length + 1);
      return Uint8Array.from([...out.subarray(0, at), ...other.subarray(from, from + random.below(64))]);
    }
  }
}

// The input of this seed.
export function fuzzInput({ corpus }: FuzzTarget, seed: number): Uint8Array<ArrayBuffer> {
  const random = new Random(seed);
  let input = Uint8Array.from(random.pick(corpus));
  for (let left = random.below(6); left >= 0; left -= 1) input = mutateOnce(input, corpus, random);
  return input;
}
