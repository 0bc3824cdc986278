// Which findings are shown. `changed` is called with the positions of those that pass, in the report's order.

function makeFilters(data, changed) {
  const findings = data.findings;
  const count = findings.id.length;
  const range = {depth: null, pair: null};
  const text = element("input", {type: "search", placeholder: "text, node or part", "aria-label": "Text"});
  const severity = selectOf("Severity", [["", "any severity"], ...[2, 1, 0].map((s) => [String(s), severities[s]])]);
  const ruleNames = new Map();
  for (let i = 0; i < count; ++i) ruleNames.set(textOf(data, "id", i), textOf(data, "rule", i));
  const rules = [...ruleNames].sort().map(([id, name]) => [id, `${id} ${name}`]);
  const rule = selectOf("Rule", [["", "any rule"], ...rules]);
  const titles = new Map(data.contacts.map((contact) => [contact.id, contact.title]));
  const known = [...new Set(findings.contact)];
  const contact = selectOf("Contact", [
    ["", "any contact"],
    ...known.map((id) => [String(id), id === 0 ? "no contact" : `contact ${id} ${titles.get(id) || ""}`])
  ]);
  const partIds = [...new Set([...findings.part, ...findings.element_part])].filter((id) => id !== 0);
  partIds.sort((a, b) => Number(a) - Number(b));
  const part = selectOf("Part", [["", "any part"], ...partIds.slice(0, 5000).map((id) => [String(id), `part ${id}`])]);
  const state = selectOf("State", [["", "any state"], ...["new", "worse", "unchanged", "ignored"].map((s) => [s, s])]);
  const depth =
      element("input", {type: "number", min: 0, step: "any", placeholder: "depth from", "aria-label": "Depth from"});
  const reset = element("button", {type: "button"}, "All");

  let words = null;  // of every finding, made when the first text is searched for
  const wordsOf =
      (i) => [textOf(data, "id", i), textOf(data, "rule", i), textOf(data, "message", i), textOf(data, "outcome", i),
              placeOf(textOf(data, "file", i), findings.line[i]), idText(findings.node[i]), idText(findings.element[i]),
              idText(findings.part[i]), idText(findings.element_part[i])]
                 .join(" ")
                 .toLowerCase();

  function passes(i, wanted, least) {
    if (wanted && !words[i].includes(wanted)) return false;
    if (severity.value !== "" && findings.severity[i] !== Number(severity.value)) return false;
    if (rule.value !== "" && textOf(data, "id", i) !== rule.value) return false;
    if (contact.value !== "" && String(findings.contact[i]) !== contact.value) return false;
    if (state.value !== "" && textOf(data, "state", i) !== state.value) return false;
    if (part.value !== "" && String(findings.part[i]) !== part.value && String(findings.element_part[i]) !== part.value)
      return false;
    if (range.pair && (findings.part[i] !== range.pair.part || findings.element_part[i] !== range.pair.other))
      return false;
    const deep = findings.penetration[i];
    if (least > 0 && !(deep !== null && deep >= least)) return false;
    if (range.depth) {
      const value = range.depth.ratio ? deep / findings.contact_distance[i] : deep;
      if (deep === null || !(value >= range.depth.from && value < range.depth.to)) return false;
    }
    return true;
  }

  function apply() {
    const wanted = text.value.trim().toLowerCase();
    if (wanted && words === null) words = Array.from({length: count}, (_, i) => wordsOf(i));
    const least = Number(depth.value);
    const passed = [];
    for (let i = 0; i < count; ++i)
      if (passes(i, wanted, least)) passed.push(i);
    changed(passed);
  }

  reset.addEventListener("click", () => {
    for (const field of [text, severity, state, rule, contact, part, depth]) field.value = "";
    range.depth = range.pair = null;
    for (const bar of document.querySelectorAll("#histogram .chosen")) bar.classList.remove("chosen");
    for (const cell of document.querySelectorAll("#matrix [aria-pressed=\"true\"]"))
      cell.setAttribute("aria-pressed", "false");
    apply();
  });
  byId("filters").append(text, severity, ...(hasStates(data) ? [state] : []), rule, contact, part, depth, reset);
  byId("filters").addEventListener("input", apply);
  byId("filters").addEventListener("submit", (event) => event.preventDefault());
  return {
    apply,
    chooseContact(id) {
      contact.value = contact.value === String(id) ? "" : String(id);
      // A contact without findings is not in the list.
      if (contact.selectedIndex < 0) contact.value = "";
      apply();
    },
    chooseDepths(depths) {
      range.depth = depths;
      apply();
    },
    choosePair(pair) {
      range.pair = pair;
      apply();
    },
  };
}
