// Play, scrub and speed of the time, and which camera.

function makeTransport() {
  const bar = byId("transport");
  const cameras = buttonGroup("Camera", motions.length ? cameraModes : cameraModes.slice(0, 2), "free", setCamera);
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
  const rates = choice("Speed of play", [["0.25", "¼×"], ["0.5", "½×"], ["1", "1×"], ["2", "2×"], ["5", "5×"],
    ["10", "10×"]], "1", value => clock.setRate(Number(value)));
  clock.follow(time => {
    const words = clock.playing ? "Pause" : "Play";
    if (play.textContent !== words) play.textContent = words;
    scrub.value = time;
    scrub.setAttribute("aria-valuetext", `${time.toFixed(1)} seconds`);
    now.textContent = `${decimals(time, 2)} / ${withUnit(clock.duration, 2, "s")}`;
  });
  return [play, element("div", { class: "scrub" }, scrub, now), rates];
}

function setCamera(mode) {
  stage.look(mode);
  transport.cameras.choose(mode);
}

function goHome() {
  setCamera("free");
  stage.view.home();
  stage.redraw();
}
