// What belongs to one id: its paths, what was planned, what was flown, and whether its checks passed.

const missionColours = 8, missionPatterns = 4;  // --mission-0 … of the theme; solid, dashed, dotted, dash and dot

class Mission {
  constructor(id, index) {
    Object.assign(this, { id, index, paths: [], motions: [], checks: [], failure: null });
    this.colour = `mission-${index % missionColours}`;
    this.pattern = Math.floor(index / missionColours) % missionPatterns;
  }

  // The motion to show first: flown where `flown` asks for it and there is one.
  motion(flown) { return this.motions.find(m => m.isFlight === flown) || this.motions[0] || null; }

  // What is shown of it, in the words of reports: [["trajectory", how many], …].
  shown() {
    const planned = this.motions.filter(m => m.word === "planned").length, flown = this.motions.filter(m => m.isFlight).length;
    const ways = planned + flown ? 0 : this.paths.filter(p => p.points).length;
    return [["trajectory", planned], ["flight log", flown], ["path", ways]].filter(([, number]) => number);
  }

  // The kinds of what is shown that the check accepted against the map; each of them needs a report of its own.
  accepted() {
    return this.shown().filter(([kind, number]) => this.checks.filter(c => c.checked === kind && (c.ok || isOfHome(c))).length >= number).map(([kind]) => kind);
  }

  isAccepted() { return this.accepted().length > 0 && this.accepted().length === this.shown().length; }

  // What to say of it beside its id.
  note() {
    if (this.motions.length) return withUnit(this.motions[0].duration, 1, "s");
    if (this.failure) return this.failure.replaceAll("_", " ");
    const found = this.paths.find(p => p.points);
    return found ? metres(found.length) : "–";
  }
}


// What a drone flies by its file is a mission; what a planner found is a path.
function pathWord(paths) { return paths.every(p => p.mission) ? "mission" : "path"; }

const missionOfPath = new Map();

const missions = (() => {
  const list = new Map();
  const of = id => {
    if (!list.has(id)) list.set(id, new Mission(id, list.size));
    return list.get(id);
  };
  for (const path of meta.paths) {
    const mission = of(path.id);
    mission.paths.push(path);
    missionOfPath.set(path, mission);
    if (!path.points) mission.failure = path.status;
  }
  for (const motion of motions) {
    motion.mission = of(motion.id);
    motion.mission.motions.push(motion);
  }
  for (const { id, status } of meta.unsolved) of(id).failure = status;
  for (const check of meta.reports) if (list.has(check.id)) list.get(check.id).checks.push(check);
  return [...list.values()];
})();

// Several missions are told apart by colour, one by what is planned and flown.
const manyMissions = missions.length > 1;

// How to draw a line of a mission; `alone` names the colour where there is but one.
function lineStyle(mission, alone, width) {
  return { colour: manyMissions ? mission.colour : alone, pattern: manyMissions ? mission.pattern : 0, width };
}
