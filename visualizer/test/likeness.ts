// Whether two pictures of the page show the same, whatever drew the letters. Both are averaged over cells of 8 x 8 CSS
// pixels. A cell is unlike when no cell of the other picture at its place or next to it has about its colour; asked both
// ways, so that what is missing counts as what is new. Letters of other fonts, smoothed otherwise or wider by some pixels,
// change few cells; what is gone, elsewhere by 20 pixels, or of another colour changes many. How many of a region may be
// unlike is in its row of the table.

import type { Picture } from './png';

const cell = 8; // CSS pixels
const near = 12; // of 255, in each of red, green and blue

export interface Region {
  readonly name: string;
  readonly x: number; // CSS pixels of a page of 1440 x 900
  readonly y: number;
  readonly width: number;
  readonly height: number;
  readonly most: number; // share of its cells that may be unlike
}

const region = (name: string, x: number, y: number, width: number, height: number, most = 0.05): Region => ({
  name,
  x,
  y,
  width,
  height,
  most,
});

// Of the map, where no letters are drawn but those of faults and distances, one cell of 5900; over it lie a line of text
// and buttons as wide as their letters.
export const regions: readonly Region[] = [
  region('header', 0, 0, 1440, 44, 0.06),
  region('commands', 0, 44, 268, 456),
  region('shrinking', 0, 500, 268, 176),
  region('layers', 0, 676, 268, 224),
  region('banner', 268, 44, 872, 56, 0.12),
  region('map buttons', 1048, 100, 92, 124, 0.12),
  region('map', 268, 100, 780, 490, 0.0003),
  region('playback', 268, 614, 872, 38, 0.08),
  region('timeline', 268, 652, 872, 60),
  region('curves', 268, 712, 872, 188),
  region('object', 1140, 44, 300, 282),
  region('inject', 1140, 326, 300, 388),
  region('steer', 1140, 714, 300, 186),
];

export interface Comparison {
  readonly unlike: readonly string[]; // names of regions
  readonly shares: string; // how much of each region is unlike, in a line
  marked(): Picture; // what was seen, pale, with the unlike cells in red
}

// `scale` is how many pixels of each picture make a CSS pixel.
export function compare(wanted: Scaled, seen: Scaled): Comparison {
  const [a, b] = [cellsOf(wanted), cellsOf(seen)];
  const differs = new Set<number>();
  for (let y = 0; y < a.height; y++)
    for (let x = 0; x < a.width; x++)
      if (isAlone(a, b, x, y) || isAlone(b, a, x, y)) differs.add(y * a.width + x);
  const told = regions.map((one) => ({ ...one, share: shareOf(one, differs, a.width) }));
  return {
    unlike: told.filter(({ share, most }) => share > most).map(({ name }) => name),
    shares: told.map(({ name, share }) => `${name} ${(100 * share).toFixed(2)} %`).join(', '),
    marked: () => marked(seen, differs, a.width),
  };
}

export interface Scaled {
  readonly picture: Picture;
  readonly scale: number;
}

// Means over squares of so many pixels, as RGB.
export function shrunk({ width, height, channels, bytes }: Picture, by: number): Picture {
  const [w, h] = [Math.floor(width / by), Math.floor(height / by)];
  const sums = new Float64Array(w * h * 3);
  for (let y = 0; y < h * by; y++)
    for (let x = 0; x < w * by; x++) {
      const from = (y * width + x) * channels;
      const to = (Math.floor(y / by) * w + Math.floor(x / by)) * 3;
      for (let k = 0; k < 3; k++) sums[to + k] = (sums[to + k] ?? 0) + (bytes[from + k] ?? 0);
    }
  return {
    width: w,
    height: h,
    channels: 3,
    bytes: Uint8Array.from(sums, (sum) => Math.round(sum / by ** 2)),
  };
}

const cellsOf = ({ picture, scale }: Scaled): Picture => shrunk(picture, cell * scale);

// Whether no cell of the other picture there or next to it is about the same.
function isAlone(one: Picture, other: Picture, x: number, y: number): boolean {
  for (let toY = Math.max(0, y - 1); toY <= Math.min(other.height - 1, y + 1); toY++)
    for (let toX = Math.max(0, x - 1); toX <= Math.min(other.width - 1, x + 1); toX++)
      if (isNear(one, (y * one.width + x) * 3, other, (toY * other.width + toX) * 3)) return false;
  return true;
}

function isNear(one: Picture, i: number, other: Picture, j: number): boolean {
  for (let k = 0; k < 3; k++)
    if (Math.abs((one.bytes[i + k] ?? 0) - (other.bytes[j + k] ?? 0)) > near) return false;
  return true;
}

// Of the cells that lie wholly within the region.
function shareOf({ x, y, width, height }: Region, differs: ReadonlySet<number>, columns: number): number {
  let [all, unlike] = [0, 0];
  for (let row = Math.ceil(y / cell); row < Math.floor((y + height) / cell); row++)
    for (let column = Math.ceil(x / cell); column < Math.floor((x + width) / cell); column++) {
      all += 1;
      if (differs.has(row * columns + column)) unlike += 1;
    }
  return unlike / all;
}

function marked({ picture, scale }: Scaled, differs: ReadonlySet<number>, columns: number): Picture {
  const { width, height, channels } = picture;
  const size = cell * scale;
  const bytes = new Uint8Array(width * height * 3);
  for (let y = 0; y < height; y++)
    for (let x = 0; x < width; x++) {
      const red = differs.has(Math.floor(y / size) * columns + Math.floor(x / size));
      for (let k = 0; k < 3; k++) {
        const seen = picture.bytes[(y * width + x) * channels + k] ?? 0;
        bytes[(y * width + x) * 3 + k] = red ? (k === 0 ? 220 : seen / 2) : 128 + seen / 2;
      }
    }
  return { width, height, channels: 3, bytes };
}
