// Builds the page: one self-contained HTML file, dist/page.html, whose scripts and styles are allowed by their
// hashes and nothing else. `--mode test` writes _build/visualizer/page.html instead, with window.__viz in it.
import { fileURLToPath } from 'node:url';
import { defineConfig } from 'vite';
import { viteSingleFile } from 'vite-plugin-singlefile';
import { contentSecurity } from './content_security.ts';
import { notices } from './notices.ts';

const here = (path: string): string => fileURLToPath(new URL(path, import.meta.url));

export default defineConfig(({ mode }) => ({
  root: here('../page'),
  logLevel: 'warn',
  define: { __VIZ_TEST__: JSON.stringify(mode === 'test') },
  plugins: [
    viteSingleFile({ removeViteModuleLoader: true }),
    notices(['uplot']),
    contentSecurity('page.html'),
  ],
  build: {
    target: 'es2022',
    outDir: mode === 'test' ? here('../../_build/visualizer') : here('../dist'),
    emptyOutDir: false,
    modulePreload: false,
    reportCompressedSize: false,
  },
}));
