// LCM log files: read whole, written message by message.
//
// A message is a 28-byte header, all big endian (sync word eda1da01, i64 number, i64 time in us of the writer's
// clock, i32 length of the channel, i32 length of the data), then channel and data.

import { Writer } from './bytes';

export interface LogMessage {
  number: number;
  timeUs: number; // wall time of the recording, not simulated time
  channel: string;
  data: Uint8Array; // a view into the file's bytes
}

export interface Log {
  messages: LogMessage[];
  problem: string; // one line: where and why reading ended early; '' if it did not
}

const sync = 0xeda1da01;
const headerSize = 28;
export const maxChannel = 63; // bytes, as in liblcm
export const maxData = 16 * 1024 * 1024; // bytes

const ascii = new TextDecoder('latin1');

interface Header {
  number: number;
  timeUs: number;
  channelSize: number;
  dataSize: number;
}

const int64 = (view: DataView, at: number): number => view.getInt32(at) * 2 ** 32 + view.getUint32(at + 4);

// The header at `at`, or what is wrong with it.
function readHeader(view: DataView, at: number): Header | string {
  const word = view.getUint32(at);
  if (word !== sync) return `expected the sync word eda1da01, got ${word.toString(16).padStart(8, '0')}`;
  const channelSize = view.getInt32(at + 20);
  const dataSize = view.getInt32(at + 24);
  if (channelSize < 1 || channelSize > maxChannel) return `a channel's name of ${channelSize} bytes`;
  if (dataSize < 0 || dataSize > maxData) return `${dataSize} bytes of data`;
  return { number: int64(view, at + 4), timeUs: int64(view, at + 12), channelSize, dataSize };
}

// Everything up to the first thing that is wrong.
export function readLog(bytes: Uint8Array): Log {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  const messages: LogMessage[] = [];
  const stopped = (at: number, why: string): Log => ({
    messages,
    problem: `the log is read up to byte ${at} (${messages.length} messages): ${why}`,
  });
  let at = 0;
  while (at < bytes.byteLength) {
    if (bytes.byteLength - at < headerSize) return stopped(at, 'it ends within a message');
    const header = readHeader(view, at);
    if (typeof header === 'string') return stopped(at, header);
    const dataAt = at + headerSize + header.channelSize;
    const end = dataAt + header.dataSize;
    if (end > bytes.byteLength) return stopped(at, 'it ends within a message');
    messages.push({
      number: header.number,
      timeUs: header.timeUs,
      channel: ascii.decode(bytes.subarray(at + headerSize, dataAt)),
      data: bytes.subarray(dataAt, end),
    });
    at = end;
  }
  return { messages, problem: '' };
}

// The bytes of a log with these messages, numbered in order.
export function writeLog(messages: Iterable<Omit<LogMessage, 'number'>>): Uint8Array<ArrayBuffer> {
  const writer = new Writer();
  let number = 0;
  for (const { timeUs, channel, data } of messages) {
    const name = new TextEncoder().encode(channel);
    writer.int32(sync | 0);
    writer.int64(number);
    writer.int64(timeUs);
    writer.int32(name.length);
    writer.int32(data.length);
    writer.raw(name);
    writer.raw(data);
    number += 1;
  }
  return writer.bytes();
}
