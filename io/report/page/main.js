// SPDX-License-Identifier: Apache-2.0
// The page as a whole: what is shown of a report follows from the address (#case=name&mode=slider).

const report = JSON.parse(element("report").textContent);
const entries = report.cases;
const single = entries.length === 1;
let caseList = null;
let listScroll = 0;

function showProblem(problem) {
  element("problem").textContent = `The pictures cannot be shown: ${problem.message || problem}`;
  element("problem").hidden = false;
}

/** Names may be there twice; the later ones get a number. */
function giveIds() {
  const taken = new Set();
  for (const entry of entries) {
    let id = entry.name;
    for (let i = 2; taken.has(id); ++i) id = `${entry.name} (${i})`;
    taken.add(id);
    entry.id = id;
  }
}

function hashOf(entry, mode) {
  const hash = `#case=${encodeURIComponent(entry.id)}`;
  return mode ? `${hash}&mode=${mode}` : hash;
}

function chooseMode(mode) {
  viewer.setMode(mode);
  if (viewer.entry) window.history.replaceState(null, "", hashOf(viewer.entry, viewer.wantedMode));
}

function neighbour(step) {
  const shown = caseList ? caseList.shownEntries : entries;
  const list = shown.includes(viewer.entry) ? shown : entries;
  return list[list.indexOf(viewer.entry) + step] || null;
}

function goToNeighbour(step) {
  const entry = neighbour(step);
  if (entry) window.location.hash = hashOf(entry, viewer.wantedMode);
}

function goToList() {
  if (!single) window.location.hash = "";
}

function linkNeighbour(id, step) {
  const entry = neighbour(step);
  if (entry) element(id).href = hashOf(entry, viewer.wantedMode);
  else element(id).removeAttribute("href");
}

function addSource(name, text) {
  element("sources").append(make("dt", "", name), make("dd", "", text));
}

const KINDS = {
  half: "scene-linear", float: "scene-linear", srgb8: "sRGB, 8 bits", srgb16: "sRGB, 16 bits",
};

function describeSide(side, name) {
  if (!side) return;
  const size = `${side.fullWidth} × ${side.fullHeight}`;
  const rounded = side.rounded ? "; values are rounded to half floats here" : "";
  addSource(name, `${side.label ? `${side.label}, ` : ""}${size}, ${KINDS[side.format]}${rounded}`);
}

function describeFacts(facts) {
  const rows = facts.map((fact) => {
    const row = make("tr", fact.failed ? "failed" : "");
    const limit = fact.failed ? `${fact.limit} ✗` : fact.limit;
    row.append(make("th", "", fact.name), make("td", "", fact.value), make("td", "", limit));
    return row;
  });
  element("facts").hidden = facts.length === 0;
  element("facts").tBodies[0].replaceChildren(...rows);
}

/** All that is text in the viewer. */
function describeCase(entry) {
  element("case-name").textContent = entry.name;
  element("case-verdict").className = verdictClass(entry.verdict);
  element("case-verdict").textContent = entry.verdict;
  element("case-message").textContent = entry.message;
  describeFacts(entry.facts);
  element("accept").hidden = !entry.accept;
  element("accept-command").textContent = entry.accept;
  element("copy").textContent = "Copy";
  element("case-history").textContent = entry.history;
  element("sources").replaceChildren();
  describeSide(entry.actual, "actual");
  describeSide(entry.expected, "expected");
  if (entry.reduction > 1) {
    addSource("shown at",
      `1/${entry.reduction} of the size, as means of pixels: this page would get too large`);
  }
  if (entry.seconds !== undefined) addSource("took", formatSeconds(entry.seconds));
  if (single && report.summary) addSource("summary", report.summary);
  if (report.command) addSource("command", report.command);
}

function showCase(entry, mode) {
  if (!element("list-page").hidden) listScroll = window.scrollY;
  element("list-page").hidden = true;
  element("viewer-page").hidden = false;
  document.title = `${entry.name} - ${report.title}`;
  if (MODES.includes(mode)) viewer.wantedMode = mode;
  viewer.open(entry).then(() => viewer.showMode(), showProblem);
  linkNeighbour("previous", -1);
  linkNeighbour("next", 1);
  window.scrollTo(0, 0);
  element("case-name").focus({ preventScroll: true });
}

function showList() {
  const left = viewer.entry;
  viewer.close();
  element("viewer-page").hidden = true;
  element("list-page").hidden = false;
  document.title = report.title;
  window.scrollTo(0, listScroll);
  caseList.focus(left);
}

function route() {
  const wanted = new URLSearchParams(window.location.hash.slice(1));
  const entry = single ? entries[0] : entries.find(({ id }) => id === wanted.get("case"));
  if (entry) showCase(entry, wanted.get("mode"));
  else showList();
}

function start() {
  element("title").textContent = report.title;
  element("summary").textContent = report.summary;
  element("command").textContent = report.command;
  element("command").hidden = !report.command;
  giveIds();
  for (const id of ["back", "neighbours"]) element(id).hidden = single;
  if (!single) caseList = new CaseList(entries);
  if (!canInflate()) {
    showProblem("this browser has no DecompressionStream; Chromium 80, Firefox 113 and Safari 16.4 have.");
  }
  listenToInput();
  document.addEventListener("keydown", (event) => {
    if (event.key !== "/" || element("list-page").hidden || event.target === element("search")) return;
    event.preventDefault();
    element("search").focus();
  });
  window.addEventListener("hashchange", route);
  route();
}

start();
