import { describe, expect, test } from 'vitest';
import { parseHello, parseRequest, parseServerText, unwrap, wrap } from './protocol';
import { checkVerb } from './verbs';

const request = { seq: 1, verb: 'seek', object: -1, args: [7.42], text: '', token: 'abc' };

describe('messages to the page', () => {
  test('a binary message is the length of the channel, the channel, the payload', () => {
    const bytes = wrap('AB', new Uint8Array([1, 2]));
    expect([...bytes]).toEqual([2, 65, 66, 1, 2]);
    expect(unwrap(bytes)).toEqual({ channel: 'AB', payload: new Uint8Array([1, 2]) });
  });

  test.each([[[]], [[0, 1]], [[2, 65]], [[1]]])('%j is none', (bytes) => {
    expect(unwrap(new Uint8Array(bytes))).toMatch(/^a message of \d bytes with a channel of \d$/);
  });

  test('the hello of another version says "rebuild"', () => {
    expect(parseHello('{"v":2}')).toBe('the bridge speaks another version of viz.v1: rebuild');
    expect(parseHello('no json')).toMatch(/rebuild/);
    expect(parseHello('{"v":1}')).toBe('the first message of the bridge is no hello');
  });

  test('the hello is read', () => {
    const hello = {
      v: 1,
      start: 's',
      control: true,
      token: 't',
      client: 'c',
      group: 'g',
      tiles: { origin: [11.97, 57.69], minzoom: 14, maxzoom: 19, attribution: '' },
      channels: { A: 'viz.a' },
    };
    expect(parseHello(JSON.stringify(hello))).toEqual(hello);
    expect(parseHello(JSON.stringify({ ...hello, tiles: undefined }))).toEqual({ ...hello, tiles: null });
    expect(parseHello(JSON.stringify({ ...hello, tiles: 7 }))).toBe(
      'the map tiles of the bridge: expected a JSON object',
    );
  });

  test('later texts are statistics or refusals', () => {
    const stats = { udp: 1, lost: 2, dropped: 3, bytesPerSec: 4 };
    expect(parseServerText(JSON.stringify({ stats }))).toEqual({ stats });
    expect(parseServerText('{"refused":{"seq":1,"text":"no"}}')).toEqual({ refused: { seq: 1, text: 'no' } });
    expect(parseServerText('{"news":1}')).toBeNull();
    expect(parseServerText('[')).toBeNull();
  });
});

describe('requests from the page', () => {
  test('a good one is read', () => {
    expect(parseRequest(JSON.stringify(request))).toEqual(request);
  });

  test.each([
    ['seq', -1, 'seq: expected a whole number from 0'],
    ['seq', 1.5, 'seq: expected a whole number from 0'],
    ['seq', 2 ** 31, 'seq: expected a whole number from 0'],
    ['verb', 1, 'verb: expected a string'],
    ['object', -2, 'object: expected a whole number from -1'],
    ['object', '1', 'object: expected a whole number from -1'],
    ['args', 7, 'args: expected an array of finite numbers'],
    ['args', [null], 'args: expected an array of finite numbers'],
    ['args', ['1'], 'args: expected an array of finite numbers'],
    ['text', null, 'text: expected a string'],
    ['token', undefined, 'token: expected a string'],
  ])('%s: %j is refused', (member, value, line) => {
    expect(parseRequest(JSON.stringify({ ...request, [member]: value }))).toBe(line);
  });

  test.each(['', 'null', '[]', '1', '{'])('"%s" is no request', (text) => {
    expect(parseRequest(text)).toBe('a request is one JSON object');
  });

  test('more than 4 KiB are not even read', () => {
    expect(parseRequest(JSON.stringify({ ...request, text: 'x'.repeat(4096) }))).toBe(
      'a request of more than 4096 bytes',
    );
  });
});

describe('verbs', () => {
  const check = (verb: string, args: number[] = [], object = -1, text = ''): string =>
    checkVerb({ verb, args, object, text });

  test.each([
    ['play', [], -1, ''],
    ['speed', [0.05], -1, ''],
    ['speed', [20], -1, ''],
    ['step', [-5], -1, ''],
    ['load', [1], -1, 'copter_2026-01-01'],
    ['steer', [0.1, -0.1, 1], 3, ''],
    ['set', [1.5], -1, 'pos_p'],
    ['inject', [], 3, '{"probe":"range"}'],
    ['clear_faults', [], -1, ''],
    ['add_object', [1, 2], -1, ''],
    ['scenario', [], -1, 'crossing.json'],
    ['stop_all', [], -1, ''],
  ])('%s is passed on', (verb, args, object, text) => {
    expect(check(verb, args, object, text)).toBe('');
  });

  test.each([
    ['fly', [], -1, '', /^verb: expected one of play, pause,/],
    ['constructor', [], -1, '', /^verb: expected one of/],
    ['play', [1], -1, '', 'play: expected 0 arguments, got 1'],
    ['play', [], -1, 'x', 'play: text: expected no text'],
    ['speed', [0.04], -1, '', 'speed: factor: expected a number from 0.05 to 20, got 0.04'],
    ['speed', [21], -1, '', 'speed: factor: expected a number from 0.05 to 20, got 21'],
    ['step', [0.5], -1, '', 'step: frames: expected a whole number from -100000 to 100000, got 0.5'],
    ['seek', [-1], -1, '', 'seek: seconds: expected a number from 0 to 1000000, got -1'],
    ['steer', [0, 0, 0], -1, '', 'steer: expected an object'],
    ['steer', [2, 0, 0], 1, '', 'steer: roll (rad): expected a number from -1.5708 to 1.5708, got 2'],
    ['load', [0], -1, '../x', 'load: text: expected a case id: 1 to 64 letters, digits, - and _'],
    ['scenario', [], -1, '../x', 'scenario: text: expected a file name without a folder'],
    ['scenario', [], -1, '..', 'scenario: text: expected a file name without a folder'],
    ['inject', [], 1, '[]', 'inject: text: expected a JSON object'],
    ['set', [1], 1, 'a b', 'set: text: expected a name: 1 to 64 letters, digits, . - and _'],
  ])('%s %j %i "%s" is refused', (verb, args, object, text, line) => {
    expect(check(verb, args, object, text)).toMatch(line);
  });
});
