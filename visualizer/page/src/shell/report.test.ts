import { gunzipSync } from 'node:zlib';
import { expect, test } from 'vitest';
import { readLog } from '../../../codec/log';
import type { Message } from '../../../codec/messages';
import { decodeMessage } from '../../../codec/viz';
import { aCase, aFrame, anEvent, anObject, aRisk } from '../model/testing';
import { base64, escaped, fileName, logOf, report, thinned, withLog } from './report';

const page = '<!doctype html>\n<html><body><div id="app"></div>\n</body></html>\n';

function logIn(html: string): Message[] {
  const text =
    /<script type="application\/gzip" id="log"[^>]*>([^<]*)<\/script>\n<\/body>/.exec(html)?.[1] ?? '';
  const { messages, problem } = readLog(new Uint8Array(gunzipSync(Buffer.from(text, 'base64'))));
  expect(problem).toBe('');
  return messages.map(({ channel, data }) => {
    const decoded = decodeMessage(channel, data);
    if (!decoded.ok) throw new Error(decoded.error);
    return decoded.message;
  });
}

const run: Message[] = [
  { channel: 'VIZ_CASE', value: aCase([0, 500_000]) },
  aFrame(0),
  { channel: 'VIZ_EVENT', value: anEvent({ tUs: 500_000, kind: 'collision', text: '</script> Q1 & Q2' }) },
  aFrame(500_000),
];

test('what a report holds comes out of it again', async () => {
  expect(logIn(await report(page, 'case 7', run))).toEqual(run);
});

test('times in the log are simulated ones and never go back', () => {
  const { messages } = readLog(logOf(run));
  expect(messages.map(({ timeUs }) => timeUs)).toEqual([0, 0, 500_000, 500_000]);
  expect(messages.map(({ number }) => number)).toEqual([0, 1, 2, 3]);
});

test('a title cannot end the element that it is written into', () => {
  const html = withLog(page, '"><script>alert("&")</script>', 'AAAA');
  expect(html).toContain('data-name="&quot;&gt;&lt;script&gt;alert(&quot;&amp;&quot;)&lt;/script&gt;"');
  expect(html.match(/<script/g)).toHaveLength(1);
  expect(escaped('a<b')).toBe('a&lt;b');
});

test('the log goes before the last </body>, and a page without one is refused', () => {
  const twice = page.replace('<div', '<p title="</body>"></p><div');
  expect(withLog(twice, 't', 'AAAA')).toMatch(
    /<div id="app"><\/div>\n<script [^>]*>AAAA<\/script>\n<\/body><\/html>\n$/,
  );
  expect(() => withLog('<p>', 't', 'AAAA')).toThrow('the page has no </body>');
});

test('thinning keeps 20 frames and contours a second, the first and last, and all events', () => {
  const messages: Message[] = [];
  for (let tUs = 0; tUs <= 2_000_000; tUs += 10_000) {
    messages.push(aFrame(tUs), { channel: 'VIZ_RISK', value: aRisk(1, tUs) });
    messages.push({ channel: 'VIZ_EVENT', value: anEvent({ tUs, seq: tUs }) });
  }
  const kept = thinned(messages, 20);
  const times = (channel: string): number[] =>
    kept.flatMap((m) => (m.channel === channel && 'tUs' in m.value ? [m.value.tUs] : []));
  const expected = Array.from({ length: 41 }, (_, i) => i * 50_000);
  expect(times('VIZ_FRAME')).toEqual(expected);
  expect(times('VIZ_RISK')).toEqual(expected);
  expect(times('VIZ_EVENT')).toHaveLength(201);
});

test('a report that would be too large has fewer frames, but every event', async () => {
  const long: Message[] = [];
  for (let tUs = 0; tUs <= 4_000_000; tUs += 10_000) {
    const objects = Array.from({ length: 20 }, (_, id) =>
      anObject(id, { pos: [Math.sin(tUs * id), tUs, 1] }),
    );
    long.push(aFrame(tUs, objects));
    long.push({ channel: 'VIZ_EVENT', value: anEvent({ tUs, seq: tUs }) });
  }
  const whole = await report(page, 't', long);
  const half = await report(page, 't', long, whole.length / 2);
  expect(half.length).toBeLessThanOrEqual(whole.length / 2);
  const count = (channel: string): number => logIn(half).filter((m) => m.channel === channel).length;
  expect(count('VIZ_EVENT')).toBe(401);
  expect([81, 41, 21, 9, 5]).toContain(count('VIZ_FRAME')); // 20, 10, 5, 2 or 1 a second, both ends counted
});

test('base64 agrees with the system on every length', () => {
  for (const length of [0, 1, 2, 3, 0x8000, 0x8001, 100_000]) {
    const bytes = Uint8Array.from({ length }, (_, i) => (i * 31) % 256);
    expect(base64(bytes)).toBe(Buffer.from(bytes).toString('base64'));
  }
});

test('the name of a file holds no path', () => {
  expect(fileName('copter_1a', '.html')).toBe('copter_1a.html');
  expect(fileName('../../etc/x y', '.html')).toBe('_etc_x_y.html');
  expect(fileName('', '.png')).toBe('visualizer.png');
});
