// Keys that work wherever no field has them.

const cameraKeys = { 1: "free", 2: "top", 3: "follow", 4: "ride" };

function turnOrMove(key, moves) {
  const [x, y] = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] }[key];
  const { orbit } = stage.view;
  if (moves || stage.view.mode === "top") orbit.move(x * orbit.distance * 0.06, y * orbit.distance * 0.06);
  else orbit.turn(x * 0.08, y * 0.06);
  stage.redraw();
}

function listenToKeys() {
  document.addEventListener("keydown", e => {
    const field = e.target.closest("input, select, textarea, canvas.surface");
    if (field || e.ctrlKey || e.metaKey || e.altKey) return;
    const onButton = e.target.closest("button");
    if (e.key.startsWith("Arrow") && e.target === byId("view")) turnOrMove(e.key, e.shiftKey);
    else if (e.key === " " && !onButton && clock.duration > 0) clock.toggle();
    else if (cameraKeys[e.key] && (motions.length || e.key < "3")) setCamera(cameraKeys[e.key]);
    else if (e.key === "+" || e.key === "=") { stage.view.orbit.zoom(0.85); stage.redraw(); }
    else if (e.key === "-") { stage.view.orbit.zoom(1 / 0.85); stage.redraw(); }
    else if (e.key.toLowerCase() === "h") goHome();
    else if (e.key === "Escape" && stage.picked) { stage.picked.choose(null); stage.redraw(); }
    else return;
    e.preventDefault();
  });
}
