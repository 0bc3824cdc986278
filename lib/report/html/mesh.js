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

/** Corners of the rows that are particles or, with `ends` of 2, beams. */
function thinRows(faces, ends) {
  const corners = [];
  for (let f = 0; f < faces.length; f += 4) {
    const kind = faces[f + 1] !== faces[f + 2] ? 4 : faces[f] !== faces[f + 1] ? 2 : 1;
    if (kind === ends) for (let i = 0; i < ends; ++i) corners.push(faces[f + i]);
  }
  return new Uint32Array(corners);
}

/** Puts the points that move at a share of their way: 0 before, 1 after, more than 1 exaggerates. */
function makeMover(picture) {
  const from = new Float32Array(picture.moved_to.length);
  picture.moved_points.forEach((point, i) => from.set(picture.points.subarray(3 * point, 3 * point + 3), 3 * i));
  return (share) => picture.moved_points.forEach((point, i) => {
    for (let axis = 0; axis < 3; ++axis) {
      const at = 3 * i + axis;
      picture.points[3 * point + axis] = from[at] + share * (picture.moved_to[at] - from[at]);
    }
  });
}

function makeMesh(picture, look) {
  const points = new THREE.BufferAttribute(picture.points, 3);
  const colors = new Uint8Array(picture.points.length);
  picture.parts.forEach((part, p) => {
    const color = partColor(p).toArray().map((value) => Math.round(255 * value));
    for (const point of picture.faces.subarray(4 * part.first, 4 * (part.first + part.faces)))
      colors.set(color, 3 * point);
  });
  const surface = new THREE.BufferGeometry(), lines = new THREE.BufferGeometry(), outline = new THREE.BufferGeometry();
  const beams = new THREE.BufferGeometry(), particles = new THREE.BufferGeometry();
  const depths = new THREE.BufferAttribute(new Float32Array(picture.points.length / 3), 1);
  for (const geometry of [surface, beams, particles]) {
    geometry.setAttribute("position", points);
    geometry.setAttribute("color", new THREE.BufferAttribute(colors, 3, true));
    geometry.setAttribute("depth", depths);
  }
  lines.setAttribute("position", points);
  outline.setAttribute("position", new THREE.BufferAttribute(picture.outline_points, 3));
  outline.setIndex(new THREE.BufferAttribute(picture.outline, 1));
  const faces = new THREE.Mesh(surface, useLook(new THREE.MeshPhongMaterial({
    vertexColors: THREE.VertexColors,
    flatShading: true,
    side: THREE.DoubleSide,
    shininess: 0,
    transparent: true,
    opacity: 1,
    polygonOffset: true,
    polygonOffsetFactor: 1,
    polygonOffsetUnits: 1,
  }), look, true));
  const thin = {vertexColors: THREE.VertexColors};
  const move = makeMover(picture);
  const made = {
    faces,
    moveTo(share) {
      move(share);
      points.needsUpdate = true;
    },
    lines: new THREE.LineSegments(
        lines, useLook(new THREE.LineBasicMaterial({transparent: true, opacity: 0.5}), look, false)),
    beams: new THREE.LineSegments(beams, useLook(new THREE.LineBasicMaterial(thin), look, true)),
    particles: new THREE.Points(
        particles, useLook(new THREE.PointsMaterial({...thin, sizeAttenuation: false, size: 4}), look, true)),
    outline: new THREE.LineSegments(outline, new THREE.LineBasicMaterial({transparent: true, opacity: 0.7})),
    showDepths(values) {
      depths.array.set(values);
      depths.needsUpdate = true;
    },
    hidden: new Set(),  // positions of parts
    only: null,         // ids of the parts that are shown alone; null: all
    shownFaces: 0,
    /** Hides a part, or shows it again. */
    hide(p, on) {
      if (on) made.hidden.add(p);
      else made.hidden.delete(p);
      made.update();
    },
    /** Shows parts with these ids alone; null: all. */
    isolate(ids) {
      if (String(ids) === String(made.only)) return;
      made.only = ids;
      made.update();
    },
    update() {
      const shown =
          picture.parts.filter((part, p) => !made.hidden.has(p) && (made.only === null || made.only.includes(part.id)));
      made.shownFaces = shown.reduce((sum, part) => sum + part.faces, 0);
      const rows = new Uint32Array(4 * made.shownFaces);
      let at = 0;
      for (const part of shown) {
        rows.set(picture.faces.subarray(4 * part.first, 4 * (part.first + part.faces)), at);
        at += 4 * part.faces;
      }
      surface.setIndex(new THREE.BufferAttribute(faceTriangles(rows), 1));
      lines.setIndex(new THREE.BufferAttribute(faceEdges(rows, picture.points.length / 3), 1));
      beams.setIndex(new THREE.BufferAttribute(thinRows(rows, 2), 1));
      particles.setIndex(new THREE.BufferAttribute(thinRows(rows, 1), 1));
    },
    /** Lines of elements with few pixels would hide the faces. */
    thinLines(pixels) {
      made.lines.material.opacity = 0.5 * Math.min(1, Math.max(0.04, (pixels - 3) / 12));
    },
    /** Calls `draw` with everything that is on, or for `plain` with the outline instead of faces and mesh lines. */
    asOutline(plain, draw) {
      const before = [faces, made.lines, made.outline].map((object) => object.visible);
      if (plain) [faces.visible, made.lines.visible, made.outline.visible] = [false, false, true];
      if (made.only !== null) made.outline.visible = false;
      draw();
      [faces.visible, made.lines.visible, made.outline.visible] = before;
    },
    paint() {
      made.lines.material.color.set(styleValue("--mesh-line"));
      made.outline.material.color.set(styleValue("--outline"));
    },
  };
  // Stray points would make the bounds useless, so three.js is not to ask for them.
  for (const object of [faces, made.lines, made.beams, made.particles, made.outline]) object.frustumCulled = false;
  made.shapes = [faces, made.lines, made.beams, made.particles];
  made.update();
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
