// What the reports say: verdict, place and time of a failure, extremes beside their limits.

const extremeRows = {
  clearance: ["Clearance, least", "m", 3, null], speed: ["Speed", "m/s", 2, "vmax"],
  horizontal_speed: ["Speed over ground", "m/s", 2, "vmax_h"], vertical_speed: ["Speed up or down", "m/s", 2, "vmax_v"],
  acceleration: ["Acceleration", "m/s²", 2, "amax"], jerk: ["Jerk", "m/s³", 2, "jmax"],
  body_rate: ["Body rate", "rad/s", 2, "body_rate"], yaw_rate: ["Yaw rate", "rad/s", 2, "yaw_rate"],
  tilt: ["Tilt", "°", 1, "tilt"], rms: ["Tracking error, RMS", "m", 3, null], p99: ["… 99th percentile", "m", 3, null],
  max: ["… largest", "m", 3, null], final: ["… at the end", "m", 3, null], thrust: ["Thrust over mass", "m/s²", 2, "thrust"],
};

// A quantity without a row of its own is shown under its name.
const rowOf = name => extremeRows[name] || [name.replaceAll("_", " "), "", 2, name];

const reasons = { collision: "collides with an obstacle", bounds: "leaves the bounds", no_path: "there is no path",
  speed: "too fast", acceleration: "accelerates too much", jerk: "jerks too much", tilt: "tilts too far",
  fence: "breaks a fence", takeoff: "would begin inside the ground", return: "returns by a way that is not known",
  takeoff_ground: "takes off in the air", discontinuous: "segments do not meet", duration_bound: "claims a bound on its duration that cannot be", duration: "has no valid duration", exact: "refused by the exact check" };

// Refused for its ways home alone.
function isOfHome(check) { return check.checked === "contingency" || (check.reason === "return" && Boolean(check.return) && !check.place); }

// Of the check against the map, not of a simulation or of planned ways home.
function isOfMap(check) { return ["trajectory", "path", "flight log"].includes(check.checked); }

// What is said where accepted records were held to less than they ask for; may be empty.
function looseWords(checks) {
  const loose = checks.filter(c => c.ok && c.overridden).length;
  return loose ? ` ${loose === checks.length ? "" : `Of ${decimals(loose, 0)} of them, `}${loose === checks.length ? "V" : "v"}ehicle, margin, limits or map were taken as less strict than ${loose === 1 ? "the record says" : "the records say"}.` : "";
}

const checkedWords = { contingency: "planned ways home", flight: "simulated flight" };

function whyOf(check) {
  if (check.checked === "contingency") return check.detail || "not every instant has a planned way home";
  return isOfHome(check) ? "a return is not proved from every instant (Ways home)" : reasons[check.reason] || check.reason;
}

function worstOf(check) {
  const lengths = ["collision", "bounds", "discontinuous", "fence", "takeoff", "takeoff_ground"];
  if (check.worst === undefined) return null;
  if (lengths.includes(check.reason)) return metres(check.worst);
  const row = extremeRows[check.reason];
  return row ? withUnit(row[1] === "°" ? check.worst * degrees : check.worst, row[2], row[1]) : decimals(check.worst, 3);
}

function checkTable(check) {
  const rows = check.extremes.map(({ name, value, time }) => {
    const [words, unit, digits, limit] = rowOf(name);
    const scale = unit === "°" ? degrees : 1;
    const bound = limit && check.limits[limit] ? withUnit(check.limits[limit] * scale, digits, unit) : "";
    return element("tr", {}, element("td", {}, words), element("td", {}, withUnit(value * scale, digits, unit)),
      element("td", {}, bound), element("td", {}, time === undefined || check.checked === "path" ? "" : withUnit(time, 2, "s")));
  });
  if (!rows.length) return null;
  return element("table", {}, element("thead", {}, element("tr", {}, ["", "extreme", "limit", "at"].map(
    words => element("th", { scope: "col" }, words)))), element("tbody", {}, rows));
}

// When or where on the way: a mission's item says it already, and a path has legs.
function whenOf(check) {
  if (check.time === undefined || isMission(check)) return ["", null];
  if (check.checked !== "path") return ["Time", withUnit(check.time, 3, "s")];
  const leg = Math.floor(check.time);
  return ["Leg", `from point ${decimals(leg, 0)} to ${decimals(leg + 1, 0)}, counted from 0`];
}

// A drone's mission has items; what was checked of it are its legs.
function isMission(check) { return check.item !== undefined; }

// From near enough to see what is hit, in a room as in a city.
function goToFailure(check) {
  stage.goTo(check.place, Math.min(60, 0.6 * stage.view.extent().across));
  if (stage.picked) stage.picked.choose(stage.boxes.withId(check.box));
  transport.cameras.choose("free");
  const motion = motions.find(m => m.id === check.id);
  if (check.checked !== "path" && check.time !== undefined && clock.duration > 0) {
    if (motion) selection.chooseMotion(motion);
    clock.play(false);
    clock.set(check.time + (motion ? motion.begin : 0));
  }
}

function checkCard(check) {
  const words = check.ok ? "Passed" : "Failed";
  const where = !check.ok && check.place ? facts([
    ["Why", whyOf(check)],
    ["By", worstOf(check)],
    ["Item", check.item === undefined ? null : `${check.item}${check.part ? ` (${check.part})` : ""}`],
    ["That is", check.detail || null],
    [...whenOf(check)],
    ["Place", place(...check.place.map((x, i) => x + origin[i]))],
    ["Obstacle, id in the source", check.box === undefined ? null : String(check.box)],
  ]) : check.ok ? null : element("p", {}, whyOf(check));
  return element("article", { class: `check ${check.ok ? "ok" : "failed"}` },
    element("h3", {}, check.id, element("span", { class: `verdict ${check.ok ? "good" : "bad"}` },
      `${check.ok ? "✓" : "✕"} ${words}`)),
    element("p", { class: "soft" }, [isMission(check) ? "mission" : checkedWords[check.checked] || check.checked || "record", check.duration ? `, ${withUnit(check.duration, 2, "s")}` : "",
      check.slower ? `, ${check.slower} (if no path is shorter than the record claims)` : "",
      check.exact === undefined ? "" : `; exact check ${check.exact ? "passed" : "failed"}`].join("")),
    check.ok && check.rests ? element("p", { class: `rests${check.overridden ? " bad" : ""}` }, `${check.rests[0].toUpperCase()}${check.rests.slice(1)}.`) : null,
    where, checkTable(check),
    !check.ok && check.place ? element("button", { type: "button", onclick: () => goToFailure(check) }, "Show the place") : null);
}

function makeChecksPanel() {
  const order = meta.reports.filter(r => !isOfRefused(r)).sort((a, b) => a.ok - b.ok);
  const failed = order.filter(r => !r.ok).length, what = order.every(r => r.checked !== "flight") ? "check" : order.every(r => r.checked === "flight") ? "simulation" : "report";
  return element("div", {}, order.length ? sentence(failed ? ["bad", "✕", order.length === 1 ? `The ${what} failed`
    : `${decimals(failed, 0)} of ${count(order.length, what)} failed`] : ["good", "✓", (order.length === 1 ? `The ${what} passed.` : `All ${count(order.length, what)} passed.`) + looseWords(order)]) : null, refusedNote(), order.slice(0, 200).map(checkCard),
  order.length > 200 ? element("p", { class: "soft" }, `and ${decimals(order.length - 200, 0)} more that passed`) : null);
}
