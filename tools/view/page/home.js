// Ways home of a flight: its autopilot's own return, and those that were planned, from each instant on.

const homeTouching = 1e-6;  // s

// Times that hold the ways of a list with energy enough, as long as they go on: [[from, until], …].
function plannedTimes(ways) {
  const out = [];
  for (const way of ways) {
    if (way.latest === undefined) continue;  // no way, or never the energy for it
    const last = out[out.length - 1];
    if (last && way.from <= last[1] + homeTouching) last[1] = Math.max(last[1], way.latest);
    else out.push([way.from, way.latest]);
  }
  return out;
}

class Home {
  // `returns`: of reports; `ways`: contingencies.
  constructor(id, returns, ways) {
    Object.assign(this, { id, returns, ways: [...ways].sort((a, b) => a.from - b.from) });
    this.mission = missions.find(m => m.id === id) || null;
    this.motion = this.mission && this.mission.motion(false);
    this.planned = plannedTimes(this.ways);
    this.duration = Math.max(0, ...returns.map(r => r.duration), ...this.ways.map(w => w.until), this.motion ? this.motion.duration : 0);
    this.parts = this.partsOf();
  }

  // The report that is drawn: the first.
  get returned() { return this.returns[0] || null; }

  gapAt(t) { return this.returned ? this.returned.gaps.find(g => g.from <= t && t <= g.until) || null : null; }

  wayAt(t) { return this.ways.find(w => w.from <= t && t <= w.latest) || null; }

  // How long there will still be a planned way, s; 0 where there is none.
  left(t) {
    const span = this.planned.find(([from, until]) => from <= t && t <= until);
    return span ? span[1] - t : 0;
  }

  // "proved": the autopilot's return; "planned": only a planned way; "none".
  kindAt(t) {
    if (this.returned && t <= this.returned.duration + homeTouching && !this.gapAt(t)) return "proved";
    return this.planned.some(([from, until]) => from <= t && t <= until) ? "planned" : "none";
  }

  // The flight in parts of one kind: [{ from, until, kind }], ascending.
  partsOf() {
    const gaps = this.returned ? this.returned.gaps.map(g => [g.from, g.until]) : [];
    const cuts = [0, this.duration, ...gaps.flat(), ...this.planned.flat(), ...(this.returned ? [this.returned.duration] : [])].filter(t => t >= 0 && t <= this.duration);
    cuts.sort((a, b) => a - b);
    const out = [];
    for (let i = 1; i < cuts.length; ++i) {
      if (cuts[i] - cuts[i - 1] <= homeTouching) continue;
      const kind = this.kindAt((cuts[i] + cuts[i - 1]) / 2), last = out[out.length - 1];
      if (last && last.kind === kind) last.until = cuts[i]; else out.push({ from: cuts[i - 1], until: cuts[i], kind });
    }
    return out;
  }

  none() { return this.parts.filter(p => p.kind === "none"); }

  // Of the time of the flight, 0 to 1.
  shareOf(...kinds) {
    if (!(this.duration > 0)) return this.returned && !this.returned.gaps.length ? 1 : 0;
    return this.parts.filter(p => kinds.includes(p.kind)).reduce((sum, p) => sum + p.until - p.from, 0) / this.duration;
  }

  get share() { return this.shareOf("proved", "planned"); }
}

// By id, in the order of the missions.
const homes = (() => {
  const ids = new Set([...missions.map(m => m.id), ...meta.reports.map(r => r.id), ...(meta.contingencies || []).map(w => w.id)]);
  const out = new Map();
  for (const id of ids) {
    const returns = meta.reports.filter(r => r.id === id && r.return).map(r => r.return);
    const ways = (meta.contingencies || []).filter(w => w.id === id);
    if (returns.length || ways.length) out.set(id, new Home(id, returns, ways));
  }
  return out;
})();

function homeOf(mission) { return (mission && homes.get(mission.id)) || null; }

// Of the motion that is looked at, as long as it flies: [home, s of the flight].
function homeNow() {
  const { motion, mission } = selection, home = homeOf(mission);
  return home && motion && motion.flies(clock.time) ? [home, motion.local(clock.time)] : [home, null];
}

const phaseWords = { braking: "while it brakes", climb: "while it climbs", way: "on its way home", descent: "while it sinks", landing: "where it lands" };

// "on its way home it meets obstacle 1135"
function gapWords(gap) {
  const met = { bounds: "it leaves the map's bounds", fence: `it leaves ${gap.fence === undefined ? "a fence" : `fence ${gap.fence}`}`,
    landing: "there is no level ground as high as home", collision: `it meets ${gap.box === undefined ? "an obstacle" : `obstacle ${gap.box}`}` };
  return `${phaseWords[gap.phase] || gap.phase} ${met[gap.reason] || "it may go to another place"}`;
}

function shareWords(share) { return withUnit(share < 1 ? Math.min(100 * share, 99.9) : 100, 1, "%"); }

function spanWords({ from, until }) { return `${decimals(from, 1)} to ${withUnit(until, 1, "s")}`; }

const homeColours = { proved: "good", planned: "planned", none: "bad" };
const homeWords = { proved: "return proved", planned: "only a planned way",
  none: [...homes.values()].some(h => h.returns.length) ? "none proved" : "no way home" };

// The kinds that the page has.
function homeKinds() {
  const all = [...homes.values()];
  return [...(all.some(h => h.returns.length) ? ["proved"] : []), ...(all.some(h => h.ways.length) ? ["planned"] : []), "none"];
}
