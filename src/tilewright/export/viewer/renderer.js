// WebGL2: tiles in a texture array, their mip levels, and one triangle over the canvas.
//
// A layer holds a square of tiles. The shader fetches texels and filters by itself across tile borders, so
// tiles need no gutter, may share a layer, and 2048 texels and 256 layers, which every device has, hold
// 65,536 tiles of 128 texels.

const LAYER_SIDE = 2048;
const TRIANGLE = `#version 300 es
void main() { gl_Position = vec4(gl_VertexID == 1 ? 3 : -1, gl_VertexID == 2 ? 3 : -1, 0, 1); }`;

class Renderer {
  constructor(canvas, material, shaders) {
    this.canvas = canvas;
    this.material = material;
    const gl = canvas.getContext("webgl2", { alpha: false, antialias: false, depth: false, stencil: false });
    if (!gl) throw new Error("This page needs WebGL 2, which this browser does not offer or has switched off.");
    this.gl = gl;
    const size = material.tileSize;
    const across = Math.min(Math.max(1, Math.floor(LAYER_SIDE / size)), Math.ceil(Math.sqrt(material.count)));
    this.across = across;
    this.layers = Math.ceil(material.count / across ** 2);
    this.topLevel = Math.floor(Math.log2(size));
    if (across * size > gl.getParameter(gl.MAX_TEXTURE_SIZE) ||
        this.layers > gl.getParameter(gl.MAX_ARRAY_TEXTURE_LAYERS)) {
      throw new Error(`This device cannot hold ${material.count} tiles of ${size} texels.`);
    }
    this.plane = this.#program(shaders.plane);
    this.mip = this.#program(shaders.mip);
    this.table = this.#table(material.tiling.cells ?? material.tiling.indexOfCode);
    this.textures = new Map();
  }

  #program(fragment) {
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

