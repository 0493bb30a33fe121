// The control token, which bridge and player share through a file.

import { randomBytes, timingSafeEqual } from 'node:crypto';
import { existsSync, linkSync, mkdirSync, readFileSync, rmSync, statSync, writeFileSync } from 'node:fs';
import { dirname } from 'node:path';

const pattern = /^[0-9a-f]{32,128}$/i;

function read(file: string): string {
  const token = readFileSync(file, 'utf8').trim();
  if (!pattern.test(token)) throw new Error(`${file}: expected 32 to 128 hexadecimal digits`);
  if ((statSync(file).mode & 0o077) !== 0)
    throw new Error(`${file}: others may read it; run: chmod 600 ${file}`);
  return token;
}

// The file appears whole or not at all, and only if there is none: a link does that, whoever else tries it.
function make(file: string): void {
  const temporary = `${file}.${process.pid}`;
  writeFileSync(temporary, `${randomBytes(32).toString('hex')}\n`, { mode: 0o600, flag: 'wx' });
  try {
    linkSync(temporary, file);
  } catch (error) {
    if ((error as NodeJS.ErrnoException).code !== 'EEXIST') throw error;
  } finally {
    rmSync(temporary);
  }
}

// The token of the file, which is made if it is not there. Throws one line.
export function sharedToken(file: string): string {
  mkdirSync(dirname(file), { recursive: true });
  if (!existsSync(file)) make(file);
  return read(file);
}

// Takes as long whatever the first difference is.
export function sameToken(given: string, token: string): boolean {
  const a = Buffer.from(given);
  const b = Buffer.from(token);
  return a.length === b.length && timingSafeEqual(a, b);
}
