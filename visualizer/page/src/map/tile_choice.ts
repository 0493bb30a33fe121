// Which map tiles a view shows, and where. Pure.

import { mercatorEdge, type TileSet } from '../../../codec/tile_set';
import type { LocalFrame } from './local_frame';
import { screenX, screenY, type View, worldX, worldY } from './view';

// A tile, or the part of it that is in the view.
export interface ShownTile {
  readonly z: number;
  readonly x: number;
  readonly y: number;
  // Its place on the map, CSS pixels.
  readonly left: number;
  readonly top: number;
  readonly width: number;
  readonly height: number;
  // The part of its picture, of which the whole is 0, 0, 1, 1.
  readonly u: number;
  readonly v: number;
  readonly du: number;
  readonly dv: number;
}

const TILE_PX = 256; // of each side, at its own scale
export const MOST_TILES = 256; // at once: a screen of 4K needs some 200
// Farther from the origin a flat frame says nothing about the Earth (m).
const REACH_M = 100_000;

// The tiles of the zoom that comes nearest to one pixel of a tile on one of the screen; the deepest one is enlarged
// beyond that. None where they would be too many, because the shallowest there is is too deep for the view.
export function tilesInView(set: TileSet, frame: LocalFrame, view: View, devicePixels: number): ShownTile[] {
  if (!(Math.abs(view.x) < REACH_M && Math.abs(view.y) < REACH_M)) return [];
  const wanted = Math.round(Math.log2((frame.sideM * view.scale * devicePixels) / TILE_PX));
  const most = Math.min(Math.max(wanted, set.minzoom), set.maxzoom);
  for (let z = most; z >= set.minzoom; z--) {
    const area = areaOf(frame, view, 2 ** z);
    if (area.columns * area.rows <= MOST_TILES) return tilesOf(z, area, frame, view, devicePixels);
  }
  return [];
}

// What of the map is in view, in tiles of a zoom.
interface Area {
  readonly west: number;
  readonly east: number;
  readonly north: number;
  readonly south: number;
  readonly columns: number; // of tiles that are at least partly in view
  readonly rows: number;
}

function areaOf(frame: LocalFrame, view: View, across: number): Area {
  const { width, height } = view.size;
  const edge = (py: number): number => {
    const { latitude } = frame.place(0, worldY(view, py));
    return Math.abs(latitude) < mercatorEdge ? frame.toMap(0, worldY(view, py)).v : latitude > 0 ? 0 : 1;
  };
  const west = frame.toMap(worldX(view, 0), 0).u * across;
  const east = frame.toMap(worldX(view, width), 0).u * across;
  const [north, south] = [edge(0) * across, edge(height) * across];
  return {
    west,
    east,
    north,
    south,
    columns: Math.ceil(east) - Math.floor(west),
    rows: Math.ceil(south) - Math.floor(north),
  };
}

function tilesOf(z: number, area: Area, frame: LocalFrame, view: View, devicePixels: number): ShownTile[] {
  const across = 2 ** z;
  // Edges on whole pixels of the device: between two that are not, the ground would shine through.
  const whole = (px: number): number => Math.round(px * devicePixels) / devicePixels;
  const px = (u: number): number => whole(screenX(view, frame.fromMap({ u: u / across, v: 0.5 }).x));
  const py = (v: number): number => whole(screenY(view, frame.fromMap({ u: 0.5, v: v / across }).y));
  const tiles: ShownTile[] = [];
  for (let y = Math.floor(area.north); y < area.south; y++) {
    for (let x = Math.floor(area.west); x < area.east; x++) {
      const [west, east] = [Math.max(x, area.west), Math.min(x + 1, area.east)];
      const [north, south] = [Math.max(y, area.north), Math.min(y + 1, area.south)];
      const [left, top] = [px(west), py(north)];
      tiles.push({
        z,
        x: ((x % across) + across) % across, // the map goes on around the Earth
        y,
        left,
        top,
        width: px(east) - left,
        height: py(south) - top,
        u: west - x,
        v: north - y,
        du: east - west,
        dv: south - north,
      });
    }
  }
  return tiles;
}
