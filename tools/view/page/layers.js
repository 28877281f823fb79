// What is drawn, and what its colours mean.

function makeLayers() {
  const card = byId("layers");
  const body = element("div", {}, boxLayer(), roomLayer(), pathLayer(), motionLayer(), tubeLayer(), homeLayer(), checkLayer(),
    stage.parts.corridors.map(corridorLayer),
    stage.parts.trees.map(treeLayer), stage.parts.lattices.map(latticeLayer));
  const fold = element("button", { type: "button", class: "quiet", "aria-expanded": "true",
    onclick: () => setFolded(!body.hidden) });
  const setFolded = folded => {
    body.hidden = folded;
    card.classList.toggle("folded", folded);
    fold.textContent = folded ? "Layers" : "Hide";
    fold.setAttribute("aria-expanded", String(!folded));
    title.hidden = folded;
  };
  const title = element("h2", {}, "Layers");
  card.append(element("div", { class: "card-head" }, title, fold), body);
  setFolded(matchMedia("(max-width: 860px)").matches);
}

// A layer with a switch; `rest` stays where the switch is on.
function layer(name, note, object, rest, shown = true) {
  const inner = element("div", {}, rest);
  const set = on => {
    object.visible = on;
    inner.hidden = !on;
    stage.redraw();
  };
  const box = element("input", { type: "checkbox", checked: shown, onchange: () => set(box.checked) });
  set(shown);
  return element("section", { class: "layer" },
    element("label", { class: "head" }, box, name, element("span", { class: "note" }, note)), inner);
}

function boxLayer() {
  if (!stage.boxes) return null;
  const { boxes } = stage;
  const legend = element("div");
  let shown = boxes.usualColour();
  const show = what => {
    shown = what;
    boxes.colourBy(what);
    legend.replaceChildren(...(what === "label" ? [labelKeys(boxes)] : rampLegend(
      ["var(--low)", "var(--middle)", "var(--high)"], `top ${metres(boxes.lowest + origin[2])}`,
      metres(boxes.highest + origin[2]) + (boxes.cut ? " and more" : ""))));
    stage.redraw();
  };
  const by = element("div", { class: "row" }, element("span", {}, "Colour"), choice("Colour boxes by",
    [["height", "height of the top"], ...(boxes.map.label ? [["label", "label"]] : [])], boxes.usualColour(), show));
  theme.follow(() => show(shown));
  return layer("Obstacles", count(boxes.count, "box", "boxes"), boxes.mesh, [boxes.map.label ? by : null, legend,
    boxes.hasZones ? element("ul", { class: "keys" }, element("li", {}, swatch("var(--zone)"), element("span", {}, "keep-out, seen through"))) : null,
    boxes.map.timed ? element("p", { class: "soft" }, `${count(boxes.map.timed, "box is", "boxes are")} there for a time only, and shown always.`) : null]);
}

function labelKeys(boxes) {
  return element("ul", { class: "keys" }, boxes.labelLegend().map(key => element("li", {}, swatch(seenColour(key.colour).getStyle()),
    element("span", {}, key.name), element("span", { class: "note soft" }, decimals(key.boxes, 0)))));
}

const roomDigits = () => (meta.max[0] - meta.min[0] < 100 ? 1 : 0);

function roomLayer() {
  if (!stage.room) return null;
  return layer("Bounds", [0, 1, 2].map(k => decimals(meta.max[k] - meta.min[k], roomDigits())).join(" × ") + `${thinSpace}m`,
    stage.room.object, []);
}

function pathLayer() {
  const found = meta.paths.filter(p => p.points);
  if (!found.length) return null;
  const key = element("ul", { class: "keys" }, element("li", {}, manyMissions ? null : swatch("var(--path)", "line"),
    element("span", {}, "ring: start; disc: goal")));
  const word = pathWord(found);
  return layer(`${word[0].toUpperCase()}${word.slice(1)}${found.length === 1 ? "" : "s"}`, found.length === 1 ? metres(found[0].length)
    : count(found.length, word), stage.pathGroup, key, !(stage.fleet && found.length > mostAlone));
}

// What a fleet may be coloured by beside the quantities: a value of each flight.
const fleetColours = [["delay", "delay", "s", 1, m => (m.data.delay === undefined ? NaN : m.data.delay)],
  ["nearest", "nearest approach", "m", 1, m => (m.nearest === undefined ? NaN : m.nearest)],
  ["home", "time with a way home", "%", 0, m => (homeOf(m.mission) ? 100 * homeOf(m.mission).share : NaN)]];

function fleetLayer() {
  const { fleet } = stage, legend = element("div");
  const offered = fleetColours.filter(([, , , , value]) => motions.some(m => Number.isFinite(value(m))));
  const colour = element("div", { class: "row" }, element("span", {}, "Colour"), choice("Colour flights by",
    [["", "one a flight"], ...offered.map(([key, words]) => [key, words])], "", key => colourFleet(key, legend)));
  const trails = element("div", { class: "row" }, element("span", {}, "Ways"), choice("How much of the ways is drawn",
    [["20", "trails of 20 s"], ["60", "trails of 60 s"], ["0", "whole"]], String(fleet.trail), value => {
      fleet.trail = Number(value);
      stage.redraw();
    }));
  const flying = element("span", { class: "note" });
  colourFleet("", legend);
  clock.follow(time => {
    const words = `${decimals(motions.filter(m => m.flies(time)).length, 0)} of ${decimals(motions.length, 0)} in the air`;
    if (flying.textContent !== words) flying.textContent = words;
  });
  return layer("Flights", flying, stage.motionGroup, [colour, trails, legend]);
}

