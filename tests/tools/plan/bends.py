"""Where a shortest path around grown boxes may bend: convex edges, and corners where edges cross or are flush. docs/bound.md
proves it. Coordinates are only compared and copied once the boxes are grown."""

import itertools
import math

from verify_certificate import require

CELL = 32.0  # metres: of the grid that finds boxes
DEEPEST = 60


def sum_error(a, b, total):
    part = total - a
    return (a - (total - part)) + (b - part)


def add_down(a, b):
    total = a + b
    return math.nextafter(total, -math.inf) if sum_error(a, b, total) < 0 else total


def add_up(a, b):
    return -add_down(-a, -b)


def slack(value):
    return max(5e-10, 2 * math.ulp(value))


def grown(box, half):
    """As the tools grow: half on every side, and as much again as they may round by; rounded outwards."""
    low = [add_down(v, -h) for v, h in zip(box[:3], half)]
    high = [add_up(v, h) for v, h in zip(box[3:], half)]
    return tuple(add_down(v, -slack(v)) for v in low), tuple(add_up(v, slack(v)) for v in high)


class Part:
    """A closed stretch of an edge, or a place (axis 3). `out`: signs, of the next two axes; the box is where both
    coordinates times these are less."""

    __slots__ = ("low", "high", "axis", "out", "length")

    def __init__(self, low, high, axis=3, out=(0, 0)):
        self.low, self.high, self.axis, self.out = low, high, axis, out
        self.length = 0.0 if axis == 3 else high[axis] - low[axis]

    def cut(self, low, high):
        ends = (tuple(at if k == self.axis else v for k, v in enumerate(self.low)) for at in (low, high))
        return Part(*ends, self.axis, self.out)

    def line(self):
        """What all parts of one edge have in common."""
        i, j = (self.axis + 1) % 3, (self.axis + 2) % 3
        return self.axis, self.low[i], self.low[j], self.out


def distance(a, b):
    """Between the closest points of two parts, or boxes."""
    (ax, ay, az), (bx, by, bz), (cx, cy, cz), (dx, dy, dz) = a.low, a.high, b.low, b.high
    x = cx - bx if cx > bx else ax - dx if ax > dx else 0.0
    y = cy - by if cy > by else ay - dy if ay > dy else 0.0
    z = cz - bz if cz > bz else az - dz if az > dz else 0.0
    return math.sqrt(x * x + y * y + z * z)


def sides(edge, other):
    """1: some of the other is in the closed quadrant (out, in) of the edge, 2: (in, out). Of a place 3. 0 on its own line."""
    if edge.axis == 3:
        return 3
    out, inner, on_line = [], [], True
    for n in (0, 1):
        k = (edge.axis + 1 + n) % 3
        at = edge.low[k]
        below, above = other.low[k] <= at, other.high[k] >= at
        out.append(above if edge.out[n] > 0 else below)
        inner.append(below if edge.out[n] > 0 else above)
        on_line = on_line and other.low[k] == at == other.high[k]
    return 0 if on_line else (out[0] and inner[1]) + 2 * (inner[0] and out[1])


def beside(low, high, at, sign):
    """Whether an interval holds what is just beside a coordinate."""
    return low <= at < high if sign > 0 else low < at <= high


OCTANTS = list(itertools.product((-1, 1), repeat=3))


def is_plain(blocked):
    """Whether no shortest path bends at a point with these octants blocked, but as at an edge through it."""
    if len(blocked) in (0, 1, 8):
        return True
    for k in range(3):
        above, below = ({o[:k] + o[k + 1:] for o in blocked if o[k] == sign} for sign in (1, -1))
        if above == below or len(above) == 4 or len(below) == 4:
            return True
    return False


