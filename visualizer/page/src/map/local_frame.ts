// The flat frame of objects (m, x east, y north) on the Earth, and on Web Mercator's map of it. Pure.
//
// Metres become degrees by the radii of curvature of the WGS84 ellipsoid at the frame's origin, latitude f0:
//   M = a (1 - e^2) / (1 - e^2 sin^2 f0)^(3/2)   along the meridian   (Snyder, Map Projections - A Working Manual,
//   N = a / (1 - e^2 sin^2 f0)^(1/2)             across it             USGS Professional Paper 1395, 4-18 and 4-20)
//   longitude = l0 + x / (N cos f0),  latitude = f0 + y / M
// A place is off by about d^2 tan(f0) / 2a at a distance d: 0.1 m at 1 km, 14 m at 10 km, at 60 degrees.
//
// The map is a square (EPSG:3857; EPSG guidance note 7-2, Popular Visualisation Pseudo Mercator), here of side 1:
//   u = 1/2 + longitude / 360 to the east,  v = 1/2 - asinh(tan latitude) / 2 pi to the south

import type { TileSet } from '../../../codec/tile_set';

const SEMI_MAJOR_M = 6_378_137; // a
const FLATTENING = 1 / 298.257_223_563;
const E2 = FLATTENING * (2 - FLATTENING);
const DEGREE = Math.PI / 180;

export interface Place {
  readonly longitude: number; // degrees
  readonly latitude: number;
}

// Lengths of a radian of longitude and of latitude (m).
export interface Radii {
  readonly east: number;
  readonly north: number;
}

export function radiiAt(latitude: number): Radii {
  const root = Math.sqrt(1 - E2 * Math.sin(latitude * DEGREE) ** 2);
  return {
    east: (SEMI_MAJOR_M / root) * Math.cos(latitude * DEGREE),
    north: (SEMI_MAJOR_M * (1 - E2)) / root ** 3,
  };
}

// Parts of the map's side, 0 to 1; u goes on beyond, once more around the Earth.
export interface MapPoint {
  readonly u: number; // from the west
  readonly v: number; // from the north
}

export function onMap({ longitude, latitude }: Place): MapPoint {
  return { u: 0.5 + longitude / 360, v: 0.5 - Math.asinh(Math.tan(latitude * DEGREE)) / (2 * Math.PI) };
}

export function fromMap({ u, v }: MapPoint): Place {
  return { longitude: (u - 0.5) * 360, latitude: Math.atan(Math.sinh((0.5 - v) * 2 * Math.PI)) / DEGREE };
}

export class LocalFrame {
  private readonly longitude: number;
  private readonly latitude: number;
  private readonly radii: Radii;

  constructor([longitude, latitude]: TileSet['origin']) {
    this.longitude = longitude;
    this.latitude = latitude;
    this.radii = radiiAt(latitude);
  }

  place(x: number, y: number): Place {
    return {
      longitude: this.longitude + x / this.radii.east / DEGREE,
      latitude: this.latitude + y / this.radii.north / DEGREE,
    };
  }

  // Where on the map a point of the frame (m) is. Its u depends on x alone, its v on y alone.
  toMap(x: number, y: number): MapPoint {
    return onMap(this.place(x, y));
  }

  // The other way.
  fromMap(point: MapPoint): { x: number; y: number } {
    const { longitude, latitude } = fromMap(point);
    return {
      x: (longitude - this.longitude) * DEGREE * this.radii.east,
      y: (latitude - this.latitude) * DEGREE * this.radii.north,
    };
  }

  // Length of the Earth's circle of latitude through the origin (m): the map's side there.
  get sideM(): number {
    return 2 * Math.PI * this.radii.east;
  }
}
