// The ways home of the flight that is looked at in numbers, and those of all.

const actionWords = { rtl: "return to home", land: "land below", hold: "stay in place" };

// [class, sign, sentence]
function returnVerdict(returned) {
  const what = { rtl: "The autopilot's return is", land: "The autopilot's landing is", hold: "Staying in place is" }[returned.action] || `${returned.action} is`;
  if (returned.gaps.length && !(returned.share > 0)) return ["bad", "✕", `${what} proved from no instant.`];
  return returned.gaps.length ? ["bad", "✕", `${what} not proved for ${shareWords(1 - returned.share)} of the time.`]
    : ["good", "✓", `${what} proved from every instant.`];
}

function waysVerdict(home) {
  const held = home.planned.reduce((sum, [from, until]) => sum + until - from, 0), share = home.duration > 0 ? held / home.duration : 0;
  if (!home.planned.length) return ["bad", "✕", "There is no planned way home."];
  return share < 1 - 1e-9 ? ["bad", "✕", `There is no planned way home for ${shareWords(1 - share)} of the time.`]
    : ["good", "✓", "There is a planned way home from every instant."];
}

function returnFacts(returned) {
  const rtl = returned.action === "rtl";
  return facts([
    ["When the link is lost", actionWords[returned.action] || returned.action],
    ["Autopilot", returned.autopilot || null],
    ["Return height", rtl ? `${shortMetres(returned.height)}${thinSpace}m above home` : null],
    ["Proved from every instant at", rtl ? heightWords(returned) : null],
    ["A return may take", returned.longest ? withUnit(returned.longest, 0, "s") : null],
  ]);
}

// Metres that are enough stay enough with the digits of shortMetres.
function roundedUp(value) { const step = value < 10 ? 100 : 10; return Math.ceil(value * step - 1e-6) / step; }

// The least return height that makes all of it safe, or the best there is.
function heightWords({ least_height, best_height, best_share, share }) {
  if (least_height !== undefined) return `${shortMetres(roundedUp(least_height))}${thinSpace}m above home`;
  return !(best_share > share) ? "no height" : `no height; at ${shortMetres(best_height)}${thinSpace}m for ${shareWords(best_share)}`;
}

// To the instant, and to what would be met.
function goToGap(home, gap) {
  if (home.motion) {
    selection.chooseMotion(home.motion);
    clock.play(false);
    clock.set(home.motion.begin + gap.from);
  }
  if (!gap.place) return;
  stage.goTo(gap.place, Math.min(120, 0.6 * stage.view.extent().across));
  if (stage.picked && gap.box !== undefined) stage.picked.choose(stage.boxes.withId(gap.box));
  transport.cameras.choose("free");
}

const listedGaps = 200;

function gapTable(home, returned) {
  if (!returned.gaps.length) return null;
  const rows = returned.gaps.slice(0, listedGaps).map(gap => element("tr", { "data-from": gap.from, "data-until": gap.until },
    element("td", {}, element("button", { type: "button", class: "link", onclick: () => goToGap(home, gap) }, spanWords(gap))),
    element("td", { class: "words" }, gapWords(gap), gap.item === undefined ? "" : `, item ${gap.item}${gap.part ? ` (${gap.part})` : ""}`,
      gap.autopilot ? element("span", { class: "soft" }, ` ${gap.autopilot}`) : "")));
  return timeTable(["when", "what the return would meet"], rows, returned.gaps.length);
}

function wayTable(home) {
  const rows = home.ways.slice(0, listedGaps).map(way => element("tr", { "data-from": way.from, "data-until": way.until },
    element("td", {}, element("button", { type: "button", class: "link", onclick: () => goToGap(home, { from: way.from }) }, spanWords(way))),
    ...(way.points ? [way.site, way.length === undefined ? "–" : metres(way.length), way.duration === undefined ? "–" : withUnit(way.duration, 0, "s"),
      latestWords(way)].map(words => element("td", {}, words)) : [element("td", { class: "words bad", colspan: "4" }, way.message || "none was found")])));
  return timeTable(["when", "to", "length", "takes", "leave by"], rows, home.ways.length);
}

function latestWords(way) {
  if (!way.energy) return "–";
  return way.latest === undefined ? element("span", { class: "bad" }, "no energy") : withUnit(way.latest, 1, "s");
}

