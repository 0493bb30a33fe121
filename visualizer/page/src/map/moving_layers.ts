// What moves: comfort zones, contours, trails, distances, ghosts, vehicles, labels, collisions.
// Everything of one kind and colour is one path, and nothing is allocated per object, so that 400
// objects are drawn without a graphics processor.

import { ObjectFlag, ObjectKind } from '../../../codec/messages';
import { Col, type PackedFrame } from '../model/packed_frame';
import { RISK_STRIDE, RiskCol } from '../model/packed_risk';
import { objectX, objectY, valueAt } from './columns';
import {
  addArms,
  addCarBody,
  addFrontRotor,
  addRotors,
  addWheels,
  CAR_LENGTH_M,
  glyphRadius,
} from './glyphs';
import { drawCollisions, drawFaultLetters, drawLabels, drawMeasure, drawRanges } from './marks';
import { OBJECT_COLORS } from './palette';
import type { Scene } from './scene';
import type { Stamps } from './stamps';
import { circle, FULL_CIRCLE, type Surface } from './surface';
import { addTrail, trailFrames } from './trails';
import { screenX, screenY, type View } from './view';

// Perceived positions nearer than this to the true one are not told apart on the screen.
const GHOST_PX = 2;
// From so many objects on, copters are copied instead of drawn.
const STAMPED_FROM = 80;

const trailScratch: PackedFrame[] = [];

export function drawMovingLayers(surface: Surface, scene: Scene): void {
  const frame = scene.frame;
  if (frame === null) return;
  if (scene.layers.comfort) drawComfort(surface, scene, frame);
  if (scene.layers.risk) drawRisk(surface, scene);
  if (scene.layers.trails && scene.trail !== 0) drawTrails(surface, scene, frame);
  if (scene.layers.ranges) drawRanges(surface, scene, frame);
  if (scene.layers.perceived) drawGhosts(surface, scene, frame);
  drawVehicles(surface, scene, frame);
  drawSelection(surface, scene, frame);
  drawFaultLetters(surface, scene, frame);
  if (scene.layers.labels) drawLabels(surface, scene, frame);
  drawCollisions(surface, scene);
  drawMeasure(surface, scene);
}

function drawComfort(surface: Surface, { view, palette, observer }: Scene, frame: PackedFrame): void {
  const count = frame.layout.ids.length;
  surface.beginPath();
  for (let row = 0; row < count; row++) {
    if (frame.layout.ids[row] !== observer) addComfort(surface, view, frame, row);
  }
  surface.strokeStyle = palette.comfort;
  surface.lineWidth = 0.75;
  surface.globalAlpha = 0.55;
  surface.stroke();
  surface.globalAlpha = 1;
  const row = frame.layout.rowOf.get(observer);
  if (row === undefined) return;
  surface.beginPath();
  addComfort(surface, view, frame, row);
  surface.fillStyle = palette.comfortFill;
  surface.fill();
  surface.lineWidth = 1.5;
  surface.stroke();
}

function addComfort(surface: Surface, view: View, frame: PackedFrame, row: number): void {
  const radius = valueAt(frame, row, Col.comfort) * view.scale;
  if (radius > 0) circle(surface, objectX(view, frame, row), objectY(view, frame, row), radius);
}

// Overlapping contours stand out by colour and by a thicker outline. Each is a path of its own: one
// path of hundreds of ellipses takes longer to fill.
function drawRisk(surface: Surface, scene: Scene): void {
  const { palette } = scene;
  surface.fillStyle = palette.riskFill;
  surface.strokeStyle = palette.risk;
  surface.lineWidth = 1;
  drawContours(surface, scene, false);
  surface.fillStyle = palette.overlapFill;
  surface.strokeStyle = palette.overlap;
  surface.lineWidth = 3;
  drawContours(surface, scene, true);
}

