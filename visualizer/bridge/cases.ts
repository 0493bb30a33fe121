// Stored cases on disk: DIR/<id>/run.lcm.

import { readdir } from 'node:fs/promises';
import { join } from 'node:path';
import { caseIdPattern } from '../codec/verbs';
import { type OpenedFile, openInside } from './inside';

export interface CaseEntry {
  id: string;
  bytes: number; // of run.lcm
  modified: string; // ISO 8601
}

const logName = 'run.lcm';

// The log of a case opened for reading, or null: no such case, or its path leads out of the folder.
export async function openCase(folder: string, id: string): Promise<OpenedFile | null> {
  if (!caseIdPattern.test(id)) return null;
  const opened = await openInside(folder, join(id, logName));
  return typeof opened === 'string' ? null : opened;
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
