// Runs one fuzz target for so many seconds, or so many runs:
//
//   node fuzz.mjs TARGET SECONDS [RUNS [FIRST_SEED]]
//
// Ends with "Done N runs in S second(s)", as libFuzzer does, or with the seed of what it found and exit status 1.

import { fuzzInput, fuzzTargets } from './targets';

const slowMs = 1000; // no input may take longer

function number(text: string | undefined, otherwise: number): number {
  if (text === undefined || text === '') return otherwise;
  if (/^\d{1,12}$/.test(text)) return Number(text);
  process.stderr.write(`fuzz: expected a whole number, got "${text}"\n`);
  process.exit(2);
}

const [name = '', secondsText, runsText, seedText] = process.argv.slice(2);
const target = fuzzTargets[name];
if (!target) {
  process.stderr.write(`fuzz: expected one of ${Object.keys(fuzzTargets).join(', ')}, got "${name}"\n`);
  process.exit(2);
}
const runs = number(runsText, Number.POSITIVE_INFINITY);
const endMs = runsText ? Number.POSITIVE_INFINITY : 1000 * number(secondsText, 10);
// Other inputs each day, the same all day.
const first = number(seedText, Math.floor(Date.now() / 86_400_000) * 100_000);

const began = performance.now();
let done = 0;
while (done < runs && performance.now() - began < endMs) {
  const seed = first + done;
  const input = fuzzInput(target, seed);
  const before = performance.now();
  try {
    target.run(input);
    if (performance.now() - before > slowMs) throw new Error(`took more than ${slowMs} ms`);
  } catch (error) {
    process.stderr.write(`fuzz ${name}: ${(error as Error).message}\n`);
    process.stderr.write(
      `again: node fuzz.mjs ${name} 0 1 ${seed}\ninput: ${Buffer.from(input).toString('hex')}\n`,
    );
    process.exit(1);
  }
  done += 1;
}
const seconds = Math.round((performance.now() - began) / 1000);
process.stdout.write(`Done ${done} runs in ${seconds} second(s)\n`);
