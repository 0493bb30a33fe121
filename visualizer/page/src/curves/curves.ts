// The curves below the timeline: errors, places and distances of the observer and of pinned objects,
// on the same axis of time.

import 'uplot/dist/uPlot.min.css';
import './curves.css';
import type uPlot from 'uplot';
import { shortNameOf } from '../model/short_name';
import { objectColor } from '../map/palette';
import type { SvgSurface } from '../map/svg_surface';
import { currentPalette, onThemeChange } from '../map/theme_watch';
import { failureUs } from '../model/event_log';
import type { TimeAxis } from '../model/time_axis';
import type { Topic, Viewer } from '../model/viewer';
import { button, el, setText } from '../shell/dom';
import { type PlotArea, plotWidth, timeToX } from '../timeline/plot_area';
import { drawCurves } from './curves_picture';
import { decimate, type Points } from './decimate';
import { type Curve, curvesOf, GROUPS, type Group } from './groups';
import { createPlot, type PlotWorld } from './plot';
import { quantityAt } from './quantity';
import { Tracks } from './tracks';

export interface Curves {
  draw(surface: SvgSurface, top: number): number; // for the exported picture; answers its height
}

// While frames come, the curves are drawn this often.
const DRAW_EVERY_MS = 200;
const NUMBERS_EVERY_MS = 200;

// `save': what the button for saving timeline and curves as a picture does.
export function createCurves(host: HTMLElement, viewer: Viewer, axis: TimeAxis, save: () => void): Curves {
  return new UplotCurves(host, viewer, axis, save);
}

class UplotCurves implements Curves {
  private palette = currentPalette();
  private group: Group = GROUPS[0] as Group;
  private curves: Curve[] = [];
  private plot: uPlot | null = null;
  private readonly tracks = new Tracks();
  private readonly tabs = el('div', { class: 'curves-tabs', role: 'group', 'aria-label': 'Curves' });
  private readonly legend = el('div', { class: 'curves-legend' });
  private numbers: HTMLElement[] = [];
  private readonly chart = el('div', { class: 'curves-chart' });
  private readonly head = el('div', { class: 'curves-head', 'aria-hidden': 'true' });
  private timer: ReturnType<typeof setTimeout> | null = null;
  private numbersMs = -Infinity;
  private width = 0; // of the chart, CSS pixels; asking the element for it would cost a layout each frame

  constructor(
    host: HTMLElement,
    private readonly viewer: Viewer,
    private readonly axis: TimeAxis,
    save: () => void,
  ) {
    this.chart.append(this.head);
    const saver = button('SVG', save, { class: 'curves-tab', title: 'Save timeline and curves as SVG' });
    host.append(
      el(
        'div',
        { class: 'curves' },
        el('div', { class: 'curves-strip' }, this.tabs, this.legend, saver),
        this.chart,
      ),
    );
    for (const group of GROUPS) this.tabs.append(this.tab(group));
    new ResizeObserver(() => this.resized()).observe(this.chart);
    axis.listen(() => this.redraw());
    onThemeChange(() => {
      this.palette = currentPalette();
      this.rebuild();
    });
    viewer.listen((changed) => this.changed(changed));
    this.rebuild();
  }

  draw(surface: SvgSurface, top: number): number {
    const { seconds, points } = this.data();
    const { area } = this;
    const curves = this.curves.map((curve, index) => ({
      curve,
      name: this.name(curve),
      points: points[index] ?? [],
    }));
    const height = Math.max(this.chart.clientHeight, 160) + 40; // room for the legend
    drawCurves(surface, {
      area,
      top,
      height,
      palette: this.palette,
      group: this.group,
      seconds,
      curves,
      endsS: this.ends(),
    });
    return height;
  }

  private get area(): PlotArea {
    return { width: this.width, span: this.axis.span };
  }

  private tab(group: Group): HTMLButtonElement {
    const button = el('button', { type: 'button', class: 'curves-tab' }, group.name);
    button.setAttribute('aria-pressed', String(group === this.group));
    button.addEventListener('click', () => {
      this.group = group;
      for (const other of this.tabs.children) other.setAttribute('aria-pressed', String(other === button));
      this.rebuild();
    });
    return button;
  }

