// SPDX-License-Identifier: Apache-2.0
// One case: what is shown of it, in which of the ways there are.

const MODES = ["side", "slider", "blink", "difference", "flip", "actual", "expected"];

const NO_PICTURES = { encoded: true, actual: null, expected: null, flip: null };

class Viewer {
  constructor() {
    this.view = new CanvasView(element("canvas"));
    this.entry = null;
    this.pictures = NO_PICTURES;
    this.wantedMode = "side";  // stays when a case lacks what it takes
    this.split = 0.5;
    this.period = 500;
    this.paused = window.matchMedia("(prefers-reduced-motion: reduce)").matches;
    this.showsExpected = false;  // while blinking
    this.scale = 4;
    this.signed = false;
    this.exposure = 0;
    this.pixel = null;
    this.layers = new Map();
    this.timer = null;
    this.drawRequested = false;
    new ResizeObserver(() => this.draw()).observe(element("stage"));
  }

  async open(entry) {
    if (this.entry === entry) return;
    this.close();
    this.entry = entry;
    describeCase(entry);
    if (canInflate()) {
      const pictures = await picturesOf(entry);
      if (this.entry !== entry) return;  // another case was opened meanwhile
      this.pictures = pictures;
    }
    const frames = [this.pictures.actual, this.pictures.expected].filter(Boolean);
    this.view.show(Math.max(1, ...frames.map((p) => p.width)),
      Math.max(1, ...frames.map((p) => p.height)));
    this.setExposure(startExposure(this.pictures.expected || this.pictures.actual));
    this.showMode();
  }

  close() {
    this.entry = null;
    this.pictures = NO_PICTURES;
    this.pixel = null;
    this.layers.clear();
    this.showMode();
  }

  has(mode) {
    const { actual, expected, flip } = this.pictures;
    if (mode === "actual") return Boolean(actual);
    if (mode === "expected") return Boolean(expected);
    if (mode === "flip") return Boolean(flip);
    return Boolean(actual && expected);
  }

  get mode() {
    if (this.has(this.wantedMode)) return this.wantedMode;
    return ["actual", "expected"].find((mode) => this.has(mode)) || null;
  }

  setMode(mode) {
    if (!this.has(mode)) return;
    this.wantedMode = mode;
    this.showsExpected = false;
    this.showMode();
  }

  showMode() {
    const mode = this.mode;
    for (const button of element("modes").children) {
      button.disabled = !this.has(button.dataset.mode);
      button.setAttribute("aria-pressed", button.dataset.mode === mode);
    }
    element("split").hidden = mode !== "slider";
    element("blink-options").hidden = mode !== "blink";
    element("difference-options").hidden = mode !== "difference";
    element("exposure-options").hidden = this.pictures.encoded || mode === "flip";
    element("worst").disabled = !this.has("difference");
    element("nothing").hidden = mode !== null || !this.entry || !canInflate();
    this.showSplit();
    this.restartBlinking();
    this.showCaption();
    this.draw();
  }

  restartBlinking() {
    clearInterval(this.timer);
    this.timer = null;
    element("pause").setAttribute("aria-pressed", this.paused);
    element("period-value").textContent = `${this.period} ms`;
    if (this.mode !== "blink" || this.paused) return;
    this.timer = setInterval(() => this.swap(), this.period);
  }

  swap() {
    this.showsExpected = !this.showsExpected;
    this.draw();
  }

  setPaused(paused) {
    this.paused = paused;
    this.restartBlinking();
  }

  setPeriod(period) {
    this.period = period;
    this.restartBlinking();
  }

  setSplit(split) {
    this.split = Math.min(Math.max(split, 0), 1);
    this.showSplit();
    this.draw();
  }

  showSplit() {
    element("split").style.left = `${100 * this.split}%`;
    element("split").setAttribute("aria-valuenow", Math.round(100 * this.split));
  }

  setDifference(scale, signed) {
    this.scale = scale;
    this.signed = signed;
    this.showCaption();
    this.draw();
  }

