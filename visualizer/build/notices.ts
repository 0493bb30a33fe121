// A step of both builds: the licences of the packages whose code a built file contains, as a comment near its top.
import { readFileSync } from 'node:fs';
import type { Plugin } from 'vite';

const notice = (name: string): string => {
  const licence = new URL(`../node_modules/${name}/LICENSE`, import.meta.url);
  return `This file contains ${name}:\n\n${readFileSync(licence, 'utf8').trim()}`;
};

export function notices(packages: readonly string[]): Plugin {
  const text = packages.map(notice).join('\n\n');
  if (text.includes('-->') || text.includes('*/'))
    throw new Error('a licence would end the comment it is in');
  return {
    name: 'notices',
    enforce: 'post',
    generateBundle: {
      order: 'post',
      handler(_options, bundle) {
        for (const file of Object.values(bundle)) {
          if (file.type === 'chunk' && file.isEntry) file.code = `/*\n${text}\n*/\n${file.code}`;
          else if (file.type === 'asset' && file.fileName.endsWith('.html'))
            file.source = file.source.toString().replace('</title>', (end) => `${end}\n<!--\n${text}\n-->`);
        }
      },
    },
  };
}
