// Pictures as PNG: 8-bit RGB and RGBA without interlacing, which is what browsers write. They are written without the
// filters that suit photographs: drawings with flat areas get smaller so.

import { crc32, deflateSync, inflateSync } from 'node:zlib';

// By the colour type of the header.
const bytesOfPixel = new Map([
  [2, 3],
  [6, 4],
]);
const signature = Buffer.from([137, 80, 78, 71, 13, 10, 26, 10]);

// Rows from the top, pixels from the left, channels red, green, blue and, where there are four, alpha.
export interface Picture {
  readonly width: number;
  readonly height: number;
  readonly channels: number;
  readonly bytes: Uint8Array;
}

export function smallerPng(png: Buffer): Buffer {
  return writePng(readPng(png));
}

// A square of one colour, so many pixels wide.
export function plainPng(side: number, colour: readonly [number, number, number]): Buffer {
  return writePng({
    width: side,
    height: side,
    channels: 3,
    bytes: Buffer.alloc(3 * side * side, Buffer.from(colour)),
  });
}

export function readPng(png: Buffer): Picture {
  const chunks = chunksOf(png);
  const header = chunks.find(({ type }) => type === 'IHDR')?.data;
  const channels = bytesOfPixel.get(header?.[9] ?? -1);
  if (header === undefined || channels === undefined || header[8] !== 8 || header[12] !== 0)
    throw new Error('expected a PNG of 8-bit RGB or RGBA without interlacing');
  const [width, height] = [header.readUInt32BE(0), header.readUInt32BE(4)];
  const data = Buffer.concat(chunks.filter(({ type }) => type === 'IDAT').map((chunk) => chunk.data));
  const rows = unfiltered(inflateSync(data), width * channels, channels);
  const bytes = new Uint8Array(width * height * channels);
  for (let y = 0; y < height; y++) bytes.set(rowOf(rows, y, width * channels), y * width * channels);
  return { width, height, channels, bytes };
}

export function writePng({ width, height, channels, bytes }: Picture): Buffer {
  const rowBytes = width * channels;
  const rows = Buffer.alloc((rowBytes + 1) * height);
  for (let y = 0; y < height; y++)
    rowOf(rows, y, rowBytes).set(bytes.subarray(y * rowBytes, (y + 1) * rowBytes));
  const header = Buffer.alloc(13);
  header.writeUInt32BE(width, 0);
  header.writeUInt32BE(height, 4);
  header.set([8, channels === 4 ? 6 : 2], 8);
  return Buffer.concat([
    signature,
    chunk('IHDR', header),
    chunk('IDAT', deflateSync(rows, { level: 9, memLevel: 9 })),
    chunk('IEND', Buffer.alloc(0)),
  ]);
}

// A row without the byte before it, which names its filter.
function rowOf(rows: Buffer, y: number, rowBytes: number): Buffer {
  return rows.subarray(y * (rowBytes + 1) + 1, (y + 1) * (rowBytes + 1));
}

function chunksOf(png: Buffer): { type: string; data: Buffer }[] {
  const chunks: { type: string; data: Buffer }[] = [];
  for (let at = signature.length; at < png.length; ) {
    const size = png.readUInt32BE(at);
    chunks.push({ type: png.toString('latin1', at + 4, at + 8), data: png.subarray(at + 8, at + 8 + size) });
    at += size + 12;
  }
  return chunks;
}

function chunk(type: string, data: Buffer): Buffer {
  const body = Buffer.concat([Buffer.from(type, 'latin1'), data]);
  const ends = Buffer.alloc(8);
  ends.writeUInt32BE(data.length, 0);
  ends.writeUInt32BE(crc32(body), 4);
  return Buffer.concat([ends.subarray(0, 4), body, ends.subarray(4)]);
}

// The rows with their filters undone (PNG specification, section 9), each with filter 0 before it.
function unfiltered(rows: Buffer, rowBytes: number, step: number): Buffer {
  const stride = rowBytes + 1;
  for (let start = 0; start < rows.length; start += stride) {
    const filter = rows[start] ?? 0;
    rows[start] = 0;
    for (let i = 1; i <= rowBytes; i++) {
      const left = i > step ? (rows[start + i - step] ?? 0) : 0;
      const up = start > 0 ? (rows[start + i - stride] ?? 0) : 0;
      const corner = start > 0 && i > step ? (rows[start + i - stride - step] ?? 0) : 0;
      rows[start + i] = ((rows[start + i] ?? 0) + predicted(filter, left, up, corner)) & 255;
    }
  }
  return rows;
}

function predicted(filter: number, left: number, up: number, corner: number): number {
  if (filter === 1) return left;
  if (filter === 2) return up;
  if (filter === 3) return (left + up) >> 1;
  if (filter !== 4) return 0;
  const guess = left + up - corner;
  const [toLeft, toUp, toCorner] = [Math.abs(guess - left), Math.abs(guess - up), Math.abs(guess - corner)];
  if (toLeft <= toUp && toLeft <= toCorner) return left;
  return toUp <= toCorner ? up : corner;
}
