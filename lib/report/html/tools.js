// The tools above the picture, the list of its parts, and what it does not show.

function makeTools({mesh, markers, selection, redraw, fitModel, fitFindings, hasMesh, hasMoves}) {
  const button = (text, act) => {
    const made = element("button", {type: "button"}, text);
    made.addEventListener("click", act);
    return made;
  };
  const visible = (object) => (on) => {
    object.visible = on;
    redraw();
  };
  const factor = selectOf(
      "Length of the vectors",
      [1, 2, 5, 10, 20, 50, 100, 1000].map((f) => [f, f === 1 ? "vectors × 1" : `vectors × ${f}`]));
  factor.addEventListener("change", () => {
    markers.magnify(Number(factor.value));
    redraw();
  });
  const faces = selectOf("Faces", [["1", "faces"], ["0.35", "faces transparent"], ["0", "no faces"]]);
  faces.addEventListener("change", () => {
    const opacity = Number(faces.value);
    mesh.faces.visible = opacity > 0;
    mesh.faces.material.opacity = opacity;
    mesh.faces.material.depthWrite = opacity === 1;
    redraw();
  });
  const nodes = selectOf("Nodes", [["0", "before"], ...[1, 2, 5, 10, 50, 100].map((f) => [f, f === 1 ? "after" : `after, moves × ${f}`])]);
  nodes.addEventListener("change", () => {
    mesh.moveTo(Number(nodes.value));
    selection.again();
    redraw();
  });
  const tools = byId("tools");
  if (hasMoves) tools.append(nodes);
  tools.append(button("Model", fitModel), button("Findings", fitFindings), factor);
  if (hasMesh)
    tools.append(
        faces, checkBox("mesh", true, visible(mesh.lines)), checkBox("outline", true, visible(mesh.outline)),
        ...selection.controls);
  tools.addEventListener("submit", (event) => event.preventDefault());
}

function makeParts(picture, mesh, redraw) {
  const most = 500;
  const place = byId("parts");
  if (picture.parts.length === 0) {
    place.previousElementSibling.remove();
    place.remove();
    return;
  }
  picture.parts.slice(0, most).forEach((part, p) => {
    const box = checkBox(` part ${part.id} ${part.title}`, true, (on) => {
      mesh.hide(p, !on);
      redraw();
    });
    const swatch = element("span", {class: "swatch"});
    swatch.style.background = `#${partColor(p).getHexString()}`;
    box.insertBefore(swatch, box.childNodes[1]);
    place.append(box);
  });
  if (picture.parts.length > most)
    place.append(element("p", {class: "note"}, `${counted(picture.parts.length - most, "further part")} not listed.`));
}

function sayWhatIsLeftOut(picture) {
  const words = [];
  if (picture.model_faces > 0)
    words.push(`${(picture.faces.length / 4).toLocaleString("en")} of ${
        counted(picture.model_faces, "face")} of the model: those around the findings, and an outline of the rest.`);
  else
    words.push("No mesh is known: nodes and vectors only.");
  if (picture.faces_cut)
    words.push("There are more findings than the page can show the mesh around; the deepest come first.");
  if (picture.outline_left_out > 0)
    words.push(`${counted(picture.outline_left_out, "edge")} far away from the rest not drawn.`);
  words.push("Drag to turn, Shift to shift, wheel to zoom; press a node to see its finding.");
  byId("view-note").textContent = words.join(" ");
}
