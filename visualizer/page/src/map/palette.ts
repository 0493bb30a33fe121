// The colours of drawings: read from the CSS custom properties of the theme, once per theme.

export interface Palette {
  readonly background: string;
  readonly panel: string; // around the plots
  readonly grid: string;
  readonly axis: string;
  readonly terrain: string;
  readonly text: string;
  readonly soft: string; // text of less weight
  readonly line: string;
  readonly risk: string;
  readonly riskFill: string;
  readonly overlap: string;
  readonly overlapFill: string;
  readonly comfort: string;
  readonly comfortFill: string;
  readonly anchor: string;
  readonly range: string;
  readonly allowed: string;
  readonly forbidden: string;
  readonly route: string;
  readonly recovery: string;
  readonly accent: string;
  readonly bad: string;
  readonly onBad: string;
  readonly warn: string;
  readonly tileOpacity: string; // of map tiles, 0 to 1
  readonly font: string;
  readonly mono: string;
}

const PROPERTIES: Readonly<Record<keyof Palette, string>> = {
  background: '--map-bg',
  panel: '--bg',
  grid: '--map-grid',
  axis: '--map-axis',
  terrain: '--map-terrain',
  text: '--map-text',
  soft: '--text-soft',
  line: '--line',
  risk: '--map-risk',
  riskFill: '--map-risk-fill',
  overlap: '--map-overlap',
  overlapFill: '--map-overlap-fill',
  comfort: '--map-comfort',
  comfortFill: '--map-comfort-fill',
  anchor: '--map-anchor',
  range: '--map-range',
  allowed: '--map-allowed',
  forbidden: '--map-forbidden',
  route: '--map-route',
  recovery: '--map-recovery',
  accent: '--accent',
  bad: '--bad',
  onBad: '--on-bad',
  warn: '--warn',
  tileOpacity: '--map-tile-opacity',
  font: '--font',
  mono: '--mono',
};

// `read` gives the value of a custom property: of getComputedStyle, or of a test.
export function readPalette(read: (property: string) => string): Palette {
  const palette: Partial<Record<keyof Palette, string>> = {};
  for (const [name, property] of Object.entries(PROPERTIES) as [keyof Palette, string][]) {
    palette[name] = read(property).trim();
  }
  return palette as Palette;
}

// Colours that tell objects apart, also for colour-blind eyes, on light and dark ground; an object
// has the same on the map and in the curves.
export const OBJECT_COLORS: readonly string[] = [
  '#0a7cc2',
  '#d2601a',
  '#0f9d76',
  '#c2699c',
  '#c99212',
  '#7a6fd0',
];

export function objectColor(id: number): string {
  const count = OBJECT_COLORS.length;
  return OBJECT_COLORS[((id % count) + count) % count] ?? '#0a7cc2';
}

// Ground of a fault's letter and bar; dark letters on all of them.
export const FAULT_COLORS: Readonly<Record<string, string>> = {
  P: '#e8782a',
  A: '#57aee0',
  G: '#a49be8',
  R: '#e6a51b',
  N: '#4cb88f',
  C: '#dd8fba',
  T: '#b3b8c2',
  Y: '#c7bf35',
  W: '#d79a7a',
  F: '#b7a58e',
};
export const ON_FAULT = '#14181f';
