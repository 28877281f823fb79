"""verify_bound.py MAP.boxmap CERTIFICATES: follows every proof that no path is shorter than its bound.

CERTIFICATES is what `skyway-plan --bound EPS --certificate` wrote (JSON Lines); records of enclosures are left to
verify_enclosure.py. The map's hash is worked out of its frame, bounds and boxes, and where a shortest path may bend is
worked out of the boxes alone. Exit 0 when there is a record and each holds, a line each saying what it proves; 1 when
one is refused, with the reason; 2 for wrong usage; 3 when a file cannot be read as what it should be.
docs/certificates.md says what is checked; docs/bound.md why that is enough.
"""

import math
import pathlib
import sys
from fractions import Fraction as F

sys.path.append(str(pathlib.Path(__file__).resolve().parent.parent / "check"))
sys.path.append(str(pathlib.Path(__file__).resolve().parent))
from bends import EdgeFinder, Part, distance, sides
from length_lines import carried_is_above, plus, straight_line
from verify_certificate import (BoxMap, Refused, an_object, by_id, corners, entries, number, numbers, require, run_main, text,
                                whole_number)

NONE = None  # of a label: no path shorter than the bound comes to the state


# ---- What is blocked.

def meets(p, q, low, high, off):
    """Whether a point of the segment is within `off` of the box: one is worked out and looked at."""
    enter, leave = 0.0, 1.0
    for a, b, lo, hi in zip(p, q, low, high):
        d = b - a
        if d == 0:
            continue
        s, t = (lo - a) / d, (hi - a) / d
        enter, leave = max(enter, min(s, t)), min(leave, max(s, t))
    t = min(max((enter + leave) / 2, 0.0), 1.0)
    return all(lo - off <= a + t * (b - a) <= hi + off for a, b, lo, hi in zip(p, q, low, high))


def covered(low, high, boxes):
    """Whether a closed box lies in the union of closed boxes: what the largest piece leaves of it must, in turn."""
    near = [(l, h) for l, h in boxes if all(a < d and c < b for a, b, c, d in zip(low, high, l, h))]
    if not near:
        return False
    best = max(near, key=lambda o: math.prod(min(b, d) - max(a, c) for a, b, c, d in zip(low, high, *o)))
    low, high = list(low), list(high)
    for k in range(3):
        if low[k] < best[0][k]:
            if not covered(low, high[:k] + [best[0][k]] + high[k + 1:], near):
                return False
            low[k] = best[0][k]
        if best[1][k] < high[k]:
            if not covered(low[:k] + [best[1][k]] + low[k + 1:], high, near):
                return False
            high[k] = best[1][k]
    return True


# ---- Levels.

class Level:
    """Parts; for each state (part, side) what is known of the way to it and on from it before, and what is claimed."""

    def __init__(self, parts, known_come, known_go, claimed_come, claimed_go, hidden, parents, before):
        self.parts = parts
        self.known = known_come, known_go
        self.claimed = claimed_come, claimed_go
        self.hidden, self.parents, self.before = hidden, parents, before

    def is_hidden(self, i, j):
        if j in self.hidden.get(i, ()):
            return True
        return self.before is not None and self.before.is_hidden(self.parents[i], self.parents[j])


def parts_sides(part):
    return (0,) if part.axis == 3 else (0, 1)


