// Stored cases on disk: DIR/<id>/run.lcm.

import { constants } from 'node:fs';
import { type FileHandle, open, readdir, realpath } from 'node:fs/promises';
import { join, sep } from 'node:path';
import { caseIdPattern } from '../codec/verbs';

export interface CaseEntry {
  id: string;
  bytes: number; // of run.lcm
  modified: string; // ISO 8601
}

const logName = 'run.lcm';

// The log of a case opened for reading, or null: no such case, or its path leads out of the folder.
export async function openCase(
  folder: string,
  id: string,
): Promise<{ file: FileHandle; size: number } | null> {
  if (!caseIdPattern.test(id)) return null;
  try {
    const inside = (await realpath(folder)) + sep;
    const path = await realpath(join(folder, id, logName));
    if (!path.startsWith(inside)) return null;
    const file = await open(path, constants.O_RDONLY | constants.O_NOFOLLOW | constants.O_NONBLOCK);
    const found = await file.stat();
    if (found.isFile()) return { file, size: found.size };
    await file.close();
    return null;
  } catch {
    return null; // not there, or not readable
  }
}

// Cases that have a log, the newest first.
export async function listCases(folder: string): Promise<CaseEntry[]> {
  const names = await readdir(folder).catch(() => []);
  const entries = await Promise.all(names.map((id) => describe(folder, id)));
  return entries
    .filter((entry): entry is CaseEntry => entry !== null)
    .sort((a, b) => (a.modified < b.modified ? 1 : a.modified > b.modified ? -1 : a.id < b.id ? -1 : 1));
}

async function describe(folder: string, id: string): Promise<CaseEntry | null> {
  const opened = await openCase(folder, id);
  if (!opened) return null;
  const { mtime } = await opened.file.stat();
  await opened.file.close();
  return { id, bytes: opened.size, modified: mtime.toISOString() };
}
