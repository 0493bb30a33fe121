// Keys of the whole page: what they do is in keys.ts, here it is done.

import { layerNames, speeds } from './settings';
import type { Context } from '../panels/panel';
import type { SteerPanel } from '../panels/steer_panel';
import type { Transport } from '../panels/transport';
import { focusOf, watchPointerFocus } from './focus';
import { type Action, actionOf, isSteerKey, nextSpeed } from './keys';

export interface KeyTargets {
  stage: HTMLElement; // with the map
  pad: HTMLElement;
  steer: SteerPanel;
  transport: Transport;
  theme(): void;
  report(): void;
  picture(): void;
  help(): void;
  clear(): void;
}

export function listenToKeys(context: Context, targets: KeyTargets): void {
  const byPointer = watchPointerFocus(document);
  const act = (event: KeyboardEvent): void => {
    if (event.defaultPrevented || inDialog()) return;
    const action = actionOf({
      key: event.key,
      shift: event.shiftKey,
      command: event.ctrlKey || event.altKey || event.metaKey,
      focus: focusOf(document.activeElement),
      byPointer: byPointer(),
      steering: maySteer(context, targets),
    });
    if (action === null) return;
    event.preventDefault();
    perform(action, context, targets);
  };
  document.addEventListener('keydown', act);
  // Space after a click comes before what was clicked: the buttons of steering listen for themselves.
  const early = (event: KeyboardEvent): void => {
    if (event.key !== ' ' || !byPointer() || inDialog()) return;
    if (focusOf(document.activeElement) === 'text') return;
    if (event.type === 'keydown') act(event);
    if (event.type === 'keyup') event.preventDefault(); // Firefox clicks then
    if (event.defaultPrevented) event.stopPropagation();
  };
  document.addEventListener('keydown', early, true);
  document.addEventListener('keyup', early, true);
  document.addEventListener('keyup', (event) => {
    const key = event.key.toLowerCase();
    if (isSteerKey(key)) targets.steer.release(key);
  });
  const releaseAll = (): void => targets.steer.releaseAll();
  window.addEventListener('blur', releaseAll);
  window.addEventListener('pagehide', releaseAll);
  targets.stage.addEventListener('focusout', releaseAll);
  document.addEventListener('visibilitychange', () => {
    if (document.hidden) releaseAll();
  });
}

function inDialog(): boolean {
  return document.querySelector('dialog[open]') !== null;
}

function maySteer({ viewer }: Context, { stage, pad }: KeyTargets): boolean {
  const focused = document.activeElement;
  const there = focused !== null && (stage.contains(focused) || pad.contains(focused));
  return there && viewer.state.controlAllowed && viewer.state.observer >= 0;
}

function perform(action: Action, context: Context, targets: KeyTargets): void {
  const { viewer, settings } = context;
  const { state } = viewer;
  const map = context.map();
  switch (action.do) {
    case 'playPause':
      if (state.playing) viewer.pause();
      else viewer.play();
      return;
    case 'start':
      targets.transport.toStart();
      return;
    case 'end':
      if (state.badge === 'LIVE' && state.behindS > 0) viewer.toLive();
      else viewer.seek(state.durationUs);
      return;
    case 'frames':
      viewer.step(action.by);
      return;
    case 'seconds':
      viewer.seek(Math.max(0, state.tUs + action.by * 1e6));
      return;
    case 'event':
      viewer.seekEvent(action.by);
      return;
    case 'slower':
      targets.transport.setSpeed(nextSpeed(speeds, targets.transport.speed(), -1));
      return;
    case 'faster':
      targets.transport.setSpeed(nextSpeed(speeds, targets.transport.speed(), 1));
      return;
    case 'loop':
      targets.transport.toggleLoop();
      return;
    case 'object':
      viewer.nextObject(action.by);
      return;
    case 'follow':
      viewer.setFollowed(!state.followed);
      return;
    case 'zoom':
      map?.zoom(action.by);
      return;
    case 'fit':
      map?.fit();
      return;
    case 'measure':
      map?.toggleMeasure();
      return;
    case 'layer':
      settings.toggleLayer(layerNames[action.index] ?? 'grid');
      return;
    case 'dark':
      targets.theme();
      return;
    case 'picture':
      targets.picture();
      return;
    case 'report':
      targets.report();
      return;
    case 'help':
      targets.help();
      return;
    case 'steer':
      targets.steer.press(action.key);
      return;
    case 'clear':
      targets.steer.releaseAll();
      map?.clear();
      targets.clear();
      return;
  }
}
