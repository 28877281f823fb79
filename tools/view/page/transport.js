// Play, scrub and speed of the time, and which camera.

function makeTransport() {
  const bar = byId("transport");
  const cameras = buttonGroup("Camera", availableCameras(), "free", setCamera);
  const home = element("button", { type: "button", title: "the whole map (H)", onclick: goHome }, "Home");
  if (clock.duration > 0) bar.append(...timeControls());
  bar.append(element("span", { class: "row" }, cameras.element, " ", home));
  return { cameras };
}

function timeControls() {
  const play = element("button", { type: "button", class: "play main", id: "play", onclick: () => clock.toggle() });
  const scrub = slider("Time, seconds", 0, clock.duration, "any", 0, value => clock.set(value));
  scrub.id = "scrub";
  const now = element("output", { class: "clock", for: "scrub" });
  const fast = clock.duration > 300 ? [["30", "30×"], ["60", "60×"], ["120", "120×"]] : [];
  const rates = choice("Speed of play", [["0.25", "¼×"], ["0.5", "½×"], ["1", "1×"], ["2", "2×"], ["5", "5×"],
    ["10", "10×"], ...fast], "1", value => clock.setRate(Number(value)));
  clock.follow(time => {
    const words = clock.playing ? "Pause" : "Play";
    if (play.textContent !== words) play.textContent = words;
    scrub.value = time;
    scrub.setAttribute("aria-valuetext", `${time.toFixed(1)} seconds`);
    now.textContent = together && together.epoch ? clockWords(time)
      : `${clockWords(time)} / ${withUnit(clock.duration + (together ? together.begin : 0), 2, "s")}`;
  });
  return [play, element("div", { class: "scrub" }, homes.size ? element("div", { class: "scrub-track" }, scrub, makeHomeMarks()) : scrub, now), rates];
}

function availableCameras() {
  return cameraModes.filter(([mode]) => mode === "free" || mode === "top" || (mode === "pair" ? hasPairs() : motions.length));
}

function setCamera(mode) {
  if (mode === "pair" && !selection.pair) selection.choosePair(together.pairs[0]);
  stage.look(mode);
  transport.cameras.choose(mode);
}

function goHome() {
  setCamera("free");
  stage.view.home();
  stage.redraw();
}
