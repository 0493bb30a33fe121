// The page around the drawings: places, header, columns, dialogs; joins them with the viewer.

import './theme.css';
import './layout.css';
import './controls.css';
import '../panels/panels.css';
import { activeFaultsPanel } from '../panels/active_faults';
import { bannersPanel } from '../panels/banners';
import { commandsPanel } from '../panels/commands';
import { emptyPanel } from '../panels/empty';
import { eventsPanel } from '../panels/events';
import { caseTitle, headerPanel } from '../panels/header';
import { injectPanel } from '../panels/inject_form';
import { layersPanel } from '../panels/layers';
import { mapButtonsPanel } from '../panels/map_buttons';
import { objectsPanel } from '../panels/objects';
import { observerPanel } from '../panels/observer';
import { type Context, Updates } from '../panels/panel';
import { runControlsPanel } from '../panels/run_controls';
import { shrinkingPanel } from '../panels/shrinking';
import { steerPanel } from '../panels/steer_panel';
import { tabs } from '../panels/tabs';
import { transportPanel } from '../panels/transport';
import { bannersOf } from '../panels/banner_texts';
import type { ViewerState } from '../model/viewer';
import { el, setClass } from './dom';
import { drawers } from './drawers';
import { acceptDrops, filePicker } from './files';
import { helpDialog } from './help';
import { listenToKeys } from './keyboard';
import { notices } from './notices';
import { alarmOf, showAlarm } from './page_icon';
import type { MapControls, MountShell } from './parts';
import { openCase, openFile, saveMapSvg, savePicture, saveReport } from './saving';
import { followTheme, otherTheme } from './theme';

export const mountShell: MountShell = (root, viewer, settings, outside) => {
  followTheme(settings);
  let map: MapControls | null = null;
  const lines = notices();
  const context: Context = { viewer, settings, notify: lines.show, map: () => map };
  const picker = filePicker((file) => void openFile(context, file));
  const help = helpDialog();
  const columns = drawers();
  const theme = (): void => settings.update({ theme: otherTheme(settings) });
  const report = (): void => void saveReport(context);
  const picture = (): void => void savePicture(context);

  const header = headerPanel(context, {
    open: picker.open,
    report,
    picture,
    vector: () => void saveMapSvg(context),
    theme,
    help: () => help.showModal(),
    drawer: columns.toggle,
    chooseCase: (id) => void openCase(context, outside, id),
    listCases: outside.listCases,
  });
  const left = [
    commandsPanel(context),
    objectsPanel(context),
    eventsPanel(context),
    shrinkingPanel(context),
  ] as const;
  const layers = layersPanel(context);
  const steer = steerPanel(context);
  const right = [
    observerPanel(context),
    activeFaultsPanel(context),
    injectPanel(context),
    steer,
    runControlsPanel(context),
  ];
  const transport = transportPanel(context);
  const banners = bannersPanel(context);
  const mapButtons = mapButtonsPanel(context);
  const empty = emptyPanel(context, picker.open);

  const mapHost = el('div', { class: 'map-host' });
  const timelineHost = el('div', { class: 'timeline-host' });
  const curvesHost = el('div', { class: 'curves-host' });
  const stage = el(
    'main',
    { class: 'stage' },
    mapHost,
    mapButtons.element,
    empty.element,
    banners.element,
    lines.element,
  );
  const [commands, objects, events, shrinking] = left;
  columns.left.append(
    tabs('Case', [
      { label: 'Commands', content: commands.element },
      { label: 'Objects', content: objects.element },
      { label: 'Events', content: events.element },
    ]),
    shrinking.element,
    layers.element,
  );
  columns.right.append(...right.map(({ element }) => element));
  root.replaceChildren(
    header.element,
    columns.left,
    stage,
    el('section', { class: 'bottom', 'aria-label': 'Time' }, transport.element, timelineHost, curvesHost),
    columns.right,
    help,
    picker.element,
  );

  acceptDrops(stage, (file) => void openFile(context, file));
  listenToKeys(context, {
    stage,
    pad: steer.element,
    steer,
    transport,
    theme,
    report,
    picture,
    help: () => help.showModal(),
    clear: () => {
      columns.close();
      lines.clear();
    },
  });

  const panels = [header, ...left, layers, ...right, transport, mapButtons, banners, empty];
  const updates = new Updates(
    panels,
    () => performance.now(),
    (ms, callback) => void setTimeout(callback, ms),
  );
  viewer.listen((changed) => {
    updates.changed(changed);
    if (changed.has('source') || changed.has('status') || changed.has('events'))
      showState(stage, viewer.state);
  });
  settings.listen(() => updates.all());
  updates.all();
  showState(stage, viewer.state);
  return { mapHost, timelineHost, curvesHost, attachMap: (controls) => (map = controls), notify: lines.show };
};

// The signs of a state outside of the panels: a grey map, the tab's title and icon.
function showState(stage: HTMLElement, state: ViewerState): void {
  setClass(stage, 'disconnected', state.badge === 'DISCONNECTED');
  const alarm = alarmOf(state);
  const told = bannersOf(state).find(({ kind }) => kind === alarm)?.text ?? '';
  showAlarm(alarm, state.caseInfo === null ? '' : caseTitle(state.caseInfo), told);
}
