import { expect, it } from 'vitest';
import { PlayerWatch } from './player_watch';

it('knows a player that was started anew by its number of the run and the silence before', () => {
  const watch = new PlayerWatch();
  watch.heard(5000);
  expect(watch.isAnother(3, -1, 9000)).toBe(false); // the first
  expect(watch.isAnother(2, 3, 5010)).toBe(true); // numbers only rise while a player lives
  expect(watch.isAnother(900, 3, 6500)).toBe(true);
  expect(watch.isAnother(900, 3, 5500)).toBe(false); // no silence: runs went by unseen
  expect(watch.isAnother(4, 3, 9000)).toBe(false); // the same player's next
});
