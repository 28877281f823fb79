// The line between the two flights of a pair, and how far apart they are now.

class PairLine {
  constructor() {
    this.points = new Float32Array(6);
    this.ribbon = new Ribbon(this.points, { colour: "bad", width: 3 });
    this.object = this.ribbon.object;
    this.object.visible = false;
    this.distance = null;
    this.label = element("div", { class: "pair-label", hidden: true });
    byId("mission-labels").append(this.label);
  }

  update(pair, time, camera, width, height) {
    this.object.visible = Boolean(pair);
    this.label.hidden = !pair;
    this.distance = null;
    if (!pair) return;
    const [a, b] = pair.of.map(i => motions[i].place(time));
    this.points.set([a.x, a.y, a.z, b.x, b.y, b.z]);
    this.ribbon.moved();
    this.distance = a.distanceTo(b);
    const words = apartWords({ across: Math.hypot(a.x - b.x, a.y - b.y), up: Math.abs(a.z - b.z) });
    if (this.label.textContent !== words) this.label.textContent = words;
    const at = a.lerp(b, 0.5).project(camera);
    this.label.style.visibility = at.z < 1 ? "visible" : "hidden";
    this.label.style.transform =  // below the line
      `translate(-50%,0) translate(${((at.x + 1) / 2 * width).toFixed(1)}px,${((1 - at.y) / 2 * height + 26).toFixed(1)}px)`;
  }
}
