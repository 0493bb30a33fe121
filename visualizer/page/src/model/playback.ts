// Which moment is shown, and how it moves. What the buffer holds is played here without asking the
// player; a wish to the player is answered only when it must produce, or when what is asked for is
// not held. Pure: the buffer's bounds and the seconds that passed are passed in.

import type { SourceKind } from './viewer';

export interface PlayContext {
  readonly source: SourceKind; // a socket without connection plays like a file
  readonly fromUs: number; // what the buffer holds
  readonly toUs: number;
  readonly empty: boolean; // nothing is held
  readonly durationUs: number; // end of the case, at least toUs
  readonly ends: boolean; // nothing comes after durationUs; a live flight that goes on has no end
  readonly live: boolean; // it only goes forward: the player cannot be sent back
  readonly mayAsk: boolean; // the player does what it is asked
  readonly producing: boolean; // a player runs and is not paused
  readonly stopsUs: readonly number[]; // playing stops at these, in ascending order
  // The time of the frame that many frames away from a moment, clamped to the buffer.
  frameTime(tUs: number, frames: number): number;
}

export interface Wish {
  readonly verb: 'play' | 'pause' | 'restart' | 'step' | 'seek' | 'speed';
  readonly args: readonly number[];
}

export interface Loop {
  readonly fromUs: number;
  readonly toUs: number;
}

export const MIN_SPEED = 0.05;
export const MAX_SPEED = 20;
// As near to the end of what is held as this counts as its end (two frames at 60 Hz).
export const END_US = 35_000;
// What is held from here on is held from the beginning.
const BEGINNING_US = 100_000;

export class Playback {
  tUs = 0;
  playing = false;
  following = true; // the trailing edge of what arrives is shown
  speed = 1;
  loop: Loop | null = null;
  stopAtCollision = true;
  private soughtUs = -1; // where the player was sent: what lies before is not stopped at

  // A new source, or a new run of the same.
  reset(playing: boolean): void {
    this.tUs = 0;
    this.playing = playing;
    this.following = true;
    this.loop = null;
  }

  play(context: PlayContext): Wish[] {
    if (this.playing) return [];
    this.playing = true;
    if (context.source !== 'socket') {
      this.following = false;
      if (this.tUs >= context.toUs) this.tUs = this.loop?.fromUs ?? context.fromUs;
      return [];
    }
    if (context.empty || this.tUs >= context.toUs - END_US) return this.resume(context);
    this.following = false;
    return [];
  }

  pause(context: PlayContext): Wish[] {
    this.playing = false;
    this.following = false;
    return context.source === 'socket' && context.producing ? [wish('pause')] : [];
  }

  restart(context: PlayContext): Wish[] {
    this.soughtUs = -1;
    if (context.source === 'socket') {
      this.following = true;
      return [wish('restart')];
    }
    this.tUs = context.fromUs;
    this.playing = !context.empty;
    return [];
  }

  step(frames: number, context: PlayContext): Wish[] {
    const wishes = this.pause(context);
    const next = context.frameTime(this.tUs, frames);
    const wanting = frames > 0 && next === this.tUs && context.source === 'socket';
    this.tUs = next;
    if (!wanting) return wishes;
    this.following = true;
    return [...wishes, wish('step', frames)];
  }

  seek(wantedUs: number, context: PlayContext): Wish[] {
    const tUs = Math.round(wantedUs);
    const held = !context.empty && tUs >= context.fromUs && tUs <= context.toUs;
    this.soughtUs = -1;
    if (context.source !== 'socket' || held || context.live) {
      this.tUs = clamp(tUs, context.fromUs, context.toUs);
      this.following = context.source === 'socket' && context.producing && tUs >= context.toUs;
      return [];
    }
    const target = clamp(tUs, 0, Math.max(context.durationUs, 0));
    this.following = true;
    this.soughtUs = target;
    return [wish('seek', target / 1e6)];
  }

  setSpeed(factor: number, context: PlayContext): Wish[] {
    this.speed = clamp(factor, MIN_SPEED, MAX_SPEED);
    return context.source === 'socket' ? [wish('speed', this.speed)] : [];
  }

  // Back to the trailing edge.
  toLive(context: PlayContext): Wish[] {
    this.following = true;
    this.playing = true;
    this.tUs = context.toUs;
    return context.producing ? [] : [wish('play')];
  }

  // The player said whether it runs; when its trailing edge is followed, so do we.
  heardFromPlayer(producing: boolean): void {
    if (this.following) this.playing = producing;
  }

  // That many seconds of wall time passed.
  advance(seconds: number, context: PlayContext): Wish[] {
    if (context.empty) return [];
    const from = this.tUs;
    const stop = this.nextStop(from, context);
    const follows = this.following && context.source === 'socket';
    const played = this.playing ? from + seconds * this.speed * 1e6 : from;
    const wanted = follows ? context.toUs : played;
    if (stop !== null && wanted >= stop) return this.stopAt(stop, context);
    if (this.loop !== null && this.playing && wanted >= this.loop.toUs) {
      this.following = false;
      this.tUs = clamp(this.loop.fromUs, context.fromUs, context.toUs);
      return [];
    }
    this.tUs = clamp(wanted, context.fromUs, context.toUs);
    return this.playing && !follows && wanted >= context.toUs ? this.reachedEnd(context) : [];
  }

  private resume(context: PlayContext): Wish[] {
    if (context.empty || !isOver(context)) return this.follow(context);
    if (this.loop === null && mustComeAgain(context)) {
      return context.mayAsk ? [...this.restart(context), wish('play')] : this.restart(context);
    }
    this.following = false;
    this.tUs = this.loop?.fromUs ?? context.fromUs;
    return [];
  }

  private follow(context: PlayContext): Wish[] {
    this.following = true;
    return context.producing ? [] : [wish('play')];
  }

  private reachedEnd(context: PlayContext): Wish[] {
    if (context.source === 'socket' && !isOver(context)) return this.follow(context);
    this.playing = false;
    return [];
  }

  private nextStop(fromUs: number, context: PlayContext): number | null {
    if (!this.playing || !this.stopAtCollision || fromUs < context.fromUs) return null;
    const passed = Math.max(fromUs, this.soughtUs);
    return context.stopsUs.find((tUs) => tUs > passed && tUs <= context.toUs) ?? null;
  }

  private stopAt(tUs: number, context: PlayContext): Wish[] {
    const wishes = this.pause(context);
    this.tUs = tUs;
    return wishes;
  }
}

// Nothing more comes of this run.
function isOver({ producing, ends, toUs, durationUs }: PlayContext): boolean {
  return !producing && ends && toUs >= durationUs - END_US;
}

// The beginning is not held, as in a page that came late: the player has to show it. Where it may
// not be asked what is held plays, if that is more than a moment.
function mustComeAgain({ live, mayAsk, fromUs, toUs }: PlayContext): boolean {
  return !live && fromUs > BEGINNING_US && (mayAsk || toUs - fromUs <= END_US);
}

function wish(verb: Wish['verb'], ...args: number[]): Wish {
  return { verb, args };
}

function clamp(value: number, low: number, high: number): number {
  return Math.min(Math.max(value, low), Math.max(low, high));
}
