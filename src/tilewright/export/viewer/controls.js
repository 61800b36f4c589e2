// Hands on the plane: drag, wheel, pinch and keys on the canvas.

const WHEEL_STEP = 0.0016, PINCH_WHEEL_STEP = 0.012, TILT_PER_PIXEL = 0.006;

class CanvasControls {
  /**
   * @param canvas takes the pointer and, when focused, the keys
   * @param camera is moved
   * @param changed called after each move, with true while the hand is still moving
   * @param actions key -> function, for keys that are not moves
   */
  constructor(canvas, camera, changed, actions) {
    Object.assign(this, { canvas, camera, changed, actions });
    this.pointers = new Map();
    const on = (name, handler) => canvas.addEventListener(name, handler, { passive: false });
    on("pointerdown", (event) => this.#down(event));
    on("pointermove", (event) => this.#move(event));
    on("pointerup", (event) => this.#up(event));
    on("pointercancel", (event) => this.#up(event));
    on("wheel", (event) => this.#wheel(event));
    on("contextmenu", (event) => event.preventDefault());
    on("dblclick", (event) => this.#zoom(...this.#at(event), event.shiftKey ? 0.5 : 2));
    on("keydown", (event) => this.#key(event));
  }

  /** Device pixels from the canvas's corner. */
  #at(event) {
    const box = this.canvas.getBoundingClientRect(), ratio = this.camera.width / box.width;
    return [(event.clientX - box.left) * ratio, (event.clientY - box.top) * ratio];
  }

  #down(event) {
    this.canvas.setPointerCapture(event.pointerId);
    this.canvas.focus({ preventScroll: true });
    this.pointers.set(event.pointerId, this.#at(event));
    this.turning = this.pointers.size === 1 && (event.button === 2 || event.ctrlKey);
    this.canvas.classList.add("held");
    event.preventDefault();
  }

  #move(event) {
    const before = this.pointers.get(event.pointerId);
    if (!before) return;
    const now = this.#at(event);
    if (this.pointers.size === 2) this.#pinch(event.pointerId, before, now);
    else if (this.turning) this.#turn(before, now);
    else if (this.pointers.size === 1) this.camera.drag(...before, ...now);
    this.pointers.set(event.pointerId, now);
    this.changed(true);
  }

  #up(event) {
    this.pointers.delete(event.pointerId);
    if (this.pointers.size === 0) this.canvas.classList.remove("held");
    this.changed(false);
  }

  #turn(before, now) {
    const ratio = this.camera.width / this.canvas.clientWidth;
    this.camera.tiltBy((before[1] - now[1]) / ratio * TILT_PER_PIXEL);
    this.camera.turnBy((now[0] - before[0]) / ratio * TILT_PER_PIXEL);
  }

  /** Two fingers: their middle drags, their distance zooms. */
  #pinch(moved, before, now) {
    const other = [...this.pointers].find(([id]) => id !== moved)[1];
    const middle = (a) => [(a[0] + other[0]) / 2, (a[1] + other[1]) / 2];
    const gap = (a) => Math.max(1, Math.hypot(a[0] - other[0], a[1] - other[1]));
    this.camera.drag(...middle(before), ...middle(now));
    this.camera.zoomAt(...middle(now), gap(now) / gap(before));
  }

  #wheel(event) {
    event.preventDefault();
    const lines = event.deltaMode === WheelEvent.DOM_DELTA_LINE ? 33 : 1;
    const step = event.ctrlKey ? PINCH_WHEEL_STEP : WHEEL_STEP;
    this.#zoom(...this.#at(event), Math.exp(-event.deltaY * lines * step));
  }

  #zoom(px, py, factor) {
    this.camera.zoomAt(px, py, factor);
    this.changed(true);
  }

  #key(event) {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const { camera } = this, middle = [camera.width / 2, camera.height / 2];
    const step = Math.round((event.shiftKey ? 0.5 : 0.1) * Math.min(camera.width, camera.height));
    const pan = (dx, dy) => camera.drag(middle[0] + dx, middle[1] + dy, ...middle);
    const moves = {
      ArrowLeft: () => pan(-step, 0), ArrowRight: () => pan(step, 0),
      ArrowUp: () => pan(0, -step), ArrowDown: () => pan(0, step),
      "+": () => camera.zoomAt(...middle, 1.25), "=": () => camera.zoomAt(...middle, 1.25),
      "-": () => camera.zoomAt(...middle, 0.8), _: () => camera.zoomAt(...middle, 0.8),
      "[": () => camera.tiltBy(-0.05), "]": () => camera.tiltBy(0.05),
      "<": () => camera.turnBy(0.05), ">": () => camera.turnBy(-0.05),
      ",": () => camera.turnBy(0.05), ".": () => camera.turnBy(-0.05),
    };
    const act = moves[event.key] ?? this.actions[event.key.toLowerCase()];
    if (!act) return;
    event.preventDefault();
    act();
    this.changed(event.key in moves);
  }
}
