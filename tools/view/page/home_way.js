// The way home from where the vehicle is now: a sketch of the autopilot's return, and the planned way; and all planned
// ways of the mission, faintly, with where they land.

const mostMet = 100;

class HomeWay {
  // `floor`: the height where a landing ends that knows no other.
  constructor(floor) {
    this.floor = floor;
    this.object = new THREE.Group();
    const most = Math.max(2, ...[...homes.values()].flatMap(h => h.ways).map(w => 1 + (w.points ? w.points.count / 3 : 0)));
    this.lines = { proved: this.line("proved", 4, 2), planned: this.line("planned", most, 3), none: this.line("none", 4, 2) };
    this.met = new Marker([0, 0, 0], "failed", "bad", 22);
    this.all = new THREE.Group();
    this.object.add(this.met.object, this.all);
    this.faint = new THREE.LineBasicMaterial({ transparent: true, opacity: 0.45, depthTest: false });
    theme.follow(() => this.faint.color.copy(theme.colour("planned")));
    this.signs = [];
    this.made = new Map();  // of each home, signs of its places
    this.shown = {};
  }

  line(kind, count, width) {
    const ribbon = new Ribbon(new Float32Array(3 * count), { colour: homeColours[kind], pattern: kind === "none" ? 1 : 0, width });
    this.object.add(ribbon.object);
    return ribbon;
  }

  // Another mission is looked at: its planned ways and landing places.
  choose(home) {
    this.all.remove(...this.all.children);
    if (home && !this.made.has(home)) this.made.set(home, this.signsOf(home));
    this.signs = home ? this.made.get(home) : [];
    const legs = home ? home.ways.filter(w => w.points).map(w => arrayOf(w.points)) : [];
    if (legs.some(points => points.length >= 6)) this.all.add(this.legs(legs));
    for (const marker of this.signs) this.all.add(marker.object);
  }

  legs(ways) {
    const ends = [];
    for (const points of ways) for (let i = 0; i + 6 <= points.length; i += 3) ends.push(...points.subarray(i, i + 6));
    const geometry = new THREE.BufferGeometry();
    geometry.setAttribute("position", new THREE.BufferAttribute(new Float32Array(ends), 3));
    const lines = new THREE.LineSegments(geometry, this.faint);
    lines.renderOrder = 4;
    return lines;
  }

  // Where ways home end; and what returns would meet, where there is no motion to show that in time.
  signsOf(home) {
    const sites = new Map(home.ways.filter(w => w.points).map(w => [w.site, arrayOf(w.points).slice(-3)]));
    const out = [...sites.values()].map(at => new Marker(at, "site", "planned", 20));
    if (home.returned && home.returned.home) out.push(new Marker(home.returned.home, "site", "good", 20));
    const met = home.motion || !home.returned ? [] : home.returned.gaps.filter(g => g.place).slice(0, mostMet);
    return out.concat(met.map(g => new Marker(g.place, "failed", "bad", 18)));
  }

  // The sketch of a return from a place: up, across, down.
  sketch({ action, home, height }, { x, y, z }) {
    if (action === "hold") return null;
    if (action === "land") return [x, y, z, x, y, this.floor];
    if (!home) return null;
    const top = Math.max(z, home[2] + height);
    return [x, y, z, x, y, top, home[0], home[1], top, ...home];
  }

  update(perPixel) {
    const [home, t] = homeNow(), shown = { proved: null, planned: null, none: null };
    const gap = home && t !== null ? home.gapAt(t) : null;
    if (home && t !== null) {
      const at = selection.motion.place(clock.time), way = home.wayAt(t);
      if (home.returned) shown[gap ? "none" : "proved"] = this.sketch(home.returned, at);
      if (way) shown.planned = [...at.toArray(), ...arrayOf(way.points)];
    }
    for (const [kind, points] of Object.entries(shown)) this.draw(this.lines[kind], points);
    this.met.object.visible = Boolean(gap && gap.place);
    if (this.met.object.visible) this.met.object.position.fromArray(gap.place);
    for (const marker of [this.met, ...this.signs]) marker.resize(perPixel);
    Object.assign(this, { shown, time: clock.time });
  }

  // What is too short ends in its last point.
  draw(ribbon, points) {
    ribbon.object.visible = Boolean(points);
    if (!points) return;
    for (let i = 0; i < ribbon.points.length; ++i) ribbon.points[i] = points[i < points.length ? i : points.length - 3 + i % 3];
    ribbon.moved();
  }
}
