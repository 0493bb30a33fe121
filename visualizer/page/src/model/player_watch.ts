// Whether the player that is heard is still the same. Its runs count on by one; a player that was
// started anew begins at another number, after a silence.

// A player speaks five times a second.
const SILENCE_MS = 1000;

export class PlayerWatch {
  private heardMs = -Infinity;

  // Something of the present run came, or began to be able to come.
  heard(nowMs: number): void {
    this.heardMs = nowMs;
  }

  // Whether a run is another player's than the one before it (-1: none).
  isAnother(run: number, before: number, nowMs: number): boolean {
    if (before < 0) return false;
    return run < before || (run > before + 1 && nowMs - this.heardMs >= SILENCE_MS);
  }
}
