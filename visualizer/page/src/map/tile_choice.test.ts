import { describe, expect, it } from 'vitest';
import { Random } from '../../../codec/random';
import { LocalFrame } from './local_frame';
import { MOST_TILES, type ShownTile, tilesInView } from './tile_choice';
import { MAX_SCALE, MIN_SCALE, screenX, screenY, type View } from './view';

// The north-west corner of tile 10/486/332, from the documentation of the Python package mercantile.
const corner = [-9.140625, 53.33087298301705] as const;
const set = { origin: corner, minzoom: 0, maxzoom: 22, attribution: '' };
const frame = new LocalFrame(corner);
const view: View = { x: 0, y: 0, scale: 1, size: { width: 800, height: 600 } };

const numbers = (tiles: readonly ShownTile[]): number[][] => tiles.map(({ z, x, y }) => [z, x, y]);
const zooms = (tiles: readonly ShownTile[]): number[] => [...new Set(tiles.map(({ z }) => z))];

describe('the tiles of a view', () => {
  it('around a corner of four are these four, and meet there', () => {
    const tiles = tilesInView({ ...set, maxzoom: 10 }, frame, view, 1);
    expect(numbers(tiles)).toEqual([
      [10, 485, 331],
      [10, 486, 331],
      [10, 485, 332],
      [10, 486, 332],
    ]);
    expect(tiles.map(({ left, top, width, height }) => [left + 0, top + 0, width, height])).toEqual([
      [0, 0, 400, 300],
      [400, 0, 400, 300],
      [0, 300, 400, 300],
      [400, 300, 400, 300],
    ]);
    // The south-eastern one begins there; one of zoom 10 is some 23 km wide there.
    expect(tiles[3]).toMatchObject({ u: expect.closeTo(0, 6), v: expect.closeTo(0, 6) });
    expect(tiles[3]?.du).toBeCloseTo(400 / 23_430, 4);
  });

  it('are of the zoom that is nearest to a pixel for a pixel', () => {
    // The usual figure for a sphere of the Earth's equator.
    const metresOfPixel = (zoom: number): number =>
      (40_075_016.686 * Math.cos((corner[1] * Math.PI) / 180)) / 2 ** zoom / 256;
    for (const zoom of [12, 16, 17, 20]) {
      const scale = 1 / metresOfPixel(zoom);
      expect(zooms(tilesInView(set, frame, { ...view, scale }, 1))).toEqual([zoom]);
      expect(zooms(tilesInView(set, frame, { ...view, scale: scale * 1.3 }, 1))).toEqual([zoom]);
      expect(zooms(tilesInView(set, frame, { ...view, scale: scale / 1.3 }, 1))).toEqual([zoom]);
      expect(zooms(tilesInView(set, frame, { ...view, scale }, 2))).toEqual([zoom + 1]);
    }
  });

  it('are of the deepest zoom beyond it, and none where the shallowest would be too many', () => {
    const few = { ...set, minzoom: 17, maxzoom: 18 };
    expect(zooms(tilesInView(few, frame, { ...view, scale: MAX_SCALE }, 1))).toEqual([18]);
    expect(zooms(tilesInView(few, frame, { ...view, scale: 0.5 }, 1))).toEqual([17]);
    expect(tilesInView(few, frame, { ...view, scale: MIN_SCALE }, 1)).toEqual([]);
  });

  it('are none where the flat frame says nothing about the Earth', () => {
    for (const far of [1e6, 1e30, Number.NaN]) {
      expect(tilesInView(set, frame, { ...view, x: far }, 1)).toEqual([]);
      expect(tilesInView(set, frame, { ...view, y: -far }, 1)).toEqual([]);
    }
  });

  it('go on around the Earth, and end at the edge of the map', () => {
    const pacific = tilesInView({ ...set, maxzoom: 10 }, new LocalFrame([180, 0.01]), view, 1);
    expect(numbers(pacific)).toEqual([
      [10, 1023, 511],
      [10, 0, 511],
    ]);
    const edge = new LocalFrame([0, 85.0511287798066]);
    const north = tilesInView({ ...set, maxzoom: 12 }, edge, { ...view, x: 10, scale: 0.5 }, 1);
    expect(north.length).toBeGreaterThan(0);
    for (const { y, top } of north) {
      expect(y).toBeGreaterThanOrEqual(0);
      expect(top).toBeGreaterThanOrEqual(299); // the origin is in the middle, nothing north of it
    }
  });

  it('cover any view without gap or overlap, each at its place', () => {
    const random = new Random(2);
    for (let i = 0; i < 100; i += 1) {
      const size = { width: 300 + random.below(3000), height: 200 + random.below(1800) };
      const scale = MIN_SCALE * (MAX_SCALE / MIN_SCALE) ** (random.below(1000) / 999);
      const devicePixels = random.pick([1, 1.25, 2]);
      const any: View = { x: random.below(4000) - 2000, y: random.below(4000) - 2000, scale, size };
      const local = new LocalFrame([random.below(360) - 180, random.below(160) - 80]);
      const tiles = tilesInView(set, local, any, devicePixels);
      expect(tiles.length).toBeGreaterThan(0);
      expect(tiles.length).toBeLessThanOrEqual(MOST_TILES);
      const area = tiles.reduce((sum, { width, height }) => sum + width * height, 0);
      // Up to half a pixel at each edge of the view.
      expect(Math.abs(area - size.width * size.height)).toBeLessThanOrEqual(size.width + size.height + 1);
      for (const tile of tiles) {
        const { x, y } = local.fromMap({
          u: (tile.x + tile.u) / 2 ** tile.z,
          v: (tile.y + tile.v) / 2 ** tile.z,
        });
        const turn = Math.round((x - any.x) / local.sideM) * local.sideM;
        expect(Math.abs(screenX(any, x - turn) - tile.left)).toBeLessThan(0.51);
        expect(Math.abs(screenY(any, y) - tile.top)).toBeLessThan(0.51);
      }
    }
  });
});
