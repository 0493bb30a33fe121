// Where a copter can be added: away from the others and from the lines of terrain. No DOM.

import { ObjectKind, type VizObject, type World } from '../../../codec/messages';

// Metres between centres: two copters hovering so do not avoid each other.
const APART_M = 2.6;
const OFF_LINES_M = 1.3;
const STEP_M = 0.5;
const FARTHEST_STEPS = 200;

// The nearest free place to the origin on a grid of half metres, [x, y] in m.
export function freePlace(objects: readonly VizObject[], world: World | null): [number, number] {
  const copters = objects.filter(({ kind }) => kind === ObjectKind.copter);
  const isFree = (x: number, y: number): boolean =>
    copters.every(({ pos }) => Math.hypot(pos[0] - x, pos[1] - y) >= APART_M) &&
    (world?.seg ?? []).every((line) => distance(line, x, y) >= OFF_LINES_M);
  for (let ring = 0; ring <= FARTHEST_STEPS; ring++) {
    for (const [x, y] of square(ring)) {
      if (isFree(x * STEP_M, y * STEP_M)) return [x * STEP_M, y * STEP_M];
    }
  }
  return [0, 0];
}

// The grid's places on the edge of a square around the origin, those near its axes first.
function square(ring: number): [number, number][] {
  if (ring === 0) return [[0, 0]];
  const places: [number, number][] = [];
  for (let along = 0; along <= ring; along++) {
    for (const side of along === 0 || along === ring ? [along] : [along, -along]) {
      places.push([ring, side], [-side, ring], [-ring, -side], [side, -ring]);
    }
  }
  return places;
}

function distance([x1, y1, x2, y2]: World['seg'][number], x: number, y: number): number {
  const [dx, dy] = [x2 - x1, y2 - y1];
  const length2 = dx * dx + dy * dy;
  const part = length2 === 0 ? 0 : ((x - x1) * dx + (y - y1) * dy) / length2;
  const near = Math.min(1, Math.max(0, part));
  return Math.hypot(x1 + near * dx - x, y1 + near * dy - y);
}
