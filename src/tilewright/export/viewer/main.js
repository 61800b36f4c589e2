// The page: material, camera and controls put together; drawing on demand; the small API for embedders.

const element = (id) => document.getElementById(id);
const shaderText = (id) => element(id).textContent.trim();

/** Milliseconds after which what the pointer is on is told. */
const SETTLED = 700;

/** The material as written into the page, with binary tables unpacked. */
function readMaterial() {
  const material = JSON.parse(element("material").textContent);
  const unpack = (table, kind) => {
    if (table) table.values = new kind(Uint8Array.from(atob(table.values), (c) => c.charCodeAt(0)).buffer);
  };
  for (const { tiles } of material.planes) {
    unpack(tiles?.tiling.cells, Uint16Array);
    unpack(tiles?.tiling.indexOfCode, Uint16Array);
    unpack(tiles?.tiling.variants, Uint32Array);
    for (const { tone } of tiles?.maps ?? []) unpack(tone, Uint16Array);
  }
  unpack(material.photo?.inverse, Float32Array);
  return material;
}

class Page {
  constructor() {
    this.material = readMaterial();
    this.canvas = element("plane");
    this.seed = 0n;
    this.camera = new Camera(this.material.tileSize);
    this.look = { map: 0, repeat: false, borders: false, pixelRatio: 1, sky: [0, 0, 0], backdrop: [0.5, 0.5, 0.5] };
    this.pace = 1;
    this.comparison = new Comparison(this.material.planes, () => this.#load());
    this.startRenderer();
    this.#connect();
    this.setSeed(String(this.material.seed));
    this.ready = this.#chooseMap(0).then(() => this.resize());
  }

  startRenderer() {
    const parts = [...document.querySelectorAll("script[type='x-shader/x-fragment']")];
    const shaders = Object.fromEntries(parts.map(({ id }) => [id.split(".")[0], shaderText(id)]));
    this.renderer = new Renderer(this.canvas, this.material, shaders);
  }

  #connect() {
    const shortcuts = element("shortcuts");
    const keys = {
      b: () => this.#toggle("borders"), r: () => this.#toggle("repeat"), n: () => this.nextSeed(),
      s: () => element("seed").select(), 1: () => this.oneToOne(), 0: () => this.reset(), home: () => this.reset(),
      h: () => document.body.classList.toggle("bare"), "?": () => shortcuts.showModal(),
      m: () => this.#nextMap(), c: () => this.comparison.next(), v: () => this.comparison.toggleBeside(),
      x: () => this.comparison.swap(),
    };
    new CanvasControls(this.canvas, this.camera, (moving) => this.changed(moving), keys);
    this.canvas.addEventListener("pointermove", (event) => this.#point(event));
    this.canvas.addEventListener("pointerleave", () => this.#point(null));
    this.canvas.addEventListener("webglcontextlost", (event) => event.preventDefault());
    this.canvas.addEventListener("webglcontextrestored", () => {
      this.startRenderer();
      this.#load();
    });
    element("seed").addEventListener("input", () => this.setSeed(element("seed").value));
    element("next-seed").addEventListener("click", () => this.nextSeed());
    element("one").addEventListener("click", () => this.oneToOne());
    element("reset").addEventListener("click", () => this.reset());
    element("help").addEventListener("click", () => shortcuts.showModal());
    element("fold").addEventListener("click", () => this.#fold());
    element("tilt").addEventListener("input", () => {
      this.camera.tilt = element("tilt").valueAsNumber * Math.PI / 180;
      if (this.camera.tilt === 0) this.camera.turn = 0;
      this.changed(true);
    });
    for (const name of ["borders", "repeat"]) {
      element(name).addEventListener("change", () => this.#set(name, element(name).checked));
    }
    element("map").addEventListener("change", () => this.#chooseMap(element("map").selectedIndex));
    matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => this.changed(false));
    new ResizeObserver(() => this.resize()).observe(this.canvas);
  }

  // --- What the controls do ---------------------------------------------------------------------------

  #toggle(name) {
    element(name).checked = !element(name).checked;
    this.#set(name, element(name).checked);
  }

  #set(name, value) {
    this.look[name] = element(name).checked = value;
    this.changed(false);
  }

  #fold() {
    const folded = element("panel").classList.toggle("folded");
    element("fold").setAttribute("aria-expanded", String(!folded));
  }

  async #chooseMap(index) {
    await this.#load(index);
    this.look.map = element("map").selectedIndex = index;
    element("map-note").textContent = this.material.maps[index].note;
    this.changed(false);
  }

