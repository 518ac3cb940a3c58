// SPDX-License-Identifier: Apache-2.0
// Mouse, fingers, keys and buttons of the viewer.

const CLICK_DISTANCE = 4;
const PAN_STEP = 40;

/** The place of an event on the canvas, in pixels of the screen. */
function placeOf(event) {
  const box = viewer.view.canvas.getBoundingClientRect();
  const { ratio } = viewer.view;
  return { x: (event.clientX - box.left) * ratio, y: (event.clientY - box.top) * ratio };
}

function pointAt(place) {
  const { x, y } = viewer.view.toPicture(place.x, place.y);
  viewer.setPixel({ x: Math.floor(x), y: Math.floor(y) });
}

function middleAndSpread([a, b]) {
  return { x: (a.x + b.x) / 2, y: (a.y + b.y) / 2, spread: Math.hypot(a.x - b.x, a.y - b.y) };
}

/** One finger or the mouse drags the picture, two fingers zoom it as well. */
function listenToPointers(canvas) {
  const down = new Map();
  let moved = 0;

  const drag = (event) => {
    const before = [...down.values()];
    const from = down.get(event.pointerId);
    const to = placeOf(event);
    down.set(event.pointerId, to);
    moved += Math.hypot(to.x - from.x, to.y - from.y);
    if (moved < CLICK_DISTANCE) return;
    if (down.size === 1) {
      viewer.view.panBy(to.x - from.x, to.y - from.y);
    } else if (down.size === 2) {
      const was = middleAndSpread(before);
      const is = middleAndSpread([...down.values()]);
      viewer.view.panBy(is.x - was.x, is.y - was.y);
      viewer.view.zoomAt(viewer.view.zoom * (is.spread / Math.max(was.spread, 1)), is.x, is.y);
    }
    viewer.draw();
  };
  const release = (event) => {
    if (event.type === "pointerup" && moved < CLICK_DISTANCE) pointAt(placeOf(event));
    down.delete(event.pointerId);
  };

  canvas.addEventListener("pointerdown", (event) => {
    if (event.button !== 0) return;
    if (down.size === 0) moved = 0;
    canvas.setPointerCapture(event.pointerId);
    down.set(event.pointerId, placeOf(event));
  });
  canvas.addEventListener("pointermove", (event) => {
    if (down.has(event.pointerId)) drag(event);
    else if (event.pointerType !== "touch") pointAt(placeOf(event));
  });
  canvas.addEventListener("pointerup", release);
  canvas.addEventListener("pointercancel", release);
}

function listenToWheel(canvas) {
  const LINE = 16;  // pixels, for wheels that count in lines
  canvas.addEventListener("wheel", (event) => {
    event.preventDefault();
    const distance = event.deltaY * (event.deltaMode === 1 ? LINE : 1);
    const speed = event.ctrlKey ? 0.01 : 0.002;  // with ctrl it is two fingers on a touch pad
    const place = placeOf(event);
    viewer.view.zoomAt(viewer.view.zoom * Math.exp(-speed * distance), place.x, place.y);
    pointAt(place);
  }, { passive: false });
}

function listenToSplit(handle) {
  const follow = (event) => {
    const box = element("stage").getBoundingClientRect();
    viewer.setSplit((event.clientX - box.left) / box.width);
  };
  handle.addEventListener("pointerdown", (event) => {
    handle.setPointerCapture(event.pointerId);
    handle.focus();
    event.preventDefault();
  });
  handle.addEventListener("pointermove", (event) => {
    if (handle.hasPointerCapture(event.pointerId)) follow(event);
  });
}

/** To the next power of two. */
function zoomStep(direction) {
  const exponent = Math.log2(viewer.view.zoom);
  const next = direction > 0 ? Math.floor(exponent + 1.01) : Math.ceil(exponent - 1.01);
  viewer.view.zoomTo(2 ** next);
  viewer.draw();
}

function zoomOne() {
  viewer.view.zoomTo(1);
  viewer.draw();
}

function zoomFit() {
  viewer.view.fit();
  viewer.draw();
}