function colourFleet(key, legend) {
  const chosen = fleetColours.find(([name]) => name === key), { fleet } = stage;
  if (chosen) {
    const [, , unit, digits, value] = chosen;
    const range = extremesOf(motions.map(value).filter(Number.isFinite));
    fleet.colourBy(value, range);
    legend.replaceChildren(...rampLegend(valueStops, withUnit(range[0], digits, unit), withUnit(range[1], digits, unit)),
      element("p", { class: "soft" }, key === "nearest" ? `Grey: no other within ${metres(together.within)}, or at rest.` : "Grey: not known, or at rest."));
  } else {
    fleet.colourBy(null);
    legend.replaceChildren(element("p", { class: "soft" }, "Eight colours take turns; grey: at rest."));
  }
  legend.append(element("p", { class: "soft" }, "Vehicles are enlarged from afar."));
  stage.redraw();
}

function motionLayer() {
  if (!motions.length) return null;
  if (stage.fleet) return fleetLayer();
  const legend = element("div");
  const offered = quantities.filter(q => q.key !== "position" && q.key !== "motors" &&
    motions.some(m => available(q, m)));
  const row = element("div", { class: "row" }, element("span", {}, "Colour"), choice("Colour motion by",
    [["", "plain"], ...(homes.size ? [["home", "way home"]] : []), ...offered.map(q => [q.key, q.name.split(",")[0].toLowerCase()])],
    homes.size ? "home" : "", key => colourMotions(key, legend)));
  colourMotions(homes.size ? "home" : "", legend);
  return layer("Motion", motionWords(), stage.motionGroup, [row, legend]);
}

// "2 trajectories", or "1 planned, 1 flown"
function motionWords() {
  const of = word => motions.filter(m => m.word === word).length;
  const kinds = ["planned", "flown", "estimated"].filter(word => of(word));
  if (kinds.length > 1) return kinds.map(word => `${of(word)} ${word}`).join(", ");
  return { planned: n => count(n, "trajectory", "trajectories"), flown: n => count(n, "flight"), estimated: n => count(n, "mission") }[kinds[0]](motions.length);
}

// `key`: of a quantity, "home" for ways home, or "" for plain colours.
function colourMotions(key, legend) {
  const quantity = quantities.find(q => q.key === key), plain = () => (manyMissions ? missionKeys() : motionKeys());
  if (stage.homeLines) stage.homeLines.setMode(key, stage.parts.ribbons);
  const able = motions.filter(m => quantity && available(quantity, m));
  let low = Infinity, high = -Infinity;
  for (const m of able) {
    const [a, b] = extremesOf(mainCurve(quantity, m));
    low = Math.min(low, a);
    high = Math.max(high, b);
  }
  for (const ribbon of stage.parts.ribbons) {
    const on = able.includes(ribbon.motion);
    ribbon.colourBy(on ? mainCurve(quantity, ribbon.motion) : null, low, high);
  }
  legend.replaceChildren(...(able.length ? rampLegend(valueStops, withUnit(low, quantity.digits, quantity.unit),
    withUnit(high, quantity.digits, quantity.unit)) : [key === "home" ? homeKeys(homeKinds()) : plain()]));
  if (key === "left") legend.append(homeKeys(["none"]));
  legend.append(element("p", { class: "soft" }, "The vehicle is enlarged from afar."));
  stage.redraw();
}

function motionKeys() {
  const keys = [];
  const others = [...new Set(motions.filter(m => !m.isFlight).map(m => m.word))];
  if (others.length) keys.push(["--motion", others.join(", ")]);
  if (motions.some(m => m.isFlight)) keys.push(["--flown", "flown"]);
  return element("ul", { class: "keys" }, keys.map(([colour, words]) =>
    element("li", {}, swatch(`var(${colour})`, "line"), element("span", {}, words))));
}

function missionKeys() {
  const both = motions.some(m => m.isFlight) && motions.some(m => !m.isFlight);
  return element("p", { class: "soft" }, `One colour for each mission, as in the list${both ? "; flown: the darker line" : ""}.`);
}

function homeKeys(kinds) {
  return element("ul", { class: "keys" }, kinds.map(kind => element("li", {}, swatch(`var(--${homeColours[kind]})`, kind === "none" ? "line dashed" : "line"),
    element("span", {}, homeWords[kind]))));
}

