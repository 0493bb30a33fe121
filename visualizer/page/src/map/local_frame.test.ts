import { describe, expect, it } from 'vitest';
import { Random } from '../../../codec/random';
import { fromMap, LocalFrame, onMap, radiiAt } from './local_frame';

const random = new Random(1);
const between = (low: number, high: number): number => low + (high - low) * (random.below(1_000_001) / 1e6);
// Seeded frames from the equator to far north and south, and points within 20 km of them.
const cases = Array.from({ length: 200 }, () => ({
  origin: [between(-180, 180), between(-80, 80)] as const,
  x: between(-20_000, 20_000),
  y: between(-20_000, 20_000),
}));

// The tile of a place, as the names of its file.
function tileOf(longitude: number, latitude: number, zoom: number): number[] {
  const { u, v } = onMap({ longitude, latitude });
  return [Math.floor(u * 2 ** zoom), Math.floor(v * 2 ** zoom)];
}

describe('the map', () => {
  // From the documentation of the Python package mercantile: bounds(486, 332, 10).
  const west = -9.140625;
  const east = -8.7890625;
  const north = 53.33087298301705;
  const south = 53.12040528310657;

  it('has tile 10/486/332 where mercantile has it', () => {
    const corner = fromMap({ u: 486 / 1024, v: 332 / 1024 });
    expect(corner.longitude).toBeCloseTo(west, 12);
    expect(corner.latitude).toBeCloseTo(north, 12);
    const opposite = fromMap({ u: 487 / 1024, v: 333 / 1024 });
    expect(opposite.longitude).toBeCloseTo(east, 12);
    expect(opposite.latitude).toBeCloseTo(south, 12);
    expect(tileOf((west + east) / 2, (north + south) / 2, 10)).toEqual([486, 332]);
  });

  it('is a square that ends at 85.0511 degrees, as Web Mercator does', () => {
    expect(fromMap({ u: 0, v: 0 })).toEqual({ longitude: -180, latitude: expect.closeTo(85.0511287798, 9) });
    expect(fromMap({ u: 1, v: 1 })).toEqual({ longitude: 180, latitude: expect.closeTo(-85.0511287798, 9) });
    expect(onMap({ longitude: 0, latitude: 0 })).toEqual({ u: 0.5, v: 0.5 });
  });
});

describe('lengths of a degree', () => {
  // By the series for WGS84 as Wikipedia gives it ("Geographic coordinate system"), good to some centimetres.
  it.each([0, 15, 30, 45, 57.7, 60, 75, 85])('at latitude %d are those of WGS84', (latitude) => {
    const cos = (times: number): number => Math.cos((times * latitude * Math.PI) / 180);
    const north = 111_132.92 - 559.82 * cos(2) + 1.175 * cos(4) - 0.0023 * cos(6);
    const east = 111_412.84 * cos(1) - 93.5 * cos(3) + 0.118 * cos(5);
    const radii = radiiAt(latitude);
    expect(Math.abs((radii.north * Math.PI) / 180 - north)).toBeLessThan(0.1);
    expect(Math.abs((radii.east * Math.PI) / 180 - east)).toBeLessThan(0.1);
    expect(radiiAt(-latitude)).toEqual(radii);
  });
});

describe('a local frame', () => {
  it('has its origin where it is said to be', () => {
    for (const { origin } of cases) {
      expect(new LocalFrame(origin).place(0, 0)).toEqual({ longitude: origin[0], latitude: origin[1] });
      const { u, v } = new LocalFrame(origin).toMap(0, 0);
      const tile = tileOf(...origin, 18);
      expect([Math.floor(u * 2 ** 18), Math.floor(v * 2 ** 18)]).toEqual(tile);
    }
  });

  it('goes to the map and back within a micrometre', () => {
    for (const { origin, x, y } of cases) {
      const frame = new LocalFrame(origin);
      const back = frame.fromMap(frame.toMap(x, y));
      expect(Math.hypot(back.x - x, back.y - y)).toBeLessThan(1e-6);
    }
  });

  it('grows to the east with x and to the north with y, each on its own', () => {
    for (const { origin, x, y } of cases) {
      const frame = new LocalFrame(origin);
      const here = frame.toMap(x, y);
      expect(frame.toMap(x + 1, y).u).toBeGreaterThan(here.u);
      expect(frame.toMap(x, y + 1).v).toBeLessThan(here.v);
      expect([frame.toMap(x, 0).u, frame.toMap(0, y).v]).toEqual([here.u, here.v]);
    }
  });

  // The usual figure for a sphere of the Earth's equator; the ellipsoid differs by up to 0.7 %.
  it('has tiles of cos(latitude) 40075016.686 m / 2^zoom', () => {
    for (const { origin } of cases) {
      const frame = new LocalFrame(origin);
      for (const zoom of [10, 16, 22]) {
        const { u, v } = frame.toMap(0, 0);
        const side = 2 ** -zoom;
        const [a, b] = [frame.fromMap({ u, v }), frame.fromMap({ u: u + side, v: v + side })];
        const usual = (Math.cos((origin[1] * Math.PI) / 180) * 40_075_016.686) / 2 ** zoom;
        expect(Math.abs((b.x - a.x) / usual - 1)).toBeLessThan(0.007);
        // To the south tiles grow and shrink with the cosine: within 1 % across one of zoom 16.
        if (zoom >= 16) expect(Math.abs((a.y - b.y) / usual - 1)).toBeLessThan(0.01);
      }
      expect(frame.sideM).toBeCloseTo(
        frame.fromMap({ u: 1, v: 0.5 }).x - frame.fromMap({ u: 0, v: 0.5 }).x,
        3,
      );
    }
  });
});
