// The lattice hash and 64-bit cells on the JavaScript side: what the shader is started with, and the
// number of the tile under the pointer. The same bits as lattice.glsl and the Python library.

const LARGEST_CELL = 2n ** 61n;

/** Low and high word of the two's complement of a BigInt. */
function words(value) {
  const bits = BigInt.asUintN(64, value);
  return [Number(bits & 0xffffffffn), Number(bits >> 32n)];
}

function mix32(h) {
  h = Math.imul(h ^ (h >>> 16), 0x21f0aaad);
  h = Math.imul(h ^ (h >>> 15), 0xd35a2d97);
  return (h ^ (h >>> 15)) >>> 0;
}

function absorb([a, b], word) {
  a = mix32(a ^ word);
  return [a, mix32(((b ^ a) + word) | 0)];
}

/** State after the stream, the seed and z = 0: what all points of the plane share. */
function startStream(stream, seed) {
  const [low, high] = words(seed);
  return [stream, low, high, 0, 0].reduce(absorb, [0x243f6a88, 0x85a308d3]);
}

/** Color of `count` at a lattice point. */
function colorAt(start, x, y, count) {
  const [xLow, xHigh] = words(x), [yLow, yHigh] = words(y);
  const [a, b] = [xHigh, yHigh, yLow].reduce(absorb, start);
  let h = xLow ^ a;
  h = (Math.imul(h ^ (h >>> 16), 0x21f0aaad) + b) | 0;
  h = Math.imul(h ^ (h >>> 15), 0xd35a2d97);
  h = (h ^ (h >>> 15)) >>> 0;
  return Number((BigInt(h >>> 8) * BigInt(count)) >> 24n);
}

const SECOND_STREAM = { bits: 5, "marked-edges": 4, "marked-sums": 4 };

const VARIANT_STREAM = 6, TONE_STREAM = 512;

/** The tiling of a material: which tile and variant lies at a cell, for a seed. */
class Lattice {
  /**
   * @param tiling {algorithm, radices: [C of N and S, C of E and W, 0, C of corners], indexOfCode | cells and
   *   chance (the seed they were laid with),
   *   variants: {tiles: their number, values: first row of each tile, then the threshold of each row}}
   */
  constructor(tiling) {
    this.tiling = tiling;
    this.setSeed(0n);
  }

  setSeed(seed) {
    this.seed = seed;
    const second = SECOND_STREAM[this.tiling.algorithm];
    this.first = startStream(this.tiling.algorithm === "bits" ? second : 0, seed);
    this.marks = startStream(second ?? 0, seed);
    this.draw = startStream(VARIANT_STREAM, seed);
    // What is stored keeps the seed that it was laid with.
    this.tone = startStream(TONE_STREAM, this.tiling.chance === undefined ? seed : BigInt(this.tiling.chance));
  }

  /** Numbers of the tile at a cell (BigInt, BigInt), -1 where there is none, and of its variant. */
  placementAt(x, y) {
    const { algorithm, variants } = this.tiling, found = this.#lookUp(x, y);
    if (!variants || found < 0) return [found, 0];
    const { tiles, values } = variants;
    let tile = found, row = found;
    if (algorithm === "baked") {
      for (tile = 0; values[tile + 1] <= row;) tile++;
    } else {
      const number = colorAt(this.draw, x, y, 2 ** 24);
      for (row = values[tile]; row + 1 < values[tile + 1] && number >= values[tiles + 2 + row];) row++;
    }
    return [tile, row - values[tile]];
  }

  /** The tile at a cell; its picture where cells are stored. */
  #lookUp(x, y) {
    const { algorithm, radices, cells, indexOfCode } = this.tiling;
    if (algorithm === "baked") {
      const inside = x >= 0n && y >= 0n && x < BigInt(cells.width) && y < BigInt(cells.height);
      return inside ? cells.values[Number(y) * cells.width + Number(x)] : -1;
    }
    const cornered = algorithm === "corners" || algorithm === "classed";
    const edges = cornered ? [] : this.edges(x, y);
    const start = cornered ? this.first : this.marks;
    const corners = cornered || algorithm.startsWith("marked") ? this.corners(start, x, y, radices[3]) : [];
    let code = 0;
    edges.forEach((c, slot) => { code = code * radices[slot % 2] + c; });
    corners.forEach((c) => { code = code * radices[3] + c; });
    return indexOfCode ? indexOfCode.values[code] : code;
  }

  corners(start, x, y, count) {
    const { classes } = this.tiling;
    return [[1n, 0n], [1n, 1n], [0n, 1n], [0n, 0n]].map(([dx, dy]) => {
      if (!classes) return colorAt(start, x + dx, y + dy, count);
      const most = BigInt(classes.classes), at = (x + dx + BigInt(classes.step) * (y + dy)) % most;
      return Number((at + most) % most) * classes.colors + colorAt(start, x + dx, y + dy, classes.colors);
    });
  }

  edges(x, y) {
    const { algorithm, radices: [h, v] } = this.tiling;
    if (algorithm.endsWith("edges")) {
      const [x2, y2] = [2n * x, 2n * y];
      return [
        colorAt(this.first, x2 + 1n, y2, h), colorAt(this.first, x2 + 2n, y2 + 1n, v),
        colorAt(this.first, x2 + 1n, y2 + 2n, h), colorAt(this.first, x2, y2 + 1n, v),
      ];
    }
    if (algorithm.endsWith("sums")) {
      const c = this.corners(this.first, x, y, h);
      return [c[3] + c[0], c[0] + c[1], c[1] + c[2], c[2] + c[3]].map((sum) => sum % h);
    }
    return [this.history(x, y, 0n, 1n), this.history(x + 1n, y, 1n, 0n),
      this.history(x, y + 1n, 0n, 1n), this.history(x, y, 1n, 0n)];
  }

  /** The bits of the tiles before an edge, the latest lowest. */
  history(x, y, dx, dy) {
    let bits = 0;
    for (let back = 1; 1 << back <= this.tiling.radices[0]; back++) {
      const steps = BigInt(back);
      bits |= colorAt(this.first, x - dx * steps, y - dy * steps, 2) << (back - 1);
    }
    return bits;
  }
}
