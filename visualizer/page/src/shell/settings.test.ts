import { expect, test } from 'vitest';
import { createSettings, defaultSettings, type Memory, readSettings } from './settings';

function memory(): Memory & { text: string | null } {
  return {
    text: null,
    getItem() {
      return this.text;
    },
    setItem(_key, value) {
      this.text = value;
    },
  };
}

test('what was chosen is there at the next start', () => {
  const kept = memory();
  const first = createSettings(kept);
  first.update({ theme: 'dark', length: 'mm', angle: 'rad', trail: 'all', speed: 0.25 });
  first.toggleLayer('ranges');
  first.toggleLayer('grid');
  const second = createSettings(kept).value;
  expect(second).toEqual({
    theme: 'dark',
    length: 'mm',
    angle: 'rad',
    trail: 'all',
    speed: 0.25,
    layers: { ...defaultSettings.layers, ranges: true, grid: false },
  });
});

test('listeners hear of changes until they stop', () => {
  const settings = createSettings(memory());
  const heard: string[] = [];
  const stop = settings.listen(({ theme }) => heard.push(theme));
  settings.update({ theme: 'dark' });
  stop();
  settings.update({ theme: 'light' });
  expect(heard).toEqual(['dark']);
});

test.each([null, '', '[1]', '"x"', '{', '{"theme":"pink","layers":7,"speed":1000,"trail":3,"length":"ft"}'])(
  'what is stored as %j becomes the defaults',
  (text) => {
    expect(readSettings(text)).toEqual(defaultSettings);
  },
);

test('of a partly readable text the readable part counts', () => {
  const { theme, layers, speed } = readSettings(
    '{"theme":"dark","layers":{"labels":false,"grid":1},"speed":"fast"}',
  );
  expect({ theme, labels: layers.labels, grid: layers.grid, speed }).toEqual({
    theme: 'dark',
    labels: false,
    grid: true,
    speed: 1,
  });
});

test('a storage that refuses lets the page go on', () => {
  const refuse = (): never => {
    throw new DOMException('denied', 'SecurityError');
  };
  const settings = createSettings({ getItem: refuse, setItem: refuse });
  settings.update({ theme: 'dark' });
  expect(settings.value.theme).toBe('dark');
});
