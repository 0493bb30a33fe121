// The map: two canvases one over the other (what stands still, what moves), pointer gestures, and
// what keys and buttons ask of it.

import type { Viewer, Topic } from '../model/viewer';
import type { MapControls } from '../shell/parts';
import type { SettingsStore } from '../shell/settings';
import { el, setText } from '../shell/dom';
import { FrameCounter } from './frame_counter';
import { listenGestures } from './gestures';
import { drawMovingLayers } from './moving_layers';
import { pick } from './picking';
import type { Measure, Scene } from './scene';
import { CanvasStamps } from './stamps';
import { drawStaticLayers } from './static_layers';
import { SvgSurface } from './svg_surface';
import { TileLayer, type TileSource } from './tile_layer';
import { currentPalette, onThemeChange } from './theme_watch';
import { fitted, panned, type Size, type View, worldX, worldY, zoomedAt } from './view';
import { worldBounds } from './world_bounds';
import './map.css';

export interface MapView extends MapControls {
  stats(): { drawn: number; fps: number; scriptMs: number }; // scriptMs: of the last picture
}

const ZOOM_STEP = 1.25;

export function createMap(
  host: HTMLElement,
  viewer: Viewer,
  settings: SettingsStore,
  tiles: TileSource,
): MapView {
  return new CanvasMap(host, viewer, settings, tiles);
}

class CanvasMap implements MapView {
  private view: View = { x: 0, y: 0, scale: 40, size: { width: 1, height: 1 } };
  private palette = currentPalette();
  private touched = false; // the user chose the view
  private measure: Measure | null = null;
  private measureMode = false;
  private staticStale = true;
  private scheduled = false;
  private scriptMs = 0;
  private readonly counter = new FrameCounter();
  private readonly still = el('canvas', { class: 'map-canvas', 'aria-hidden': 'true' });
  private readonly moving = el('canvas', {
    class: 'map-canvas',
    tabindex: '0',
    role: 'img',
    'aria-label': 'Map. The table Objects has the same data.',
  });
  private readonly readout = el('div', { class: 'map-readout', 'aria-hidden': 'true' });
  private readonly stillSurface = context(this.still);
  private readonly movingSurface = context(this.moving);
  private readonly stamps = new CanvasStamps(this.movingSurface);
  private readonly tiles: TileLayer;

  constructor(
    host: HTMLElement,
    private readonly viewer: Viewer,
    private readonly settings: SettingsStore,
    source: TileSource,
  ) {
    host.append(this.still, this.moving, this.readout);
    this.tiles = new TileLayer(host, this.stillSurface, viewer, settings, source, () => this.redraw());
    listenGestures(this.moving, this.gestures());
    new ResizeObserver(() => this.resize({ width: host.clientWidth, height: host.clientHeight })).observe(
      host,
    );
    this.resize({ width: host.clientWidth, height: host.clientHeight });
    viewer.listen((changed) => this.changed(changed));
    settings.listen(() => this.redraw());
    onThemeChange(() => {
      this.palette = currentPalette();
      this.redraw();
    });
  }

  // ---- MapControls

  zoom(direction: 1 | -1): void {
    const { width, height } = this.view.size;
    this.setView(zoomedAt(this.view, direction > 0 ? ZOOM_STEP : 1 / ZOOM_STEP, width / 2, height / 2));
  }

  fit(): void {
    this.viewer.setFollowed(false);
    this.fitAll();
  }

  toggleMeasure(): boolean {
    this.measureMode = !this.measureMode;
    this.moving.classList.toggle('measuring', this.measureMode);
    return this.measureMode;
  }

  measuring(): boolean {
    return this.measureMode;
  }

  clear(): void {
    this.measure = null;
    if (this.measureMode) this.toggleMeasure();
    this.schedule();
  }

  centreOn(x: number, y: number): void {
    this.setView({ ...this.view, x, y });
  }

  picture(): Promise<Blob> {
    const canvas = el('canvas');
    canvas.width = this.still.width;
    canvas.height = this.still.height;
    const surface = context(canvas);
    surface.drawImage(this.still, 0, 0);
    surface.drawImage(this.moving, 0, 0);
    surface.setTransform(this.stillSurface.getTransform());
    this.tiles.sign(surface, this.palette, this.view.size);
    return new Promise((resolve, reject) => {
      canvas.toBlob((blob) =>
        blob === null ? reject(new Error('no picture: the map is empty')) : resolve(blob),
      );
    });
  }

  svg(): string {
    const surface = new SvgSurface();
    const scene = { ...this.scene(), stamps: null, ground: null };
    drawStaticLayers(surface, scene);
    drawMovingLayers(surface, scene);
    const { width, height } = this.view.size;
    const name = this.viewer.state.caseInfo?.caseId ?? 'map';
    return surface.document(width, height, `${name} at ${(scene.tUs / 1e6).toFixed(3)} s`);
  }

  stats(): ReturnType<MapView['stats']> {
    return {
      drawn: this.counter.drawn,
      fps: this.counter.perSecond(performance.now()),
      scriptMs: this.scriptMs,
    };
  }

  // ---- view

  private setView(view: View): void {
    this.view = view;
    this.touched = true;
    this.redraw();
  }

