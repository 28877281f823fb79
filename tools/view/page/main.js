// Puts the page together and keeps it moving.

byId("title").textContent = document.title;
byId("summary").textContent = summaryWords();

const stage = new Stage();
const transport = makeTransport();
const motionPanel = motions.length ? new MotionPanel() : null;
makeLayers();
const tabs = makeTabs([
  ...(motionPanel ? [["Motion", motionPanel.element]] : manyMissions ? [["Missions", element("div", {}, makeMissionList())]] : []),
  ...(together && motions.length > 1 ? [["Pairs", makePairsPanel()]] : []),
  ...(meta.reports.length ? [["Checks", makeChecksPanel()]] : []),
  ["Contents", makeContentsPanel()]]);
if (together && together.check && !together.check.ok) tabs.show("Pairs");
if (meta.reports.some(r => !r.ok)) tabs.show("Checks");
stage.view.home();  // now that it is known what the cards leave of the view
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
