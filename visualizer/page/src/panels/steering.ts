// Held steering keys as a steer command. Body frame: W tilts so that the object goes where its
// marked rotor points, A to its left, Q turns counter-clockwise (docs/coptersim.md: roll drives
// the body's x axis, pitch the negative y axis).

import type { SteerKey } from '../shell/keys';

export interface Steer {
  roll: number; // rad
  pitch: number; // rad
  yawRate: number; // rad/s
}

export const tilt = (10 * Math.PI) / 180;
export const turn = (45 * Math.PI) / 180;
export const repeatMs = 100;

export function steerOf(held: ReadonlySet<SteerKey>): Steer {
  const both = (plus: SteerKey, minus: SteerKey): number => Number(held.has(plus)) - Number(held.has(minus));
  return { roll: both('w', 's') * tilt, pitch: both('d', 'a') * tilt, yawRate: both('q', 'e') * turn };
}

// Sends at once when the keys change, then every 0.1 s while any is held; once zero on release.
export class SteerPad {
  private readonly held = new Set<SteerKey>();
  private timer: ReturnType<typeof setInterval> | null = null;

  constructor(
    private readonly send: (steer: Steer) => void,
    private readonly changed: () => void,
  ) {}

  get keys(): ReadonlySet<SteerKey> {
    return this.held;
  }

  press(key: SteerKey): void {
    if (this.held.has(key)) return;
    this.held.add(key);
    this.send(steerOf(this.held));
    this.timer ??= setInterval(() => this.send(steerOf(this.held)), repeatMs);
    this.changed();
  }

  release(key: SteerKey): void {
    if (!this.held.delete(key)) return;
    if (this.held.size === 0) this.stop();
    this.send(steerOf(this.held));
    this.changed();
  }

  releaseAll(): void {
    for (const key of [...this.held]) this.release(key);
  }

  private stop(): void {
    if (this.timer !== null) clearInterval(this.timer);
    this.timer = null;
  }
}
