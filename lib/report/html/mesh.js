// The mesh around the findings and the outline of the whole model as objects of three.js.

/** Pale, and without the reds and oranges of severities. */
function partColor(position) {
  return new THREE.Color().setHSL(0.18 + 0.64 * ((0.6 + position * 0.618034) % 1), 0.24, 0.64);
}

/** Every edge of the faces once, as pairs of points. */
function faceEdges(faces, points) {
  const keys = new Float64Array(faces.length);
  let count = 0;
  for (let f = 0; f < faces.length; f += 4) {
    const edges = faces[f + 1] === faces[f + 2] ? 1 : 4;  // a beam has one
    for (let i = 0; i < edges; ++i) {
      const a = faces[f + i], b = faces[f + ((i + 1) % 4)];
      if (a !== b) keys[count++] = Math.min(a, b) * points + Math.max(a, b);
    }
  }
  const sorted = keys.subarray(0, count).sort();
  const pairs = new Uint32Array(2 * count);
  let length = 0;
  for (let i = 0; i < count; ++i) {
    if (i > 0 && sorted[i] === sorted[i - 1]) continue;
    pairs[length++] = Math.floor(sorted[i] / points);
    pairs[length++] = sorted[i] % points;
  }
  return pairs.slice(0, length);
}

function faceTriangles(faces) {
  const corners = new Uint32Array((faces.length / 4) * 6);
  let length = 0;
  for (let f = 0; f < faces.length; f += 4) {
    const [a, b, c, d] = faces.subarray(f, f + 4);
    if (b === c) continue;
    corners[length++] = a;
    corners[length++] = b;
    corners[length++] = c;
    if (c === d) continue;
    corners[length++] = a;
    corners[length++] = c;
    corners[length++] = d;
  }
  return corners.slice(0, length);
}

function makeMesh(picture) {
  const points = new THREE.BufferAttribute(picture.points, 3);
  const colors = new Uint8Array(picture.points.length);
  picture.parts.forEach((part, p) => {
    const color = partColor(p).toArray().map((value) => Math.round(255 * value));
    for (const point of picture.faces.subarray(4 * part.first, 4 * (part.first + part.faces)))
      colors.set(color, 3 * point);
  });
  const surface = new THREE.BufferGeometry(), lines = new THREE.BufferGeometry(), outline = new THREE.BufferGeometry();
  surface.setAttribute("position", points);
  surface.setAttribute("color", new THREE.BufferAttribute(colors, 3, true));
  lines.setAttribute("position", points);
  outline.setAttribute("position", new THREE.BufferAttribute(picture.outline_points, 3));
  outline.setIndex(new THREE.BufferAttribute(picture.outline, 1));
  const faces = new THREE.Mesh(surface, new THREE.MeshPhongMaterial({
    vertexColors: THREE.VertexColors,
    flatShading: true,
    side: THREE.DoubleSide,
    shininess: 0,
    transparent: true,
    opacity: 1,
    polygonOffset: true,
    polygonOffsetFactor: 1,
    polygonOffsetUnits: 1,
  }));
  const made = {
    faces,
    lines: new THREE.LineSegments(lines, new THREE.LineBasicMaterial({transparent: true, opacity: 0.5})),
    outline: new THREE.LineSegments(outline, new THREE.LineBasicMaterial({transparent: true, opacity: 0.7})),
    /** Shows only the parts whose positions are not in `hidden`. */
    showParts(hidden) {
      const shown = picture.parts.filter((_, p) => !hidden.has(p));
      const rows = new Uint32Array(4 * shown.reduce((sum, part) => sum + part.faces, 0));
      let at = 0;
      for (const part of shown) {
        rows.set(picture.faces.subarray(4 * part.first, 4 * (part.first + part.faces)), at);
        at += 4 * part.faces;
      }
      surface.setIndex(new THREE.BufferAttribute(faceTriangles(rows), 1));
      lines.setIndex(new THREE.BufferAttribute(faceEdges(rows, picture.points.length / 3), 1));
    },
    paint() {
      made.lines.material.color.set(styleValue("--mesh-line"));
      made.outline.material.color.set(styleValue("--outline"));
    },
  };
  // Stray points would make the bounds useless, so three.js is not to ask for them.
  for (const object of [faces, made.lines, made.outline]) object.frustumCulled = false;
  made.showParts(new Set());
  made.paint();
  return made;
}

/** The usual length of an edge in the mesh; 0 where there is none. */
function usualEdge(picture) {
  const lengths = [];
  const step = 4 * Math.max(1, Math.floor(picture.faces.length / 4 / 500));
  for (let f = 0; f < picture.faces.length; f += step) {
    const a = 3 * picture.faces[f], b = 3 * picture.faces[f + 1], p = picture.points;
    lengths.push(Math.hypot(p[a] - p[b], p[a + 1] - p[b + 1], p[a + 2] - p[b + 2]));
  }
  lengths.sort((a, b) => a - b);
  return lengths.length === 0 ? 0 : lengths[Math.floor(lengths.length / 2)];
}
