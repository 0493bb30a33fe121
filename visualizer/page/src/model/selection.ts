// Which objects the viewer looks at: the observer, whose risk contours are shown, and the pinned
// ones, which have curves beside it and keep them when another is observed.

export const MAX_PINNED = 6;

export class Selection {
  observer = -1;
  followed = false;
  pinned: readonly number[] = [];

  reset(): void {
    this.observer = -1;
    this.followed = false;
    this.pinned = [];
  }

  // Answers whether it is another than before.
  observe(id: number): boolean {
    if (id === this.observer) return false;
    this.observer = id;
    if (id < 0) this.followed = false;
    return true;
  }

  // The object after or before the observer, in ascending order of id and around.
  neighbour(ids: Int32Array, direction: 1 | -1): number {
    if (ids.length === 0) return -1;
    const row = ids.indexOf(this.observer);
    if (row < 0) return ids[direction > 0 ? 0 : ids.length - 1] ?? -1;
    return ids[(row + direction + ids.length) % ids.length] ?? -1;
  }

  // Not more than six can be pinned. Answers whether anything changed.
  pin(id: number, on: boolean): boolean {
    const has = this.pinned.includes(id);
    if (has === on || id < 0) return false;
    if (on && this.pinned.length >= MAX_PINNED) return false;
    this.pinned = on ? [...this.pinned, id] : this.pinned.filter((other) => other !== id);
    return true;
  }
}
