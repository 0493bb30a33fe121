// The visualizer's messages: which type each channel carries, bytes to message and back.

import { BadBytes } from './bytes';
import { decodeFrame } from './frame';
import type { Channel, Control, Message } from './messages';
import { decodeRisk } from './risk';
import { Schema } from './schema';

const files = import.meta.glob<string>('../../lcm/*.lcm', { query: '?raw', import: 'default', eager: true });

// int8_t members that mean yes or no.
const flags = [
  'ellipse.overlap',
  'range.used',
  'fault.active',
  'status.paused',
  'status.control_allowed',
  'ack.ok',
];

export const vizSchema = new Schema(Object.entries(files), flags);

export const channelTypes: Readonly<Record<Channel, string>> = {
  VIZ_FRAME: 'viz.frame',
  VIZ_RISK: 'viz.risk',
  VIZ_WORLD: 'viz.world',
  VIZ_RANGE: 'viz.ranges',
  VIZ_FAULTS: 'viz.faults',
  VIZ_EVENT: 'viz.event',
  VIZ_CASE: 'viz.case_info',
  VIZ_STATUS: 'viz.status',
  VIZ_ACK: 'viz.ack',
};

// From a page, through the bridge, to the player; a page never gets it.
export const controlChannel = 'VIZ_CONTROL';
const controlType = 'viz.control';

export const channels = Object.keys(channelTypes) as Channel[];

export const isChannel = (name: string): name is Channel => Object.hasOwn(channelTypes, name);

export type Decoded = { ok: true; message: Message } | { ok: false; error: string };

const fingerprints = new Map<string, bigint>(
  Object.values(channelTypes).map((type) => [type, vizSchema.fingerprint(type)]),
);

// The payload of a channel, checked. The error is one line; "type mismatch: rebuild" when the sender's type has
// another layout.
export function decodeMessage(channel: string, payload: Uint8Array): Decoded {
  if (!isChannel(channel)) return { ok: false, error: `${channel}: no channel of the visualizer` };
  const type = channelTypes[channel];
  if (payload.byteLength < 8)
    return { ok: false, error: `${channel}: ${payload.byteLength} bytes hold no fingerprint` };
  if (fingerprintOf(payload) !== fingerprints.get(type))
    return { ok: false, error: `${channel}: type mismatch: rebuild (${type} has another layout here)` };
  try {
    return { ok: true, message: { channel, value: decodeValue(channel, payload) } as Message };
  } catch (error) {
    if (error instanceof BadBytes) return { ok: false, error: `${channel}: ${error.message}` };
    throw error;
  }
}

const fingerprintOf = (payload: Uint8Array): bigint =>
  new DataView(payload.buffer, payload.byteOffset, 8).getBigUint64(0);

function decodeValue(channel: Channel, payload: Uint8Array): unknown {
  if (channel === 'VIZ_FRAME') return decodeFrame(payload);
  if (channel === 'VIZ_RISK') return decodeRisk(payload);
  return vizSchema.decode(channelTypes[channel], payload);
}

// The payload, fingerprint first. Throws one line when a member is missing or out of its range.
export function encodeMessage(message: Message): Uint8Array<ArrayBuffer> {
  return vizSchema.encode(channelTypes[message.channel], message.value);
}

export function encodeControl(control: Control): Uint8Array<ArrayBuffer> {
  return vizSchema.encode(controlType, control);
}

// As the player reads it. Throws one line.
export function decodeControl(payload: Uint8Array): Control {
  if (payload.byteLength < 8 || fingerprintOf(payload) !== vizSchema.fingerprint(controlType))
    throw new BadBytes(`${controlChannel}: type mismatch: rebuild`);
  return vizSchema.decode(controlType, payload) as unknown as Control;
}
