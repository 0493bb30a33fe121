import { describe, expect, test } from 'vitest';
import { parseOptions, UsageError } from './options';

describe('the command line', () => {
  test('without options: this host alone, no control', () => {
    expect(parseOptions([])).toEqual({
      port: 8765,
      bind: '127.0.0.1',
      group: {
        host: '239.255.76.67',
        port: 7667,
        multicast: true,
        ttl: 0,
        receiveBuffer: 2097152,
        network: false,
      },
      cases: 'cases',
      tiles: null,
      page: null,
      tokenFile: null,
    });
  });

  test.each([
    ['--group', 'udpm://239.1.2.3:7000?ttl=0&recv_buf_size=100'],
    ['--lcm-url', 'udpm://239.1.2.3:7000?recv_buf_size=100'],
    ['--group', '239.1.2.3:7000?recv_buf_size=100'],
  ])('%s %s', (option, url) => {
    expect(parseOptions([option, url])?.group).toMatchObject({
      host: '239.1.2.3',
      port: 7000,
      ttl: 0,
      receiveBuffer: 100,
    });
  });

  test('unicast', () => {
    expect(parseOptions(['--udp', '127.0.0.1:7667'])?.group).toMatchObject({ multicast: false, port: 7667 });
  });

  test('the network is entered only when told so', () => {
    const group = parseOptions(['--allow-network', '--group', 'udpm://239.1.2.3:7000?ttl=1'])?.group;
    expect(group).toMatchObject({ ttl: 1, network: true });
  });

  test.each([
    [['--port', '65536'], '--port: expected a whole number from 0 to 65535, got "65536"'],
    [['--port', 'x'], '--port: expected a whole number from 0 to 65535, got "x"'],
    [['--bind', 'localhost'], '--bind: expected an IPv4 address, got "localhost"'],
    [
      ['--group', 'udpm://239.1.2.3:7000?ttl=1'],
      '--group: ttl=1 would leave this host; needs --allow-network',
    ],
    [['--group', 'udpm://239.1.2.3'], '--group: expected ADDRESS:PORT with an IPv4 address, got "239.1.2.3"'],
    [['--group', '127.0.0.1:7667'], '--group: expected a multicast address, 224 to 239, got 127.0.0.1'],
    [['--group', '239.1.2.3:7000?speed=1'], '--group: expected ttl and recv_buf_size, got "speed"'],
    [['--group', '239.1.2.3:7000?ttl=-1'], '--group: ttl: expected a whole number from 0 to 255, got "-1"'],
    [['--udp', '192.168.0.1:1'], '--udp: 192.168.0.1 is not on this host alone; needs --allow-network'],
    [['--udp', '127.0.0.1:1', '--group', '239.1.2.3:1'], '--udp and --group: expected one of them, got both'],
    [['--allow-control'], '--allow-control and --token-file: expected both or none, got one'],
    [['--token-file', 'x'], '--allow-control and --token-file: expected both or none, got one'],
    [
      ['--bind', '0.0.0.0', '--allow-control', '--token-file', 'x'],
      '--allow-control with --bind 0.0.0.0: other hosts would control; needs --insecure-remote-control',
    ],
    [['--nonsense'], /nonsense/],
    [['more'], /more/],
  ])('%j is refused in one line', (argv, line) => {
    const parse = (): unknown => parseOptions(argv);
    expect(parse).toThrow(UsageError);
    expect(parse).toThrow(line);
  });
});
