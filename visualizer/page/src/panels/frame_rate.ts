// How many frames came in the last second of wall time, by the run's count of frames.

export class FrameRate {
  private samples: { ms: number; seq: number; run: number }[] = [];

  // `seq': of the newest frame that is held, null for none. Those that went before the first one are
  // not counted: they did not come here.
  of(seq: number | null, run: number, ms: number): number {
    if (seq === null || this.samples.at(-1)?.run !== run) this.samples = [];
    if (seq === null) return 0;
    this.samples.push({ ms, seq, run });
    while (this.samples.length > 2 && ms - (this.samples[1]?.ms ?? ms) > 1000) this.samples.shift();
    const first = this.samples[0];
    const last = this.samples.at(-1);
    if (first === undefined || last === undefined || ms <= first.ms) return 0;
    return Math.max(0, Math.round(((last.seq - first.seq) * 1000) / (ms - first.ms)));
  }
}
