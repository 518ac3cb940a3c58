// SPDX-License-Identifier: Apache-2.0
// The list of all cases, and the texts of one.

const THUMBNAIL_WIDTH = 128;
const THUMBNAIL_HEIGHT = 96;

/** An element with a class and a text. */
function make(tag, className, text) {
  const made = document.createElement(tag);
  if (className) made.className = className;
  if (text !== undefined) made.textContent = text;
  return made;
}

function verdictClass(verdict) {
  return `verdict ${verdict.replace(" ", "-")}`;
}

function thumbnail(layer, name) {
  const ratio = window.devicePixelRatio || 1;
  const zoom = Math.min(THUMBNAIL_WIDTH / layer.width, THUMBNAIL_HEIGHT / layer.height, 1);
  const canvas = make("canvas");
  const width = Math.max(1, Math.round(layer.width * zoom));
  const height = Math.max(1, Math.round(layer.height * zoom));
  canvas.width = Math.round(width * ratio);
  canvas.height = Math.round(height * ratio);
  canvas.style.width = `${width}px`;
  canvas.style.height = `${height}px`;
  const context = canvas.getContext("2d");
  context.imageSmoothingEnabled = canvas.width < layer.width;
  context.imageSmoothingQuality = "high";
  context.drawImage(layer, 0, 0, canvas.width, canvas.height);
  const figure = make("figure");
  figure.append(canvas, make("figcaption", "", name));
  return figure;
}

async function addThumbnails(place, entry) {
  const { actual, expected, flip, encoded } = await picturesOf(entry);
  const exposure = encoded ? 0 : startExposure(expected || actual);
  const layers = [];
  if (actual) layers.push([pictureLayer(actual, exposure), "actual"]);
  if (expected) layers.push([pictureLayer(expected, exposure), "expected"]);
  if (flip) layers.push([flipLayer(flip), "FLIP"]);
  place.replaceChildren(...layers.map(([layer, name]) => thumbnail(layer, name)));
}

function makeRow(entry) {
  const link = make("a", "case");
  link.href = hashOf(entry);
  const text = make("div", "case-text");
  const head = make("p", "case-line");
  head.append(make("span", "case-title", entry.name),
    make("span", verdictClass(entry.verdict), entry.verdict));
  text.append(head);
  if (entry.message) text.append(make("p", "case-note", entry.message));
  const notes = [entry.history, entry.seconds === undefined ? "" : formatSeconds(entry.seconds)];
  const note = notes.filter(Boolean).join("; ");
  if (note) text.append(make("p", "case-note faint", note));
  const thumbnails = make("div", entry.actual || entry.expected ? "thumbnails" : "thumbnails none");
  link.append(text, thumbnails);
  const row = make("li");
  row.append(link);
  return { entry, row, link, thumbnails };
}

function formatSeconds(seconds) {
  return `${seconds < 10 ? seconds.toFixed(2) : seconds.toFixed(0)} s`;
}

class CaseList {
  constructor(entries) {
    this.rows = entries.map(makeRow);
    this.verdict = null;  // null: all
    element("cases").append(...this.rows.map(({ row }) => row));
    this.addFilters(entries);
    element("search").addEventListener("input", () => this.filter());
    this.filter();
    if (canInflate()) this.watchThumbnails();
  }

  /** Pictures are unpacked when they come into sight, one case at a time. */
  watchThumbnails() {
    let queue = Promise.resolve();
    const observer = new IntersectionObserver((seen) => {
      for (const { isIntersecting, target } of seen) {
        if (!isIntersecting) continue;
        observer.unobserve(target);
        const { entry, thumbnails } = this.rows.find(({ row }) => row === target);
        queue = queue.then(() => addThumbnails(thumbnails, entry)).catch(showProblem);
      }
    }, { rootMargin: "400px" });
    for (const { row } of this.rows) observer.observe(row);
  }

  addFilters(entries) {
    const verdicts = [...new Set(entries.map(({ verdict }) => verdict))];
    const buttons = [null, ...verdicts].map((verdict) => {
      const count = entries.filter((entry) => verdict === null || entry.verdict === verdict).length;
      const button = make("button", "", `${verdict || "all"} ${count}`);
      button.dataset.verdict = verdict || "";
      button.addEventListener("click", () => {
        this.verdict = verdict;
        this.filter();
      });
      return button;
    });
    element("verdict-filters").append(...buttons);
  }

  filter() {
    const words = element("search").value.toLowerCase().split(/\s+/).filter(Boolean);
    let shown = 0;
    for (const { entry, row } of this.rows) {
      const text = `${entry.name} ${entry.message} ${entry.history}`.toLowerCase();
      const fits = (this.verdict === null || entry.verdict === this.verdict) &&
        words.every((word) => text.includes(word));
      row.hidden = !fits;
      if (fits) shown += 1;
    }
    for (const button of element("verdict-filters").children) {
      button.setAttribute("aria-pressed", button.dataset.verdict === (this.verdict || ""));
    }
    element("count").textContent = `${shown} of ${this.rows.length} shown`;
  }

  /** The cases that the filter lets through, in order. */
  get shownEntries() {
    return this.rows.filter(({ row }) => !row.hidden).map(({ entry }) => entry);
  }

  focus(entry) {
    const row = this.rows.find((candidate) => candidate.entry === entry);
    if (row && !row.row.hidden) row.link.focus({ preventScroll: true });
  }
}
