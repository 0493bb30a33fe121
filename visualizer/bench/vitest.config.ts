// The measurements of the visualizer, which scripts/bench.sh starts: bench/*.bench.ts, one after the other.
import { fileURLToPath } from 'node:url';
import { defineConfig } from 'vitest/config';

export default defineConfig({
  root: fileURLToPath(new URL('..', import.meta.url)),
  test: {
    include: ['bench/**/*.bench.ts'],
    globalSetup: fileURLToPath(new URL('../test/browser.ts', import.meta.url)),
    fileParallelism: false,
    maxWorkers: 1,
    testTimeout: 240_000,
    hookTimeout: 30_000,
  },
});
