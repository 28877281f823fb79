// A plot over time on a canvas: curves, limits, joints of segments, the cursor. Drawn once, then
// copied under the moving cursor.

const plotHeight = 84, plotLeft = 46, plotRight = 6, plotTop = 6, plotBottom = 6;

function fitCanvas(canvas, height) {
  const ratio = Math.min(window.devicePixelRatio || 1, 3), width = canvas.clientWidth || 360;
  canvas.width = Math.round(width * ratio);
  canvas.height = Math.round(height * ratio);
  canvas.style.height = `${height}px`;
  const c = canvas.getContext("2d");
  c.setTransform(ratio, 0, 0, ratio, 0, 0);
  c.font = `11px ${getComputedStyle(document.body).fontFamily}`;
  return { c, width };
}

// What the plots show: all the time there is or, where flights begin at times of their own, one flight from its departure
// on. Plots count from there.
const plotSpan = {
  begin: 0, duration: clock.duration,
  of(motion) {
    this.begin = together && motion ? motion.begin : 0;
    this.duration = together && motion ? motion.duration : clock.duration;
  },
  local() { return Math.min(Math.max(clock.time - this.begin, 0), this.duration); },
};

function timeToX(t, width) {
  return plotLeft + (width - plotLeft - plotRight) * (plotSpan.duration ? t / plotSpan.duration : 0);
}

function xToTime(x, width) {
  return Math.min(Math.max((x - plotLeft) / (width - plotLeft - plotRight), 0), 1) * plotSpan.duration;
}

class Plot {
  // `on`: hover(time or null, plot), set(time).
  constructor(quantity, motion, on) {
    this.quantity = quantity;
    this.motion = motion;
    this.curves = quantity.curves(motion);
    this.limit = limitOf(quantity, motion);
    this.range();
    this.surface = element("canvas", { class: "surface", tabindex: "0", role: "slider",
      "aria-label": `${quantity.name} over time; moves the time`, "aria-valuemin": "0",
      "aria-valuemax": plotSpan.duration.toFixed(2) });
    this.values = this.curves.map(() => element("span"));
    this.element = element("div", { class: "plot", "data-plot": quantity.key }, this.head(), this.surface);
    this.base = document.createElement("canvas");
    this.listen(on);
  }

  head() {
    const names = this.curves.map((curve, k) => element("span", { title: curve.name },
      this.curves.length > 1 ? [swatch(`var(--${curve.colour})`), ` ${curve.short || curve.name} `] : "",
      this.values[k]));
    const { name, unit } = this.quantity;
    return element("div", { class: "plot-head" }, element("span", { class: "name" }, name),
      element("span", { class: "soft" }, unit), element("span", { class: "values" }, names));
  }

  range() {
    let low = Infinity, high = -Infinity;
    for (const curve of this.curves) {
      const [a, b] = extremesOf(curve.values);
      low = Math.min(low, a);
      high = Math.max(high, b);
    }
    const fromZero = this.quantity.key !== "position" && this.quantity.key !== "height";
    if (fromZero) { low = Math.min(low, 0); high = Math.max(high, 0); }
    if (this.limit !== null) high = Math.max(high, this.limit);
    high = Math.max(high, low + 5 / 10 ** this.quantity.digits);  // less than digits show is flat
    const room = (high - low) * 0.06;
    this.low = low - (fromZero && low === 0 ? 0 : room);
    this.high = high + room;
  }

  y(value) {
    return plotTop + (plotHeight - plotTop - plotBottom) * (1 - (value - this.low) / (this.high - this.low));
  }

  paint() {
    const { c, width } = fitCanvas(this.surface, plotHeight);
    this.width = width;
    this.paintGrid(c, width);
    this.curves.forEach(curve => this.paintCurve(c, width, curve));
    if (this.limit !== null) this.paintLimit(c, width);
    this.base.width = this.surface.width;
    this.base.height = this.surface.height;
    this.base.getContext("2d").drawImage(this.surface, 0, 0);
  }

  paintGrid(c, width) {
    let marks = ticks(this.low, this.high, 3.6);
    if (marks.length < 2) marks = ticks(this.low, this.high, 6);
    const digits = tickDigits(marks);
    c.lineWidth = 1;
    c.textAlign = "right";
    c.textBaseline = "middle";
    for (const value of marks) {
      const y = Math.round(this.y(value)) + 0.5;
      line(c, theme.css("line"), plotLeft, y, width - plotRight, y);
      c.fillStyle = theme.css("soft");
      c.fillText(decimals(value, digits), plotLeft - 6, Math.min(Math.max(y, 7), plotHeight - 7));
    }
    this.paintNone(c, width);
    c.globalAlpha = 0.6;
    for (const t of this.motion.joints && this.motion.joints.length <= 60 ? this.motion.joints : []) {
      const x = timeToX(t, width);
      line(c, theme.css("line"), x, plotTop, x, plotHeight - plotBottom);
    }
    c.globalAlpha = 1;
  }

  // Times without a way home.
  none() {
    const home = homeOf(this.motion.mission);
    return home ? home.none() : [];
  }

  paintNone(c, width) {
    c.fillStyle = theme.css("bad");
    c.globalAlpha = 0.14;
    for (const { from, until } of this.none()) {
      const x = timeToX(from, width);
      c.fillRect(x, plotTop, Math.max(timeToX(Math.min(until, this.motion.duration), width) - x, 1.5), plotHeight - plotTop - plotBottom);
    }
    c.globalAlpha = 1;
  }

