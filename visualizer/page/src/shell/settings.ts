// What the user has chosen, kept in localStorage: theme, units, layers, trails, speed. No DOM.

// The first nine have the keys 1 to 9.
export const layerNames = [
  'grid',
  'terrain',
  'risk',
  'comfort',
  'trails',
  'perceived',
  'anchors',
  'ranges',
  'labels',
  'tiles',
] as const;
export type LayerName = (typeof layerNames)[number];

export interface Settings {
  theme: 'auto' | 'light' | 'dark';
  length: 'm' | 'mm';
  angle: 'deg' | 'rad';
  layers: Readonly<Record<LayerName, boolean>>;
  trail: Trail;
  speed: number; // simulated seconds per second, 0.05 to 20
}

// How far back trails reach, in simulated seconds.
export type Trail = 0 | 2 | 10 | 'all';
export const trailLengths: readonly Trail[] = [0, 2, 10, 'all'];
export const speeds: readonly number[] = [0.05, 0.1, 0.25, 0.5, 1, 2, 5, 10, 20];

export const defaultSettings: Settings = {
  theme: 'auto',
  length: 'm',
  angle: 'deg',
  layers: {
    grid: true,
    terrain: true,
    risk: true,
    comfort: true,
    trails: true,
    perceived: true,
    anchors: true,
    ranges: false,
    labels: true,
    tiles: true, // where the bridge has any
  },
  trail: 2,
  speed: 1,
};

export interface SettingsStore {
  readonly value: Settings;
  update(change: Partial<Settings>): void;
  toggleLayer(name: LayerName): void;
  // Called after each change. Answers how to stop listening.
  listen(listener: (value: Settings) => void): () => void;
}

// The part of Storage that is used; localStorage of a page from a file may be missing or full.
export type Memory = Pick<Storage, 'getItem' | 'setItem'>;

const key = 'faultcheck.visualizer';

export function createSettings(memory: Memory | null): SettingsStore {
  let value = readSettings(stored(memory));
  const listeners = new Set<(value: Settings) => void>();
  const update = (change: Partial<Settings>): void => {
    value = { ...value, ...change };
    store(memory, value);
    for (const listener of listeners) listener(value);
  };
  return {
    get value() {
      return value;
    },
    update,
    toggleLayer: (name) => update({ layers: { ...value.layers, [name]: !value.layers[name] } }),
    listen: (listener) => {
      listeners.add(listener);
      return () => void listeners.delete(listener);
    },
  };
}

// What is not understood (an older version, an edit by hand) becomes the default, key by key.
export function readSettings(text: string | null): Settings {
  const given = parsed(text);
  const layers = { ...defaultSettings.layers };
  const givenLayers = isObject(given.layers) ? given.layers : {};
  for (const name of layerNames) {
    const shown = givenLayers[name];
    if (typeof shown === 'boolean') layers[name] = shown;
  }
  const speed = given.speed;
  return {
    theme: oneOf(given.theme, ['auto', 'light', 'dark'], defaultSettings.theme),
    length: oneOf(given.length, ['m', 'mm'], defaultSettings.length),
    angle: oneOf(given.angle, ['deg', 'rad'], defaultSettings.angle),
    layers,
    trail: oneOf(given.trail, trailLengths, defaultSettings.trail),
    speed: typeof speed === 'number' && speed >= 0.05 && speed <= 20 ? speed : defaultSettings.speed,
  };
}

function parsed(text: string | null): Record<string, unknown> {
  try {
    const value: unknown = JSON.parse(text ?? '{}');
    return isObject(value) ? value : {};
  } catch {
    return {};
  }
}

function isObject(value: unknown): value is Record<string, unknown> {
  return typeof value === 'object' && value !== null && !Array.isArray(value);
}

function oneOf<T>(value: unknown, allowed: readonly T[], otherwise: T): T {
  return allowed.find((a) => a === value) ?? otherwise;
}

function stored(memory: Memory | null): string | null {
  try {
    return memory?.getItem(key) ?? null;
  } catch {
    return null;
  }
}

// Settings that cannot be stored last as long as the page.
function store(memory: Memory | null, value: Settings): void {
  try {
    memory?.setItem(key, JSON.stringify(value));
  } catch {
    // a full or forbidden storage: nothing to be done, nothing lost but the next start's comfort
  }
}
