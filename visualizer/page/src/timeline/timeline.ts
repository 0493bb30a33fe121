// The timeline: rows over the curves, and a slider by pointer and keyboard. Dragging scrubs, with
// shift it marks the part that is looped.

import './timeline.css';
import { currentPalette, onThemeChange } from '../map/theme_watch';
import type { SvgSurface } from '../map/svg_surface';
import { AvoidanceSpans } from '../model/avoidance';
import { failureUs } from '../model/event_log';
import { faultText } from '../model/faults';
import { type TimeAxis, wholeSpan } from '../model/time_axis';
import type { Topic, Viewer } from '../model/viewer';
import { el } from '../shell/dom';
import { laneBars } from './lanes';
import { LEFT, type PlotArea, timeToX, xToTime } from './plot_area';
import { sliderTarget } from './slider_keys';
import { drawRows, laneHeight, type Rows, rowsHeight, rowTops } from './timeline_rows';
import { valueText } from './value_text';

export interface Timeline {
  draw(surface: SvgSurface): { width: number; height: number }; // for the exported picture
}

export function createTimeline(host: HTMLElement, viewer: Viewer, axis: TimeAxis): Timeline {
  return new CanvasTimeline(host, viewer, axis);
}

// The value for screen readers changes at most so often while playing.
const VALUE_EVERY_MS = 500;
// While frames come, the rows grow this often.
const GROWS_EVERY_MS = 200;

class CanvasTimeline implements Timeline {
  private palette = currentPalette();
  private readonly avoidance = new AvoidanceSpans();
  private readonly canvas = el('canvas', { class: 'timeline-canvas', 'aria-hidden': 'true' });
  private readonly head = el('div', { class: 'timeline-head', 'aria-hidden': 'true' });
  private readonly slider = el('div', {
    class: 'timeline',
    role: 'slider',
    tabindex: '0',
    'aria-label': 'Time',
  });
  private width = 0;
  private height = 0;
  private valueMs = -Infinity;
  private command = -1;
  private scheduled = false;
  private later: ReturnType<typeof setTimeout> | null = null;

  constructor(
    host: HTMLElement,
    private readonly viewer: Viewer,
    private readonly axis: TimeAxis,
  ) {
    this.slider.append(this.canvas, this.head);
    host.append(this.slider);
    this.listenPointer();
    this.slider.addEventListener('keydown', (event) => this.key(event));
    new ResizeObserver(() => this.redraw()).observe(host);
    axis.listen(() => this.redraw());
    onThemeChange(() => {
      this.palette = currentPalette();
      this.redraw();
    });
    viewer.listen((changed) => this.changed(changed));
    this.redraw();
  }

  draw(surface: SvgSurface): { width: number; height: number } {
    const rows = this.rows();
    drawRows(surface, this.area, rows);
    return { width: this.width, height: rowsHeight(rows.bars) };
  }

  private get area(): PlotArea {
    return { width: this.width, span: this.axis.span };
  }

  private changed(changed: ReadonlySet<Topic>): void {
    const { state } = this.viewer;
    if (changed.has('buffer') || changed.has('status') || changed.has('case')) {
      const known = state.connection.kind !== 'socket' || (state.status?.durationUs ?? -1) > 0;
      this.axis.setWhole(wholeSpan(known, state.fromUs, state.durationUs));
    }
    if (changed.has('buffer')) this.redrawLater();
    const rows = ['case', 'faults', 'events', 'selection', 'playback'] as const;
    if (rows.some((topic) => changed.has(topic)) || state.currentCommand !== this.command) this.redraw();
    if (changed.has('time')) this.moveHead();
  }

  private redrawLater(): void {
    this.later ??= setTimeout(() => {
      this.later = null;
      this.paint();
    }, GROWS_EVERY_MS);
  }

  private redraw(): void {
    if (this.scheduled) return;
    this.scheduled = true;
    requestAnimationFrame(() => {
      this.scheduled = false;
      this.paint();
    });
  }

  private paint(): void {
    const rows = this.rows();
    this.command = rows.currentCommand;
    this.resize(this.slider.clientWidth, rowsHeight(rows.bars));
    const surface = this.canvas.getContext('2d');
    if (surface === null || this.width < 1) return;
    drawRows(surface, this.area, rows);
    this.moveHead();
  }

