// A drawing surface that writes SVG: the same calls as a canvas context, a text as result.

import type { Surface } from './surface';

type Paint = CanvasRenderingContext2D['fillStyle'];

export class SvgSurface implements Surface {
  fillStyle: Paint = '#000';
  strokeStyle: Paint = '#000';
  lineWidth = 1;
  lineJoin: CanvasLineJoin = 'miter';
  font = '12px sans-serif';
  textAlign: CanvasTextAlign = 'start';
  textBaseline: CanvasTextBaseline = 'alphabetic';
  globalAlpha = 1;
  private dash: readonly number[] = [];
  private path: string[] = [];
  private readonly elements: string[] = [];

  beginPath(): void {
    this.path = [];
  }

  closePath(): void {
    this.path.push('Z');
  }

  moveTo(x: number, y: number): void {
    this.path.push(`M${short(x)} ${short(y)}`);
  }

  lineTo(x: number, y: number): void {
    this.path.push(`L${short(x)} ${short(y)}`);
  }

  rect(x: number, y: number, width: number, height: number): void {
    this.path.push(`M${short(x)} ${short(y)}h${short(width)}v${short(height)}h${short(-width)}Z`);
  }

  // Whole ellipses only, which is all that is drawn: as two halves, since an arc of SVG cannot go
  // all the way round.
  ellipse(x: number, y: number, rx: number, ry: number, rotation: number): void {
    const dx = rx * Math.cos(rotation);
    const dy = rx * Math.sin(rotation);
    const turn = `A${short(rx)} ${short(ry)} ${short((rotation * 180) / Math.PI)} 1 1`;
    this.path.push(
      `M${short(x + dx)} ${short(y + dy)}${turn} ${short(x - dx)} ${short(y - dy)}` +
        `${turn} ${short(x + dx)} ${short(y + dy)}Z`,
    );
  }

  // Nothing is written for an empty path.
  fill(): void {
    if (this.path.length === 0) return;
    this.add(`<path d="${this.path.join('')}" fill="${escaped(String(this.fillStyle))}"${this.opacity()}/>`);
  }

  stroke(): void {
    if (this.path.length === 0) return;
    const dash = this.dash.length > 0 ? ` stroke-dasharray="${this.dash.join(' ')}"` : '';
    this.add(
      `<path d="${this.path.join('')}" fill="none" stroke="${escaped(String(this.strokeStyle))}"` +
        ` stroke-width="${short(this.lineWidth)}" stroke-linejoin="${this.lineJoin}"${dash}${this.opacity()}/>`,
    );
  }

  setLineDash(segments: Iterable<number>): void {
    this.dash = [...segments];
  }

  fillText(text: string, x: number, y: number): void {
    const anchor = ANCHORS[this.textAlign];
    const baseline = BASELINES[this.textBaseline];
    this.add(
      `<text x="${short(x)}" y="${short(y)}" style="font:${escaped(this.font)}" text-anchor="${anchor}"` +
        ` dominant-baseline="${baseline}" fill="${escaped(String(this.fillStyle))}"${this.opacity()}>` +
        `${escaped(text)}</text>`,
    );
  }

  // The document, of so many CSS pixels.
  document(width: number, height: number, title: string): string {
    const size = `width="${short(width)}" height="${short(height)}"`;
    return (
      `<svg xmlns="http://www.w3.org/2000/svg" ${size} viewBox="0 0 ${short(width)} ${short(height)}">\n` +
      `<title>${escaped(title)}</title>\n${this.elements.join('\n')}\n</svg>\n`
    );
  }

  private add(element: string): void {
    this.elements.push(element);
  }

  private opacity(): string {
    return this.globalAlpha < 1 ? ` opacity="${short(this.globalAlpha)}"` : '';
  }
}

const ANCHORS: Record<CanvasTextAlign, string> = {
  start: 'start',
  left: 'start',
  center: 'middle',
  end: 'end',
  right: 'end',
};

const BASELINES: Record<CanvasTextBaseline, string> = {
  alphabetic: 'alphabetic',
  bottom: 'text-after-edge',
  hanging: 'hanging',
  ideographic: 'ideographic',
  middle: 'central',
  top: 'text-before-edge',
};

// Hundredths of a pixel are enough, and numbers that XML does not know must not get in.
function short(value: number): string {
  return Number.isFinite(value) ? String(Math.round(value * 100) / 100) : '0';
}

// Text for XML; control characters are not allowed in it at all.
export function escaped(text: string): string {
  let safe = '';
  for (const char of text) {
    const code = char.codePointAt(0) ?? 0;
    if (code < 32 && code !== 9 && code !== 10) safe += ' ';
    else safe += ENTITIES[char] ?? char;
  }
  return safe;
}

const ENTITIES: Readonly<Record<string, string>> = { '&': '&amp;', '<': '&lt;', '>': '&gt;', '"': '&quot;' };
