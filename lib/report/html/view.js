// The picture: mesh, outline, markers, camera and the tools above it. Drawn only when something has changed.

/** A box that holds nearly all points of a flat array: stray ones do not count. NaN is left out. */
function boxOf(points, chosen) {
  const box = new THREE.Box3();
  const low = [], high = [];
  for (let axis = 0; axis < 3; ++axis) {
    const values = [];
    for (const i of chosen)
      if (!Number.isNaN(points[3 * i])) values.push(points[3 * i + axis]);
    if (values.length === 0) return box;
    values.sort((a, b) => a - b);
    const margin = Math.floor(values.length / 200);
    low.push(values[margin]);
    high.push(values[values.length - 1 - margin]);
  }
  return box.set(new THREE.Vector3(...low), new THREE.Vector3(...high));
}

/** At most some thousand positions of an array with `length` entries. */
function sampleOf(length) {
  const step = Math.max(1, Math.floor(length / 5000));
  return Array.from({length: Math.ceil(length / step)}, (_, i) => i * step);
}

function withoutPicture(why) {
  byId("view").replaceChildren(element("p", {}, why));
  byId("tools").remove();
  byId("parts").closest(".card").remove();
  return {show() {}, select() {}};
}

function makeView(data, pressed) {
  const {picture} = data;
  const canvas = byId("canvas");
  if (picture.points.length === 0 && picture.outline_points.length === 0 && picture.positions.every(Number.isNaN))
    return withoutPicture("Nothing is known of where the findings are.");
  const context = canvas.getContext("webgl", {antialias: true});
  if (!context)
    return withoutPicture("This browser has no WebGL, so there is no picture. The tables work all the same.");
  const renderer = new THREE.WebGLRenderer({canvas, context});
  // Asking whether each shader is well would wait for it.
  renderer.debug.checkShaderErrors = false;
  const scene = new THREE.Scene();
  const mesh = makeMesh(picture), markers = makeMarkers(data);
  scene.add(mesh.outline, mesh.faces, mesh.lines, ...markers.objects, new THREE.AmbientLight(0xffffff, 0.6));
  const light = new THREE.DirectionalLight(0xffffff, 0.45);
  scene.add(light, light.target);
  let waiting = false, chosen = -1;

  const view = makeCamera(canvas, redraw, (x, y) => {
    const hit = nearest(x, y);
    if (hit >= 0) pressed(hit);
  });

  function redraw() {
    if (waiting) return;
    waiting = true;
    requestAnimationFrame(draw);
  }

  function draw() {
    waiting = false;
    light.position.copy(view.camera.position);
    light.target.position.copy(view.state.target);
    light.target.updateMatrixWorld();
    renderer.render(scene, view.camera);
    canvas.dataset.camera = [...view.camera.position.toArray(), ...view.state.target.toArray()].join(" ");
    moveLabel();
  }

  function onScreen(i) {
    const place = markers.at(i).project(view.camera);
    return {
      x: ((place.x + 1) / 2) * canvas.clientWidth,
      y: ((1 - place.y) / 2) * canvas.clientHeight,
      behind: place.z > 1 || place.z < -1
    };
  }

  function moveLabel() {
    const label = byId("label");
    label.hidden = chosen < 0 || !markers.placed(chosen);
    if (label.hidden) return;
    const {x, y, behind} = onScreen(chosen);
    label.hidden = behind || x < 0 || y < 0 || x > canvas.clientWidth || y > canvas.clientHeight;
    label.style.transform = `translate(${Math.round(x) + 10}px, ${Math.round(y) - 26}px)`;
  }

  function nearest(x, y) {
    let best = -1, least = 100;
    for (const i of markers.shown) {
      const place = onScreen(i);
      const squared = (place.x - x) ** 2 + (place.y - y) ** 2;
      if (place.behind || squared >= least) continue;
      least = squared;
      best = i;
    }
    return best;
  }

  function fit(box) {
    if (box.isEmpty()) return;
    const radius = Math.max(box.getSize(new THREE.Vector3()).length() / 2, 2 * edge, 1e-12);
    view.fly(box.getCenter(new THREE.Vector3()), 3.4 * radius);
  }

  function flyTo(i) {
    if (!markers.placed(i)) return;
    const h = data.findings.contact_distance[i] || 0;
    const distance = Math.max(12 * h, 6 * edge, 20 * (data.findings.penetration[i] || 0)) || whole / 5;
    view.fly(markers.at(i), distance, markers.pointed(i) ? sideways(markers.vector(i)) : null);
  }

  /** From where a vector can be seen from its side, near to where the camera is. */
  function sideways(vector) {
    const now = view.camera.position.clone().sub(view.state.target).normalize();
    const along = vector.clone().normalize();
    const rise = now.dot(along);
    if (Math.abs(rise) > 0.35 && Math.abs(rise) < 0.75) return now;
    const across = now.addScaledVector(along, -rise);
    if (across.length() < 1e-3) across.crossVectors(along, new THREE.Vector3(0.3, 0.9, 0.2));
    return across.normalize().multiplyScalar(0.85).addScaledVector(along, rise < 0 ? -0.5 : 0.5);
  }

  function paint() {
    renderer.setClearColor(new THREE.Color(styleValue("--view")), 1);
    mesh.paint();
    markers.paint();
    redraw();
  }

  function resize() {
    const width = byId("view").clientWidth, height = byId("view").clientHeight;
    renderer.setPixelRatio(Math.min(2, window.devicePixelRatio || 1));
    renderer.setSize(width, height, false);
    view.resize(width, height);
  }

  const modelBox = boxOf(picture.outline_points, sampleOf(picture.outline_points.length / 3));
  const meshBox = boxOf(picture.points, sampleOf(picture.points.length / 3));
  const findingsBox = () => boxOf(picture.positions, markers.shown);
  markers.show(sampleOf(picture.positions.length / 3));
  const first = [modelBox, meshBox, findingsBox()].find((box) => !box.isEmpty()) || new THREE.Box3();
  const whole = first.isEmpty() ? 1 : Math.max(1e-12, first.getSize(new THREE.Vector3()).length());
  const edge = usualEdge(picture) || whole / 50;
  view.setReach(whole);

  makeTools({
    mesh,
    markers,
    redraw,
    fitModel: () => fit(first),
    fitFindings: () => fit(findingsBox()),
    hasMesh: picture.faces.length > 0
  });
  makeParts(picture, mesh, redraw);
  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", paint);
  new ResizeObserver(resize).observe(byId("view"));
  resize();
  paint();
  fit(first);
  sayWhatIsLeftOut(picture);
  return {
    show(list) {
      markers.show(list);
      redraw();
    },
    select(i) {
      chosen = i;
      markers.choose(i);
      const node = idText(data.findings.node[i]), depth = data.findings.penetration[i];
      byId("label").textContent =
          [node && `node ${node}`, depth !== null && depth > 0 && `depth ${short(depth)}`].filter(Boolean).join(", ") ||
          textOf(data, "rule", i);
      flyTo(i);
      redraw();
    },
  };
}

