// Which key does what. No DOM: a key event is passed in as what matters of it.

import { layerNames } from './settings';

export type Action =
  | { do: 'playPause' | 'start' | 'end' | 'slower' | 'faster' | 'loop' | 'follow' | 'fit' | 'measure' }
  | { do: 'dark' | 'picture' | 'report' | 'help' | 'clear' }
  | { do: 'frames' | 'event' | 'zoom' | 'object'; by: 1 | -1 }
  | { do: 'seconds'; by: number }
  | { do: 'layer'; index: number }
  | { do: 'steer'; key: SteerKey };

export type SteerKey = 'w' | 'a' | 's' | 'd' | 'q' | 'e';
export const steerKeys: readonly SteerKey[] = ['w', 'a', 's', 'd', 'q', 'e'];

export interface KeyPress {
  key: string; // as in KeyboardEvent
  shift: boolean;
  command: boolean; // ctrl, alt or meta is down: not for us
  focus: Focus;
  byPointer: boolean; // the focus came from a click: Space is not for what was clicked last
  steering: boolean; // live with control, and the map or the pad has the focus
}

// What the focused element does with keys itself.
export type Focus = 'none' | 'text' | 'select' | 'button' | 'arrows';

export function actionOf(press: KeyPress): Action | null {
  if (press.key === 'Escape') return { do: 'clear' };
  if (press.command) return null;
  if (press.key === ' ' && press.byPointer && press.focus !== 'text') return { do: 'playPause' };
  if (press.focus === 'text' || press.focus === 'select') return null;
  const key = press.key.length === 1 ? press.key.toLowerCase() : press.key;
  if (press.steering && isSteerKey(key)) return { do: 'steer', key };
  if (press.focus === 'button' && (key === ' ' || key === 'Enter')) return null;
  if (press.focus === 'arrows' && (key.startsWith('Arrow') || key === 'Home' || key === 'End' || key === ' '))
    return null;
  if (/^[1-9]$/.test(key)) return { do: 'layer', index: Number(key) - 1 };
  if (key === 'n') return { do: 'object', by: press.shift ? -1 : 1 };
  if (key === 'ArrowLeft') return { do: 'seconds', by: press.shift ? -1 : -0.1 };
  if (key === 'ArrowRight') return { do: 'seconds', by: press.shift ? 1 : 0.1 };
  return plain.get(key) ?? null;
}

export function isSteerKey(key: string): key is SteerKey {
  return steerKeys.some((one) => one === key);
}

const plain: ReadonlyMap<string, Action> = new Map<string, Action>([
  [' ', { do: 'playPause' }],
  [',', { do: 'frames', by: -1 }],
  ['.', { do: 'frames', by: 1 }],
  ['Home', { do: 'start' }],
  ['End', { do: 'end' }],
  ['[', { do: 'event', by: -1 }],
  [']', { do: 'event', by: 1 }],
  ['-', { do: 'zoom', by: -1 }],
  ['=', { do: 'zoom', by: 1 }],
  ['+', { do: 'zoom', by: 1 }],
  [';', { do: 'slower' }],
  ["'", { do: 'faster' }],
  ['l', { do: 'loop' }],
  ['c', { do: 'follow' }],
  ['f', { do: 'fit' }],
  ['m', { do: 'measure' }],
  ['d', { do: 'dark' }],
  ['p', { do: 'picture' }],
  ['r', { do: 'report' }],
  ['?', { do: 'help' }],
]);

// The list that `?' shows.
export const keyList: readonly (readonly [keys: string, what: string])[] = [
  ['Space', 'play, pause'],
  [',  .', 'one frame back, on'],
  ['←  →', '0.1 s back, on; with Shift 1 s'],
  ['Home  End', 'to the start, to the end'],
  ['[  ]', 'previous, next event'],
  [";  '", 'slower, faster'],
  ['L', 'loop the selection on the timeline, or all'],
  ['N  Shift+N', 'next, previous object'],
  ['C', 'the map follows the observer'],
  ['F', 'fit everything into the map'],
  ['-  =', 'zoom out, in'],
  ['M', 'measure; also Shift and drag'],
  ['1 … 9', `layers: ${layerNames.slice(0, 9).join(', ')}`],
  ['D', 'dark or light'],
  ['P', 'save the map as PNG'],
  ['R', 'save a report: one HTML file with the page and what it holds'],
  ['W A S D  Q E', 'steer and turn the observer (live with control, map focused)'],
  ['Esc', 'release the controls, clear the measurement, close'],
  ['?', 'this list'],
];

// The neighbouring entry of a list of speeds.
export function nextSpeed(speeds: readonly number[], now: number, direction: 1 | -1): number {
  const beyond = direction > 0 ? speeds.filter((s) => s > now) : speeds.filter((s) => s < now).reverse();
  return beyond[0] ?? now;
}