  private fitAll(): void {
    const { world } = this.viewer.state;
    const bounds = worldBounds(world, this.viewer.packed.shown);
    if (bounds === null) return;
    this.view = fitted(bounds, this.view.size);
    this.touched = false;
    this.redraw();
  }

  private resize(size: Size): void {
    const ratio = window.devicePixelRatio || 1;
    for (const canvas of [this.still, this.moving]) {
      canvas.width = Math.max(1, Math.round(size.width * ratio));
      canvas.height = Math.max(1, Math.round(size.height * ratio));
    }
    this.stillSurface.setTransform(ratio, 0, 0, ratio, 0, 0);
    this.movingSurface.setTransform(ratio, 0, 0, ratio, 0, 0);
    this.view = { ...this.view, size: { width: Math.max(1, size.width), height: Math.max(1, size.height) } };
    if (!this.touched) this.fitAll();
    this.staticStale = true;
    this.draw();
  }

  private gestures(): Parameters<typeof listenGestures>[1] {
    return {
      pan: (dx, dy) => {
        if (this.viewer.state.followed) this.viewer.setFollowed(false);
        this.setView(panned(this.view, dx, dy));
      },
      zoom: (factor, px, py) => this.setView(zoomedAt(this.view, factor, px, py)),
      click: (px, py) => {
        const id = pick(this.view, this.viewer.packed.shown, px, py);
        if (id >= 0) this.viewer.observe(id);
      },
      doubleClick: (px, py) => {
        const id = pick(this.view, this.viewer.packed.shown, px, py);
        if (id >= 0) {
          this.viewer.observe(id);
          this.viewer.setFollowed(true);
        } else {
          this.centreOn(worldX(this.view, px), worldY(this.view, py));
        }
      },
      measureFrom: (px, py) => {
        const x = worldX(this.view, px);
        const y = worldY(this.view, py);
        this.measure = { fromX: x, fromY: y, toX: x, toY: y };
        this.schedule();
      },
      measureTo: (px, py) => {
        if (this.measure === null) return;
        this.measure = { ...this.measure, toX: worldX(this.view, px), toY: worldY(this.view, py) };
        this.schedule();
      },
      hover: (px, py) => {
        const unit = this.settings.value.length;
        const text = (metres: number): string =>
          unit === 'm' ? metres.toFixed(2) : (metres * 1000).toFixed(0);
        const place = `x ${text(worldX(this.view, px))}  y ${text(worldY(this.view, py))} ${unit}`;
        setText(this.readout, `${place}   ${Number(this.view.scale.toPrecision(3))} px/m`);
      },
      leave: () => setText(this.readout, ''),
      measuring: () => this.measureMode,
    };
  }

  // ---- drawing

  private changed(changed: ReadonlySet<Topic>): void {
    if (changed.has('world') || (changed.has('case') && !this.touched)) this.staticStale = true;
    if (changed.has('source') && this.tiles.update()) this.staticStale = true;
    if (!this.touched && (changed.has('world') || changed.has('case') || this.counter.drawn === 0)) {
      this.fitAll();
    }
    const seen = ['time', 'events', 'faults', 'selection', 'world', 'source'] as const;
    if (seen.some((topic) => changed.has(topic))) this.draw();
  }

  private redraw(): void {
    this.staticStale = true;
    this.schedule();
  }

  private schedule(): void {
    if (this.scheduled) return;
    this.scheduled = true;
    requestAnimationFrame(() => {
      this.scheduled = false;
      this.draw();
    });
  }

  private draw(): void {
    const begin = performance.now();
    this.follow();
    const scene = this.scene();
    if (this.staticStale) drawStaticLayers(this.stillSurface, scene);
    this.staticStale = false;
    this.movingSurface.clearRect(0, 0, this.view.size.width, this.view.size.height);
    drawMovingLayers(this.movingSurface, scene);
    this.scriptMs = performance.now() - begin;
    this.counter.count(begin);
  }

  private follow(): void {
    const { followed, observer, frame } = this.viewer.state;
    if (!followed) return;
    const object = frame?.objects.find((one) => one.id === observer);
    if (object === undefined || (object.pos[0] === this.view.x && object.pos[1] === this.view.y)) return;
    this.view = { ...this.view, x: object.pos[0], y: object.pos[1] };
    this.touched = true;
    this.staticStale = true;
  }

  private scene(): Scene {
    const { state, packed } = this.viewer;
    return {
      view: this.view,
      palette: this.palette,
      layers: this.settings.value.layers,
      trail: this.settings.value.trail,
      unit: this.settings.value.length,
      tUs: state.tUs,
      world: state.world,
      frames: packed.frames,
      frame: packed.shown,
      risk: packed.risk,
      ranges: state.ranges,
      faults: state.faults,
      collisions: state.collisions,
      observer: state.observer,
      pinned: state.pinned,
      measure: this.measure,
      stamps: this.stamps,
      ground: this.tiles,
    };
  }
}

function context(canvas: HTMLCanvasElement): CanvasRenderingContext2D {
  const made = canvas.getContext('2d');
  if (made === null) throw new Error('this browser cannot draw on a canvas');
  return made;
}