  setExposure(exposure) {
    this.exposure = Math.min(Math.max(exposure, -20), 20);
    element("exposure").value = this.exposure;
    element("exposure-value").textContent = `${this.exposure > 0 ? "+" : ""}${this.exposure} EV`;
    this.draw();
  }

  setPixel(pixel) {
    const inside = pixel && pixel.x >= 0 && pixel.y >= 0 && pixel.x < this.view.width &&
      pixel.y < this.view.height;
    this.pixel = inside ? pixel : null;
    this.draw();
  }

  goToWorst() {
    if (!this.has("difference")) return;
    const { x, y } = findWorstPixel(this.pictures.actual, this.pictures.expected);
    this.view.centerOn(x + 0.5, y + 0.5);
    if (this.view.zoom < 16) this.view.zoomTo(16);
    this.view.centerOn(x + 0.5, y + 0.5);
    this.setPixel({ x, y });
  }

  /** What is on the canvas, in words. */
  showCaption() {
    const clipped = this.pictures.encoded ? "" : "Linear values as sRGB, clipped at 0 and 1.";
    const captions = {
      slider: `Drag the line, or move it with the arrow keys. ${clipped}`,
      difference: this.differenceCaption(),
      flip: "FLIP per pixel: black 0, pale yellow 1.",
    };
    element("caption").textContent = this.mode ? captions[this.mode] || clipped : "";
  }

  differenceCaption() {
    const what = this.pictures.encoded ? "of sRGB codes" : "of linear values, exposed";
    return this.signed
      ? `Luminance of the difference × ${this.scale}, ${what}: orange if actual is more, blue if less.`
      : `Absolute difference × ${this.scale}, ${what}.`;
  }

  /** The layer of that name, painted if it is not there yet as it should be. */
  layer(name) {
    const { actual, expected, flip, encoded } = this.pictures;
    const exposure = encoded ? 0 : this.exposure;
    const key = name === "difference" ? `${exposure} ${this.scale} ${this.signed}` : `${exposure}`;
    const known = this.layers.get(name);
    if (known && (known.key === key || name === "flip")) return known.canvas;
    let canvas;
    if (name === "flip") canvas = flipLayer(flip);
    else if (name !== "difference") canvas = pictureLayer(this.pictures[name], exposure);
    else canvas = differenceLayer(actual, expected, this.scale * 2 ** exposure, this.signed);
    this.layers.set(name, { key, canvas });
    return canvas;
  }

  draw() {
    if (this.drawRequested) return;
    this.drawRequested = true;
    requestAnimationFrame(() => {
      this.drawRequested = false;
      this.drawNow();
    });
  }

  drawNow() {
    if (!this.entry || element("viewer-page").hidden) return;
    const { view, mode } = this;
    view.layOut(mode === "side" ? 2 : 1);
    view.canvas.getContext("2d").clearRect(0, 0, view.canvas.width, view.canvas.height);
    if (mode) this.drawMode(mode);
    if (mode && this.pixel) view.panes.forEach((pane) => view.drawMark(pane, this.pixel));
    element("zoom").textContent = `${Math.round(100 * view.zoom)}%`;
    showReadout(this.pictures, this.pixel, this.entry.reduction);
  }

  drawMode(mode) {
    const { view } = this;
    const [first, second] = view.panes;
    if (mode === "side") {
      view.drawPane(first, this.layer("actual"), "actual");
      view.drawPane(second, this.layer("expected"), "expected");
    } else if (mode === "slider") {
      view.drawPane(first, this.layer("actual"), "actual", [0, this.split]);
      view.drawPane(first, this.layer("expected"), "expected", [this.split, 1]);
    } else if (mode === "blink") {
      const shown = this.showsExpected ? "expected" : "actual";
      view.drawPane(first, this.layer(shown), shown);
    } else {
      view.drawPane(first, this.layer(mode), mode === "flip" ? "FLIP" : mode);
    }
  }
}

const viewer = new Viewer();
