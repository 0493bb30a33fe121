// Unit tests: X.test.ts beside X.ts. The browser tests (test/) have a configuration of their own.
import { defineConfig } from 'vitest/config';

export default defineConfig({
  define: { __VIZ_TEST__: 'true' },
  test: {
    include: [
      'codec/**/*.test.ts',
      'fuzz/**/*.test.ts',
      'bridge/**/*.test.ts',
      'page/**/*.test.ts',
      'build/**/*.test.ts',
    ],
    testTimeout: 60_000,
  },
});
