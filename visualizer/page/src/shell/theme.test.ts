// The contrast of theme.css, by the formula of WCAG 2.2 (relative luminance, contrast ratio).
import { readFileSync } from 'node:fs';
import { describe, expect, test } from 'vitest';
import { themeOf } from './theme';

const css = readFileSync(new URL('./theme.css', import.meta.url), 'utf8');

function blockOf(theme: 'light' | 'dark'): string {
  return new RegExp(`:root\\[data-theme="${theme}"\\]\\s*\\{([^}]*)\\}`).exec(css)?.[1] ?? '';
}

function colours(theme: 'light' | 'dark'): Map<string, string> {
  return new Map(
    [...blockOf(theme).matchAll(/--([a-z-]+):\s*(#[0-9a-f]{6});/g)].map(([, name, value]) => [
      name ?? '',
      value ?? '',
    ]),
  );
}

function luminance(colour: string): number {
  const channel = (at: number): number => {
    const value = Number.parseInt(colour.slice(at, at + 2), 16) / 255;
    return value <= 0.04045 ? value / 12.92 : ((value + 0.055) / 1.055) ** 2.4;
  };
  return 0.2126 * channel(1) + 0.7152 * channel(3) + 0.0722 * channel(5);
}

function contrast(one: string, other: string): number {
  const [low = 0, high = 0] = [luminance(one), luminance(other)].sort((a, b) => a - b);
  return (high + 0.05) / (low + 0.05);
}

// Every pair in which the style sheets set text on a background.
const texts: readonly (readonly [text: string, background: string])[] = [
  ...['text', 'text-soft', 'accent', 'bad', 'good', 'warn'].flatMap((text) =>
    ['bg', 'bg-soft', 'bg-selected'].map((background) => [text, background] as const),
  ),
  ['on-accent', 'accent'],
  ['on-bad', 'bad'],
  ['bad', 'bad-bg'],
  ['warn', 'warn-bg'],
  ['map-text', 'map-bg'],
];

// Borders of controls, focus and lines that carry meaning: 3:1 is asked of them.
const lines: readonly (readonly [line: string, background: string])[] = [
  ['control-line', 'bg'],
  ['focus', 'bg'],
  ['focus', 'bg-selected'],
  ['map-terrain', 'map-bg'],
  ['map-risk', 'map-bg'],
  ['map-overlap', 'map-bg'],
  ['map-comfort', 'map-bg'],
  ['map-anchor', 'map-bg'],
];

describe.each(['light', 'dark'] as const)('in the %s theme', (theme) => {
  const known = colours(theme);
  const of = (name: string): string => {
    const colour = known.get(name);
    if (colour === undefined) throw new Error(`theme.css has no --${name} of the form #rrggbb for ${theme}`);
    return colour;
  };
  test.each(texts)('text in %s on %s has a contrast of at least 4.5', (text, background) => {
    expect(contrast(of(text), of(background))).toBeGreaterThanOrEqual(4.5);
  });
  test.each(lines)('%s on %s has a contrast of at least 3', (line, background) => {
    expect(contrast(of(line), of(background))).toBeGreaterThanOrEqual(3);
  });
});

// The worst that can be there: black tiles below dark text, white ones below bright text.
test.each([
  ['light', 0],
  ['dark', 255],
] as const)('in the %s theme text of the map can be read on map tiles of any colour', (theme, tile) => {
  const known = colours(theme);
  const opacity = Number(/--map-tile-opacity: ([\d.]+);/.exec(blockOf(theme))?.[1]);
  const ground = known.get('map-bg') ?? '';
  const mixed = [1, 3, 5].map((at) => {
    const under = Number.parseInt(ground.slice(at, at + 2), 16);
    return Math.round(under + (tile - under) * opacity)
      .toString(16)
      .padStart(2, '0');
  });
  expect(contrast(known.get('map-text') ?? '', `#${mixed.join('')}`)).toBeGreaterThanOrEqual(4.5);
});

// From the definition: black on white is 21, and #777777 on white is known to just miss 4.5.
test('the formula gives the known contrasts', () => {
  expect(contrast('#000000', '#ffffff')).toBeCloseTo(21, 5);
  expect(contrast('#777777', '#ffffff')).toBeCloseTo(4.48, 2);
});

test('without a choice the system decides', () => {
  expect([themeOf('auto', true), themeOf('auto', false)]).toEqual(['dark', 'light']);
  expect([themeOf('light', true), themeOf('dark', false)]).toEqual(['light', 'dark']);
});
