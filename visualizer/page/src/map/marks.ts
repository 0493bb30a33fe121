// Marks on top of the vehicles: names, letters of active faults, measured distances of the
// observer, collisions, and the user's own measurement.

import { activeAt, faultLetter } from '../model/faults';
import { Col, type PackedFrame } from '../model/packed_frame';
import { glyphRadius } from './glyphs';
import { lengthText } from './length_text';
import { objectX, objectY, valueAt } from './columns';
import { shortNameOf } from '../model/short_name';
import { Places } from './places';
import { FAULT_COLORS, ON_FAULT } from './palette';
import type { Scene } from './scene';
import { circle, type Surface } from './surface';
import { screenX, screenY } from './view';

// Up to this many objects all have their name; beyond, only chosen ones and so many near ones.
const ALL_NAMED = 100;
const NEAR_NAMED = 30;

let distances = new Float64Array(0);
let sorted = new Float64Array(0);

const names = new Places(26, 13);
const letters = new Places(15, 17);

export function drawLabels(surface: Surface, scene: Scene, frame: PackedFrame): void {
  const { view, palette } = scene;
  const { ids, kinds } = frame.layout;
  const near = ids.length > ALL_NAMED ? nearDistance(scene, frame) : Infinity;
  const offset = glyphRadius(view.scale) * 1.5;
  surface.font = `12px ${palette.font}`;
  surface.textAlign = 'left';
  surface.textBaseline = 'middle';
  surface.fillStyle = palette.text;
  names.begin();
  for (let row = 0; row < ids.length; row++) {
    const id = ids[row] ?? -1;
    const faulted = (valueAt(frame, row, Col.flags) & 4) !== 0;
    const wanted = faulted || id === scene.observer || scene.pinned.includes(id);
    if (!wanted && !((distances[row] ?? 0) <= near) && near !== Infinity) continue;
    const x = objectX(view, frame, row) + offset;
    const y = names.free(x, objectY(view, frame, row) - offset);
    surface.fillText(shortNameOf(id, kinds[row] ?? 0), x, y);
  }
}

// Distance (m) of the 30th nearest object of the observer, of the map's middle without any.
function nearDistance({ view, observer }: Scene, frame: PackedFrame): number {
  const count = frame.layout.ids.length;
  if (distances.length !== count) {
    distances = new Float64Array(count);
    sorted = new Float64Array(count);
  }
  const from = frame.layout.rowOf.get(observer);
  const x = from === undefined ? view.x : valueAt(frame, from, Col.x);
  const y = from === undefined ? view.y : valueAt(frame, from, Col.y);
  for (let row = 0; row < count; row++) {
    distances[row] = Math.hypot(valueAt(frame, row, Col.x) - x, valueAt(frame, row, Col.y) - y);
  }
  sorted.set(distances);
  sorted.sort();
  return sorted[NEAR_NAMED] ?? Infinity;
}

// Letters of the faults that are active now, side by side below each object.
export function drawFaultLetters(surface: Surface, scene: Scene, frame: PackedFrame): void {
  const { view, palette } = scene;
  const offset = glyphRadius(view.scale) * 1.5;
  const shown = new Map<number, number>(); // object id: how many letters it has already
  surface.font = `bold 11px ${palette.font}`;
  surface.textAlign = 'center';
  surface.textBaseline = 'middle';
  letters.begin();
  for (const fault of scene.faults?.items ?? []) {
    const row = frame.layout.rowOf.get(fault.object);
    if (row === undefined || !activeAt(fault, scene.tUs)) continue;
    const place = shown.get(fault.object) ?? 0;
    shown.set(fault.object, place + 1);
    const x = objectX(view, frame, row) + offset + 7 + place * 17;
    const y = letters.free(x, objectY(view, frame, row) + offset);
    drawLetter(surface, faultLetter(fault), x, y);
  }
}