function drawContours(surface: Surface, { view, risk }: Scene, overlap: boolean): void {
  const data = risk?.data ?? NO_RISK;
  for (let at = 0; at < data.length; at += RISK_STRIDE) {
    if ((data[at + RiskCol.overlap] !== 0) !== overlap) continue;
    const rx = (data[at + RiskCol.rx] ?? 0) * view.scale;
    const ry = (data[at + RiskCol.ry] ?? 0) * view.scale;
    const theta = data[at + RiskCol.theta] ?? 0;
    if (!(rx >= 0) || !(ry >= 0) || !Number.isFinite(theta)) continue;
    const x = screenX(view, data[at + RiskCol.x] ?? NaN);
    const y = screenY(view, data[at + RiskCol.y] ?? NaN);
    surface.beginPath();
    surface.ellipse(x, y, rx, ry, -theta, 0, FULL_CIRCLE);
    surface.fill();
    surface.stroke();
  }
}

const NO_RISK = new Float32Array(0);

function drawTrails(surface: Surface, scene: Scene, frame: PackedFrame): void {
  trailFrames(scene.frames, frame, scene.tUs, scene.trail, trailScratch);
  surface.lineWidth = 1.25;
  surface.lineJoin = 'round';
  for (let color = 0; color < OBJECT_COLORS.length; color++) {
    surface.beginPath();
    for (let row = 0; row < frame.layout.ids.length; row++) {
      if (colorOf(frame, row) === color) addTrail(surface, scene.view, trailScratch, row);
    }
    surface.strokeStyle = OBJECT_COLORS[color] ?? scene.palette.text;
    surface.stroke();
  }
}

// A dashed ring where the vehicle believes itself to be, and a line from where it is.
function drawGhosts(surface: Surface, { view, palette }: Scene, frame: PackedFrame): void {
  const radius = glyphRadius(view.scale);
  surface.beginPath();
  for (let row = 0; row < frame.layout.ids.length; row++) {
    const x = objectX(view, frame, row);
    const y = objectY(view, frame, row);
    const gx = screenX(view, valueAt(frame, row, Col.xEst));
    const gy = screenY(view, valueAt(frame, row, Col.yEst));
    if (!(Math.abs(gx - x) > GHOST_PX || Math.abs(gy - y) > GHOST_PX)) continue;
    surface.moveTo(x, y);
    surface.lineTo(gx, gy);
    circle(surface, gx, gy, radius);
  }
  surface.setLineDash(GHOST_DASH);
  surface.strokeStyle = palette.text;
  surface.lineWidth = 1;
  surface.stroke();
  surface.setLineDash(NO_DASH);
}

const GHOST_DASH = [4, 3];
const NO_DASH: number[] = [];

function drawVehicles(surface: Surface, scene: Scene, frame: PackedFrame): void {
  const stamped = scene.stamps !== null && frame.layout.ids.length >= STAMPED_FROM;
  if (stamped && scene.stamps !== null) stampCopters(scene.stamps, scene, frame);
  drawWheelsAndArms(surface, scene, frame, stamped);
  drawBodies(surface, scene, frame, stamped);
  if (!stamped) drawFronts(surface, scene, frame);
}

function stampCopters(stamps: Stamps, { view, palette }: Scene, frame: PackedFrame): void {
  stamps.prepare(glyphRadius(view.scale), palette.text);
  for (let row = 0; row < frame.layout.ids.length; row++) {
    if (frame.layout.kinds[row] !== ObjectKind.copter) continue;
    const x = objectX(view, frame, row);
    stamps.copter(x, objectY(view, frame, row), valueAt(frame, row, Col.yaw), colorOf(frame, row));
  }
}

function drawWheelsAndArms(
  surface: Surface,
  { view, palette }: Scene,
  frame: PackedFrame,
  stamped: boolean,
): void {
  const radius = glyphRadius(view.scale);
  const length = carLength(view);
  surface.beginPath();
  for (let row = 0; row < frame.layout.ids.length; row++) {
    const kind = frame.layout.kinds[row];
    const x = objectX(view, frame, row);
    const y = objectY(view, frame, row);
    const yaw = valueAt(frame, row, Col.yaw);
    if (kind === ObjectKind.car) addWheels(surface, x, y, length, yaw, valueAt(frame, row, Col.steer0));
    else if (kind === ObjectKind.copter && !stamped) addArms(surface, x, y, radius, yaw);
  }
  surface.strokeStyle = palette.text;
  surface.lineWidth = Math.max(1.5, radius * 0.16);
  surface.stroke();
}

