// The fingerprint that begins each LCM payload: 64 bits over the names, types and dimensions of all members,
// nested types included, so that two programs with different layouts never read each other's bytes.

import type { Struct } from './lcm_syntax';

const signed = (v: bigint): bigint => BigInt.asIntN(64, v);
const utf8 = new TextEncoder();

function mixNumber(hash: bigint, byte: number): bigint {
  const c = BigInt(byte > 127 ? byte - 256 : byte);
  return signed(((hash << 8n) ^ (hash >> 55n)) + c);
}

function mixText(hash: bigint, text: string): bigint {
  const bytes = utf8.encode(text);
  return bytes.reduce(mixNumber, mixNumber(hash, bytes.length));
}

// Of the members of one struct alone. The struct's own name and the names of nested types do not count.
function ownHash(struct: Struct): bigint {
  let hash = 0x12345678n;
  for (const { name, type, primitive, dimensions } of struct.members) {
    hash = mixText(hash, name);
    if (primitive) hash = mixText(hash, type);
    hash = mixNumber(hash, dimensions.length);
    for (const { text, fixed } of dimensions) hash = mixText(mixNumber(hash, fixed === null ? 1 : 0), text);
  }
  return hash;
}

// Fingerprint of a struct as an unsigned 64-bit number. A type that contains itself counts as 0 inside.
export function fingerprint(name: string, types: ReadonlyMap<string, Struct>, within: string[] = []): bigint {
  if (within.includes(name)) return 0n;
  const struct = types.get(name);
  if (!struct) throw new Error(`${within.at(-1) ?? 'fingerprint'}: no type ${name}`);
  const nested = struct.members.filter(({ primitive }) => !primitive);
  const sum = nested.reduce(
    (hash, { type }) => hash + fingerprint(type, types, [...within, name]),
    ownHash(struct),
  );
  const hash = BigInt.asUintN(64, sum);
  return BigInt.asUintN(64, (hash << 1n) + (hash >> 63n));
}
