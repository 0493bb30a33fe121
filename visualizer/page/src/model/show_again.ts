// What is shown of a replay, to be asked for again of a player that was started anew.

import { type Ack, Mode } from '../../../codec/messages';
import { refusalLine } from './pending_control';
import type { Playback } from './playback';
import type { RunData } from './run_data';

export interface Shown {
  readonly caseId: string;
  readonly original: boolean; // the sequence before shrinking
  readonly tUs: number;
  readonly speed: number;
  readonly playing: boolean;
}

// null when it is no stored case, or the player takes no wishes.
export function shownOfReplay({ status, caseInfo }: RunData, playback: Playback): Shown | null {
  if (status?.mode !== Mode.replay || !status.controlAllowed || !caseInfo?.caseId) return null;
  const { tUs, following, playing, speed } = playback;
  const original = caseInfo.ncmdOriginal > 0 && caseInfo.commands.length === caseInfo.ncmdOriginal;
  return { caseId: caseInfo.caseId, original, tUs, speed: following ? status.speed : speed, playing };
}

// Resolves with '' or with the player's first refusal.
export async function showAgain(
  { caseId, original, tUs, speed, playing }: Shown,
  control: (verb: string, args: readonly number[], text: string) => Promise<Ack>,
): Promise<string> {
  const wishes: [verb: string, args: number[], text: string][] = [
    ['load', [original ? 1 : 0], caseId],
    ['speed', [speed], ''],
  ];
  if (!playing) wishes.push(['pause', [], '']);
  wishes.push(['seek', [tUs / 1e6], '']);
  for (const [verb, args, text] of wishes) {
    const ack = await control(verb, args, text);
    if (!ack.ok) return refusalLine(verb, ack.text);
  }
  return '';
}
