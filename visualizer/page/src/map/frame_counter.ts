// How often something is drawn: over the last second, and in all.

const KEPT = 240;

export class FrameCounter {
  drawn = 0;
  private readonly times = new Float64Array(KEPT);

  // Something was drawn at that time (ms), which took so long.
  count(nowMs: number): void {
    this.times[this.drawn % KEPT] = nowMs;
    this.drawn += 1;
  }

  // How many were drawn in the second before that time.
  perSecond(nowMs: number): number {
    let found = 0;
    for (let index = 0; index < Math.min(this.drawn, KEPT); index++) {
      if (nowMs - (this.times[index] ?? 0) < 1000) found += 1;
    }
    return found;
  }
}
