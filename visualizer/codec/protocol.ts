// What bridge and page say to one another over the WebSocket (path /ws, subprotocol "viz.v1").
//
// Bridge to page, binary: u8 length of the channel, channel, payload of the LCM message (fingerprint first).
// Bridge to page, text: one JSON object; the first message is `Hello`, later ones `ServerText`.
// Page to bridge, text: `ControlRequest`.

import { parseTileSet, type TileSet } from './tile_set';
import { channelTypes } from './viz';

export const subprotocol = 'viz.v1';
export const maxRequestBytes = 4096;

export interface Hello {
  v: 1;
  start: string; // tells starts of the bridge apart
  control: boolean;
  token: string | null; // goes back with each request; null when control is off
  client: string; // the name that answers (VIZ_ACK) to this page carry
  group: string; // where the bridge listens: "239.255.76.67:7667"
  tiles: TileSet | null; // of the map: GET /tiles/Z/X/Y; null: there are none
  channels: Record<string, string>; // channel: type
}

export interface Stats {
  udp: number; // messages since the bridge began
  lost: number; // of them missing, by the senders' numbers
  dropped: number; // not sent to this page because it was slow
  bytesPerSec: number; // of LCM payload
}

// A request that the bridge did not pass on.
export interface Refused {
  seq: number; // of the request, -1 when it had none
  text: string;
}

export type ServerText = { stats: Stats } | { refused: Refused };

export interface ControlRequest {
  seq: number;
  verb: string;
  object: number;
  args: number[];
  text: string;
  token: string;
}

export const helloChannels: Readonly<Record<string, string>> = channelTypes;

const ascii = new TextDecoder('latin1');

// A binary message to a page.
export function wrap(channel: string, payload: Uint8Array): Uint8Array<ArrayBuffer> {
  const bytes = new Uint8Array(1 + channel.length + payload.length);
  bytes[0] = channel.length;
  for (let i = 0; i < channel.length; i += 1) bytes[1 + i] = channel.charCodeAt(i);
  bytes.set(payload, 1 + channel.length);
  return bytes;
}

// The other way; a string is one line saying what is wrong.
export function unwrap(bytes: Uint8Array): { channel: string; payload: Uint8Array } | string {
  const size = bytes[0];
  if (size === undefined || size === 0 || size >= bytes.length)
    return `a message of ${bytes.length} bytes with a channel of ${size ?? 0}`;
  return { channel: ascii.decode(bytes.subarray(1, 1 + size)), payload: bytes.subarray(1 + size) };
}

const isRecord = (value: unknown): value is Record<string, unknown> =>
  typeof value === 'object' && value !== null && !Array.isArray(value);

function parseJson(text: string): Record<string, unknown> | null {
  try {
    const value: unknown = JSON.parse(text);
    return isRecord(value) ? value : null;
  } catch {
    return null;
  }
}

// The first text of a bridge, or one line saying what is wrong.
export function parseHello(text: string): Hello | string {
  const hello = parseJson(text);
  if (hello?.v !== 1) return 'the bridge speaks another version of viz.v1: rebuild';
  const { start, control, token, client, group, channels } = hello;
  if (typeof start !== 'string' || typeof client !== 'string' || typeof group !== 'string')
    return 'the first message of the bridge is no hello';
  const tiles = hello.tiles === null || hello.tiles === undefined ? null : parseTileSet(hello.tiles);
  if (typeof tiles === 'string') return `the map tiles of the bridge: ${tiles}`;
  return {
    v: 1,
    start,
    control: control === true,
    token: typeof token === 'string' ? token : null,
    client,
    group,
    tiles,
    channels: isRecord(channels)
      ? Object.fromEntries(Object.entries(channels).map(([name, type]) => [name, String(type)]))
      : {},
  };
}

// Any later text of a bridge; null when it is none that is known.
export function parseServerText(text: string): ServerText | null {
  const value = parseJson(text);
  if (isRecord(value?.stats)) {
    const { udp, lost, dropped, bytesPerSec } = value.stats;
    return {
      stats: {
        udp: Number(udp),
        lost: Number(lost),
        dropped: Number(dropped),
        bytesPerSec: Number(bytesPerSec),
      },
    };
  }
  if (isRecord(value?.refused))
    return { refused: { seq: Number(value.refused.seq), text: String(value.refused.text) } };
  return null;
}

// Shape and types of a request; its verb and numbers are checked by verbs.ts. A string says what is wrong.
export function parseRequest(text: string): ControlRequest | string {
  if (text.length > maxRequestBytes) return `a request of more than ${maxRequestBytes} bytes`;
  const value = parseJson(text);
  if (!value) return 'a request is one JSON object';
  const { seq, verb, object, args, text: words, token } = value;
  if (!isInt32(seq) || seq < 0) return 'seq: expected a whole number from 0';
  if (typeof verb !== 'string') return 'verb: expected a string';
  if (!isInt32(object) || object < -1) return 'object: expected a whole number from -1';
  if (!Array.isArray(args) || !args.every((arg): arg is number => Number.isFinite(arg)))
    return 'args: expected an array of finite numbers';
  if (typeof words !== 'string') return 'text: expected a string';
  if (typeof token !== 'string') return 'token: expected a string';
  return { seq, verb, object, args, text: words, token };
}

const isInt32 = (value: unknown): value is number =>
  Number.isInteger(value) && (value as number) === ((value as number) | 0);
