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
  private events: Uint8Array[] = [];
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
    return [...kept.flatMap((channel) => this.latest.get(channel) ?? []), ...this.events];
  }

  private noteEvent(payload: Uint8Array): string {
    const decoded = decodeMessage('VIZ_EVENT', payload);
    if (!decoded.ok) return decoded.error;
    if (decoded.message.channel === 'VIZ_EVENT') this.noteRun(decoded.message.value.run);
    const event = wrap('VIZ_EVENT', payload);
    this.events.push(event);
    this.eventBytes += event.length;
    while (this.events.length > maxEvents || this.eventBytes > maxEventBytes)
      this.eventBytes -= this.events.shift()?.length ?? 0;
    return '';
  }

  private noteRun(run: number): void {
    if (run === this.run) return;
    this.run = run;
    this.events = [];
    this.eventBytes = 0;
  }
}
