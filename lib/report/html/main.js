// Puts the page together.

function showHead(data) {
  const {errors, warnings, notes} = data.totals;
  const name = data.input.split("/").pop() || "gapcheck";
  document.title = `${name}: ${counted(errors + warnings + notes, "finding")}`;
  byId("title").textContent = data.input;
  const verdict = byId("verdict");
  verdict.dataset.severity = errors ? "error" : warnings ? "warning" : notes ? "note" : "clean";
  const found = errors + warnings + notes === 0 ?
      "Nothing found" :
      [counted(errors, "error"), counted(warnings, "warning"), counted(notes, "note")].join(", ");
  verdict.textContent = found + (data.ignored > 0 ? `, ${data.ignored.toLocaleString("en")} ignored` : "") +
      (data.baseline ? `; against the baseline: ${data.baseline}` : "");
  const present = Object.entries(data.model).filter((entry) => entry[1] > 0);
  const kinds = present.map(([kind, count]) => counted(count, kind.slice(0, -1)));
  byId("model").textContent =
      [data.moves, kinds.join(", "), data.solver, data.termination, data["run title"]].filter(Boolean).join(" · ");
  byId("made").textContent =
      `gapcheck ${data.version}. Lengths in the deck's unit. This page loads nothing from anywhere.`;
}

/** The finding that the address points to (#f12); -1: none, or it is not in the page. */
function pointedTo(data) {
  const match = /^#f(\d{1,15})$/.exec(location.hash);
  return match ? data.findings.number.indexOf(Number(match[1])) : -1;
}

/** The address follows the selection, without a step in the history for each. */
function pointTo(finding) {
  const hash = `#f${data.findings.number[finding]}`;
  if (ready && location.hash !== hash) location.replace(hash);
}

const data = readData();
showHead(data);
const titles = new Map(data.picture.parts.map((part) => [part.id, part.title]));
let ready = false;  // what is selected to begin with leaves the address as it is
let view = null, shown = [], chosen = -1;
const worst = worstFirst(data);
const table = makeFindings(data, worst, (finding) => {
  chosen = finding;
  pointTo(finding);
  if (view) view.select(finding);
});
const filters = makeFilters(data, (passed) => {
  shown = passed;
  table.show(passed);
  if (view) view.show(passed);
});
showContacts(data, filters.chooseContact);
showHistogram(data, filters.chooseDepths);
showMatrix(data, titles, filters.choosePair);
filters.apply();
const wanted = pointedTo(data);
const first = wanted >= 0 ? wanted : worstOf(data, worst);
if (first >= 0) table.select(first);
else byId("caption").textContent = "There is nothing to show.";

ready = true;
addEventListener("hashchange", () => {
  const finding = pointedTo(data);
  if (finding >= 0 && finding !== chosen) table.select(finding);
});

// The tables can be read before the picture is there.
requestAnimationFrame(() => setTimeout(() => {
  view = makeView(data, (finding) => table.select(finding));
  view.show(shown);
  if (chosen >= 0) view.select(chosen);
}));
