// A camera that circles around a point: drag to turn, with the right button or Shift to shift, the wheel to come
// nearer; arrow keys, + and - do the same. `changed` is called whenever it moved (with true: its frame alone has
// changed), `pressed` for a click without a drag.

function makeCamera(canvas, changed, pressed) {
  const camera = new THREE.PerspectiveCamera(35, 1, 0.01, 1000);
  camera.up.set(0, 0, 1);
  const state = {target: new THREE.Vector3(), distance: 10, turn: -0.9, rise: 0.55};
  let reach = 10;  // radius around the origin that must stay visible
  let flight = 0;

  function place(still = false) {
    const {target, distance, turn, rise} = state;
    camera.position.set(Math.cos(rise) * Math.cos(turn), Math.cos(rise) * Math.sin(turn), Math.sin(rise));
    camera.position.multiplyScalar(distance).add(target);
    camera.lookAt(target);
    camera.near = distance / 200;
    camera.far = distance + 2 * (reach + target.length());
    camera.updateProjectionMatrix();
    camera.updateMatrixWorld();
    changed(still);
  }

  function turn(x, y) {
    state.turn -= x;
    state.rise = Math.min(1.55, Math.max(-1.55, state.rise + y));
    place();
  }

  function shift(x, y) {
    const step = (2 * state.distance * Math.tan((camera.fov * Math.PI) / 360)) / canvas.clientHeight;
    const right = new THREE.Vector3().setFromMatrixColumn(camera.matrixWorld, 0);
    const up = new THREE.Vector3().setFromMatrixColumn(camera.matrixWorld, 1);
    state.target.addScaledVector(right, -x * step).addScaledVector(up, y * step);
    place();
  }

  function zoom(factor) {
    state.distance = Math.min(100 * reach, Math.max(1e-6 * reach, state.distance * factor));
    place();
  }

  /** Moves to a target in a moment, or at once where the reader wants no motion. */
  function fly(target, distance, direction) {
    cancelAnimationFrame(flight);
    const from = {target: state.target.clone(), distance: state.distance, turn: state.turn, rise: state.rise};
    const to = {turn: state.turn, rise: state.rise};
    if (direction) {
      to.turn = Math.atan2(direction.y, direction.x);
      to.rise = Math.min(1.55, Math.max(-1.55, Math.asin(direction.z / direction.length())));
    }
    const around = Math.atan2(Math.sin(to.turn - from.turn), Math.cos(to.turn - from.turn));
    const start = performance.now();
    const still = matchMedia("(prefers-reduced-motion: reduce)").matches;
    const step = (now) => {
      const part = still ? 1 : Math.min(1, Math.max(0, (now - start) / 450));
      const eased = part * part * (3 - 2 * part);
      state.target.lerpVectors(from.target, target, eased);
      state.distance = from.distance * (distance / from.distance) ** eased;
      state.turn = from.turn + around * eased;
      state.rise = from.rise + (to.rise - from.rise) * eased;
      place();
      if (part < 1) flight = requestAnimationFrame(step);
    };
    step(start);
  }

  listenToPointer(canvas, {turn, shift, zoom, pressed, stop: () => cancelAnimationFrame(flight)});
  canvas.addEventListener("keydown", (event) => {
    const acts = {
      ArrowLeft: () => turn(0.1, 0),
      ArrowRight: () => turn(-0.1, 0),
      ArrowUp: () => turn(0, 0.1),
      ArrowDown: () => turn(0, -0.1),
      "+": () => zoom(0.8),
      "-": () => zoom(1.25),
    };
    if (!(event.key in acts)) return;
    event.preventDefault();
    acts[event.key]();
  });
  return {
    camera,
    state,
    fly,
    /** The length that a pixel shows at the target. */
    pixel(height) {
      return (2 * state.distance * Math.tan((camera.fov * Math.PI) / 360)) / Math.max(1, height);
    },
    setReach(radius) {
      reach = radius;
    },
    resize(width, height) {
      camera.aspect = width / Math.max(1, height);
      place(true);
    },
  };
}

function listenToPointer(canvas, {turn, shift, zoom, pressed, stop}) {
  let drag = null;
  canvas.addEventListener("contextmenu", (event) => event.preventDefault());
  canvas.addEventListener("pointerdown", (event) => {
    stop();
    drag = {x: event.clientX, y: event.clientY, moved: 0, shifts: event.button === 2 || event.shiftKey};
    canvas.setPointerCapture(event.pointerId);
  });
  canvas.addEventListener("pointermove", (event) => {
    if (!drag) return;
    const x = event.clientX - drag.x, y = event.clientY - drag.y;
    drag.moved += Math.abs(x) + Math.abs(y);
    drag.x = event.clientX;
    drag.y = event.clientY;
    if (drag.shifts)
      shift(x, y);
    else
      turn(x * 0.006, y * 0.006);
  });
  canvas.addEventListener("pointerup", (event) => {
    if (drag && drag.moved < 4) pressed(event.offsetX, event.offsetY);
    drag = null;
  });
  canvas.addEventListener("pointercancel", () => {
    drag = null;
  });
  canvas.addEventListener("wheel", (event) => {
    event.preventDefault();
    stop();
    zoom(Math.exp(Math.max(-100, Math.min(100, event.deltaY)) * 0.002));
  }, {passive: false});
}
