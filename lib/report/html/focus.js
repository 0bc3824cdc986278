// The selected finding in the mesh: its segment, the element of the segment, and the elements around its node.

/** Rows of faces (four points each) with what `wanted` says yes to. */
function rowsWhere(picture, wanted) {
  const rows = [];
  for (let f = 0; 4 * f < picture.faces.length; ++f)
    if (wanted(f)) rows.push(...picture.faces.subarray(4 * f, 4 * f + 4));
  return new Uint32Array(rows);
}

/** The position in picture.parts of each face's part. */
function partsOfFaces(picture) {
  const parts = new Uint32Array(picture.faces.length / 4);
  picture.parts.forEach((part, p) => parts.fill(p, part.first, part.first + part.faces));
  return parts;
}

/** What of the mesh belongs to a finding, as rows of faces; without elements of either side empty ones. */
function rowsOfFinding(data, partOf, i) {
  const {picture, findings} = data;
  const point = picture.node_points[i], element = Number(findings.element[i]);
  const corners = picture.corners.subarray(4 * i, 4 * i + 4);
  const segment = corners.length === 4 && !corners.includes(nowhere) ? corners.slice() : new Uint32Array();
  const ofElement = (f) => element > 0 && picture.elements[f] === element &&
      (findings.element_part[i] === 0 || picture.parts[partOf[f]].id === findings.element_part[i]);
  const ofNode = (f) => picture.faces.subarray(4 * f, 4 * f + 4).includes(point);
  return {
    segment,
    element: rowsWhere(picture, ofElement),
    tracked: point === undefined || point === nowhere ? new Uint32Array() : rowsWhere(picture, ofNode),
  };
}

/** A filled shape and its edges, both of points of the mesh. */
function makeMarked(points, name, opacity) {
  const fill = new THREE.BufferGeometry(), edges = new THREE.BufferGeometry();
  for (const geometry of [fill, edges]) geometry.setAttribute("position", points);
  const paint = {transparent: true, opacity, side: THREE.DoubleSide, depthWrite: false};
  const nearer = {polygonOffset: true, polygonOffsetFactor: -1, polygonOffsetUnits: -1};
  const faces = new THREE.Mesh(fill, new THREE.MeshBasicMaterial({...paint, ...nearer}));
  const lines = new THREE.LineSegments(edges, new THREE.LineBasicMaterial({depthTest: false, transparent: true}));
  for (const object of [faces, lines]) object.frustumCulled = false;
  faces.renderOrder = 1;
  lines.renderOrder = 2;
  return {
    objects: [faces, lines],
    show(rows) {
      faces.visible = lines.visible = rows.length > 0;
      fill.setIndex(new THREE.BufferAttribute(faceTriangles(rows), 1));
      edges.setIndex(new THREE.BufferAttribute(faceEdges(rows, points.count), 1));
    },
    paint() {
      for (const object of [faces, lines]) object.material.color.set(styleValue(name));
    },
    clip(planes) {
      for (const object of [faces, lines]) object.material.clippingPlanes = planes;
    },
  };
}

function makeFocus(data, partOf) {
  const points = new THREE.BufferAttribute(data.picture.points, 3);
  const marked = {
    element: makeMarked(points, "--segment", 0.25),
    segment: makeMarked(points, "--segment", 0.4),
    tracked: makeMarked(points, "--tracked", 0.25),
  };
  const all = Object.values(marked);
  const made = {
    objects: all.flatMap((shape) => shape.objects),
    rows: null,
    select(i) {
      made.rows = rowsOfFinding(data, partOf, i);
      for (const [name, shape] of Object.entries(marked)) shape.show(made.rows[name]);
      return made.rows;
    },
    paint: () => all.forEach((shape) => shape.paint()),
    clip: (planes) => all.forEach((shape) => shape.clip(planes)),
  };
  for (const shape of all) shape.show(new Uint32Array());
  return made;
}
