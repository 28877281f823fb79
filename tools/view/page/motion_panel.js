// Plots of one motion, linked to the time.

class MotionPanel {
  constructor() {
    this.element = element("div");
    this.hover = null;
    this.plots = [];
    this.note = element("p", { class: "cursor-note" });
    this.axis = new TimeAxis();
    this.holder = element("div");
    const select = motions.length > 1 ? choice("Motion that is plotted and followed",
      motions.map((m, i) => [String(i), m.name]), "0", value => this.choose(Number(value))) : null;
    this.numbers = element("div");
    this.frames = meta.frames ? new FrameView(meta.frames) : null;
    this.element.append(...[select, this.numbers, this.frames && this.frames.element, this.note, this.holder,
      this.axis.element].filter(Boolean));
    if (select && this.frames) select.value = String(this.frames.motion);
    this.choose(this.frames ? this.frames.motion : 0);
    new ResizeObserver(() => this.paint()).observe(this.holder);
    theme.follow(() => this.paint());
    clock.follow(() => this.update());
  }

  choose(index) {
    stage.selected = index;
    const motion = motions[index];
    this.numbers.replaceChildren(facts(motionFacts(motion)));
    this.hover = null;
    const on = {
      hover: (time, plot) => { this.hover = time === null ? null : { time, plot }; this.update(); },
      set: time => { this.hover = null; clock.set(time); },
    };
    this.plots = quantities.filter(q => available(q, motion)).map(q => new Plot(q, motion, on));
    this.holder.replaceChildren(...this.plots.map(plot => plot.element));
    this.paint();
    stage.redraw();
  }

  paint() {
    if (!this.holder.clientWidth) return;
    for (const plot of this.plots) plot.paint();
    this.axis.paint();
    this.update();
  }

  update() {
    const shown = this.hover ? this.hover.time : clock.time;
    if (this.frames) this.frames.show(stage.selected, shown);
    for (const plot of this.plots) plot.update(clock.time, shown);
    const words = this.hover ? `At ${withUnit(shown, 2, "s")}, under the pointer`
      : `At ${withUnit(shown, 2, "s")} · dashed: limit${this.plots.some(p => p.motion.joints) ? " · thin uprights: joints of segments" : ""}`;
    if (this.note.textContent !== words) this.note.textContent = words;
  }
}

function motionFacts(motion) {
  const { data } = motion, { summary, vehicle } = data;
  return [
    ["Duration", withUnit(motion.duration, 2, "s")],
    ["Segments", data.segments ? `${decimals(data.segments, 0)}${data.rung ? `, ${data.rung.replaceAll("_", " ")}` : ""}` : null],
    ["Vehicle", vehicle ? `${vehicle.name || "box"}: ${vehicle.half.map(h => decimals(2 * h, 2)).join(" × ")}${thinSpace}m` : null],
    ["Tracking error", summary ? `${metres(summary.error_rms)} RMS, ${metres(summary.error_max)} at most` : null],
    ["Motors saturated", summary ? `${withUnit(summary.saturated * 100, 1, "%")} of ${count(summary.rows, "row")}` : null],
  ];
}
