// The table of contacts. A row that is pressed filters the findings by its contact.

function contactCells(contact) {
  const found = contact.not_checked ? "not checked" : contact.tied ? "tied" : String(contact.penetrations);
  return [
    [idText(contact.id) || `no. ${contact.order}`, "number"],
    [contact.title || contact.keyword, ""],
    [contact.type, ""],
    [contact.tracked_nodes.toLocaleString("en"), "number"],
    [contact.segments.toLocaleString("en"), "number"],
    [found, "number"],
    [contact.max_penetration > 0 ? short(contact.max_penetration) : "", "number"],
    [contact.edge_zone ? String(contact.edge_zone) : "", "number"],
    [contact.untied ? String(contact.untied) : "", "number"],
  ];
}

function showContacts(data, choose) {
  const most = 1000;
  const heads = ["id", "contact", "type", "nodes", "segments", "penetrations", "deepest", "edge zone", "untied"];
  const head = element("tr");
  const numeric = (i) => (i === 1 || i === 2 ? "" : "number");
  heads.forEach((text, i) => head.append(element("th", {scope: "col", class: numeric(i)}, text)));
  const body = element("tbody");
  for (const contact of data.contacts.slice(0, most)) {
    const hint = [contact.keyword, placeOf(contact.file, contact.line), contact.not_checked].filter(Boolean).join("\n");
    const row = element("tr", {class: "choice", tabindex: 0, title: hint});
    for (const [text, kind] of contactCells(contact)) row.append(element("td", {class: kind}, text));
    onPress(row, () => choose(contact.id));
    body.append(row);
  }
  byId("contacts").append(element("table", {}, element("thead", {}, head), body));
  const more = data.contacts_in_all - Math.min(most, data.contacts.length);
  if (more > 0)
    byId("contacts").append(element("p", {class: "note"}, `${counted(more, "further contact")} not shown.`));
  if (data.contacts_in_all === 0) byId("contacts").append(element("p", {class: "note"}, "There are no contacts."));
}
