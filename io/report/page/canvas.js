// SPDX-License-Identifier: Apache-2.0
// Where on the canvas which pixel is, and the drawing of one or two panes of it.
// Lengths on the canvas are in pixels of the screen; a zoom of 1 shows pixels as they are.

const MOST_ZOOM = 128;
const GRID_FROM_ZOOM = 12;
const PANE_GAP = 2;

class CanvasView {
  constructor(canvas) {
    this.canvas = canvas;
    this.zoom = 1;
    this.centerX = 0;  // the pixel of the picture that is in the middle of a pane
    this.centerY = 0;
    this.fitted = true;
    this.width = 1;  // of the picture
    this.height = 1;
    this.panes = [];
  }

  /** How many pixels of the screen are one of CSS. */
  get ratio() {
    return window.devicePixelRatio || 1;
  }

  show(width, height) {
    this.width = width;
    this.height = height;
    this.fitted = true;
  }

  /** Takes the size of the stage and divides it among `count` panes. */
  layOut(count) {
    const box = this.canvas.parentElement.getBoundingClientRect();
    const width = Math.max(1, Math.round(box.width * this.ratio));
    const height = Math.max(1, Math.round(box.height * this.ratio));
    if (this.canvas.width !== width) this.canvas.width = width;
    if (this.canvas.height !== height) this.canvas.height = height;
    this.panes = this.divide(width, height, count);
    if (this.fitted) this.fit();
  }

  divide(width, height, count) {
    if (count === 1) return [{ x: 0, y: 0, width, height }];
    const gap = Math.round(PANE_GAP * this.ratio);
    const halfWidth = Math.floor((width - gap) / 2);
    const halfHeight = Math.floor((height - gap) / 2);
    const beside = Math.min(halfWidth / this.width, height / this.height);
    const above = Math.min(width / this.width, halfHeight / this.height);
    if (beside >= above) {
      return [0, width - halfWidth].map((x) => ({ x, y: 0, width: halfWidth, height }));
    }
    return [0, height - halfHeight].map((y) => ({ x: 0, y, width, height: halfHeight }));
  }

  get fitZoom() {
    const pane = this.panes[0];
    const zoom = Math.min(pane.width / this.width, pane.height / this.height);
    return zoom > 1 ? Math.min(Math.floor(zoom), MOST_ZOOM) : zoom;
  }

  fit() {
    this.fitted = true;
    this.zoom = this.fitZoom;
    this.centerX = this.width / 2;
    this.centerY = this.height / 2;
  }

  /** Where the picture's corner is in a pane. Whole pixels, so that all of one are as wide. */
  origin(pane) {
    return {
      x: Math.round(pane.x + pane.width / 2 - this.centerX * this.zoom),
      y: Math.round(pane.y + pane.height / 2 - this.centerY * this.zoom),
    };
  }

  paneAt(x, y) {
    const inside = (p) => x >= p.x && y >= p.y && x < p.x + p.width && y < p.y + p.height;
    return this.panes.find(inside) || this.panes[0];
  }

  /** The place in the picture, in pixels of it, at one of the canvas. */
  toPicture(x, y) {
    const origin = this.origin(this.paneAt(x, y));
    return { x: (x - origin.x) / this.zoom, y: (y - origin.y) / this.zoom };
  }

  /** Changes the zoom such that what is at (x, y) stays there. */
  zoomAt(zoom, x, y) {
    const place = this.toPicture(x, y);
    const pane = this.paneAt(x, y);
    this.fitted = false;
    this.zoom = Math.min(Math.max(zoom, Math.min(this.fitZoom, 1) / 4), MOST_ZOOM);
    this.centerX = place.x - (x - pane.x - pane.width / 2) / this.zoom;
    this.centerY = place.y - (y - pane.y - pane.height / 2) / this.zoom;
    this.keepInSight();
  }

  /** In the middle of the first pane. */
  zoomTo(zoom) {
    const pane = this.panes[0];
    this.zoomAt(zoom, pane.x + pane.width / 2, pane.y + pane.height / 2);
  }

