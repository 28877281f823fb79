// The missions, each with its colour and pattern of line: a legend, and a way to choose one.

const listedMissions = 1000;

function verdictOf(mission) {
  const failed = mission.checks.find(c => !isOfRefused(c) && !c.ok);
  if (failed) return element("span", { class: "bad", title: whyOf(failed) }, "✕");
  const accepted = mission.accepted();
  if (!accepted.length) return null;
  const others = mission.shown().map(([kind]) => kind).filter(kind => !accepted.includes(kind));
  const title = `The ${accepted.join(" and the ")} passed the check against the map${others.length ? `; the ${others.join(" and the ")} was not checked` : ""}`;
  return element("span", { class: others.length ? "soft" : "good", title }, "✓");
}

function missionEntry(mission) {
  return element("li", {}, element("button", { type: "button", class: "mission", "data-mission": mission.id,
    onclick: () => selection.choose(mission) }, missionSwatch(mission), element("span", { class: "id" }, mission.id),
  ...missionNotes(mission).map(words => element("span", { class: "note soft" }, words)), verdictOf(mission)));
}

// Of a fleet's flight: when it departs, how late, and how near another comes.
function missionNotes(mission) {
  if (!together || !mission.motions.length) return [mission.note()];
  const { begin, data, nearest, apart } = mission.motions[0];
  const late = data.delay ? ` (+${shortMetres(data.delay)}${thinSpace}s)` : "";
  return [clockWords(begin, 1).replace(/(\.\d)? UTC$/, "") + late,
    Number.isFinite(nearest) ? `${shortMetres(apart.across)} across, ${shortMetres(apart.up)} up` : "–"];
}

function fleetHead() {
  return element("p", { class: "mission-head soft", "aria-hidden": "true" }, ["flight", `departs${together.epoch ? ", UTC" : ", s"} (late)`,
    "nearest other flight, m"].map(words => element("span", {}, words)));
}

function missionSwatch({ colour, pattern }) {
  return element("span", { class: `swatch line pattern-${pattern}`, style: `--c:var(--${colour})` });
}

// How a fleet's list may be ordered: words, and what counts of a mission, the least first.
const missionOrders = [["id", "as in the file", m => m.index], ["start", "departure", m => orderOf(m, x => x.begin)],
  ["delay", "delay, longest first", m => orderOf(m, x => -x.data.delay)],
  ["nearest", "nearest approach", m => orderOf(m, x => x.nearest)], ["home", "time with a way home, least first", m => (homeOf(m) ? homeOf(m).share : Infinity)]];

function orderOf(mission, value) {
  const v = mission.motions.length ? value(mission.motions[0]) : NaN;
  return Number.isFinite(v) ? v : Infinity;
}

// The missions that hold `words` in their id, in that order.
function chosenMissions(words, order) {
  const [, , value] = missionOrders.find(([key]) => key === order);
  const part = words.trim().toLowerCase();
  const found = missions.filter(m => m.id.toLowerCase().includes(part));
  return found.map(m => [value(m), m.index, m]).sort((a, b) => a[0] - b[0] || a[1] - b[1]).map(([, , m]) => m);
}

function makeMissionList() {
  let shown = [], entries = [];
  const list = element("ul", { class: together ? "missions fleet" : "missions", "aria-label": "Missions" });
  const more = element("p", { class: "soft" });
  const mark = () => {
    entries.forEach((entry, i) => entry.firstChild.setAttribute("aria-pressed", String(shown[i] === selection.mission)));
    const entry = entries[shown.indexOf(selection.mission)];
    if (!entry) return;
    const top = entry.offsetTop;
    if (top < list.scrollTop || top + entry.offsetHeight > list.scrollTop + list.clientHeight) {
      list.scrollTop = top - list.clientHeight / 2;
    }
  };
  const fill = found => {
    shown = found.slice(0, listedMissions);
    entries = shown.map(missionEntry);
    list.replaceChildren(...entries);
    const left = found.length - shown.length;
    more.textContent = left ? `and ${decimals(left, 0)} more: ${together ? "name a part of their id" : "click their lines"}` : "";
    more.hidden = !left;
    mark();
  };
  const tools = together ? missionTools(fill) : null;
  fill(missions);
  selection.follow(mark);
  return element("section", {}, element("h2", {}, count(missions.length, together ? "flight" : "mission")), tools, together ? fleetHead() : null, list, more);
}

// Finding and ordering the flights of a fleet.
function missionTools(fill) {
  let words = "", order = "id";
  const again = () => fill(chosenMissions(words, order));
  const find = element("input", { type: "search", id: "find", placeholder: "find by id", "aria-label": "Find flights by id",
    oninput: () => { words = find.value; again(); } });
  const known = missionOrders.filter(([key, , value]) => key === "id" || missions.some(m => Number.isFinite(value(m))));
  return element("div", { class: "row tools" }, find, choice("Order of the flights", known.map(([key, words]) => [key, words]),
    "id", key => { order = key; again(); }));
}
