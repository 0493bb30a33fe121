// Fewer points than frames for the same picture: of the frames that fall on one pixel, each curve
// keeps its least and its greatest value, in the order in which they came.

import type { Growing } from './tracks';

export type Points = (number | null)[];

// Index of the first time at or after one, in ascending times.
export function firstAt(times: Growing, tUs: number): number {
  let low = 0;
  let high = times.length;
  while (low < high) {
    const middle = (low + high) >>> 1;
    if (times.at(middle) < tUs) low = middle + 1;
    else high = middle;
  }
  return low;
}

// Times (s) and curves between two times, two points a bucket when there are more than that. The
// frame before and the one after are included, so that lines reach the edges.
export function decimate(
  times: Growing,
  curves: readonly Growing[],
  fromUs: number,
  toUs: number,
  buckets: number,
): { seconds: number[]; points: Points[] } {
  const begin = Math.max(firstAt(times, fromUs) - 1, 0);
  const end = Math.min(firstAt(times, toUs) + 1, times.length);
  if (end - begin <= 2 * buckets) return every(times, curves, begin, end);
  const width = (toUs - fromUs) / buckets;
  const seconds: number[] = [];
  const points: Points[] = curves.map(() => []);
  for (let at = begin; at < end; ) {
    const until = bucketEnd(times, at, end, fromUs, width);
    const last = until - 1;
    seconds.push(times.at(at) / 1e6, (last > at ? times.at(last) : times.at(at) + width / 4) / 1e6);
    curves.forEach((curve, index) => {
      points[index]?.push(...extremes(curve, at, until));
    });
    at = until;
  }
  return { seconds, points };
}

function every(
  times: Growing,
  curves: readonly Growing[],
  begin: number,
  end: number,
): { seconds: number[]; points: Points[] } {
  const seconds: number[] = [];
  for (let at = begin; at < end; at++) seconds.push(times.at(at) / 1e6);
  const points = curves.map((curve) => {
    const values: Points = [];
    for (let at = begin; at < end; at++) values.push(finite(curve.at(at)));
    return values;
  });
  return { seconds, points };
}

function bucketEnd(times: Growing, at: number, end: number, fromUs: number, width: number): number {
  const bucket = Math.floor((times.at(at) - fromUs) / width);
  let until = at + 1;
  while (until < end && Math.floor((times.at(until) - fromUs) / width) === bucket) until += 1;
  return until;
}

function extremes(curve: Growing, begin: number, end: number): [number | null, number | null] {
  let low = -1;
  let high = -1;
  for (let at = begin; at < end; at++) {
    const value = curve.at(at);
    if (!Number.isFinite(value)) continue;
    if (low < 0 || value < curve.at(low)) low = at;
    if (high < 0 || value > curve.at(high)) high = at;
  }
  if (low < 0) return [null, null];
  return [curve.at(Math.min(low, high)), curve.at(Math.max(low, high))];
}

function finite(value: number): number | null {
  return Number.isFinite(value) ? value : null;
}
