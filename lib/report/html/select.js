// The selected finding: what is highlighted, coated, faded and cut, and from where it is looked at.

function makeSelection({data, mesh, markers, look, canvas, redraw, looked}) {
  const {picture} = data;
  const focus = makeFocus(data, partsOfFaces(picture)), coats = makeCoats(picture);
  const cut = makeCut((turned) => {
    near = chosen >= 0;
    apply();
    if (turned) looked();
  });
  let usual = 0, chosen = -1, fades = true, isolated = false;
  let near = false;  // the selected finding is looked at, not the whole
  const h = (i) => data.findings.contact_distance[i] || 0;
  // A node on the segment itself has a depth, but no vector.
  const deep = (i) => data.findings.penetration[i] > 0;

  /** The length of an edge at the finding. */
  function edgeHere() {
    const lists = focus.rows ? [focus.rows.segment, focus.rows.tracked, focus.rows.element] : [];
    const row = lists.find((list) => list.length > 0);
    return (row && pointOf(picture, row[0]).distanceTo(pointOf(picture, row[1]))) || usual;
  }

  /** How far around the finding is worth seeing. */
  function reachOf(i) {
    return markers.placed(i) ? Math.max(3 * edgeHere(), 4 * h(i)) : 0;
  }

  function apply() {
    const plane = near ? cut.plane : null, planes = plane ? [plane] : [];
    for (const shape of mesh.shapes) shape.material.clippingPlanes = planes;
    focus.clip(planes);
    canvas.dataset.cut = String(coats.cut(plane));
    look.reach.value = fades && near ? reachOf(chosen) : 0;
    const parts = chosen < 0 ? [] : [data.findings.part[chosen], data.findings.element_part[chosen]];
    mesh.isolate(isolated && parts.some((id) => id !== 0) ? parts : null);
    canvas.dataset.faces = String(mesh.shownFaces);
    redraw();
  }

  function select(i) {
    chosen = i;
    near = true;
    const rows = focus.select(i), placed = markers.placed(i);
    const place = placed ? markers.at(i) : new THREE.Vector3();
    look.place.value.copy(place);
    const coated = placed ? coats.show(place, reachOf(i), rows) : [0, 0];
    canvas.dataset.coats = coated.join(" ");
    canvas.dataset.marked = [rows.segment, rows.element, rows.tracked].map((list) => list.length / 4).join(" ");
    const inMesh = placed && rows.tracked.length + rows.element.length > 0;
    cut.put(place, inMesh ? frameOf(data, markers, i, rows) : null, reachOf(i) / 2, deep(i));
    byId("legend").classList.toggle("plain", !inMesh);
    apply();
  }

  const option = (text, on, change) => checkBox(text, on, (now) => {
    change(now);
    apply();
  });
  return {
    objects: [...focus.objects, ...coats.objects],
    select,
    controls: [
      ...cut.controls,
      option("contact thickness", true, (on) => coats.visible(on)),
      option("fade rest", true, (on) => {
        fades = on;
      }),
      option("its parts only", false, (on) => {
        isolated = on;
      }),
    ],
    /** What is highlighted and coated follows the points. */
    again() {
      const [was, before] = [chosen, near];
      if (was < 0) return;
      select(was);
      near = before;
      apply();
    },
    /** Nothing fades or is cut until a finding is selected again. */
    leave() {
      near = false;
      apply();
    },
    setEdge(length) {
      usual = length;
    },
    /** How near the camera comes: a tenth of the contact distance is to be visible. */
    distance(i) {
      const edge = edgeHere();
      if (!(h(i) > 0) || !deep(i)) return 6 * edge;
      return Math.max(16 * h(i), 12 * (data.findings.penetration[i] || 0), 0.5 * edge);
    },
    /** Onto the cut, a little from above and from the side; without a cut onto the face. null: any is as good. */
    direction() {
      if (!cut.normal) return null;
      if (!cut.plane) return cut.frame.out.clone().addScaledVector(cut.normal, 0.7).normalize();
      const above = cut.frame.out.clone().multiplyScalar(cut.frame.out.z < -0.1 ? -1 : 1);
      const aside = cut.normal.clone().cross(above);
      return cut.normal.clone().addScaledVector(above, 0.3).addScaledVector(aside, 0.2).normalize();
    },
    paint() {
      focus.paint();
      coats.paint();
    },
  };
}
