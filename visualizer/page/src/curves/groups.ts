// The groups of curves that can be chosen, and the curves of each.

import type { Quantity } from './quantity';

export interface Kind {
  readonly quantity: Quantity;
  readonly name: string;
  readonly right: boolean; // on the right axis
  readonly dash: readonly number[];
  readonly width: number; // CSS pixels
}

export interface Group {
  readonly id: string;
  readonly name: string;
  readonly leftUnit: string;
  readonly rightUnit: string; // '' without a right axis
  readonly fromZero: boolean;
  readonly kinds: readonly Kind[];
}

export const GROUPS: readonly Group[] = [
  {
    id: 'errors',
    name: 'Errors',
    leftUnit: 'position error (m)',
    rightUnit: 'velocity error (m/s)',
    fromZero: true,
    kinds: [
      { quantity: 'positionError', name: 'position error', right: false, dash: [], width: 2 },
      { quantity: 'velocityError', name: 'velocity error', right: true, dash: [4, 3], width: 1.25 },
    ],
  },
  {
    id: 'place',
    name: 'x and y',
    leftUnit: 'm',
    rightUnit: '',
    fromZero: false,
    kinds: [
      { quantity: 'x', name: 'x', right: false, dash: [], width: 2 },
      { quantity: 'xEst', name: 'x perceived', right: false, dash: [5, 4], width: 1.5 },
      { quantity: 'y', name: 'y', right: false, dash: [1, 3], width: 2 },
      { quantity: 'yEst', name: 'y perceived', right: false, dash: [8, 3, 2, 3], width: 1.25 },
    ],
  },
  {
    id: 'near',
    name: 'Distances',
    leftUnit: 'm',
    rightUnit: '',
    fromZero: true,
    kinds: [
      { quantity: 'nearest', name: 'nearest distance', right: false, dash: [], width: 2 },
      { quantity: 'comfort', name: 'comfort radius', right: false, dash: [5, 4], width: 1.5 },
    ],
  },
];

export interface Curve {
  readonly object: number;
  readonly kind: Kind;
}

// The curves of a group, those of the observer first.
export function curvesOf(group: Group, objects: readonly number[]): Curve[] {
  return objects.flatMap((object) => group.kinds.map((kind) => ({ object, kind })));
}
