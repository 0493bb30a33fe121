// The viewer: joins a run's data, playback, selection and the source into viewer.ts's face. The
// world outside (clock, animation frames, log reader, sockets) is passed in.

import { type Ack, type Frame, type Message, Mode } from '../../../codec/messages';
import type { ControlRequest } from '../../../codec/protocol';
import { badgeOf, controlReason } from './badge';
import type { PackedFrame } from './packed_frame';
import type { PackedRisk } from './packed_risk';
import { PendingControl, refusal, refusalLine } from './pending_control';
import { PlayerWatch } from './player_watch';
import { type PlayContext, Playback, type Wish } from './playback';
import { RunData } from './run_data';
import { Selection } from './selection';
import { type Shown, showAgain, shownOfReplay } from './show_again';
import { type Connection, NOT_CONNECTED, type Topic, type Viewer, type ViewerState } from './viewer';
import { stateOf } from './viewer_state';

// One control message; the link adds the token.
export type Asked = Omit<ControlRequest, 'token'>;

// A source of live data, and the way back to the player.
export interface Link {
  send(asked: Asked): void;
  close(): void;
}

// What a link tells.
export interface LinkListener {
  message(message: Message): void;
  connection(change: Partial<Connection>): void;
  granted(control: boolean): void; // whether the bridge lets this page control
}

export interface Surroundings {
  now(): number; // ms of wall time, never backwards
  animationFrame(callback: () => void): void;
  later(ms: number, callback: () => void): void;
  // Resolves with '' or with one line on why reading ended early; rejects with one line.
  readLog(bytes: ArrayBuffer, take: (message: Message) => void): Promise<string>;
  openLink(url: string, listener: LinkListener): Link;
  firstSeq: number; // of control messages; different from page to page
}

// Longer pauses between two animation frames (a page in the background) do not count as playing.
const LONGEST_TICK_S = 0.25;
// Staleness and unanswered controls are looked at this often.
const WATCH_MS = 250;
// While the time line is dragged outside of what is held, one seek in this time goes to the player.
const SEEK_EVERY_MS = 150;
// Wishes that are local as well: without control they are not worth a complaint.
const QUIET_VERBS: readonly string[] = ['pause', 'speed', 'observe'];

export function createViewer(outside: Surroundings): Viewer {
  return new ViewerModel(outside);
}

class ViewerModel implements Viewer {
  readonly state: Readonly<ViewerState>;
  data = new RunData();
  connection: Connection = NOT_CONNECTED;
  shown: PackedFrame | null = null;
  readonly playback = new Playback();
  readonly selection = new Selection();
  private readonly player = new PlayerWatch();
  private link: Link | null = null;
  private granted = false;
  private everConnected = false;
  private readonly pending: PendingControl;
  private readonly listeners = new Set<(changed: ReadonlySet<Topic>) => void>();
  private readonly refusalListeners = new Set<(line: string) => void>();
  private changed = new Set<Topic>();
  private awake = false;
  private watching = false;
  private lastTickMs: number;
  private lastFrameMs = 0;
  private lastSeekMs = -Infinity;
  private laterSeek: Wish | null = null;
  private knownRuns = 0;
  private lastBadge = '';
  private observerChosen = false; // by the user

  constructor(private readonly outside: Surroundings) {
    this.pending = new PendingControl(outside.firstSeq);
    this.lastTickMs = outside.now();
    this.state = stateOf(this);
  }

  listen(listener: (changed: ReadonlySet<Topic>) => void): () => void {
    this.listeners.add(listener);
    return () => void this.listeners.delete(listener);
  }

  onRefusal(listener: (line: string) => void): () => void {
    this.refusalListeners.add(listener);
    return () => void this.refusalListeners.delete(listener);
  }

  // ---- sources

  async openLog(bytes: ArrayBuffer, name: string): Promise<void> {
    const data = new RunData();
    const problem = await this.outside.readLog(bytes, (message) => data.take(message, new Set()));
    if (data.frames.length === 0) {
      throw new Error(`${name}: ${problem === '' ? 'a log without any VIZ_FRAME' : problem}`);
    }
    this.leaveSource();
    this.data = data;
    this.connection = { ...NOT_CONNECTED, kind: 'file', fileName: name, error: problem };
    this.playback.following = false;
    this.playback.tUs = data.frames.first?.tUs ?? 0;
    this.chooseObserver();
    this.touch('source', 'status', 'case', 'world', 'faults');
    this.touch('events', 'time', 'buffer', 'playback', 'selection');
  }

