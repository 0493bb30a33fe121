// Numbers as text, in the units that the user has chosen.

import { shortNameOf } from '../model/short_name';
import type { VizObject } from '../../../codec/messages';
import { ObjectKind } from '../../../codec/messages';

export interface Units {
  readonly length: 'm' | 'mm';
  readonly angle: 'deg' | 'rad';
}

// `digits' are those of metres; millimetres have none.
function lengthNumber(metres: number, units: Units, digits: number): string {
  if (!Number.isFinite(metres)) return '–';
  return units.length === 'm' ? metres.toFixed(digits) : (metres * 1000).toFixed(0);
}

export function lengthText(metres: number, units: Units, digits = 2): string {
  return `${lengthNumber(metres, units, digits)} ${units.length}`;
}

// Without the unit, for tables with the unit at their head.
export const lengthCell = lengthNumber;

export function positionText(x: number, y: number, units: Units): string {
  return `${lengthNumber(x, units, 2)}, ${lengthText(y, units)}`;
}

export function speedText(metresPerSecond: number, units: Units): string {
  return `${lengthText(metresPerSecond, units)}/s`;
}

export function angleText(radians: number, units: Units, digits = 1): string {
  if (!Number.isFinite(radians)) return '–';
  if (units.angle === 'rad') return `${radians.toFixed(digits + 2)} rad`;
  return `${((radians * 180) / Math.PI).toFixed(digits)}°`;
}

export function rateText(radiansPerSecond: number, units: Units): string {
  return `${angleText(radiansPerSecond, units)}/s`;
}

// Simulated time: 7.420.
export function secondsText(us: number, digits = 3): string {
  return (us / 1e6).toFixed(digits);
}

export function ageText(seconds: number): string {
  return seconds < 60 ? `${seconds.toFixed(1)} s` : `${Math.floor(seconds / 60)} min`;
}

export function bytesText(bytes: number): string {
  if (bytes < 1000) return `${bytes.toFixed(0)} B`;
  return bytes < 1e6 ? `${(bytes / 1000).toFixed(0)} kB` : `${(bytes / 1e6).toFixed(1)} MB`;
}

export function speedFactorText(factor: number): string {
  return `${Number(factor.toPrecision(3))}×`;
}

const kindNames = new Map<number, string>([
  [ObjectKind.copter, 'Quad'],
  [ObjectKind.car, 'Car'],
]);

export function objectName(object: Pick<VizObject, 'id' | 'kind'>): string {
  return `${kindNames.get(object.kind) ?? 'Object'} ${object.id}`;
}

export function shortName(object: Pick<VizObject, 'id' | 'kind'>): string {
  return shortNameOf(object.id, object.kind);
}

export function distance(a: readonly number[], b: readonly number[]): number {
  return Math.hypot((a[0] ?? 0) - (b[0] ?? 0), (a[1] ?? 0) - (b[1] ?? 0), (a[2] ?? 0) - (b[2] ?? 0));
}
