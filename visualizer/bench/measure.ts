// Processes measured through /proc, and the lines that scripts/bench.sh collects.

import { appendFileSync, readFileSync } from 'node:fs';

const ticksPerSecond = 100; // of /proc on Linux

// Adds one line: see bench/README.md at the top.
export function report(key: string, value: number, unit: string): void {
  const line = JSON.stringify({
    key,
    value: Number(value.toPrecision(4)),
    unit,
    baseline: null,
    baseline_value: null,
  });
  const file = process.env.VIZ_BENCH_LINES;
  if (file) appendFileSync(file, `${line}\n`);
  console.log(line);
}

// Processor time that a process has used, in seconds.
export function cpuSeconds(pid: number): number {
  const fields = readFileSync(`/proc/${pid}/stat`, 'utf8')
    .replace(/^.*\) /, '')
    .split(' ');
  return (Number(fields[11]) + Number(fields[12])) / ticksPerSecond;
}

// Memory that a process has to itself, plus its share of what it has with others, in MiB.
export function proportionalMiB(pid: number): number {
  const pss = /^Pss:\s+(\d+) kB/m.exec(readFileSync(`/proc/${pid}/smaps_rollup`, 'utf8'));
  return Number(pss?.[1]) / 1024;
}

export function median(values: readonly number[]): number {
  const sorted = values.toSorted((a, b) => a - b);
  return sorted[Math.floor(sorted.length / 2)] ?? Number.NaN;
}
