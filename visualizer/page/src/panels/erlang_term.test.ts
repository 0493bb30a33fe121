import { expect, test } from 'vitest';
import { aCase } from '../model/testing';
import { atom, commandsTerm, commandTerm, commandText } from './erlang_term';

const command = { tUs: 0, index: 2, name: 'fault_pos_offset', args: '7, [1500, 0]' };

test('a command is written as the stored case has it', () => {
  expect(commandTerm(command, 'copter_eqc:prop_no_collision')).toBe(
    '{set, {var, 3}, {call, copter_eqc, fault_pos_offset, [7, [1500, 0]]}}',
  );
});

test('without a module the command stands alone', () => {
  expect(commandTerm(command, 'no_collision')).toBe('{fault_pos_offset, [7, [1500, 0]]}');
});

// Erlang reference manual, "Atom": lower case first, then letters, digits, _ and @; others are quoted.
test('names that are no plain atoms are quoted', () => {
  expect(['iterate', 'a_1@b', 'Steer', 'drop-one', "it's", 'a\\b', 'end', ''].map(atom)).toEqual([
    'iterate',
    'a_1@b',
    "'Steer'",
    "'drop-one'",
    "'it\\'s'",
    "'a\\\\b'",
    "'end'",
    "''",
  ]);
});

test('a case is a list that ends with a full stop', () => {
  expect(commandsTerm({ ...aCase([0, 1]), property: 'm:p' })).toBe(
    '[{set, {var, 1}, {call, m, iterate, [0]}},\n {set, {var, 2}, {call, m, iterate, [1]}}].\n',
  );
});

test('shown, it looks like a call', () => {
  expect(commandText(command)).toBe('fault_pos_offset(7, [1500, 0])');
});
