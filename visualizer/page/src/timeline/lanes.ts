// Which lane each fault's bar goes to: bars that do not overlap share one.

import type { Fault } from '../../../codec/messages';

export interface Bar {
  readonly fault: Fault;
  readonly lane: number;
  readonly toUs: number; // the end of the axis when no end is known
}

// More faults than this are no picture any more; the first ones are shown.
const MOST_BARS = 500;

// Bars in order of their begin; lanes are numbered from 0.
export function laneBars(faults: readonly Fault[], endUs: number): Bar[] {
  const busyUntil: number[] = [];
  const bars: Bar[] = [];
  const inOrder = [...faults].sort((one, other) => one.fromUs - other.fromUs);
  for (const fault of inOrder.slice(0, MOST_BARS)) {
    const toUs = fault.toUs < 0 ? endUs : fault.toUs;
    let lane = busyUntil.findIndex((until) => until <= fault.fromUs);
    if (lane < 0) lane = busyUntil.length;
    busyUntil[lane] = Math.max(toUs, fault.fromUs + 1);
    bars.push({ fault, lane, toUs });
  }
  return bars;
}

export function laneCount(bars: readonly Bar[]): number {
  return bars.reduce((most, bar) => Math.max(most, bar.lane + 1), 0);
}
