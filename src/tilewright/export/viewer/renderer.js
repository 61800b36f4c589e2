// WebGL2: tiles in a texture array, their mip levels, and one triangle over the canvas.
//
// A layer holds a square of tiles. The shader fetches texels and filters by itself across tile borders, so
// tiles need no gutter, may share a layer, and 2048 texels and 256 layers, which every device has, hold
// 65,536 tiles of 128 texels.

const LAYER_SIDE = 2048;
const TRIANGLE = `#version 300 es
void main() { gl_Position = vec4(gl_VertexID == 1 ? 3 : -1, gl_VertexID == 2 ? 3 : -1, 0, 1); }`;

/** Draws planes: each is a TilePlane or a PhotoPlane, with a fragment shader of its own. */
class Renderer {
  /** @param shaders {plane, mip, lattice, tiles, photo}: texts, the last only where there is a comparison */
  constructor(canvas, material, shaders) {
    this.canvas = canvas;
    const gl = canvas.getContext("webgl2", { alpha: false, antialias: false, depth: false, stencil: false });
    if (!gl) throw new Error("This page needs WebGL 2, which this browser does not offer or has switched off.");
    this.gl = gl;
    this.shaders = shaders;
    this.mip = this.program(shaders.mip);
    this.photos = new Map();
    this.planes = material.planes.map((plane) =>
      plane.tiles ? new TilePlane(this, material.tileSize, plane) : new PhotoPlane(this, material, plane));
  }

  /** Compile the fragment shader of a plane: what all share, its defines, and what it shows. */
  planeProgram(defines, parts) {
    const source = [defines, ...parts.map((name) => this.shaders[name])].join("\n");
    return this.program(this.shaders.plane.replace("// SOURCE", () => source));
  }

  program(fragment) {
    const { gl } = this;
    const program = gl.createProgram();
    for (const [kind, source] of [[gl.VERTEX_SHADER, TRIANGLE], [gl.FRAGMENT_SHADER, fragment]]) {
      const shader = gl.createShader(kind);
      gl.shaderSource(shader, source);
      gl.compileShader(shader);
      gl.attachShader(program, shader);
      if (!gl.getShaderParameter(shader, gl.COMPILE_STATUS) && !gl.isContextLost()) {
        throw new Error(`The shader does not compile here: ${gl.getShaderInfoLog(shader)}`);
      }
    }
    gl.linkProgram(program);
    if (!gl.getProgramParameter(program, gl.LINK_STATUS) && !gl.isContextLost()) {
      throw new Error(`The shader does not link here: ${gl.getProgramInfoLog(program)}`);
    }
    const uniforms = {};
    for (let i = 0; i < gl.getProgramParameter(program, gl.ACTIVE_UNIFORMS); i++) {
      const { name } = gl.getActiveUniform(program, i);
      uniforms[name] = gl.getUniformLocation(program, name);
    }
    return { program, uniforms };
  }

