// Planes made from the photograph without tiles. The place of the origin on the photograph or on the triangle
// grid is taken with whole numbers, so that no digit is lost far out.

const PATCH_STREAMS = [10, 11];

/** What is left of a whole number divided by a positive one, and the quotient rounded down. */
function divideFloor(value, by) {
  const rest = ((value % by) + by) % by;
  return [(value - rest) / by, Number(rest)];
}

class PhotoPlane {
  constructor(renderer, material, { photo, defines }) {
    Object.assign(this, { renderer, gl: renderer.gl, defines, tileSize: BigInt(material.tileSize) });
    this.photo = material.photo;
    this.image = photo;
    this.repeats = defines.includes("REPEAT");
    this.topLevel = Math.floor(Math.log2(Math.min(this.photo.width, this.photo.height)));
    const { gl } = this, { levels, entries, values } = this.photo.inverse;
    if (Math.max(this.photo.width, this.photo.height) > gl.getParameter(gl.MAX_TEXTURE_SIZE)) {
      throw new Error(`This device cannot hold a photograph of ${this.photo.width} x ${this.photo.height} texels.`);
    }
    this.inverse = renderer.table(entries, levels, gl.RGBA32F, gl.RGBA, gl.FLOAT, values);
  }

  isLoaded() { return Boolean(this.program) && this.renderer.photos.has(this.image); }

  async load() {
    this.program ??= this.renderer.planeProgram(this.defines, ["lattice", "photo"]);
    if (this.isLoaded()) return;
    const { width, height, light, images } = this.photo;
    const encoded = [images[this.image]], shown = light && this.image === "color";
    this.renderer.photos.set(
      this.image, await this.renderer.images(encoded, [width, height], shown, 1, this.topLevel));
  }

  use(camera, seed, look) {
    const { gl, photo } = this, { program, uniforms: u } = this.program;
    const [edge, row] = photo.grid;
    gl.useProgram(program);
    gl.activeTexture(gl.TEXTURE1);
    gl.bindTexture(gl.TEXTURE_2D, this.inverse);
    gl.activeTexture(gl.TEXTURE0);
    gl.bindTexture(gl.TEXTURE_2D_ARRAY, this.renderer.photos.get(this.image));
    gl.uniform1i(u.uPhoto, 0);
    gl.uniform1i(u.uInverse, 1);
    gl.uniform2i(u.uPhotoSize, photo.width, photo.height);
    gl.uniform1i(u.uSide, Math.min(photo.width, photo.height));
    gl.uniform1i(u.uTopLevel, this.topLevel);
    gl.uniform4f(u.uMean, ...photo.mean);
    gl.uniform1i(u.uEncode, photo.light ? 1 : 0);
    gl.uniform2ui(u.uPatchX, ...startStream(PATCH_STREAMS[0], seed));
    gl.uniform2ui(u.uPatchY, ...startStream(PATCH_STREAMS[1], seed));
    gl.uniform4i(u.uPatchRange, ...photo.range);
    gl.uniform2i(u.uGrid, edge, row);
    gl.uniformMatrix3fv(u.uAxes, true, photo.axes);
    gl.uniform3f(u.uAverage, ...photo.average);
    this.#place(u, camera);
    return u;
  }

  /** Where the origin cell lies. */
  #place(u, camera) {
    const { gl, photo } = this, x = camera.cellX * this.tileSize, y = camera.cellY * this.tileSize;
    if (this.repeats) {
      gl.uniform2f(u.uStart, divideFloor(x, BigInt(photo.width))[1], divideFloor(y, BigInt(photo.height))[1]);
      return;
    }
    const [edge, row] = photo.grid.map(BigInt);
    const [j, top] = divideFloor(y, row), [i, left] = divideFloor(x - j * (edge / 2n), edge);
    gl.uniform2f(u.uStart, left, top);
    gl.uniform2ui(u.uVertexX, ...words(i));
    gl.uniform2ui(u.uVertexY, ...words(j));
  }

  describe() { return ""; }
}
