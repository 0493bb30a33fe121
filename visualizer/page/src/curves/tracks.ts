// Curves as columns that grow with the frames, so that a new frame costs one value a curve.

import type { PackedFrame } from '../model/packed_frame';
import type { TimeBuffer } from '../model/time_buffer';
import { type Quantity, quantityAt } from './quantity';

// A column of numbers that grows.
export class Growing {
  length = 0;
  private values = new Float64Array(256);

  push(value: number): void {
    if (this.length === this.values.length) {
      const larger = new Float64Array(2 * this.length);
      larger.set(this.values);
      this.values = larger;
    }
    this.values[this.length] = value;
    this.length += 1;
  }

  at(index: number): number {
    return index < this.length ? (this.values[index] ?? NaN) : NaN;
  }
}

export interface Track {
  readonly object: number;
  readonly quantity: Quantity;
  readonly values: Growing; // one for each frame, NaN where the object is missing
}

export class Tracks {
  readonly times = new Growing(); // us, of each frame
  private readonly tracks = new Map<string, Track>();
  private seen: TimeBuffer<PackedFrame> | null = null;
  private edits = -1;

  // The track of an object's quantity, up to date with the frames.
  of(object: number, quantity: Quantity, frames: TimeBuffer<PackedFrame>): Track {
    this.catchUp(frames);
    const key = `${quantity} ${object}`;
    let track = this.tracks.get(key);
    if (track === undefined) {
      track = { object, quantity, values: new Growing() };
      this.tracks.set(key, track);
    }
    extend(track, frames);
    return track;
  }

  // Forgets the tracks of objects that nobody looks at any more.
  keep(objects: ReadonlySet<number>): void {
    for (const [key, track] of this.tracks) {
      if (!objects.has(track.object)) this.tracks.delete(key);
    }
  }

  private catchUp(frames: TimeBuffer<PackedFrame>): void {
    if (frames !== this.seen || frames.edits !== this.edits) {
      this.seen = frames;
      this.edits = frames.edits;
      this.times.length = 0;
      this.tracks.clear();
    }
    while (this.times.length < frames.length) this.times.push(frames.at(this.times.length)?.tUs ?? NaN);
  }
}

function extend(track: Track, frames: TimeBuffer<PackedFrame>): void {
  for (let index = track.values.length; index < frames.length; index++) {
    const frame = frames.at(index);
    const row = frame?.layout.rowOf.get(track.object);
    const missing = frame === null || row === undefined;
    track.values.push(missing ? NaN : quantityAt(track.quantity, frame, row));
  }
}