  paintLimit(c, width) {
    c.lineWidth = 1;
    c.setLineDash([5, 4]);
    for (const at of this.low < -this.limit ? [this.limit, -this.limit] : [this.limit]) {
      line(c, theme.css("limit"), plotLeft, this.y(at), width - plotRight, this.y(at));
    }
    c.setLineDash([]);
    const y = this.y(this.limit);
    c.fillStyle = theme.css("limit");
    c.textAlign = "right";
    c.strokeStyle = theme.css("panel");
    c.lineWidth = 4;
    for (const draw of ["strokeText", "fillText"]) {
      c[draw](`limit ${decimals(this.limit, 1)}`, width - plotRight - 12, y > 16 ? y - 7 : y + 9);
    }
  }

  paintCurve(c, width, curve) {
    c.strokeStyle = theme.css(curve.colour);
    c.lineWidth = curve.bold ? 1.75 : 1.25;
    c.lineJoin = "round";
    c.beginPath();
    if (curve.ends) this.traceSteps(c, width, curve); else this.traceSamples(c, width, curve);
    c.stroke();
  }

  traceSteps(c, width, { values, ends }) {
    for (let i = 0; i < values.length; ++i) {
      const y = this.y(values[i]);
      c.lineTo(timeToX(i ? ends[i - 1] : 0, width), y);
      c.lineTo(timeToX(ends[i], width), y);
    }
  }

  traceSamples(c, width, curve) {
    let drawn = false;
    for (let i = 0; i < this.motion.samples; ++i) {
      const v = curve.values[i];
      if (!Number.isFinite(v)) { drawn = false; continue; }
      const x = timeToX(this.motion.time[i], width), y = this.y(v);
      if (drawn) c.lineTo(x, y); else c.moveTo(x, y);
      drawn = true;
    }
  }

  at(time) {
    const t = Math.min(time, this.motion.duration);
    return this.curves.map(({ values, ends }) => (ends ? values[this.motion.step(ends, t)] : this.motion.scalar(values, t)));
  }

  // The cursor at `time`, and what the curves are `shown` at.
  update(time, shown) {
    const values = this.at(shown), { digits, unit, name } = this.quantity;
    this.values.forEach((span, k) => {
      const text = decimals(values[k], digits);
      if (span.textContent !== text) span.textContent = text;
    });
    this.surface.setAttribute("aria-valuenow", time.toFixed(2));
    this.surface.setAttribute("aria-valuetext", `${time.toFixed(2)} s: ${name} ${
      this.curves.map((curve, k) => `${curve.name} ${withUnit(values[k], digits, unit)}`).join(", ")}`);
    if (!this.width) return;
    const c = this.surface.getContext("2d");
    c.save();
    c.setTransform(1, 0, 0, 1, 0, 0);
    c.clearRect(0, 0, this.surface.width, this.surface.height);
    c.drawImage(this.base, 0, 0);
    c.restore();
    this.paintCursor(c, time, theme.css("accent"));
    if (shown !== time) this.paintCursor(c, shown, theme.css("soft"));
  }

  paintCursor(c, time, colour) {
    const x = timeToX(time, this.width);
    c.lineWidth = 1.25;
    line(c, colour, x, 2, x, plotHeight - 2);
    this.at(time).forEach((value, k) => {
      if (!Number.isFinite(value)) return;
      c.fillStyle = theme.css(this.curves[k].colour);
      c.beginPath();
      c.arc(timeToX(Math.min(time, this.motion.duration), this.width), this.y(value), 2.75, 0, 7);
      c.fill();
    });
  }

  listen(on) {
    const time = e => {
      const box = this.surface.getBoundingClientRect();
      return xToTime(e.clientX - box.left, box.width);
    };
    this.surface.addEventListener("pointermove", e => {
      if (e.buttons) on.set(time(e)); else on.hover(time(e), this);
    });
    this.surface.addEventListener("pointerdown", e => {
      this.surface.setPointerCapture(e.pointerId);
      on.set(time(e));
    });
    this.surface.addEventListener("pointerleave", () => on.hover(null, this));
    this.surface.addEventListener("keydown", e => {
      const step = { ArrowLeft: -1, ArrowRight: 1, PageDown: -10, PageUp: 10 }[e.key];
      if (step) on.set(plotSpan.local() + step * plotSpan.duration / 200);
      else if (e.key === "Home") on.set(0);
      else if (e.key === "End") on.set(plotSpan.duration);
      else return;
      e.preventDefault();
      e.stopPropagation();
    });
  }
}

function line(c, colour, x0, y0, x1, y1) {
  c.strokeStyle = colour;
  c.beginPath();
  c.moveTo(x0, y0);
  c.lineTo(x1, y1);
  c.stroke();
}

// The axis below all plots.
class TimeAxis {
  constructor() {
    this.canvas = element("canvas", { "aria-hidden": "true" });
    this.element = element("div", { class: "time-axis" }, this.canvas);
  }
  paint() {
    const { c, width } = fitCanvas(this.canvas, 26);
    const marks = ticks(0, plotSpan.duration, 6), digits = tickDigits(marks);
    c.fillStyle = theme.css("soft");
    c.textBaseline = "top";
    line(c, theme.css("line"), plotLeft, 0.5, width - plotRight, 0.5);
    for (const t of marks) {
      const x = timeToX(t, width);
      line(c, theme.css("soft"), x, 0, x, 4);
      c.textAlign = x > width - 24 ? "right" : "center";
      c.fillText(decimals(t, digits), x, 8);
    }
    c.textAlign = "left";
    c.fillText("t, s", 12, 8);
  }
}
