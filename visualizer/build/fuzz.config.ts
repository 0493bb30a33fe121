// Builds the fuzz targets: _build/visualizer/fuzz.mjs.
import { fileURLToPath } from 'node:url';
import { defineConfig } from 'vite';

const here = (path: string): string => fileURLToPath(new URL(path, import.meta.url));

export default defineConfig({
  root: here('..'),
  logLevel: 'warn',
  publicDir: false,
  build: {
    ssr: here('../fuzz/run.ts'),
    target: 'node18',
    outDir: here('../../_build/visualizer'),
    emptyOutDir: false,
    minify: false,
    rolldownOptions: { output: { entryFileNames: 'fuzz.mjs', codeSplitting: false } },
  },
});
