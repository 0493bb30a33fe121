// The layer of map tiles: pictures below everything else of the map, and whom they are from.

import type { TileSet } from '../../../codec/tile_set';
import type { Viewer } from '../model/viewer';
import { el, setHidden, setText } from '../shell/dom';
import type { SettingsStore } from '../shell/settings';
import { LocalFrame } from './local_frame';
import type { Palette } from './palette';
import { type LoadTile, TileCache } from './tile_cache';
import { tilesInView } from './tile_choice';
import type { Size, View } from './view';

// What the static layers draw first; there is none when a picture is not drawn on a canvas.
export interface Ground {
  draw(view: View, palette: Palette): void;
}

// Where tiles come from, and who is told of the first that could not be had.
export interface TileSource {
  load: LoadTile<ImageBitmap>;
  complain(line: string): void;
}

interface Tiles {
  readonly set: TileSet;
  readonly frame: LocalFrame;
  readonly cache: TileCache<ImageBitmap>;
}

export class TileLayer implements Ground {
  private tiles: Tiles | null = null;
  private readonly attribution = el('div', { class: 'map-attribution' });

  // `arrived` is called after each picture that has come.
  constructor(
    host: HTMLElement,
    private readonly surface: CanvasRenderingContext2D,
    private readonly viewer: Viewer,
    private readonly settings: SettingsStore,
    private readonly source: TileSource,
    private readonly arrived: () => void,
  ) {
    host.append(this.attribution);
  }

  // Answers whether there are other tiles than before: of another bridge, or of one that was started anew.
  update(): boolean {
    const { tiles: set } = this.viewer.state.connection;
    if (set === (this.tiles?.set ?? null)) return false;
    this.tiles?.cache.clear();
    this.tiles = set === null ? null : this.tilesOf(set, this.source);
    return true;
  }

  draw(view: View, palette: Palette): void {
    setText(this.attribution, this.signature);
    setHidden(this.attribution, this.signature === '');
    if (this.tiles === null || !this.on) return;
    const { surface } = this;
    const { set, frame, cache } = this.tiles;
    const mayAsk = this.viewer.state.connection.connected;
    surface.globalAlpha = Number(palette.tileOpacity);
    for (const tile of tilesInView(set, frame, view, surface.getTransform().a)) {
      const picture = cache.get(tile.z, tile.x, tile.y, mayAsk);
      if (picture === null) continue;
      const [sx, sy] = [tile.u * picture.width, tile.v * picture.height];
      const [sw, sh] = [tile.du * picture.width, tile.dv * picture.height];
      surface.drawImage(picture, sx, sy, sw, sh, tile.left, tile.top, tile.width, tile.height);
    }
    surface.globalAlpha = 1;
  }

  // Writes into a picture whom the tiles are from, in the corner where the page says it.
  sign(surface: CanvasRenderingContext2D, palette: Palette, { width, height }: Size): void {
    if (this.signature === '') return;
    surface.font = `11px ${palette.font}`;
    surface.textAlign = 'right';
    surface.textBaseline = 'bottom';
    const wide = surface.measureText(this.signature).width;
    surface.fillStyle = palette.background;
    surface.fillRect(width - wide - 6, height - 14, wide + 6, 14);
    surface.fillStyle = palette.text;
    surface.fillText(this.signature, width - 3, height - 1);
  }

  private get on(): boolean {
    return this.settings.value.layers.tiles;
  }

  private get signature(): string {
    return this.on ? (this.tiles?.set.attribution ?? '') : '';
  }

  private tilesOf(set: TileSet, { load, complain }: TileSource): Tiles {
    return { set, frame: new LocalFrame(set.origin), cache: new TileCache(load, this.arrived, complain) };
  }
}
