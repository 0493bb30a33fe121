// Decodes and encodes any struct of a set of LCM types, after their definitions.
//
// Values: a struct is an object whose keys are the members in camel case (t_us: tUs), an array an array, strings
// are strings, all else is a number. A member that only counts another one is left out, the array's length says it.
// Members listed as flags (int8_t, 0 or not) are booleans.

import { BadBytes, Reader, Writer } from './bytes';
import { fingerprint } from './fingerprint';
import { type Member, parseTypes, type Primitive, type Struct } from './lcm_syntax';

export type LcmValue = number | string | boolean | LcmValue[] | { [member: string]: LcmValue };
export type LcmStruct = { [member: string]: LcmValue };

interface Dimension {
  fixed: number | null;
  count: string; // member that holds the count
  countedKey: string; // key of the first array that it counts
}

interface Field {
  member: Member;
  dimensions: Dimension[];
  key: string;
  path: string; // "frame.t_us", for messages
  flag: boolean;
  countedKey: string | null; // of a count: key of the first array that it counts
  itemSize: number; // the fewest bytes that one item may take
}

interface Layout {
  name: string;
  fields: Field[];
  size: number; // the fewest bytes
  fingerprint: bigint;
}

const fewest: Record<Primitive, number> = {
  int8_t: 1,
  boolean: 1,
  byte: 1,
  int16_t: 2,
  int32_t: 4,
  int64_t: 8,
  float: 4,
  double: 8,
  string: 5,
};

const camelCase = (name: string): string =>
  name.replace(/_([a-z])/g, (_, letter: string) => letter.toUpperCase());

export class Schema {
  private readonly structs = new Map<string, Struct>();
  private readonly layouts = new Map<string, Layout>();
  private readonly flags: ReadonlySet<string>;

  // files: name and text of each .lcm file. flags: "struct.member" without the package. Throws one line.
  constructor(files: Iterable<readonly [string, string]>, flags: Iterable<string> = []) {
    this.flags = new Set(flags);
    for (const [file, text] of files)
      for (const struct of parseTypes(text, file)) this.structs.set(struct.name, struct);
  }

  // The full names of all types.
  names(): string[] {
    return [...this.structs.keys()];
  }

  fingerprint(name: string): bigint {
    return this.layout(name).fingerprint;
  }

  // A payload of this type, its fingerprint already compared. Throws BadBytes.
  decode(name: string, payload: Uint8Array): LcmStruct {
    const reader = new Reader(payload, 8);
    const value = this.readStruct(this.layout(name), reader);
    if (reader.left > 0) throw new BadBytes(`${name}: ${reader.left} bytes too many`);
    return value;
  }

  // The payload, fingerprint first. A missing or wrong member throws one line.
  encode(name: string, value: object): Uint8Array<ArrayBuffer> {
    const writer = new Writer();
    writer.uint64(this.layout(name).fingerprint);
    this.writeStruct(this.layout(name), value as LcmStruct, writer);
    return writer.bytes();
  }

  private layout(name: string): Layout {
    const known = this.layouts.get(name);
    if (known) return known;
    const struct = this.structs.get(name);
    if (!struct) throw new Error(`no type ${name}`);
    const layout: Layout = { name, fields: [], size: 0, fingerprint: fingerprint(name, this.structs) };
    this.layouts.set(name, layout);
    for (const member of struct.members) {
      const field = this.field(struct, member);
      layout.fields.push(field);
      const fixed = member.dimensions.map((d) => d.fixed ?? 0).reduce((a, b) => a * b, 1);
      layout.size += fixed * field.itemSize;
    }
    return layout;
  }

  private field(struct: Struct, member: Member): Field {
    const short = `${struct.name.replace(/^.*\./, '')}.${member.name}`;
    const counted = (count: string): string | null => {
      const array = struct.members.find(({ dimensions }) => dimensions[0]?.text === count);
      return array ? camelCase(array.name) : null;
    };
    return {
      member,
      dimensions: member.dimensions.map(({ fixed, text }) => ({
        fixed,
        count: text,
        countedKey: counted(text) ?? camelCase(member.name),
      })),
      key: camelCase(member.name),
      path: short,
      flag: this.flags.has(short),
      countedKey: counted(member.name),
      itemSize: member.primitive ? fewest[member.type as Primitive] : this.layout(member.type).size,
    };
  }

