import { expect, it } from 'vitest';
import { escaped, SvgSurface } from './svg_surface';

it('text cannot become markup', () => {
  const surface = new SvgSurface();
  surface.fillText('<script>"&\u0000', 1, 2);
  const svg = surface.document(10, 10, 'a <b>');
  expect(svg).toContain('&lt;script&gt;&quot;&amp; </text>');
  expect(svg).toContain('<title>a &lt;b&gt;</title>');
  expect(escaped('a\u0007b\nc')).toBe('a b\nc');
});

it('numbers that XML has no word for do not get in', () => {
  const surface = new SvgSurface();
  surface.beginPath();
  surface.moveTo(NaN, Infinity);
  surface.lineTo(1.23456, -1);
  surface.stroke();
  expect(surface.document(1, 1, '')).toContain('d="M0 0L1.23 -1"');
});

it('an ellipse is two half turns about its axis', () => {
  const surface = new SvgSurface();
  surface.beginPath();
  surface.ellipse(10, 20, 4, 2, Math.PI / 2);
  surface.fill();
  expect(surface.document(1, 1, '')).toContain('M10 24A4 2 90 1 1 10 16A4 2 90 1 1 10 24Z');
});
