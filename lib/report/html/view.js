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

/** More findings than that are colours of the mesh; a mesh with more faces than that is an outline while it moves. */
const mostMarkers = 2000, mostMoving = 40000;

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
  const context = canvas.getContext("webgl", {antialias: true, stencil: true});
  if (!context)
    return withoutPicture("This browser has no WebGL, so there is no picture. The tables work all the same.");
  const renderer = new THREE.WebGLRenderer({canvas, context});
  // Asking whether each shader is well would wait for it.
  renderer.debug.checkShaderErrors = false;
  const scene = new THREE.Scene();
  renderer.localClippingEnabled = true;
  const deepest = picture.deepest || 0;
  const look = makeLook(deepest);
  const mesh = makeMesh(picture, look), markers = makeMarkers(data);
  const overlay = makeOverlay(deepest);
  const selection = makeSelection({data, mesh, markers, look, canvas, redraw, looked: () => flyTo(chosen)});
  scene.add(mesh.outline, ...mesh.shapes, ...selection.objects, ...markers.objects);
  scene.add(new THREE.AmbientLight(0xffffff, 0.6));
  const light = new THREE.DirectionalLight(0xffffff, 0.45);
  scene.add(light, light.target);
  let waiting = false, chosen = -1, moving = 0;

  const view = makeCamera(canvas, moved, (x, y) => {
    const hit = nearest(x, y);
    if (hit >= 0) pressed(hit);
  });

  /** A large mesh is only an outline while it turns. */
  function moved(still) {
    clearTimeout(moving);
    moving = !still && picture.faces.length / 4 > mostMoving ? setTimeout(() => {
      moving = 0;
      redraw();
    }, 250) : 0;
    redraw();
  }

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
    mesh.thinLines(edge / view.pixel(canvas.clientHeight));
    mesh.asOutline(moving !== 0, () => renderer.render(scene, view.camera));
    canvas.dataset.drawn = moving !== 0 ? "outline" : "all";
    overlay(view.camera, view.pixel(canvas.clientHeight));
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
    label.style.transform = `translate(${Math.round(x) + 12}px, ${Math.round(y) - 64}px)`;
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

  function fit(box, direction = null) {
    if (box.isEmpty()) return;
    const radius = Math.max(box.getSize(new THREE.Vector3()).length() / 2, 2 * edge, 1e-12);
    view.fly(box.getCenter(new THREE.Vector3()), 3.4 * radius, direction);
  }

  /** All of it, from above. */
  function overview(box) {
    selection.leave();
    fit(box, new THREE.Vector3(0.53, -0.67, 0.52));
  }

  function flyTo(i) {
    if (!markers.placed(i)) {
      fit(first);
      return;
    }
    const direction = selection.direction() || (markers.pointed(i) ? sideways(markers.vector(i)) : null);
    view.fly(markers.at(i), selection.distance(i) || whole / 5, direction);
  }

  /** From where a vector can be seen from its side, near to where the camera is. */
  function sideways(vector) {
    const now = view.camera.position.clone().sub(view.state.target).normalize();
    const along = vector.clone().normalize();
    const rise = now.dot(along);
    if (Math.abs(rise) > 0.35 && Math.abs(rise) < 0.75) return now;
    return across(along, now).multiplyScalar(0.85).addScaledVector(along, rise < 0 ? -0.5 : 0.5);
  }

  function paint() {
    renderer.setClearColor(new THREE.Color(styleValue("--view")), 1);
    look.back.value.set(styleValue("--view"));
    for (const painted of [mesh, markers, selection]) painted.paint();
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
  selection.setEdge(edge);
  view.setReach(whole);

  makeTools({
    mesh,
    markers,
    selection,
    redraw,
    fitModel: () => overview(first),
    fitFindings: () => overview(findingsBox()),
    hasMesh: picture.faces.length > 0,
    hasMoves: picture.moved_points.length > 0
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
      mesh.showDepths(pointDepths(data, list));
      const inField = list.length > mostMarkers ? (i) => hasPointDepth(data, i) : () => false;
      markers.show(list, list.filter((i) => !inField(i)));
      canvas.dataset.markers = String(markers.drawn);
      redraw();
    },
    select(i) {
      chosen = i;
      markers.choose(i);
      selection.select(i);
      const node = idText(data.findings.node[i]), depth = data.findings.penetration[i];
      byId("label").textContent =
          [node && `node ${node}`, depth !== null && depth > 0 && `depth ${short(depth)}`].filter(Boolean).join(", ") ||
          textOf(data, "rule", i);
      flyTo(i);
      redraw();
    },
  };
}
