// Functions that browser tests run inside of the page: they may use nothing from outside of themselves.

export interface SeenControl {
  what: string; // tag, role and text, to name it in a failure
  width: number; // CSS pixels, of the label where one belongs to it
  height: number;
}

// Every control that is shown and not disabled, in the order of the document.
export function seenControls(): SeenControl[] {
  const selector = 'button, select, input, summary, a[href], [tabindex="0"]';
  const seen: SeenControl[] = [];
  for (const element of document.querySelectorAll<HTMLElement>(selector)) {
    const off = element.matches(':disabled') || element.tabIndex < 0;
    if (off || !element.checkVisibility({ visibilityProperty: true })) continue;
    const target = element instanceof HTMLInputElement ? (element.closest('label') ?? element) : element;
    const { width, height } = target.getBoundingClientRect();
    const labels = element instanceof HTMLInputElement ? element.labels : null;
    const name = element.getAttribute('aria-label') ?? labels?.[0]?.textContent ?? element.textContent ?? '';
    seen.push({ what: `${element.tagName} ${element.id} ${name.slice(0, 40)}`, width, height });
  }
  return seen;
}

// How the focused element is called by seenControls, and whether its focus can be seen.
export function focused(): { what: string; visible: boolean } | null {
  const element = document.activeElement;
  if (!(element instanceof HTMLElement) || element === document.body) return null;
  const labels = element instanceof HTMLInputElement ? element.labels : null;
  const name = element.getAttribute('aria-label') ?? labels?.[0]?.textContent ?? element.textContent ?? '';
  const style = getComputedStyle(element);
  const outlined = style.outlineStyle !== 'none' && Number.parseFloat(style.outlineWidth) >= 1;
  return { what: `${element.tagName} ${element.id} ${name.slice(0, 40)}`, visible: outlined };
}

// The least contrast of a text that is shown with what is behind it, by the formula of WCAG 2.2, and where it is. What
// is disabled is not counted; nor is what lies over a canvas or a picture without a background of its own.
export function leastContrast(): { ratio: number; text: string } {
  type Rgba = readonly [number, number, number, number];
  const rgba = (colour: string): Rgba => {
    const [r = 0, g = 0, b = 0, a = 1] = (/\(([^)]*)\)/.exec(colour)?.[1] ?? '').split(/[ ,/]+/).map(Number);
    return [r, g, b, a];
  };
  const luminance = ([r, g, b]: Rgba): number => {
    const [x = 0, y = 0, z = 0] = [r, g, b].map((value) => {
      const part = value / 255;
      return part <= 0.04045 ? part / 12.92 : ((part + 0.055) / 1.055) ** 2.4;
    });
    return 0.2126 * x + 0.7152 * y + 0.0722 * z;
  };
  const behind = (element: Element): Rgba | null => {
    for (let at: Element | null = element; at !== null; at = at.parentElement) {
      const colour = rgba(getComputedStyle(at).backgroundColor);
      if (colour[3] === 1) return colour;
      if (colour[3] > 0) return null;
    }
    return [255, 255, 255, 1];
  };
  let least = { ratio: 21, text: '' };
  const walker = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
  for (let node = walker.nextNode(); node !== null; node = walker.nextNode()) {
    const element = node.parentElement;
    const text = node.textContent?.trim() ?? '';
    if (element === null || text === '' || !element.checkVisibility({ visibilityProperty: true })) continue;
    if (element.closest(':disabled, option, noscript, svg') !== null) continue;
    const background = behind(element);
    if (background === null) continue;
    const [low = 0, high = 0] = [
      luminance(rgba(getComputedStyle(element).color)),
      luminance(background),
    ].sort((a, b) => a - b);
    const ratio = (high + 0.05) / (low + 0.05);
    if (ratio < least.ratio)
      least = { ratio, text: `${text.slice(0, 40)} in ${element.className || element.tagName}` };
  }
  return least;
}

// The colours of what stands still on the map at some places (device pixels).
export function pixelsOfMap(places: number[][]): number[][] {
  const canvas = document.querySelector<HTMLCanvasElement>('canvas.map-canvas');
  if (canvas === null) return [];
  const copy = new OffscreenCanvas(canvas.width, canvas.height).getContext('2d', {
    willReadFrequently: true,
  });
  copy?.drawImage(canvas, 0, 0);
  return places.map(([x = 0, y = 0]) => {
    const read = copy?.getImageData(Math.round(x), Math.round(y), 1, 1);
    return [...(read?.data.slice(0, 3) ?? [])];
  });
}

// The colours of a PNG (base64) at some places, from the left and the top, or if negative from the right and the bottom.
export async function pixelsOfPng({ png, places }: { png: string; places: number[][] }): Promise<number[][]> {
  const bytes = Uint8Array.from(atob(png), (char) => char.charCodeAt(0));
  const picture = await createImageBitmap(new Blob([bytes], { type: 'image/png' }));
  const { width, height } = picture;
  const copy = new OffscreenCanvas(width, height).getContext('2d', { willReadFrequently: true });
  copy?.drawImage(picture, 0, 0);
  return places.map(([x = 0, y = 0]) => {
    const [left, top] = [x < 0 ? width + x : x, y < 0 ? height + y : y];
    return [...(copy?.getImageData(Math.round(left), Math.round(top), 1, 1).data.slice(0, 3) ?? [])];
  });
}
