// Which line is under a point of the picture: of those within a few pixels the nearest.

const lineReach = 9;  // pixels

// `lines`: [{ points, … }], x, y, z after one another; the line itself, or null.
function pickLine(lines, camera, x, y, width, height) {
  const turn = new THREE.Matrix4().multiplyMatrices(camera.projectionMatrix, camera.matrixWorldInverse).elements;
  let best = lineReach, hit = null;
  for (const line of lines) {
    const away = awayFrom(line.points, turn, x, y, width, height);
    if (away < best) {
      best = away;
      hit = line;
    }
  }
  return hit;
}

function awayFrom(points, m, x, y, width, height) {
  let least = Infinity, last = null;
  for (let i = 0; i < points.length; i += 3) {
    const a = points[i], b = points[i + 1], c = points[i + 2];
    const w = m[3] * a + m[7] * b + m[11] * c + m[15];
    const next = w <= 1e-6 ? null : [((m[0] * a + m[4] * b + m[8] * c + m[12]) / w + 1) / 2 * width - x,
      (1 - (m[1] * a + m[5] * b + m[9] * c + m[13]) / w) / 2 * height - y];
    if (next && last) least = Math.min(least, fromOrigin(last, next));
    last = next;
  }
  return least;
}

// The distance of the origin from the segment a b, in two dimensions.
function fromOrigin([ax, ay], [bx, by]) {
  const dx = bx - ax, dy = by - ay, length = dx * dx + dy * dy;
  const share = length > 0 ? Math.min(Math.max(-(ax * dx + ay * dy) / length, 0), 1) : 0;
  return Math.hypot(ax + share * dx, ay + share * dy);
}