// Rotors, cars and other objects, a path for each colour.
function drawBodies(surface: Surface, { view, palette }: Scene, frame: PackedFrame, stamped: boolean): void {
  const radius = glyphRadius(view.scale);
  const length = carLength(view);
  surface.lineWidth = 1;
  surface.strokeStyle = palette.text;
  for (let color = 0; color < OBJECT_COLORS.length; color++) {
    surface.beginPath();
    for (let row = 0; row < frame.layout.ids.length; row++) {
      const kind = frame.layout.kinds[row];
      if (colorOf(frame, row) !== color || (stamped && kind === ObjectKind.copter)) continue;
      const x = objectX(view, frame, row);
      const y = objectY(view, frame, row);
      const yaw = valueAt(frame, row, Col.yaw);
      if (kind === ObjectKind.copter) addRotors(surface, x, y, radius, yaw);
      else if (kind === ObjectKind.car) addCarBody(surface, x, y, length, yaw);
      else circle(surface, x, y, radius * 0.7);
    }
    surface.fillStyle = OBJECT_COLORS[color] ?? palette.text;
    surface.fill();
    surface.stroke();
  }
}

function drawFronts(surface: Surface, { view, palette }: Scene, frame: PackedFrame): void {
  const radius = glyphRadius(view.scale);
  surface.beginPath();
  for (let row = 0; row < frame.layout.ids.length; row++) {
    if (frame.layout.kinds[row] !== ObjectKind.copter) continue;
    const yaw = valueAt(frame, row, Col.yaw);
    addFrontRotor(surface, objectX(view, frame, row), objectY(view, frame, row), radius, yaw);
  }
  surface.fillStyle = palette.text;
  surface.fill();
}

function carLength(view: View): number {
  return Math.max(CAR_LENGTH_M * view.scale, 18);
}

function colorOf(frame: PackedFrame, row: number): number {
  const count = OBJECT_COLORS.length;
  const id = frame.layout.ids[row] ?? 0;
  return ((id % count) + count) % count;
}

// A square round the observer, a dashed one round each other pinned object; a ring when it is avoiding.
function drawSelection(surface: Surface, scene: Scene, frame: PackedFrame): void {
  const { view, palette, observer, pinned } = scene;
  const half = glyphRadius(view.scale) * 1.75;
  surface.strokeStyle = palette.accent;
  const row = frame.layout.rowOf.get(observer);
  if (row !== undefined) {
    surface.beginPath();
    addSquare(surface, view, frame, row, half);
    surface.lineWidth = 2.5;
    surface.stroke();
  }
  surface.beginPath();
  for (const id of pinned) {
    const pinnedRow = frame.layout.rowOf.get(id);
    if (pinnedRow !== undefined && id !== observer) addSquare(surface, view, frame, pinnedRow, half);
  }
  surface.setLineDash(GHOST_DASH);
  surface.lineWidth = 1.5;
  surface.stroke();
  surface.setLineDash(NO_DASH);
  drawAvoiding(surface, scene, frame, half);
}

function drawAvoiding(surface: Surface, { view, palette }: Scene, frame: PackedFrame, half: number): void {
  surface.beginPath();
  for (let row = 0; row < frame.layout.ids.length; row++) {
    if ((valueAt(frame, row, Col.flags) & ObjectFlag.avoiding) === 0) continue;
    circle(surface, objectX(view, frame, row), objectY(view, frame, row), half * 0.92);
  }
  surface.strokeStyle = palette.warn;
  surface.lineWidth = 2;
  surface.stroke();
}

function addSquare(surface: Surface, view: View, frame: PackedFrame, row: number, half: number): void {
  surface.rect(objectX(view, frame, row) - half, objectY(view, frame, row) - half, 2 * half, 2 * half);
}
