// Commands of a case as Erlang terms, to be pasted into a shell or a test.

import type { CaseInfo, Command } from '../../../codec/messages';

// An atom as Erlang reads it.
export function atom(name: string): string {
  if (/^[a-z][A-Za-z0-9_@]*$/.test(name) && !reserved.has(name)) return name;
  return `'${name.replace(/[\\']/g, '\\$&')}'`;
}

const reserved = new Set(
  (
    'after and andalso band begin bnot bor bsl bsr bxor case catch cond div else end fun if let maybe not of or ' +
    'orelse receive rem try when xor'
  ).split(' '),
);

// `module:property' names the model; without a module the command stands alone.
export function commandTerm(command: Command, property: string): string {
  const module = /^([^:]+):/.exec(property)?.[1];
  const args = `[${command.args}]`;
  const name = atom(command.name);
  if (module === undefined) return `{${name}, ${args}}`;
  return `{set, {var, ${command.index + 1}}, {call, ${atom(module)}, ${name}, ${args}}}`;
}

export function commandsTerm(info: CaseInfo): string {
  const terms = info.commands.map((command) => commandTerm(command, info.property));
  return `[${terms.join(',\n ')}].\n`;
}

// As shown: add_copter(0, -50, 120).
export function commandText(command: Command): string {
  return `${command.name}(${command.args})`;
}
