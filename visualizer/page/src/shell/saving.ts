// Opening files and cases, saving reports and pictures; each failure is one line.

import type { Context } from '../panels/panel';
import { caseTitle } from '../panels/header';
import { secondsText } from '../panels/format';
import { refusalLine } from '../model/pending_control';
import type { ViewerState } from '../model/viewer';
import { embeddedLog } from '../source/embedded_log';
import { save } from './files';
import type { Outside } from './parts';
import { fileName, pageText, report } from './report';

export async function openFile(context: Context, file: File): Promise<void> {
  await attempt(context, file.name, async () => {
    const bytes = /\.html?$/i.test(file.name)
      ? await logInReport(await file.text(), file.name)
      : await file.arrayBuffer();
    await context.viewer.openLog(bytes, file.name);
  });
}

// A case of the bridge: played by the player when it may be asked, else read as a file.
export async function openCase(context: Context, outside: Outside, id: string): Promise<void> {
  if (id === '' || id === context.viewer.state.caseInfo?.caseId) return;
  const { viewer } = context;
  if (viewer.state.connection.kind === 'socket' && viewer.state.status !== null) {
    const ack = await viewer.control('load', -1, [0], id);
    if (ack.ok) return;
    context.notify(`${refusalLine('load', ack.text)}; opened as a file`, true);
  }
  await attempt(context, `case ${id}`, async () => {
    if (outside.fetchCase === undefined) throw new Error(`case ${id}: there is no bridge to fetch it from`);
    await viewer.openLog(await outside.fetchCase(id), id);
  });
}

export async function saveReport(context: Context): Promise<void> {
  const { state } = context.viewer;
  if (state.frame === null) return;
  await attempt(context, 'report', async () => {
    const title = state.caseInfo === null ? 'recording' : caseTitle(state.caseInfo);
    const text = await report(pageText(document), title, context.viewer.held());
    const name = fileName(state.caseInfo?.caseId ?? '', '.html');
    save(name, new Blob([text], { type: 'text/html' }));
    context.notify(`saved ${name}, ${(text.length / 1e6).toFixed(2)} MB`);
  });
}

export async function savePicture(context: Context): Promise<void> {
  await attempt(context, 'screenshot', async () => {
    const { caseInfo, tUs } = context.viewer.state;
    const name = fileName(`${caseInfo?.caseId ?? 'map'}_${secondsText(tUs, 2)}s`, '.png');
    const picture = await context.map()?.picture();
    if (picture === undefined) throw new Error('there is no map to save');
    save(name, picture);
    context.notify(`saved ${name}`);
  });
}

export async function saveMapSvg(context: Context): Promise<void> {
  await attempt(context, 'SVG', async () => {
    const map = context.map();
    if (map === null) throw new Error('there is no map to save');
    saveSvg(context.viewer.state, 'map', map.svg(), context.notify);
  });
}

// Saves a drawing as a file that is named after case, moment and what it shows.
export function saveSvg(
  { caseInfo, tUs }: Pick<ViewerState, 'caseInfo' | 'tUs'>,
  what: string,
  document: string,
  notify: (line: string) => void,
): void {
  const name = fileName(`${caseInfo?.caseId ?? 'run'}_${what}_${secondsText(tUs, 2)}s`, '.svg');
  save(name, new Blob([document], { type: 'image/svg+xml' }));
  notify(`saved ${name}`);
}

// `what' begins the line, where the line does not say it itself.
async function attempt(context: Context, what: string, work: () => Promise<void>): Promise<void> {
  try {
    await work();
  } catch (error) {
    const line = error instanceof Error ? error.message : String(error);
    context.notify(line.startsWith(what) ? line : `${what}: ${line}`, true);
  }
}

async function logInReport(text: string, name: string): Promise<ArrayBuffer> {
  const log = await embeddedLog(new DOMParser().parseFromString(text, 'text/html'));
  if (log === null) throw new Error(`${name}: not an LCM log or a report`);
  return log.bytes;
}