// What is drawn from the vehicle, and what it means now.
function homeLayer() {
  if (!homes.size) return null;
  const now = element("p", { class: "soft home-now" });
  const say = () => {
    const words = homeNowWords();
    if (now.textContent !== words) now.textContent = words;
  };
  clock.follow(say);
  selection.follow(say);
  const kinds = homeKinds(), keys = [...(kinds.includes("proved") ? [["proved", "line", "autopilot's return"]] : []),
    ...(kinds.includes("planned") ? [["planned", "line", "planned way home"]] : []),
    ...(kinds.includes("proved") ? [["none", "line dashed", "return, not proved"]] : [])];
  const all = [...homes.values()], share = all.reduce((sum, h) => sum + h.share * h.duration, 0) / Math.max(all.reduce((sum, h) => sum + h.duration, 0), 1e-9);
  return layer("Ways home", shareWords(share), stage.homeWay.object, [element("ul", { class: "keys" }, keys.map(([kind, look, words]) =>
    element("li", {}, swatch(`var(--${homeColours[kind]})`, look), element("span", {}, words))),
  element("li", {}, element("b", { class: "swatch-h" }, "H"), element("span", {}, "where it lands"))), now]);
}

// Where the simulated vehicles may be: what is proved is never mixed up with statistics.
function tubeLayer() {
  const { tubes } = stage.parts;
  if (!tubes.length) return null;
  const proved = tubes.filter(t => t.proved), others = tubes.filter(t => !t.proved);
  const widest = list => `${decimals(1000 * Math.max(...list.map(t => t.largest)), 1)}${thinSpace}mm at most`;
  const key = (list, colour, words) => (list.length ? element("li", {}, swatch(`var(--${colour})`),
    element("span", {}, words), element("span", { class: "note soft" }, widest(list))) : null);
  const said = [...new Set(tubes.map(t => t.data.words.replace(/^[^,]*, /, "")))].slice(0, 3);
  return layer(tubes.length === 1 ? "Tube" : "Tubes", proved.length === tubes.length ? "proved" : others.length === tubes.length
    ? "statistics" : `${proved.length} proved, ${others.length} statistics`, stage.tubeGroup, [
    element("ul", { class: "keys" }, key(proved, "good", "proved"), key(others, "fourth", "statistics, not proved")),
    ...said.map(words => element("p", { class: "soft" }, `${words[0].toUpperCase()}${words.slice(1)}.`)),
    element("p", { class: "soft" }, "Around the vehicle's reference point, to scale.")]);
}

function checkLayer() {
  const placed = meta.reports.filter(r => !r.ok && r.place);
  if (!placed.length) return null;
  return layer("Failed checks", count(placed.length, "place"), stage.checkGroup,
    element("ul", { class: "keys" }, element("li", {}, swatch("var(--bad)"), element("span", {}, "worst violation"))));
}

function treeLayer(tree) {
  const words = element("span", { class: "note soft" });
  const show = nodes => {
    tree.show(nodes);
    words.textContent = decimals(tree.shown, 0);
    range.value = tree.shown;
    stage.redraw();
  };
  const range = slider(`Nodes of search tree ${tree.data.id}, in order of insertion`, 1, tree.count, 1, tree.count, show);
  const grow = element("button", { type: "button", class: "grow", onclick: () => {
    tree.growing = !tree.growing;
    if (tree.growing && tree.shown >= tree.count) show(1);
  } }, "Grow");
  tree.advance = seconds => {  // the whole tree in about eight seconds
    if (!tree.growing) return;
    tree.exact = (tree.shown <= 1 ? 1 : tree.exact ?? tree.shown) + Math.max(tree.count * seconds / 8, 0.2);
    show(Math.floor(tree.exact));
    if (tree.shown >= tree.count) { tree.growing = false; tree.exact = null; }
    grow.textContent = tree.growing ? "Stop" : "Grow";
  };
  show(tree.count);
  const keys = [["--tree-0", "from the start"], ...(tree.goalTree() ? [["--tree-1", "from the goal"]] : [])];
  return layer("Search tree", count(tree.count, "node"), tree.object, [
    element("div", { class: "row" }, grow, range, words),
    element("ul", { class: "keys" }, keys.map(([colour, name]) => element("li", {}, swatch(`var(${colour})`, "line"),
      element("span", {}, name))))]);
}

function corridorLayer(corridor) {
  const words = element("span", { class: "note soft" });
  const show = piece => {
    corridor.show(piece);
    words.textContent = piece ? `${piece} of ${corridor.pieces}` : "all";
    stage.redraw();
  };
  show(0);
  return layer("Corridor", count(corridor.pieces, "region"), corridor.object,
    element("div", { class: "row" }, element("span", {}, "Region"),
      slider(`Region of corridor ${corridor.data.id}; 0 shows all`, 0, corridor.pieces, 1, 0, show), words));
}

function latticeLayer(lattice) {
  const words = element("span", { class: "note soft" });
  const show = level => {
    lattice.show(level);
    words.textContent = metres(lattice.heightOf(level));
    stage.redraw();
  };
  const first = Math.min(1, lattice.levels - 1);
  show(first);
  return layer("Lattice", `${metres(lattice.data.spacing)}, ${lattice.data.connectivity} ways`, lattice.object,
    element("div", { class: "row" }, element("span", {}, "Level"),
      slider("Level of the lattice that is shown", 0, lattice.levels - 1, 1, first, show), words), false);
}
