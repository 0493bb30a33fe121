// A log file as messages, in turns, so that the page stays usable while a long one is read.

import { readLog } from '../../../codec/log';
import type { Message } from '../../../codec/messages';
import { decodeMessage, isChannel } from '../../../codec/viz';

const MESSAGES_A_TURN = 2000;

// Gives each message of the visualizer's channels to `take`; other channels are none of our business.
// `pause` lets others have a turn. Resolves with '' or one line on why reading ended early, or on what
// could not be understood; rejects with one line when nothing could.
export async function readVizLog(
  bytes: ArrayBuffer,
  take: (message: Message) => void,
  pause: () => Promise<void>,
): Promise<string> {
  const log = readLog(new Uint8Array(bytes));
  if (log.messages.length === 0) throw new Error('not an LCM log or a report');
  let taken = 0;
  let problem = log.problem;
  for (const [index, { channel, data }] of log.messages.entries()) {
    if (index % MESSAGES_A_TURN === MESSAGES_A_TURN - 1) await pause();
    if (!isChannel(channel)) continue;
    const decoded = decodeMessage(channel, data);
    if (decoded.ok) {
      take(decoded.message);
      taken += 1;
    } else if (problem === '') {
      problem = decoded.error;
    }
  }
  if (taken === 0) throw new Error(problem === '' ? 'no message of the visualizer in it' : problem);
  return problem;
}
