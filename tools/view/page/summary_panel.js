// A fleet in a few sentences, shown first: what is proved, which flights were refused, when most are in the air.

// When the most flights are in the air: the middle of the longest such stretch.
function busiest() {
  const changes = motions.flatMap(m => [[m.begin, 1], [m.begin + m.duration, -1]]).sort((a, b) => a[0] - b[0] || b[1] - a[1]);
  let flying = 0, best = { time: 0, flights: 0, lasts: 0 };
  changes.forEach(([time, change], i) => {
    flying += change;
    const lasts = i + 1 < changes.length ? changes[i + 1][0] - time : 0;
    if (flying > best.flights || (flying === best.flights && lasts > best.lasts)) best = { time: time + lasts / 2, flights: flying, lasts };
  });
  return best;
}

// Records without a motion: they are refused flights, and no failures of what flies.
const refusedFlights = (() => {
  const flying = new Set(motions.map(m => m.id));
  return meta.unsolved.filter(u => !flying.has(u.id));
})();
const isOfRefused = (() => {
  const ids = new Set(refusedFlights.map(u => u.id));
  return check => !check.ok && !check.place && ids.has(check.id);
})();

// [class, sign, sentence] of the check of all pairs.
function pairsVerdict() {
  const { check } = together;
  if (!check) return ["soft", "", "No report of skyway-check --together is here: nothing is proved of pairs."];
  if (check.refused) return ["bad", "✕", `${decimals(check.refused, 0)} of ${count(check.pairs, "pair")} are not proved apart.`];
  const loose = check.overridden ? " Vehicles or margins were smaller than their records say." : "";
  if (!check.pairs) return ["soft", "", "There are no two flights, so nothing is proved of pairs."];
  if (check.pairs === 1) return ["good", "✓", `Both flights are proved apart.${loose}`];
  return ["good", "✓", `All ${count(check.pairs, "pair")} of ${count(check.flights, "flight")} are proved apart.${loose}`];
}

function mapVerdict() {
  const checks = meta.reports.filter(check => isOfMap(check) && !isOfRefused(check));
  if (!checks.length) return null;
  const failed = new Set(checks.filter(check => !check.ok && !isOfHome(check)).map(check => check.id));
  const flights = missions.filter(mission => mission.shown().length);
  if (failed.size) {
    const all = new Set([...failed, ...flights.map(mission => mission.id)]);
    return ["bad", "✕", `${decimals(failed.size, 0)} of ${count(all.size, "flight")} failed the check against the map.`];
  }
  const unknown = flights.filter(mission => !mission.isAccepted()).length;
  const loose = looseWords(checks);
  return unknown ? ["soft", "", `${decimals(flights.length - unknown, 0)} of ${count(flights.length, "flight")} passed the check against the map. ` +
      `Of ${unknown === 1 ? "the other" : "the others"} there is no report.${loose}`]
    : ["good", "✓", `${flights.length === 1 ? "The flight" : `All ${count(flights.length, "flight")}`} passed the check against the map.${loose}`];
}

// Of the autopilots' returns, where reports have them.
function homeVerdict() {
  const returned = [...homes.values()].filter(home => home.returned), whole = returned.filter(home => !home.returned.gaps.length).length;
  if (!returned.length) return null;
  return whole < returned.length ? ["bad", "✕", `A way home by the autopilot is proved from every instant of ${decimals(whole, 0)} of ${count(returned.length, "flight")}.`]
    : ["good", "✓", `A way home by the autopilot is proved from every instant of ${returned.length === 1 ? "the flight" : `all ${count(returned.length, "flight")}`}.`];
}

function sentence([kind, sign, words]) {
  return element("p", { class: `verdict-line ${kind}` }, sign ? element("span", { "aria-hidden": "true" }, sign) : null, element("span", {}, words));
}

// The refused flights by themselves: they do not fly, so nothing is compared with them.
function refusedNote() {
  const left = Math.max(together && together.check ? together.check.left_out : 0, refusedFlights.length);
  if (!left) return null;
  const words = `${count(left, "flight was", "flights were")} refused before. ${left === 1 ? "It is" : "They are"} not part of this plan` +
    (together ? `, and no pair counts ${left === 1 ? "it" : "them"}.` : ".");
  const rows = refusedFlights.slice(0, listedPairs).map(u => element("li", {}, element("b", {}, u.id), " ",
    element("span", { class: "soft" }, u.message || u.status.replaceAll("_", " "))));
  return element("section", { class: "aside" }, element("p", {}, words), rows.length
    ? element("details", {}, element("summary", {}, "Which, and why"), element("ul", {}, rows),
      refusedFlights.length > rows.length ? element("p", { class: "soft" }, `and ${decimals(refusedFlights.length - rows.length, 0)} more`) : null)
    : null);
}

function makeSummaryPanel() {
  const most = busiest(), { pairs, check } = together, last = clock.duration;
  const when = time => clockWords(time, 1) + (together.epoch ? "" : `${thinSpace}s`);
  const nearest = pairs[0];
  return element("div", { class: "summary-panel" }, sentence(pairsVerdict()), ...[mapVerdict(), homeVerdict()].filter(Boolean).map(sentence), refusedNote(),
    facts([
      ["Flights", decimals(motions.length, 0)],
      ["First departure", when(0)],
      ["Last arrival", when(last)],
      ["Most in the air", `${decimals(most.flights, 0)}, at ${when(most.time)}`],
      ["Asked between two flights", check && check.asked ? `${askedWords(check.asked)}` : null],
      ["Nearest pair", nearest ? pairName(nearest) : null],
      ["", nearest ? apartWords(nearest) : null],
    ]),
    element("div", { class: "row" },
      element("button", { type: "button", id: "densest", onclick: () => { clock.play(false); clock.set(most.time); } }, "The busiest time"),
      nearest ? element("button", { type: "button", onclick: () => jumpToPair(nearest) }, "The nearest pair") : null),
    element("p", { class: "soft" }, check
      ? `Proved by skyway-check: ${check.refused ? "all other pairs of" : "the"} planned flights keep that apart at every instant. ` +
        "Not proved: how well vehicles follow their plan."
      : "Distances are measured to 1 mm, for display."));
}
