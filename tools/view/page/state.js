// What the page shows, for tests and for the curious: window.skyway, read-only.

const problems = [];

function tellProblem(words) {
  problems.push(words);
  const box = byId("problem");
  box.hidden = false;
  box.textContent = words;
}

addEventListener("error", e => tellProblem(`Something went wrong: ${e.message}`));

function exposeState() {
  const motionAt = () => stage.motion();
  const values = () => {
    const out = {};
    const time = motionPanel && motionPanel.hover ? motionPanel.hover.time : clock.time;
    for (const plot of motionPanel ? motionPanel.plots : []) {
      out[plot.quantity.key] = Object.fromEntries(plot.curves.map((curve, k) => [curve.name, plot.at(time)[k]]));
    }
    return out;
  };
  const position = () => {
    const motion = motionAt();
    return motion && motion.vector(motion.position, clock.time).toArray().map((x, i) => x + origin[i]);
  };
  const info = () => (stage.renderer ? stage.renderer.info.render : { calls: 0, triangles: 0 });
  const getters = {
    ready: () => true, problems: () => [...problems], time: () => clock.time, duration: () => clock.duration,
    playing: () => clock.playing, rate: () => clock.rate, camera: () => stage.view.mode, theme: () => theme.current(),
    motion: () => (motionAt() ? motionAt().name : null), boxes: () => (stage.boxes ? stage.boxes.count : 0),
    drawCalls: () => info().calls, triangles: () => info().triangles, frames: () => stage.frames,
    frameMs: () => stage.frameMs,
    trees: () => stage.parts.trees.map(t => ({ id: t.data.id, nodes: t.count, shown: t.shown })),
    hover: () => (motionPanel && motionPanel.hover
      ? { plot: motionPanel.hover.plot.quantity.key, time: motionPanel.hover.time } : null),
    frame: () => (motionPanel && motionPanel.frames && !motionPanel.frames.element.hidden ? motionPanel.frames.index : null),
    values, position, picked: () => (stage.picked ? stage.picked.index : null),
    checks: () => meta.reports.map(r => ({ id: r.id, ok: r.ok, reason: r.reason || null })),
    target: () => stage.view.orbit.target.toArray().map((x, i) => x + origin[i]),
    distance: () => stage.view.orbit.distance, heading: () => stage.view.orbit.heading,
  };
  const state = {};
  for (const [name, get] of Object.entries(getters)) Object.defineProperty(state, name, { get, enumerable: true });
  window.skyway = Object.freeze(state);
}
