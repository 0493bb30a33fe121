// Where timeline and curves draw: both leave the same room left and right, so that a moment is at
// the same place in both. CSS pixels.

import type { Span } from '../model/time_axis';

export const LEFT = 72; // names of rows, the left axis
export const RIGHT = 52; // the right axis

export interface PlotArea {
  readonly width: number; // of the whole, with both margins
  readonly span: Span;
}

export function timeToX(area: PlotArea, tUs: number): number {
  return LEFT + ((tUs - area.span.fromUs) / (area.span.toUs - area.span.fromUs)) * plotWidth(area.width);
}

export function xToTime(area: PlotArea, x: number): number {
  const part = Math.min(Math.max((x - LEFT) / plotWidth(area.width), 0), 1);
  return area.span.fromUs + part * (area.span.toUs - area.span.fromUs);
}

export function plotWidth(width: number): number {
  return Math.max(width - LEFT - RIGHT, 1);
}

// Seconds as an axis writes them: as many digits as its steps need, at most to the microsecond.
export function secondsText(tUs: number, stepUs: number): string {
  let digits = 0;
  for (let step = stepUs / 1e6; digits < 6 && Math.abs(step - Math.round(step)) > 1e-6; step *= 10)
    digits += 1;
  return `${(tUs / 1e6).toFixed(digits)} s`;
}

// Least time between two marks of the axis: 80 pixels.
export function spacingUs(area: PlotArea): number {
  return ((area.span.toUs - area.span.fromUs) / plotWidth(area.width)) * 80;
}
