// The program: reads the command line, runs the bridge until a signal ends it.

import { fileURLToPath } from 'node:url';
import { Bridge } from './bridge';
import { groupName } from './group';
import { Journal } from './journal';
import { parseOptions, usage, UsageError } from './options';

const exitUsage = 2;
const exitCannot = 3;
const exitInterrupted = 130;

function fail(error: unknown): never {
  const line = String((error as Error).message).split('\n')[0];
  process.stderr.write(`bridge: ${line}\n`);
  process.exit(error instanceof UsageError ? exitUsage : exitCannot);
}

async function run(): Promise<void> {
  const options = parseOptions(process.argv.slice(2));
  if (!options) {
    process.stdout.write(`${usage}\n`);
    return;
  }
  const pageFile = options.page ?? fileURLToPath(new URL('page.html', import.meta.url));
  const journal = new Journal((line) => process.stderr.write(`${line}\n`));
  const bridge = new Bridge(options, pageFile, journal);
  const end = async (status: number): Promise<void> => {
    await bridge.close();
    process.exit(status);
  };
  process.once('SIGINT', () => void end(exitInterrupted));
  process.once('SIGTERM', () => void end(0));
  const url = await bridge.open();
  const control = options.tokenFile === null ? 'control is off' : 'control is on';
  process.stdout.write(`bridge: ${url} shows ${groupName(options.group)}; ${control}\n`);
}

run().catch(fail);
