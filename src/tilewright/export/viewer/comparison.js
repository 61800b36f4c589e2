// Which planes are shown: one, or two with a divider between them; and the table of what is known of each.

const DIVIDER_STEP = 0.02;

class Comparison {
  /**
   * @param planes as in the page's data; a single one needs no controls
   * @param changed called after each change
   */
  constructor(planes, changed) {
    Object.assign(this, { planes, changed });
    this.first = Math.max(0, planes.findIndex((plane) => plane.own));
    this.beside = -1;
    this.split = 0.5;
    if (planes.length > 1) this.#connect();
  }

  /** What the renderer draws: [{plane, from, to}]. */
  get shown() {
    if (this.beside < 0) return [{ plane: this.first, from: 0, to: 1 }];
    return [{ plane: this.first, from: 0, to: this.split }, { plane: this.beside, from: this.split, to: 1 }];
  }

  /** The plane at a share of the width. */
  planeAt(x) { return this.beside >= 0 && x > this.split ? this.beside : this.first; }

  get state() {
    return {
      method: this.planes[this.first].name, beside: this.planes[this.beside]?.name ?? null, split: this.split,
    };
  }

  /** Take what is given of {method, beside, split}; beside null shows one plane. */
  set({ method, beside, split }) {
    if (method !== undefined) this.first = this.#find(method);
    if (beside !== undefined) this.beside = beside === null ? -1 : this.#find(beside);
    if (split !== undefined) this.split = Math.min(1, Math.max(0, split));
    if (this.planes.length > 1) this.#show();
  }

  #find(name) {
    const found = this.planes.findIndex((plane) => plane.name === name);
    if (found < 0) throw new RangeError(`method: ${this.planes.map((plane) => plane.name).join(", ")}`);
    return found;
  }

  next() { this.#change({ method: this.planes[(this.first + 1) % this.planes.length].name }); }

  toggleBeside() { this.#change({ beside: this.beside < 0 ? this.planes[this.#other()].name : null }); }

  swap() {
    if (this.beside < 0) return;
    this.#change({ method: this.planes[this.beside].name, beside: this.planes[this.first].name });
  }

  /** What is first set beside: plain repetition, or the tiles where that is shown. */
  #other() { return this.first === 0 ? this.planes.findIndex((plane) => plane.own) : 0; }

  #change(wanted) {
    this.set(wanted);
    this.changed();
  }

  #connect() {
    const first = element("method"), beside = element("beside"), divider = element("divider");
    first.addEventListener("change", () => this.#change({ method: first.value }));
    beside.addEventListener("change", () => this.#change({ beside: beside.value || null }));
    document.querySelectorAll("#methods tbody tr").forEach((row) => {
      row.addEventListener("click", () => this.#change({ method: row.dataset.method }));
    });
    divider.addEventListener("pointerdown", (event) => divider.setPointerCapture(event.pointerId));
    divider.addEventListener("pointermove", (event) => {
      if (divider.hasPointerCapture(event.pointerId)) this.#change({ split: event.clientX / innerWidth });
    });
    divider.addEventListener("keydown", (event) => {
      const step = { ArrowLeft: -DIVIDER_STEP, ArrowRight: DIVIDER_STEP }[event.key];
      if (step) this.#change({ split: this.split + step });
    });
    this.#show();
  }

  #show() {
    const two = this.beside >= 0, [left, right] = [this.planes[this.first], this.planes[this.beside]];
    element("method").value = left.name;
    element("beside").value = right?.name ?? "";
    element("divider").hidden = element("left-label").hidden = element("right-label").hidden = !two;
    element("divider").setAttribute("aria-valuenow", String(Math.round(100 * this.split)));
    document.documentElement.style.setProperty("--split", String(this.split));
    element("left-label").textContent = left.label;
    element("right-label").textContent = right?.label ?? "";
    document.querySelectorAll("#methods tbody tr").forEach((row) => {
      row.classList.toggle("shown", row.dataset.method === left.name || row.dataset.method === right?.name);
    });
  }
}
