// Where the page begins: viewer, shell and drawings are joined, and a source of data is found.
import './main.css';
import { createCurves } from './curves/curves';
import { timeSvg } from './curves/time_svg';
import { createMap } from './map/map_view';
import { createTimeAxis } from './model/time_axis';
import { mountShell } from './shell/shell';
import { saveSvg } from './shell/saving';
import { createSettings } from './shell/settings';
import { beginAgain } from './source/begin_again';
import { browserViewer, bridgeUrl } from './source/browser';
import { fetchCase, listCases } from './source/case_list';
import { embeddedLog } from './source/embedded_log';
import { browserAddress, followFragment } from './source/follow_fragment';
import { parseFragment } from './source/fragment';
import { fetchTile } from './source/tile';
import { createTimeline } from './timeline/timeline';

function memory(): Storage | null {
  try {
    return localStorage;
  } catch {
    return null; // a page from a file may not have any
  }
}

async function begin(root: HTMLElement): Promise<void> {
  const settings = createSettings(memory());
  const viewer = browserViewer();
  const socket = bridgeUrl(location);
  const bridge = location.origin;
  const outside =
    socket === null
      ? {}
      : { listCases: () => listCases(bridge), fetchCase: (id: string) => fetchCase(bridge, id) };
  const shell = mountShell(root, viewer, settings, outside);
  const map = createMap(shell.mapHost, viewer, settings, {
    load: (z, x, y) => fetchTile(bridge, z, x, y),
    complain: (line) => shell.notify(line, true),
  });
  const axis = createTimeAxis();
  const timeline = createTimeline(shell.timelineHost, viewer, axis);
  const curves = createCurves(shell.curvesHost, viewer, axis, () => {
    saveSvg(viewer.state, 'curves', timeSvg(timeline, curves, viewer), shell.notify);
  });
  shell.attachMap(map);
  viewer.onRefusal((line) => shell.notify(line, true));
  const loadCase = async (id: string): Promise<void> => {
    const ack = await viewer.control('load', -1, [0], id);
    if (ack.ok) return;
    if (socket === null) throw new Error(ack.text);
    await viewer.openLog(await fetchCase(bridge, id), id);
  };
  const still = matchMedia('(prefers-reduced-motion: reduce)').matches;
  if (!still && parseFragment(location.hash).tUs === null) beginAgain(viewer);
  followFragment(
    viewer,
    browserAddress(window),
    loadCase,
    (ms, callback) => void setTimeout(callback, ms),
    (line) => shell.notify(line, true),
  );
  if (__VIZ_TEST__) window.__viz = { stats: () => map.stats(), state: () => viewer.state, viewer };
  try {
    const log = await embeddedLog(document);
    if (log !== null) await viewer.openLog(log.bytes, log.name);
    else if (socket !== null) viewer.connect(socket);
  } catch (error) {
    shell.notify(error instanceof Error ? error.message : String(error), true);
  }
}

const root = document.querySelector<HTMLElement>('#app');
if (root !== null) void begin(root);
