// Frames in little memory: one array of 32-bit floats a frame, 76 bytes an object instead of some
// 500 as JavaScript objects, so that ten minutes of 40 objects stay far below the page's 400 MiB.
// The map and the curves read the columns directly, which allocates nothing.

import type { Frame, VizObject } from '../../../codec/messages';

// Where a value of an object lies in its row. SI units, radians, x east, y north, z up.
export const Col = {
  flags: 0,
  x: 1,
  y: 2,
  z: 3,
  vx: 4,
  vy: 5,
  vz: 6,
  yaw: 7,
  roll: 8,
  pitch: 9,
  xEst: 10,
  yEst: 11,
  zEst: 12,
  vxEst: 13,
  vyEst: 14,
  vzEst: 15,
  comfort: 16,
  steer0: 17,
  steer1: 18,
} as const;

export const STRIDE = 19;

// Which objects a frame has. Frames with the same objects share one.
export interface Layout {
  readonly ids: Int32Array;
  readonly kinds: Int8Array;
  readonly rowOf: ReadonlyMap<number, number>; // id to row
}

export interface PackedFrame {
  readonly tUs: number;
  readonly run: number;
  readonly seq: number;
  readonly layout: Layout;
  readonly data: Float32Array; // STRIDE values an object
  readonly bytes: number; // estimated, for the buffer's limit
}

// What a frame costs besides its rows: the array object, its buffer and the record.
const OVERHEAD_BYTES = 200;

// Packs a frame; `previous` is the layout to share when the objects are the same.
export function packFrame(frame: Frame, previous: Layout | null): PackedFrame {
  const objects = frame.objects;
  const layout = previous !== null && fits(previous, objects) ? previous : layoutOf(objects);
  const data = new Float32Array(objects.length * STRIDE);
  for (let row = 0; row < objects.length; row++) {
    packObject(data, row * STRIDE, objects[row] as VizObject);
  }
  const bytes = data.byteLength + OVERHEAD_BYTES;
  return { tUs: frame.tUs, run: frame.run, seq: frame.seq, layout, data, bytes };
}

// The frame as objects again (values rounded to 32 bits, as they came).
export function unpackFrame(packed: PackedFrame): Frame {
  const objects: VizObject[] = [];
  for (let row = 0; row < packed.layout.ids.length; row++) objects.push(unpackObject(packed, row));
  return { tUs: packed.tUs, run: packed.run, seq: packed.seq, objects };
}

// One object of a frame.
export function unpackObject(packed: PackedFrame, row: number): VizObject {
  const at = (column: number): number => packed.data[row * STRIDE + column] ?? NaN;
  return {
    id: packed.layout.ids[row] ?? -1,
    kind: packed.layout.kinds[row] ?? 0,
    flags: at(Col.flags),
    pos: [at(Col.x), at(Col.y), at(Col.z)],
    vel: [at(Col.vx), at(Col.vy), at(Col.vz)],
    yaw: at(Col.yaw),
    roll: at(Col.roll),
    pitch: at(Col.pitch),
    posEst: [at(Col.xEst), at(Col.yEst), at(Col.zEst)],
    velEst: [at(Col.vxEst), at(Col.vyEst), at(Col.vzEst)],
    comfort: at(Col.comfort),
    steer: [at(Col.steer0), at(Col.steer1)],
  };
}

function fits(layout: Layout, objects: readonly VizObject[]): boolean {
  if (layout.ids.length !== objects.length) return false;
  for (let row = 0; row < objects.length; row++) {
    const object = objects[row] as VizObject;
    if (layout.ids[row] !== object.id || layout.kinds[row] !== object.kind) return false;
  }
  return true;
}

function layoutOf(objects: readonly VizObject[]): Layout {
  return {
    ids: Int32Array.from(objects, (object) => object.id),
    kinds: Int8Array.from(objects, (object) => object.kind),
    rowOf: new Map(objects.map((object, row) => [object.id, row])),
  };
}

function packObject(data: Float32Array, at: number, object: VizObject): void {
  data[at + Col.flags] = object.flags;
  data.set(object.pos, at + Col.x);
  data.set(object.vel, at + Col.vx);
  data[at + Col.yaw] = object.yaw;
  data[at + Col.roll] = object.roll;
  data[at + Col.pitch] = object.pitch;
  data.set(object.posEst, at + Col.xEst);
  data.set(object.velEst, at + Col.vxEst);
  data[at + Col.comfort] = object.comfort;
  data.set(object.steer, at + Col.steer0);
}
