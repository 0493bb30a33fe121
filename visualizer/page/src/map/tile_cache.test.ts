import { describe, expect, it } from 'vitest';
import { MOST_HELD, TileCache } from './tile_cache';

interface Picture {
  name: string;
  width: number;
  height: number;
  closed: boolean;
  close(): void;
}

function picture(name: string): Picture {
  return {
    name,
    width: 256,
    height: 256,
    closed: false,
    close() {
      this.closed = true;
    },
  };
}

// A cache whose loads end when the test says so.
function setUp() {
  const asked: string[] = [];
  const ends = new Map<string, { come: (made: Picture | null) => void; fail: (line: string) => void }>();
  let arrived = 0;
  const complaints: string[] = [];
  const cache = new TileCache<Picture>(
    (z, x, y) =>
      new Promise((resolve, reject) => {
        asked.push(`${z}/${x}/${y}`);
        ends.set(`${z}/${x}/${y}`, { come: resolve, fail: (line) => reject(new Error(line)) });
      }),
    () => {
      arrived += 1;
    },
    (line) => void complaints.push(line),
  );
  const settle = async (end: () => void): Promise<void> => {
    end();
    await new Promise((resolve) => setImmediate(resolve));
  };
  const come = (key: string, made: Picture | null) => settle(() => ends.get(key)?.come(made));
  const fail = (key: string, line: string) => settle(() => ends.get(key)?.fail(line));
  return { cache, asked, complaints, come, fail, arrived: () => arrived };
}

describe('a cache of tiles', () => {
  it('asks once, and has the picture when it has come', async () => {
    const { cache, asked, come, arrived } = setUp();
    expect(cache.get(3, 1, 2, true)).toBeNull();
    expect(cache.get(3, 1, 2, true)).toBeNull();
    expect(asked).toEqual(['3/1/2']);
    const made = picture('a');
    await come('3/1/2', made);
    expect(arrived()).toBe(1);
    expect(cache.get(3, 1, 2, true)).toBe(made);
    expect(asked).toEqual(['3/1/2']);
  });

  it('does not ask when it may not, and asks later', () => {
    const { cache, asked } = setUp();
    expect(cache.get(3, 1, 2, false)).toBeNull();
    expect(asked).toEqual([]);
    cache.get(3, 1, 2, true);
    expect(asked).toEqual(['3/1/2']);
  });

  it('does not ask again for what is not there', async () => {
    const { cache, asked, come, arrived, complaints } = setUp();
    cache.get(3, 1, 2, true);
    await come('3/1/2', null);
    expect(cache.get(3, 1, 2, true)).toBeNull();
    expect([asked, arrived(), complaints]).toEqual([['3/1/2'], 0, []]);
  });

  it('complains of the first that could not be had, and asks for none of them again', async () => {
    const { cache, asked, fail, complaints } = setUp();
    cache.get(3, 1, 2, true);
    cache.get(3, 1, 3, true);
    await fail('3/1/2', 'no picture');
    await fail('3/1/3', 'no picture either');
    expect(complaints).toEqual(['no picture']);
    expect(cache.get(3, 1, 2, true)).toBeNull();
    expect(asked.length).toBe(2);
  });

  it('lets go of those that were asked for longest ago', async () => {
    const { cache, asked, come } = setUp();
    const first = picture('first');
    const second = picture('second');
    cache.get(9, 0, 0, true);
    await come('9/0/0', first);
    cache.get(9, 0, 1, true);
    await come('9/0/1', second);
    for (let x = 2; x < MOST_HELD; x += 1) cache.get(9, 0, x, true);
    cache.get(9, 0, 0, true); // the second is the oldest now
    cache.get(9, 1, 0, true);
    expect([first.closed, second.closed]).toEqual([false, true]);
    expect(asked.length).toBe(MOST_HELD + 1);
    cache.get(9, 0, 1, true);
    expect(asked.at(-1)).toBe('9/0/1');
  });

  it('closes what comes after it was cleared', async () => {
    const { cache, come, arrived } = setUp();
    const [held, late] = [picture('held'), picture('late')];
    cache.get(9, 0, 0, true);
    await come('9/0/0', held);
    cache.get(9, 0, 1, true);
    cache.clear();
    await come('9/0/1', late);
    expect([held.closed, late.closed, arrived()]).toEqual([true, true, 1]);
  });
});
