// Findings in the picture: a point where the node is, and a line from there to the contact surface, in true length and,
// beside that, magnified.

/** A round spot for points. */
function spot() {
  const canvas = element("canvas", {width: 32, height: 32});
  const pen = canvas.getContext("2d");
  pen.fillStyle = "#fff";
  pen.arc(16, 16, 14, 0, 2 * Math.PI);
  pen.fill();
  return new THREE.CanvasTexture(canvas);
}

function makeMarkers(data) {
  const {positions, vectors} = data.picture;
  const count = positions.length / 3;
  const colors = new Uint8Array(3 * count), lineColors = new Uint8Array(6 * count);
  const ends = new Float32Array(6 * count), farEnds = new Float32Array(6 * count);
  const geometry = (place, color) => {
    const made = new THREE.BufferGeometry();
    made.setAttribute("position", new THREE.BufferAttribute(place, 3));
    made.setAttribute("color", new THREE.BufferAttribute(color, 3, true));
    return made;
  };
  // NaN, where nothing is known, may not reach the graphics card.
  const points = geometry(positions.map((value) => (Number.isNaN(value) ? 0 : value)), colors);
  const lines = geometry(ends, lineColors), farLines = geometry(farEnds, lineColors);
  const texture = spot();
  const dots = (options) => new THREE.Points(points, new THREE.PointsMaterial({
    vertexColors: THREE.VertexColors,
    map: texture,
    alphaTest: 0.5,
    sizeAttenuation: false,
    size: 7,
    transparent: true,
    ...options,
  }));
  const strokes = (of, options) => new THREE.LineSegments(
      of, new THREE.LineBasicMaterial({vertexColors: THREE.VertexColors, transparent: true, ...options}));
  // What lies behind the mesh shines through.
  const objects = [
    dots({depthTest: false, opacity: 0.35, alphaTest: 0.1}),
    dots({}),
    strokes(lines, {depthTest: false}),
    strokes(farLines, {depthTest: false, opacity: 0.6}),
  ];
  const chosenPoint = new THREE.BufferGeometry();
  chosenPoint.setAttribute("position", new THREE.BufferAttribute(new Float32Array(3), 3));
  const chosen = new THREE.Points(
      chosenPoint,
      new THREE.PointsMaterial(
          {map: texture, alphaTest: 0.5, sizeAttenuation: false, size: 10, depthTest: false, transparent: true}));
  chosen.visible = false;
  chosen.renderOrder = 6;
  objects.forEach((object) => {
    object.renderOrder = 5;
    object.frustumCulled = false;
  });
  chosen.frustumCulled = false;

  const placed = (i) => !Number.isNaN(positions[3 * i]);
  const pointed = (i) => placed(i) && !Number.isNaN(vectors[3 * i]);
  const made = {
    objects: [...objects, chosen],
    placed,
    pointed,
    shown: [],
    at: (i) => new THREE.Vector3().fromArray(positions, 3 * i),
    vector: (i) => new THREE.Vector3().fromArray(vectors, 3 * i),
    drawn: 0,
    /** Findings that can be pressed, and those of them that are drawn. */
    show(list, drawn = list) {
      made.shown = list.filter(placed);
      const dots = drawn.filter(placed);
      made.drawn = dots.length;
      points.setIndex(new THREE.BufferAttribute(new Uint32Array(dots), 1));
      const pairs =
          new THREE.BufferAttribute(new Uint32Array(dots.filter(pointed).flatMap((i) => [2 * i, 2 * i + 1])), 1);
      lines.setIndex(pairs);
      farLines.setIndex(pairs);
    },
    magnify(factor) {
      for (let i = 0; i < count; ++i) {
        if (!pointed(i)) continue;
        for (let axis = 0; axis < 3; ++axis) {
          const from = positions[3 * i + axis], along = vectors[3 * i + axis];
          ends[6 * i + axis] = from;
          ends[6 * i + 3 + axis] = from + along;
          farEnds[6 * i + axis] = from + along;
          farEnds[6 * i + 3 + axis] = from + factor * along;
        }
      }
      for (const of of [lines, farLines]) of.attributes.position.needsUpdate = true;
      objects[3].visible = factor !== 1;
    },
    choose(i) {
      chosen.visible = i >= 0 && placed(i);
      if (!chosen.visible) return;
      made.at(i).toArray(chosenPoint.attributes.position.array);
      chosenPoint.attributes.position.needsUpdate = true;
    },
    paint() {
      const shades =
          severities.map((name) => new THREE.Color(styleValue(`--${name}`)).toArray().map((value) => 255 * value));
      for (let i = 0; i < count; ++i) {
        const shade = shades[data.findings.severity[i]];
        colors.set(shade, 3 * i);
        lineColors.set([...shade, ...shade], 6 * i);
      }
      for (const of of [points, lines, farLines]) of.attributes.color.needsUpdate = true;
      chosen.material.color.set(styleValue("--accent"));
    },
  };
  made.paint();
  made.magnify(1);
  return made;
}
