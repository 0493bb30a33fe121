import { expect, test } from 'vitest';
import { fuzzInput, fuzzTargets } from './targets';

// Longer runs: scripts/fuzz.sh.
test.each(Object.entries(fuzzTargets))('%s holds for 2000 mutated inputs', (_, target) => {
  for (const input of target.corpus) target.run(input);
  for (let seed = 1; seed <= 2000; seed += 1) {
    const input = fuzzInput(target, seed);
    expect(() => target.run(input), `seed ${seed}`).not.toThrow();
  }
});
