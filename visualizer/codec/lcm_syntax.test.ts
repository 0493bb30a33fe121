import { describe, expect, test } from 'vitest';
import { parseTypes } from './lcm_syntax';

describe('definitions of LCM types', () => {
  test('members carry type, dimensions and the package of nested types', () => {
    const [struct] = parseTypes(
      `// a comment
       package p; /* another
       one */
       struct s { int32_t n; float a[n][3], b; other c[2]; q.far d; }`,
      's.lcm',
    );
    expect(struct?.name).toBe('p.s');
    expect(struct?.members.map(({ name, type }) => [name, type])).toEqual([
      ['n', 'int32_t'],
      ['a', 'float'],
      ['b', 'float'],
      ['c', 'p.other'],
      ['d', 'q.far'],
    ]);
    expect(struct?.members[1]?.dimensions).toEqual([
      { text: 'n', fixed: null },
      { text: '3', fixed: 3 },
    ]);
  });

  test.each([
    ['struct s { int32_t a }', 's.lcm: expected ";", got }'],
    ['struct s { float a[n]; }', 's.lcm: expected a whole number "n" before "a", got none'],
    ['struct s { float n; float a[n]; }', 's.lcm: expected a whole number "n" before "a", got none'],
    ['struct s { const int32_t A = 1; }', 's.lcm: expected a member, got const'],
    ['enum e { A }', 's.lcm: expected "package" or "struct", got enum'],
    ['struct s { float a[-1]; }', 's.lcm: expected a dimension, got -'],
    ['struct s {', 's.lcm: expected a name, got the end'],
  ])('%s is refused in one line', (text, line) => {
    expect(() => parseTypes(text, 's.lcm')).toThrow(line);
  });
});
