// What the parts of the columns have in common.

import { refusalLine } from '../model/pending_control';
import type { Topic, Viewer } from '../model/viewer';
import type { MapControls } from '../shell/parts';
import type { SettingsStore } from '../shell/settings';

export interface Panel {
  readonly element: HTMLElement;
  readonly topics: readonly Topic[]; // when to update
  readonly everyMs?: number; // at most so often; without: each animation frame that changes a topic
  update(): void;
}

export interface Context {
  readonly viewer: Viewer;
  readonly settings: SettingsStore;
  notify(line: string, bad?: boolean): void;
  map(): MapControls | null;
}

// Sends to the player, and tells of its answer in one line.
export async function act(
  context: Context,
  verb: string,
  object = -1,
  args: readonly number[] = [],
  text = '',
): Promise<boolean> {
  const ack = await context.viewer.control(verb, object, args, text);
  const name = verb.replaceAll('_', ' ');
  if (ack.ok) context.notify(ack.text === '' ? `${name}: done` : `${name}: ${ack.text}`);
  else context.notify(refusalLine(verb, ack.text), true);
  return ack.ok;
}

// Updates panels: at once for topics without a pace, else at most once in their time.
export class Updates {
  private readonly dueMs = new Map<Panel, number>();
  private readonly waiting = new Set<Panel>();

  constructor(
    private readonly panels: readonly Panel[],
    private readonly now: () => number,
    private readonly later: (ms: number, callback: () => void) => void,
  ) {}

  changed(topics: ReadonlySet<Topic>): void {
    for (const panel of this.panels) if (panel.topics.some((topic) => topics.has(topic))) this.want(panel);
  }

  all(): void {
    for (const panel of this.panels) panel.update();
  }

  private want(panel: Panel): void {
    if (this.waiting.has(panel)) return;
    const waitMs = (this.dueMs.get(panel) ?? 0) - this.now();
    if (waitMs <= 0) {
      this.update(panel);
      return;
    }
    this.waiting.add(panel);
    this.later(waitMs, () => {
      this.waiting.delete(panel);
      this.update(panel);
    });
  }

  private update(panel: Panel): void {
    this.dueMs.set(panel, this.now() + (panel.everyMs ?? 0));
    panel.update();
  }
}
