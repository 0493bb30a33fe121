// The shapes of vehicles, as parts of larger paths: a copter is a cross with four rotors, its front
// one marked; a car an outline with steered wheels. Angles are of the world (counter-clockwise from
// east), so y is turned round on the screen.

import { circle, type Surface } from './surface';

export const COPTER_RADIUS_M = 0.2; // centre to rotor, as drawn
export const CAR_LENGTH_M = 0.5;
const MIN_RADIUS_PX = 5;
const MAX_RADIUS_PX = 30;

// Centre to rotor in CSS pixels; small and large scales keep glyphs readable.
export function glyphRadius(scale: number): number {
  return Math.min(Math.max(COPTER_RADIUS_M * scale, MIN_RADIUS_PX), MAX_RADIUS_PX);
}

// Both arms of the cross.
export function addArms(surface: Surface, x: number, y: number, radius: number, yaw: number): void {
  const dx = Math.cos(yaw) * radius;
  const dy = -Math.sin(yaw) * radius;
  surface.moveTo(x - dx, y - dy);
  surface.lineTo(x + dx, y + dy);
  surface.moveTo(x - dy, y + dx);
  surface.lineTo(x + dy, y - dx);
}

// The left, rear and right rotor.
export function addRotors(surface: Surface, x: number, y: number, radius: number, yaw: number): void {
  const dx = Math.cos(yaw) * radius;
  const dy = -Math.sin(yaw) * radius;
  const size = rotorRadius(radius);
  circle(surface, x - dx, y - dy, size);
  circle(surface, x + dy, y - dx, size);
  circle(surface, x - dy, y + dx, size);
}

// The front rotor, larger than the others.
export function addFrontRotor(surface: Surface, x: number, y: number, radius: number, yaw: number): void {
  circle(surface, x + Math.cos(yaw) * radius, y - Math.sin(yaw) * radius, rotorRadius(radius) * 1.15);
}

function rotorRadius(radius: number): number {
  return radius * 0.45;
}

// A car's outline with a nose line; `length` in CSS pixels.
export function addCarBody(surface: Surface, x: number, y: number, length: number, yaw: number): void {
  addBox(surface, x, y, length, length * 0.5, yaw);
  const nose = length * 0.22;
  const half = length * 0.25;
  const cos = Math.cos(yaw);
  const sin = Math.sin(yaw);
  surface.moveTo(x + nose * cos - half * sin, y - nose * sin - half * cos);
  surface.lineTo(x + nose * cos + half * sin, y - nose * sin + half * cos);
}

// Its four wheels, the front ones turned by the steering angle.
export function addWheels(
  surface: Surface,
  x: number,
  y: number,
  length: number,
  yaw: number,
  steer: number,
): void {
  const cos = Math.cos(yaw);
  const sin = Math.sin(yaw);
  for (const along of [-0.3, 0.3]) {
    for (const across of [-0.27, 0.27]) {
      const wx = x + length * (along * cos - across * sin);
      const wy = y - length * (along * sin + across * cos);
      addBox(surface, wx, wy, length * 0.24, length * 0.1, along > 0 ? yaw + steer : yaw);
    }
  }
}

function addBox(surface: Surface, x: number, y: number, length: number, width: number, yaw: number): void {
  const ax = (Math.cos(yaw) * length) / 2;
  const ay = (-Math.sin(yaw) * length) / 2;
  const bx = (Math.sin(yaw) * width) / 2;
  const by = (Math.cos(yaw) * width) / 2;
  surface.moveTo(x + ax + bx, y + ay + by);
  surface.lineTo(x + ax - bx, y + ay - by);
  surface.lineTo(x - ax - bx, y - ay - by);
  surface.lineTo(x - ax + bx, y - ay + by);
  surface.closePath();
}
