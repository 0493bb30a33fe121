// What is done to the map without a wheel and a mouse: zooming, fitting, following, measuring.

import { button, el } from '../shell/dom';
import type { Context, Panel } from './panel';

export function mapButtonsPanel(context: Context): Panel {
  const { viewer } = context;
  const follow = button('Follow', () => viewer.setFollowed(!viewer.state.followed), {
    title: 'The map follows the observer (C)',
  });
  const measure = button(
    'Measure',
    () => {
      context.map()?.toggleMeasure();
      update();
    },
    { title: 'Measure a distance (M; also Shift and drag)' },
  );
  const element = el(
    'div',
    { class: 'map-buttons', role: 'group', 'aria-label': 'Map' },
    button('+', () => context.map()?.zoom(1), { 'aria-label': 'Zoom in (=)', title: 'Zoom in (=)' }),
    button('−', () => context.map()?.zoom(-1), { 'aria-label': 'Zoom out (-)', title: 'Zoom out (-)' }),
    button('Fit', () => context.map()?.fit(), { title: 'Fit everything (F)' }),
    follow,
    measure,
  );
  const update = (): void => {
    const { frame, observer, followed } = viewer.state;
    element.hidden = frame === null;
    follow.disabled = observer < 0;
    follow.setAttribute('aria-pressed', String(followed));
    measure.setAttribute('aria-pressed', String(context.map()?.measuring() ?? false));
  };
  return { element, topics: ['selection', 'source', 'time'], everyMs: 100, update };
}
