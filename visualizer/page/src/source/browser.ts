// The viewer in a browser: its clock, animation frames, sockets and files.

import { createViewer } from '../model/create_viewer';
import type { Viewer } from '../model/viewer';
import { readVizLog } from './read_viz_log';
import { openSocketLink, type SocketWorld } from './socket_link';

const socketWorld: SocketWorld = {
  open: (url, protocol) => new WebSocket(url, protocol),
  now: () => performance.now(),
  every: (ms, callback) => {
    const timer = setInterval(callback, ms);
    return () => clearInterval(timer);
  },
};

export function browserViewer(): Viewer {
  return createViewer({
    now: () => performance.now(),
    animationFrame: (callback) => void requestAnimationFrame(callback),
    later: (ms, callback) => void setTimeout(callback, ms),
    readLog: (bytes, take) => readVizLog(bytes, take, () => new Promise((resolve) => setTimeout(resolve))),
    openLink: (url, listener) => openSocketLink(url, listener, socketWorld),
    firstSeq: 1 + Math.floor(Math.random() * 2 ** 30),
  });
}

// The socket of the bridge that served this page, null when none did.
export function bridgeUrl(place: Pick<Location, 'protocol' | 'host'>): string | null {
  if (place.protocol !== 'http:' && place.protocol !== 'https:') return null;
  return `${place.protocol === 'https:' ? 'wss' : 'ws'}://${place.host}/ws`;
}
