// What the build and the tests add to the page's world.

// True in test builds only (`npm run build:test`).
declare const __VIZ_TEST__: boolean;

interface Window {
  // What the browser tests look at; in test builds only.
  __viz?: { stats: () => unknown; state: () => unknown; viewer: unknown };
}
