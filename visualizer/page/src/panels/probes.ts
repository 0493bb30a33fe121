// At what a fault can be injected: as the case tells, else what a quadcopter has
// (docs/copter_scenarios.md). No DOM.

import { ObjectKind, type VizObject, type World } from '../../../codec/messages';
import type { CaseParams } from './case_params';

export interface Place {
  name: string;
  where: 'probe' | 'channel';
  object: number; // id, -1: none in its name
}

const plain = ['PxId', 'PyId', 'RollId', 'PitchId', 'YawId', 'ClockId'];
const ofAnchor = ['RangeId', 'AnchXId', 'AnchYId', 'AnchZId'];

export function places(params: CaseParams, objects: readonly VizObject[], world: World | null): Place[] {
  const told = [
    ...params.probes.map((name) => place(name, 'probe')),
    ...params.channels.map((name) => place(name, 'channel')),
  ];
  if (told.length > 0) return told;
  return objects.filter((o) => o.kind === ObjectKind.copter).flatMap(({ id }) => ofCopter(id, world));
}

// A copter's own position: the probe is applied in place, so that an offset adds up call by call
// (docs/coptersim.md).
export function isPosition(probe: string): boolean {
  return /^P[xy]Id\d+$/.test(probe);
}

function ofCopter(id: number, world: World | null): Place[] {
  const anchors = world?.anchors ?? [];
  return [
    ...plain.map((name) => place(`${name}${id}`, 'probe')),
    ...ofAnchor.flatMap((name) => anchors.map((anchor) => place(`${name}${id}Anch${anchor.id}`, 'probe'))),
    place(`ITS_DATA${id}`, 'channel'),
  ];
}

function place(name: string, where: Place['where']): Place {
  const id = /(?:Id|DATA)(\d+)/.exec(name)?.[1];
  return { name, where, object: id === undefined ? -1 : Number(id) };
}
