// All that is known of one run and its case: frames, contours, distances, events, faults. Messages
// go in, the changed topics come out.

import type { CaseInfo, Faults, Frame, Message, Ranges, Risk, Status, World } from '../../../codec/messages';
import { EventLog, failingCommand } from './event_log';
import { type PackedFrame, packFrame, unpackFrame } from './packed_frame';
import { type PackedRisk, packRisk, unpackRisk } from './packed_risk';
import { RunFilter } from './run_filter';
import { TimeBuffer, type Timed } from './time_buffer';
import type { Topic } from './viewer';

const FRAMES_LIMIT_BYTES = 256 * 2 ** 20;
const RISKS_LIMIT_BYTES = 64 * 2 ** 20; // of one observer
const RANGES_LIMIT_BYTES = 16 * 2 ** 20; // of one object
// Contours and distances of longer ago than this are not those of the moment.
const RISK_AGE_US = 250_000;
const RANGES_AGE_US = 500_000;

type TimedRanges = Timed & { readonly value: Ranges };

export class RunData {
  readonly frames = new TimeBuffer<PackedFrame>(FRAMES_LIMIT_BYTES);
  readonly log = new EventLog();
  caseInfo: CaseInfo | null = null;
  world: World | null = null;
  faults: Faults | null = null;
  status: Status | null = null;
  runs = 0; // how many runs began, this one included
  private failingKnown: number | null = null; // null: events or case have changed since
  private readonly filter = new RunFilter();
  private readonly risks = new Map<number, TimeBuffer<PackedRisk>>();
  private readonly ranges = new Map<number, TimeBuffer<TimedRanges>>();

  get run(): number {
    return this.filter.current;
  }

  // Index of the command that failed, -1 without.
  get failing(): number {
    this.failingKnown ??= failingCommand(this.caseInfo, this.log.events, this.log.collisions);
    return this.failingKnown;
  }

  // The observers whose contours came, in the order they came first.
  get observers(): readonly number[] {
    return [...this.risks.keys()];
  }

  // Takes a message and adds to `changed` what it changed.
  take(message: Message, changed: Set<Topic>): void {
    if (!this.isOfThisRun(message, changed)) return;
    switch (message.channel) {
      case 'VIZ_FRAME':
        this.frames.add(packFrame(message.value, this.frames.last?.layout ?? null));
        changed.add('buffer');
        return;
      case 'VIZ_RISK':
        this.addRisk(message.value);
        changed.add('time'); // another observer's contours may come while paused
        return;
      case 'VIZ_RANGE':
        this.addRanges(message.value);
        changed.add('time');
        return;
      case 'VIZ_EVENT':
        if (!this.log.add(message.value)) return;
        changed.add('events');
        this.failingKnown = null;
        return;
      case 'VIZ_STATUS':
        this.status = message.value;
        changed.add('status');
        return;
      default:
        this.takeRepeated(message, changed);
    }
  }

  // The contours that an observer reckoned with at a time, null when none are held.
  riskAt(observer: number, tUs: number): PackedRisk | null {
    const buffer = this.risks.get(observer);
    const risk = buffer?.at(buffer.indexAt(tUs)) ?? null;
    return risk !== null && tUs - risk.tUs <= RISK_AGE_US ? risk : null;
  }

  rangesAt(object: number, tUs: number): Ranges | null {
    const buffer = this.ranges.get(object);
    const ranges = buffer?.at(buffer.indexAt(tUs)) ?? null;
    return ranges !== null && tUs - ranges.tUs <= RANGES_AGE_US ? ranges.value : null;
  }

  framesBetween(fromUs: number, toUs: number): Frame[] {
    return this.frames.between(fromUs, toUs).map(unpackFrame);
  }

  // As it would stand in a log: what describes the run first, then everything by time.
  held(): Message[] {
    const head: Message[] = [];
    if (this.caseInfo !== null) head.push({ channel: 'VIZ_CASE', value: this.caseInfo });
    if (this.world !== null) head.push({ channel: 'VIZ_WORLD', value: this.world });
    const timed: (Message & { value: { tUs: number } })[] = [];
    for (const frame of all(this.frames)) timed.push({ channel: 'VIZ_FRAME', value: unpackFrame(frame) });
    for (const buffer of this.risks.values()) {
      for (const risk of all(buffer)) timed.push({ channel: 'VIZ_RISK', value: unpackRisk(risk) });
    }
    for (const buffer of this.ranges.values()) {
      for (const ranges of all(buffer)) timed.push({ channel: 'VIZ_RANGE', value: ranges.value });
    }
    for (const event of this.log.events) timed.push({ channel: 'VIZ_EVENT', value: event });
    if (this.faults !== null) timed.push({ channel: 'VIZ_FAULTS', value: this.faults });
    if (this.status !== null) timed.push({ channel: 'VIZ_STATUS', value: this.status });
    return [...head, ...timed.sort((one, other) => one.value.tUs - other.value.tUs)];
  }

  private isOfThisRun(message: Message, changed: Set<Topic>): boolean {
    if (!('run' in message.value)) return true;
    const verdict = this.filter.judge(message.value.run, message.channel === 'VIZ_STATUS');
    if (verdict === 'new') this.begin(changed);
    return verdict !== 'drop';
  }

  // World and case stay until the new run's come: most often they are the same.
  private begin(changed: Set<Topic>): void {
    this.runs += 1;
    this.frames.clear();
    this.risks.clear();
    this.ranges.clear();
    this.log.clear();
    this.faults = null;
    this.failingKnown = null;
    for (const topic of ['buffer', 'events', 'faults', 'case'] as const) changed.add(topic);
  }

  private addRisk(risk: Risk): void {
    let buffer = this.risks.get(risk.observer);
    if (buffer === undefined) {
      buffer = new TimeBuffer(RISKS_LIMIT_BYTES);
      this.risks.set(risk.observer, buffer);
    }
    buffer.add(packRisk(risk));
  }

  private addRanges(value: Ranges): void {
    let buffer = this.ranges.get(value.object);
    if (buffer === undefined) {
      buffer = new TimeBuffer(RANGES_LIMIT_BYTES);
      this.ranges.set(value.object, buffer);
    }
    buffer.add({ tUs: value.tUs, bytes: 100 + 60 * value.items.length, value });
  }

  // What is repeated each second changes something only when it differs.
  private takeRepeated(message: Message, changed: Set<Topic>): void {
    if (message.channel === 'VIZ_WORLD') {
      const known = this.world;
      if (known?.run === message.value.run && known.version === message.value.version) return;
      this.world = message.value;
      changed.add('world');
    } else if (message.channel === 'VIZ_FAULTS') {
      this.faults = message.value;
      changed.add('faults');
    } else if (message.channel === 'VIZ_CASE') {
      if (sameCase(this.caseInfo, message.value)) return;
      this.caseInfo = message.value;
      this.failingKnown = null;
      changed.add('case');
    }
  }
}

function sameCase(known: CaseInfo | null, next: CaseInfo): boolean {
  return (
    known !== null &&
    known.caseId === next.caseId &&
    known.params === next.params &&
    known.commands.length === next.commands.length &&
    known.codeVersion === next.codeVersion &&
    known.commands.every((command, index) => {
      const other = next.commands[index];
      return other?.name === command.name && other.args === command.args && other.tUs === command.tUs;
    })
  );
}

function* all<T extends Timed>(buffer: TimeBuffer<T>): Generator<T> {
  for (let index = 0; index < buffer.length; index++) {
    const item = buffer.at(index);
    if (item !== null) yield item;
  }
}