  connect(url: string): void {
    this.leaveSource();
    this.connection = { ...NOT_CONNECTED, kind: 'socket' };
    this.link = this.outside.openLink(url, {
      message: (message) => this.feed(message, this.outside.now()),
      connection: (change) => this.setConnection(change),
      granted: (control) => {
        this.granted = control;
        this.touch('source');
      },
    });
    this.touch('source', 'buffer', 'time');
    this.watch();
  }

  feed(message: Message, receivedMs: number): void {
    if (message.channel === 'VIZ_ACK') {
      this.pending.answered(message.value);
      return;
    }
    const before = this.data.run;
    const other = 'run' in message.value && message.value.run !== before;
    const shown = other ? shownOfReplay(this.data, this.playback) : null; // a new run's data take its place
    this.data.take(message, this.changed);
    const { run, runs } = this.data;
    if (runs !== this.knownRuns) {
      this.beginRun();
      if (this.player.isAnother(run, before, receivedMs)) this.playerRestarted(shown);
    }
    if ('run' in message.value && message.value.run === run) this.player.heard(receivedMs);
    if (message.channel === 'VIZ_FRAME') this.lastFrameMs = receivedMs;
    if (message.channel === 'VIZ_STATUS') this.playback.heardFromPlayer(this.producing);
    this.wake();
  }

  // ---- playback

  play(): void {
    this.move((context) => this.playback.play(context));
  }

  pause(): void {
    this.move((context) => this.playback.pause(context));
  }

  restart(): void {
    this.move((context) => this.playback.restart(context));
  }

  step(frames: number): void {
    this.move((context) => this.playback.step(frames, context));
  }

  seek(tUs: number): void {
    this.move((context) => this.playback.seek(tUs, context));
  }

  seekEvent(direction: 1 | -1): void {
    const tUs = this.data.log.neighbour(this.playback.tUs, direction);
    if (tUs !== null) this.seek(tUs);
  }

  setSpeed(factor: number): void {
    this.move((context) => this.playback.setSpeed(factor, context));
  }

  setLoop(range: { fromUs: number; toUs: number } | null): void {
    this.playback.loop = range;
    this.touch('playback');
  }

  setStopAtCollision(on: boolean): void {
    this.playback.stopAtCollision = on;
    this.touch('playback');
  }

  toLive(): void {
    this.move((context) => this.playback.toLive(context));
  }

  showCollision(index: number): void {
    const collision = this.data.log.collisions[index];
    if (collision === undefined) return;
    this.pause();
    this.seek(Math.max(collision.tUs - 1_000_000, 0));
  }

  // ---- selection

  observe(id: number): void {
    this.observerChosen = id >= 0;
    if (!this.selection.observe(id)) return;
    this.touch('selection');
    if (this.connection.kind === 'socket' && id >= 0) this.perform('observe', id, []);
  }

  nextObject(direction: 1 | -1): void {
    this.observe(this.selection.neighbour(this.shown?.layout.ids ?? new Int32Array(), direction));
  }

  setFollowed(on: boolean): void {
    this.selection.followed = on && this.selection.observer >= 0;
    this.touch('selection');
  }

  pin(id: number, on: boolean): void {
    if (this.selection.pin(id, on)) this.touch('selection');
  }

  // ---- to the player

  control(verb: string, object = -1, args: readonly number[] = [], text = ''): Promise<Ack> {
    const reason = this.sendingReason;
    if (this.link === null || reason !== '') return Promise.resolve(refusal(0, reason));
    const { seq, answer } = this.pending.begin(this.outside.now());
    this.link.send({ seq, verb, object, args: [...args], text });
    return answer;
  }

  // ---- for drawings

  framesBetween(fromUs: number, toUs: number): readonly Frame[] {
    return this.data.framesBetween(fromUs, toUs);
  }

