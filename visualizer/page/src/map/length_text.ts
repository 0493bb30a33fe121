// A length in words: '2 m', '50 mm', '1.2 km'; all in mm for those who asked for that.

export function lengthText(metres: number, unit: 'm' | 'mm' = 'm'): string {
  if (unit === 'mm') return `${trim(metres * 1000)} mm`;
  if (metres >= 1000) return `${trim(metres / 1000)} km`;
  return metres >= 0.1 ? `${trim(metres)} m` : `${trim(metres * 1000)} mm`;
}

function trim(value: number): string {
  return String(Number(value.toPrecision(3)));
}
