import { expect, test } from 'vitest';
import { Hub } from './hub';
import { Journal } from './journal';
import { Web } from './web';

function web(port: number): Web {
  const journal = new Journal(() => undefined);
  const hub = new Hub({ group: 'test', token: null, tiles: null, journal, control: () => false });
  return new Web({
    port,
    bind: '127.0.0.1',
    cases: 'none',
    tiles: null,
    page: Buffer.alloc(0),
    hub,
    journal,
  });
}

test('a port that is taken is one line with the way out', async () => {
  const first = web(0);
  const port = await first.open();
  await expect(web(port).open()).rejects.toThrow(
    `port ${port} is in use; choose another: --port N (make visualizer PORT=N)`,
  );
  first.close();
});
