// The browser tests, one after the other: they share two cores with a browser. Started by scripts/stages/browser.sh.
import { fileURLToPath } from 'node:url';
import { defineConfig } from 'vitest/config';

export default defineConfig({
  root: fileURLToPath(new URL('..', import.meta.url)),
  test: {
    include: ['test/**/*.test.ts'],
    globalSetup: fileURLToPath(new URL('browser.ts', import.meta.url)),
    fileParallelism: false,
    maxWorkers: 1,
    testTimeout: 120_000, // several waits of harness.ts, each with its own limit and text
    hookTimeout: 60_000,
  },
});
