// The ways of motions in parts: where their return is proved, where there is a planned way, and where there is none.

class HomeLines {
  constructor() {
    this.object = new THREE.Group();
    this.made = new Map();
    this.mode = homes.size ? "home" : "";
  }

  // `mode`: "home": all parts; "left": those without a way home, over the motion's own colours; else nothing.
  setMode(mode, ribbons) {
    this.mode = mode;
    this.show(ribbons);
  }

  // In the place of those ribbons that have ways home, or beside them.
  show(ribbons) {
    this.object.remove(...this.object.children);
    for (const ribbon of ribbons) {
      const home = homeOf(ribbon.motion.mission);
      ribbon.object.visible = !(home && this.mode === "home");
      if (!home || !(this.mode === "home" || this.mode === "left")) continue;
      for (const { kind, ribbon: part } of this.partsOf(ribbon.motion, home)) {
        if (this.mode === "home" || kind === "none") this.object.add(part.object);
      }
    }
  }

  partsOf(motion, home) {
    if (!this.made.has(motion)) {
      this.made.set(motion, home.parts.map(part => ({ kind: part.kind, points: this.pointsOf(motion, part) })).filter(p => p.points.length >= 6)
        .map(({ kind, points }) => ({ kind, ribbon: this.ribbonOf(kind, points) })));
    }
    return this.made.get(motion);
  }

  ribbonOf(kind, points) {
    const ribbon = new Ribbon(points, { colour: homeColours[kind], pattern: kind === "none" ? 1 : 0, width: kind === "none" ? 5 : 3 });
    for (const mesh of ribbon.object.children) mesh.renderOrder += kind === "none" ? 2 : 0;
    return ribbon;
  }

  // Samples of the motion between exact ends.
  pointsOf(motion, { from, until }) {
    const end = Math.min(until, motion.duration), times = [from, ...Array.from(motion.time).filter(t => t > from && t < end), end];
    const points = new Float32Array(3 * times.length);
    if (from < end) times.forEach((t, i) => motion.vector(motion.position, t).toArray(points, 3 * i));
    return from < end ? points : new Float32Array(0);
  }
}
