// Which Host and Origin headers are of this bridge. Loopback alone does not keep other web sites out: a page of theirs
// may open a WebSocket to 127.0.0.1, and a name of theirs may point there (DNS rebinding).

import { networkInterfaces } from 'node:os';

export class Origins {
  private readonly hosts: ReadonlySet<string>;

  // bind 0.0.0.0 means every address of this host.
  constructor(bind: string, port: number) {
    const all = Object.values(networkInterfaces()).flatMap((found) =>
      (found ?? []).map((one) => one.address),
    );
    const names = ['127.0.0.1', 'localhost', ...(bind === '0.0.0.0' ? all : [bind])];
    this.hosts = new Set(names.flatMap((name) => (port === 80 ? [name, `${name}:80`] : [`${name}:${port}`])));
  }

  isOurHost(host: string | undefined): boolean {
    return host !== undefined && this.hosts.has(host.toLowerCase());
  }

  // The header is exactly scheme, name and port, and these are ours.
  isOurOrigin(origin: string | undefined): boolean {
    if (origin === undefined || !URL.canParse(origin)) return false;
    const url = new URL(origin);
    return url.protocol === 'http:' && url.origin === origin.toLowerCase() && this.isOurHost(url.host);
  }
}
