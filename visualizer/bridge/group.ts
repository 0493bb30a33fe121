// Where LCM packets come from and go to: a multicast group on this host, or one unicast address.

export interface Group {
  host: string; // IPv4
  port: number;
  multicast: boolean;
  ttl: number; // 0: packets stay on this host
  receiveBuffer: number; // bytes
  network: boolean; // messages of other hosts are taken
}

export const groupName = ({ host, port }: Group): string => `${host}:${port}`;

const defaultBuffer = 2 * 1024 * 1024;

function parseAddress(text: string): { host: string; port: number; first: number } | string {
  const match = /^(\d{1,3})\.(\d{1,3})\.(\d{1,3})\.(\d{1,3}):(\d{1,5})$/.exec(text);
  const numbers = match?.slice(1).map(Number) ?? [];
  const [first = 256, , , , port = 0] = numbers;
  if (!match || numbers.slice(0, 4).some((part) => part > 255) || port < 1 || port > 65_535)
    return `expected ADDRESS:PORT with an IPv4 address, got "${text}"`;
  return { host: numbers.slice(0, 4).join('.'), port, first };
}

function parseNumber(name: string, text: string | null, otherwise: number, max: number): number | string {
  if (text === null) return otherwise;
  if (/^\d{1,10}$/.test(text) && Number(text) <= max) return Number(text);
  return `${name}: expected a whole number from 0 to ${max}, got "${text}"`;
}

// udpm://ADDRESS:PORT?ttl=N&recv_buf_size=N, as liblcm takes it, or ADDRESS:PORT. A string says what is wrong.
export function parseGroup(text: string, network: boolean): Group | string {
  const [address = '', query = ''] = text.replace(/^udpm:\/\//, '').split('?');
  const place = parseAddress(address);
  if (typeof place === 'string') return place;
  if (place.first < 224 || place.first > 239)
    return `expected a multicast address, 224 to 239, got ${place.host}`;
  const values = new URLSearchParams(query);
  const unknown = [...values.keys()].find((key) => key !== 'ttl' && key !== 'recv_buf_size');
  if (unknown !== undefined) return `expected ttl and recv_buf_size, got "${unknown}"`;
  const ttl = parseNumber('ttl', values.get('ttl'), 0, 255);
  const receiveBuffer = parseNumber('recv_buf_size', values.get('recv_buf_size'), defaultBuffer, 2 ** 30);
  if (typeof ttl === 'string') return ttl;
  if (typeof receiveBuffer === 'string') return receiveBuffer;
  if (ttl > 0 && !network) return `ttl=${ttl} would leave this host; needs --allow-network`;
  return { host: place.host, port: place.port, multicast: true, ttl, receiveBuffer, network };
}

// ADDRESS:PORT of this host. A string says what is wrong.
export function parseUnicast(text: string, network: boolean): Group | string {
  const place = parseAddress(text);
  if (typeof place === 'string') return place;
  if (place.first !== 127 && !network)
    return `${place.host} is not on this host alone; needs --allow-network`;
  const { host, port } = place;
  return { host, port, multicast: false, ttl: 0, receiveBuffer: defaultBuffer, network };
}
