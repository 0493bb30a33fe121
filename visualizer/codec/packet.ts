// LCM packets: a whole small message, or one fragment of a large one. All numbers big endian.
//
//   small     magic 4c433032, u32 sequence, channel, NUL, payload
//   fragment  magic 4c433033, u32 sequence, u32 size of the whole payload, u32 offset in it, u16 number of the
//             fragment, u16 count of fragments; fragment 0 has channel and NUL before its data

import { maxChannel, maxData } from './log';

export interface Small {
  kind: 'small';
  sequence: number; // of the sender, one more with each message, modulo 2^32
  channel: string;
  payload: Uint8Array; // a view into the packet
}

export interface Fragment {
  kind: 'fragment';
  sequence: number; // of the message
  total: number; // bytes of the whole payload
  offset: number;
  number: number;
  count: number;
  channel: string; // of fragment 0, '' in the others
  data: Uint8Array; // a view into the packet
}

const smallMagic = 0x4c433032;
const fragmentMagic = 0x4c433033;
const smallHeader = 8;
const fragmentHeader = 20;

// liblcm sends larger payloads in fragments of this size.
const smallPayload = 65_499;
const fragmentPayload = 65_487;

const ascii = new TextDecoder('latin1');

// The channel that begins at `at` and where its NUL is, or what is wrong.
function readChannel(bytes: Uint8Array, at: number): { channel: string; end: number } | string {
  const end = bytes.subarray(at, at + maxChannel + 1).indexOf(0);
  if (end < 0) return `no channel of at most ${maxChannel} bytes with a NUL after it`;
  if (end === 0) return 'a channel without a name';
  return { channel: ascii.decode(bytes.subarray(at, at + end)), end: at + end };
}

function parseSmall(bytes: Uint8Array, view: DataView): Small | string {
  const name = readChannel(bytes, smallHeader);
  if (typeof name === 'string') return name;
  return {
    kind: 'small',
    sequence: view.getUint32(4),
    channel: name.channel,
    payload: bytes.subarray(name.end + 1),
  };
}

function parseFragment(bytes: Uint8Array, view: DataView): Fragment | string {
  if (bytes.length < fragmentHeader) return `a fragment of ${bytes.length} bytes has no header`;
  const total = view.getUint32(8);
  const offset = view.getUint32(12);
  const number = view.getUint16(16);
  const count = view.getUint16(18);
  if (total > maxData) return `a message of ${total} bytes, at most ${maxData} are taken`;
  if (number >= count) return `fragment ${number} of ${count}`;
  const name = number === 0 ? readChannel(bytes, fragmentHeader) : { channel: '', end: fragmentHeader - 1 };
  if (typeof name === 'string') return name;
  const data = bytes.subarray(name.end + 1);
  if (data.length === 0) return `fragment ${number} of ${count} is empty`;
  if (offset + data.length > total)
    return `fragment ${number} ends at byte ${offset + data.length} of a message of ${total}`;
  return {
    kind: 'fragment',
    sequence: view.getUint32(4),
    total,
    offset,
    number,
    count,
    channel: name.channel,
    data,
  };
}

// One datagram. A string is one line that says what is wrong with it.
export function parsePacket(bytes: Uint8Array): Small | Fragment | string {
  if (bytes.length < smallHeader) return `${bytes.length} bytes are no LCM packet`;
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  const magic = view.getUint32(0);
  if (magic === smallMagic) return parseSmall(bytes, view);
  if (magic === fragmentMagic) return parseFragment(bytes, view);
  return `${magic.toString(16).padStart(8, '0')} begins no LCM packet`;
}

function head(
  size: number,
  magic: number,
  sequence: number,
): { bytes: Uint8Array<ArrayBuffer>; view: DataView } {
  const bytes = new Uint8Array(size);
  const view = new DataView(bytes.buffer);
  view.setUint32(0, magic);
  view.setUint32(4, sequence);
  return { bytes, view };
}

// The datagrams of one message: one, or fragments when the payload is large. The channel has 1 to 63 bytes.
export function packets(
  channel: string,
  payload: Uint8Array,
  sequence: number,
  perFragment = fragmentPayload,
): Uint8Array<ArrayBuffer>[] {
  const name = new TextEncoder().encode(channel);
  if (name.length < 1 || name.length > maxChannel || name.includes(0))
    throw new Error(`a channel has 1 to ${maxChannel} bytes, not "${channel}"`);
  if (perFragment === fragmentPayload && name.length + 1 + payload.length <= smallPayload) {
    const { bytes } = head(smallHeader + name.length + 1 + payload.length, smallMagic, sequence);
    bytes.set(name, smallHeader);
    bytes.set(payload, smallHeader + name.length + 1);
    return [bytes];
  }
  return fragments(name, payload, sequence, perFragment);
}

function fragments(
  name: Uint8Array,
  payload: Uint8Array,
  sequence: number,
  perFragment: number,
): Uint8Array<ArrayBuffer>[] {
  const first = perFragment - name.length - 1;
  if (first < 1) throw new Error(`fragments of ${perFragment} bytes have no room for the channel`);
  const count = 1 + Math.max(0, Math.ceil((payload.length - first) / perFragment));
  if (count > 0xffff) throw new Error(`${count} fragments, at most 65535 can be numbered`);
  return Array.from({ length: count }, (_, number) => {
    const offset = number === 0 ? 0 : first + (number - 1) * perFragment;
    const data = payload.subarray(offset, number === 0 ? first : offset + perFragment);
    const extra = number === 0 ? name.length + 1 : 0;
    const { bytes, view } = head(fragmentHeader + extra + data.length, fragmentMagic, sequence);
    view.setUint32(8, payload.length);
    view.setUint32(12, offset);
    view.setUint16(16, number);
    view.setUint16(18, count);
    if (number === 0) bytes.set(name, fragmentHeader);
    bytes.set(data, fragmentHeader + extra);
    return bytes;
  });
}
