// What is plotted and coloured by: each quantity's unit, curves and limits for a motion.

const degrees = 180 / Math.PI;

function component(motion, key, axis, shift = 0) {
  return motion.column(`${key}${axis}`, i => motion[key][3 * i + axis] + shift);
}

function norm(motion, key) {
  return motion.column(`|${key}|`, i => Math.hypot(...motion[key].subarray(3 * i, 3 * i + 3)));
}

// Curves of a vector: components by colour, the norm in ink.
function vectorCurves(motion, key, withNorm) {
  const names = ["east", "north", "up"];
  const curves = names.map((name, axis) => ({ name, short: name[0].toUpperCase(), colour: name,
    values: component(motion, key, axis) }));
  if (withNorm) curves.push({ name: "norm", short: "‖·‖", colour: "ink", values: norm(motion, key), bold: true });
  return curves;
}

function tilt(motion) {
  const share = i => {
    if (motion.attitude) {  // third column of the rotation: 1 - 2 (x2 + y2)
      const [x, y] = motion.attitude.subarray(4 * i, 4 * i + 2);
      return 1 - 2 * (x * x + y * y);
    }
    const [x, y, z] = motion.acceleration.subarray(3 * i, 3 * i + 3);
    return (z + gravity) / Math.hypot(x, y, z + gravity);
  };
  return motion.column("tilt", i => Math.acos(Math.min(1, Math.max(-1, share(i)))) * degrees);
}

function thrust(motion) {
  return motion.column("thrust", i => {
    const [x, y, z] = motion.acceleration.subarray(3 * i, 3 * i + 3);
    return Math.hypot(x, y, z + gravity);
  });
}

// A value a sample; with `ends`, a value a step, each until then.
const one = (name, values, ends) => [{ name, colour: "ink", values, ends, bold: true }];

const quantities = [
  { key: "height", name: "Height", unit: "m", digits: 2, needs: "position",
    curves: m => one("up", component(m, "position", 2, origin[2])) },
  { key: "position", name: "Position", unit: "m", digits: 2, needs: "position",
    curves: m => ["east", "north", "up"].map((name, axis) => (
      { name, short: name[0].toUpperCase(), colour: name, values: component(m, "position", axis, origin[axis]) })) },
  { key: "velocity", name: "Velocity", unit: "m/s", digits: 2, needs: "velocity", limit: "vmax",
    curves: m => vectorCurves(m, "velocity", true) },
  { key: "acceleration", name: "Acceleration", unit: "m/s²", digits: 2, needs: "acceleration", limit: "amax",
    curves: m => vectorCurves(m, "acceleration", true) },
  { key: "jerk", name: "Jerk", unit: "m/s³", digits: 2, needs: "jerk", limit: "jmax",
    curves: m => vectorCurves(m, "jerk", true) },
  { key: "thrust", name: "Thrust over mass", unit: "m/s²", digits: 2, needs: "acceleration", limit: "thrust",
    curves: m => one("norm", thrust(m)) },
  { key: "motors", name: "Motors, share of the most", unit: "%", digits: 0, needs: "motors",
    curves: m => ["east", "north", "up", "fourth"].map((colour, k) => ({ name: String(k + 1), colour,
      values: m.column(`motor${k}`, i => 100 * m.motors[4 * i + k]) })) },
  { key: "tilt", name: "Tilt", unit: "°", digits: 1, limit: "tilt", limitScale: degrees,
    needs: m => m.attitude || m.acceleration, curves: m => one("tilt", tilt(m)) },
  { key: "clearance", name: "Clearance, least of each step", unit: "m", digits: 2, needs: "clearance",
    curves: m => one("to the nearest obstacle", m.clearance, m.clearance_end) },
  { key: "left", name: "Time left with a way home", unit: "s", digits: 1, needs: m => homeOf(m.mission) && homeOf(m.mission).ways.length > 0,
    curves: m => one("until there is none", m.column("left", i => homeOf(m.mission).left(m.time[i]))) },
  { key: "error", name: "Tracking error", unit: "m", digits: 3, needs: "error",
    curves: m => one("from the setpoint", m.error) },
];

function available(quantity, motion) {
  return Boolean(typeof quantity.needs === "function" ? quantity.needs(motion) : motion[quantity.needs]);
}

function limitOf(quantity, motion) {
  const limit = quantity.limit && motion.limits[quantity.limit];
  return limit === undefined || limit === null || !quantity.limit ? null : limit * (quantity.limitScale || 1);
}

// The one curve that a motion may be coloured by, a value a sample: the norm, or the only one.
function mainCurve(quantity, motion) {
  const { values, ends } = quantity.curves(motion).pop();
  return ends ? motion.column(`${quantity.key} around samples`, i => motion.leastAround(values, ends, i)) : values;
}

function extremesOf(values) {
  let low = Infinity, high = -Infinity;
  for (const v of values) {
    if (v < low) low = v;
    if (v > high) high = v;
  }
  return low > high ? [0, 1] : [low, high];
}
