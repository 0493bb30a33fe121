// A report: this page with a log inside (docs/visualizer.md), and the log of what a viewer holds.

import { writeLog } from '../../../codec/log';
import type { Message } from '../../../codec/messages';
import { encodeMessage } from '../../../codec/viz';

// A larger report is made again with fewer and fewer frames a second.
const maxReportBytes = 20e6;
const thinnedHz: readonly number[] = [20, 10, 5, 2, 1];

// In the order given; times are simulated, so that lcm-logplayer keeps the pace.
export function logOf(messages: readonly Message[]): Uint8Array<ArrayBuffer> {
  let timeUs = 0;
  return writeLog(
    messages.map((message) => {
      if ('tUs' in message.value) timeUs = Math.max(timeUs, message.value.tUs);
      return { timeUs, channel: message.channel, data: encodeMessage(message) };
    }),
  );
}

// At most `hz' frames and contours in a simulated second, the first and last always.
export function thinned(messages: readonly Message[], hz: number): Message[] {
  const periodUs = 1e6 / hz;
  const next = new Map<string, number>();
  const last = new Map(messages.map((message) => [message.channel, message]));
  return messages.filter((message) => {
    if (message.channel !== 'VIZ_FRAME' && message.channel !== 'VIZ_RISK') return true;
    const dueUs = next.get(message.channel) ?? -Infinity;
    if (message.value.tUs < dueUs && last.get(message.channel) !== message) return false;
    next.set(message.channel, message.value.tUs + periodUs);
    return true;
  });
}

// The page's own text without what it has shown since: empty, and without a log.
export function pageText(page: Document): string {
  const root = page.documentElement.cloneNode(true) as HTMLElement;
  root.removeAttribute('data-theme');
  root.querySelector('#app')?.replaceChildren();
  root.querySelector('#log')?.remove();
  root.querySelector('#icon')?.setAttribute('href', 'data:,');
  return `<!doctype html>\n${root.outerHTML}\n`;
}

export function withLog(page: string, title: string, base64: string): string {
  const element = `<script type="application/gzip" id="log" data-name="${escaped(title)}">${base64}</script>\n`;
  const end = page.lastIndexOf('</body>');
  if (end < 0) throw new Error('the page has no </body> to put a log before');
  return page.slice(0, end) + element + page.slice(end);
}

export function escaped(text: string): string {
  const entities: Readonly<Record<string, string>> = {
    '&': '&amp;',
    '<': '&lt;',
    '>': '&gt;',
    '"': '&quot;',
  };
  return text.replace(/[&<>"]/g, (character) => entities[character] ?? character);
}

export async function gzipped(bytes: Uint8Array<ArrayBuffer>): Promise<Uint8Array<ArrayBuffer>> {
  const stream = new Blob([bytes]).stream().pipeThrough(new CompressionStream('gzip'));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

export function base64(bytes: Uint8Array): string {
  const parts: string[] = [];
  for (let at = 0; at < bytes.length; at += 0x8000) {
    parts.push(String.fromCharCode(...bytes.subarray(at, at + 0x8000)));
  }
  return btoa(parts.join(''));
}

export async function report(
  page: string,
  title: string,
  messages: readonly Message[],
  maxBytes = maxReportBytes,
): Promise<string> {
  const room = ((maxBytes - page.length) * 3) / 4;
  let log = await gzipped(logOf(messages));
  for (const hz of thinnedHz) {
    if (log.length <= room) break;
    log = await gzipped(logOf(thinned(messages, hz)));
  }
  return withLog(page, title, base64(log));
}

// A name for a file that says which case it is of.
export function fileName(caseId: string, ending: string): string {
  const safe = caseId.replace(/[^A-Za-z0-9_-]+/g, '_').slice(0, 64);
  return `${safe === '' ? 'visualizer' : safe}${ending}`;
}
