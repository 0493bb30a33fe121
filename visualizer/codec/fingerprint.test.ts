import { expect, test } from 'vitest';
import { vizSchema } from './viz';

// As lcm-gen 1.3.1 (Debian's liblcm-bin) puts them into the code it makes from lcm/*.lcm.
const lcmGen: Record<string, string> = {
  ack: 'c172967dd907c581',
  anchor: '36e446154ae5cd90',
  case_info: 'f5aef49fbb69fbd7',
  command: 'c2292ca2231b8cf0',
  control: '992a315c5473197a',
  ellipse: 'd8737699dd9739e8',
  event: 'ab11e568455cdf74',
  fault: '1f6b79fbaa82f41c',
  faults: '3487663e0a6c1115',
  frame: '4bd969c0a5717aeb',
  object: 'bd6120f300eb9401',
  poly: '5c8963b4ac254e28',
  range: '513542ec77520407',
  ranges: 'cc80e39ddaa7fd4c',
  risk: 'd89b075ea021c860',
  status: '4c1835a9069c325c',
  world: 'bc9f692e2cdf60bc',
};

test('the fingerprint of every type is that of lcm-gen', () => {
  const ours = vizSchema
    .names()
    .map((name) => [name.replace('viz.', ''), vizSchema.fingerprint(name).toString(16).padStart(16, '0')]);
  expect(Object.fromEntries(ours)).toEqual(lcmGen);
});
