// The bridge's map tiles: GET /tiles/Z/X/Y.

// The picture, null where the bridge has none (204). Rejects with one line.
export async function fetchTile(base: string, z: number, x: number, y: number): Promise<ImageBitmap | null> {
  const answer = await fetch(`${base}/tiles/${z}/${x}/${y}`);
  if (answer.status === 204) return null;
  if (!answer.ok) throw new Error(`map tile ${z}/${x}/${y}: the bridge answers ${answer.status}`);
  const blob = await answer.blob();
  return createImageBitmap(blob).catch(() => {
    throw new Error(`map tile ${z}/${x}/${y}: not a picture that this browser knows`);
  });
}
