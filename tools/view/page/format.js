// Numbers as people read them: digits that mean something, a real minus, a unit.

const thinSpace = "\u202f";

function decimals(value, digits) {
  if (value === null || value === undefined || !Number.isFinite(value)) return "–";
  const text = Math.abs(value).toLocaleString("en", {
    minimumFractionDigits: digits, maximumFractionDigits: digits });
  return value < 0 && /[1-9]/.test(text) ? "\u2212" + text : text;
}

function withUnit(value, digits, unit) {
  const text = decimals(value, digits);
  if (text === "–" || !unit) return text;
  return text + (unit === "°" ? "" : thinSpace) + unit;
}

// Few digits for small and for large lengths alike.
function metres(value) {
  const size = Math.abs(value);
  return withUnit(value, size < 1 ? 3 : size < 100 ? 2 : 1, "m");
}

function count(value, word, plural = word + "s") {
  return `${decimals(value, 0)} ${value === 1 ? word : plural}`;
}

function place(x, y, z) {
  const metresOf = `E ${decimals(x, 1)}, N ${decimals(y, 1)}, U ${decimals(z, 1)}${thinSpace}m`;
  return meta.map && meta.map.geographic ? `${metresOf} · ${onEarth(x, y)}` : metresOf;
}

// Where on Earth metres of the map are, within a metre: a polynomial that the map's projection was put into.
function onEarth(east, north) {
  const { at, scale, latitude, longitude } = meta.map.geographic;
  const x = (east - at[0]) / scale, y = (north - at[1]) / scale;
  const of = c => c[0] + c[1] * x + c[2] * y + c[3] * x * x + c[4] * x * y + c[5] * y * y;
  return geographic(of(latitude), of(longitude));
}

function geographic(latitude, longitude) {
  const side = (value, [above, below]) => `${decimals(Math.abs(value), 5)}° ${value < 0 ? below : above}`;
  return `${side(latitude, "NS")}, ${side(longitude, "EW")}`;
}

// The next of 1, 2, 5, 10, … at or above a value > 0, or at or below it.
function roundUp(value) {
  const power = 10 ** Math.floor(Math.log10(value));
  return power * [1, 2, 5, 10].find(lead => value <= lead * power * (1 + 1e-9));
}

function roundDown(value) {
  const power = 10 ** Math.floor(Math.log10(value));
  return power * [5, 2, 1].find(lead => value >= lead * power * (1 - 1e-9));
}

// Round values (1, 2 or 5 times a power of ten) inside [low, high], about `wanted` of them.
function ticks(low, high, wanted) {
  if (!(high > low)) return [low];
  const step = roundUp((high - low) / wanted);
  const out = [];
  for (let k = Math.ceil(low / step - 1e-9); k * step <= high + step * 1e-9; ++k) out.push(k * step);
  return out;
}

// Digits after the point that tell neighbouring ticks apart.
function tickDigits(values) {
  if (values.length < 2) return Number.isInteger(values[0]) ? 0 : 2;
  return Math.max(0, -Math.floor(Math.log10(values[1] - values[0]) + 1e-9));
}
