// The rows of the table of objects: the same data as on the map. No DOM.

import { type Fault, ObjectFlag, type VizObject } from '../../../codec/messages';
import { activeAt, faultLetter } from '../model/faults';
import { distance, lengthCell, shortName, type Units } from './format';

export const columns = ['name', 'x', 'y', 'v', 'error', 'state'] as const;
export type Column = (typeof columns)[number];

export interface Order {
  column: Column;
  descending: boolean;
}

export interface Row {
  id: number;
  cells: Readonly<Record<Column, string>>;
  keys: Readonly<Record<Column, number>>; // to sort by
}

export function rowsOf(
  objects: readonly VizObject[],
  faults: readonly Fault[],
  tUs: number,
  units: Units,
  order: Order,
): Row[] {
  const active = faults.filter((fault) => activeAt(fault, tUs));
  const rows = objects.map((object) => rowOf(object, active, units));
  const sign = order.descending ? -1 : 1;
  return rows.sort((a, b) => sign * (a.keys[order.column] - b.keys[order.column]) || a.id - b.id);
}

function rowOf(object: VizObject, active: readonly Fault[], units: Units): Row {
  const speed = Math.hypot(...object.vel);
  const error = distance(object.pos, object.posEst);
  const letters = [...new Set(active.filter((f) => f.object === object.id).map((f) => faultLetter(f)))];
  const state = stateText(object.flags, letters);
  return {
    id: object.id,
    cells: {
      name: shortName(object),
      x: lengthCell(object.pos[0], units, 2),
      y: lengthCell(object.pos[1], units, 2),
      v: lengthCell(speed, units, 2),
      error: lengthCell(error, units, 2),
      state,
    },
    keys: { name: object.id, x: object.pos[0], y: object.pos[1], v: speed, error, state: object.flags },
  };
}

// The worst first; letters of faults last.
export function stateText(flags: number, letters: readonly string[]): string {
  const words: string[] = [];
  if (flags & ObjectFlag.collided) words.push('✖ hit');
  if (flags & ObjectFlag.avoiding) words.push('avoids');
  if (flags & ObjectFlag.manual) words.push('manual');
  if (flags & ObjectFlag.stale) words.push('stale');
  if (letters.length > 0) words.push(letters.join(''));
  else if (flags & ObjectFlag.faulted) words.push('fault');
  return words.join(' ');
}