function moveBy(x, y, event) {
  if (event.shiftKey) {
    const { pixel, view } = viewer;
    const from = pixel || { x: Math.floor(view.centerX), y: Math.floor(view.centerY) };
    viewer.setPixel({
      x: Math.min(Math.max(from.x + x, 0), view.width - 1),
      y: Math.min(Math.max(from.y + y, 0), view.height - 1),
    });
  } else if (viewer.mode === "slider" && x !== 0) {
    viewer.setSplit(viewer.split + 0.02 * x);
  } else {
    viewer.view.panBy(-PAN_STEP * x, -PAN_STEP * y);
    viewer.draw();
  }
}

function blinkOrSwap() {
  if (viewer.mode === "blink" && viewer.paused) viewer.swap();
  else chooseMode("blink");
}

const KEYS = {
  s: () => chooseMode("side"),
  l: () => chooseMode("slider"),
  b: blinkOrSwap,
  d: () => chooseMode("difference"),
  h: () => chooseMode("flip"),
  a: () => chooseMode("actual"),
  e: () => chooseMode("expected"),
  "+": () => zoomStep(1),
  "=": () => zoomStep(1),
  "-": () => zoomStep(-1),
  1: zoomOne,
  f: zoomFit,
  m: () => viewer.goToWorst(),
  "[": () => viewer.setExposure(viewer.exposure - 0.5),
  "]": () => viewer.setExposure(viewer.exposure + 0.5),
  j: () => goToNeighbour(1),
  k: () => goToNeighbour(-1),
  escape: () => goToList(),
  arrowleft: (event) => moveBy(-1, 0, event),
  arrowright: (event) => moveBy(1, 0, event),
  arrowup: (event) => moveBy(0, -1, event),
  arrowdown: (event) => moveBy(0, 1, event),
  " ": () => viewer.setPaused(!viewer.paused),
};

/** Keys that an element has a use for itself stay with it. */
function belongsTo(target, key) {
  const takesSpace = target.closest("button, summary, input, select, a");
  const takesArrows = target.closest("input, select");
  if (key === " ") return Boolean(takesSpace) || viewer.mode !== "blink";
  if (key.startsWith("arrow")) return Boolean(takesArrows);
  return Boolean(target.closest("select, input[type=search]"));
}

function listenToKeys() {
  document.addEventListener("keydown", (event) => {
    if (element("viewer-page").hidden || event.ctrlKey || event.metaKey || event.altKey) return;
    const key = event.key.toLowerCase();
    if (!Object.hasOwn(KEYS, key) || belongsTo(event.target, key)) return;
    event.preventDefault();
    KEYS[key](event);
  });
}

function listenToControls() {
  const on = (id, type, listener) => element(id).addEventListener(type, listener);
  const difference = () => viewer.setDifference(Number(element("scale").value), element("signed").checked);
  element("modes").addEventListener("click", (event) => {
    if (event.target.dataset.mode) chooseMode(event.target.dataset.mode);
  });
  on("zoom-in", "click", () => zoomStep(1));
  on("zoom-out", "click", () => zoomStep(-1));
  on("zoom-one", "click", zoomOne);
  on("zoom-fit", "click", zoomFit);
  on("worst", "click", () => viewer.goToWorst());
  on("period", "input", () => viewer.setPeriod(Number(element("period").value)));
  on("pause", "click", () => viewer.setPaused(!viewer.paused));
  on("scale", "change", difference);
  on("signed", "change", difference);
  on("exposure", "input", () => viewer.setExposure(Number(element("exposure").value)));
  on("exposure-reset", "click", () => viewer.setExposure(0));
  on("copy", "click", copyCommand);
}

/** Selects the command, so that it can be copied by hand where a page may not. */
async function copyCommand() {
  window.getSelection().selectAllChildren(element("accept-command"));
  try {
    await navigator.clipboard.writeText(element("accept-command").textContent);
    element("copy").textContent = "Copied";
  } catch {
    element("copy").textContent = "Selected";
  }
}

function listenToInput() {
  listenToPointers(element("canvas"));
  listenToWheel(element("canvas"));
  listenToSplit(element("split"));
  listenToKeys();
  listenToControls();
}
