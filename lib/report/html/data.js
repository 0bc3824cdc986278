// What the page shows: the JSON of the data element, with its arrays of numbers decoded.

function bytesOf(base64) {
  const text = atob(base64);
  const bytes = new Uint8Array(text.length);
  for (let i = 0; i < text.length; ++i) bytes[i] = text.charCodeAt(i);
  return bytes.buffer;
}

const severities = ["note", "warning", "error"];

function readData() {
  const data = JSON.parse(document.getElementById("data").textContent);
  const picture = data.picture;
  for (const name of ["positions", "vectors", "points", "outline_points"])
    picture[name] = new Float32Array(bytesOf(picture[name] || ""));
  for (const name of ["faces", "outline"]) picture[name] = new Uint32Array(bytesOf(picture[name] || ""));
  picture.parts = picture.parts || [];
  return data;
}

/** The text of a finding's column that holds positions of texts. */
function textOf(data, column, finding) {
  return data.texts[data.findings[column][finding]];
}

/** There is a baseline, or something is left out on purpose. */
function hasStates(data) {
  return data.baseline !== "" || data.ignored > 0;
}

/** Ids of 0 are not known. */
function idText(id) {
  return id === 0 ? "" : String(id);
}

function placeOf(file, line) {
  return file === "" ? "" : line > 0 ? `${file}:${line}` : file;
}

/** The end of a long text, which says more of a path than its beginning. */
function tail(text, length) {
  return text.length > length ? `…${text.slice(1 - length)}` : text;
}

/** Four significant digits, as tables show lengths. */
function short(number) {
  return number === null ? "" : String(Number(number.toPrecision(4)));
}

function counted(number, noun) {
  return `${number.toLocaleString("en")} ${noun}${number === 1 ? "" : "s"}`;
}
