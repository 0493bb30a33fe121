// The range of an axis of values.

// Least and greatest of the axis for data between two values (null: no data).
export function axisRange(min: number | null, max: number | null, fromZero: boolean): [number, number] {
  if (min === null || max === null || !Number.isFinite(min) || !Number.isFinite(max)) return [0, 1];
  if (fromZero) return [0, Math.max(max * 1.12, 0.05)];
  // A part of the value itself, so that the ends differ however large it is.
  const room = Math.max((max - min) * 0.08, 0.05, Math.abs(max) * 1e-6);
  return [min - room, max + room];
}
