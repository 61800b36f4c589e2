// Where one looks from. The place is a 64-bit cell and texels within it, so that panning never runs out;
// zoom is in device pixels per texel; tilt turns the picture into a plane in perspective.

const MAX_TILT = 80 * Math.PI / 180;
const MAX_ZOOM = 64;

class Camera {
  constructor(tileSize) {
    this.tileSize = tileSize;
    this.width = this.height = 1;
    this.reset();
  }

  reset() {
    this.cellX = this.cellY = 0n;
    this.x = this.y = 0;
    this.zoom = 1;
    this.tilt = this.turn = 0;
  }

  get minZoom() { return 2 / this.tileSize; }

  /** Pixels from the eye to the middle of the view. */
  get focal() { return 1.2 * this.height; }

  get isFlat() { return this.tilt === 0 && this.turn === 0; }

  /** Move by texels; the cell takes over what exceeds a tile. */
  move(dx, dy) {
    [this.cellX, this.x] = this.#carry(this.cellX, this.x + dx);
    [this.cellY, this.y] = this.#carry(this.cellY, this.y + dy);
  }

  #carry(cell, texel) {
    const cells = Math.floor(texel / this.tileSize);
    cell += BigInt(cells);
    const limit = LARGEST_CELL - 1n;
    if (cell > limit || cell < -limit) return [cell > 0n ? limit : -limit, 0];
    return [cell, texel - cells * this.tileSize];
  }

  /** Texels from the middle of the view to the ground at a pixel (from the view's corner), at a zoom. */
  ground(px, py, zoom = this.zoom) {
    const cos = Math.cos(this.tilt), sin = Math.sin(this.tilt);
    const sx = px - this.width / 2, sy = py - this.height / 2;
    const depth = Math.max(cos + sy * sin / this.focal, 0.05);  // just below the horizon
    const y = sy / depth, x = sx * (1 - y * sin / this.focal);
    const c = Math.cos(this.turn), s = Math.sin(this.turn);
    return [(c * x - s * y) / zoom, (s * x + c * y) / zoom];
  }

  /** Whether a pixel shows the plane, not what is above the horizon. */
  showsGround(py) {
    return Math.cos(this.tilt) + (py - this.height / 2) * Math.sin(this.tilt) / this.focal > 1e-4;
  }

  /** Move so that the ground seen at one pixel is seen at another. */
  drag(fromX, fromY, toX, toY) {
    const [ax, ay] = this.ground(fromX, fromY), [bx, by] = this.ground(toX, toY);
    this.move(ax - bx, ay - by);
  }

  /** Zoom by a factor, keeping the ground at a pixel where it is; 1:1 is not stepped over. */
  zoomAt(px, py, factor) {
    let zoom = Math.min(MAX_ZOOM, Math.max(this.minZoom, this.zoom * factor));
    if ((zoom - 1) * (this.zoom - 1) < 0 || Math.abs(zoom - 1) < 1e-6) zoom = 1;
    const [ax, ay] = this.ground(px, py), [bx, by] = this.ground(px, py, zoom);
    this.zoom = zoom;
    this.move(ax - bx, ay - by);
  }

  tiltBy(radians) { this.tilt = Math.min(MAX_TILT, Math.max(0, this.tilt + radians)); }

  turnBy(radians) {
    const turn = (this.turn + radians) % (2 * Math.PI);
    this.turn = Math.abs(turn) < 0.01 ? 0 : turn;
  }

  /**
   * Texels from the cell's corner to the middle of the view, as drawn. Seen from straight above at a whole
   * number of pixels per texel, texels are laid on pixels, so that nothing is blurred by half a pixel.
   */
  get drawnCenter() {
    if (!this.isFlat || !Number.isInteger(this.zoom)) return [this.x, this.y];
    const snap = (texel, size) => (Math.round(texel * this.zoom - size / 2) + size / 2) / this.zoom;
    return [snap(this.x, this.width), snap(this.y, this.height)];
  }

  /** The cell and the texel in it at a pixel: {cellX, cellY, x, y}. */
  locate(px, py) {
    const [cx, cy] = this.drawnCenter, [dx, dy] = this.ground(px, py);
    const [cellX, x] = this.#carry(this.cellX, cx + dx), [cellY, y] = this.#carry(this.cellY, cy + dy);
    return { cellX, cellY, x, y };
  }
}