  panBy(x, y) {
    this.fitted = false;
    this.centerX -= x / this.zoom;
    this.centerY -= y / this.zoom;
    this.keepInSight();
  }

  centerOn(x, y) {
    this.fitted = false;
    this.centerX = x;
    this.centerY = y;
  }

  keepInSight() {
    this.centerX = Math.min(Math.max(this.centerX, 0), this.width);
    this.centerY = Math.min(Math.max(this.centerY, 0), this.height);
  }

  /** Draws a layer and its name; `part` is the share of the pane's width that it may cover. */
  drawPane(pane, layer, name, part = [0, 1]) {
    const context = this.canvas.getContext("2d");
    const origin = this.origin(pane);
    const left = pane.x + Math.round(part[0] * pane.width);
    const right = pane.x + Math.round(part[1] * pane.width);
    context.save();
    context.beginPath();
    context.rect(left, pane.y, right - left, pane.height);
    context.clip();
    context.imageSmoothingEnabled = this.zoom < 1;
    context.imageSmoothingQuality = "high";
    context.drawImage(layer, origin.x, origin.y, layer.width * this.zoom, layer.height * this.zoom);
    if (this.zoom >= GRID_FROM_ZOOM * this.ratio) this.drawGrid(context, pane, origin, layer);
    this.drawName(context, pane, name, part[0] > 0 ? "right" : "left");
    context.restore();
  }

  drawGrid(context, pane, origin, layer) {
    const lines = (start, first, length, count) => {
      const begin = Math.max(0, Math.floor((start - first) / this.zoom));
      const end = Math.min(count, Math.ceil((start + length - first) / this.zoom));
      return Array.from({ length: Math.max(0, end - begin + 1) },
        (_, i) => Math.round(first + (begin + i) * this.zoom));
    };
    const bottom = origin.y + layer.height * this.zoom;
    const right = origin.x + layer.width * this.zoom;
    context.fillStyle = "rgba(128, 128, 128, 0.5)";
    for (const x of lines(pane.x, origin.x, pane.width, layer.width)) {
      context.fillRect(x, Math.max(origin.y, pane.y), 1, Math.min(bottom, pane.y + pane.height));
    }
    for (const y of lines(pane.y, origin.y, pane.height, layer.height)) {
      context.fillRect(Math.max(origin.x, pane.x), y, Math.min(right, pane.x + pane.width), 1);
    }
  }

  drawName(context, pane, name, side) {
    const size = Math.round(13 * this.ratio);
    context.font = `${size}px "DejaVu Sans", Verdana, Arial, sans-serif`;
    const width = context.measureText(name).width + size;
    const x = side === "left" ? pane.x : pane.x + pane.width - width;
    context.fillStyle = "rgba(0, 0, 0, 0.7)";
    context.fillRect(x, pane.y, width, 1.7 * size);
    context.fillStyle = "#fff";
    context.textBaseline = "middle";
    context.fillText(name, x + size / 2, pane.y + 0.87 * size);
  }

  /** A frame around a pixel that is seen on all backgrounds. */
  drawMark(pane, pixel) {
    const context = this.canvas.getContext("2d");
    const origin = this.origin(pane);
    const margin = Math.max(0, (7 * this.ratio - this.zoom) / 2);
    const x = Math.round(origin.x + pixel.x * this.zoom - margin);
    const y = Math.round(origin.y + pixel.y * this.zoom - margin);
    const size = Math.round(this.zoom + 2 * margin);
    const line = Math.max(1, Math.round(this.ratio));
    context.save();
    context.beginPath();
    context.rect(pane.x, pane.y, pane.width, pane.height);
    context.clip();
    context.lineWidth = line;
    context.strokeStyle = "#000";
    context.strokeRect(x - 1.5 * line, y - 1.5 * line, size + 3 * line, size + 3 * line);
    context.strokeStyle = "#fff";
    context.strokeRect(x - 0.5 * line, y - 0.5 * line, size + line, size + line);
    context.restore();
  }
}
