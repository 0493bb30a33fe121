// What a page that comes late needs at once: the newest world, case, faults and status, and the events of the run.

import type { Channel } from '../codec/messages';
import { decodeMessage } from '../codec/viz';
import { wrap } from '../codec/protocol';

const kept: readonly Channel[] = ['VIZ_WORLD', 'VIZ_CASE', 'VIZ_FAULTS', 'VIZ_STATUS'];

// A run with more than this tells late pages of its latest events only.
const maxEvents = 20_000;
const maxEventBytes = 16 * 1024 * 1024;

export class Newest {
  private readonly latest = new Map<string, Uint8Array>();
  private events = new Map<number, Uint8Array>(); // by number: players tell each of them more than once
  private eventBytes = 0;
  private run: number | null = null; // of the events

  // Keeps what is to be kept of a message; one line when it cannot be read.
  note(channel: string, payload: Uint8Array): string {
    if (channel === 'VIZ_EVENT') return this.noteEvent(payload);
    if (!kept.includes(channel as Channel)) return '';
    const decoded = decodeMessage(channel, payload);
    if (!decoded.ok) return decoded.error;
    this.latest.set(channel, wrap(channel, payload));
    if (decoded.message.channel === 'VIZ_STATUS') this.noteRun(decoded.message.value.run);
    return '';
  }

  // In the order in which a page wants them.
  all(): Uint8Array[] {
    return [...kept.flatMap((channel) => this.latest.get(channel) ?? []), ...this.events.values()];
  }

  private noteEvent(payload: Uint8Array): string {
    const decoded = decodeMessage('VIZ_EVENT', payload);
    if (!decoded.ok) return decoded.error;
    if (decoded.message.channel !== 'VIZ_EVENT') return '';
    const { run, seq } = decoded.message.value;
    this.noteRun(run);
    if (this.events.has(seq)) return '';
    const event = wrap('VIZ_EVENT', payload);
    this.events.set(seq, event);
    this.eventBytes += event.length;
    for (const [oldest, { length }] of this.events) {
      if (this.events.size <= maxEvents && this.eventBytes <= maxEventBytes) break;
      this.events.delete(oldest);
      this.eventBytes -= length;
    }
    return '';
  }

  private noteRun(run: number): void {
    if (run === this.run) return;
    this.run = run;
    this.events.clear();
    this.eventBytes = 0;
  }
}
