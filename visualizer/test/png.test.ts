// The pictures of docs/ are made smaller without changing a pixel: the browser itself compares.

import { expect, test } from 'vitest';
import { openLog } from './harness';
import { smallerPng } from './png';
import { sceneLog } from './scene';

test('a picture is smaller, and the same to the pixel', async () => {
  const { page } = await openLog(sceneLog());
  const before = await page.screenshot();
  const after = smallerPng(before);
  expect(after.length).toBeLessThan(before.length);
  const blank = await page.context().newPage();
  const differing = await blank.evaluate(
    async (pictures) => {
      const pixels = await Promise.all(
        pictures.map(async (base64) => {
          const picture = new Image();
          picture.src = `data:image/png;base64,${base64}`;
          await picture.decode();
          const canvas = new OffscreenCanvas(picture.width, picture.height);
          const context = canvas.getContext('2d');
          context?.drawImage(picture, 0, 0);
          return context?.getImageData(0, 0, picture.width, picture.height).data;
        }),
      );
      const [one, other] = pixels;
      return one?.reduce((count, value, i) => count + Number(value !== other?.[i]), 0);
    },
    [before, after].map((picture) => picture.toString('base64')),
  );
  expect(differing).toBe(0);
});
