// The curves' chart: options for uPlot, in the page's colours and with the timeline's margins.

import uPlot from 'uplot';
import { objectColor, type Palette } from '../map/palette';
import { marks } from '../model/time_axis';
import { LEFT, type PlotArea, RIGHT, secondsText, spacingUs } from '../timeline/plot_area';
import type { Curve, Group } from './groups';
import { axisRange } from './scale';

export interface PlotWorld {
  readonly palette: () => Palette;
  readonly area: () => PlotArea;
  readonly ends: () => readonly number[]; // seconds at which a line marks a failure
  readonly selected: (fromS: number, toS: number) => void;
  readonly reset: () => void;
  readonly clicked: (seconds: number) => void;
}

export const X_AXIS = 24; // CSS pixels
const CLICK_PX = 4;

export function createPlot(
  host: HTMLElement,
  group: Group,
  curves: readonly Curve[],
  world: PlotWorld,
): uPlot {
  const empty = [[], ...curves.map(() => [])] as unknown as uPlot.AlignedData;
  const plot = new uPlot(options(host, group, curves, world), empty, host);
  listenClick(plot, world);
  return plot;
}

function options(host: HTMLElement, group: Group, curves: readonly Curve[], world: PlotWorld): uPlot.Options {
  return {
    width: Math.max(host.clientWidth, 1),
    height: Math.max(host.clientHeight, 1),
    padding: [6, group.rightUnit === '' ? RIGHT : 0, 0, 0],
    legend: { show: false },
    cursor: {
      drag: { x: true, y: false, setScale: false, dist: CLICK_PX },
      bind: {
        dblclick: () => () => {
          world.reset();
          return null;
        },
      },
    },
    scales: {
      x: { time: false, range: () => [world.area().span.fromUs / 1e6, world.area().span.toUs / 1e6] },
      y: { range: (_plot, min, max) => axisRange(min, max, group.fromZero) },
      right: { range: (_plot, min, max) => axisRange(min, max, true) },
    },
    axes: axes(group, world),
    series: [{}, ...curves.map(series)],
    hooks: { setSelect: [(plot) => select(plot, world)], draw: [(plot) => drawEnds(plot, world)] },
  };
}

function series({ object, kind }: Curve): uPlot.Series {
  return {
    scale: kind.right ? 'right' : 'y',
    stroke: objectColor(object),
    width: kind.width,
    dash: [...kind.dash],
    points: { show: false },
    spanGaps: false,
  };
}

function axes(group: Group, world: PlotWorld): uPlot.Axis[] {
  const { palette } = world;
  const look = {
    stroke: () => palette().soft,
    font: `11px ${palette().font}`,
    labelFont: `11px ${palette().font}`,
    ticks: { show: false },
    grid: { stroke: () => palette().grid, width: 1 },
  };
  const left: uPlot.Axis = {
    ...look,
    scale: 'y',
    size: LEFT - 20,
    label: group.leftUnit,
    labelSize: 20,
    space: 26,
  };
  const right: uPlot.Axis = {
    ...look,
    scale: 'right',
    side: 1,
    size: RIGHT - 20,
    label: group.rightUnit,
    labelSize: 20,
    space: 26,
    grid: { show: false },
  };
  // The same marks as the timeline's.
  const timeMarks = (): ReturnType<typeof marks> => {
    const area = world.area();
    return marks(area.span, spacingUs(area));
  };
  const time: uPlot.Axis = {
    ...look,
    scale: 'x',
    size: X_AXIS,
    splits: () => timeMarks().timesUs.map((tUs) => tUs / 1e6),
    values: (_plot, splits) => splits.map((seconds) => secondsText(seconds * 1e6, timeMarks().stepUs)),
  };
  return group.rightUnit === '' ? [time, left] : [time, left, right];
}

function select(plot: uPlot, world: PlotWorld): void {
  const { left, width } = plot.select;
  if (width < CLICK_PX) return;
  const from = plot.posToVal(left, 'x');
  const to = plot.posToVal(left + width, 'x');
  plot.setSelect({ left: 0, top: 0, width: 0, height: 0 }, false);
  world.selected(from, to);
}

function drawEnds(plot: uPlot, world: PlotWorld): void {
  const { ctx, bbox } = plot;
  ctx.save();
  ctx.strokeStyle = world.palette().bad;
  ctx.lineWidth = 1.5 * uPlot.pxRatio;
  ctx.setLineDash([4 * uPlot.pxRatio, 3 * uPlot.pxRatio]);
  ctx.beginPath();
  for (const seconds of world.ends()) {
    const x = plot.valToPos(seconds, 'x', true);
    if (x < bbox.left || x > bbox.left + bbox.width) continue;
    ctx.moveTo(x, bbox.top);
    ctx.lineTo(x, bbox.top + bbox.height);
  }
  ctx.stroke();
  ctx.restore();
}

function listenClick(plot: uPlot, world: PlotWorld): void {
  let downX = NaN;
  plot.over.addEventListener('pointerdown', (event) => {
    downX = event.clientX;
  });
  plot.over.addEventListener('pointerup', (event) => {
    if (Math.abs(event.clientX - downX) >= CLICK_PX) return;
    world.clicked(plot.posToVal(event.clientX - plot.over.getBoundingClientRect().left, 'x'));
  });
}
