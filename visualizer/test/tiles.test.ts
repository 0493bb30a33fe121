// Map tiles: pictures of the bridge's folder below the map, each where it belongs on the Earth.

import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { beforeEach, describe, expect, test } from 'vitest';
import {
  type BridgeProcess,
  expectNoErrors,
  joinPlayer,
  type Opened,
  openLog,
  openPage,
  startBridge,
  temporaryFolder,
} from './harness';
import { pixelsOfMap, pixelsOfPng } from './on_page';
import { plainPng } from './png';
import { frame, sceneLog, status } from './scene';

type Colour = readonly [number, number, number];
type Quarter = 'NW' | 'NE' | 'SW' | 'SE';

// The frame's origin is the north-west corner of tile 10/486/332 (from the documentation of the Python package
// mercantile), hence of tile Z/486 n/332 n for n = 2^(Z - 10) in any deeper zoom Z: four tiles meet there.
const origin = [-9.140625, 53.33087298301705];
const deep = { zoom: 18, x: 486 * 256, y: 332 * 256 };
const shallow = { zoom: 12, x: 486 * 4, y: 332 * 4 }; // the one for the map zoomed out as far as it goes
const attribution = '© Nobody, <b>as text</b>';

const colours = { NE: [220, 30, 30], SW: [30, 160, 30], SE: [40, 40, 220] } as const; // and none in the north-west
const farColour: Colour = [200, 0, 200];

function tileFolder(): string {
  const folder = temporaryFolder();
  const store = (zoom: number, x: number, y: number, colour: Colour): void => {
    mkdirSync(join(folder, `${zoom}/${x}`), { recursive: true });
    writeFileSync(join(folder, `${zoom}/${x}/${y}.png`), plainPng(256, colour));
  };
  const description = { tilejson: '3.0.0', minzoom: shallow.zoom, maxzoom: deep.zoom, attribution, origin };
  writeFileSync(join(folder, 'tiles.json'), JSON.stringify(description));
  store(deep.zoom, deep.x, deep.y - 1, colours.NE);
  store(deep.zoom, deep.x - 1, deep.y, colours.SW);
  store(deep.zoom, deep.x, deep.y, colours.SE);
  for (const dx of [-1, 0])
    for (const dy of [-1, 0]) store(shallow.zoom, shallow.x + dx, shallow.y + dy, farColour);
  return folder;
}

let folder: string;
let bridge: BridgeProcess;
let opened: Opened;
const box = () => opened.page.getByRole('checkbox', { name: 'tiles', exact: true });

beforeEach(async () => {
  folder = tileFolder();
  bridge = await startBridge({ tiles: folder });
  const player = await joinPlayer(bridge);
  opened = await openPage(bridge.url, { colorScheme: 'light' });
  await opened.until((s) => s.connection.connected);
  await player.publish({ channel: 'VIZ_STATUS', value: status(0, { paused: true }) });
  await player.publish({ channel: 'VIZ_FRAME', value: frame(0, 4) });
  await opened.until((s) => s.badge === 'REPLAY');
  await opened.page.keyboard.press('1'); // no grid over what is looked at
});

// Where on the map (CSS pixels) the frame's origin is: the read-out tells the place of the pointer.
async function originOnMap(): Promise<{ x: number; y: number }> {
  const host = await opened.page.locator('.map-host').boundingBox();
  if (!host) throw new Error('no map');
  const placeAt = async (px: number, py: number): Promise<{ x: number; y: number }> => {
    await opened.page.mouse.move(host.x + px, host.y + py);
    const text = (await opened.page.locator('.map-readout').textContent()) ?? '';
    const [, x, y] = /x (\S+) +y (\S+) m/.exec(text) ?? [];
    return { x: Number(x), y: Number(y) };
  };
  const [one, other] = [await placeAt(150, 250), await placeAt(450, 350)];
  const scale = 300 / (other.x - one.x);
  return { x: 150 - one.x * scale, y: 250 + one.y * scale };
}

// The colours of the map 40 pixels from the origin to each side.
async function around(): Promise<Record<Quarter, unknown>> {
  const { x, y } = await originOnMap();
  const places = [-40, 40].flatMap((dy) => [-40, 40].map((dx) => [x + dx, y + dy]));
  const [NW, NE, SW, SE] = await opened.page.evaluate(pixelsOfMap, places);
  return { NW, NE, SW, SE };
}

const style = (name: string): Promise<string> =>
  opened.page.evaluate((n) => getComputedStyle(document.documentElement).getPropertyValue(n), name);

// What the quarters around the origin should look like: the theme's ground, and colours of tiles on it.
async function expected(quarters: Partial<Record<Quarter, Colour>>): Promise<Record<Quarter, unknown>> {
  const ground = rgb(await style('--map-bg'));
  const opacity = Number(await style('--map-tile-opacity'));
  const seen = (colour: Colour = ground): unknown =>
    colour.map((value, i) => {
      const under = ground[i] ?? 0;
      return expect.closeTo(under + (value - under) * opacity, -0.5); // to 1.6
    });
  const { NW, NE, SW, SE } = quarters;
  return { NW: seen(NW), NE: seen(NE), SW: seen(SW), SE: seen(SE) };
}

