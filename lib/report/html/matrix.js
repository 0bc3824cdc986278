// Which parts penetrate which: rows are parts of the tracked nodes, columns those of the segments. A cell that is
// pressed filters the findings by its parts, pressed again by none.

function showMatrix(data, titles, choose) {
  const most = 20;
  const pairs = data.pairs.list;
  const place = byId("matrix");
  if (pairs.length === 0) {
    place.append(element("p", {class: "note"}, "No penetrations between parts are known."));
    return;
  }
  const rows = [], columns = [];
  let left = data.pairs.more;
  const cells = new Map();
  for (const [part, other, nodes, depth] of pairs) {
    const room = (list, id) => list.includes(id) || list.length < most;
    if (!room(rows, part) || !room(columns, other)) {
      ++left;
      continue;
    }
    if (!rows.includes(part)) rows.push(part);
    if (!columns.includes(other)) columns.push(other);
    const cell = cells.get(`${part} ${other}`) || {nodes: 0, depth: 0};
    cells.set(`${part} ${other}`, {nodes: cell.nodes + nodes, depth: Math.max(cell.depth, depth)});
  }
  for (const list of [rows, columns]) list.sort((a, b) => Number(a) - Number(b));
  const deepest = Math.max(...pairs.map((pair) => pair[3]));
  const named = (id) => (id === 0 ? "?" : String(id));
  const full = (id) => (titles.get(id) ? `part ${id}: ${titles.get(id)}` : `part ${named(id)}`);
  const head = element("tr", {}, element("th", {}, "node \\ in"));
  for (const id of columns) head.append(element("th", {scope: "col", title: full(id), class: "number"}, named(id)));
  const table = element("table", {}, element("thead", {}, head));
  for (const row of rows) {
    const line = element("tr", {}, element("th", {scope: "row", title: full(row)}, named(row)));
    for (const column of columns)
      line.append(matrixCell(cells.get(`${row} ${column}`), row, column, full, deepest, choose));
    table.append(line);
  }
  place.append(table);
  if (left > 0) place.append(element("p", {class: "note"}, `${counted(left, "pair")} of parts, less deep, not shown.`));
}

function matrixCell(cell, row, column, full, deepest, choose) {
  const made = element("td");
  if (cell === undefined) return made;
  const words = `${counted(cell.nodes, "record")} of ${full(row)} in ${full(column)}, deepest ${short(cell.depth)}`;
  const button = element(
      "button", {type: "button", title: words, "aria-label": words, "aria-pressed": "false"}, String(cell.nodes));
  made.style.background = `rgba(214, 84, 60, ${0.08 + 0.5 * Math.sqrt(cell.depth / (deepest || 1))})`;
  button.addEventListener("click", () => {
    const pressed = button.getAttribute("aria-pressed") === "true";
    for (const other of document.querySelectorAll("#matrix [aria-pressed=\"true\"]"))
      other.setAttribute("aria-pressed", "false");
    button.setAttribute("aria-pressed", String(!pressed));
    choose(pressed ? null : {part: row, other: column});
  });
  made.append(button);
  return made;
}
