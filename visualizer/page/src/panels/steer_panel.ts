// Steering the observer by hand: keys WASD and QE or the buttons, while held; stop everything.

import { Mode } from '../../../codec/messages';
import { refusalLine } from '../model/pending_control';
import { button, el, setClass, setHidden, setText } from '../shell/dom';
import { type SteerKey, steerKeys } from '../shell/keys';
import { facts } from './facts';
import { angleText, rateText } from './format';
import { act, type Context, type Panel } from './panel';
import { SteerPad, steerOf } from './steering';

export interface SteerPanel extends Panel {
  press(key: SteerKey): void;
  release(key: SteerKey): void;
  releaseAll(): void;
}

const names: Readonly<Record<SteerKey, string>> = {
  w: 'forward',
  a: 'left',
  s: 'backward',
  d: 'right',
  q: 'turn left',
  e: 'turn right',
};

export function steerPanel(context: Context): SteerPanel {
  const { viewer, settings } = context;
  let steered = -1; // to whom the keys went down
  const pad = new SteerPad(
    ({ roll, pitch, yawRate }) => void send(context, steered, [roll, pitch, yawRate]),
    () => showHeld(),
  );
  const press = (key: SteerKey): void => {
    if (!viewer.state.controlAllowed || viewer.state.observer < 0) return;
    if (pad.keys.size === 0) steered = viewer.state.observer;
    pad.press(key);
  };
  const buttons = new Map(steerKeys.map((key) => [key, padButton(key, press, (k) => pad.release(k))]));
  const readings = facts(['roll', 'pitch', 'yaw']);
  const stop = button('Stop all', () => void act(context, 'stop_all'), {
    class: 'danger',
    title: 'Zero steering of every object, and pause',
  });
  const restart = button('Restart run', () => viewer.restart(), {
    title: 'From its beginning, as a new run',
  });
  const reason = el('p', { class: 'hint', role: 'note' });
  const grid = el('div', { class: 'pad', role: 'group', 'aria-label': 'Steering' }, ...buttons.values());
  const element = el(
    'section',
    { class: 'section', 'aria-label': 'Steer' },
    el('h2', {}, 'Steer (live only)'),
    el('div', { class: 'steer' }, grid, readings.element),
    el('p', { class: 'row' }, stop, restart),
    reason,
  );
  const showHeld = (): void => {
    for (const [key, one] of buttons) setClass(one, 'held', pad.keys.has(key));
  };
  const update = (): void => {
    const { controlAllowed, controlReason, askReason, observer, frame, status } = viewer.state;
    if (!controlAllowed || (pad.keys.size > 0 && observer !== steered)) pad.releaseAll();
    for (const one of buttons.values()) one.disabled = !controlAllowed || observer < 0;
    stop.disabled = !controlAllowed;
    restart.disabled = askReason !== '' || status?.mode !== Mode.live; // also when the flight is over
    const why = controlReason !== '' ? controlReason : unsteered(observer, status?.paused === true);
    setText(reason, why);
    setHidden(reason, why === '');
    const object = frame?.objects.find((o) => o.id === observer);
    const held = steerOf(pad.keys);
    const units = settings.value;
    readings.set('roll', object === undefined ? '–' : angleText(object.roll, units));
    readings.set('pitch', object === undefined ? '–' : angleText(object.pitch, units));
    const yaw =
      held.yawRate !== 0 ? rateText(held.yawRate, units) : angleText(object?.yaw ?? Number.NaN, units);
    readings.set('yaw', yaw);
  };
  return {
    element,
    topics: ['source', 'status', 'selection', 'time'],
    everyMs: 60,
    update,
    press,
    release: (key) => pad.release(key),
    releaseAll: () => pad.releaseAll(),
  };
}

// Why steering does nothing now although it is allowed.
function unsteered(observer: number, paused: boolean): string {
  if (observer < 0) return 'Choose an object first.';
  return paused ? 'Paused: play to see it steered.' : '';
}

// Answers to steering are told only when they are refusals.
async function send(context: Context, object: number, args: readonly number[]): Promise<void> {
  const ack = await context.viewer.control('steer', object, args);
  if (!ack.ok) context.notify(refusalLine('steer', ack.text), true);
}

function padButton(key: SteerKey, press: (key: SteerKey) => void, release: (key: SteerKey) => void) {
  const made = el(
    'button',
    {
      type: 'button',
      class: `key-${key}`,
      'aria-label': `${names[key]} (${key.toUpperCase()})`,
      title: names[key],
    },
    key.toUpperCase(),
  );
  made.addEventListener('pointerdown', (event) => {
    if (event.button === 0) press(key);
  });
  for (const end of ['pointerup', 'pointerleave', 'pointercancel', 'blur']) {
    made.addEventListener(end, () => release(key));
  }
  made.addEventListener('keydown', (event) => {
    if (event.key === ' ' || event.key === 'Enter') press(key);
  });
  made.addEventListener('keyup', (event) => {
    if (event.key === ' ' || event.key === 'Enter') release(key);
  });
  return made;
}
