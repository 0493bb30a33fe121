// The events of one run, in order, and what follows from them: collisions, the current and the
// failing command, where the run ended.

import type { CaseInfo, VizEvent } from '../../../codec/messages';
import type { Collision } from './viewer';

export class EventLog {
  private list: VizEvent[] = [];
  private seqs = new Set<number>();
  private found: Collision[] = [];

  get events(): readonly VizEvent[] {
    return this.list;
  }

  get collisions(): readonly Collision[] {
    return this.found;
  }

  clear(): void {
    this.list = [];
    this.seqs = new Set();
    this.found = [];
  }

  // Adds an event unless its number is known already (bridges repeat them). Tells whether it was
  // new. The lists are replaced, not changed, so that a listener can compare them.
  add(event: VizEvent): boolean {
    if (this.seqs.has(event.seq)) return false;
    this.seqs.add(event.seq);
    const last = this.list[this.list.length - 1];
    if (last === undefined || inOrder(last, event)) this.list.push(event);
    else insert(this.list, event);
    if (event.kind === 'collision') {
      this.found = [...this.found, collisionOf(event)].sort((p, q) => p.tUs - q.tUs);
    }
    return true;
  }

  // The next or previous event's time from a moment on, null when there is none.
  neighbour(tUs: number, direction: 1 | -1): number | null {
    let found: number | null = null;
    for (const event of this.list) {
      if (direction > 0 && event.tUs > tUs) return event.tUs;
      if (direction < 0 && event.tUs < tUs) found = event.tUs;
    }
    return found;
  }
}

// When a run failed: at the first collision or when the verdict fell, whichever was first (the verdict
// may come only at the run's end); null when nothing failed.
export function failureUs(events: readonly VizEvent[], collisions: readonly Collision[]): number | null {
  const verdict = events.find((event) => event.kind === 'verdict' && isFailure(event.text));
  const tUs = Math.min(verdict?.tUs ?? Infinity, collisions[0]?.tUs ?? Infinity);
  return Number.isFinite(tUs) ? tUs : null;
}

// Index of the command that runs at a time, -1 before the first. Of several at one time the last.
export function commandAt(info: CaseInfo | null, tUs: number): number {
  const commands = info?.commands ?? [];
  let found = -1;
  for (let index = 0; index < commands.length; index++) {
    if ((commands[index]?.tUs ?? Infinity) <= tUs) found = index;
  }
  return found;
}

// Index of the command during which the run failed, -1 when it did not. A failure at the very
// moment at which a command begins belongs to the one before: its last step brought it about.
export function failingCommand(
  info: CaseInfo | null,
  events: readonly VizEvent[],
  collisions: readonly Collision[],
): number {
  const tUs = failureUs(events, collisions);
  if (tUs === null) return -1;
  const before = commandAt(info, tUs - 1);
  return before >= 0 ? before : commandAt(info, tUs);
}

// Whether a verdict's text tells of a failure.
export function isFailure(text: string): boolean {
  return /^(failed|differs)\b/i.test(text);
}

function collisionOf(event: VizEvent): Collision {
  const terrain = /terrain/i.test(event.text);
  return { tUs: event.tUs, a: event.a, b: event.b, terrain, x: event.x, y: event.y };
}

function inOrder(first: VizEvent, second: VizEvent): boolean {
  return first.tUs < second.tUs || (first.tUs === second.tUs && first.seq <= second.seq);
}

function insert(list: VizEvent[], event: VizEvent): void {
  let index = list.length;
  while (index > 0 && !inOrder(list[index - 1] as VizEvent, event)) index -= 1;
  list.splice(index, 0, event);
}
