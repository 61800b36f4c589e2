// Names of patches, as `pick` and `reject` take them: told for squares of a few texels, unpacked when first asked.

class PatchNames {
  /** @param patches {step, names, pictures: [{names: numbers of names, runs}]}, as patches.py writes them */
  constructor(patches, tileSize) {
    Object.assign(this, patches);
    this.across = Math.ceil((tileSize - (this.step >> 1)) / this.step);
    this.squares = new Map();
  }

  /** The patch that a picture shows at a texel; "" where that is not known. */
  at(picture, x, y) {
    const [column, row] = [x, y].map((texel) => Math.min(this.across - 1, Math.max(0, Math.floor(texel / this.step))));
    const number = this.#unpack(picture)[row * this.across + column];
    return this.names[this.pictures[picture].names[number]] ?? "";
  }

  #unpack(picture) {
    let found = this.squares.get(picture);
    if (found) return found;
    found = new Uint8Array(this.across ** 2);
    const runs = atob(this.pictures[picture].runs);
    for (let i = 0, at = 0; i < runs.length; i += 2) {
      found.fill(runs.charCodeAt(i), at, at += runs.charCodeAt(i + 1));
    }
    this.squares.set(picture, found);
    return found;
  }
}
