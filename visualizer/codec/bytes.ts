// Big-endian bytes, read with every length checked and written into a buffer that grows.

const decoder = new TextDecoder('utf-8', { ignoreBOM: true });
const encoder = new TextEncoder();

// Thrown by a Reader: one line that names the byte.
export class BadBytes extends Error {}

export class Reader {
  readonly view: DataView;
  at: number;
  readonly end: number;
  private readonly bytes: Uint8Array;

  constructor(bytes: Uint8Array, at = 0) {
    this.bytes = bytes;
    this.view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
    this.at = at;
    this.end = bytes.byteLength;
  }

  get left(): number {
    return this.end - this.at;
  }

  // Moves over `size` bytes and answers where they begin.
  take(size: number, what: string): number {
    const at = this.at;
    if (size > this.end - at)
      throw new BadBytes(`${what} at byte ${at}: needs ${size}, ${this.left} are left`);
    this.at = at + size;
    return at;
  }

  int8(what: string): number {
    return this.view.getInt8(this.take(1, what));
  }
  int16(what: string): number {
    return this.view.getInt16(this.take(2, what));
  }
  int32(what: string): number {
    return this.view.getInt32(this.take(4, what));
  }
  // A number, as the times of our messages are; beyond 2^53 there would be gaps, so that is refused.
  int64(what: string): number {
    const at = this.take(8, what);
    const value = this.view.getInt32(at) * 2 ** 32 + this.view.getUint32(at + 4);
    if (!Number.isSafeInteger(value)) throw new BadBytes(`${what} at byte ${at}: beyond 2^53`);
    return value;
  }
  float(what: string): number {
    return this.view.getFloat32(this.take(4, what));
  }
  double(what: string): number {
    return this.view.getFloat64(this.take(8, what));
  }
  // 32-bit length with the NUL at the end, then UTF-8.
  string(what: string): string {
    const at = this.at;
    const size = this.int32(what);
    if (size < 1 || size > this.left)
      throw new BadBytes(`${what} at byte ${at}: length ${size}, ${this.left} bytes are left`);
    const start = this.take(size, what);
    if (this.bytes[start + size - 1] !== 0) throw new BadBytes(`${what} at byte ${at}: no NUL at the end`);
    return decoder.decode(this.bytes.subarray(start, start + size - 1));
  }
}

export class Writer {
  private buffer = new Uint8Array(256);
  private view = new DataView(this.buffer.buffer);
  private size = 0;

  // Moves over `size` bytes, growing when needed, and answers where they begin.
  private room(size: number): number {
    const at = this.size;
    this.size += size;
    if (this.size > this.buffer.length) {
      const larger = new Uint8Array(Math.max(this.size, 2 * this.buffer.length));
      larger.set(this.buffer);
      this.buffer = larger;
      this.view = new DataView(larger.buffer);
    }
    return at;
  }

  int8(value: number): void {
    const at = this.room(1);
    this.view.setInt8(at, value);
  }
  int16(value: number): void {
    const at = this.room(2);
    this.view.setInt16(at, value);
  }
  int32(value: number): void {
    const at = this.room(4);
    this.view.setInt32(at, value);
  }
  int64(value: number): void {
    this.uint64(BigInt(value));
  }
  uint64(value: bigint): void {
    const at = this.room(8);
    this.view.setBigUint64(at, BigInt.asUintN(64, value));
  }
  float(value: number): void {
    const at = this.room(4);
    this.view.setFloat32(at, value);
  }
  double(value: number): void {
    const at = this.room(8);
    this.view.setFloat64(at, value);
  }
  string(value: string): void {
    const text = encoder.encode(value);
    this.int32(text.length + 1);
    this.raw(text);
    this.int8(0);
  }
  raw(bytes: Uint8Array): void {
    const at = this.room(bytes.length);
    this.buffer.set(bytes, at);
  }
  // What was written, in a buffer of its own.
  bytes(): Uint8Array<ArrayBuffer> {
    return this.buffer.slice(0, this.size);
  }
}
