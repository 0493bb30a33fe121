// The bridge's end of LCM: receives the packets of a group and puts messages together; publishes.

import { createSocket, type Socket } from 'node:dgram';
import { networkInterfaces } from 'node:os';
import { packets } from '../codec/packet';
import { Reassembly } from '../codec/reassembly';
import type { Group } from './group';
import type { Journal } from './journal';

const loopback = '127.0.0.1';

export interface UdpStats {
  messages: number;
  bytes: number; // of payload
  lost: number;
}

export class LcmSocket {
  readonly stats: UdpStats = { messages: 0, bytes: 0, lost: 0 };
  private readonly group: Group;
  private readonly journal: Journal;
  private readonly receiver: Socket;
  private readonly sender: Socket;
  private readonly reassembly = new Reassembly();
  private readonly ownAddresses = new OwnAddresses();
  private sequence = 0;
  private peer: { port: number; address: string } | null = null; // unicast: who sent last

  // onMessage gets each whole message; it must not keep the payload's buffer longer than it needs.
  constructor(group: Group, journal: Journal, onMessage: (channel: string, payload: Uint8Array) => void) {
    this.group = group;
    this.journal = journal;
    this.receiver = createSocket({
      type: 'udp4',
      reuseAddr: group.multicast,
      recvBufferSize: group.receiveBuffer,
    });
    this.sender = createSocket({ type: 'udp4' });
    this.receiver.on('message', (packet, { address, port }) => {
      if (!this.isOurs(address)) return;
      const whole = this.reassembly.accept(`${address}:${port}`, packet);
      this.stats.lost = this.reassembly.lost;
      if (typeof whole === 'string') journal.refused('packet', `a packet of ${address}:${port}: ${whole}`);
      else if (whole) {
        this.stats.messages += 1;
        this.stats.bytes += whole.payload.length;
        if (!group.multicast) this.peer = { address, port };
        onMessage(whole.channel, whole.payload);
      }
    });
  }

  // Joins the group. Rejects when the address cannot be used.
  async open(): Promise<void> {
    const { group, receiver, sender } = this;
    await bound(sender, 0, group.network ? '0.0.0.0' : loopback);
    if (group.multicast) {
      if (!group.network) sender.setMulticastInterface(loopback);
      sender.setMulticastTTL(group.ttl);
      sender.setMulticastLoopback(true);
    }
    await bound(receiver, group.port, group.host);
    if (group.multicast) receiver.addMembership(group.host, group.network ? undefined : loopback);
    for (const socket of [receiver, sender])
      socket.on('error', (error) => this.journal.refused('packet', `UDP: ${error.message}`));
  }

  // False when there is nobody to send to: unicast, and nothing has come yet.
  publish(channel: string, payload: Uint8Array): boolean {
    const { group } = this;
    const to = group.multicast ? { address: group.host, port: group.port } : this.peer;
    if (!to) return false;
    for (const packet of packets(channel, payload, this.sequence))
      this.sender.send(packet, to.port, to.address);
    this.sequence = (this.sequence + 1) >>> 0;
    return true;
  }

  close(): void {
    this.receiver.close();
    this.sender.close();
  }

  // Another program that joins the group on a network interface would let that network's packets in here too.
  private isOurs(address: string): boolean {
    if (this.group.network || this.ownAddresses.has(address)) return true;
    this.journal.refused('packet', `a packet of another host, ${address}; --allow-network takes them`);
    return false;
  }
}

function bound(socket: Socket, port: number, address: string): Promise<void> {
  return new Promise((resolve, reject) => {
    socket.once('error', reject);
    socket.bind({ port, address, exclusive: false }, () => {
      socket.off('error', reject);
      resolve();
    });
  });
}

// The addresses of this host, looked up again at most once a second.
class OwnAddresses {
  private known = new Set<string>();
  private readMs = Number.NEGATIVE_INFINITY;

  has(address: string): boolean {
    if (address.startsWith('127.') || address === '0.0.0.0' || this.known.has(address)) return true;
    const now = performance.now();
    if (now - this.readMs < 1000) return false;
    this.readMs = now;
    this.known = new Set(
      Object.values(networkInterfaces()).flatMap((all) => (all ?? []).map((one) => one.address)),
    );
    return this.known.has(address);
  }
}