  /** Numbers in a texture that the shader looks up. */
  table(width, height, internal, format, type, values) {
    const { gl } = this;
    const texture = gl.createTexture();
    gl.bindTexture(gl.TEXTURE_2D, texture);
    gl.pixelStorei(gl.UNPACK_ALIGNMENT, 1);
    gl.texStorage2D(gl.TEXTURE_2D, 1, internal, width, height);
    gl.texSubImage2D(gl.TEXTURE_2D, 0, 0, 0, width, height, format, type, values);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.NEAREST);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MAG_FILTER, gl.NEAREST);
    return texture;
  }

  /**
   * Decode images of one size and put them and their mip levels on the device: `across` x `across` of them on
   * each layer.
   */
  async images(encoded, [width, height], light, across, topLevel) {
    const { gl } = this;
    const images = await Promise.all(encoded.map(decodeImage));
    const layers = Math.ceil(images.length / across ** 2);
    const texture = gl.createTexture();
    gl.bindTexture(gl.TEXTURE_2D_ARRAY, texture);
    gl.pixelStorei(gl.UNPACK_PREMULTIPLY_ALPHA_WEBGL, false);
    gl.pixelStorei(gl.UNPACK_COLORSPACE_CONVERSION_WEBGL, gl.NONE);
    const format = light ? gl.SRGB8_ALPHA8 : gl.RGBA8;
    gl.texStorage3D(gl.TEXTURE_2D_ARRAY, topLevel + 1, format, across * width, across * height, layers);
    images.forEach((image, tile) => {
      const place = tile % across ** 2;
      gl.texSubImage3D(gl.TEXTURE_2D_ARRAY, 0, (place % across) * width, Math.floor(place / across) * height,
        Math.floor(tile / across ** 2), width, height, 1, gl.RGBA, gl.UNSIGNED_BYTE, image);
    });
    gl.texParameteri(gl.TEXTURE_2D_ARRAY, gl.TEXTURE_MIN_FILTER, gl.NEAREST_MIPMAP_NEAREST);
    gl.texParameteri(gl.TEXTURE_2D_ARRAY, gl.TEXTURE_MAG_FILTER, gl.NEAREST);
    this.#fillLevels(texture, [width, height], across, layers, topLevel);
    return texture;
  }

  #fillLevels(texture, [width, height], across, layers, topLevel) {
    const { gl, mip: { program, uniforms } } = this;
    const frame = gl.createFramebuffer();
    gl.bindFramebuffer(gl.FRAMEBUFFER, frame);
    gl.disable(gl.SCISSOR_TEST);
    gl.useProgram(program);
    gl.activeTexture(gl.TEXTURE0);
    gl.bindTexture(gl.TEXTURE_2D_ARRAY, texture);
    gl.uniform1i(uniforms.uTiles, 0);
    gl.uniform1i(uniforms.uAcross, across);
    for (let level = 0; level < topLevel; level++) {
      gl.texParameteri(gl.TEXTURE_2D_ARRAY, gl.TEXTURE_BASE_LEVEL, level);
      gl.texParameteri(gl.TEXTURE_2D_ARRAY, gl.TEXTURE_MAX_LEVEL, level);
      gl.uniform2i(uniforms.uSize, width >> level, height >> level);
      gl.viewport(0, 0, across * (width >> (level + 1)), across * (height >> (level + 1)));
      for (let layer = 0; layer < layers; layer++) {
        gl.framebufferTextureLayer(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, texture, level + 1, layer);
        gl.uniform1i(uniforms.uLayer, layer);
        gl.drawArrays(gl.TRIANGLES, 0, 3);
      }
    }
    gl.texParameteri(gl.TEXTURE_2D_ARRAY, gl.TEXTURE_BASE_LEVEL, 0);
    gl.texParameteri(gl.TEXTURE_2D_ARRAY, gl.TEXTURE_MAX_LEVEL, topLevel);
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
    gl.deleteFramebuffer(frame);
  }

  /**
   * Draw what a camera sees; `coarse` pixels of the screen become one.
   * @param shown [{plane: number, from, to}]: planes, and the share of the width that each takes
   */
  draw(camera, seed, look, shown, coarse = 1) {
    const { gl } = this;
    const width = Math.max(1, Math.round(camera.width / coarse));
    const height = Math.max(1, Math.round(camera.height / coarse));
    if (this.canvas.width !== width || this.canvas.height !== height) {
      this.canvas.width = width;
      this.canvas.height = height;
    }
    gl.viewport(0, 0, width, height);
    gl.enable(gl.SCISSOR_TEST);
    for (const { plane, from, to } of shown) {
      const left = Math.round(from * width);
      gl.scissor(left, 0, Math.round(to * width) - left, height);
      const uniforms = this.planes[plane].use(camera, seed, look);
      this.#look(uniforms, camera, look, coarse, width, height);
      gl.drawArrays(gl.TRIANGLES, 0, 3);
    }
  }

  #look(u, camera, look, coarse, width, height) {
    const { gl } = this;
    gl.uniform2f(u.uCenter, ...camera.drawnCenter);
    gl.uniform1f(u.uScale, coarse / camera.zoom);
    gl.uniform2f(u.uViewport, width, height);
    gl.uniform1f(u.uFocal, camera.focal / coarse);
    gl.uniform2f(u.uTilt, Math.cos(camera.tilt), Math.sin(camera.tilt));
    gl.uniform2f(u.uTurn, Math.cos(camera.turn), Math.sin(camera.turn));
    gl.uniform1i(u.uBorders, look.borders ? 1 : 0);
    gl.uniform1f(u.uPixelRatio, look.pixelRatio / coarse);
    gl.uniform3f(u.uSky, ...look.sky);
    gl.uniform3f(u.uBackdrop, ...look.backdrop);
  }

  /** The pixels drawn last, rows from the top: {width, height, data: RGBA bytes}. Read at once after draw. */
  pixels() {
    const { gl } = this, { width, height } = this.canvas;
    const upward = new Uint8Array(4 * width * height);
    gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, upward);
    const data = new Uint8Array(upward.length);
    for (let row = 0; row < height; row++) {
      data.set(upward.subarray(4 * width * row, 4 * width * (row + 1)), 4 * width * (height - 1 - row));
    }
    return { width, height, data };
  }
}

