// The bridge: a group of LCM on one side, web pages on the other.

import { readFileSync } from 'node:fs';
import type { ControlRequest } from '../codec/protocol';
import { controlChannel, encodeControl } from '../codec/viz';
import { groupName } from './group';
import { Hub } from './hub';
import type { Journal } from './journal';
import type { Options } from './options';
import { readTileFolder } from './tiles';
import { sharedToken } from './token';
import { LcmSocket } from './udp';
import { Web } from './web';

// How long pages have to say goodbye when the bridge ends.
const goodbyeMs = 500;

export class Bridge {
  private readonly options: Options;
  private readonly journal: Journal;
  private readonly token: string | null;
  private readonly hub: Hub;
  private readonly lcm: LcmSocket;
  private readonly web: Web;
  private clock: NodeJS.Timeout | null = null;

  // Throws one line when the page, the token or the description of the tiles cannot be read.
  constructor(options: Options, pageFile: string, journal: Journal) {
    this.options = options;
    this.journal = journal;
    this.token = options.tokenFile === null ? null : sharedToken(options.tokenFile);
    const page = readFileSync(pageFile);
    const { group, port, bind, cases } = options;
    const tiles = options.tiles === null ? null : readTileFolder(options.tiles);
    this.hub = new Hub({
      group: groupName(group),
      token: this.token,
      tiles: tiles?.set ?? null,
      journal,
      control: (client, request) => this.control(client, request),
    });
    this.lcm = new LcmSocket(group, journal, (channel, payload) => this.hub.message(channel, payload));
    this.web = new Web({ port, bind, cases, tiles, page, hub: this.hub, journal });
  }

  // Answers with the address of the page. Rejects when an address is in use.
  async open(): Promise<string> {
    await this.lcm.open();
    const port = await this.web.open();
    this.clock = setInterval(() => {
      this.hub.statistics(this.lcm.stats);
      this.journal.flush();
    }, 1000);
    return `http://${this.options.bind}:${port}/`;
  }

  async close(): Promise<void> {
    if (this.clock) clearInterval(this.clock);
    this.lcm.close();
    this.hub.close();
    for (let waited = 0; this.hub.size > 0 && waited < goodbyeMs; waited += 10)
      await new Promise((resolve) => setTimeout(resolve, 10));
    this.hub.terminate();
    this.web.close();
    this.journal.flush();
  }

  private control(client: string, { seq, verb, object, args, text }: ControlRequest): boolean {
    const payload = encodeControl({ client, token: this.token ?? '', seq, verb, object, args, text });
    return this.lcm.publish(controlChannel, payload);
  }
}