class Claim:
    """One record against the map."""

    def __init__(self, record, box_map, finders):
        require(record.get("type") == "bound", "the record is no bound")
        require(record.get("map") == box_map.hash, "it is of another map")
        require(record.get("frame") == box_map.frame, "it is of another frame")
        vehicle = an_object(record.get("vehicle"), "the vehicle")
        margin = number(record.get("margin"), "the margin", 0)
        half = tuple(math.nextafter(v + margin, math.inf) if margin > 0 else v
                     for v in numbers(vehicle.get("half"), 3, "the half sizes", 0))
        sides_ = [numbers(c, 3, "a corner of the bounds") for c in entries(record.get("bounds"), "the bounds")]
        require(sides_ == list(box_map.bounds), "the bounds are not the map's")
        if half not in finders:
            finders[half] = EdgeFinder(box_map, half)
        self.finder = finders[half]
        self.start, self.goal = (Part(p, p) for p in (tuple(numbers(record.get(k), 3, k)) for k in ("from", "to")))
        self.bound = number(record.get("bound"), "the bound", 0)
        self.record = record
        self.largest = max(abs(v) for corner in box_map.bounds for v in corner)
        # Sums here are of fewer than 16 terms of this size.
        self.margin = (sum(max(abs(a), abs(b)) for a, b in zip(*box_map.bounds)) + self.bound) * 2.0**-46

    def verify(self):
        straight = sum((F(b) - F(a)) ** 2 for a, b in zip(self.start.low, self.goal.low))
        levels, occluders = (entries(self.record.get(key), key) for key in ("levels", "occluders"))
        if F(self.bound) ** 2 <= straight:
            return
        require(levels, "the bound is longer than the straight line, and there are no levels")
        require(self.finder.has_room(), "the bounds are flat")
        for end in (self.start, self.goal):
            require(self.finder.inside(end), "an end is out of bounds")
        self.occluders = [self.occluder(o) for o in occluders]
        level = None
        for n, written in enumerate(levels):
            level = self.level(an_object(written, "a level"), level)
            self.check_hidden(level)
            self.check(level, 0)
            if self.is_enough(level.claimed[0][1][0]):
                return
            if level.claimed[1] is None:
                break
            self.check(level, 1)
            if self.is_enough(level.claimed[1][0][0]):
                return
        raise Refused("no level comes to the bound")

    def is_enough(self, label):
        return label is NONE or min(label) >= self.bound

    # -- Reading a level.

    def level(self, written, before):
        parts, parents = self.first_parts(written) if before is None else self.finer_parts(written, before)
        labels = [self.labels(written, key, parts) for key in ("come", "go")]
        require(labels[0] is not None, "a level has no labels")
        labels[0][0] = [(0.0, 0.0)]
        if labels[1] is not None:
            labels[1][1] = [(0.0, 0.0)]
        hidden = {}
        for row in entries(written.get("hidden"), "hidden"):
            row = entries(row, "what a part does not see")
            require(len(row) % 2 == 1, "what a part does not see must be pairs")
            row = [whole_number(row[0], "a part", len(parts))] + [
                whole_number(v, "a part or occluder", (len(parts), len(self.occluders))[k % 2]) for k, v in enumerate(row[1:])]
            hidden.setdefault(row[0], {}).update(zip(row[1::2], row[2::2]))
        if before is None:
            known = [[[straight_line(end, p, self.margin) for _ in parts_sides(p)] for p in parts] for end in (self.start, self.goal)]
        else:
            known = self.inherited(before, parts, parents)
        return Level(parts, *known, *labels, hidden, parents, before)

    def first_parts(self, written):
        parts = [self.start, self.goal]
        for value in entries(written.get("parts"), "parts"):
            if len(entries(value, "a part")) == 3:
                p = tuple(numbers(value, 3, "a corner"))
                parts.append(Part(p, p))
            else:
                x, y, z, end, axis, *out = numbers(value, 7, "a part")
                require(axis in (0, 1, 2) and all(v in (-1, 1) for v in out), "a part has no axis or no sides")
                low = (x, y, z)
                high = tuple(end if k == axis else v for k, v in enumerate(low))
                require(low[int(axis)] <= end, "a part ends before it begins")
                parts.append(Part(low, high, int(axis), (int(out[0]), int(out[1]))))
            require(self.finder.inside(parts[-1]), "a part is out of bounds")
        self.finder.require_listed(parts, self.start, self.goal, self.bound + self.margin)
        return parts, None

    def finer_parts(self, written, before):
        parts, parents = list(before.parts[:2]), [0, 1]
        pieces = {}
        for value in entries(written.get("parts"), "parts"):
            parent = whole_number(entries(value, "a part")[0] if value else None, "a parent", len(before.parts))
            part = before.parts[parent]
            if len(value) > 1:
                require(part.axis != 3, "a place is cut")
                low, high = numbers(value[1:], 2, "a part's ends")
                require(part.low[part.axis] <= low <= high <= part.high[part.axis], "a part is not on its parent")
                part = part.cut(low, high)
                pieces.setdefault(parent, []).append((low, high))
            else:
                require(part.axis == 3, "a part has no ends")
                pieces.setdefault(parent, [])
            parts.append(part)
            parents.append(parent)
        for i, part in enumerate(before.parts):
            if i < 2 or not any(self.may_be_used(before, i, s) for s in parts_sides(part)):
                continue
            require(i in pieces, "a part is left out that a short path may use")
            if part.axis != 3:
                at = part.low[part.axis]
                for low, high in sorted(pieces[i]):
                    require(low <= at, "a part is cut with a gap")
                    at = max(at, high)
                require(at >= part.high[part.axis], "a part is cut short")
        return parts, parents

    def labels(self, written, key, parts):
        if key not in written:
            return None
        rows = entries(written[key], key)
        require(len(rows) == len(parts), f"{key} must have a label of each part")
        return [self.label(row, part) for row, part in zip(rows, parts)]

    @staticmethod
    def label(row, part):
        out, row = [], list(entries(row, "a label"))
        while row:
            if row[0] is None:
                out.append(NONE)
                row = row[1:]
            else:
                out.append(tuple(numbers(row[:2], 2, "a label")))
                row = row[2:]
        require(len(out) == 2, "a part must have two labels")
        require(part.axis != 3 or out[0] is NONE or out[0][0] == out[0][1], "a place must have one label")
        return out[:len(parts_sides(part))]

    def may_be_used(self, level, i, s):
        """Unless every path by the state is as long as the bound."""
        lines = [[line for line in (level.claimed[w][i][s], level.known[w][i][s])] for w in (0, 1)]
        if None in lines[0] or None in lines[1]:
            return False
        return not any(min(plus(g, h)) >= self.bound + self.margin for g in lines[0] for h in lines[1])

    def inherited(self, before, parts, parents):
        known = [], []
        for part, parent in zip(parts, parents):
            of = before.parts[parent]
            used = [parent < 2 or self.may_be_used(before, parent, s) for s in parts_sides(part)]
            for w in (0, 1):
                lines = before.claimed[w][parent]
                known[w].append([self.piece(of, lines[s], part) if used[s] else NONE for s in parts_sides(part)])
        return known

    def piece(self, of, line, part):
        if line is NONE or part.axis == 3 or not of.length > 0:
            return line
        ts = [(end[of.axis] - of.low[of.axis]) / of.length for end in (part.low, part.high)]
        return tuple(line[0] * (1 - t) + line[1] * t - self.margin for t in ts)

    # -- Checking it.

    def occluder(self, value):
        low, high = (numbers(c, 3, "a corner of an occluder") for c in entries(value, "an occluder"))
        corners(low + high, "an occluder")
        largest = max(self.largest, *map(abs, low + high))
        off = largest * 2.0**-48
        outer = [math.nextafter(v - off, -math.inf) for v in low], [math.nextafter(v + off, math.inf) for v in high]
        require(covered(*outer, self.finder.boxes_near(*outer)), f"the occluder {low + high} is not blocked")
        return low, high, largest * 2.0**-49

    def check_hidden(self, level):
        """Segments that come within half of what an occluder was made larger by meet its inside. Between parts all do where
        those between their ends do: the points from which the segments to one point meet something convex are an interval."""
        for i, row in level.hidden.items():
            for j, o in row.items():
                for p in {level.parts[i].low, level.parts[i].high}:
                    for q in {level.parts[j].low, level.parts[j].high}:
                        require(meets(p, q, *self.occluders[o]), f"the occluder of {i} and {j} is not between them")

    def check(self, level, way):
        """Each label of a state is at most what comes to it, or known, or a path by that link is as long as the bound. `way`
        0: the labels from the start; 1: those to the goal."""
        targets = self.targets(level, way)
        for i, part in enumerate(level.parts):
            sources = self.sources(level, way, i)
            if not sources:
                continue
            least = min(min(max(lines, key=min)) for _, lines in sources)
            for j, wanted, highest in targets:
                if j != i and least + distance(part, level.parts[j]) < highest + self.margin:
                    self.check_pair(level, way, (i, sources), (j, wanted))

    def sources(self, level, way, i):
        """States from which a path shorter than the bound may go on, with lines below what it took."""
        if i == 1 - way:
            return []
        if i == way:
            return [(0, [(0.0, 0.0)])]
        out = []
        for s in parts_sides(level.parts[i]):
            claimed, known, ahead = level.claimed[way][i][s], level.known[way][i][s], self.ahead(level, way, i, s)
            if claimed is NONE or known is NONE or not ahead:
                continue
            if not any(min(plus(a, b)) >= self.bound + self.margin for a in (claimed, known) for b in ahead):
                out.append((s, [claimed, known]))
        return out

    def ahead(self, level, way, i, s):
        """Lines below what is left of a way by the state; none where no path shorter than the bound uses it."""
        come, go = ([level.known[w][i][s]] for w in (0, 1))
        if way == 1:
            come.append(level.claimed[0][i][s])
        if NONE in come + go or any(min(plus(a, b)) >= self.bound + self.margin for a in come for b in go):
            return []
        return come if way == 1 else go

    def targets(self, level, way):
        """States whose label is not known anyway: of each, lines one of which must be below what comes to it."""
        out = []
        for j, part in enumerate(level.parts):
            wanted = []
            for s in parts_sides(part):
                claimed, known, ahead = level.claimed[way][j][s], level.known[way][j][s], self.ahead(level, way, j, s)
                if j == way or not ahead or (claimed is not NONE and all(a <= b for a, b in zip(claimed, known))):
                    continue
                lines = [tuple(self.bound - v + self.margin for v in a) for a in ahead]
                wanted.append((s, lines + ([claimed] if claimed is not NONE else [])))
            if wanted:
                out.append((j, wanted, max(min(map(max, lines)) for _, lines in wanted)))
        return out

    def check_pair(self, level, way, source, target):
        (i, sources), (j, wanted) = source, target
        first, then = (i, j) if way == 0 else (j, i)
        here, there = sides(level.parts[first], level.parts[then]), sides(level.parts[then], level.parts[first])
        if here == 0 or there == 0 or level.is_hidden(first, then):
            return
        for s, below in sources:
            for t, lines in wanted:
                leaving, coming = (s, t) if way == 0 else (t, s)
                if level.parts[first].axis != 3 and not here >> (1 - leaving) & 1 or not there >> coming & 1:
                    continue
                if any(carried_is_above(level.parts[i], a, level.parts[j], b, self.margin) for a in below for b in lines):
                    continue
                if not self.was_too_long(level.before, level.parents, (first, leaving), (then, coming)):
                    raise Refused(f"the label of part {j} is above what comes from part {i}")

    def was_too_long(self, level, parents, leaving, coming):
        """Whether what held the two states at some level before says that a path by their link is as long as the bound."""
        while level is not None:
            (i, s), (j, t) = (parents[leaving[0]], leaving[1]), (parents[coming[0]], coming[1])
            g = [w[i][s] for w in (level.claimed[0], level.known[0])]
            h = [w[j][t] for w in (level.claimed[1], level.known[1])]
            if NONE in g or NONE in h:
                return True
            for a in g:
                for b in h:
                    most = tuple(self.bound - v + self.margin for v in b)
                    if carried_is_above(level.parts[i], a, level.parts[j], most, self.margin):
                        return True
            level, parents, leaving, coming = level.before, level.parents, (i, s), (j, t)
        return False


def verify(record, box_map, finders):
    Claim(record, box_map, finders).verify()


def verify_files(map_file, certificates):
    box_map, finders = BoxMap(map_file), {}
    refused = found = 0
    for name, record in by_id(certificates).items():
        if record.get("type") == "enclosure":
            continue
        found += 1
        try:
            verify(record, box_map, finders)
            half = ", ".join(f"{v:g}" for v in record["vehicle"]["half"])
            print(f"{name}: no way from {record['from']} to {record['to']} is shorter than {record['bound']} m "
                  f"for half sizes {half} and margin {record['margin']:g}")
        except Refused as reason:
            refused += 1
            print(f"{name}: refused: {reason}", file=sys.stderr)
    require(found, f"{certificates}: there is no bound")
    return refused


if __name__ == "__main__":
    run_main(__doc__, 2, verify_files)