function timeTable(columns, rows, all) {
  return element("section", {}, element("table", { class: "times" }, element("thead", {}, element("tr", {}, columns.map(
    words => element("th", { scope: "col" }, words)))), element("tbody", {}, rows)),
  all > rows.length ? element("p", { class: "soft" }, `and ${decimals(all - rows.length, 0)} more`) : null);
}

function homeDetails(home) {
  if (!home) return [element("p", { class: "soft" }, "Nothing is known of ways home of this flight.")];
  const parts = home.returns.flatMap(returned => [sentence(returnVerdict(returned)), returnFacts(returned), gapTable(home, returned)]);
  if (home.ways.length) parts.push(sentence(waysVerdict(home)), wayTable(home));
  if (home.ways.some(w => w.points && !w.energy)) parts.push(element("p", { class: "soft" }, "Energy is not known: no latest departure is said."));
  parts.push(element("p", { class: "soft" }, "Proved holds for every place where the autopilot may be then: braking, climb, way, descent and landing. " +
    `The thin line is a sketch of one return.${home.returns.length ? " No proof of a return looks at the battery." : ""}`));
  return parts.filter(Boolean);
}

// All flights that have ways home, the smallest share first.
function makeHomeList() {
  if (homes.size < 2) return null;
  const order = [...homes.values()].map(h => [h.share, h]).sort((a, b) => a[0] - b[0]);
  const whole = order.filter(([share]) => share >= 1).length, time = order.reduce((sum, [, h]) => sum + h.duration, 0);
  const held = order.reduce((sum, [share, h]) => sum + share * h.duration, 0);
  const rows = order.slice(0, listedGaps).map(([share, home]) => element("tr", { "data-home": home.id },
    element("td", {}, home.mission ? element("button", { type: "button", class: "link", onclick: () => selection.choose(home.mission) }, home.id) : home.id),
    element("td", { class: share < 1 ? "bad" : "good" }, shareWords(share)),
    element("td", {}, !home.returned || home.returned.action !== "rtl" ? "–" : home.returned.least_height === undefined ? "none" : `${shortMetres(roundedUp(home.returned.least_height))}${thinSpace}m`)));
  selection.follow(() => { for (const row of rows) row.classList.toggle("chosen", Boolean(selection.mission) && row.dataset.home === selection.mission.id); });
  return element("section", {}, element("h2", {}, `${decimals(whole, 0)} of ${count(order.length, "flight")} always have a way home`),
    element("p", { class: "soft" }, `${shareWords(time > 0 ? held / time : 0)} of the time of all.`),
    timeTable(["flight", "time with a way home", "least return height"], rows, order.length));
}

function makeHomePanel() {
  const details = element("div", { class: "home-details" });
  const mark = () => {
    const [, t] = homeNow();
    for (const row of details.querySelectorAll("tr[data-from]")) {
      row.classList.toggle("chosen", t !== null && Number(row.dataset.from) <= t && t <= Number(row.dataset.until));
    }
  };
  selection.follow(() => {
    details.replaceChildren(...(homes.size > 1 && selection.mission ? [element("h2", {}, selection.mission.id)] : []),
      ...homeDetails(homeOf(selection.mission) || (selection.mission ? null : [...homes.values()][0])));
    mark();
  });
  clock.follow(mark);
  return element("div", {}, ...[makeHomeList(), details].filter(Boolean));
}

// What is true now, in a sentence or two.
function homeNowWords() {
  const [home, t] = homeNow();
  if (!home) return "Nothing is known of this flight.";
  if (t === null) return home.motion ? "" : `There is no motion to follow in time.${home.returned ? " Crosses stand at what a return would meet." : ""}`;
  const words = [], gap = home.gapAt(t), way = home.wayAt(t);
  if (home.returned) words.push(gap ? `No return is proved: ${gapWords(gap)}.` : home.kindAt(t) === "proved" ? "The return is proved." : "The report ends before: no return is proved.");
  if (way) {
    words.push(`Planned: to ${way.site}${way.duration === undefined ? "" : `, at most ${withUnit(way.duration, 0, "s")}`}; a way home for ${withUnit(home.left(t), 1, "s")} more.`);
  } else if (home.ways.length) words.push("No planned way home.");
  return `At ${withUnit(t, 1, "s")}: ${words.join(" ")}`;
}
