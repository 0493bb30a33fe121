// Control messages that wait for the player's answer, each for a second.

import type { Ack } from '../../../codec/messages';

export const ACK_TIMEOUT_MS = 1000;

interface Waiting {
  readonly dueMs: number;
  readonly resolve: (ack: Ack) => void;
}

export class PendingControl {
  private readonly waiting = new Map<number, Waiting>();

  // `firstSeq` differs from page to page, so that another page's answers are told apart.
  constructor(private nextSeq: number) {}

  get empty(): boolean {
    return this.waiting.size === 0;
  }

  // Registers a message; the answer to its number goes to the promise.
  begin(nowMs: number): { seq: number; answer: Promise<Ack> } {
    const seq = this.nextSeq;
    this.nextSeq = seq >= 0x7fffffff ? 1 : seq + 1;
    const answer = new Promise<Ack>((resolve) => {
      this.waiting.set(seq, { dueMs: nowMs + ACK_TIMEOUT_MS, resolve });
    });
    return { seq, answer };
  }

  answered(ack: Ack): void {
    this.waiting.get(ack.seq)?.resolve(ack);
    this.waiting.delete(ack.seq);
  }

  // Gives up what waited too long.
  expire(nowMs: number): void {
    for (const [seq, one] of this.waiting) {
      if (nowMs < one.dueMs) continue;
      this.waiting.delete(seq);
      one.resolve(refusal(seq, 'no answer from the player within 1 s'));
    }
  }
}

// An answer made here, for what cannot be sent.
export function refusal(seq: number, text: string): Ack {
  return { client: '', seq, ok: false, text };
}

// The player's refusals begin with the verb, those of this page and of the bridge do not.
export function refusalLine(verb: string, text: string): string {
  return text.startsWith(`${verb}:`) ? text : `${verb}: ${text}`;
}