  private changed(changed: ReadonlySet<Topic>): void {
    if (changed.has('selection') || changed.has('case')) this.rebuild();
    else if (changed.has('buffer') || changed.has('events')) this.redraw();
    if (changed.has('time') || changed.has('playback')) this.moveHead();
  }

  private rebuild(): void {
    const { observer, pinned } = this.viewer.state;
    const objects = [...new Set([observer, ...pinned])].filter((id) => id >= 0);
    this.tracks.keep(new Set(objects));
    this.curves = curvesOf(this.group, objects);
    this.plot?.destroy();
    this.plot = createPlot(this.chart, this.group, this.curves, this.world());
    this.fillLegend();
    this.paint();
  }

  private world(): PlotWorld {
    return {
      palette: () => this.palette,
      area: () => this.area,
      ends: () => this.ends(),
      selected: (fromS, toS) => this.axis.zoom({ fromUs: fromS * 1e6, toUs: toS * 1e6 }),
      reset: () => this.axis.reset(),
      clicked: (seconds) => this.viewer.seek(seconds * 1e6),
    };
  }

  private ends(): readonly number[] {
    const { events, collisions } = this.viewer.state;
    const tUs = failureUs(events, collisions);
    return tUs === null ? [] : [tUs / 1e6];
  }

  private fillLegend(): void {
    this.numbers = [];
    this.legend.replaceChildren(
      ...this.curves.map((curve) => {
        const number = el('span', { class: 'curves-number' });
        this.numbers.push(number);
        const line = el('canvas', {
          class: 'curves-sample',
          width: '44',
          height: '8',
          'aria-hidden': 'true',
        });
        drawSample(line, curve);
        return el('span', { class: 'curves-item' }, line, this.name(curve), number);
      }),
    );
  }

  private name({ object, kind }: Curve): string {
    const frame = this.viewer.packed.shown;
    const row = frame?.layout.rowOf.get(object);
    return `${shortNameOf(object, row === undefined ? 0 : (frame?.layout.kinds[row] ?? 0))} ${kind.name}`;
  }

  private redraw(): void {
    if (this.timer !== null) return;
    this.timer = setTimeout(() => {
      this.timer = null;
      this.paint();
    }, DRAW_EVERY_MS);
  }

  private resized(): void {
    const { clientWidth: width, clientHeight: height } = this.chart;
    if (width < 1 || height < 1) return;
    this.width = width;
    this.plot?.setSize({ width, height });
    this.paint();
  }

  private paint(): void {
    const { seconds, points } = this.data();
    this.plot?.setData([seconds, ...points], true);
    this.moveHead();
  }

  private data(): { seconds: number[]; points: Points[] } {
    const { frames } = this.viewer.packed;
    const { fromUs, toUs } = this.axis.span;
    const values = this.curves.map(
      ({ object, kind }) => this.tracks.of(object, kind.quantity, frames).values,
    );
    return decimate(this.tracks.times, values, fromUs, toUs, Math.round(plotWidth(this.width)));
  }

  private moveHead(): void {
    const { area } = this;
    const { tUs } = this.viewer.state;
    this.head.hidden = tUs < area.span.fromUs || tUs > area.span.toUs;
    this.head.style.transform = `translateX(${timeToX(area, tUs)}px)`;
    this.writeNumbers();
  }

  private writeNumbers(): void {
    const now = performance.now();
    if (this.viewer.state.playing && now - this.numbersMs < NUMBERS_EVERY_MS) return;
    this.numbersMs = now;
    const frame = this.viewer.packed.shown;
    this.curves.forEach(({ object, kind }, index) => {
      const row = frame?.layout.rowOf.get(object);
      const value = frame === null || row === undefined ? NaN : quantityAt(kind.quantity, frame, row);
      const element = this.numbers[index];
      if (element !== undefined) setText(element, Number.isFinite(value) ? value.toFixed(3) : '–');
    });
  }
}

// A bit of the curve's line: its colour and dashes.
function drawSample(canvas: HTMLCanvasElement, { object, kind }: Curve): void {
  const surface = canvas.getContext('2d');
  if (surface === null) return;
  surface.strokeStyle = objectColor(object);
  surface.lineWidth = kind.width * 2;
  surface.setLineDash(kind.dash.map((length) => length * 2));
  surface.beginPath();
  surface.moveTo(0, 4);
  surface.lineTo(44, 4);
  surface.stroke();
}
