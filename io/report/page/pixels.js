// SPDX-License-Identifier: Apache-2.0
// Pictures as the page holds them, unpacked into planes of numbers: the reverse of packed_image.cpp.
"use strict";

const FORMATS = {
  half: { bytes: 2, planes: 3, Codes: Uint16Array },
  float: { bytes: 4, planes: 3, Codes: Uint32Array },
  srgb8: { bytes: 1, planes: 3, Codes: Uint8Array },
  srgb16: { bytes: 2, planes: 3, Codes: Uint16Array },
  unit8: { bytes: 1, planes: 1, Codes: Uint8Array },
};

/** The value of every half float (IEEE 754-2008, binary16), by its bits. */
const HALF_VALUES = (() => {
  const values = new Float32Array(65536);
  for (let bits = 0; bits < 65536; ++bits) {
    const sign = bits & 0x8000 ? -1 : 1;
    const exponent = (bits >> 10) & 31;
    const mantissa = bits & 1023;
    if (exponent === 31) values[bits] = mantissa ? NaN : sign * Infinity;
    else if (exponent === 0) values[bits] = sign * mantissa * 2 ** -24;
    else values[bits] = sign * (1024 + mantissa) * 2 ** (exponent - 25);
  }
  return values;
})();

/** IEC 61966-2-1, of a value in [0, 1]. */
function srgbToLinear(encoded) {
  return encoded <= 0.04045 ? encoded / 12.92 : ((encoded + 0.055) / 1.055) ** 2.4;
}

function canInflate() {
  return typeof DecompressionStream === "function";
}

async function inflate(id) {
  const text = atob(document.getElementById(id).textContent);
  const packed = new Uint8Array(text.length);
  for (let i = 0; i < text.length; ++i) packed[i] = text.charCodeAt(i);
  const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream("deflate"));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

function joinBytes(bytes, start, codes, bytesPerCode) {
  for (let k = 0; k < bytesPerCode; ++k) {
    const from = start + k * codes.length;
    for (let i = 0; i < codes.length; ++i) codes[i] = (codes[i] << 8) | bytes[from + i];
  }
}

function addNeighbours(codes, width) {
  for (let i = width; i < codes.length; i += width) codes[i] += codes[i - width];
  for (let row = 0; row < codes.length; row += width) {
    for (let i = row + 1; i < row + width; ++i) codes[i] += codes[i - 1];
  }
}

function unpackPlanes(bytes, format, width, height) {
  const { bytes: bytesPerCode, planes: count, Codes } = FORMATS[format];
  const planes = [];
  for (let p = 0; p < count; ++p) {
    const codes = new Codes(width * height);
    joinBytes(bytes, p * codes.length * bytesPerCode, codes, bytesPerCode);
    addNeighbours(codes, width);
    planes.push(codes);
  }
  if (count === 3) {
    const [red, green, blue] = planes;
    for (let i = 0; i < green.length; ++i) {
      red[i] += green[i];
      blue[i] += green[i];
    }
  }
  return format === "float" ? planes.map((codes) => new Float32Array(codes.buffer)) : planes;
}

/** The value of each code; null where numbers are values themselves. */
function lookupFor(format, wantsEncoded) {
  if (format === "float") return null;
  if (format === "half") return HALF_VALUES;
  const most = format === "srgb16" ? 65535 : 255;
  const values = new Float32Array(most + 1);
  for (let code = 0; code <= most; ++code) {
    const encoded = code / most;
    values[code] = wantsEncoded || format === "unit8" ? encoded : srgbToLinear(encoded);
  }
  return values;
}

/**
 * A picture with its planes. Its values are encoded sRGB where both pictures of a case are, and
 * linear otherwise.
 */
class Picture {
  constructor(meta, planes, encoded) {
    this.width = meta.width;
    this.height = meta.height;
    this.format = meta.format;
    this.display = meta.format.startsWith("srgb");
    this.encoded = encoded;
    this.planes = planes;
    this.lookup = lookupFor(meta.format, encoded);
  }

  contains(x, y) {
    return x >= 0 && y >= 0 && x < this.width && y < this.height;
  }

  value(channel, index) {
    const number = this.planes[channel][index];
    return this.lookup ? this.lookup[number] : number;
  }

  code(channel, index) {
    return this.planes[channel][index];
  }
}

async function unpackPicture(meta, encoded) {
  if (!meta) return null;
  const bytes = await inflate(meta.data);
  return new Picture(meta, unpackPlanes(bytes, meta.format, meta.width, meta.height), encoded);
}

async function unpackCase(entry) {
  const sides = [entry.actual, entry.expected].filter(Boolean);
  const encoded = sides.every((side) => side.format.startsWith("srgb"));
  return {
    encoded,
    actual: await unpackPicture(entry.actual, encoded),
    expected: await unpackPicture(entry.expected, encoded),
    flip: await unpackPicture(entry.flip, true),
  };
}

const unpackedCases = new Map();
const MOST_UNPACKED = 4;

/** The case's pictures. Those of the last few cases are kept, as unpacking takes a while. */
function picturesOf(entry) {
  const known = unpackedCases.get(entry);
  unpackedCases.delete(entry);
  const pictures = known || unpackCase(entry);
  unpackedCases.set(entry, pictures);
  if (unpackedCases.size > MOST_UNPACKED) unpackedCases.delete(unpackedCases.keys().next().value);
  return pictures;
}
