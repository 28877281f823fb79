// The camera around a point: by mouse, touch and keys.

const tallest = Math.PI / 2 - 0.001;

class Orbit {
  constructor() {
    this.target = new THREE.Vector3();
    this.distance = 100;
    this.heading = 0;     // where the view goes: radians from north, clockwise
    this.elevation = 0.7;  // above the horizon, of the camera seen from the target
  }

  place(camera) {
    const { heading: h, elevation: e, distance: d } = this;
    camera.position.set(-Math.sin(h) * Math.cos(e), -Math.cos(h) * Math.cos(e), Math.sin(e))
      .multiplyScalar(d).add(this.target);
    camera.up.set(Math.sin(h) * Math.sin(e), Math.cos(h) * Math.sin(e), Math.cos(e));
    camera.lookAt(this.target);
  }

  turn(dx, dy) {
    this.heading += dx;
    this.elevation = Math.min(Math.max(this.elevation + dy, -0.3), tallest);
  }

  // Metres to the right and ahead, over the ground.
  move(right, ahead) {
    const s = Math.sin(this.heading), c = Math.cos(this.heading);
    this.target.x += right * c + ahead * s;
    this.target.y += -right * s + ahead * c;
  }

  zoom(factor) { this.distance = Math.min(Math.max(this.distance * factor, 0.5), 1e5); }
}

// Tells `on`: turn(dx, dy), move(dx, dy), zoom(factor, x, y), click(x, y) in pixels of `surface`.
function listenToPointers(surface, on) {
  const down = new Map();
  let travelled = 0;
  const local = e => {
    const box = surface.getBoundingClientRect();
    return { x: e.clientX - box.left, y: e.clientY - box.top };
  };
  surface.addEventListener("contextmenu", e => e.preventDefault());
  surface.addEventListener("pointerdown", e => {
    surface.setPointerCapture(e.pointerId);
    if (down.size === 0) travelled = 0;
    down.set(e.pointerId, { ...local(e), moves: e.button !== 0 || e.shiftKey });
  });
  surface.addEventListener("pointermove", e => {
    const before = down.get(e.pointerId);
    if (!before) return;
    const now = { ...local(e), moves: before.moves };
    const dx = now.x - before.x, dy = now.y - before.y;
    travelled += Math.abs(dx) + Math.abs(dy);
    if (down.size === 2) {
      const other = [...down].find(([id]) => id !== e.pointerId)[1];
      const spread = p => Math.hypot(p.x - other.x, p.y - other.y);
      on.move(dx / 2, dy / 2);
      on.zoom(spread(before) / Math.max(spread(now), 1), (now.x + other.x) / 2, (now.y + other.y) / 2);
    } else if (now.moves) on.move(dx, dy);
    else on.turn(dx, dy);
    down.set(e.pointerId, now);
  });
  const up = e => {
    if (!down.delete(e.pointerId)) return;
    if (e.type === "pointerup" && down.size === 0 && travelled < 5) on.click(local(e).x, local(e).y);
  };
  surface.addEventListener("pointerup", up);
  surface.addEventListener("pointercancel", up);
  surface.addEventListener("wheel", e => {
    e.preventDefault();
    const { x, y } = local(e);
    on.zoom(Math.exp(Math.min(Math.max(e.deltaY, -200), 200) * 0.0015), x, y);
  }, { passive: false });
}
