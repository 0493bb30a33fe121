// A folder of map tiles, as its tiles.json tells it and as the hello of the bridge passes it on. Names and meaning are
// those of TileJSON 3.0; "origin" is ours. Tiles are squares of Web Mercator (EPSG:3857), Z/X/Y with Y from the north.

export interface TileSet {
  origin: readonly [longitude: number, latitude: number]; // WGS84 degrees, of the place that objects call (0, 0)
  minzoom: number;
  maxzoom: number;
  attribution: string; // plain text, '' for none
}

export const deepestZoom = 30; // of TileJSON
// Where Web Mercator ends (degrees): atan(sinh(pi)), which makes its map a square.
export const mercatorEdge = 85.0511287798066;
const longestAttribution = 200;

// The members that a page needs, or one line saying which is wrong and what would be right; others are not looked at.
export function parseTileSet(value: unknown): TileSet | string {
  if (typeof value !== 'object' || value === null || Array.isArray(value)) return 'expected a JSON object';
  const { origin, minzoom, maxzoom, attribution = '' } = value as Record<string, unknown>;
  if (!isPlace(origin))
    return `origin: expected [longitude, latitude] in degrees, within 180 and ${mercatorEdge}, ${got(origin)}`;
  if (!isZoom(minzoom, 0))
    return `minzoom: expected a whole number from 0 to ${deepestZoom}, ${got(minzoom)}`;
  if (!isZoom(maxzoom, minzoom))
    return `maxzoom: expected a whole number from ${minzoom} (minzoom) to ${deepestZoom}, ${got(maxzoom)}`;
  if (typeof attribution !== 'string' || !isLine(attribution))
    return `attribution: expected one line of at most ${longestAttribution} characters, ${got(attribution)}`;
  return { origin, minzoom, maxzoom, attribution };
}

function isPlace(value: unknown): value is [number, number] {
  if (!Array.isArray(value) || value.length !== 2) return false;
  const [longitude, latitude] = value as unknown[];
  return within(longitude, 180) && within(latitude, mercatorEdge);
}

const within = (value: unknown, most: number): boolean =>
  typeof value === 'number' && Math.abs(value) <= most;

const isZoom = (value: unknown, least: number): value is number =>
  Number.isInteger(value) && (value as number) >= least && (value as number) <= deepestZoom;

const isLine = (text: string): boolean => text.length <= longestAttribution && !/\p{Cc}/u.test(text);

function got(value: unknown): string {
  return value === undefined ? 'got none' : `got ${JSON.stringify(value).slice(0, 60)}`;
}
