// What the bridge says to the terminal: one line each. Refusals of one kind beyond 20 a second are counted and
// summed up in one line, so that no flood fills a disk.

export type Refusal = 'packet' | 'request' | 'control';

const perSecond = 20;

// Text of others on one line of a terminal: no control characters, at most 300 characters.
const plain = (text: string): string => text.replace(/\p{Cc}+/gu, ' ').slice(0, 300);

export class Journal {
  private readonly write: (line: string) => void;
  private readonly now: () => number;
  private readonly windows = new Map<Refusal, { since: number; lines: number; more: number }>();

  constructor(write: (line: string) => void, now: () => number = () => performance.now()) {
    this.write = write;
    this.now = now;
  }

  say(text: string): void {
    this.write(`bridge: ${plain(text)}`);
  }

  refused(kind: Refusal, text: string): void {
    const now = this.now();
    const window = this.windows.get(kind) ?? { since: now, lines: 0, more: 0 };
    this.windows.set(kind, window);
    if (now - window.since >= 1000) {
      this.flush(kind);
      Object.assign(window, { since: now, lines: 0 });
    }
    window.lines += 1;
    if (window.lines <= perSecond) this.say(`refused: ${text}`);
    else window.more += 1;
  }

  // Says how many refusals had no line of their own; called each second and at the end.
  flush(...kinds: Refusal[]): void {
    for (const kind of kinds.length > 0 ? kinds : this.windows.keys()) {
      const window = this.windows.get(kind);
      if (!window || window.more === 0) continue;
      this.say(`refused: ${window.more} more of this kind (${kind})`);
      window.more = 0;
    }
  }
}
