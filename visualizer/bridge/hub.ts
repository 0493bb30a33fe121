// All pages, and what goes to each of them.

import type { WebSocket } from 'ws';
import { type ControlRequest, helloChannels, type Stats, wrap } from '../codec/protocol';
import type { TileSet } from '../codec/tile_set';
import { isChannel } from '../codec/viz';
import { Client } from './client';
import type { Journal } from './journal';
import { Newest } from './newest';
import type { UdpStats } from './udp';

export const maxClients = 128;

export interface HubOptions {
  group: string; // its name
  token: string | null; // null: control is off
  tiles: TileSet | null; // of the map
  journal: Journal;
  control: (client: string, request: ControlRequest) => boolean; // false: there is no player to hear it
}

export class Hub {
  private readonly options: HubOptions;
  private readonly clients = new Set<Client>();
  private readonly newest = new Newest();
  private readonly start = new Date().toISOString();
  private named = 0;
  private bytesBefore = 0;

  constructor(options: HubOptions) {
    this.options = options;
  }

  get size(): number {
    return this.clients.size;
  }

  get full(): boolean {
    return this.clients.size >= maxClients;
  }

  add(socket: WebSocket): void {
    const { token, tiles, journal, group } = this.options;
    this.named += 1;
    const client = new Client(socket, `page-${this.named}`, token, journal, {
      control: (from, request) => {
        if (!this.options.control(from.name, request))
          from.refuse(request.seq, 'no player has been heard yet');
      },
      closed: (gone) => this.clients.delete(gone),
    });
    this.clients.add(client);
    client.hello({
      v: 1,
      start: this.start,
      control: token !== null,
      token,
      client: client.name,
      group,
      tiles,
      channels: { ...helloChannels },
    });
    for (const message of this.newest.all()) client.forward('', message);
  }

  // A message from the group. Channels that are not for pages, VIZ_CONTROL with its token above all, go nowhere.
  message(channel: string, payload: Uint8Array): void {
    if (!isChannel(channel)) return;
    const problem = this.newest.note(channel, payload);
    if (problem) this.options.journal.refused('packet', problem);
    const message = wrap(channel, payload);
    for (const client of this.clients) client.forward(channel, message);
  }

  // Once a second: what has come so far.
  statistics({ messages, bytes, lost }: UdpStats): void {
    const bytesPerSec = bytes - this.bytesBefore;
    this.bytesBefore = bytes;
    for (const client of this.clients) {
      const stats: Stats = { udp: messages, lost, dropped: client.dropped, bytesPerSec };
      client.text({ stats });
    }
  }

  // Says goodbye; a page that does not answer is not waited for.
  close(): void {
    for (const client of this.clients) client.close();
  }

  terminate(): void {
    for (const client of this.clients) client.terminate();
  }
}
