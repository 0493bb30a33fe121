// What the map shows when it fits everything: terrain, polygons, anchors and all objects.

import type { World } from '../../../codec/messages';
import { Col, type PackedFrame, STRIDE } from '../model/packed_frame';
import { type Bounds, boundsOf } from './view';

export function worldBounds(world: World | null, frame: PackedFrame | null): Bounds | null {
  return boundsOf(points(world, frame));
}

function* points(world: World | null, frame: PackedFrame | null): Generator<readonly [number, number]> {
  for (const [x1, y1, x2, y2] of world?.seg ?? []) {
    yield [x1, y1];
    yield [x2, y2];
  }
  for (const poly of world?.polys ?? []) {
    for (const point of poly.pt) yield [point[0], point[1]];
  }
  for (const anchor of world?.anchors ?? []) yield [anchor.pos[0], anchor.pos[1]];
  const data = frame?.data ?? new Float32Array();
  for (let at = 0; at < data.length; at += STRIDE) yield [data[at + Col.x] ?? NaN, data[at + Col.y] ?? NaN];
}