  held(): readonly Message[] {
    return this.data.held();
  }

  get packed(): Viewer['packed'] {
    return { frames: this.data.frames, shown: this.shown, risk: this.risk };
  }

  get risk(): PackedRisk | null {
    return this.data.riskAt(this.selection.observer, this.playback.tUs);
  }

  get frameAgeS(): number {
    return Math.max(0, (this.outside.now() - this.lastFrameMs) / 1000);
  }

  get badge(): ReturnType<typeof badgeOf> {
    return badgeOf({
      source: this.connection.kind,
      connected: this.connection.connected,
      everConnected: this.everConnected,
      hasFrames: this.shown !== null || this.data.frames.length > 0,
      status: this.data.status,
      frameAgeS: this.frameAgeS,
    });
  }

  get reason(): string {
    const { kind, connected } = this.connection;
    return controlReason(kind, connected, this.data.status, this.granted);
  }

  get askReason(): string {
    const { status } = this.data;
    if (status === null) return this.sendingReason || 'no player answers';
    return this.sendingReason || (status.controlAllowed ? '' : 'the player was started without control');
  }

  get producing(): boolean {
    const status = this.data.status;
    const { kind, connected } = this.connection;
    if (kind !== 'socket' || !connected) return false;
    // Without any status (a bare log player) frames that come are the only sign.
    return status === null ? this.frameAgeS < 1 : !status.paused && status.mode !== Mode.idle;
  }

  get durationUs(): number {
    const toUs = this.data.frames.last?.tUs ?? 0;
    const commands = this.data.caseInfo?.commands ?? [];
    const told = this.connection.kind === 'socket' ? (this.data.status?.durationUs ?? 0) : 0;
    return Math.max(toUs, told, commands[commands.length - 1]?.tUs ?? 0);
  }

  // Whether anything comes after durationUs. Nothing tells of a bare log player's end.
  get ends(): boolean {
    const { status } = this.data;
    return status === null || status.durationUs >= 0 || status.verdict !== 0;
  }

  // A player shows a replay from its beginning when asked.
  get startUs(): number {
    const { kind, connected } = this.connection;
    const asks = kind === 'socket' && connected && this.data.status?.mode === Mode.replay;
    return asks ? 0 : (this.data.frames.first?.tUs ?? 0);
  }

  // Why nothing can be sent, '' when it can.
  private get sendingReason(): string {
    if (this.connection.kind !== 'socket') return 'no player is connected';
    if (!this.connection.connected) return 'disconnected from the bridge';
    return this.granted ? '' : 'the bridge was started without --allow-control';
  }

  private leaveSource(): void {
    this.link?.close();
    this.link = null;
    this.granted = false;
    this.everConnected = false;
    this.data = new RunData();
    this.knownRuns = 0;
    this.shown = null;
    this.playback.reset(false);
    this.selection.reset();
    this.observerChosen = false;
  }

  private setConnection(change: Partial<Connection>): void {
    this.connection = { ...this.connection, ...change };
    if (change.connected === true) this.everConnected = true;
    if (change.connected === true) this.player.heard(this.outside.now());
    if (change.connected === false) this.granted = false;
    this.touch('source');
  }

  private beginRun(): void {
    this.knownRuns = this.data.runs;
    this.playback.reset(this.producing || this.data.status === null);
    this.changed.add('playback');
    this.changed.add('time');
  }

  private playerRestarted(shown: Shown | null): void {
    this.complain('player restarted');
    if (shown === null || this.sendingReason !== '') return;
    void showAgain(shown, (verb, args, text) => this.control(verb, -1, args, text)).then((refused) => {
      if (refused !== '') this.complain(refused);
    });
  }

  private complain(line: string): void {
    for (const listener of this.refusalListeners) listener(line);
  }

  // Without a choice of the user's, the one whose contours come is looked at, else the first.
  private chooseObserver(): void {
    const ids = this.data.frames.last?.layout.ids;
    if (ids === undefined || ids.length === 0) return;
    if (this.observerChosen && ids.includes(this.selection.observer)) return;
    const told = this.data.observers.filter((id) => ids.includes(id));
    if (told.includes(this.selection.observer)) return;
    const wanted = told[0] ?? ids[0] ?? -1;
    if (this.selection.observe(wanted)) this.changed.add('selection');
  }

