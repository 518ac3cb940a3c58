// SPDX-License-Identifier: Apache-2.0
// Pictures, differences and maps as colours: each becomes a canvas of its own size.

const NOT_FINITE = 256;
const NOT_FINITE_COLOR = [255, 0, 255];
const LUMINANCE = [0.2126, 0.7152, 0.0722];
const MORE_COLOR = [255, 150, 30];
const LESS_COLOR = [70, 150, 255];

/** Stops of magma (van der Walt and Smith 2015, CC0), at equal distances. */
const MAGMA = [
  [0, 0, 4], [28, 16, 68], [79, 18, 123], [129, 37, 129], [181, 54, 122],
  [229, 80, 100], [251, 135, 97], [254, 194, 135], [252, 253, 191],
];

/** 8-bit sRGB of a linear value in [0, 1], by its 65535ths. */
const ENCODED_BYTES = Uint8Array.from({ length: 65536 }, (_, i) => {
  const v = i / 65535;
  return Math.round(255 * (v <= 0.0031308 ? 12.92 * v : 1.055 * v ** (1 / 2.4) - 0.055));
});

/** What a screen shows of a value, clipped. */
function shownByte(value, encoded) {
  if (!Number.isFinite(value)) return NOT_FINITE;
  if (!(value > 0)) return 0;
  if (value >= 1) return 255;
  return encoded ? Math.round(255 * value) : ENCODED_BYTES[Math.round(65535 * value)];
}

function heatColor(value) {
  const at = Math.min(Math.max(value, 0), 1) * (MAGMA.length - 1);
  const low = Math.min(Math.floor(at), MAGMA.length - 2);
  return MAGMA[low].map((stop, c) => Math.round(stop + (at - low) * (MAGMA[low + 1][c] - stop)));
}

/** A canvas whose every pixel is set by paint(bytes, index of the pixel, index of its first byte). */
function paintLayer(width, height, paint) {
  const canvas = document.createElement("canvas");
  canvas.width = width;
  canvas.height = height;
  const context = canvas.getContext("2d");
  const data = context.createImageData(width, height);
  const bytes = data.data;
  for (let i = 0, to = 0; i < width * height; ++i, to += 4) {
    bytes[to + 3] = 255;
    paint(bytes, i, to);
  }
  context.putImageData(data, 0, 0);
  return canvas;
}

function setColor(bytes, to, color) {
  for (let c = 0; c < 3; ++c) bytes[to + c] = color[c];
}

/** The picture, its linear values times 2^exposure first. */
function pictureLayer(picture, exposure) {
  const gain = picture.encoded ? 1 : 2 ** exposure;
  const { planes, lookup, encoded } = picture;
  const table = lookup && Uint16Array.from(lookup, (value) => shownByte(value * gain, encoded));
  return paintLayer(picture.width, picture.height, (bytes, i, to) => {
    for (let c = 0; c < 3; ++c) {
      const number = planes[c][i];
      const shown = table ? table[number] : shownByte(number * gain, encoded);
      if (shown === NOT_FINITE) {
        setColor(bytes, to, NOT_FINITE_COLOR);
        return;
      }
      bytes[to + c] = shown;
    }
  });
}

/** Calls visit(x, y, actual's index, expected's index) for every pixel that both have. */
function forCommonPixels(actual, expected, visit) {
  const width = Math.min(actual.width, expected.width);
  const height = Math.min(actual.height, expected.height);
  for (let y = 0; y < height; ++y) {
    for (let x = 0; x < width; ++x) visit(x, y, y * actual.width + x, y * expected.width + x);
  }
}

/** Where both pictures are. `factor` multiplies differences before they are shown. */
function differenceLayer(actual, expected, factor, signed) {
  const width = Math.min(actual.width, expected.width);
  const height = Math.min(actual.height, expected.height);
  const difference = [0, 0, 0];
  return paintLayer(width, height, (bytes, i, to) => {
    const x = i % width;
    const y = (i - x) / width;
    let luminance = 0;
    for (let c = 0; c < 3; ++c) {
      const d = actual.value(c, y * actual.width + x) - expected.value(c, y * expected.width + x);
      difference[c] = shownByte(factor * Math.abs(d), actual.encoded);
      luminance += LUMINANCE[c] * factor * d;
    }
    if (difference.includes(NOT_FINITE)) {
      setColor(bytes, to, NOT_FINITE_COLOR);
    } else if (signed) {
      const strength = shownByte(Math.abs(luminance), actual.encoded) / 255;
      const color = luminance < 0 ? LESS_COLOR : MORE_COLOR;
      for (let c = 0; c < 3; ++c) bytes[to + c] = Math.round(strength * color[c]);
    } else {
      setColor(bytes, to, difference);
    }
  });
}

function flipLayer(map) {
  const colors = Array.from(map.lookup, heatColor);
  return paintLayer(map.width, map.height, (bytes, i, to) => {
    setColor(bytes, to, colors[map.planes[0][i]]);
  });
}

/** The pixel in which a channel differs most; one that is not finite counts as infinitely far. */
function findWorstPixel(actual, expected) {
  let worst = { x: 0, y: 0, difference: -1 };
  forCommonPixels(actual, expected, (x, y, i, j) => {
    for (let c = 0; c < 3; ++c) {
      const difference = Math.abs(actual.value(c, i) - expected.value(c, j));
      const counted = Number.isNaN(difference) ? Infinity : difference;
      if (counted > worst.difference) worst = { x, y, difference: counted };
    }
  });
  return worst;
}

/**
 * The exposure to begin with: 0, unless nearly all would be black or white. Then the value that one
 * pixel in twenty exceeds becomes 0.8.
 */
function startExposure(picture) {
  if (!picture || picture.encoded) return 0;
  const count = picture.width * picture.height;
  const step = Math.max(1, Math.floor(count / 20000));
  const values = [];
  for (let i = 0; i < count; i += step) {
    const value = Math.max(picture.value(0, i), picture.value(1, i), picture.value(2, i));
    if (Number.isFinite(value)) values.push(value);
  }
  values.sort((a, b) => a - b);
  const high = values[Math.floor(0.95 * values.length)];
  if (!(high > 0) || (high > 0.1 && high < 4)) return 0;
  return Math.min(Math.max(Math.round(2 * Math.log2(0.8 / high)) / 2, -20), 20);
}
