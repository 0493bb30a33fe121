// Copters drawn once for each colour and heading, then only copied: with hundreds of them this costs
// a quarter of drawing their paths, at the price of headings in steps and whole pixels.

import { addArms, addFrontRotor, addRotors } from './glyphs';
import { OBJECT_COLORS } from './palette';
import type { Surface } from './surface';

// What the moving layers ask for; there are none when a picture is not drawn on a canvas.
export interface Stamps {
  // Makes ready for copters of that radius (CSS pixels); cheap when nothing changed.
  prepare(radius: number, outline: string): void;
  copter(x: number, y: number, yaw: number, color: number): void; // CSS pixels, rad, index of colour
}

const HEADINGS = 64;
const REACH = 1.75; // half a cell, in radii: centre to the rotors' rim and the outline

// The step of heading that is nearest to an angle.
export function headingStep(yaw: number): number {
  const turn = Math.round((yaw / (2 * Math.PI)) * HEADINGS) % HEADINGS;
  return turn < 0 ? turn + HEADINGS : turn;
}

export class CanvasStamps implements Stamps {
  private readonly sheet = document.createElement('canvas');
  private key = '';
  private cell = 1; // device pixels
  private ratio = 1;

  constructor(private readonly target: CanvasRenderingContext2D) {}

  prepare(radius: number, outline: string): void {
    const ratio = window.devicePixelRatio || 1;
    const key = `${radius} ${outline} ${ratio}`;
    if (key === this.key) return;
    this.key = key;
    this.ratio = ratio;
    this.cell = 2 * Math.ceil(radius * REACH * ratio);
    this.sheet.width = HEADINGS * this.cell;
    this.sheet.height = OBJECT_COLORS.length * this.cell;
    const surface = this.sheet.getContext('2d');
    if (surface === null) return;
    surface.setTransform(ratio, 0, 0, ratio, 0, 0);
    const step = this.cell / ratio;
    OBJECT_COLORS.forEach((color, row) => {
      for (let turn = 0; turn < HEADINGS; turn++) {
        const yaw = (turn / HEADINGS) * 2 * Math.PI;
        drawCopter(surface, (turn + 0.5) * step, (row + 0.5) * step, radius, yaw, color, outline);
      }
    });
  }

  copter(x: number, y: number, yaw: number, color: number): void {
    const { cell, ratio } = this;
    const left = Math.round(x * ratio - cell / 2) / ratio;
    const top = Math.round(y * ratio - cell / 2) / ratio;
    const size = cell / ratio;
    const from = headingStep(yaw) * cell;
    this.target.drawImage(this.sheet, from, color * cell, cell, cell, left, top, size, size);
  }
}

function drawCopter(
  surface: Surface,
  x: number,
  y: number,
  radius: number,
  yaw: number,
  color: string,
  outline: string,
): void {
  surface.strokeStyle = outline;
  surface.lineWidth = Math.max(1.5, radius * 0.16);
  surface.beginPath();
  addArms(surface, x, y, radius, yaw);
  surface.stroke();
  surface.lineWidth = 1;
  surface.beginPath();
  addRotors(surface, x, y, radius, yaw);
  surface.fillStyle = color;
  surface.fill();
  surface.stroke();
  surface.beginPath();
  addFrontRotor(surface, x, y, radius, yaw);
  surface.fillStyle = outline;
  surface.fill();
}
