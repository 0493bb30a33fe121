// The bridge's command line.

import { parseArgs } from 'node:util';
import { type Group, parseGroup, parseUnicast } from './group';

export interface Options {
  port: number; // 0: any free one
  bind: string; // IPv4 address
  group: Group;
  cases: string; // folder
  tiles: string | null; // folder of map tiles
  page: string | null; // another page than the one beside the bridge
  tokenFile: string | null; // null: pages may not control
}

// Wrong usage: one line for the person at the terminal, exit status 2.
export class UsageError extends Error {}

export const usage = `bridge.mjs: passes LCM messages on to web pages, and what pages ask of the player back

  node bridge.mjs [--port 8765] [--bind 127.0.0.1] [--group URL | --udp 127.0.0.1:7667]
                  [--cases DIR] [--tiles DIR] [--page FILE] [--allow-control --token-file FILE]

  --port N       of the web server, 0 to 65535; 0 takes a free one, and the first line printed names it (8765)
  --bind ADDR    IPv4 address of the web server (127.0.0.1)
  --group URL    multicast group: udpm://239.255.76.67:7667?ttl=0 or 239.255.76.67:7667; --lcm-url is the same
  --udp ADDR     unicast on this address instead; the tools of LCM do not see that
  --cases DIR    folder of stored cases (cases); /cases lists those with a run.lcm
  --tiles DIR    folder of map tiles, Z/X/Y.png (or jpg, webp), with a tiles.json; none are ever fetched elsewhere
  --page FILE    the page to serve (page.html beside this program)
  --allow-control              pages may control the player, with a token of this file
  --token-file FILE            shared with the player; whoever comes first makes it
  --allow-network              take a URL with ttl > 0, and messages of other hosts
  --insecure-remote-control    take --allow-control together with a --bind that other hosts reach

Exit status: 0 ended by --help or SIGTERM, 2 usage, 3 an address or a file cannot be used, 130 interrupted.`;

const definition = {
  port: { type: 'string', default: '8765' },
  bind: { type: 'string', default: '127.0.0.1' },
  group: { type: 'string' },
  'lcm-url': { type: 'string' },
  udp: { type: 'string' },
  cases: { type: 'string', default: 'cases' },
  tiles: { type: 'string' },
  page: { type: 'string' },
  'token-file': { type: 'string' },
  'allow-control': { type: 'boolean', default: false },
  'allow-network': { type: 'boolean', default: false },
  'insecure-remote-control': { type: 'boolean', default: false },
  help: { type: 'boolean', short: 'h', default: false },
} as const;

const defaultGroup = 'udpm://239.255.76.67:7667?ttl=0&recv_buf_size=2097152';

function parsed(argv: string[]) {
  try {
    return parseArgs({ args: argv, options: definition, strict: true, allowPositionals: false }).values;
  } catch (error) {
    throw new UsageError(firstLine(error));
  }
}

const firstLine = (error: unknown): string => String((error as Error).message).split('\n')[0] ?? '';

function wholeNumber(name: string, text: string, max: number): number {
  const value = /^\d{1,9}$/.test(text) ? Number(text) : Number.NaN;
  if (!(value <= max))
    throw new UsageError(`${name}: expected a whole number from 0 to ${max}, got "${text}"`);
  return value;
}

const isLoopback = (address: string): boolean => /^127\./.test(address);

function address(text: string): string {
  const parts = text.split('.');
  const good = parts.length === 4 && parts.every((part) => /^\d{1,3}$/.test(part) && Number(part) <= 255);
  if (!good) throw new UsageError(`--bind: expected an IPv4 address, got "${text}"`);
  return text;
}

function chosenGroup(values: ReturnType<typeof parsed>): Group {
  const network = values['allow-network'] ?? false;
  const url = values.group ?? values['lcm-url'];
  if (values.udp !== undefined && url !== undefined)
    throw new UsageError('--udp and --group: expected one of them, got both');
  const group =
    values.udp !== undefined ? parseUnicast(values.udp, network) : parseGroup(url ?? defaultGroup, network);
  if (typeof group === 'string')
    throw new UsageError(`${values.udp !== undefined ? '--udp' : '--group'}: ${group}`);
  return group;
}

// Null: help was asked for. Throws UsageError.
export function parseOptions(argv: string[]): Options | null {
  const values = parsed(argv);
  if (values.help) return null;
  const bind = address(values.bind ?? '');
  const control = values['allow-control'] ?? false;
  if (control && !isLoopback(bind) && !values['insecure-remote-control'])
    throw new UsageError(
      `--allow-control with --bind ${bind}: other hosts would control; needs --insecure-remote-control`,
    );
  if (control !== (values['token-file'] !== undefined))
    throw new UsageError('--allow-control and --token-file: expected both or none, got one');
  return {
    port: wholeNumber('--port', values.port ?? '', 65_535),
    bind,
    group: chosenGroup(values),
    cases: values.cases ?? 'cases',
    tiles: values.tiles ?? null,
    page: values.page ?? null,
    tokenFile: values['token-file'] ?? null,
  };
}
