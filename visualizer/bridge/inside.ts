// Files of a folder that pages may ask for: wherever links lead, nothing outside of the folder is opened.

import { constants } from 'node:fs';
import { type FileHandle, open, realpath } from 'node:fs/promises';
import { join, sep } from 'node:path';

export interface OpenedFile {
  file: FileHandle; // whoever asked closes it
  size: number; // bytes
}

// 'missing': there is none of that name. 'refused': it is no file, not readable, or outside of the folder.
export async function openInside(folder: string, path: string): Promise<OpenedFile | 'missing' | 'refused'> {
  try {
    const inside = (await realpath(folder)) + sep;
    const real = await realpath(join(folder, path));
    if (!real.startsWith(inside)) return 'refused';
    const file = await open(real, constants.O_RDONLY | constants.O_NOFOLLOW | constants.O_NONBLOCK);
    const found = await file.stat();
    if (found.isFile()) return { file, size: found.size };
    await file.close();
    return 'refused';
  } catch (error) {
    const { code } = error as NodeJS.ErrnoException;
    return code === 'ENOENT' || code === 'ENOTDIR' ? 'missing' : 'refused';
  }
}
