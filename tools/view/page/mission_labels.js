// The ids of missions beside where they are now; those that would overlap others stay away.

const mostLabels = 40;

class MissionLabels {
  constructor(stage) {
    this.stage = stage;
    this.holder = byId("mission-labels");
    this.made = new Map();
    this.labels = manyMissions ? missions.slice(0, together && missions.length > mostLabels ? 0 : mostLabels)
      .filter(m => this.placed(m)).map(m => this.label(m)) : [];
    selection.follow(() => {
      if (together) this.nameChosen();
      this.order();
    });
  }

  placed(mission) { return mission.motions.length > 0 || mission.paths.some(p => p.points); }

  label(mission) {
    if (!this.made.has(mission)) {
      const made = element("button", { type: "button", class: "mission-label", tabindex: "-1",
        style: `--c:var(--${mission.colour})`, onclick: () => selection.choose(mission) }, mission.id);
      this.holder.append(made);
      this.made.set(mission, { mission, size: null, point: new THREE.Vector3(), element: made });
    }
    return this.made.get(mission);
  }

  // Of a fleet that is too large for names, those that are looked at have one.
  nameChosen() {
    if (missions.length <= mostLabels) return;
    for (const l of this.labels) l.element.style.visibility = "hidden";
    const chosen = selection.pair ? selection.pair.of.map(i => motions[i].mission) : [selection.mission];
    this.labels = [...new Set(chosen)].filter(m => m && this.placed(m)).map(m => this.label(m));
  }

  // The chosen one first: it is never left out.
  order() {
    const first = l => (l.mission === selection.mission ? -1 : l.mission.index);
    this.labels.sort((a, b) => first(a) - first(b));
    for (const l of this.labels) l.element.classList.toggle("chosen", l.mission === selection.mission);
    for (const l of this.labels) l.size = null;
  }

  place({ mission, point }) {
    const motion = mission === selection.mission ? selection.motion : mission.motion(false);
    if (motion) return motion.place(clock.time, point);
    return point.fromArray(arrayOf(mission.paths.find(p => p.points).points), 0);
  }

  shown(mission) {
    return mission.motions.length ? this.stage.motionGroup.visible : this.stage.pathGroup.visible;
  }

  // The first free place beside each: above to the right, below to the right, above to the left, below to the left.
  update(camera, width, height) {
    const taken = [];
    for (const label of this.labels) {
      const at = this.place(label).project(camera);
      label.size = label.size || [label.element.offsetWidth || 60, label.element.offsetHeight || 18];
      const [w, h] = label.size, x = (at.x + 1) / 2 * width, y = (1 - at.y) / 2 * height;
      const places = [[x + 12, y - h - 4], [x + 12, y + 6], [x - w - 12, y - h - 4], [x - w - 12, y + 6]];
      const free = ([left, top]) => left > 2 && top > 2 && left + w < width - 2 && top + h < height - 2 &&
        !taken.some(t => left < t[2] && left + w > t[0] && top < t[3] && top + h > t[1]);
      const place = at.z < 1 && this.shown(label.mission) ? places.find(free) : undefined;
      label.element.style.visibility = place ? "visible" : "hidden";
      if (!place) continue;
      taken.push([place[0], place[1], place[0] + w, place[1] + h]);
      label.element.style.transform = `translate(${place[0].toFixed(1)}px,${place[1].toFixed(1)}px)`;
    }
  }
}