  private readStruct(layout: Layout, reader: Reader): LcmStruct {
    const value: LcmStruct = {};
    const counts = new Map<string, number>();
    for (const field of layout.fields) {
      const read = this.readDimension(field, 0, counts, reader);
      if (field.countedKey !== null) counts.set(field.member.name, read as number);
      else value[field.key] = read;
    }
    return value;
  }

  private readDimension(field: Field, depth: number, counts: Map<string, number>, reader: Reader): LcmValue {
    const dimension = field.dimensions[depth];
    if (!dimension) return this.readItem(field, reader);
    const count = dimension.fixed ?? counts.get(dimension.count) ?? 0;
    // Before room is made for them: so many items must be there.
    const size = field.dimensions.slice(depth + 1).reduce((n, d) => n * (d.fixed ?? 1), field.itemSize);
    if (count < 0 || count * size > reader.left)
      throw new BadBytes(`${field.path} at byte ${reader.at}: ${count} items in ${reader.left} bytes`);
    const items: LcmValue[] = [];
    for (let i = 0; i < count; i += 1) items.push(this.readDimension(field, depth + 1, counts, reader));
    return items;
  }

  private readItem(field: Field, reader: Reader): LcmValue {
    const { type, primitive } = field.member;
    if (!primitive) return this.readStruct(this.layout(type), reader);
    switch (type as Primitive) {
      case 'int8_t':
        return field.flag ? reader.int8(field.path) !== 0 : reader.int8(field.path);
      case 'boolean':
        return reader.int8(field.path) !== 0;
      case 'byte':
        return reader.int8(field.path) & 0xff;
      case 'int16_t':
        return reader.int16(field.path);
      case 'int32_t':
        return reader.int32(field.path);
      case 'int64_t':
        return reader.int64(field.path);
      case 'float':
        return reader.float(field.path);
      case 'double':
        return reader.double(field.path);
      case 'string':
        return reader.string(field.path);
    }
  }

  private writeStruct(layout: Layout, value: LcmStruct, writer: Writer): void {
    for (const field of layout.fields) {
      const { countedKey } = field;
      const written = countedKey === null ? value[field.key] : length(value[countedKey], field);
      this.writeDimension(field, 0, written, value, writer);
    }
  }

  private writeDimension(
    field: Field,
    depth: number,
    value: LcmValue | undefined,
    owner: LcmStruct,
    writer: Writer,
  ): void {
    const dimension = field.dimensions[depth];
    if (!dimension) {
      this.writeItem(field, value, writer);
      return;
    }
    const count = dimension.fixed ?? length(owner[dimension.countedKey], field);
    if (!Array.isArray(value) || value.length !== count)
      throw new Error(`${field.path}: expected an array of ${count}`);
    for (const item of value) this.writeDimension(field, depth + 1, item, owner, writer);
  }

  private writeItem(field: Field, value: LcmValue | undefined, writer: Writer): void {
    const { type, primitive } = field.member;
    if (!primitive) {
      if (typeof value !== 'object' || Array.isArray(value))
        throw new Error(`${field.path}: expected an object`);
      this.writeStruct(this.layout(type), value, writer);
    } else if (type === 'string') {
      if (typeof value !== 'string') throw new Error(`${field.path}: expected a string`);
      writer.string(value);
    } else writeNumber(type as Primitive, toNumber(field, value), writer);
  }
}

function length(value: LcmValue | undefined, field: Field): number {
  if (!Array.isArray(value)) throw new Error(`${field.path}: expected the array that it counts`);
  return value.length;
}

const bits: Partial<Record<Primitive, number>> = { int8_t: 8, int16_t: 16, int32_t: 32, int64_t: 64 };

function toNumber(field: Field, value: LcmValue | undefined): number {
  const number = typeof value === 'boolean' ? Number(value) : value;
  if (typeof number !== 'number') throw new Error(`${field.path}: expected a number`);
  const width = bits[field.member.type as Primitive];
  if (
    width !== undefined &&
    !(Number.isSafeInteger(number) && number < 2 ** (width - 1) && number >= -(2 ** (width - 1)))
  )
    throw new Error(`${field.path}: ${number} is no ${field.member.type}`);
  return number;
}

function writeNumber(type: Primitive, value: number, writer: Writer): void {
  if (type === 'int16_t') writer.int16(value);
  else if (type === 'int32_t') writer.int32(value);
  else if (type === 'int64_t') writer.int64(value);
  else if (type === 'float') writer.float(value);
  else if (type === 'double') writer.double(value);
  else writer.int8(value);
}
