import { expect, test } from 'vitest';
import { Journal } from './journal';

test('text of others stays on one line', () => {
  const lines: string[] = [];
  new Journal((line) => lines.push(line)).refused('request', `a\r\nb\u001b[31m${'c'.repeat(500)}`);
  expect(lines).toEqual([`bridge: refused: a b [31m${'c'.repeat(300)}`.slice(0, 'bridge: '.length + 300)]);
});

test('beyond 20 a second refusals are counted, not written', () => {
  const lines: string[] = [];
  let now = 0;
  const journal = new Journal(
    (line) => lines.push(line),
    () => now,
  );
  for (let i = 0; i < 25; i += 1) journal.refused('packet', 'bad');
  journal.refused('control', 'of another kind');
  expect(lines.length).toBe(21);
  now = 1000;
  journal.refused('packet', 'later');
  expect(lines.slice(21)).toEqual([
    'bridge: refused: 5 more of this kind (packet)',
    'bridge: refused: later',
  ]);
  journal.flush();
  expect(lines.length).toBe(23);
});