function makeTools({mesh, markers, redraw, fitModel, fitFindings, hasMesh}) {
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
      [1, 2, 5, 10, 20, 50, 100, 1000].map((f) => [f, f === 1 ? "vectors in true scale" : `vectors × ${f}`]));
  factor.addEventListener("change", () => {
    markers.magnify(Number(factor.value));
    redraw();
  });
  const faces = selectOf("Faces", [["1", "faces solid"], ["0.35", "faces transparent"], ["0", "no faces"]]);
  faces.addEventListener("change", () => {
    const opacity = Number(faces.value);
    mesh.faces.visible = opacity > 0;
    mesh.faces.material.opacity = opacity;
    mesh.faces.material.depthWrite = opacity === 1;
    redraw();
  });
  const tools = byId("tools");
  tools.append(button("Model", fitModel), button("Findings", fitFindings), factor);
  if (hasMesh)
    tools.append(
        faces, checkBox("mesh lines", true, visible(mesh.lines)), checkBox("outline", true, visible(mesh.outline)));
  tools.addEventListener("submit", (event) => event.preventDefault());
}

function makeParts(picture, mesh, redraw) {
  const most = 500;
  const hidden = new Set();
  const place = byId("parts");
  if (picture.parts.length === 0) {
    place.previousElementSibling.remove();
    place.remove();
    return;
  }
  picture.parts.slice(0, most).forEach((part, p) => {
    const box = checkBox(` part ${part.id} ${part.title}`, true, (on) => {
      if (on)
        hidden.delete(p);
      else
        hidden.add(p);
      mesh.showParts(hidden);
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
