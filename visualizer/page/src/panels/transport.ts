// The bar with which time is moved.

import type { SourceKind, ViewerState } from '../model/viewer';
import { button, el, setHidden, setOptions, setText } from '../shell/dom';
import { type IconName, icon } from '../shell/icons';
import { speeds } from '../shell/settings';
import { secondsText, speedFactorText } from './format';
import type { Context, Panel } from './panel';

export interface Transport extends Panel {
  toStart(): void;
  toggleLoop(): void;
  speed(): number; // that of what is seen
  setSpeed(factor: number): void;
}

export function transportPanel(context: Context): Transport {
  const { viewer, settings } = context;
  const start = iconButton('start', 'To the start (Home)', () => toStart());
  const back = iconButton('back', 'One frame back (,)', () => viewer.step(-1));
  const play = iconButton(
    'play',
    'Play (Space)',
    () => (viewer.state.playing ? viewer.pause() : viewer.play()),
    'play',
  );
  const next = iconButton('forward', 'One frame on (.)', () => viewer.step(1));
  const time = el('span', { class: 'clock' });
  const speed = el('select', { 'aria-label': 'Speed' });
  const loop = el('button', { type: 'button', title: 'Loop the selection of the timeline, or all (L)' });
  loop.append(icon('loop'), 'Loop');
  const previousEvent = iconButton('previousEvent', 'Previous event ([)', () => viewer.seekEvent(-1));
  const nextEvent = iconButton('nextEvent', 'Next event (])', () => viewer.seekEvent(1));
  const stop = el('input', { type: 'checkbox' });
  const stopLabel = el(
    'label',
    { class: 'check', title: 'A replay stops where objects collide' },
    stop,
    'stop at collision',
  );
  const behind = el('span', { class: 'warn' });
  const toLive = button('Go live', () => viewer.toLive());
  const run = el('span', { class: 'aside' });

  const toStart = (): void => viewer.seek(viewer.state.startUs);
  let source: SourceKind = 'none';
  let lastLoop: { fromUs: number; toUs: number } | null = null;
  const toggleLoop = (): void => {
    const { loop: now, fromUs, toUs } = viewer.state;
    if (now !== null) viewer.setLoop(null);
    else if (toUs > fromUs) viewer.setLoop(lastLoop ?? { fromUs, toUs });
  };
  // At the edge of live data it is the player's, who may have been asked by another page.
  const speedSeen = (): number => {
    const { following, status, speed: own } = viewer.state;
    return following && status !== null ? Number(status.speed.toPrecision(6)) : own; // a 32-bit float
  };
  const setSpeed = (factor: number): void => {
    viewer.setSpeed(factor);
    settings.update({ speed: factor });
  };
  loop.addEventListener('click', toggleLoop);
  speed.addEventListener('change', () => setSpeed(Number(speed.value)));
  stop.addEventListener('change', () => viewer.setStopAtCollision(stop.checked));

  const element = el(
    'div',
    { class: 'transport', role: 'toolbar', 'aria-label': 'Playback' },
    ...[start, back, play, next, time, speed, loop, previousEvent, nextEvent, stopLabel, behind, toLive, run],
  );
  const update = (): void => {
    const { state } = viewer;
    const empty = state.frame === null;
    if (state.connection.kind === 'file' && source !== 'file') viewer.setSpeed(settings.value.speed);
    source = state.connection.kind;
    for (const control of [start, back, play, next, loop, previousEvent, nextEvent]) control.disabled = empty;
    showPlaying(play, state.playing);
    setText(time, empty ? '–' : timeText(state.tUs, state.durationUs, state.badge === 'LIVE'));
    setOptions(speed, speedOptions(speedSeen()), String(speedSeen()));
    if (state.loop !== null) lastLoop = state.loop;
    loop.setAttribute('aria-pressed', String(state.loop !== null));
    stop.checked = state.stopAtCollision;
    const late = state.badge === 'LIVE' && state.behindS >= 0.05;
    setText(behind, late ? `behind live by ${state.behindS.toFixed(1)} s` : '');
    setHidden(toLive, !late && !isPausedLive(state));
    setText(
      run,
      empty
        ? ''
        : `run ${state.run} · frame ${state.frame?.seq ?? 0}${state.thinned ? ' · old frames thinned' : ''}`,
    );
  };
  return {
    element,
    topics: ['time', 'playback', 'status', 'buffer', 'source'],
    everyMs: 33,
    update,
    speed: speedSeen,
    toStart,
    toggleLoop,
    setSpeed,
  };
}

// A flight that goes on when it is told to.
function isPausedLive({ badge, status }: Pick<ViewerState, 'badge' | 'status'>): boolean {
  return badge === 'LIVE' && status !== null && status.paused && status.verdict === 0;
}

function timeText(tUs: number, durationUs: number, live: boolean): string {
  return live ? `${secondsText(tUs)} s` : `${secondsText(tUs)} / ${secondsText(durationUs, 2)} s`;
}

function speedOptions(now: number): { value: string; label: string }[] {
  const all = speeds.includes(now) ? speeds : [...speeds, now].sort((a, b) => a - b);
  return all.map((factor) => ({ value: String(factor), label: speedFactorText(factor) }));
}

function iconButton(name: IconName, label: string, onClick: () => void, className = ''): HTMLButtonElement {
  const made = button('', onClick, { class: `icon-button ${className}`, 'aria-label': label, title: label });
  made.append(icon(name));
  return made;
}

function showPlaying(play: HTMLButtonElement, playing: boolean): void {
  const label = playing ? 'Pause (Space)' : 'Play (Space)';
  if (play.getAttribute('aria-label') === label) return;
  play.setAttribute('aria-label', label);
  play.title = label;
  play.replaceChildren(icon(playing ? 'pause' : 'play'));
}