/** Tiles of one set, laid by its tiling. */
class TilePlane {
  constructor(renderer, size, { tiles }) {
    const { gl } = renderer;
    Object.assign(this, { renderer, gl, size, tiles });
    this.across = Math.min(Math.max(1, Math.floor(LAYER_SIDE / size)), Math.ceil(Math.sqrt(tiles.count)));
    this.topLevel = Math.floor(Math.log2(size));
    if (this.across * size > gl.getParameter(gl.MAX_TEXTURE_SIZE) ||
        Math.ceil(tiles.count / this.across ** 2) > gl.getParameter(gl.MAX_ARRAY_TEXTURE_LAYERS)) {
      throw new Error(`This device cannot hold ${tiles.count} tiles of ${size} texels.`);
    }
    this.lattice = new Lattice(tiles.tiling);
    this.patches = tiles.patches?.step && new PatchNames(tiles.patches, size);
    const { width, height, values } =
      tiles.tiling.cells ?? tiles.tiling.indexOfCode ?? { width: 1, height: 1, values: new Uint16Array(1) };
    this.table = renderer.table(width, height, gl.R16UI, gl.RED_INTEGER, gl.UNSIGNED_SHORT, values);
    const { variants } = tiles.tiling;
    this.variants = variants && renderer.table(
      variants.width, variants.height, gl.R32UI, gl.RED_INTEGER, gl.UNSIGNED_INT, variants.values);
    this.textures = new Map();
    this.tones = tiles.maps.map(({ tone }) => tone && this.#loadTone(tone));
  }

  isLoaded(map) { return this.textures.has(map); }

  /** A picture of tone with its mip levels. */
  #loadTone({ width, height, values }) {
    const { gl } = this, texture = gl.createTexture();
    const levels = Math.floor(Math.log2(Math.max(width, height))) + 1;
    gl.bindTexture(gl.TEXTURE_2D, texture);
    gl.pixelStorei(gl.UNPACK_ALIGNMENT, 1);
    gl.texStorage2D(gl.TEXTURE_2D, levels, gl.RGBA16F, width, height);
    for (let level = 0, at = 0; level < levels; level++) {
      const [w, h] = [width, height].map((side) => Math.max(1, side >> level));
      gl.texSubImage2D(gl.TEXTURE_2D, level, 0, 0, w, h, gl.RGBA, gl.HALF_FLOAT, values.subarray(at, at + 4 * w * h));
      at += 4 * w * h;
    }
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.LINEAR_MIPMAP_LINEAR);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MAG_FILTER, gl.LINEAR);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_WRAP_S, gl.MIRRORED_REPEAT);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_WRAP_T, gl.MIRRORED_REPEAT);
    return texture;
  }

  #useTone(camera, map, u) {
    const { gl, lattice, tiles } = this, { tone } = tiles.tiling, span = BigInt(tone.span);
    const rest = (cell) => ((cell % span) + span) % span;
    gl.uniform1i(u.uToned, this.tones[map] ? 1 : 0);
    gl.activeTexture(gl.TEXTURE3);
    gl.bindTexture(gl.TEXTURE_2D, this.tones[map] ?? this.tones.find(Boolean));
    gl.uniform1i(u.uTone, 3);
    gl.uniform3f(u.uToneMean, ...tiles.maps[map].tone?.mean ?? [0, 0, 0]);
    gl.uniform1i(u.uSpan, tone.span);
    gl.uniform1f(u.uTexel, tone.texel);
    gl.uniform2ui(u.uToneState, ...lattice.tone);
    gl.uniform2ui(u.uSquareX, ...words((camera.cellX - rest(camera.cellX)) / span));
    gl.uniform2ui(u.uSquareY, ...words((camera.cellY - rest(camera.cellY)) / span));
    gl.uniform2f(u.uSquareRest, this.size * Number(rest(camera.cellX)), this.size * Number(rest(camera.cellY)));
  }

  async load(map) {
    if (this.isLoaded(map)) return;
    this.program ??= this.renderer.planeProgram(this.tiles.defines, ["lattice", "tiles"]);
    const { tiles, light } = this.tiles.maps[map], size = [this.size, this.size];
    this.textures.set(map, await this.renderer.images(tiles, size, light, this.across, this.topLevel));
  }

  /** Make this the plane that is drawn; gives its uniforms. */
  use(camera, seed, look) {
    const { gl, tiles: { tiling, maps, repeat }, lattice } = this, { program, uniforms: u } = this.program;
    lattice.setSeed(seed);
    gl.useProgram(program);
    gl.activeTexture(gl.TEXTURE1);
    gl.bindTexture(gl.TEXTURE_2D, this.table);
    gl.activeTexture(gl.TEXTURE0);
    gl.bindTexture(gl.TEXTURE_2D_ARRAY, this.textures.get(look.map));
    gl.uniform1i(u.uTiles, 0);
    gl.uniform1i(u.uTable, 1);
    if (this.variants) {
      gl.activeTexture(gl.TEXTURE2);
      gl.bindTexture(gl.TEXTURE_2D, this.variants);
      gl.uniform1i(u.uVariants, 2);
      gl.uniform1i(u.uTileCount, tiling.variants.tiles);
      gl.uniform2ui(u.uDraw, ...lattice.draw);
    }
    if (tiling.tone) this.#useTone(camera, look.map, u);
    gl.uniform2ui(u.uFirst, ...lattice.first);
    gl.uniform2ui(u.uMarks, ...lattice.marks);
    gl.uniform4ui(u.uRadices, ...tiling.radices);
    gl.uniform2ui(u.uOriginX, ...words(camera.cellX));
    gl.uniform2ui(u.uOriginY, ...words(camera.cellY));
    gl.uniform1i(u.uBaked, tiling.algorithm === "baked" ? 1 : 0);
    gl.uniform1i(u.uRepeat, look.repeat ? tiling.variants?.values[repeat] ?? repeat : -1);
    gl.uniform1i(u.uSide, this.size);
    gl.uniform1i(u.uAcross, this.across);
    gl.uniform1i(u.uTopLevel, this.topLevel);
    gl.uniform4f(u.uMean, ...maps[look.map].mean);
    gl.uniform1i(u.uEncode, maps[look.map].light ? 1 : 0);
    return u;
  }

  /** What is at a texel of a cell, for the readout: "tile 7, variant 1: center:7:1". */
  describe({ cellX, cellY, x, y }, seed, look) {
    this.lattice.setSeed(seed);
    const [tile, variant] = look.repeat ? [this.tiles.repeat, 0] : this.lattice.placementAt(cellX, cellY);
    if (tile < 0) return "no tile";
    const patch = this.patchAt(tile, variant, x, y);
    return (this.variants ? `tile ${tile}, variant ${variant}` : `tile ${tile}`) + (patch && `: ${patch}`);
  }

  /** The name of the patch at a texel of a tile; "" where none is known. */
  patchAt(tile, variant, x, y) {
    const first = this.tiles.tiling.variants?.values[tile] ?? tile;
    return this.patches ? this.patches.at(first + variant, x, y) : "";
  }
}

function decodeImage(base64) {
  return new Promise((resolve, reject) => {
    const image = new Image();
    image.onload = () => resolve(image);
    image.onerror = () => reject(new Error("An image of this page cannot be decoded; the file may be damaged."));
    image.src = `data:image/png;base64,${base64}`;
  });
}
