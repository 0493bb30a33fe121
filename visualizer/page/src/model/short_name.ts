// What an object is called on the map and in lists: Q3 for copter 3, C1 for a car, O9 for others.

const LETTERS = ['Q', 'C', 'O'] as const;

export function shortNameOf(id: number, kind: number): string {
  return `${LETTERS[kind] ?? 'O'}${id}`;
}
