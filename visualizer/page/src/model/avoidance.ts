// When an object was avoiding others, as spans of time; kept up as frames come.

import { ObjectFlag } from '../../../codec/messages';
import { Col, type PackedFrame, STRIDE } from './packed_frame';
import type { TimeBuffer } from './time_buffer';

export interface Avoiding {
  fromUs: number;
  toUs: number;
}

export class AvoidanceSpans {
  private list: Avoiding[] = [];
  private object = -1;
  private seen: TimeBuffer<PackedFrame> | null = null;
  private edits = -1;
  private done = 0; // frames looked at
  private open = false; // the last span goes on

  // The spans of an object in the frames that are held.
  of(object: number, frames: TimeBuffer<PackedFrame>): readonly Avoiding[] {
    if (object !== this.object || frames !== this.seen || frames.edits !== this.edits) {
      this.object = object;
      this.seen = frames;
      this.edits = frames.edits;
      this.list = [];
      this.done = 0;
      this.open = false;
    }
    for (; this.done < frames.length; this.done++) {
      const frame = frames.at(this.done);
      if (frame !== null) this.look(frame);
    }
    return this.list;
  }

  private look(frame: PackedFrame): void {
    const row = frame.layout.rowOf.get(this.object);
    const flags = row === undefined ? 0 : (frame.data[row * STRIDE + Col.flags] ?? 0);
    const avoiding = (flags & ObjectFlag.avoiding) !== 0;
    const last = this.list[this.list.length - 1];
    if (this.open && last !== undefined) last.toUs = frame.tUs;
    else if (avoiding) this.list.push({ fromUs: frame.tUs, toUs: frame.tUs });
    this.open = avoiding;
  }
}
