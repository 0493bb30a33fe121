// Keeps marks of one size apart: what would lie on another moves down. No allocation per mark.

const MOST = 256; // beyond, marks stay where they are
const TRIES = 4;

export class Places {
  private count = 0;
  private readonly xs = new Float64Array(MOST);
  private readonly ys = new Float64Array(MOST);

  // Width and height of a mark, CSS pixels.
  constructor(
    private readonly width: number,
    private readonly height: number,
  ) {}

  // A new picture.
  begin(): void {
    this.count = 0;
  }

  // Where the mark that wants to be there may stand: its y.
  free(x: number, y: number): number {
    let placed = y;
    for (let attempt = 0; attempt < TRIES && this.taken(x, placed); attempt++) placed += this.height;
    if (this.count < MOST) {
      this.xs[this.count] = x;
      this.ys[this.count] = placed;
      this.count += 1;
    }
    return placed;
  }

  private taken(x: number, y: number): boolean {
    for (let index = 0; index < this.count; index++) {
      const near = Math.abs((this.xs[index] ?? 0) - x) < this.width;
      if (near && Math.abs((this.ys[index] ?? 0) - y) < this.height - 0.5) return true;
    }
    return false;
  }
}
