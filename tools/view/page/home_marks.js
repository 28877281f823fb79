// Below the bar of the time: when the flight that is looked at has which way home.

function makeHomeMarks() {
  const marks = element("div", { class: "home-marks", role: "img" });
  const fill = () => {
    const home = homeOf(selection.mission), { motion } = selection;
    const known = home && motion && clock.duration > 0;
    marks.hidden = !known;
    if (!known) return;
    const share = t => 100 * (motion.begin + Math.min(t, motion.duration)) / clock.duration;
    marks.setAttribute("aria-label", home.none().length ? `No way home: ${home.none().map(spanWords).join(", ")}` : "A way home from every instant");
    marks.replaceChildren(...home.parts.map(part => element("span", { class: part.kind, title: `${spanWords(part)}: ${homeWords[part.kind]}`,
      style: `left:${share(part.from)}%;width:${share(part.until) - share(part.from)}%` })));
  };
  selection.follow(fill);
  return marks;
}

// To the next time without a way home, or the one before.
function jumpToNone(step) {
  const [home] = homeNow(), { motion } = selection, none = home ? home.none() : [];
  if (!none.length || !motion) return;
  const now = clock.time - motion.begin, begins = none.map(p => p.from);
  const next = step > 0 ? begins.find(t => t > now + 1e-3) : begins.filter(t => t < now - 1e-3).pop();
  clock.play(false);
  clock.set(motion.begin + (next ?? begins[step > 0 ? 0 : begins.length - 1]));
}

const hasNone = () => [...homes.values()].some(h => h.motion && h.none().length);
