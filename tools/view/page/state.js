// What the page shows, for tests and for the curious: window.skyway, read-only.

const problems = [];

function tellProblem(words) {
  problems.push(words);
  const box = byId("problem");
  box.hidden = false;
  box.textContent = words;
}

addEventListener("error", e => tellProblem(`Something went wrong: ${e.message}`));

// How a mission is told apart from the others, and where on the page a point of its line is.
function missionState(mission) {
  const line = stage.parts.lines.find(l => l.mission === mission);
  const middle = line && new THREE.Vector3().fromArray(line.points, 3 * Math.floor(line.points.length / 6));
  const box = stage.surface.getBoundingClientRect(), at = middle && middle.clone().project(stage.view.camera);
  const label = stage.labels.labels.find(l => l.mission === mission);
  return { id: mission.id, colour: theme.css(mission.colour), pattern: mission.pattern,
    label: Boolean(label && label.element.style.visibility === "visible"),
    at: at ? [box.left + (at.x + 1) / 2 * box.width, box.top + (1 - at.y) / 2 * box.height] : null };
}

// Whether no box stands between the camera and the vehicle that is followed.
function seesVehicle() {
  const { motion } = selection;
  const at = motion && motion.place(clock.time);
  return Boolean(at) && !stage.hidden(stage.view.camera.position, at);
}

// The ways home that are drawn now, in metres of the map.
function homeState() {
  const [home, t] = homeNow();
  if (!home || !stage.homeWay) return null;
  const metresOf = points => points && Array.from(points, (x, i) => x + origin[i % 3]);
  const { proved, planned, none } = stage.homeWay.shown;
  return { id: home.id, time: t, kind: t === null ? null : home.kindAt(t), left: t === null ? null : home.left(t), words: homeNowWords(), drawn: stage.homeWay.time,
    proved: metresOf(proved), planned: metresOf(planned), none: metresOf(none) };
}

function exposeState() {
  const values = () => {
    const out = {};
    const time = motionPanel && motionPanel.hover ? motionPanel.hover.time : motionPanel && plotSpan.local();
    for (const plot of motionPanel ? motionPanel.plots : []) {
      out[plot.quantity.key] = Object.fromEntries(plot.curves.map((curve, k) => [curve.name, plot.at(time)[k]]));
    }
    return out;
  };
  const position = () => {
    const { motion } = selection;
    return motion && motion.place(clock.time).toArray().map((x, i) => x + origin[i]);
  };
  const info = () => (stage.renderer ? stage.renderer.info.render : { calls: 0, triangles: 0 });
  const getters = {
    ready: () => true, problems: () => [...problems], time: () => clock.time, duration: () => clock.duration,
    playing: () => clock.playing, rate: () => clock.rate, camera: () => stage.view.mode, theme: () => theme.current(),
    motion: () => (selection.motion ? selection.motion.name : null), boxes: () => (stage.boxes ? stage.boxes.count : 0),
    mission: () => (selection.mission ? selection.mission.id : null), missions: () => missions.map(missionState),
    fleet: () => (stage.fleet ? stage.fleet.state() : null),
    pair: () => selection.pair && { ids: selection.pair.of.map(i => motions[i].id), time: selection.pair.time,
      distance: selection.pair.distance, now: stage.pairLine.distance },
    buildings: () => (stage.boxes ? stage.boxes.buildings : 0), seen: () => seesVehicle(),
    boxTraits: () => (stage.boxes ? [...stage.boxes.traits] : []),
    pickedCorners: () => (stage.picked && stage.picked.index !== null
      ? [...stage.boxes.corners.subarray(6 * stage.picked.index, 6 * stage.picked.index + 6)] : null),
    unpack: () => inflated, seenContrast: () => css => contrastOf(seenColour(css), theme.colour("ground")),
    drawn: () => (stage.boxes ? stage.boxes.parts.map(part => part.count) : []),  // boxes themselves, and blocks for afar
    drawCalls: () => info().calls, triangles: () => info().triangles, frames: () => stage.frames,
    frameMs: () => stage.frameMs,
    trees: () => stage.parts.trees.map(t => ({ id: t.data.id, nodes: t.count, shown: t.shown })),
    homes: () => [...homes.values()].map(h => ({ id: h.id, share: h.share, parts: h.parts.map(p => ({ ...p })) })),
    home: () => homeState(), hover: () => (motionPanel && motionPanel.hover
      ? { plot: motionPanel.hover.plot.quantity.key, time: motionPanel.hover.time } : null),
    frame: () => (motionPanel && motionPanel.frames && !motionPanel.frames.element.hidden ? motionPanel.frames.index : null),
    values, position, picked: () => (stage.picked ? stage.picked.index : null),
    checks: () => meta.reports.map(r => ({ id: r.id, ok: r.ok, reason: r.reason || null })),
    target: () => stage.view.orbit.target.toArray().map((x, i) => x + origin[i]),
    distance: () => stage.view.orbit.distance, heading: () => stage.view.orbit.heading,
    elevation: () => stage.view.orbit.elevation,
  };
  const state = {};
  for (const [name, get] of Object.entries(getters)) Object.defineProperty(state, name, { get, enumerable: true });
  window.skyway = Object.freeze(state);
}
