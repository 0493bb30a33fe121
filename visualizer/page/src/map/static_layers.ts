// What does not move: map tiles, grid, polygons, terrain, anchors, scale bar. Redrawn only when the view, the
// world or the theme changes.

import type { Poly } from '../../../codec/messages';
import { lengthText } from './length_text';
import type { Palette } from './palette';
import type { Scene } from './scene';
import type { Surface } from './surface';
import { roundLength, screenX, screenY, type View, worldX, worldY } from './view';

const GRID_PX = 40; // least distance of grid lines
const MOST_LINES = 1000;
const ANCHOR_NAME_PX = 75;
const SCALE_BAR_PX = 120; // longest

export function drawStaticLayers(surface: Surface, scene: Scene): void {
  drawBackground(surface, scene);
  scene.ground?.draw(scene.view, scene.palette);
  if (scene.layers.grid) drawGrid(surface, scene.view, scene.palette);
  if (scene.world !== null && scene.layers.terrain) {
    for (const poly of scene.world.polys) drawPoly(surface, scene.view, poly, scene.palette);
    drawTerrain(surface, scene);
  }
  if (scene.world !== null && scene.layers.anchors) drawAnchors(surface, scene);
  drawScaleBar(surface, scene);
}

// Coordinates (m) of grid lines between two. So far away from the origin that numbers are coarser than
// the steps there are none: data may be anything.
export function gridLines(from: number, to: number, step: number): number[] {
  const first = Math.ceil(from / step);
  const count = Math.floor(to / step) - first + 1;
  if (!(count > 0) || !Number.isSafeInteger(first)) return [];
  return Array.from({ length: Math.min(count, MOST_LINES) }, (_, n) => (first + n) * step);
}

function drawBackground(surface: Surface, { view, palette }: Scene): void {
  surface.beginPath();
  surface.rect(0, 0, view.size.width, view.size.height);
  surface.fillStyle = palette.background;
  surface.fill();
}

function drawGrid(surface: Surface, view: View, palette: Palette): void {
  const { width, height } = view.size;
  const step = 2 * roundLength(view.scale, GRID_PX);
  surface.beginPath();
  for (const x of gridLines(worldX(view, 0), worldX(view, width), step)) {
    const px = crisp(screenX(view, x));
    surface.moveTo(px, 0);
    surface.lineTo(px, height);
  }
  for (const y of gridLines(worldY(view, height), worldY(view, 0), step)) {
    const py = crisp(screenY(view, y));
    surface.moveTo(0, py);
    surface.lineTo(width, py);
  }
  stroke(surface, palette.grid, 1);
  surface.beginPath();
  surface.moveTo(crisp(screenX(view, 0)), 0);
  surface.lineTo(crisp(screenX(view, 0)), height);
  surface.moveTo(0, crisp(screenY(view, 0)));
  surface.lineTo(width, crisp(screenY(view, 0)));
  stroke(surface, palette.axis, 1);
}

function drawPoly(surface: Surface, view: View, poly: Poly, palette: Palette): void {
  const [first, ...rest] = poly.pt;
  if (first === undefined) return;
  surface.beginPath();
  surface.moveTo(screenX(view, first[0]), screenY(view, first[1]));
  for (const point of rest) surface.lineTo(screenX(view, point[0]), screenY(view, point[1]));
  if (poly.role === 0 || poly.role === 1) {
    surface.closePath();
    surface.fillStyle = poly.role === 0 ? palette.allowed : palette.forbidden;
    surface.fill();
    stroke(surface, poly.role === 0 ? palette.anchor : palette.overlap, 1.5);
  } else {
    surface.setLineDash(poly.role === 3 ? [8, 5] : []);
    stroke(surface, poly.role === 3 ? palette.recovery : palette.route, 2);
    surface.setLineDash([]);
  }
  text(surface, palette, 11);
  surface.fillStyle = palette.soft;
  surface.fillText(poly.name, screenX(view, first[0]) + 6, screenY(view, first[1]) + 12);
}

function drawTerrain(surface: Surface, { view, palette, world }: Scene): void {
  surface.beginPath();
  for (const [x1, y1, x2, y2] of world?.seg ?? []) {
    surface.moveTo(screenX(view, x1), screenY(view, y1));
    surface.lineTo(screenX(view, x2), screenY(view, y2));
  }
  surface.lineJoin = 'round';
  stroke(surface, palette.terrain, 4);
}

function drawAnchors(surface: Surface, { view, palette, world }: Scene): void {
  const anchors = world?.anchors ?? [];
  surface.beginPath();
  for (const anchor of anchors) {
    const x = screenX(view, anchor.pos[0]);
    const y = screenY(view, anchor.pos[1]);
    surface.moveTo(x, y - 7);
    surface.lineTo(x + 7, y + 5);
    surface.lineTo(x - 7, y + 5);
    surface.closePath();
  }
  surface.fillStyle = palette.anchor;
  surface.fill();
  if (anchors.length > 40) return;
  text(surface, palette, 12);
  surface.fillStyle = palette.text;
  for (const anchor of anchors) {
    const x = screenX(view, anchor.pos[0]);
    const left = x > view.size.width - ANCHOR_NAME_PX; // no room to the right
    surface.textAlign = left ? 'right' : 'left';
    surface.fillText(`Anchor ${anchor.id}`, left ? x - 10 : x + 10, screenY(view, anchor.pos[1]));
  }
  surface.textAlign = 'left';
}

function drawScaleBar(surface: Surface, { view, palette, unit }: Scene): void {
  const length = roundLength(view.scale, SCALE_BAR_PX);
  const right = view.size.width - 20;
  const y = view.size.height - 16;
  const left = right - length * view.scale;
  surface.beginPath();
  surface.moveTo(left, y - 4);
  surface.lineTo(left, y);
  surface.lineTo(right, y);
  surface.lineTo(right, y - 4);
  stroke(surface, palette.text, 2);
  text(surface, palette, 12);
  surface.textAlign = 'center';
  surface.fillStyle = palette.text;
  surface.fillText(lengthText(length, unit), (left + right) / 2, y - 11);
  surface.textAlign = 'left';
}

function stroke(surface: Surface, color: string, width: number): void {
  surface.strokeStyle = color;
  surface.lineWidth = width;
  surface.stroke();
}

function text(surface: Surface, palette: Palette, px: number): void {
  surface.font = `${px}px ${palette.font}`;
  surface.textBaseline = 'middle';
  surface.textAlign = 'left';
}

// A line of one pixel is sharp in the middle of a pixel.
function crisp(px: number): number {
  return Math.round(px) + 0.5;
}
