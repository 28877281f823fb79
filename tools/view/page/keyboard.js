// Keys that work wherever no field has them, and what each does.

function turnOrMove(key, moves) {
  const [x, y] = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] }[key];
  const { orbit } = stage.view;
  if (moves || stage.view.mode === "top") orbit.move(x * orbit.distance * 0.06, y * orbit.distance * 0.06);
  else orbit.turn(x * 0.08, y * 0.06);
  stage.redraw();
}

function zoomBy(factor) {
  stage.view.orbit.zoom(factor);
  stage.redraw();
}

const moving = () => clock.duration > 0;
const arrows = ["ArrowLeft", "ArrowRight", "ArrowUp", "ArrowDown"];

// `on`: the keys it listens to; `shown`: how they are listed; `needs`: when there is such a key; `where`: the element
// that must have the focus; `act`: what it does.
const keys = [
  { on: [" "], shown: ["Space"], words: "play or pause", needs: moving, act: () => clock.toggle() },
  { on: [",", "."], shown: [",", "."], words: "back or ahead by half a second", needs: moving,
    act: e => clock.set(clock.time + (e.key === "," ? -0.5 : 0.5)) },
  { on: ["1"], shown: ["1"], words: "camera: free", act: () => setCamera("free") },
  { on: ["2"], shown: ["2"], words: "camera: from above", act: () => setCamera("top") },
  { on: ["3"], shown: ["3"], words: "camera: follow the vehicle", needs: moving, act: () => setCamera("follow") },
  { on: ["4"], shown: ["4"], words: "camera: ride behind it", needs: moving, act: () => setCamera("ride") },
  { on: ["5"], shown: ["5"], words: "camera: both vehicles of a pair", needs: hasPairs, act: () => setCamera("pair") },
  { on: ["j"], shown: ["J"], words: "the nearest pair of flights, and the next", needs: hasPairs, act: () => jumpToNext() },
  { on: ["g"], shown: ["G"], words: "the next time without a way home; with Shift the one before", needs: hasNone,
    act: e => jumpToNone(e.shiftKey ? -1 : 1) },
  { on: ["n", "p"], shown: ["N", "P"], words: "next or previous mission", needs: () => manyMissions,
    act: e => selection.step(e.key.toLowerCase() === "n" ? 1 : -1) },
  { on: arrows, shown: ["←", "→", "↑", "↓"], words: "turn the view; with Shift move it", where: "view",
    act: e => turnOrMove(e.key, e.shiftKey) },
  { on: ["+", "=", "-"], shown: ["+", "−"], words: "zoom", act: e => zoomBy(e.key === "-" ? 1 / 0.85 : 0.85) },
  { on: ["h"], shown: ["H"], words: "home: the whole map", act: () => goHome() },
  { on: ["d"], shown: ["D"], words: "dark or light", act: () => byId("theme").click() },
  { on: ["escape"], shown: ["Esc"], words: "let go of a box", needs: () => Boolean(stage.picked),
    act: () => { stage.picked.choose(null); stage.redraw(); } },
  { on: ["?"], shown: ["?"], words: "this list", act: () => help.toggle() },
];

function keyFor(e) {
  return keys.find(key => (key.on.includes(e.key) || key.on.includes(e.key.toLowerCase())) &&
    (!key.needs || key.needs()) && (!key.where || e.target === byId(key.where)));
}

function listenToKeys() {
  document.addEventListener("keydown", e => {
    const field = e.target.closest("input, select, textarea, canvas.surface, dialog");
    if (field || e.ctrlKey || e.metaKey || e.altKey) return;
    if (e.key === " " && e.target.closest("button")) return;
    const key = keyFor(e);
    if (!key) return;
    key.act(e);
    e.preventDefault();
  });
}
