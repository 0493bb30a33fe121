// What is shown in the map's place while there is no data: how to get some, and where to drop a file.

import { button, el, setHidden, setText } from '../shell/dom';
import type { Context, Panel } from './panel';

export function emptyPanel({ viewer }: Context, open: () => void): Panel {
  const listening = el('p', {});
  const element = el(
    'section',
    { class: 'empty', 'aria-label': 'No data' },
    el('h1', {}, 'No data yet'),
    listening,
    el('p', {}, 'Start the player, for instance:'),
    el('pre', {}, 'make visualizer\nrebar3 proper --watch\nlcm-logplayer cases/<id>/run.lcm'),
    el(
      'div',
      { class: 'drop' },
      el('p', {}, 'or drop a log (.lcm) or a report (.html) here'),
      button('Open a file…', open, { class: 'primary' }),
    ),
  );
  const update = (): void => {
    const { connection, badge } = viewer.state;
    setHidden(element, badge !== 'NO DATA');
    if (connection.kind !== 'socket') setText(listening, 'This page is not connected to a bridge.');
    else if (connection.connected) {
      const group = connection.group === '' ? 'the LCM group' : connection.group;
      setText(listening, `The bridge listens to ${group}: ${connection.packets} packets seen so far.`);
    } else {
      const retry = connection.retryInS > 0 ? `, next try in ${connection.retryInS.toFixed(1)} s` : '';
      setText(listening, `The bridge does not answer${retry}.`);
    }
  };
  return { element, topics: ['source', 'buffer', 'time'], everyMs: 100, update };
}
