// The pictures of map tiles that were shown last, and those that have been asked for.

// What is used of an ImageBitmap.
export type TilePicture = Pick<ImageBitmap, 'width' | 'height' | 'close'>;

// The picture of a tile, null where there is none. Rejects with one line when what comes is no picture.
export type LoadTile<P extends TilePicture> = (z: number, x: number, y: number) => Promise<P | null>;

// Decoded, 256 KiB each at 256 by 256 pixels; at least as many as are shown at once.
export const MOST_HELD = 320;

interface Entry<P> {
  picture: P | null; // null: not there yet, or never
}

export class TileCache<P extends TilePicture> {
  private readonly entries = new Map<string, Entry<P>>(); // those asked for last are last
  private complained = false;

  // `arrived` is called after each picture that has come, `complain` for the first that could not be had.
  constructor(
    private readonly load: LoadTile<P>,
    private readonly arrived: () => void,
    private readonly complain: (line: string) => void,
  ) {}

  // The picture if it is there. If it has never been asked for, it is now, when that is allowed.
  get(z: number, x: number, y: number, mayAsk: boolean): P | null {
    const key = `${z}/${x}/${y}`;
    const known = this.entries.get(key);
    if (known !== undefined) {
      this.entries.delete(key);
      this.entries.set(key, known);
      return known.picture;
    }
    if (mayAsk) void this.ask(key, z, x, y);
    return null;
  }

  // Lets go of all pictures; those still on their way are closed when they come.
  clear(): void {
    for (const { picture } of this.entries.values()) picture?.close();
    this.entries.clear();
  }

  private async ask(key: string, z: number, x: number, y: number): Promise<void> {
    const entry: Entry<P> = { picture: null };
    this.entries.set(key, entry);
    this.makeRoom();
    try {
      const picture = await this.load(z, x, y);
      if (this.entries.get(key) !== entry) picture?.close();
      else if (picture !== null) {
        entry.picture = picture;
        this.arrived();
      }
    } catch (error) {
      if (this.complained || this.entries.get(key) !== entry) return;
      this.complained = true;
      this.complain(error instanceof Error ? error.message : String(error));
    }
  }

  private makeRoom(): void {
    for (const [key, { picture }] of this.entries) {
      if (this.entries.size <= MOST_HELD) return;
      picture?.close();
      this.entries.delete(key);
    }
  }
}