  private resize(width: number, height: number): void {
    if (width === this.width && height === this.height) return;
    this.width = width;
    this.height = height;
    const ratio = window.devicePixelRatio || 1;
    this.canvas.width = Math.round(width * ratio);
    this.canvas.height = Math.round(height * ratio);
    this.canvas.style.height = `${height}px`;
    this.slider.style.height = `${height}px`;
    this.canvas.getContext('2d')?.setTransform(ratio, 0, 0, ratio, 0, 0);
  }

  private rows(): Rows {
    const { state, packed } = this.viewer;
    return {
      palette: this.palette,
      caseInfo: state.caseInfo,
      currentCommand: state.currentCommand,
      failingCommand: state.failingCommand,
      bars: laneBars(state.faults?.items ?? [], Math.max(state.toUs, state.tUs)),
      avoiding: this.avoidance.of(state.observer, packed.frames),
      collisions: state.collisions,
      failureUs: failureUs(state.events, state.collisions),
      heldUs: { fromUs: state.fromUs, toUs: state.toUs },
      loop: state.loop,
    };
  }

  private moveHead(): void {
    const x = timeToX(this.area, this.viewer.state.tUs);
    this.head.hidden = x < LEFT - 1 || x > this.width;
    this.head.style.transform = `translateX(${x}px)`;
    const now = performance.now();
    if (this.viewer.state.playing && now - this.valueMs < VALUE_EVERY_MS) return;
    this.valueMs = now;
    const { startUs, durationUs, tUs } = this.viewer.state;
    this.slider.setAttribute('aria-valuemin', (startUs / 1e6).toFixed(3));
    this.slider.setAttribute('aria-valuemax', (durationUs / 1e6).toFixed(3));
    this.slider.setAttribute('aria-valuenow', (tUs / 1e6).toFixed(3));
    this.slider.setAttribute('aria-valuetext', valueText(this.viewer.state));
  }

  private listenPointer(): void {
    let markFrom: number | null = null;
    let scrubbing = false;
    const timeOf = (event: MouseEvent): number =>
      xToTime(this.area, event.clientX - this.slider.getBoundingClientRect().left);
    this.slider.addEventListener('pointerdown', (event) => {
      if (event.button !== 0) return;
      this.slider.setPointerCapture(event.pointerId);
      if (event.shiftKey) {
        markFrom = timeOf(event);
      } else {
        scrubbing = true;
        this.viewer.seek(timeOf(event));
      }
    });
    this.slider.addEventListener('pointermove', (event) => {
      const tUs = timeOf(event);
      if (scrubbing) this.viewer.seek(tUs);
      else if (markFrom !== null) this.mark(markFrom, tUs);
      else this.slider.title = this.hint(event);
    });
    const end = (): void => {
      scrubbing = false;
      markFrom = null;
    };
    this.slider.addEventListener('pointerup', end);
    this.slider.addEventListener('pointercancel', end);
    this.slider.addEventListener('dblclick', () => this.axis.reset());
  }

  private mark(fromUs: number, toUs: number): void {
    if (Math.abs(toUs - fromUs) < 20_000) return;
    this.viewer.setLoop({ fromUs: Math.min(fromUs, toUs), toUs: Math.max(fromUs, toUs) });
  }

  // What is under the pointer, in full.
  private hint(event: MouseEvent): string {
    const box = this.slider.getBoundingClientRect();
    const y = event.clientY - box.top;
    const tUs = xToTime(this.area, event.clientX - box.left);
    const { caseInfo, faults, toUs } = this.viewer.state;
    const bars = laneBars(faults?.items ?? [], toUs);
    const tops = rowTops(bars);
    if (y < tops.faults) {
      const command = [...(caseInfo?.commands ?? [])].reverse().find((one) => one.tUs <= tUs);
      return command === undefined ? '' : `${command.index + 1}: ${command.name}(${command.args})`;
    }
    const lane = Math.floor((y - tops.faults) / laneHeight(bars));
    const bar = bars.find((one) => one.lane === lane && one.fault.fromUs <= tUs && tUs <= one.toUs);
    return bar === undefined ? '' : faultText(bar.fault);
  }

  // The keys of a slider; the page's own keys must not act as well.
  private key(event: KeyboardEvent): void {
    const { tUs, startUs, durationUs } = this.viewer.state;
    const target = sliderTarget(event.key, event.shiftKey, tUs, startUs, durationUs);
    if (target === null || event.ctrlKey || event.altKey || event.metaKey) return;
    event.preventDefault();
    event.stopPropagation();
    this.viewer.seek(target);
  }
}
