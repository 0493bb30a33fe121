// What was received of one run, in order of simulated time, up to a limit of bytes. Beyond it the
// oldest part is thinned to ten a second; when all is thinned, the oldest goes.

export interface Timed {
  readonly tUs: number;
  readonly bytes: number; // estimated
}

// Thinned parts keep one item for each of these.
const THINNED_STEP_US = 100_000;
// How much of the buffer one thinning works on, so that it is seldom.
const PART = 0.1;

export class TimeBuffer<T extends Timed> {
  // One more with each change other than adding at the end: indexes seen before count no longer.
  edits = 0;
  private items: T[] = [];
  private total = 0;
  private thinnedCount = 0; // items at the start that were thinned already

  constructor(private readonly limitBytes: number) {}

  get length(): number {
    return this.items.length;
  }

  get bytes(): number {
    return this.total;
  }

  get thinned(): boolean {
    return this.thinnedCount > 0;
  }

  get first(): T | null {
    return this.items[0] ?? null;
  }

  get last(): T | null {
    return this.items[this.items.length - 1] ?? null;
  }

  at(index: number): T | null {
    return this.items[index] ?? null;
  }

  clear(): void {
    this.edits += 1;
    this.items = [];
    this.total = 0;
    this.thinnedCount = 0;
  }

  // Adds an item; one of the same time is replaced, a late one goes to its place.
  add(item: T): void {
    const index = this.indexAt(item.tUs);
    const same = this.items[index];
    if (same !== undefined && same.tUs === item.tUs) {
      this.total -= same.bytes;
      this.items[index] = item;
      this.edits += 1;
    } else if (index === this.items.length - 1) {
      this.items.push(item);
    } else {
      this.items.splice(index + 1, 0, item);
      this.edits += 1;
      if (index + 1 < this.thinnedCount) this.thinnedCount += 1;
    }
    this.total += item.bytes;
    if (this.total > this.limitBytes) this.shrink();
  }

  // Index of the last item at or before a time, -1 when there is none.
  indexAt(tUs: number): number {
    const items = this.items;
    let low = 0;
    let high = items.length;
    while (low < high) {
      const middle = (low + high) >>> 1;
      if ((items[middle] as T).tUs <= tUs) low = middle + 1;
      else high = middle;
    }
    return low - 1;
  }

  // The items from one time to another, both included.
  between(fromUs: number, toUs: number): readonly T[] {
    const before = this.indexAt(fromUs);
    const start = this.items[before]?.tUs === fromUs ? before : before + 1;
    return this.items.slice(start, this.indexAt(toUs) + 1);
  }

  private shrink(): void {
    this.edits += 1;
    while (this.total > this.limitBytes && this.items.length > 1) {
      if (this.thinnedCount < this.items.length - 1) this.thinNext();
      else this.drop(Math.max(1, Math.floor(this.items.length * PART)));
    }
  }

  private thinNext(): void {
    const start = this.thinnedCount;
    const size = Math.max(2, Math.floor(this.items.length * PART));
    const end = Math.min(this.items.length - 1, start + size); // the newest stays as it is
    const kept: T[] = [];
    let slot = this.slotOf(start - 1);
    for (let index = start; index < end; index++) {
      const item = this.items[index] as T;
      const next = Math.floor(item.tUs / THINNED_STEP_US);
      if (next === slot) {
        this.total -= item.bytes;
      } else {
        kept.push(item);
        slot = next;
      }
    }
    this.items = this.items.slice(0, start).concat(kept, this.items.slice(end));
    this.thinnedCount = start + kept.length;
  }

  private slotOf(index: number): number {
    const item = this.items[index];
    return item === undefined ? NaN : Math.floor(item.tUs / THINNED_STEP_US);
  }

  private drop(count: number): void {
    for (const item of this.items.slice(0, count)) this.total -= item.bytes;
    this.items = this.items.slice(count);
    this.thinnedCount = Math.max(0, this.thinnedCount - count);
  }
}
