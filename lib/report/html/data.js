// What the page shows: the JSON of the data element, with its arrays of numbers decoded.

function bytesOf(base64) {
  const text = atob(base64);
  const bytes = new Uint8Array(text.length);
  for (let i = 0; i < text.length; ++i) bytes[i] = text.charCodeAt(i);
  return bytes.buffer;
}

/** Numbers from their differences: seven bits per byte, the lowest first, the sign in the lowest bit. */
function unpacked(base64) {
  const bytes = new Uint8Array(bytesOf(base64));
  const numbers = new Uint32Array(bytes.reduce((count, byte) => count + (byte < 128 ? 1 : 0), 0));
  let at = 0, last = 0, step = 0, place = 1;
  for (const byte of bytes) {
    step += (byte % 128) * place;
    place *= 128;
    if (byte >= 128) continue;
    last += step % 2 === 1 ? -(step + 1) / 2 : step / 2;
    numbers[at++] = last;
    step = 0;
    place = 1;
  }
  return numbers;
}

/** The id of each face's element; 0: not known. */
function elementIds(picture) {
  const ids = new Uint32Array(picture.faces.length / 4);
  let face = 0;
  for (let run = 0; run < picture.elements.length; run += 2) {
    const [first, count] = picture.elements.subarray(run, run + 2);
    for (let i = 0; i < count; ++i) ids[face++] = first === 0 ? 0 : first + i;
  }
  return ids;
}

/** The contact thickness of each face; 0: none. */
function thicknesses(picture) {
  const values = new Float32Array(bytesOf(picture.thickness || ""));
  const thickness = new Float32Array(picture.faces.length / 4);
  let face = 0;
  picture.thickness_faces.forEach((count, run) => {
    thickness.fill(values[run], face, face + count);
    face += count;
  });
  return thickness;
}

/** Gives findings of an element without a place that of the element's first face in the mesh. */
function placeByElement({findings, picture}) {
  const wanted = new Map();
  findings.element.forEach((element, i) => {
    if (!(element > 0) || !Number.isNaN(picture.positions[3 * i])) return;
    if (!wanted.has(element)) wanted.set(element, []);
    wanted.get(element).push(i);
  });
  if (wanted.size === 0) return;
  for (const part of picture.parts)
    for (let f = part.first; f < part.first + part.faces; ++f)
      for (const i of wanted.get(picture.elements[f]) || []) {
        const known = [findings.element_part[i], findings.part[i]].filter((id) => id !== 0);
        if (!Number.isNaN(picture.positions[3 * i]) || (known.length > 0 && !known.includes(part.id))) continue;
        const corners = picture.faces.subarray(4 * f, 4 * f + 4);
        for (let axis = 0; axis < 3; ++axis)
          picture.positions[3 * i + axis] = corners.reduce((sum, p) => sum + picture.points[3 * p + axis] / 4, 0);
      }
}

/** Where there is no point. */
const nowhere = 0xffffffff;

const severities = ["note", "warning", "error"];

function readData() {
  const data = JSON.parse(document.getElementById("data").textContent);
  const picture = data.picture;
  for (const name of ["positions", "vectors", "points", "outline_points", "moved_to"])
    picture[name] = new Float32Array(bytesOf(picture[name] || ""));
  for (const name of ["faces", "outline"]) picture[name] = unpacked(picture[name] || "");
  for (const name of ["node_points", "corners", "elements", "thickness_faces", "moved_points"])
    picture[name] = new Uint32Array(bytesOf(picture[name] || ""));
  picture.point_depths = new Uint8Array(bytesOf(picture.point_depths || ""));
  picture.thickness = thicknesses(picture);
  picture.elements = elementIds(picture);
  picture.parts = picture.parts || [];
  placeByElement(data);
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
