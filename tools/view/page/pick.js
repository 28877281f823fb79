// Which box a ray meets first within `reach` (of the length of `along`): slabs of every box, exact
// enough for a click.

function pickBox(corners, from, along, reach = Infinity) {
  let best = reach, hit = null;
  const inverse = [1 / along.x, 1 / along.y, 1 / along.z], start = [from.x, from.y, from.z];
  for (let i = 0; i < corners.length; i += 6) {
    let enter = 0, leave = best;
    for (let k = 0; k < 3 && enter <= leave; ++k) {
      const a = (corners[i + k] - start[k]) * inverse[k];
      const b = (corners[i + 3 + k] - start[k]) * inverse[k];
      enter = Math.max(enter, Math.min(a, b));
      leave = Math.min(leave, Math.max(a, b));
    }
    if (enter <= leave && enter < best) {
      best = enter;
      hit = i / 6;
    }
  }
  return hit;
}

class PickedBox {
  constructor(boxes) {
    this.boxes = boxes;
    this.index = null;
    const cube = new THREE.BoxBufferGeometry(1, 1, 1);
    this.object = new THREE.LineSegments(new THREE.EdgesGeometry(cube),
      new THREE.LineBasicMaterial({ depthTest: false, transparent: true }));
    this.object.visible = false;
    this.object.renderOrder = 7;
    theme.follow(() => this.object.material.color.copy(theme.colour("accent")));
  }

  choose(index) {
    this.index = index;
    this.object.visible = index !== null;
    const card = byId("picked");
    card.hidden = index === null;
    if (index === null) return;
    const c = this.boxes.corners.subarray(6 * index, 6 * index + 6);
    this.object.position.set((c[0] + c[3]) / 2, (c[1] + c[4]) / 2, (c[2] + c[5]) / 2);
    this.object.scale.set(c[3] - c[0] || 1e-3, c[4] - c[1] || 1e-3, c[5] - c[2] || 1e-3);
    const label = this.boxes.label ? this.boxes.labels[this.boxes.label[index]] : "";
    card.replaceChildren(
      element("div", { class: "card-head" }, element("h2", {}, "Box"),
        element("button", { type: "button", class: "quiet", "aria-label": "Close",
          onclick: () => { this.choose(null); stage.redraw(); } }, "×")),
      facts([
        ["Id in the source", this.boxes.ids ? String(this.boxes.ids[index]) : null],
        ["Label", label || null],
        ["Top", metres(c[5] + origin[2])],
        ["Bottom", metres(c[2] + origin[2])],
        ["East–west", metres(c[3] - c[0])],
        ["North–south", metres(c[4] - c[1])],
      ]));
  }
}
