// PNG files without a library.
//
// smallerPng makes a browser's PNG smaller without changing a pixel: drawings with flat areas compress best without the
// filters that suit photographs. For 8-bit RGB and RGBA without interlacing, which is what browsers write.

import { crc32, deflateSync, inflateSync } from 'node:zlib';

// By the colour type of the header.
const bytesOfPixel = new Map([
  [2, 3],
  [6, 4],
]);
const signature = Buffer.from([137, 80, 78, 71, 13, 10, 26, 10]);

export function smallerPng(png: Buffer): Buffer {
  const chunks = chunksOf(png);
  const header = chunks.find(({ type }) => type === 'IHDR')?.data;
  const channels = bytesOfPixel.get(header?.[9] ?? -1);
  if (header === undefined || channels === undefined || header[8] !== 8 || header[12] !== 0)
    throw new Error('expected a PNG of 8-bit RGB or RGBA without interlacing');
  const rowBytes = header.readUInt32BE(0) * channels;
  const data = Buffer.concat(chunks.filter(({ type }) => type === 'IDAT').map((chunk) => chunk.data));
  const plain = unfiltered(inflateSync(data), rowBytes, channels);
  const packed = deflateSync(plain, { level: 9, memLevel: 9 });
  return file(header, packed);
}

// A square of one colour, so many pixels wide.
export function plainPng(side: number, colour: readonly [number, number, number]): Buffer {
  const header = Buffer.from([0, 0, 0, 0, 0, 0, 0, 0, 8, 2, 0, 0, 0]); // 8 bits, RGB
  header.writeUInt32BE(side, 0);
  header.writeUInt32BE(side, 4);
  const row = Buffer.concat([Buffer.from([0]), Buffer.alloc(3 * side, Buffer.from(colour))]);
  return file(header, deflateSync(Buffer.concat(Array.from({ length: side }, () => row))));
}

const file = (header: Buffer, packed: Buffer): Buffer =>
  Buffer.concat([signature, chunk('IHDR', header), chunk('IDAT', packed), chunk('IEND', Buffer.alloc(0))]);

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
