// Small pictures of buttons, as paths in a field of 16 by 16.

const paths = {
  play: 'M4 2.5v11l9.5-5.5z',
  pause: 'M4 2.5h3v11H4zM9.5 2.5h3v11h-3z',
  start: 'M2.5 2.5h2v11h-2zM13.5 2.5v11L5.5 8z',
  back: 'M11.5 2.5v11L3.5 8z',
  forward: 'M4.5 2.5v11l8-5.5z',
  previousEvent: 'M8 3l-5 5 5 5V9.2h5.5V6.8H8z',
  nextEvent: 'M8 3l5 5-5 5V9.2H2.5V6.8H8z',
  loop: 'M4.5 3.5h7A3 3 0 0 1 14.5 6.5v1h-1.7v-1a1.3 1.3 0 0 0-1.3-1.3h-7V7L1.5 4.35 4.5 1.7zM11.5 12.5h-7A3 3 0 0 1 1.5 9.5v-1h1.7v1a1.3 1.3 0 0 0 1.3 1.3h7V9l3 2.65-3 2.65z',
  theme: 'M8 1.5a6.5 6.5 0 1 1 0 13zM8 1.5a6.5 6.5 0 1 0 0 13v-1.4A5.1 5.1 0 0 1 8 2.9z',
  close: 'M3.4 2.3 8 6.9l4.6-4.6 1.1 1.1L9.1 8l4.6 4.6-1.1 1.1L8 9.1l-4.6 4.6-1.1-1.1L6.9 8 2.3 3.4z',
  copy: 'M5.5 1.5h8v9h-8zM7 3v6h5V3zM2.5 5H4v8.5h6.5V15h-8z',
  left: 'M1.5 2.5h13v11h-13zM6.5 4v8H13V4z',
  right: 'M1.5 2.5h13v11h-13zM3 4v8h6.5V4z',
} as const;

export type IconName = keyof typeof paths;

const svgSpace = 'http://www.w3.org/2000/svg';

export function icon(name: IconName): SVGSVGElement {
  const svg = document.createElementNS(svgSpace, 'svg');
  svg.setAttribute('viewBox', '0 0 16 16');
  svg.setAttribute('aria-hidden', 'true');
  svg.setAttribute('class', 'icon');
  const path = document.createElementNS(svgSpace, 'path');
  path.setAttribute('fill-rule', 'evenodd');
  path.setAttribute('d', paths[name]);
  svg.append(path);
  return svg;
}