function drawLetter(surface: Surface, letter: string, x: number, y: number): void {
  surface.beginPath();
  surface.rect(x - 7.5, y - 7.5, 15, 15);
  surface.fillStyle = FAULT_COLORS[letter] ?? '#b7a58e';
  surface.fill();
  surface.fillStyle = ON_FAULT;
  surface.fillText(letter, x, y + 0.5);
}

// Lines from the observer's perceived position to each anchor: whole when the measurement counted,
// dashed when it was refused; the number is measured minus expected.
export function drawRanges(surface: Surface, scene: Scene, frame: PackedFrame): void {
  const { view, palette, ranges, world } = scene;
  const row = ranges === null ? undefined : frame.layout.rowOf.get(ranges.object);
  if (ranges === null || row === undefined || world === null) return;
  const x = screenX(view, valueAt(frame, row, Col.xEst));
  const y = screenY(view, valueAt(frame, row, Col.yEst));
  surface.font = `11px ${palette.mono}`;
  surface.textAlign = 'center';
  surface.textBaseline = 'middle';
  for (const range of ranges.items) {
    const anchor = world.anchors.find((one) => one.id === range.anchor);
    if (anchor === undefined) continue;
    const ax = screenX(view, anchor.pos[0]);
    const ay = screenY(view, anchor.pos[1]);
    surface.beginPath();
    surface.moveTo(x, y);
    surface.lineTo(ax, ay);
    surface.setLineDash(range.used ? [] : [3, 4]);
    surface.strokeStyle = range.used ? palette.range : palette.overlap;
    surface.lineWidth = 1.25;
    surface.stroke();
    surface.setLineDash([]);
    surface.fillStyle = palette.text;
    const error = range.measured - range.expected;
    surface.fillText(`${error < 0 ? '−' : '+'}${Math.abs(error).toFixed(2)}`, (x + ax) / 2, (y + ay) / 2 - 7);
  }
}

// A cross and a ring at each collision that has happened by now.
export function drawCollisions(surface: Surface, { view, palette, collisions, tUs }: Scene): void {
  const radius = Math.max(glyphRadius(view.scale) * 1.8, 16);
  surface.beginPath();
  for (const collision of collisions) {
    if (collision.tUs > tUs) continue;
    const x = screenX(view, collision.x);
    const y = screenY(view, collision.y);
    const arm = radius * 0.62;
    circle(surface, x, y, radius);
    surface.moveTo(x - arm, y - arm);
    surface.lineTo(x + arm, y + arm);
    surface.moveTo(x - arm, y + arm);
    surface.lineTo(x + arm, y - arm);
  }
  surface.strokeStyle = palette.overlap;
  surface.lineWidth = 3.5;
  surface.stroke();
}

export function drawMeasure(surface: Surface, { view, palette, measure, unit }: Scene): void {
  if (measure === null) return;
  const x1 = screenX(view, measure.fromX);
  const y1 = screenY(view, measure.fromY);
  const x2 = screenX(view, measure.toX);
  const y2 = screenY(view, measure.toY);
  surface.beginPath();
  surface.moveTo(x1, y1);
  surface.lineTo(x2, y2);
  circle(surface, x1, y1, 3);
  circle(surface, x2, y2, 3);
  surface.strokeStyle = palette.accent;
  surface.lineWidth = 2;
  surface.stroke();
  const length = Math.hypot(measure.toX - measure.fromX, measure.toY - measure.fromY);
  const text = lengthText(length, unit);
  surface.font = `bold 12px ${palette.font}`;
  surface.textAlign = 'center';
  surface.textBaseline = 'middle';
  const width = text.length * 8 + 10;
  surface.beginPath();
  surface.rect((x1 + x2 - width) / 2, (y1 + y2) / 2 - 24, width, 18);
  surface.fillStyle = palette.background;
  surface.fill();
  surface.fillStyle = palette.accent;
  surface.fillText(text, (x1 + x2) / 2, (y1 + y2) / 2 - 15);
}
