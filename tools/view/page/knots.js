// A trajectory by its state at each joint: between two joints the one polynomial of degree 7 that has both states, which
// is the trajectory's own.

class Knots {
  constructor(data) {
    this.count = data.knots;
    for (const key of ["position", "velocity", "acceleration", "jerk"]) this[key] = arrayOf(data[key]);
    this.time = new Float64Array(this.count);
    const step = arrayOf(data.step);
    for (let i = 1; i < this.count; ++i) this.time[i] = this.time[i - 1] + step[i];
    this.last = 0;
    this.known = null;  // the stretch that these are of, eight an axis
    this.points = new Float64Array(24);
    this.scratch = new Float64Array(8);
  }

  // The stretch from knot i to the next that holds t; the one of last time is tried first.
  find(t) {
    const { time } = this, most = this.count - 2;
    let i = this.last;
    if (!(time[i] <= t && t < time[i + 1])) {
      let low = 0, high = this.count - 1;
      while (high - low > 1) {
        const middle = (low + high) >> 1;
        if (time[middle] <= t) low = middle; else high = middle;
      }
      i = Math.min(low, most);
    }
    this.last = i;
    return i;
  }

  // The derivative of that order (0 to 3) at t, into `out` from `at` on.
  evaluate(t, order, out, at = 0) {
    const i = this.find(t), h = this.time[i + 1] - this.time[i];
    if (this.known !== i) this.control(i, h);
    const u = h > 0 ? Math.min(Math.max((t - this.time[i]) / h, 0), 1) : 1;
    for (let axis = 0; axis < 3; ++axis) out[at + axis] = this.axis(8 * axis, h, u, order);
  }

  // De Casteljau over the control points of one axis.
  axis(from, h, u, order) {
    const p = this.scratch;
    for (let m = 0; m < 8; ++m) p[m] = this.points[from + m];
    let degree = 7;
    for (let d = 0; d < order; ++d, --degree) {
      for (let m = 0; m < degree; ++m) p[m] = h > 0 ? (p[m + 1] - p[m]) * degree / h : 0;
    }
    for (; degree > 0; --degree) {
      for (let m = 0; m < degree; ++m) p[m] += (p[m + 1] - p[m]) * u;
    }
    return p[0];
  }

  // The control points of Bernstein's form on the stretch from knot i: four from the state at either end.
  control(i, h) {
    for (let axis = 0; axis < 3; ++axis) {
      this.half(3 * i + axis, h, 8 * axis, 1);
      this.half(3 * i + 3 + axis, -h, 8 * axis + 7, -1);
    }
    this.known = i;
  }

  half(from, h, at, way) {
    const p = this.points, x = this.position[from];
    const v = h * this.velocity[from] / 7, a = h * h * this.acceleration[from] / 42;
    p[at] = x;
    p[at + way] = x + v;
    p[at + 2 * way] = x + 2 * v + a;
    p[at + 3 * way] = x + 3 * v + 3 * a + h * h * h * this.jerk[from] / 210;
  }
}
