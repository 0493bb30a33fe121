import { describe, expect, test } from 'vitest';
import { deepestZoom, mercatorEdge, parseTileSet } from './tile_set';

const good = { origin: [11.97, 57.69], minzoom: 14, maxzoom: 19, attribution: '© somebody' };

describe('what a page needs of tiles.json', () => {
  test('is read, and nothing else of it', () => {
    expect(parseTileSet({ tilejson: '3.0.0', bounds: 'anything', ...good })).toEqual(good);
  });

  test('an attribution may be missing', () => {
    const { attribution: _, ...rest } = good;
    expect(parseTileSet(rest)).toEqual({ ...good, attribution: '' });
  });

  test.each([
    { origin: [-180, -mercatorEdge] },
    { origin: [180, mercatorEdge] },
    { minzoom: 0 },
    { minzoom: 19 },
    { maxzoom: deepestZoom },
    { attribution: 'x'.repeat(200) },
  ])('may be at its limit: %j', (change) => {
    expect(parseTileSet({ ...good, ...change })).toMatchObject(change);
  });

  test.each([
    ['origin', undefined, /^origin: expected \[longitude, latitude\] in degrees, .*, got none$/],
    ['origin', [11.97], /^origin: .*, got \[11.97\]$/],
    ['origin', ['11.97', '57.69'], /^origin: .*, got \["11.97","57.69"\]$/],
    ['origin', [11.97, 57.69, 0], /^origin: /],
    ['origin', [180.1, 0], /^origin: /],
    ['origin', [0, 85.06], /^origin: /],
    ['origin', [0, null], /^origin: /],
    ['minzoom', undefined, 'minzoom: expected a whole number from 0 to 30, got none'],
    ['minzoom', -1, 'minzoom: expected a whole number from 0 to 30, got -1'],
    ['minzoom', 1.5, 'minzoom: expected a whole number from 0 to 30, got 1.5'],
    ['minzoom', '14', 'minzoom: expected a whole number from 0 to 30, got "14"'],
    ['maxzoom', undefined, 'maxzoom: expected a whole number from 14 (minzoom) to 30, got none'],
    ['maxzoom', 13, 'maxzoom: expected a whole number from 14 (minzoom) to 30, got 13'],
    ['maxzoom', 31, 'maxzoom: expected a whole number from 14 (minzoom) to 30, got 31'],
    ['attribution', 7, 'attribution: expected one line of at most 200 characters, got 7'],
    [
      'attribution',
      'two\nlines',
      'attribution: expected one line of at most 200 characters, got "two\\nlines"',
    ],
    [
      'attribution',
      'x'.repeat(201),
      /^attribution: expected one line of at most 200 characters, got "x{59}$/,
    ],
  ])('%s: %j is refused in one line', (member, value, line) => {
    const told = parseTileSet({ ...good, [member]: value });
    expect(told).toMatch(line);
    expect(told).not.toMatch(/\n/);
  });

  test.each([null, [], 'text', 1, undefined])('%j is none at all', (value) => {
    expect(parseTileSet(value)).toBe('expected a JSON object');
  });
});
