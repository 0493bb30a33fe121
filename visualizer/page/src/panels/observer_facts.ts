// What the inspector tells of the observer. No DOM.

import { ObjectFlag, type Risk, type VizObject } from '../../../codec/messages';
import {
  ageText,
  angleText,
  distance,
  lengthText,
  positionText,
  shortName,
  speedText,
  type Units,
} from './format';

export const observerFacts = [
  'true position',
  'perceived',
  'position error',
  'velocity error',
  'speed',
  'height z',
  'roll, pitch, yaw',
  'comfort radius',
  'nearest',
  'avoidance',
  'last heard',
] as const;
export type ObserverFact = (typeof observerFacts)[number];

export type FactTexts = ReadonlyMap<ObserverFact, { text: string; bad?: boolean }>;

export function factsOf(
  object: VizObject,
  objects: readonly VizObject[],
  risk: Risk | null,
  units: Units,
): FactTexts {
  const near = nearest(object, objects);
  const avoiding = (object.flags & ObjectFlag.avoiding) !== 0;
  const attitude = [object.roll, object.pitch, object.yaw].map((a) => angleText(a, units)).join(' ');
  return new Map<ObserverFact, { text: string; bad?: boolean }>([
    ['true position', { text: positionText(object.pos[0], object.pos[1], units) }],
    ['perceived', { text: positionText(object.posEst[0], object.posEst[1], units) }],
    ['position error', { text: lengthText(distance(object.pos, object.posEst), units, 3) }],
    ['velocity error', { text: speedText(distance(object.vel, object.velEst), units) }],
    ['speed', { text: speedText(Math.hypot(...object.vel), units) }],
    ['height z', { text: lengthText(object.pos[2], units) }],
    ['roll, pitch, yaw', { text: attitude }],
    ['comfort radius', { text: lengthText(object.comfort, units) }],
    ['nearest', { text: near === null ? '–' : `${shortName(near)} · ${lengthText(near.away, units)}` }],
    ['avoidance', { text: avoiding ? 'steering away' : 'no', bad: avoiding }],
    ['last heard', { text: lastHeard(near, risk) }],
  ]);
}

export interface Near extends VizObject {
  away: number; // m, between the true centres
}

export function nearest(object: VizObject, objects: readonly VizObject[]): Near | null {
  let best: Near | null = null;
  for (const other of objects) {
    if (other.id === object.id) continue;
    const away = distance(object.pos, other.pos);
    if (best === null || away < best.away) best = { ...other, away };
  }
  return best;
}

// How old the news is that the observer has of its nearest.
function lastHeard(near: Near | null, risk: Risk | null): string {
  if (near === null || risk === null) return '–';
  const contour = risk.ellipses.find((ellipse) => ellipse.kind === 0 && ellipse.about === near.id);
  return contour === undefined
    ? `${shortName(near)} not known`
    : `${shortName(near)} ${ageText(contour.age)} ago`;
}