class EdgeFinder:
    """All of it for one map and vehicle; what was looked at is kept."""

    def __init__(self, box_map, half):
        self.boxes = [grown(box, half) for box in box_map.boxes]
        self.inner = ([add_up(v, h) for v, h in zip(box_map.bounds[0], half)],
                      [add_down(v, -h) for v, h in zip(box_map.bounds[1], half)])
        self.cells = {}
        for i, (low, high) in enumerate(self.boxes):
            for cell in self.cells_of(low, high):
                self.cells.setdefault(cell, []).append(i)
        self.found = {}  # of each box: stretches and corners

    @staticmethod
    def cells_of(low, high):
        return itertools.product(*(range(math.floor(low[k] / CELL), math.floor(high[k] / CELL) + 1) for k in (0, 1)))

    def boxes_near(self, low, high):
        """The grown boxes that a closed box meets."""
        across, along = ([math.floor(v / CELL) for v in (low[k], high[k])] for k in (0, 1))
        if (across[1] - across[0] + 1) * (along[1] - along[0] + 1) <= len(self.cells):
            cells = self.cells_of(low, high)
        else:  # as of an occluder that somebody made up
            cells = (c for c in self.cells if across[0] <= c[0] <= across[1] and along[0] <= c[1] <= along[1])
        found = {i for cell in cells for i in self.cells.get(cell, ())}
        boxes = (self.boxes[i] for i in sorted(found))
        return [(l, h) for l, h in boxes if all(a <= d and c <= b for a, b, c, d in zip(low, high, l, h))]

    def has_room(self):
        return all(a < b for a, b in zip(*self.inner))

    def inside(self, part):
        return all(a <= v and w <= b for a, v, w, b in zip(self.inner[0], part.low, part.high, self.inner[1]))

    def of_box(self, i):
        if i not in self.found:
            stretches, places = [], set()
            for k, *out in itertools.product(range(3), (-1, 1), (-1, 1)):
                self.add_edge(self.boxes[i], k, tuple(out), stretches, places)
            self.found[i] = stretches, {p for p in places if not is_plain(self.blocked(p))}
        return self.found[i]

    def add_edge(self, box, k, out, stretches, places):
        i, j = (k + 1) % 3, (k + 2) % 3
        at = {n: box[sign > 0][n] for n, sign in zip((i, j), out)}
        low, high = max(box[0][k], self.inner[0][k]), min(box[1][k], self.inner[1][k])
        if not low < high or not all(self.inner[0][n] < v < self.inner[1][n] for n, v in at.items()):
            return
        edge = Part(tuple(at.get(n, low) for n in range(3)), tuple(at.get(n, high) for n in range(3)), k, out)
        covers = []
        marks = {low, high}
        for other in self.boxes_near(edge.low, edge.high):
            marks |= {other[up][k] for up in (0, 1) if low < other[up][k] < high}
            if any(beside(other[0][i], other[1][i], at[i], a) and beside(other[0][j], other[1][j], at[j], b)
                   for a, b in ((out[0], -out[1]), (-out[0], out[1]))):
                covers.append((other[0][k], other[1][k]))
        places |= {edge.cut(m, m).low for m in marks}
        for a, b in sorted(covers):
            if a > low:
                stretches.append(edge.cut(low, min(a, high)))
            low = max(low, b)
            if low >= high:
                return
        stretches.append(edge.cut(low, high))

    def blocked(self, p):
        """The octants around a point that are in a box or out of bounds."""
        near = self.boxes_near(p, p)
        holds = lambda box, octant: all(beside(*v) for v in zip(box[0], box[1], p, octant))
        return {o for o in OCTANTS if not holds(self.inner, o) or any(holds(box, o) for box in near)}

    def require_listed(self, parts, start, goal, most):
        """Whatever a path of less than `most` metres may bend at is on one of the parts."""
        lines, places = {}, set()
        for part in parts[2:]:
            if part.axis == 3:
                places.add(part.low)
            else:
                lines.setdefault(part.line(), []).append((part.low[part.axis], part.high[part.axis]))
        far = lambda p: distance(start, p) + distance(p, goal) >= most
        for i, box in enumerate(self.boxes):
            if far(Part(*box)):
                continue
            stretches, corners = self.of_box(i)
            for p in corners:
                require(p in places or far(Part(p, p)), f"the corner {p} is not among the parts")
            for stretch in stretches:
                if not far(stretch):
                    self.require_on(stretch, sorted(lines.get(stretch.line(), ())), far)

    @staticmethod
    def require_on(stretch, listed, far):
        k = stretch.axis
        low, high = stretch.low[k], stretch.high[k]
        gaps = []
        for a, b in listed:
            if a > low:
                gaps.append((low, min(a, high)))
            low = max(low, b)
            if low >= high:
                break
        else:
            gaps.append((low, high))
        waiting = [(a, b, 0) for a, b in gaps if a < b or not listed]
        while waiting:
            a, b, depth = waiting.pop()
            if far(stretch.cut(a, b)):
                continue
            middle = (a + b) / 2
            require(depth < DEEPEST and a < middle < b, f"the edge from {stretch.low} to {stretch.high} is not among the parts")
            waiting += [(a, middle, depth + 1), (middle, b, depth + 1)]
