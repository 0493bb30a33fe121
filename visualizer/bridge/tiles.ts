// Map tiles on disk: DIR/Z/X/Y.png (or jpg, jpeg, webp), which DIR/tiles.json describes (codec/tile_set.ts).

import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { parseTileSet, type TileSet } from '../codec/tile_set';
import { type OpenedFile, openInside } from './inside';
import { UsageError } from './options';

export interface TileFolder {
  folder: string;
  set: TileSet;
  extension: string; // of the files, of TileJSON's neighbour MBTiles called "format"
  fromSouth: boolean; // TileJSON's "scheme" is "tms": files are numbered from the south
}

export interface OpenedTile extends OpenedFile {
  type: string; // of its content
}

const types = new Map([
  ['png', 'image/png'],
  ['jpg', 'image/jpeg'],
  ['jpeg', 'image/jpeg'],
  ['webp', 'image/webp'],
]);

// A page holds some hundred of them as pictures.
export const largestTile = 4 * 1024 * 1024;

// What tiles.json of the folder says. Throws UsageError.
export function readTileFolder(folder: string): TileFolder {
  const name = join(folder, 'tiles.json');
  const wrong = (line: string): UsageError => new UsageError(`--tiles: ${name}: ${line}`);
  const value = parsedJson(name, wrong);
  const set = parseTileSet(value);
  if (typeof set === 'string') throw wrong(set);
  const { format = 'png', scheme = 'xyz' } = value as Record<string, unknown>;
  if (typeof format !== 'string' || !types.has(format))
    throw wrong(`format: expected ${[...types.keys()].join(', ')}, got ${JSON.stringify(format)}`);
  if (scheme !== 'xyz' && scheme !== 'tms')
    throw wrong(`scheme: expected xyz or tms, got ${JSON.stringify(scheme)}`);
  return { folder, set, extension: format, fromSouth: scheme === 'tms' };
}

function parsedJson(name: string, wrong: (line: string) => UsageError): unknown {
  let text: string;
  try {
    text = readFileSync(name, 'utf8');
  } catch (error) {
    throw wrong(
      `cannot be read (${(error as NodeJS.ErrnoException).code}); expected a description of the tiles`,
    );
  }
  try {
    return JSON.parse(text);
  } catch {
    throw wrong('expected a JSON object, got no JSON');
  }
}

// The tile opened for reading. 'missing': a place that the folder has no tile of. 'refused': a number that no tile has,
// or what openInside refuses, or a file that is too large.
export async function openTile(
  { folder, set, extension, fromSouth }: TileFolder,
  z: number,
  x: number,
  y: number,
): Promise<OpenedTile | 'missing' | 'refused'> {
  const across = 2 ** z;
  if (z < set.minzoom || z > set.maxzoom || x >= across || y >= across) return 'refused';
  const row = fromSouth ? across - 1 - y : y;
  const opened = await openInside(folder, join(String(z), String(x), `${row}.${extension}`));
  if (typeof opened === 'string') return opened;
  if (opened.size <= largestTile) return { ...opened, type: types.get(extension) ?? '' };
  await opened.file.close();
  return 'refused';
}
