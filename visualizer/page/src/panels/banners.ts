// Banners over the map: collision or failure, a verdict that differs, stale data, a lost connection.

import { button, el, setText } from '../shell/dom';
import { icon } from '../shell/icons';
import { type BannerText, bannersOf } from './banner_texts';
import type { Context, Panel } from './panel';

const signs = { failed: '✖', differs: '≠', stale: '⏱', disconnected: '⌁', problem: '!' } as const;

interface Shown {
  text: string;
  element: HTMLElement;
}

export function bannersPanel(context: Context): Panel {
  const element = el('div', { class: 'banners' });
  const shown = new Map<BannerText['kind'], Shown>();
  const dismissed = new Map<BannerText['kind'], string>();

  const add = (banner: BannerText): void => {
    const made = bannerElement(context, banner, () => {
      dismissed.set(banner.kind, banner.text);
      update();
    });
    shown.set(banner.kind, { text: banner.text, element: made });
    element.append(made);
  };
  const update = (): void => {
    const wanted = bannersOf(context.viewer.state).filter((b) => dismissed.get(b.kind) !== b.text);
    for (const [kind, { element: old }] of shown) {
      if (wanted.some((banner) => banner.kind === kind)) continue;
      old.remove();
      shown.delete(kind);
    }
    for (const banner of wanted) {
      const now = shown.get(banner.kind);
      if (now === undefined) add(banner);
      else refresh(now, banner);
    }
  };
  return { element, topics: ['source', 'status', 'events', 'case'], everyMs: 100, update };
}

function bannerElement(context: Context, banner: BannerText, onClose: () => void): HTMLElement {
  const urgent = banner.kind === 'failed' || banner.kind === 'differs' || banner.kind === 'problem';
  const made = el(
    'div',
    { class: `banner ${banner.kind}`, role: urgent ? 'alert' : 'status' },
    el('span', { 'aria-hidden': 'true' }, signs[banner.kind]),
    el('span', { class: 'text' }, banner.text),
  );
  if (banner.show !== null) made.append(button('Show', () => show(context)));
  if (urgent) {
    const close = button('', onClose, { class: 'icon-button', 'aria-label': 'Close' });
    close.append(icon('close'));
    made.append(close);
  }
  return made;
}

function refresh(now: Shown, banner: BannerText): void {
  if (now.text === banner.text) return;
  now.text = banner.text;
  const text = now.element.querySelector('.text');
  if (text !== null) setText(text, banner.text);
}

// Goes to 1 s before the collision and centres on it; without one, to the failing command.
function show({ viewer, map }: Context): void {
  const { collisions, caseInfo, failingCommand } = viewer.state;
  const collision = collisions[0];
  if (collision !== undefined) {
    viewer.showCollision(0);
    map()?.centreOn(collision.x, collision.y);
    return;
  }
  const command = caseInfo?.commands[failingCommand];
  if (command !== undefined) viewer.seek(command.tUs);
}
