import { chmodSync, mkdtempSync, readdirSync, readFileSync, rmSync, statSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { afterEach, beforeEach, expect, test } from 'vitest';
import { sameToken, sharedToken } from './token';

let folder = '';
beforeEach(() => {
  folder = mkdtempSync(join(tmpdir(), 'token-'));
});
afterEach(() => rmSync(folder, { recursive: true }));

test('whoever comes first makes the token, who comes later reads the same', () => {
  const file = join(folder, 'new', 'token');
  const token = sharedToken(file);
  expect(token).toMatch(/^[0-9a-f]{64}$/);
  expect(sharedToken(file)).toBe(token);
  expect(statSync(file).mode & 0o777).toBe(0o600);
  expect(readdirSync(join(folder, 'new'))).toEqual(['token']);
  expect(sharedToken(join(folder, 'other'))).not.toBe(token);
});

test('a file that others may read is refused', () => {
  const file = join(folder, 'token');
  writeFileSync(file, 'a'.repeat(32));
  chmodSync(file, 0o640);
  expect(() => sharedToken(file)).toThrow(/others may read it; run: chmod 600/);
});

test('a file with something else in it is refused and left alone', () => {
  const file = join(folder, 'token');
  writeFileSync(file, 'short', { mode: 0o600 });
  expect(() => sharedToken(file)).toThrow(`${file}: expected 32 to 128 hexadecimal digits`);
  expect(readFileSync(file, 'utf8')).toBe('short');
});

test.each([
  ['abc', 'abc', true],
  ['abd', 'abc', false],
  ['ab', 'abc', false],
  ['', 'abc', false],
])('"%s" for "%s": %s', (given, token, same) => {
  expect(sameToken(given, token)).toBe(same);
});
