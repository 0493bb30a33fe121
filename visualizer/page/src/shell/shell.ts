// The page around the drawings: places, header, columns, keys, dialogs.

import './theme.css';
import './layout.css';
import { el } from './dom';
import type { MapControls, MountShell } from './parts';

export const mountShell: MountShell = (root, _viewer, _settings, _outside) => {
  const mapHost = el('div', { class: 'map-host' });
  const timelineHost = el('div', { class: 'timeline-host' });
  const curvesHost = el('div', { class: 'curves-host' });
  root.replaceChildren(
    el('header', { class: 'header' }),
    el('aside', { class: 'column left', 'aria-label': 'Case' }),
    el('main', { class: 'stage' }, mapHost),
    el('section', { class: 'bottom', 'aria-label': 'Time' }, el('div'), timelineHost, curvesHost),
    el('aside', { class: 'column right', 'aria-label': 'Object and control' }),
  );
  let map: MapControls | null = null;
  return {
    mapHost,
    timelineHost,
    curvesHost,
    attachMap: (controls) => {
      map = controls;
    },
    notify: () => void map,
  };
};
