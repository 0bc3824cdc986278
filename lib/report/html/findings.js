// The table of findings: only the rows that can be seen are in the document, so that it stays quick with many.

const rowHeight = 38;

/** Columns: heading, width, kind, text of a finding, and what to sort by. */
function findingColumns(data) {
  const f = data.findings;
  const id = (name) => ({text: (i) => idText(f[name][i]), key: (i) => Number(f[name][i]), kind: "number"});
  const share = (i) =>
      (f.penetration[i] === null || !(f.contact_distance[i] > 0) ? null : f.penetration[i] / f.contact_distance[i]);
  const state = {head: "state", width: 66, text: (i) => textOf(data, "state", i), key: (i) => textOf(data, "state", i)};
  const words = (i) => textOf(data, "message", i);
  return [
    {head: "severity", width: 60, text: (i) => severities[f.severity[i]], key: (i) => f.severity[i], descend: true},
    {
      head: "rule",
      width: 96,
      kind: "message",
      text: (i) => `${textOf(data, "id", i)} ${textOf(data, "rule", i)}`,
      key: (i) => textOf(data, "id", i)
    },
    {
      head: "depth",
      width: 52,
      kind: "number",
      text: (i) => short(f.penetration[i]),
      key: (i) => f.penetration[i] ?? -1,
      descend: true
    },
    {head: "message", width: 312, kind: "message", text: words, key: words},
    {
      head: "% of h",
      width: 50,
      kind: "number",
      text: (i) => (share(i) === null ? "" : (100 * share(i)).toFixed(0)),
      key: (i) => share(i) ?? -1,
      descend: true
    },
    {head: "node", width: 66, ...id("node")},
    {head: "part", width: 48, ...id("part")},
    {head: "element", width: 66, ...id("element")},
    {head: "of part", width: 56, ...id("element_part")},
    {head: "contact", width: 58, ...id("contact")},
    ...(hasStates(data) ? [state] : []),
    {
      head: "place",
      width: 0,
      text: (i) => tail(placeOf(textOf(data, "file", i), f.line[i]), 14),
      hint: (i) => placeOf(textOf(data, "file", i), f.line[i]),
      key: (i) => `${textOf(data, "file", i)} ${String(f.line[i]).padStart(10, "0")}`
    },
  ];
}

/** Findings as they are worth looking at: what is left out on purpose last, errors first, the deepest first. */
function worstFirst(data) {
  const f = data.findings;
  const ignored = (i) => Number(textOf(data, "state", i) === "ignored");
  const order = f.severity.map((_, i) => i);
  order.sort((a, b) => ignored(a) - ignored(b) || f.severity[b] - f.severity[a] ||
                 (f.penetration[b] ?? -1) - (f.penetration[a] ?? -1) || a - b);
  return order;
}

/** The first of those of the worst severity that has a place in the picture; without any the first; -1: none. */
function worstOf(data, order) {
  const placed = (i) => !Number.isNaN(data.picture.positions[3 * i]);
  const asBad = (i) => data.findings.severity[i] === data.findings.severity[order[0]];
  return order.find((i) => asBad(i) && placed(i)) ?? order[0] ?? -1;
}