  /** Whole numbers in a texture that the shader looks up. */
  #table({ width, height, values } = { width: 1, height: 1, values: new Uint16Array(1) }) {
    const { gl } = this;
    const texture = gl.createTexture();
    gl.bindTexture(gl.TEXTURE_2D, texture);
    gl.pixelStorei(gl.UNPACK_ALIGNMENT, 1);
    gl.texStorage2D(gl.TEXTURE_2D, 1, gl.R16UI, width, height);
    gl.texSubImage2D(gl.TEXTURE_2D, 0, 0, 0, width, height, gl.RED_INTEGER, gl.UNSIGNED_SHORT, values);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.NEAREST);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MAG_FILTER, gl.NEAREST);
    return texture;
  }

  /** Decode a map's tiles and put them and their mip levels on the device, once. */
  async load(index) {
    if (this.textures.has(index)) return;
    const { gl, across } = this, size = this.material.tileSize, map = this.material.maps[index];
    const images = await Promise.all(map.tiles.map(decodeImage));
    const texture = gl.createTexture();
    gl.bindTexture(gl.TEXTURE_2D_ARRAY, texture);
    gl.pixelStorei(gl.UNPACK_PREMULTIPLY_ALPHA_WEBGL, false);
    gl.pixelStorei(gl.UNPACK_COLORSPACE_CONVERSION_WEBGL, gl.NONE);
    const format = map.light ? gl.SRGB8_ALPHA8 : gl.RGBA8;
    gl.texStorage3D(gl.TEXTURE_2D_ARRAY, this.topLevel + 1, format, across * size, across * size, this.layers);
    images.forEach((image, tile) => {
      const place = tile % across ** 2;
      gl.texSubImage3D(gl.TEXTURE_2D_ARRAY, 0, (place % across) * size, Math.floor(place / across) * size,
        Math.floor(tile / across ** 2), size, size, 1, gl.RGBA, gl.UNSIGNED_BYTE, image);
    });
    gl.texParameteri(gl.TEXTURE_2D_ARRAY, gl.TEXTURE_MIN_FILTER, gl.NEAREST_MIPMAP_NEAREST);
    gl.texParameteri(gl.TEXTURE_2D_ARRAY, gl.TEXTURE_MAG_FILTER, gl.NEAREST);
    this.#fillLevels(texture);
    this.textures.set(index, texture);
  }

  #fillLevels(texture) {
    const { gl, across, mip: { program, uniforms } } = this, size = this.material.tileSize;
    const frame = gl.createFramebuffer();
    gl.bindFramebuffer(gl.FRAMEBUFFER, frame);
    gl.useProgram(program);
    gl.uniform1i(uniforms.uAcross, across);
    for (let level = 0; level < this.topLevel; level++) {
      const side = across * (size >> (level + 1));
      gl.texParameteri(gl.TEXTURE_2D_ARRAY, gl.TEXTURE_BASE_LEVEL, level);
      gl.texParameteri(gl.TEXTURE_2D_ARRAY, gl.TEXTURE_MAX_LEVEL, level);
      gl.uniform1i(uniforms.uSize, size >> level);
      gl.viewport(0, 0, side, side);
      for (let layer = 0; layer < this.layers; layer++) {
        gl.framebufferTextureLayer(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, texture, level + 1, layer);
        gl.uniform1i(uniforms.uLayer, layer);
        gl.drawArrays(gl.TRIANGLES, 0, 3);
      }
    }
    gl.texParameteri(gl.TEXTURE_2D_ARRAY, gl.TEXTURE_BASE_LEVEL, 0);
    gl.texParameteri(gl.TEXTURE_2D_ARRAY, gl.TEXTURE_MAX_LEVEL, this.topLevel);
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
    gl.deleteFramebuffer(frame);
  }

  /** Draw what a camera sees; `coarse` pixels of the screen become one. */
  draw(camera, lattice, look, coarse = 1) {
    const { gl, material, plane: { program, uniforms: u } } = this, map = material.maps[look.map];
    const width = Math.max(1, Math.round(camera.width / coarse));
    const height = Math.max(1, Math.round(camera.height / coarse));
    if (this.canvas.width !== width || this.canvas.height !== height) {
      this.canvas.width = width;
      this.canvas.height = height;
    }
    gl.viewport(0, 0, width, height);
    gl.useProgram(program);
    gl.activeTexture(gl.TEXTURE1);
    gl.bindTexture(gl.TEXTURE_2D, this.table);
    gl.activeTexture(gl.TEXTURE0);
    gl.bindTexture(gl.TEXTURE_2D_ARRAY, this.textures.get(look.map));
    gl.uniform1i(u.uTiles, 0);
    gl.uniform1i(u.uTable, 1);
    gl.uniform2ui(u.uFirst, ...lattice.first);
    gl.uniform2ui(u.uMarks, ...lattice.marks);
    gl.uniform4ui(u.uRadices, ...material.tiling.radices);
    gl.uniform2ui(u.uOriginX, ...words(camera.cellX));
    gl.uniform2ui(u.uOriginY, ...words(camera.cellY));
    gl.uniform1i(u.uBaked, material.tiling.algorithm === "baked" ? 1 : 0);
    gl.uniform1i(u.uRepeat, look.repeat ? material.repeat : -1);
    gl.uniform1i(u.uSize, material.tileSize);
    gl.uniform1i(u.uAcross, this.across);
    gl.uniform1i(u.uTopLevel, this.topLevel);
    gl.uniform4f(u.uMean, ...map.mean);
    gl.uniform1i(u.uEncode, map.light ? 1 : 0);
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
    gl.drawArrays(gl.TRIANGLES, 0, 3);
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

function decodeImage(base64) {
  return new Promise((resolve, reject) => {
    const image = new Image();
    image.onload = () => resolve(image);
    image.onerror = () => reject(new Error("A tile of this page cannot be decoded; the file may be damaged."));
    image.src = `data:image/png;base64,${base64}`;
  });
}
