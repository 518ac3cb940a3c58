// SPDX-License-Identifier: Apache-2.0
// The table of pixel values.

function element(id) {
  return document.getElementById(id);
}

/** Five digits are more than half floats have. */
function formatFloat(value, digits = 5) {
  if (!Number.isFinite(value)) return String(value).replace("Infinity", "inf").replace("NaN", "nan");
  const size = Math.abs(value);
  if (size !== 0 && (size < 1e-3 || size >= 1e6)) return value.toExponential(digits - 2);
  return value.toPrecision(digits);
}

function withSign(text) {
  return text.startsWith("-") || text === "nan" ? text : `+${text}`;
}

function pixelTexts(picture, pixel) {
  if (!picture || !picture.contains(pixel.x, pixel.y)) return null;
  const index = pixel.y * picture.width + pixel.x;
  return [0, 1, 2].map((c) => (picture.display ? String(picture.code(c, index))
    : formatFloat(picture.value(c, index))));
}

/** Of codes if both pictures have the same, of 255ths if not, of linear values otherwise. */
function differenceTexts(pictures, pixel) {
  const { actual, expected, encoded } = pictures;
  if (!actual || !expected) return null;
  if (!actual.contains(pixel.x, pixel.y) || !expected.contains(pixel.x, pixel.y)) return null;
  const i = pixel.y * actual.width + pixel.x;
  const j = pixel.y * expected.width + pixel.x;
  return [0, 1, 2].map((c) => {
    if (encoded && actual.format === expected.format) {
      return withSign(String(actual.code(c, i) - expected.code(c, j)));
    }
    const difference = actual.value(c, i) - expected.value(c, j);
    return withSign(encoded ? (255 * difference).toFixed(2) : formatFloat(difference, 4));
  });
}

function fillRow(row, texts) {
  for (let c = 0; c < 3; ++c) row.cells[c + 1].textContent = texts ? texts[c] : "";
}

function whereText(pictures, pixel, reduction) {
  const place = reduction > 1
    ? `Mean of ${reduction} × ${reduction} pixels from x ${pixel.x * reduction}, y ${pixel.y * reduction}`
    : `x ${pixel.x}, y ${pixel.y}`;
  const { flip } = pictures;
  if (!flip || !flip.contains(pixel.x, pixel.y)) return place;
  return `${place}; FLIP ${flip.value(0, pixel.y * flip.width + pixel.x).toFixed(3)}`;
}

function rowName(side, picture) {
  if (!picture || !picture.display) return side;
  return `${side}, ${picture.format === "srgb8" ? 8 : 16} bits`;
}

function showReadout(pictures, pixel, reduction) {
  element("readout-where").textContent =
    pixel ? whereText(pictures, pixel, reduction) : "Point at a pixel for its values";
  for (const side of ["actual", "expected"]) {
    const row = element(`readout-${side}`);
    row.hidden = !pictures[side];
    row.cells[0].textContent = rowName(side, pictures[side]);
    fillRow(row, pixel && pixelTexts(pictures[side], pixel));
  }
  const row = element("readout-difference");
  row.hidden = !pictures.actual || !pictures.expected;
  fillRow(row, pixel && differenceTexts(pictures, pixel));
}
