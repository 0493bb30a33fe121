import { describe, expect, it } from 'vitest';
import { testPalette } from '../map/testing';
import { SvgSurface } from '../map/svg_surface';
import { aCase } from '../model/testing';
import { laneBars, laneCount } from './lanes';
import { LEFT, plotWidth, RIGHT, secondsText, timeToX, xToTime } from './plot_area';
import { sliderTarget } from './slider_keys';
import { drawRows, type Rows, rowsHeight } from './timeline_rows';
import { valueText } from './value_text';

const S = 1e6;
const fault = (fromS: number, toS: number, probe = 'PxId1') => ({
  object: 1,
  probe,
  type: 'offset',
  params: '{"value":1}',
  fromUs: fromS * S,
  toUs: toS < 0 ? -1 : toS * S,
  active: false,
  hits: 0,
});
const area = { width: LEFT + 800 + RIGHT, span: { fromUs: 0, toUs: 8 * S } };

describe('lanes', () => {
  it('bars that overlap have lanes of their own, others share one', () => {
    const bars = laneBars([fault(3, -1), fault(0, 2), fault(1, 4), fault(2, 3)], 8 * S);
    expect(bars.map((bar) => [bar.fault.fromUs / S, bar.toUs / S, bar.lane])).toEqual([
      [0, 2, 0],
      [1, 4, 1],
      [2, 3, 0],
      [3, 8, 0],
    ]);
    expect(laneCount(bars)).toBe(2);
  });

  it('faults of one instant do not hide one another', () => {
    expect(laneCount(laneBars([fault(1, 1), fault(1, 1)], 8 * S))).toBe(2);
  });

  it('many lanes get lower instead of taking all the room', () => {
    const bars = laneBars(
      Array.from({ length: 40 }, () => fault(0, 8)),
      8 * S,
    );
    expect(rowsHeight(bars)).toBeLessThan(130);
  });
});

describe('the plot area', () => {
  it('turns times into pixels and back', () => {
    expect([timeToX(area, 0), timeToX(area, 8 * S), plotWidth(area.width)]).toEqual([LEFT, LEFT + 800, 800]);
    expect(xToTime(area, timeToX(area, 3.3 * S))).toBeCloseTo(3.3 * S);
    expect([xToTime(area, 0), xToTime(area, 9999)]).toEqual([0, 8 * S]);
  });

  it('writes seconds with as many digits as the steps need', () => {
    expect(secondsText(2.5 * S, 2.5 * S)).toBe('2.5 s');
    expect([secondsText(2 * S, S), secondsText(2 * S, 0.5 * S), secondsText(0.25 * S, 0.01 * S)]).toEqual([
      '2 s',
      '2.0 s',
      '0.25 s',
    ]);
  });
});

describe('rows', () => {
  const rows: Rows = {
    palette: testPalette,
    caseInfo: aCase([0, 2 * S]),
    currentCommand: 0,
    failingCommand: 1,
    bars: laneBars([fault(2, 6)], 8 * S),
    avoiding: [{ fromUs: 1 * S, toUs: 2 * S }],
    collisions: [{ tUs: 7 * S, a: 1, b: 2, terrain: false, x: 0, y: 0 }],
    failureUs: 7 * S,
    heldUs: { fromUs: 0, toUs: 8 * S },
    loop: null,
  };
  const drawn = (change: Partial<Rows> = {}): string => {
    const surface = new SvgSurface();
    drawRows(surface, area, { ...rows, ...change });
    return surface.document(area.width, 100, '');
  };

  it('the fault has a bar from begin to end, with its letter and its words', () => {
    expect(drawn()).toContain(`M${LEFT + 200} 23h400v14h-400Z`);
    expect(drawn()).toMatch(/>P<\/text>[\s\S]*>PxId1 offset 1<\/text>/);
  });

  it('the failing command is red, the verdict a cross', () => {
    expect(drawn()).toMatch(/d="M272 9h599v8h-599Z" fill="--bad"/);
    const x = LEFT + 700;
    expect(drawn()).toContain(`M${x - 5} `);
    expect(drawn({ collisions: [], failureUs: null })).not.toContain(`M${x - 5} `);
  });

  it('commands that inject are triangles', () => {
    const info = aCase([0]);
    const command = { tUs: 4 * S, index: 1, name: 'inject_fault', args: '' };
    const svg = drawn({ caseInfo: { ...info, commands: [...info.commands, command] } });
    expect(svg).toContain(`M${LEFT + 400} 5L${LEFT + 406} 19L${LEFT + 394} 19Z`);
  });

  it('what is looped is shaded', () => {
    expect(drawn({ loop: { fromUs: 1 * S, toUs: 2 * S } })).toContain(`M${LEFT + 100} 0h100v`);
  });
});

describe('the slider', () => {
  it('goes by tenths and whole seconds, to the ends and no further', () => {
    const target = (key: string, shift = false) => sliderTarget(key, shift, 4 * S, 0, 8 * S);
    expect([
      target('ArrowRight'),
      target('ArrowLeft', true),
      target('PageUp'),
      target('Home'),
      target('End'),
    ]).toEqual([4_100_000, 3_000_000, 4_800_000, 0, 8_000_000]);
    expect(sliderTarget('ArrowLeft', true, 0.5 * S, 0, 8 * S)).toBe(0);
    expect(target('x')).toBeNull();
  });

  it('says time, command and whether it is after the collision', () => {
    const facts = {
      tUs: 2.5 * S,
      durationUs: 8 * S,
      caseInfo: aCase([0, 2 * S]),
      currentCommand: 1,
      collisions: [],
    };
    expect(valueText(facts)).toBe('2.50 of 8.00 seconds, command 2, iterate');
    const collisions = [{ tUs: 2 * S, a: 1, b: 2, terrain: false, x: 0, y: 0 }];
    expect(valueText({ ...facts, collisions })).toContain('after the collision');
  });
});
