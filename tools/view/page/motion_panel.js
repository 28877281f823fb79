// Numbers and plots of the motion that is looked at, linked to the time.

class MotionPanel {
  constructor() {
    this.element = element("div");
    this.hover = null;
    this.plots = [];
    this.note = element("p", { class: "cursor-note" });
    this.axis = new TimeAxis();
    this.holder = element("div");
    this.kinds = element("div", { class: "kinds" });
    this.numbers = element("div");
    this.frames = meta.frames ? new FrameView(meta.frames) : null;
    this.element.append(...[manyMissions ? makeMissionList() : null, this.kinds, this.numbers,
      this.frames && this.frames.element, this.note, this.holder, this.axis.element].filter(Boolean));
    if (this.frames) selection.chooseMotion(motions[this.frames.motion]);
    selection.follow(() => this.show(selection.mission, selection.motion));
    new ResizeObserver(() => this.paint()).observe(this.holder);
    theme.follow(() => this.paint());
    clock.follow(() => this.update());
  }

  show(mission, motion) {
    this.kinds.replaceChildren(...(mission.motions.length > 1 ? [this.kindsOf(mission, motion)] : []));
    this.numbers.replaceChildren(motion ? facts(motionFacts(motion)) : element("p", { class: "soft" },
      `No motion: ${(mission.failure || "only a path").replaceAll("_", " ")}`));
    this.hover = null;
    plotSpan.of(motion);
    const on = {
      hover: (time, plot) => { this.hover = time === null ? null : { time, plot }; this.update(); },
      set: time => { this.hover = null; clock.set(plotSpan.begin + time); },
    };
    this.plots = motion ? quantities.filter(q => available(q, motion)).map(q => new Plot(q, motion, on)) : [];
    this.holder.replaceChildren(...this.plots.map(plot => plot.element));
    this.axis.element.hidden = !motion;
    this.paint();
    stage.redraw();
  }

  // Planned or flown: the mission's motions as buttons.
  kindsOf(mission, motion) {
    const twice = flown => mission.motions.filter(m => m.isFlight === flown).length > 1;
    const words = (m, i) => m.word[0].toUpperCase() + m.word.slice(1) + (twice(m.isFlight) ? ` ${i + 1}` : "");
    return buttonGroup("Motion that is plotted and followed", mission.motions.map((m, i) => [String(i), words(m, i)]),
      String(mission.motions.indexOf(motion)), value => selection.chooseMotion(mission.motions[Number(value)])).element;
  }

  paint() {
    if (!this.holder.clientWidth) return;
    for (const plot of this.plots) plot.paint();
    this.axis.paint();
    this.update();
  }

  update() {
    const now = plotSpan.local(), shown = this.hover ? this.hover.time : now;
    if (this.frames) this.frames.show(motions.indexOf(selection.motion), shown);
    for (const plot of this.plots) plot.update(now, shown);
    const words = this.hover ? `At ${withUnit(shown, 2, "s")}, under the pointer`
      : `At ${withUnit(shown, 2, "s")} · dashed: limit${this.plots.some(p => p.motion.joints) ? " · thin uprights: joints of segments" : ""}${this.plots.some(p => p.none().length) ? " · shaded: no way home" : ""}`;
    if (this.note.textContent !== words) this.note.textContent = words;
  }
}

function motionFacts(motion) {
  const { data } = motion, { summary, vehicle } = data;
  return [
    ["Departure", together ? clockWords(motion.begin, 1) + (together.epoch ? "" : `${thinSpace}s`) : null],
    ["Delay", data.delay === undefined ? null : withUnit(data.delay, 1, "s")],
    ["Nearest to another flight", together && Number.isFinite(motion.nearest) ? apartWords(motion.apart) : null],
    ["Duration", withUnit(motion.duration, 2, "s")],
    ["Beside the fastest", data.slower || null],
    ["Segments", data.segments ? `${decimals(data.segments, 0)}${data.rung ? `, ${data.rung.replaceAll("_", " ")}` : ""}` : null],
    ["Vehicle", vehicle ? `${vehicle.name || "box"}: ${vehicle.half.map(h => decimals(2 * h, 2)).join(" × ")}${thinSpace}m` : null],
    ["Tracking error", summary && summary.error_rms !== undefined ? `${metres(summary.error_rms)} RMS, ${metres(summary.error_max)} at most` : null],
    ["Motors saturated", summary && summary.saturated !== undefined ? `${withUnit(summary.saturated * 100, 1, "%")} of ${count(summary.rows, "row")}` : null],
  ];
}
