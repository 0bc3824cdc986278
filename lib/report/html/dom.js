// Building elements. Texts become text nodes, never markup.

function element(name, attributes = {}, ...children) {
  const made = document.createElement(name);
  for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, value);
  made.append(...children);
  return made;
}

function drawing(name, attributes = {}, text = "") {
  const made = document.createElementNS("http://www.w3.org/2000/svg", name);
  for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, value);
  made.textContent = text;
  return made;
}

function byId(id) {
  return document.getElementById(id);
}

/** Calls `act` for a click, and for Enter and the space bar. */
function onPress(target, act) {
  target.addEventListener("click", act);
  target.addEventListener("keydown", (event) => {
    if (event.key !== "Enter" && event.key !== " ") return;
    event.preventDefault();
    act(event);
  });
}

function selectOf(label, entries) {
  const select = element("select", {"aria-label": label});
  for (const [value, text] of entries) select.append(element("option", {value}, text));
  return select;
}

function checkBox(text, checked, change) {
  const box = element("input", {type: "checkbox"});
  box.checked = checked;
  box.addEventListener("change", () => change(box.checked));
  return element("label", {}, box, text);
}

/** A value of the style sheet: "--error". */
function styleValue(name) {
  return getComputedStyle(document.documentElement).getPropertyValue(name).trim();
}
