// Which run's messages count. Runs only rise while one player lives; a player that was started
// anew begins at a low number again, which its status keeps saying.

const LOW_STATUSES_TO_BELIEVE = 3;

export type Verdict = 'same' | 'new' | 'drop';

export class RunFilter {
  current = -1; // before the first message
  private lowStatuses = 0;

  // What to do with a message of this run. `status`: it is the player's status.
  judge(run: number, status: boolean): Verdict {
    if (run === this.current) {
      this.lowStatuses = 0;
      return 'same';
    }
    if (run > this.current) return this.adopt(run);
    if (!status) return 'drop';
    this.lowStatuses += 1;
    return this.lowStatuses >= LOW_STATUSES_TO_BELIEVE ? this.adopt(run) : 'drop';
  }

  // A new source: whatever comes first is the run.
  reset(): void {
    this.current = -1;
    this.lowStatuses = 0;
  }

  private adopt(run: number): Verdict {
    this.current = run;
    this.lowStatuses = 0;
    return 'new';
  }
}
