import { describe, expect, it } from 'vitest';
import {
  boundsOf,
  fitted,
  MAX_SCALE,
  panned,
  roundLength,
  screenX,
  screenY,
  type View,
  worldX,
  worldY,
  zoomedAt,
} from './view';

const view: View = { x: 2, y: -1, scale: 50, size: { width: 800, height: 600 } };

describe('a view', () => {
  it('has its place in the middle, north up and east right', () => {
    expect([screenX(view, 2), screenY(view, -1)]).toEqual([400, 300]);
    expect([screenX(view, 3), screenY(view, 0)]).toEqual([450, 250]);
  });

  it('turns pixels back into metres', () => {
    expect(worldX(view, screenX(view, 5.25))).toBeCloseTo(5.25);
    expect(worldY(view, screenY(view, -7.5))).toBeCloseTo(-7.5);
  });

  it('is dragged with the pointer', () => {
    const moved = panned(view, 100, -50);
    expect([moved.x, moved.y]).toEqual([0, -2]);
  });

  it('keeps what is under the pointer when it zooms', () => {
    const zoomed = zoomedAt(view, 3, 123, 456);
    expect(zoomed.scale).toBe(150);
    expect(worldX(zoomed, 123)).toBeCloseTo(worldX(view, 123));
    expect(worldY(zoomed, 456)).toBeCloseTo(worldY(view, 456));
    expect(zoomedAt(view, 1e9, 0, 0).scale).toBe(MAX_SCALE);
  });

  it('fits bounds with a margin, whichever side is tight', () => {
    const wide = fitted({ minX: -10, minY: -1, maxX: 10, maxY: 1 }, view.size);
    expect(wide.scale).toBeCloseTo((800 * 0.88) / 20);
    expect([wide.x, wide.y]).toEqual([0, 0]);
    expect(fitted({ minX: 0, minY: 0, maxX: 1, maxY: 10 }, view.size).scale).toBeCloseTo((600 * 0.88) / 10);
  });

  it('fits a single point without dividing by nothing', () => {
    expect(Number.isFinite(fitted({ minX: 3, minY: 3, maxX: 3, maxY: 3 }, view.size).scale)).toBe(true);
  });
});

it('bounds leave out what is no number', () => {
  expect(
    boundsOf([
      [1, 2],
      [NaN, 9],
      [-3, 4],
    ]),
  ).toEqual({ minX: -3, minY: 2, maxX: 1, maxY: 4 });
  expect(boundsOf([[NaN, NaN]])).toBeNull();
});

it('round lengths are 1, 2 or 5 times a power of ten and no longer than asked', () => {
  expect(roundLength(50, 120)).toBe(2);
  expect(roundLength(100, 120)).toBe(1);
  expect(roundLength(20, 120)).toBe(5);
  expect(roundLength(1000, 120)).toBeCloseTo(0.1);
});
