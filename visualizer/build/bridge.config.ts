// Builds the bridge: dist/bridge.mjs, one file with everything it needs, for Node 18 and newer.
import { fileURLToPath } from 'node:url';
import { defineConfig } from 'vite';
import { notices } from './notices.ts';

const here = (path: string): string => fileURLToPath(new URL(path, import.meta.url));

export default defineConfig({
  root: here('..'),
  logLevel: 'warn',
  publicDir: false,
  plugins: [notices(['ws'])],
  // ws looks for optional native helpers; without them it uses its own code.
  define: { 'process.env.WS_NO_BUFFER_UTIL': '"1"', 'process.env.WS_NO_UTF_8_VALIDATE': '"1"' },
  ssr: { noExternal: true, target: 'node' },
  build: {
    ssr: here('../bridge/main.ts'),
    target: 'node18',
    outDir: here('../dist'),
    emptyOutDir: false,
    minify: false,
    rolldownOptions: { output: { entryFileNames: 'bridge.mjs', codeSplitting: false } },
  },
});
