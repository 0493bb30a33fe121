// Puts fragments together and counts what got lost, per sender (address and port).
//
// Nothing here trusts a packet: only bytes that have arrived are kept, of at most 64 unfinished messages and 32 MiB
// in all (the oldest goes first), and fragments must fill their message without gap or overlap.

import { type Fragment, parsePacket } from './packet';

export interface Complete {
  channel: string;
  payload: Uint8Array;
}

interface Unfinished {
  total: number;
  count: number;
  parts: Map<number, Fragment>;
  size: number; // bytes that have arrived
}

export interface Limits {
  unfinished: number;
  bytes: number;
  senders: number;
}

const defaults: Limits = { unfinished: 64, bytes: 32 * 1024 * 1024, senders: 64 };

// A jump further than this is a sender that began again, not a loss.
const largestGap = 65_536;

export class Reassembly {
  lost = 0; // messages: gaps in the senders' numbers, and messages that never became whole
  private readonly unfinished = new Map<string, Unfinished>();
  private readonly finished = new Map<string, true>(); // the youngest of them
  private readonly latest = new Map<string, number>(); // sender: number of its latest message
  private bytes = 0;
  private readonly limits: Limits;

  constructor(limits: Partial<Limits> = {}) {
    this.limits = { ...defaults, ...limits };
  }

  // One datagram: the message that it completes, null when more is to come, or one line saying what is wrong.
  accept(sender: string, bytes: Uint8Array): Complete | string | null {
    const packet = parsePacket(bytes);
    if (typeof packet === 'string') return packet;
    this.count(sender, packet.sequence);
    if (packet.kind === 'small') return { channel: packet.channel, payload: packet.payload };
    return this.add(`${sender} ${packet.sequence}`, packet);
  }

  private count(sender: string, sequence: number): void {
    const before = this.latest.get(sender);
    const step = before === undefined ? 1 : (sequence - before) >>> 0;
    if (step === 0) return; // another fragment of the same message
    if (step > 0xffff_ffff - largestGap) return; // an old one, late
    if (step <= largestGap) this.lost += step - 1;
    this.latest.delete(sender); // and in again as the youngest
    this.latest.set(sender, sequence);
    if (this.latest.size > this.limits.senders) this.latest.delete(oldest(this.latest));
  }

  private add(key: string, fragment: Fragment): Complete | string | null {
    if (this.finished.has(key)) return null;
    const message = this.unfinished.get(key) ?? this.begin(key, fragment);
    if (message.total !== fragment.total || message.count !== fragment.count) {
      this.forget(key);
      return `fragments disagree: ${message.count} of ${message.total} bytes, ${fragment.count} of ${fragment.total}`;
    }
    if (message.parts.has(fragment.number)) return null; // repeated
    message.parts.set(fragment.number, fragment);
    message.size += fragment.data.length;
    this.bytes += fragment.data.length;
    if (message.parts.size === message.count) {
      this.forget(key);
      this.remember(key);
      return assemble(message);
    }
    this.makeRoom();
    return null;
  }

  private begin(key: string, { total, count }: Fragment): Unfinished {
    const message = { total, count, parts: new Map<number, Fragment>(), size: 0 };
    this.unfinished.set(key, message);
    return message;
  }

  private forget(key: string): void {
    this.bytes -= this.unfinished.get(key)?.size ?? 0;
    this.unfinished.delete(key);
  }

  // A fragment that comes again after its message was whole begins no new one.
  private remember(key: string): void {
    this.finished.set(key, true);
    if (this.finished.size > this.limits.unfinished) this.finished.delete(oldest(this.finished));
  }

  private makeRoom(): void {
    while (this.unfinished.size > this.limits.unfinished || this.bytes > this.limits.bytes) {
      this.forget(oldest(this.unfinished));
      this.lost += 1;
    }
  }
}

const oldest = (map: ReadonlyMap<string, unknown>): string => map.keys().next().value ?? '';

// All fragments are there: they must lie side by side in the order of their numbers.
function assemble({ total, count, parts }: Unfinished): Complete | string {
  const payload = new Uint8Array(total);
  let at = 0;
  for (let number = 0; number < count; number += 1) {
    const part = parts.get(number);
    if (!part || part.offset !== at) return `fragment ${number} begins at byte ${part?.offset}, not ${at}`;
    payload.set(part.data, at);
    at += part.data.length;
  }
  if (at !== total) return `${count} fragments hold ${at} of ${total} bytes`;
  return { channel: parts.get(0)?.channel ?? '', payload };
}
