// What the map shows, how long trails are, and the units of all numbers.

import { el, labelled, setHidden, setOptions } from '../shell/dom';
import { type LayerName, layerNames, trailLengths } from '../shell/settings';
import type { Context, Panel } from './panel';

// The layers with keys are always there, that of map tiles when the bridge has any.
export function layersPanel({ viewer, settings }: Context): Panel {
  const boxes = new Map(
    layerNames.map((name, i) => [name, layerBox(name, i, () => settings.toggleLayer(name))]),
  );
  const trail = el('select', {});
  setOptions(
    trail,
    trailLengths.map((t) => ({ value: String(t), label: t === 'all' ? 'all' : `${t} s` })),
  );
  trail.addEventListener('change', () => {
    settings.update({ trail: trailLengths.find((t) => String(t) === trail.value) ?? 2 });
  });
  const length = el('select', {}, el('option', { value: 'm' }, 'm'), el('option', { value: 'mm' }, 'mm'));
  length.addEventListener('change', () => settings.update({ length: length.value === 'mm' ? 'mm' : 'm' }));
  const angle = el('select', {}, el('option', { value: 'deg' }, '°'), el('option', { value: 'rad' }, 'rad'));
  angle.addEventListener('change', () => settings.update({ angle: angle.value === 'rad' ? 'rad' : 'deg' }));

  const element = el(
    'section',
    { class: 'section', 'aria-label': 'Layers' },
    el('h2', {}, 'Layers', el('span', { class: 'aside' }, 'keys 1–9')),
    el('div', { class: 'layers' }, ...[...boxes.values()].map(({ label }) => label)),
    el(
      'div',
      { class: 'three' },
      labelled('trails', trail),
      labelled('lengths', length),
      labelled('angles', angle),
    ),
  );
  const update = (): void => {
    for (const [name, { box }] of boxes) box.checked = settings.value.layers[name];
    const tiles = boxes.get('tiles');
    if (tiles !== undefined) setHidden(tiles.label, viewer.state.connection.tiles === null);
    trail.value = String(settings.value.trail);
    length.value = settings.value.length;
    angle.value = settings.value.angle;
  };
  return { element, topics: ['source'], update };
}

function layerBox(name: LayerName, index: number, onChange: () => void) {
  const key = index < 9 ? String(index + 1) : undefined;
  const box = el('input', { type: 'checkbox', 'aria-keyshortcuts': key });
  box.addEventListener('change', onChange);
  const swatch = el('span', { class: `swatch ${name}`, 'aria-hidden': 'true' });
  return { box, label: el('label', { class: 'check', title: key && `key ${key}` }, box, swatch, name) };
}
