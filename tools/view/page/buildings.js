// Which boxes make up one building: those that touch and share the id of the source. Where no ids are
// shared they share a label, and without labels the height of the top.

const touching = 0.005;  // metres

class Groups {
  constructor(count) {
    this.parent = Uint32Array.from({ length: count }, (_, i) => i);
    this.covered = new Uint8Array(count);  // bits 0 to 3: the walls to the west, east, south and north stand inside the building
  }

  find(i) {
    const { parent } = this;
    while (parent[i] !== i) i = parent[i] = parent[parent[i]];
    return i;
  }

  join(i, j) {
    const a = this.find(i), b = this.find(j);
    if (a === b) return 0;
    this.parent[Math.max(a, b)] = Math.min(a, b);
    return 1;
  }
}

// Joins the boxes that touch and have one key (null: none); how many were joined. A sweep from west to east.
function joinTouching(corners, keyOf, groups) {
  const members = new Map();
  for (let i = 0; i < corners.length / 6; ++i) {
    const key = keyOf(i);
    if (key === null) continue;
    if (members.has(key)) members.get(key).push(i); else members.set(key, [i]);
  }
  let joined = 0;
  for (const list of members.values()) if (list.length > 1) joined += sweep(corners, list, groups);
  return joined;
}

function sweep(corners, list, groups) {
  list.sort((a, b) => corners[6 * a] - corners[6 * b]);
  let open = [], joined = 0;
  for (const i of list) {
    open = open.filter(j => corners[6 * j + 3] >= corners[6 * i] - touching);
    for (const j of open) {
      if (!meet(corners, 6 * i, 6 * j)) continue;
      joined += groups.join(i, j);
      groups.covered[i] |= coveredBy(corners, 6 * i, 6 * j);
      groups.covered[j] |= coveredBy(corners, 6 * j, 6 * i);
    }
    open.push(i);
  }
  return joined;
}

function meet(c, a, b) {
  for (let k = 1; k < 3; ++k) {
    if (c[a + k] > c[b + 3 + k] + touching || c[b + k] > c[a + 3 + k] + touching) return false;
  }
  return true;
}

// Which walls of a are wholly against b, as bits.
function coveredBy(c, a, b) {
  const along = k => c[b + k] <= c[a + k] + touching && c[b + 3 + k] >= c[a + 3 + k] - touching;
  if (!along(2)) return 0;
  let bits = 0;
  for (let k = 0; k < 2; ++k) {
    if (!along(1 - k)) continue;
    if (c[b + k] < c[a + k] - touching && c[b + 3 + k] >= c[a + k] - touching) bits |= 1 << 2 * k;
    if (c[b + 3 + k] > c[a + 3 + k] + touching && c[b + k] <= c[a + 3 + k] + touching) bits |= 2 << 2 * k;
  }
  return bits;
}

// Of each box the number of its building, from 0, and which walls are covered; `typical`: how long half of the buildings
// are at least, in metres.
function buildingsOf({ corners, count, ids, label }) {
  const groups = new Groups(count);
  const keys = [i => (ids ? ids[i] : null), i => (label && label[i] ? label[i] : null),
    i => Math.round(corners[6 * i + 5] * 100)];
  keys.some(key => joinTouching(corners, key, groups) > 0);
  const numbers = new Map(), building = new Uint32Array(count), extents = [];
  for (let i = 0; i < count; ++i) {
    const root = groups.find(i);
    if (!numbers.has(root)) {
      numbers.set(root, numbers.size);
      extents.push([Infinity, Infinity, -Infinity, -Infinity]);
    }
    building[i] = numbers.get(root);
    grow(extents[building[i]], corners, 6 * i);
  }
  const lengths = extents.map(([x0, y0, x1, y1]) => Math.hypot(x1 - x0, y1 - y0)).sort((a, b) => a - b);
  return { building, covered: groups.covered, buildings: numbers.size, typical: lengths.length ? lengths[lengths.length >> 1] : 1 };
}

function grow(extent, corners, at) {
  for (let k = 0; k < 2; ++k) {
    extent[k] = Math.min(extent[k], corners[at + k]);
    extent[2 + k] = Math.max(extent[2 + k], corners[at + 3 + k]);
  }
}