  // ---- time

  private move(action: (context: PlayContext) => Wish[]): void {
    for (const wish of action(this.context())) this.grant(wish);
    this.touch('playback', 'time');
  }

  private grant(wish: Wish): void {
    if (wish.verb !== 'seek') {
      this.perform(wish.verb, -1, wish.args);
      return;
    }
    this.laterSeek = wish;
    this.sendSeek();
  }

  private sendSeek(): void {
    const now = this.outside.now();
    if (this.laterSeek === null || now - this.lastSeekMs < SEEK_EVERY_MS) return;
    this.perform('seek', -1, this.laterSeek.args);
    this.laterSeek = null;
    this.lastSeekMs = now;
  }

  private perform(verb: string, object: number, args: readonly number[]): void {
    if (this.sendingReason !== '' && QUIET_VERBS.includes(verb)) return;
    void this.control(verb, object, args).then((ack) => {
      if (!ack.ok) this.complain(refusalLine(verb, ack.text));
    });
  }

  private context(): PlayContext {
    const frames = this.data.frames;
    const { kind, connected } = this.connection;
    const { status } = this.data;
    const live = status?.mode === Mode.live;
    const toUs = frames.last?.tUs ?? 0;
    const replay = kind === 'file' || status?.mode === Mode.replay;
    return {
      source: kind === 'socket' && !connected ? 'file' : kind,
      fromUs: frames.first?.tUs ?? 0,
      toUs,
      empty: frames.length === 0,
      // A flight that is over does not wait for the commands that were to come.
      durationUs: live && status.verdict !== 0 ? toUs : this.durationUs,
      ends: this.ends,
      live,
      mayAsk: this.sendingReason === '',
      producing: this.producing,
      stopsUs: replay ? this.data.log.collisions.map((collision) => collision.tUs) : [],
      frameTime: (tUs, count) => {
        const index = frames.indexAt(tUs) + count;
        return frames.at(Math.max(0, Math.min(frames.length - 1, index)))?.tUs ?? tUs;
      },
    };
  }

  private touch(...topics: readonly Topic[]): void {
    for (const topic of topics) this.changed.add(topic);
    this.wake();
  }

  private wake(): void {
    if (this.awake) return;
    this.lastTickMs = this.outside.now(); // time asleep is not time played
    this.nextTick();
  }

  private nextTick(): void {
    this.awake = true;
    this.outside.animationFrame(() => this.tick());
  }

  private tick(): void {
    this.awake = false;
    const now = this.outside.now();
    const seconds = Math.min(Math.max((now - this.lastTickMs) / 1000, 0), LONGEST_TICK_S);
    this.lastTickMs = now;
    this.advance(seconds);
    if (this.playback.playing && !this.playback.following) this.nextTick();
    this.tell();
  }

  private advance(seconds: number): void {
    const { tUs, playing, following } = this.playback;
    for (const wish of this.playback.advance(seconds, this.context())) this.grant(wish);
    if (this.playback.playing !== playing || this.playback.following !== following) {
      this.changed.add('playback');
    }
    const frames = this.data.frames;
    const frame = frames.at(Math.max(0, frames.indexAt(this.playback.tUs)));
    if (frame !== null && frame !== this.shown) {
      this.shown = frame;
      this.changed.add('time');
    }
    if (this.playback.tUs !== tUs) this.changed.add('time');
    this.chooseObserver();
  }

  private tell(): void {
    if (this.changed.size === 0) return;
    const changed = this.changed;
    this.changed = new Set();
    for (const listener of this.listeners) listener(changed);
  }

  private watch(): void {
    if (this.watching || this.connection.kind !== 'socket') return;
    this.watching = true;
    this.outside.later(WATCH_MS, () => {
      this.watching = false;
      this.pending.expire(this.outside.now());
      this.sendSeek();
      const badge = this.badge;
      if (badge !== this.lastBadge || badge === 'STALE') this.touch('source');
      this.lastBadge = badge;
      this.watch();
    });
  }
}
