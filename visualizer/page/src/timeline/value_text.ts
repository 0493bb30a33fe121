// What a screen reader says of the moment: time, command, collision.

import type { ViewerState } from '../model/viewer';

type Facts = Pick<ViewerState, 'tUs' | 'durationUs' | 'caseInfo' | 'currentCommand' | 'collisions'>;

export function valueText({ tUs, durationUs, caseInfo, currentCommand, collisions }: Facts): string {
  const parts = [`${(tUs / 1e6).toFixed(2)} of ${(durationUs / 1e6).toFixed(2)} seconds`];
  const command = caseInfo?.commands[currentCommand];
  if (command !== undefined) parts.push(`command ${command.index + 1}, ${command.name}`);
  if (collisions.some((collision) => collision.tUs <= tUs)) parts.push('after the collision');
  return parts.join(', ');
}