const rgb = (hex: string): Colour => {
  const value = Number.parseInt(hex.trim().slice(1), 16);
  return [value >> 16, (value >> 8) & 255, value & 255];
};

const shows = async (quarters: Partial<Record<Quarter, Colour>>): Promise<void> =>
  expect.poll(around, { timeout: 5000 }).toEqual(await expected(quarters));

// As far as it goes; there the tiles of the shallow zoom are shown.
async function zoomOut(): Promise<void> {
  await opened.page.locator('canvas.map-canvas').last().focus();
  for (let i = 0; i < 40; i += 1) await opened.page.keyboard.press('-');
}
const far = { NW: farColour, NE: farColour, SW: farColour, SE: farColour };

const asked = (): string[] => opened.requests.filter((url) => url.includes('/tiles/'));

describe('map tiles', () => {
  test('lie where they belong, the missing one is blank, and nobody but the bridge is asked', async () => {
    await shows(colours);
    const { zoom, x, y } = deep;
    const four = [`${x - 1}/${y - 1}`, `${x}/${y - 1}`, `${x - 1}/${y}`, `${x}/${y}`];
    expect(asked().toSorted()).toEqual(four.map((name) => `${bridge.url}tiles/${zoom}/${name}`).toSorted());
    const hosts = opened.requests.map((url) => new URL(url).host);
    expect(new Set(hosts)).toEqual(new Set([new URL(bridge.url).host]));
    expect(bridge.lines.filter((line) => line.includes('refused'))).toEqual([]);
    expectNoErrors(opened);
  });

  test('go and come with their box, and with them whom they are from', async () => {
    const { page } = opened;
    await shows(colours);
    await page.getByText(attribution, { exact: true }).waitFor();
    await box().uncheck();
    await shows({});
    await page.getByText(attribution, { exact: true }).waitFor({ state: 'hidden' });
    await box().check();
    await shows(colours);
    await page.getByText(attribution, { exact: true }).waitFor();
    expect(asked().length).toBe(4); // what was there is not asked for again
    expectNoErrors(opened);
  });

  test('are dimmer in the dark', async () => {
    await shows(colours);
    const light = Number(await style('--map-tile-opacity'));
    await opened.page.keyboard.press('d');
    await opened.page.locator('html[data-theme=dark]').waitFor({ state: 'attached' });
    expect(Number(await style('--map-tile-opacity'))).toBeLessThan(light);
    await shows(colours);
    expectNoErrors(opened);
  });

  test('are those of another zoom when the map is zoomed', async () => {
    await shows(colours);
    await zoomOut();
    await shows(far);
    expectNoErrors(opened);
  });

  test('are not asked for while the bridge is away, and come when it does', async () => {
    await shows(colours);
    await bridge.kill();
    await opened.until((s) => s.badge === 'DISCONNECTED');
    await zoomOut();
    await shows({});
    expect(asked().length).toBe(4);
    await bridge.restart();
    await shows(far);
  });

  test('that are no pictures are blank, and one line names the first', async () => {
    await shows(colours);
    writeFileSync(join(folder, `${shallow.zoom}/${shallow.x}/${shallow.y}.png`), 'no picture');
    await zoomOut();
    const { SE: _, ...rest } = far;
    await shows(rest);
    const name = `${shallow.zoom}/${shallow.x}/${shallow.y}`;
    await opened.page.getByText(`map tile ${name}: not a picture that this browser knows`).waitFor();
    expectNoErrors(opened);
  });

  test('are in the picture, with whom they are from', async () => {
    await shows(colours);
    const { x, y } = await originOnMap();
    const [download] = await Promise.all([
      opened.page.waitForEvent('download'),
      opened.page.keyboard.press('p'),
    ]);
    const file = join(temporaryFolder(), 'map.png');
    await download.saveAs(file);
    const png = readFileSync(file).toString('base64');
    const pixels = await opened.page.evaluate(pixelsOfPng, {
      png,
      places: [
        [x + 40, y + 40],
        [-1, -13],
      ],
    });
    const plain = rgb(await style('--map-bg'));
    expect(pixels[0]).toEqual((await expected(colours)).SE);
    expect(pixels[1]).toEqual(plain); // where the text is, the tile of the south-east is not
  });
});

test('a file in a page without a bridge has no layer of tiles', async () => {
  const file = await openLog(sceneLog());
  expect(await file.page.getByRole('checkbox', { name: 'terrain', exact: true }).count()).toBe(1);
  expect(await file.page.getByRole('checkbox', { name: 'tiles', exact: true }).count()).toBe(0);
});