function makeFindings(data, worst, selected) {
  const columns = findingColumns(data);
  const place = byId("findings");
  const body = element("tbody");
  const above = element("tr", {class: "gap"}, element("td", {colspan: columns.length}));
  const below = above.cloneNode(true);
  const rank = new Uint32Array(worst.length);
  worst.forEach((finding, at) => {
    rank[finding] = at;
  });
  let passed = [], order = [], sorting = null, chosen = -1;

  function head() {
    const row = element("tr");
    columns.forEach((column, c) => {
      const mark = sorting && sorting.column === c ? (sorting.descend ? " ▾" : " ▴") : "";
      const button = element("button", {type: "button"}, column.head + mark);
      button.addEventListener("click", () => sortBy(c));
      const cell = element("th", {scope: "col", class: column.kind || ""}, button);
      if (mark) cell.setAttribute("aria-sort", sorting.descend ? "descending" : "ascending");
      if (column.width > 0) cell.style.width = `${column.width}px`;
      row.append(cell);
    });
    return row;
  }

  function sortBy(column) {
    const first = Boolean(columns[column].descend);
    if (!sorting || sorting.column !== column)
      sorting = {column, descend: first};
    else
      sorting = sorting.descend === first ? {column, descend: !first} : null;
    table.tHead.replaceChildren(head());
    arrange();
  }

  function arrange() {
    order = passed.slice().sort((a, b) => rank[a] - rank[b]);
    if (sorting) {
      const keys = new Map(order.map((i) => [i, columns[sorting.column].key(i)]));
      const sign = sorting.descend ? -1 : 1;
      order.sort((a, b) => (keys.get(a) < keys.get(b) ? -sign : keys.get(a) > keys.get(b) ? sign : rank[a] - rank[b]));
    }
    place.firstChild.setAttribute("aria-rowcount", order.length + 1);
    draw();
  }

  function rowOf(at) {
    const i = order[at];
    const row = element("tr", {
      class: "choice",
      role: "row",
      "aria-rowindex": at + 2,
      "aria-selected": String(i === chosen),
      "data-finding": i,
      id: `finding-${i}`
    });
    columns.forEach((column, c) => {
      const text = column.text(i);
      const title = column.hint ? column.hint(i) : text;
      const inside = column.kind === "message" ? element("span", {}, text) : text;
      const cell = element("td", {role: "gridcell", class: column.kind || "", title}, inside);
      if (c === 0) cell.classList.add(text === "note" ? "severity-note" : text);
      row.append(cell);
    });
    return row;
  }

  function draw() {
    const first = Math.max(0, Math.floor(place.scrollTop / rowHeight) - 10);
    const last = Math.min(order.length, first + Math.ceil(place.clientHeight / rowHeight) + 20);
    above.firstChild.style.height = `${first * rowHeight}px`;
    below.firstChild.style.height = `${(order.length - last) * rowHeight}px`;
    const rows = [above];
    for (let at = first; at < last; ++at) rows.push(rowOf(at));
    body.replaceChildren(...rows, below);
    if (chosen >= 0) place.setAttribute("aria-activedescendant", `finding-${chosen}`);
  }

  function select(i) {
    chosen = i;
    const at = order.indexOf(i);
    const top = at * rowHeight, room = place.clientHeight - 2 * rowHeight;
    if (at >= 0 && top < place.scrollTop) place.scrollTop = top;
    if (at >= 0 && top > place.scrollTop + room) place.scrollTop = top - room;
    draw();
    showDetail(data, i);
    selected(i);
  }

  function move(event) {
    const page = Math.max(1, Math.floor(place.clientHeight / rowHeight) - 2);
    const steps = {ArrowDown: 1, ArrowUp: -1, PageDown: page, PageUp: -page, Home: -order.length, End: order.length};
    if (!(event.key in steps) || order.length === 0 || event.target.tagName === "BUTTON") return;
    event.preventDefault();
    const at = order.indexOf(chosen);
    const next = at < 0 ? 0 : Math.min(order.length - 1, Math.max(0, at + steps[event.key]));
    select(order[next]);
  }

  const table = element("table", {role: "grid", "aria-label": "Findings"}, element("thead", {}, head()), body);
  place.setAttribute("tabindex", "0");
  place.append(table);
  place.addEventListener("scroll", draw, {passive: true});
  place.addEventListener("keydown", move);
  window.addEventListener("resize", draw);
  body.addEventListener("click", (event) => {
    const row = event.target.closest("tr.choice");
    if (row) select(Number(row.dataset.finding));
  });
  return {
    show(list) {
      passed = list;
      const total = data.findings.id.length;
      const rest = data.found - data.shown;
      const more = rest > 0 ? `; ${rest.toLocaleString("en")} more are in the output of --format csv` : "";
      byId("count").textContent = `${list.length.toLocaleString("en")} of ${counted(total, "finding")}${more}`;
      arrange();
    },
    select,
  };
}

function showDetail(data, i) {
  const f = data.findings;
  const list = element("dl");
  const add = (name, text) => {
    if (text !== "" && text !== null) list.append(element("dt", {}, name), element("dd", {}, String(text)));
  };
  add("place", placeOf(textOf(data, "file", i), f.line[i]));
  const lengths = [f.penetration[i], f.contact_distance[i]].filter((value) => value !== null);
  const digits = (value) => Number(value.toPrecision(9));
  if (f.penetration[i] !== null) add("depth, contact distance", lengths.map(digits).join(", "));
  add("segment", f.segment[i].join(" "));
  add("state", textOf(data, "state", i));
  add("left out by", textOf(data, "ignored_by", i));
  add("outcome", textOf(data, "outcome", i));
  if (f.count[i] > 1) add("stands for", counted(f.count[i], "thing"));
  const [x, y, z] = data.picture.positions.subarray(3 * i, 3 * i + 3);
  if (!Number.isNaN(x))
    add("position", [x, y, z].map((value, axis) => short(value + data.picture.origin[axis])).join(", "));
  byId("detail").replaceChildren(list);
  const severity = severities[f.severity[i]];
  const rule = `${severity} ${textOf(data, "id", i)} ${textOf(data, "rule", i)}`;
  const kind = severity === "note" ? "severity-note" : severity;
  byId("caption").title = textOf(data, "message", i);
  byId("caption").replaceChildren(element("strong", {class: kind}, rule), textOf(data, "message", i));
}
