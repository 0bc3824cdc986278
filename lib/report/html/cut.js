// The plane that cuts the mesh at the selected finding: what is in front of it is not drawn.

/** A unit vector across `along`, near to `wished`. */
function across(along, wished) {
  const made = wished.clone().addScaledVector(along, -wished.dot(along));
  if (made.length() < 1e-3) made.crossVectors(along, new THREE.Vector3(0.3, 0.9, 0.2));
  return made.normalize();
}

/** The way out of a finding, and a direction across it: an edge of its segment; without a vector the normal of it. */
function frameOf(data, markers, i, rows) {
  const {picture} = data;
  const first = rows.segment.length > 0 ? rows.segment : rows.element.length > 0 ? rows.element : rows.tracked;
  const corners = Array.from(first.subarray(0, 4), (point) => pointOf(picture, point));
  const edge = corners.length === 4 ? corners[1].clone().sub(corners[0]) : new THREE.Vector3(1, 0, 0);
  const normal = new THREE.Vector3();
  if (corners.length === 4) normal.crossVectors(corners[2].sub(corners[0]), corners[3].sub(corners[1])).normalize();
  const out = markers.pointed(i) ? markers.vector(i) : new THREE.Vector3();
  if (!(out.length() > 0)) out.copy(normal);
  if (!(out.length() > 0)) out.set(0, 0, 1);
  out.normalize();
  // At an edge the way out leaves the segment sideways: the cut is to show both directions.
  const both = out.clone().cross(normal);
  return {out, edge: both.length() > 0.3 ? both.normalize() : across(out, edge)};
}

/** The cut with its controls; `changed` is called when the reader turns or moves it. */
function makeCut(changed) {
  const kind = selectOf("Cut", [["across", "cut across"], ["along", "cut along"], ["", "no cut"]]);
  const slide = element("input", {type: "range", min: -1, max: 1, step: 0.01, value: 0});
  slide.setAttribute("aria-label", "Place of the cut");
  const made = {
    controls: [kind, slide],
    plane: null,   // keeps what is behind it; null: there is none
    normal: null,  // towards the reader
    frame: null,
    wished: null,  // the reader's choice; null: none yet, and what has no depth is not cut
    /** At a finding: its place, its frame, how far the slider moves the plane, and whether there is a depth to see. */
    put(place, frame, reach, deep) {
      kind.value = made.wished ?? (deep ? "across" : "");
      made.frame = frame && {...frame, place, reach};
      slide.value = "0";
      made.update();
    },
    update() {
      slide.disabled = kind.value === "" || !made.frame;
      made.plane = made.normal = null;
      if (!made.frame) return;
      const {place, out, edge, reach} = made.frame;
      made.normal = kind.value === "along" ? edge.clone().cross(out) : edge.clone();
      if (kind.value === "") return;
      // A little towards the reader: faces in the plane itself would come and go, pixel by pixel.
      const at = place.clone().addScaledVector(made.normal, (Number(slide.value) + 0.002) * reach);
      made.plane = new THREE.Plane().setFromNormalAndCoplanarPoint(made.normal.clone().negate(), at);
    },
  };
  kind.addEventListener("change", () => {
    made.wished = kind.value;
    made.update();
    changed(true);
  });
  slide.addEventListener("input", () => {
    made.update();
    changed(false);
  });
  return made;
}
