// Reads LCM type definitions (.lcm files): packages and structs of primitive and nested members with fixed or
// variable dimensions. Constants and enums, which no type of ours has, are refused.

export const primitives = [
  'int8_t',
  'int16_t',
  'int32_t',
  'int64_t',
  'float',
  'double',
  'string',
  'boolean',
  'byte',
] as const;
export type Primitive = (typeof primitives)[number];

export interface Dimension {
  text: string; // as written: "3", or the name of the member that holds the count
  fixed: number | null; // null: variable
}

export interface Member {
  name: string;
  type: string; // a primitive, or the full name of a struct: "viz.object"
  primitive: boolean;
  dimensions: Dimension[]; // outermost first
}

export interface Struct {
  name: string; // with its package: "viz.frame"
  members: Member[];
}

const isPrimitive = (type: string): boolean => (primitives as readonly string[]).includes(type);

// The words and signs of a definition; comments and blanks are left out.
function tokens(text: string): string[] {
  const bare = text.replace(/\/\*[\s\S]*?\*\//g, ' ').replace(/\/\/[^\n]*/g, ' ');
  return bare.match(/[A-Za-z_][\w.]*|\d+|[^\s]/g) ?? [];
}

class Parser {
  private at = 0;
  private readonly words: string[];
  private readonly file: string;
  private pkg = '';

  constructor(text: string, file: string) {
    this.words = tokens(text);
    this.file = file;
  }

  structs(): Struct[] {
    const found: Struct[] = [];
    while (this.at < this.words.length) {
      const word = this.next('"package" or "struct"');
      if (word === 'package') {
        this.pkg = this.name();
        this.sign(';');
      } else if (word === 'struct') found.push(this.struct());
      else this.fail('"package" or "struct"', word);
    }
    return found;
  }

  private struct(): Struct {
    const name = this.qualified(this.name());
    const members: Member[] = [];
    this.sign('{');
    while (!this.skip('}')) members.push(...this.declaration());
    for (const member of members) this.checkCounts(member, members);
    return { name, members };
  }

  // TYPE NAME[DIMENSION]..., NAME...;
  private declaration(): Member[] {
    const word = this.name();
    if (word === 'const' || word === 'enum') this.fail('a member', word);
    const primitive = isPrimitive(word);
    const type = primitive ? word : this.qualified(word);
    const members: Member[] = [];
    do members.push({ name: this.name(), type, primitive, dimensions: this.dimensions() });
    while (this.skip(','));
    this.sign(';');
    return members;
  }

  private dimensions(): Dimension[] {
    const found: Dimension[] = [];
    while (this.skip('[')) {
      const text = this.next('a dimension');
      if (!/^(\d+|[A-Za-z_]\w*)$/.test(text)) this.fail('a dimension', text);
      found.push({ text, fixed: /^\d/.test(text) ? Number(text) : null });
      this.sign(']');
    }
    return found;
  }

  // A count comes before what it counts and is a whole number.
  private checkCounts(member: Member, all: Member[]): void {
    for (const { text, fixed } of member.dimensions) {
      if (fixed !== null) continue;
      const count = all.slice(0, all.indexOf(member)).find(({ name }) => name === text);
      if (!count || !/^int(8|16|32|64)_t$/.test(count.type) || count.dimensions.length > 0)
        this.fail(`a whole number "${text}" before "${member.name}"`, 'none');
    }
  }

  private qualified(name: string): string {
    return name.includes('.') || this.pkg === '' ? name : `${this.pkg}.${name}`;
  }

  private name(): string {
    const word = this.next('a name');
    return /^[A-Za-z_]/.test(word) ? word : this.fail('a name', word);
  }

  private next(wanted: string): string {
    const word = this.words[this.at];
    if (word === undefined) return this.fail(wanted, 'the end');
    this.at += 1;
    return word;
  }

  private skip(sign: string): boolean {
    if (this.words[this.at] !== sign) return false;
    this.at += 1;
    return true;
  }

  private sign(sign: string): void {
    const word = this.next(`"${sign}"`);
    if (word !== sign) this.fail(`"${sign}"`, word);
  }

  private fail(wanted: string, got: string): never {
    throw new Error(`${this.file}: expected ${wanted}, got ${got}`);
  }
}

// The structs of one file, in order. Throws one line: file, what was expected, what came.
export function parseTypes(text: string, file: string): Struct[] {
  return new Parser(text, file).structs();
}
