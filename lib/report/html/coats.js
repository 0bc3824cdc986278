// Shells with their contact thickness around the selected finding: two coats, one for the side of the node and one for
// the side of the segment, half the thickness away from the mid-surface to both sides; and a cut through them.

const mostCoated = 1500;  // faces

/** Faces with a thickness near a place, the nearest first. */
function facesNear(picture, place, reach) {
  const {points, faces, thickness} = picture;
  const near = [];
  for (let f = 0; 4 * f < faces.length; ++f) {
    if (thickness[f] === 0) continue;
    let least = Infinity;
    for (let c = 0; c < 4; ++c) {
      const p = 3 * faces[4 * f + c];
      least = Math.min(least, Math.hypot(points[p] - place.x, points[p + 1] - place.y, points[p + 2] - place.z));
    }
    if (least < reach) near.push([least, f]);
  }
  near.sort((a, b) => a[0] - b[0]);
  return near.slice(0, mostCoated).map((entry) => entry[1]);
}

/** Which of the faces are on the side of the node (true): those with fewer elements to it than to the segment. */
function sidesOf(picture, near, tracked, segment) {
  const {faces} = picture;
  const ofPoint = new Map(), side = new Map();
  for (const f of near)
    for (const point of faces.subarray(4 * f, 4 * f + 4))
      if (ofPoint.has(point)) ofPoint.get(point).push(f);
      else ofPoint.set(point, [f]);
  let front = [...new Set(tracked)].map((point) => [point, true]);
  front.push(...[...new Set(segment)].map((point) => [point, false]));
  while (front.length > 0) {
    const next = [];
    for (const [point, ofNode] of front)
      for (const f of ofPoint.get(point) || []) {
        if (side.has(f)) continue;
        side.set(f, ofNode);
        for (const corner of faces.subarray(4 * f, 4 * f + 4)) next.push([corner, ofNode]);
      }
    front = next;
  }
  return side;
}

function pointOf(picture, point) {
  return new THREE.Vector3().fromArray(picture.points, 3 * point);
}

function faceNormal(picture, f) {
  const [a, b, c, d] = Array.from(picture.faces.subarray(4 * f, 4 * f + 4), (point) => pointOf(picture, point));
  return c.sub(a).cross(d.sub(b)).normalize();
}

/** The mean normal at each point of some faces; neighbours may be numbered in either direction. */
function meanNormals(picture, near) {
  const normals = new Map();
  for (const f of near) {
    const normal = faceNormal(picture, f);
    for (const point of new Set(picture.faces.subarray(4 * f, 4 * f + 4))) {
      const sum = normals.get(point);
      if (sum) sum.addScaledVector(normal, sum.dot(normal) < 0 ? -1 : 1);
      else normals.set(point, normal.clone());
    }
  }
  for (const normal of normals.values()) normal.normalize();
  return normals;
}

/** The prisms of a coat: three points above and three below for each triangle of a face; beams as four-sided bars. */
function prismsOf(picture, f, normals) {
  const row = Array.from(picture.faces.subarray(4 * f, 4 * f + 4)), half = picture.thickness[f] / 2;
  if (row[0] === row[1]) return [];
  if (row[1] === row[2]) return barOf(pointOf(picture, row[0]), pointOf(picture, row[1]), half);
  const normal = faceNormal(picture, f);
  const offset = (point, sign) => {
    const mean = normals.get(point);
    return pointOf(picture, point).addScaledVector(mean, sign * half * (mean.dot(normal) < 0 ? -1 : 1));
  };
  const triangles = row[2] === row[3] ? [row.slice(0, 3)] : [row.slice(0, 3), [row[0], row[2], row[3]]];
  return triangles.map((corners) => [1, -1].flatMap((sign) => corners.map((point) => offset(point, sign))));
}

function barOf(a, b, half) {
  const along = b.clone().sub(a).normalize();
  const aside = Math.abs(along.x) < 0.8 ? new THREE.Vector3(1, 0, 0) : new THREE.Vector3(0, 0, 1);
  const x = aside.cross(along).normalize();
  const y = along.clone().cross(x);
  const ring = (end) => [[x, 1], [y, 1], [x, -1], [y, -1]].map(([v, s]) => end.clone().addScaledVector(v, s * half));
  const first = ring(a), last = ring(b);
  return [[0, 1, 2], [0, 2, 3]].map((corners) => [...corners.map((c) => first[c]), ...corners.map((c) => last[c])]);
}

/** Where a plane cuts a tetrahedron, as triangles: points are added to `out`. */
function cutTetrahedron(corners, heights, out) {
  const above = [], below = [];
  heights.forEach((height, c) => (height >= 0 ? above : below).push(c));
  const between = (a, b) => corners[a].clone().lerp(corners[b], heights[a] / (heights[a] - heights[b]));
  if (above.length === 1 || above.length === 3) {
    const [single, others] = above.length === 1 ? [above[0], below] : [below[0], above];
    out.push(...others.map((other) => between(single, other)));
  } else if (above.length === 2) {
    const [a, b] = above, [c, d] = below;
    const ring = [between(a, c), between(a, d), between(b, d), between(b, c)];
    out.push(ring[0], ring[1], ring[2], ring[0], ring[2], ring[3]);
  }
}

