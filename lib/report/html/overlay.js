// What lies over the picture: axes, scale bar, and the legend of colours.

/** 1, 2 or 5 times a power of ten, at most `length`. */
function roundLength(length) {
  const power = 10 ** Math.floor(Math.log10(length));
  return [5, 2, 1].find((factor) => factor * power <= length) * power;
}

function makeAxes(place) {
  const size = 64, middle = size / 2, long = 22;
  const svg = drawing("svg", {id: "axes", width: size, height: size, role: "img", "aria-label": "Axes"});
  const axes = ["x", "y", "z"].map((name) => {
    const line = drawing("line", {x1: middle, y1: middle, class: `axis ${name}`});
    const text = drawing("text", {"text-anchor": "middle", "dominant-baseline": "central"}, name);
    svg.append(line, text);
    return {line, text};
  });
  place.append(svg);
  return (camera) => {
    const turn = camera.quaternion.clone().conjugate();
    axes.forEach(({line, text}, axis) => {
      const end = new THREE.Vector3().setComponent(axis, 1).applyQuaternion(turn);
      line.setAttribute("x2", middle + long * end.x);
      line.setAttribute("y2", middle - long * end.y);
      text.setAttribute("x", middle + (long + 7) * end.x);
      text.setAttribute("y", middle - (long + 7) * end.y);
    });
  };
}

function makeScale(place) {
  const text = element("span"), bar = element("div");
  place.append(element("div", {id: "scale", role: "img", "aria-label": "Scale"}, text, bar));
  return (pixel) => {
    const length = roundLength(140 * pixel);
    if (!(length > 0)) return;
    text.textContent = short(length);
    bar.style.width = `${length / pixel}px`;
  };
}

function makeLegend(place, deepest) {
  const list = element("div", {id: "legend", class: "plain"});
  if (deepest > 0) {
    const bands = depthShades.map((shade) => {
      const band = element("span", {class: "band"});
      band.style.background = shade;
      return band;
    });
    const ends = element("div", {class: "ends"}, element("span", {}, "0"), element("span", {}, short(deepest)));
    list.append(element("div", {}, "depth"), element("div", {class: "bands"}, ...bands), ends);
  }
  const marks = {tracked: "node and its elements", segment: "segment and its element", overlap: "overlap in the cut"};
  for (const [name, text] of Object.entries(marks)) {
    const swatch = element("span", {class: "swatch"});
    swatch.style.background = `var(--${name})`;
    list.append(element("div", {class: "mark"}, swatch, ` ${text}`));
  }
  place.append(list);
}

/** Returns what moves axes and scale with the camera. */
function makeOverlay(deepest) {
  const place = byId("view");
  const axes = makeAxes(place), scale = makeScale(place);
  makeLegend(place, deepest);
  return (camera, pixel) => {
    axes(camera);
    scale(pixel);
  };
}
