// A trajectory or a flight as samples over time, and its state in between.

// Limits of the trajectory that a flight is of.
function plannedLimits(id) {
  const planned = meta.motions.find(m => m.id === id && m.limits);
  return planned ? planned.limits : {};
}

// A flight begins when its trajectory does.
function plannedStart(id) {
  const planned = meta.motions.find(m => m.id === id && m.start !== undefined);
  return planned ? planned.start : 0;
}

const derivatives = ["position", "velocity", "acceleration", "jerk"];
const shownSamples = 400, shownPerSecond = 4;  // of a motion that is given by knots

class Motion {
  constructor(data) {
    this.data = data;
    this.id = data.id;
    this.isFlight = data.kind === "flight";
    this.duration = data.duration;
    this.begin = data.start ?? plannedStart(data.id);  // on the clock
    this.samples = data.samples;
    for (const key of ["yaw", "clearance", "clearance_end", "attitude", "setpoint", "setpoint_velocity", "error", "motors",
      "joints"]) {
      this[key] = arrayOf(data[key]);
    }
    if (data.knots) this.expand(data); else for (const key of derivatives) this[key] = arrayOf(data[key]);
    this.time = arrayOf(data.time) || Float32Array.from(
      { length: this.samples }, (_, i) => this.duration * i / (this.samples - 1));
    this.limits = data.limits || plannedLimits(data.id);
    this.word = this.isFlight ? "flown" : data.kind === "mission" ? "estimated" : "planned";
    this.name = `${data.id} (${this.word})`;
    this.cache = new Map();
  }

  // Samples of what knots say, each kind when it is first asked for.
  expand(data) {
    this.knots = new Knots(data);
    this.samples = Math.min(Math.max(Math.ceil(this.duration * shownPerSecond) + 1, 2), shownSamples);
    derivatives.forEach((key, order) => Object.defineProperty(this, key, { configurable: true, get: () => {
      const values = new Float32Array(3 * this.samples);
      for (let i = 0; i < this.samples; ++i) this.knots.evaluate(this.duration * i / (this.samples - 1), order, values, 3 * i);
      Object.defineProperty(this, key, { value: values });
      return values;
    } }));
  }

  // Seconds since it began, of a time of the clock; at rest before and after.
  local(time) { return Math.min(Math.max(time - this.begin, 0), this.duration); }

  flies(time) { return time >= this.begin && time <= this.begin + this.duration; }

  // Where it is at a time of the clock.
  place(time, out = new THREE.Vector3()) {
    const t = this.local(time);
    if (!this.knots) return this.vector(this.position, t, out);
    this.knots.evaluate(t, 0, place3);
    return out.fromArray(place3);
  }

  // The sample before t, and the share of the way to the next.
  find(t) {
    let low = 0, high = this.samples - 1;
    if (!(t > this.time[0])) return { i: 0, share: 0 };
    if (t >= this.time[high]) return { i: Math.max(high - 1, 0), share: high > 0 ? 1 : 0 };
    while (high - low > 1) {
      const middle = (low + high) >> 1;
      if (this.time[middle] <= t) low = middle; else high = middle;
    }
    return { i: low, share: (t - this.time[low]) / (this.time[high] - this.time[low]) };
  }

  // Linear between samples.
  scalar(values, t) {
    const { i, share } = this.find(t);
    return share === 0 ? values[i] : values[i] + (values[i + 1] - values[i]) * share;
  }

  // The step that holds t: `ends` ascend, and the first step begins at 0.
  step(ends, t) {
    let low = 0, high = ends.length - 1;
    while (low < high) {
      const middle = (low + high) >> 1;
      if (ends[middle] < t) low = middle + 1; else high = middle;
    }
    return low;
  }

  // The least of the steps from the sample before i to the one after it.
  leastAround(values, ends, i) {
    const until = this.time[Math.min(i + 1, this.samples - 1)];
    let k = this.step(ends, this.time[Math.max(i - 1, 0)]), least = values[k];
    while (ends[k] < until && k + 1 < ends.length) least = Math.min(least, values[++k]);
    return least;
  }

  vector(values, t, out = new THREE.Vector3()) {
    const { i, share } = this.find(t);
    const at = k => values[3 * i + k] + (share ? (values[3 * i + 3 + k] - values[3 * i + k]) * share : 0);
    return out.set(at(0), at(1), at(2));
  }

  // The direction of travel over the ground around t, as an angle from east; null at rest.
  heading(t, reach = 1) {
    const a = this.vector(this.position, t - reach), b = this.vector(this.position, t + reach);
    return Math.hypot(b.x - a.x, b.y - a.y) < 0.05 ? null : Math.atan2(b.y - a.y, b.x - a.x);
  }

  // Of a flight as logged; of a trajectory by flatness: thrust along a + g, nose by the yaw.
  orientation(t, out = new THREE.Quaternion()) {
    if (this.attitude) {
      const { i, share } = this.find(t);
      const at = k => new THREE.Quaternion().fromArray(this.attitude, 4 * k);
      return share ? out.copy(at(i)).slerp(at(i + 1), share) : out.copy(at(i));
    }
    const up = this.acceleration ? this.vector(this.acceleration, t) : new THREE.Vector3();  // a log without attitude
    up.z += gravity;
    up.normalize();
    const yaw = this.yawAt(t) ?? this.heading(t) ?? 0;
    const left = new THREE.Vector3().crossVectors(up, new THREE.Vector3(Math.cos(yaw), Math.sin(yaw), 0)).normalize();
    const ahead = new THREE.Vector3().crossVectors(left, up);
    return out.setFromRotationMatrix(new THREE.Matrix4().makeBasis(ahead, left, up));
  }

  // As the trajectory says; its yaws are spread evenly.
  yawAt(t) {
    if (!this.yaw) return null;
    const at = this.duration > 0 ? t / this.duration * (this.yaw.length - 1) : 0, i = Math.min(Math.floor(at), this.yaw.length - 2);
    return this.yaw[i] + (this.yaw[i + 1] - this.yaw[i]) * (at - i);
  }

  // A value a sample, worked out once.
  column(name, value) {
    if (!this.cache.has(name)) {
      this.cache.set(name, Float32Array.from({ length: this.samples }, (_, i) => value(i)));
    }
    return this.cache.get(name);
  }
}

const place3 = new Float64Array(3);

const gravity = 9.80665;  // m/s2

// Motions that share one time: when each begins is known, or there are too many to draw one by one.
const together = meta.fleet || null;

const motions = meta.motions.map(data => new Motion(data));

if (together) {
  const near = arrayOf(together.nearest);  // distance, across, up of each
  for (let i = 0; 3 * i < near.length; ++i) motions[i].nearest = near[3 * i], motions[i].apart = { across: near[3 * i + 1], up: near[3 * i + 2] };
}