/** The three tetrahedra of a prism, and the triangles of its surface. */
const prismTetrahedra = [[0, 1, 2, 3], [1, 2, 3, 4], [2, 3, 4, 5]];
const prismSurface = [0, 1, 2, 3, 5, 4, 0, 3, 4, 0, 4, 1, 1, 4, 5, 1, 5, 2, 2, 5, 3, 2, 3, 0];

/** The surface of some prisms without the faces that two of them share. */
function prismTriangles(prisms) {
  const seen = new Map();
  const key = (points) => points.map((p) => p.toArray().map((x) => Math.fround(x)).join()).sort().join(" ");
  const triangles = [];
  for (const prism of prisms) {
    for (let t = 0; t < prismSurface.length; t += 3) {
      const points = prismSurface.slice(t, t + 3).map((corner) => prism[corner]);
      if (t < 6) {
        triangles.push(points);
        continue;
      }
      // Two triangles make a wall, whose diagonal may differ between neighbours: the wall is known by its four corners.
      const at = 6 + 6 * Math.floor((t - 6) / 6);
      const wall = key([...new Set(prismSurface.slice(at, at + 6))].map((corner) => prism[corner]));
      if (!seen.has(wall)) seen.set(wall, []);
      seen.get(wall).push(points);
    }
  }
  for (const wall of seen.values())
    if (wall.length === 2) triangles.push(...wall);
  return triangles.flat();
}

function coatShape(opacity, order, more) {
  const paint = {transparent: true, opacity, side: THREE.DoubleSide, depthWrite: false, ...more};
  const mesh = new THREE.Mesh(new THREE.BufferGeometry(), new THREE.MeshBasicMaterial(paint));
  mesh.frustumCulled = false;
  mesh.renderOrder = order;
  return mesh;
}

/** The coat of one side and its section; `stencil` are properties of the section's material. */
function makeCoat(name, order, stencil) {
  const coat = coatShape(0.18, 3, {}), section = coatShape(0.8, order, {depthTest: false, ...stencil});
  const fill = (mesh, points) => {
    const values = new Float32Array(3 * points.length);
    points.forEach((point, i) => point.toArray(values, 3 * i));
    mesh.geometry.setAttribute("position", new THREE.BufferAttribute(values, 3));
    mesh.visible = points.length > 0;
  };
  const made = {
    objects: [coat, section],
    section,
    prisms: [],
    show(prisms) {
      made.prisms = prisms;
      fill(coat, prismTriangles(prisms));
    },
    /** Draws the cut at a plane; none without one. Returns the number of its triangles. */
    cut(plane) {
      const points = [];
      if (plane)
        for (const prism of made.prisms)
          for (const corners of prismTetrahedra)
            cutTetrahedron(corners.map((c) => prism[c]), corners.map((c) => plane.distanceToPoint(prism[c])), points);
      fill(section, points);
      coat.material.clippingPlanes = plane ? [plane] : [];
      return points.length / 3;
    },
    paint() {
      for (const mesh of [coat, section]) mesh.material.color.set(styleValue(name));
    },
  };
  fill(coat, []);
  fill(section, []);
  return made;
}

function makeCoats(picture) {
  // What the sections have in common is painted over: the section of one side where the other one has left its mark.
  const stencil = {stencilWrite: true, stencilRef: 1};
  const mark = {...stencil, stencilFunc: THREE.AlwaysStencilFunc, stencilZPass: THREE.ReplaceStencilOp};
  const marked = {...stencil, stencilFunc: THREE.EqualStencilFunc, stencilZPass: THREE.KeepStencilOp};
  const tracked = makeCoat("--tracked", 4, mark), segment = makeCoat("--segment", 4, {});
  const overlap = coatShape(1, 5, {depthTest: false, ...marked});
  return {
    objects: [...tracked.objects, ...segment.objects, overlap],
    /** Coats around a place; `rows` as rowsOfFinding() gives them. Returns the number of coated faces of each side. */
    show(place, reach, rows) {
      const near = facesNear(picture, place, reach);
      const other = rows.segment.length > 0 ? rows.segment : rows.element;
      const side = sidesOf(picture, near, rows.tracked, other);
      const normals = meanNormals(picture, near);
      const of = (ofNode) => near.filter((f) => side.get(f) === ofNode);
      tracked.show(of(true).flatMap((f) => prismsOf(picture, f, normals)));
      segment.show(of(false).flatMap((f) => prismsOf(picture, f, normals)));
      return [of(true).length, of(false).length];
    },
    cut(plane) {
      const triangles = tracked.cut(plane) + segment.cut(plane);
      overlap.geometry = segment.section.geometry;
      overlap.visible = segment.section.visible && tracked.section.visible;
      return triangles;
    },
    paint() {
      overlap.material.color.set(styleValue("--overlap"));
      tracked.paint();
      segment.paint();
    },
    visible(on) {
      tracked.objects[0].material.visible = segment.objects[0].material.visible = on;
    },
  };
}
