import { describe, expect, test } from 'vitest';
import { type Action, actionOf, type KeyPress, nextSpeed } from './keys';
import { speeds } from './settings';

const press = (key: string, change: Partial<KeyPress> = {}): Action | null =>
  actionOf({
    key,
    shift: false,
    command: false,
    focus: 'none',
    byPointer: false,
    steering: false,
    ...change,
  });

describe('keys', () => {
  // Section "Keys" of the reference, key by key.
  test.each<[string, boolean, Action]>([
    [' ', false, { do: 'playPause' }],
    [',', false, { do: 'frames', by: -1 }],
    ['.', false, { do: 'frames', by: 1 }],
    ['ArrowLeft', false, { do: 'seconds', by: -0.1 }],
    ['ArrowRight', false, { do: 'seconds', by: 0.1 }],
    ['ArrowLeft', true, { do: 'seconds', by: -1 }],
    ['ArrowRight', true, { do: 'seconds', by: 1 }],
    ['Home', false, { do: 'start' }],
    ['End', false, { do: 'end' }],
    ['[', false, { do: 'event', by: -1 }],
    [']', false, { do: 'event', by: 1 }],
    ['-', false, { do: 'zoom', by: -1 }],
    ['=', false, { do: 'zoom', by: 1 }],
    [';', false, { do: 'slower' }],
    ["'", false, { do: 'faster' }],
    ['L', true, { do: 'loop' }],
    ['n', false, { do: 'object', by: 1 }],
    ['N', true, { do: 'object', by: -1 }],
    ['c', false, { do: 'follow' }],
    ['f', false, { do: 'fit' }],
    ['m', false, { do: 'measure' }],
    ['1', false, { do: 'layer', index: 0 }],
    ['9', false, { do: 'layer', index: 8 }],
    ['d', false, { do: 'dark' }],
    ['p', false, { do: 'picture' }],
    ['r', false, { do: 'report' }],
    ['?', true, { do: 'help' }],
    ['Escape', false, { do: 'clear' }],
  ])('%j does its deed', (key, shift, action) => {
    expect(press(key, { shift })).toEqual(action);
  });

  test('while typing only Escape counts', () => {
    for (const key of [' ', 'r', 'd', '1', 'w', 'ArrowLeft']) {
      expect(press(key, { focus: 'text', steering: true, byPointer: true })).toBeNull();
    }
    expect(press('Escape', { focus: 'text' })).toEqual({ do: 'clear' });
  });

  test("the browser's own shortcuts are left alone", () => {
    for (const key of ['r', 'p', 'd', 'f', 'w', '1']) expect(press(key, { command: true })).toBeNull();
  });

  test('a focused button keeps space and Enter, a slider its arrows', () => {
    expect(press(' ', { focus: 'button' })).toBeNull();
    expect(press('Enter', { focus: 'button' })).toBeNull();
    expect(press('r', { focus: 'button' })).toEqual({ do: 'report' });
    for (const key of ['ArrowLeft', 'Home', 'End']) expect(press(key, { focus: 'arrows' })).toBeNull();
  });

  test('Space after a click plays and pauses, whatever was clicked', () => {
    for (const focus of ['none', 'button', 'select', 'arrows'] as const) {
      expect(press(' ', { focus, byPointer: true })).toEqual({ do: 'playPause' });
    }
    for (const focus of ['button', 'select', 'arrows'] as const) expect(press(' ', { focus })).toBeNull();
    expect(press('Enter', { focus: 'button', byPointer: true })).toBeNull();
    expect(press('r', { focus: 'select', byPointer: true })).toBeNull();
  });

  test('D steers when steering is on, and is dark otherwise', () => {
    expect(press('d', { steering: true })).toEqual({ do: 'steer', key: 'd' });
    expect(press('D', { steering: true })).toEqual({ do: 'steer', key: 'd' });
    expect(press('d')).toEqual({ do: 'dark' });
    for (const key of ['w', 'a', 's', 'q', 'e']) expect(press(key)).toBeNull();
  });

  test('other keys do nothing', () => {
    for (const key of ['0', 'z', 'Tab', 'F5', 'Shift']) expect(press(key)).toBeNull();
  });
});

test('slower and faster go along the list and stop at its ends', () => {
  expect(nextSpeed(speeds, 1, 1)).toBe(2);
  expect(nextSpeed(speeds, 1, -1)).toBe(0.5);
  expect(nextSpeed(speeds, 1.5, 1)).toBe(2);
  expect(nextSpeed(speeds, 1.5, -1)).toBe(1);
  expect(nextSpeed(speeds, 20, 1)).toBe(20);
  expect(nextSpeed(speeds, 0.05, -1)).toBe(0.05);
});
