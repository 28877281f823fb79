// What the page holds, in numbers.

function section(title, ...children) {
  return element("section", {}, element("h2", {}, title), ...children);
}

function mapFacts() {
  const { map } = meta;
  const size = [0, 1, 2].map(k => decimals(map.max[k] - map.min[k], 0)).join(" × ");
  return facts([
    ["Boxes", decimals(map.boxes, 0)],
    ["There for a time only", map.timed ? `${decimals(map.timed, 0)}, shown and counted as always there` : null],
    ["Bounds", `${size}${thinSpace}m`],
    ["Lower corner", place(...map.min)],
    ["Upper corner", place(...map.max)],
    ["Labels", map.labels.length > 1 ? decimals(map.labels.length - 1, 0) : null],
    ["Axes in the file", map.frame === "enu" ? "east, north, up" : "north, east, up; shown east, north, up"],
    ["Origin", map.latitude === undefined ? null : geographic(map.latitude, map.longitude)],
    ["CRS", map.crs || null],
    ["Hash", map.hash.replace("sha256:", "").slice(0, 16) + "…"],
  ]);
}

function listTable(columns, rows) {
  const shown = rows.slice(0, 100);
  return [element("table", {}, element("thead", {}, element("tr", {}, columns.map(c => element("th", { scope: "col" }, c)))),
    element("tbody", {}, shown.map(cells => element("tr", {}, cells.map(c => element("td", {}, c)))))),
  rows.length > shown.length ? element("p", { class: "soft" }, `and ${decimals(rows.length - shown.length, 0)} more`) : null];
}

function makeContentsPanel() {
  const parts = [];
  if (meta.map) parts.push(section("Map", mapFacts()));
  for (const data of meta.lattices) {
    parts.push(section("Lattice", facts([["Spacing", metres(data.spacing)], ["Neighbours", String(data.connectivity)],
      ["Free nodes", decimals(data.nodes, 0)], ["Free edges", decimals(data.edges, 0)]])));
  }
  for (const data of meta.trees) {
    parts.push(section("Search tree", facts([["Query", data.id], ["Nodes", decimals(data.nodes, 0)]])));
  }
  if (meta.paths.length) {
    parts.push(section("Paths", listTable(["id", "status", "length", "points"], meta.paths.map(p => [p.id,
      p.message ? element("span", { title: p.message }, p.status.replaceAll("_", " ")) : p.status,
      p.points ? metres(p.length) : "–", p.points ? decimals(p.points.count / 3, 0) : "–"]))));
  }
  if (motions.length || meta.unsolved.length) {
    parts.push(section("Motion", listTable(["id", "", "duration"], [
      ...motions.map(m => [m.id, m.word, withUnit(m.duration, 2, "s")]),
      ...meta.unsolved.map(m => [m.id, m.status.replaceAll("_", " "), "–"])])));
  }
  parts.push(element("p", { class: "soft" },
    "Metres, east–north–up. Motion between samples is drawn, not proved; clearances are the least of each step, to 1 mm." +
    (motions.some(m => m.knots) ? " Many trajectories are given by their states at joints, in single precision." : "")));
  return element("div", {}, parts);
}

function summaryWords() {
  const words = [];
  if (meta.map) words.push(count(meta.map.boxes, "box", "boxes"));
  if (meta.trees.length) words.push(count(meta.trees.length, "search tree"));
  if (meta.paths.length) words.push(count(meta.paths.length, pathWord(meta.paths)));
  const flights = motions.filter(m => m.isFlight).length;
  const planned = motions.filter(m => m.word === "planned").length;
  if (planned) words.push(count(planned, "trajectory", "trajectories"));
  if (flights) words.push(count(flights, "flight"));
  const checks = meta.reports.filter(r => !isOfRefused(r) && r.checked !== "flight"), failed = checks.filter(r => !r.ok).length;
  const loose = checks.some(r => r.ok && r.overridden) || (together && together.check && together.check.overridden);
  if (checks.length) words.push(failed && checks.length === 1 ? "the check failed" : failed ? `${decimals(failed, 0)} of ${count(checks.length, "check")} failed`
    : `${count(checks.length, "check")} passed`);
  const simulated = meta.reports.filter(r => r.checked === "flight"), lost = simulated.filter(r => !r.ok).length;
  if (simulated.length) words.push(lost ? `${decimals(lost, 0)} of ${count(simulated.length, "simulation")} failed` : `${count(simulated.length, "simulation")} passed`);
  const returned = [...homes.values()].filter(h => h.returned);
  if (returned.length === 1) words.push(`return proved for ${shareWords(returned[0].returned.share)} of the time`);
  else if (returned.length) words.push(`return proved from every instant of ${decimals(returned.filter(h => !h.returned.gaps.length).length, 0)} of ${count(returned.length, "flight")}`);
  if (together && together.check) words.push(!together.check.refused ? `${count(together.check.pairs, "pair")} proved apart`
    : `${decimals(together.check.refused, 0)} of ${count(together.check.pairs, "pair")} not proved apart`);
  if (loose) words.push("less strict than records say");
  if (together && together.check && together.check.left_out) words.push(`${count(together.check.left_out, "flight")} refused`);
  return words.join(" · ");
}