  /** Put what is shown on the device. */
  async #load(map = this.look.map) {
    await Promise.all(this.comparison.shown.map(({ plane }) => this.renderer.planes[plane].load(map)));
    this.changed(false);
  }

  #nextMap() {
    this.#chooseMap((this.look.map + 1) % this.material.maps.length);
  }

  /** Take a seed as typed; false, and the old one stays, where it is none. */
  setSeed(text) {
    const good = /^\d{1,20}$/.test(text.trim()) && BigInt(text) < 2n ** 64n;
    const box = element("seed");
    box.setAttribute("aria-invalid", String(!good));
    element("seed-note").textContent = good ? "" : "A whole number from 0 to 2⁶⁴ − 1";
    if (good) {
      this.seed = BigInt(text);
      if (box.value.trim() !== text.trim()) box.value = text.trim();
      this.changed(false);
    }
    return good;
  }

  nextSeed() {
    if (!element("seed").disabled) this.setSeed(String((this.seed + 1n) % 2n ** 64n));
  }

  oneToOne() {
    this.camera.zoomAt(this.camera.width / 2, this.camera.height / 2, 1 / this.camera.zoom);
    this.changed(false);
  }

  reset() {
    this.camera.reset();
    this.changed(false);
  }

  // --- Drawing on demand ------------------------------------------------------------------------------

  resize() {
    const ratio = window.devicePixelRatio || 1;
    this.camera.width = Math.max(1, Math.round(this.canvas.clientWidth * ratio));
    this.camera.height = Math.max(1, Math.round(this.canvas.clientHeight * ratio));
    this.changed(false);
  }

  /** Ask for a new picture; while a slow device is moving, a coarser one. */
  changed(moving) {
    this.moving = moving;
    clearTimeout(this.settled);
    if (moving) this.settled = setTimeout(() => this.changed(false), 160);
    this.frame ??= requestAnimationFrame((time) => {
      this.frame = undefined;
      if (this.moving) this.#keepPace(time);
      this.draw(this.moving ? this.pace : 1);
    });
  }

  /** While moving: coarser after pictures that came slowly, finer after quick ones. */
  #keepPace(time) {
    const passed = time - (this.lastTime ?? -Infinity);
    this.lastTime = time;
    if (passed > 60 && passed < 1000) this.pace = Math.min(4, this.pace * 1.5);
    else if (passed < 22) this.pace = Math.max(1, this.pace / 1.1);
  }

  draw(coarse = 1) {
    const { shown } = this.comparison;
    if (!shown.every(({ plane }) => this.renderer.planes[plane].isLoaded(this.look.map))) return;
    const style = getComputedStyle(document.documentElement);
    this.look.sky = parseColor(style.getPropertyValue("--sky"));
    this.look.backdrop = parseColor(style.getPropertyValue("--backdrop"));
    this.look.pixelRatio = window.devicePixelRatio || 1;
    this.renderer.draw(this.camera, this.seed, this.look, shown, coarse);
    this.#describe();
  }

  #describe() {
    const { zoom, tileSize, tilt } = this.camera;
    const texels = zoom >= 1 ? `${number(zoom)} px per texel` : `${number(1 / zoom)} texels per px`;
    element("scale").textContent = `${number(100 * zoom)} %`;
    element("scale-detail").textContent = `tile = ${number(zoom * tileSize)} px · ${texels}`;
    const across = this.camera.width / (zoom * tileSize);
    element("extent").textContent = `${number(across)} tiles across`;
    const degrees = Math.round(tilt * 180 / Math.PI);
    if (element("tilt").valueAsNumber !== degrees) element("tilt").value = degrees;
    element("tilt-value").textContent = `${degrees}°`;
    element("one").disabled = zoom === 1;
    this.#point(this.pointer);
  }

  /** Which cell and tile the pointer is on. */
  #point(event) {
    this.pointer = event;
    const box = this.canvas.getBoundingClientRect(), ratio = this.camera.width / box.width;
    const at = event
      ? [(event.clientX - box.left) * ratio, (event.clientY - box.top) * ratio]
      : [this.camera.width / 2, this.camera.height / 2];
    if (!this.camera.showsGround(at[1])) return;
    const place = this.camera.locate(...at);
    const plane = this.renderer.planes[this.comparison.planeAt(at[0] / this.camera.width)];
    element("cell").textContent = `cell ${grouped(place.cellX)}, ${grouped(place.cellY)}`;
    element("tile").textContent = plane.describe(place, this.seed, this.look);
    this.#announce();
  }

  /** Tell screen readers what is there once it has stayed for a while, to those who are on the plane. */
  #announce() {
    clearTimeout(this.announcing);
    this.announcing = setTimeout(() => {
      const told = `${element("cell").textContent}, ${element("tile").textContent}`;
      if (document.activeElement === this.canvas && element("told").textContent !== told) {
        element("told").textContent = told;
      }
    }, SETTLED);
  }

  // --- The API ----------------------------------------------------------------------------------------

  /** See docs/viewer.md. */
  view(wanted = {}) {
    const { camera } = this;
    if (wanted.seed !== undefined && !this.setSeed(String(wanted.seed))) throw new RangeError("seed: 0 to 2^64 - 1");
    if (wanted.borders !== undefined) this.#set("borders", Boolean(wanted.borders));
    if (wanted.repeat !== undefined) this.#set("repeat", Boolean(wanted.repeat));
    this.comparison.set(wanted);
    if (wanted.cellX !== undefined) [camera.cellX, camera.x] = [BigInt(wanted.cellX), 0];
    if (wanted.cellY !== undefined) [camera.cellY, camera.y] = [BigInt(wanted.cellY), 0];
    if (wanted.pixelsPerTile !== undefined) {
      camera.zoom = Math.min(MAX_ZOOM, Math.max(camera.minZoom, wanted.pixelsPerTile / camera.tileSize));
    }
    if (wanted.tilt !== undefined) camera.tilt = Math.min(MAX_TILT, Math.max(0, wanted.tilt));
    if (wanted.turn !== undefined) camera.turn = wanted.turn;
    if (wanted.x !== undefined) camera.x = wanted.x * camera.tileSize;
    if (wanted.y !== undefined) camera.y = wanted.y * camera.tileSize;
    camera.move(0, 0);
    this.changed(false);
    this.draw();
    const { cellX, cellY, x, y } = camera.locate(0, 0);
    return {
      seed: String(this.seed), map: this.material.maps[this.look.map].name,
      borders: this.look.borders, repeat: this.look.repeat, ...this.comparison.state,
      cellX: String(camera.cellX), cellY: String(camera.cellY),
      x: camera.x / camera.tileSize, y: camera.y / camera.tileSize,
      pixelsPerTile: camera.zoom * camera.tileSize, tilt: camera.tilt, turn: camera.turn,
      width: camera.width, height: camera.height,
      corner: { cellX: String(cellX), cellY: String(cellY), texelX: x, texelY: y },
    };
  }

  /** Numbers of tile and variant of the plane that is shown (the left one of two); tile -1 where it has none. */
  #placementAt(x, y) {
    const { lattice } = this.renderer.planes[this.comparison.shown[0].plane];
    lattice?.setSeed(this.seed);
    return lattice?.placementAt(x, y) ?? [-1, 0];
  }

  /** The cell and the texel in it at CSS pixels from the canvas's corner. */
  #locate(px, py) {
    const ratio = this.camera.width / this.canvas.clientWidth;
    const { cellX, cellY, x, y } = this.camera.locate(px * ratio, py * ratio);
    return { cellX: String(cellX), cellY: String(cellY), texelX: x, texelY: y };
  }

  /** The patch at a texel of a cell; "" where none is known. */
  #patchAt(x, y, texelX, texelY) {
    const [tile, variant] = this.#placementAt(x, y);
    const plane = this.renderer.planes[this.comparison.shown[0].plane];
    return tile < 0 ? "" : plane.patchAt(tile, variant, texelX, texelY);
  }

  get api() {
    return {
      ready: this.ready,
      view: (wanted) => this.view(wanted),
      showMap: (name) => this.#chooseMap(this.material.maps.findIndex((map) => map.name === name)),
      pixels: () => { this.changed(false); this.draw(); return this.renderer.pixels(); },
      show: (method, beside) => { this.comparison.set({ method, beside }); return this.#load(); },
      tileAt: (cellX, cellY) => this.#placementAt(BigInt(cellX), BigInt(cellY))[0],
      locate: (x, y) => this.#locate(x, y),
      patchAt: (cellX, cellY, texelX, texelY) => this.#patchAt(BigInt(cellX), BigInt(cellY), texelX, texelY),
      variantAt: (cellX, cellY) => this.#placementAt(BigInt(cellX), BigInt(cellY))[1],
    };
  }
}

/** "#rrggbb" as three numbers up to 1. */
function parseColor(text) {
  const hex = parseInt(text.trim().slice(1), 16);
  return [hex >> 16, (hex >> 8) & 255, hex & 255].map((byte) => byte / 255);
}

function number(value) {
  return value >= 100 ? String(Math.round(value)) : String(Number(value.toPrecision(3)));
}

/** A BigInt with thin spaces between thousands and a true minus. */
function grouped(value) {
  const digits = String(value < 0n ? -value : value).replace(/\B(?=(\d{3})+$)/g, "\u2009");
  return (value < 0n ? "\u2212" : "") + digits;
}

try {
  const page = new Page();
  window.tilewright = page.api;
  page.ready.catch((error) => complain(error));
} catch (error) {
  complain(error);
}

function complain(error) {
  element("failure-text").textContent = error.message;
  document.body.classList.add("failed");
  window.tilewright ??= { ready: Promise.reject(error) };
  window.tilewright.ready.catch(() => {});
}
