// Puts the page together and keeps it moving.

byId("title").textContent = document.title;
byId("summary").textContent = summaryWords();

const stage = new Stage();
const transport = makeTransport();
const motionPanel = motions.length ? new MotionPanel() : null;
makeLayers();
const tabs = makeTabs([
  ...(together && motions.length > 1 ? [["Summary", makeSummaryPanel()]] : []),
  ...(motionPanel ? [["Motion", motionPanel.element]] : manyMissions ? [["Missions", element("div", {}, makeMissionList())]] : []),
  ...(together && motions.length > 1 ? [["Pairs", makePairsPanel()]] : []),
  ...(homes.size ? [["Ways home", makeHomePanel()]] : []),
  ...(meta.reports.length ? [["Checks", makeChecksPanel()]] : []),
  ["Contents", makeContentsPanel()]]);
if (!together && meta.reports.some(r => !r.ok)) tabs.show(meta.reports.every(r => r.ok || isOfHome(r)) ? "Ways home" : "Checks");
if (together && motions.length > mostAlone) openWhenBusiest();
stage.view.home();  // now that it is known what the cards leave of the view
frameFailure();
listenToKeys();
clock.follow(() => stage.redraw());
exposeState();

let lastFrame = null;
function tick(now) {
  const seconds = lastFrame === null ? 0 : Math.min((now - lastFrame) / 1000, 0.25);
  lastFrame = now;
  clock.advance(seconds);
  for (const tree of stage.parts.trees) tree.advance(seconds);
  stage.draw();
  requestAnimationFrame(tick);
}
requestAnimationFrame(tick);

// Where one flight or mission failed, its place is what the page is opened for.
function frameFailure() {
  const failed = meta.reports.filter(r => !r.ok && r.place);
  if (!together && failed.length) goToFailure(failed[0]);
}

// Else it would open with the first two in the air.
function openWhenBusiest() {
  const { time } = busiest();
  selection.chooseMotion(motions.find(m => m.flies(time)));
  clock.set(time);
}
