// The curves as a picture of their own (SVG), drawn from the same points as the chart.

import { objectColor, type Palette } from '../map/palette';
import type { Surface } from '../map/surface';
import { marks } from '../model/time_axis';
import { LEFT, type PlotArea, RIGHT, secondsText, spacingUs, timeToX } from '../timeline/plot_area';
import type { Points } from './decimate';
import type { Curve, Group } from './groups';
import { axisRange } from './scale';

export interface CurvesPicture {
  readonly area: PlotArea;
  readonly top: number; // CSS pixels
  readonly height: number;
  readonly palette: Palette;
  readonly group: Group;
  readonly seconds: readonly number[];
  readonly curves: readonly { curve: Curve; name: string; points: Points }[];
  readonly endsS: readonly number[];
}

const LEGEND = 22; // a line of it
const SAMPLE_PX = 22;
const LETTER_PX = 6.2;
const BELOW = 24; // marks of time

export function drawCurves(surface: Surface, picture: CurvesPicture): void {
  const { palette, area, top, height, group } = picture;
  surface.beginPath();
  surface.rect(0, top, area.width, height);
  surface.fillStyle = palette.panel;
  surface.fill();
  drawTimes(surface, picture);
  const ofLeft = picture.curves.filter(({ curve }) => !curve.kind.right);
  const ofRight = picture.curves.filter(({ curve }) => curve.kind.right);
  drawSide(surface, picture, ofLeft, rangeOf(ofLeft, group.fromZero), false);
  if (group.rightUnit !== '') drawSide(surface, picture, ofRight, rangeOf(ofRight, true), true);
  drawEnds(surface, picture);
  drawLegend(surface, picture);
}

type Drawn = CurvesPicture['curves'];

function rangeOf(curves: Drawn, fromZero: boolean): [number, number] {
  let min: number | null = null;
  let max: number | null = null;
  for (const { points } of curves) {
    for (const value of points) {
      if (value === null) continue;
      min = min === null ? value : Math.min(min, value);
      max = max === null ? value : Math.max(max, value);
    }
  }
  return axisRange(min, max, fromZero);
}

function plotBottom({ top, height }: CurvesPicture): number {
  return top + height - BELOW;
}

function plotTop(picture: CurvesPicture): number {
  const lines = Math.max(0, ...legendOf(picture).places.map((place) => place.line)) + 1;
  return picture.top + LEGEND * lines;
}

function drawTimes(surface: Surface, picture: CurvesPicture): void {
  const { area, palette } = picture;
  const { timesUs, stepUs } = marks(area.span, spacingUs(area));
  surface.beginPath();
  for (const tUs of timesUs) {
    surface.moveTo(timeToX(area, tUs), plotTop(picture));
    surface.lineTo(timeToX(area, tUs), plotBottom(picture));
  }
  surface.strokeStyle = palette.grid;
  surface.lineWidth = 1;
  surface.stroke();
  text(surface, palette, 'center');
  for (const tUs of timesUs) {
    surface.fillText(secondsText(tUs, stepUs), timeToX(area, tUs), plotBottom(picture) + 12);
  }
}

function drawSide(
  surface: Surface,
  picture: CurvesPicture,
  curves: Drawn,
  range: [number, number],
  right: boolean,
): void {
  const { area, palette, seconds } = picture;
  const bottom = plotBottom(picture);
  const toY = (value: number): number =>
    bottom - ((value - range[0]) / (range[1] - range[0])) * (bottom - plotTop(picture));
  const steps = marks({ fromUs: range[0], toUs: range[1] }, (range[1] - range[0]) / 5);
  text(surface, palette, right ? 'left' : 'right');
  for (const value of steps.timesUs) {
    const x = right ? area.width - RIGHT + 6 : LEFT - 6;
    surface.fillText(String(Number(value.toPrecision(4))), x, toY(value));
  }
  for (const { curve, points } of curves) {
    surface.beginPath();
    let pen = false;
    points.forEach((value, index) => {
      const tUs = (seconds[index] ?? NaN) * 1e6;
      const inside = tUs >= area.span.fromUs && tUs <= area.span.toUs;
      if (value === null || !inside) {
        pen = false;
        return;
      }
      if (pen) surface.lineTo(timeToX(area, tUs), toY(value));
      else surface.moveTo(timeToX(area, tUs), toY(value));
      pen = true;
    });
    line(surface, curve);
  }
}

function line(surface: Surface, { object, kind }: Curve): void {
  surface.strokeStyle = objectColor(object);
  surface.lineWidth = kind.width;
  surface.setLineDash([...kind.dash]);
  surface.stroke();
  surface.setLineDash([]);
}

function drawEnds(surface: Surface, picture: CurvesPicture): void {
  surface.beginPath();
  for (const seconds of picture.endsS) {
    const x = timeToX(picture.area, seconds * 1e6);
    if (x < LEFT || x > picture.area.width - RIGHT) continue;
    surface.moveTo(x, plotTop(picture));
    surface.lineTo(x, plotBottom(picture));
  }
  surface.strokeStyle = picture.palette.bad;
  surface.lineWidth = 1.5;
  surface.setLineDash([4, 3]);
  surface.stroke();
  surface.setLineDash([]);
}

// Where each name goes: from left to right, on further lines when one is full.
function legendPlaces(width: number, names: readonly string[], begin: number): { x: number; line: number }[] {
  let x = begin;
  let line = 0;
  return names.map((name) => {
    const size = SAMPLE_PX + name.length * LETTER_PX + 19;
    if (x + size > width && x > LEFT) {
      x = LEFT;
      line += 1;
    }
    const place = { x, line };
    x += size;
    return place;
  });
}

function legendOf({ area, group, curves }: CurvesPicture): {
  units: string;
  places: { x: number; line: number }[];
} {
  const units = group.rightUnit === '' ? group.leftUnit : `${group.leftUnit}; right: ${group.rightUnit}`;
  const begin = LEFT + units.length * 5;
  return {
    units,
    places: legendPlaces(
      area.width,
      curves.map(({ name }) => name),
      begin,
    ),
  };
}

function drawLegend(surface: Surface, picture: CurvesPicture): void {
  const { palette, top, curves } = picture;
  const { units, places } = legendOf(picture);
  text(surface, palette, 'left');
  surface.fillText(units, 6, top + LEGEND / 2);
  curves.forEach(({ curve, name }, index) => {
    const { x, line: row } = places[index] ?? { x: LEFT, line: 0 };
    const y = top + LEGEND * (row + 0.5);
    surface.beginPath();
    surface.moveTo(x, y);
    surface.lineTo(x + SAMPLE_PX, y);
    line(surface, curve);
    surface.fillText(name, x + SAMPLE_PX + 5, y);
  });
}

function text(surface: Surface, palette: Palette, align: CanvasTextAlign): void {
  surface.font = `11px ${palette.font}`;
  surface.textAlign = align;
  surface.textBaseline = 'middle';
  surface.fillStyle = palette.soft;
}
