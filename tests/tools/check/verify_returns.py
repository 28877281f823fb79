"""verify_returns.py RECORDS MAP.boxmap CERTIFICATES: follows in exact fractions why returns from every instant are clear.

RECORDS are trajectories or paths (of a mission: as `skyway-import-trajectory` gives it), and CERTIFICATES what `skyway-check --return --certificate` wrote of them (JSON Lines).
That each record itself is clear is verify_certificate.py's affair. Nothing is taken on trust: the regions of the returns
are held against every box of the map, and their parts of the flight must be all of it. Exit 0 when all returns are shown to
be clear; 1 when not, with the reason; 2 for wrong usage; 3 when a file cannot be read as what it should be.
docs/certificates.md says what is checked, and what is not.
"""

import itertools
import json
from fractions import Fraction as F

from verify_certificate import (LONGEST, BoxMap, Refused, an_object, by_id, entries, number, numbers, require, run_main,
                                said_by, text, times_claimed)

PHASES = ("braking", "climb", "way", "descent", "landing")
SINKS = ("descent", "landing")
HAIR = F(1, 2 * 10**9)  # m: rounding may put a place so far beside its region; the room has more to spare
BESIDE, ABOVE = F(2), F(3)  # m: a flight is so near to the pad below its first or last place
ROUNDED = F(1, 10**9)  # s, in a flight's times


def fractions(values):
    return [F(v) for v in values]


# ---- Upright prisms.

class Prism:
    """The convex hull of places in plan, from one height to another."""

    def __init__(self, sweep, what):
        self.plan = [fractions(numbers(p, 2, f"a corner of {what}")) for p in entries(sweep.get("plan"), f"the plan of {what}")]
        require(self.plan, f"{what} has no corners")
        self.low, self.high = (F(number(sweep.get(key), f"{key} of {what}")) for key in ("low", "high"))
        require(self.low <= self.high, f"{what} is higher below than above")
        self.sides = [(min(p[i] for p in self.plan), max(p[i] for p in self.plan)) for i in (0, 1)]

    def normals(self):
        for i, p in enumerate(self.plan):
            q = self.plan[(i + 1) % len(self.plan)]
            yield (q[1] - p[1], p[0] - q[0])

    def is_apart(self, low, high):
        """Whether a level plane, or an upright one along a face of either, is strictly between it and a closed box."""
        if self.low > high[2] or self.high < low[2]:
            return True
        if any(self.sides[i][0] > high[i] or self.sides[i][1] < low[i] for i in (0, 1)):
            return True
        for n in self.normals():
            least = min(n[0] * p[0] + n[1] * p[1] for p in self.plan)
            most = max(n[0] * p[0] + n[1] * p[1] for p in self.plan)
            ends = [sorted((n[i] * low[i], n[i] * high[i])) for i in (0, 1)]
            if least > ends[0][1] + ends[1][1] or most < ends[0][0] + ends[1][0]:
                return True
        return False

    def holds(self, place):
        return not self.is_apart([c - HAIR for c in place], [c + HAIR for c in place])

    def meets(self, other):
        """Whether some place is in both: else one of the two has an upright face, or a level one, between them."""
        if self.low > other.high or other.low > self.high:
            return False
        axes = [(F(1), F(0)), (F(0), F(1)), *self.normals(), *other.normals()]
        for n in axes:
            spans = [[n[0] * p[0] + n[1] * p[1] for p in prism.plan] for prism in (self, other)]
            if max(spans[0]) < min(spans[1]) or max(spans[1]) < min(spans[0]):
                return False
        return True


# ---- Hulls of places.

def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def hull_faces(places):
    """Normals along which to look at the hull of the places: each of its faces has one of them; if it is flat, so has each of its
    edges. With each how far the hull reaches, and a hair more."""
    ways = [tuple(y - x for x, y in zip(p, q)) for p, q in itertools.combinations(places, 2)]
    normals = [(F(1), F(0), F(0)), (F(0), F(1), F(0)), (F(0), F(0), F(1))]
    normals += [cross(way, axis) for way in ways for axis in normals[:3]]
    level = [n for p, q, r in itertools.combinations(places, 3)
             if any(n := cross(tuple(y - x for x, y in zip(p, q)), tuple(y - x for x, y in zip(p, r))))]
    normals += level + [cross(way, level[0]) for way in ways if level]
    out = []
    for n in normals:
        along = [sum(c * x for c, x in zip(n, p)) for p in places]
        room = HAIR * sum(abs(c) for c in n)
        if room:
            out.append((n, min(along) - room, max(along) + room))
    return out


def part_between(faces, a, b):
    """From which share of the way from a to b to which it is inside of the faces; nothing if it is not."""
    begin, end = F(0), F(1)
    for n, least, most in faces:
        at, speed = sum(c * x for c, x in zip(n, a)), sum(c * (y - x) for c, x, y in zip(n, a, b))
        if speed == 0:
            if not least <= at <= most:
                return None
            continue
        shares = sorted(((least - at) / speed, (most - at) / speed))
        begin, end = max(begin, shares[0]), min(end, shares[1])
        if begin > end:
            return None
    return begin, end


# ---- The flight.

def between(points, begin, end):
    """The control points of a curve's part, by de Casteljau's scheme at any two shares."""
    def cut(points, share):
        left, right = [], []
        while points:
            left.append(points[0])
            right.append(points[-1])
            points = [[a + share * (b - a) for a, b in zip(p, q)] for p, q in zip(points, points[1:])]
        return left, right[::-1]

    if end <= 0 or begin >= 1:
        return [points[0] if end <= 0 else points[-1]]
    early, _ = cut(points, min(end, F(1)))
    return cut(early, max(begin, F(0)) / min(end, F(1)))[1]


def curve_of(record):
    """Begin, duration and control points of each segment."""
    out, now = [], F(0)
    for segment in entries(record.get("segments"), "segments"):
        lasts = F(number(an_object(segment, "a segment").get("duration"), "duration", 0, LONGEST))
        require(lasts > 0, "a segment takes no time")
        axes = [fractions(numbers(segment.get(axis), 8, axis)) for axis in "xyz"]
        out.append((now, lasts, [list(p) for p in zip(*axes)]))
        now += lasts
    require(out, "the record has no segments")
    return out, now


def require_curve(curve, stage):
    """That all of the flight between the stage's times is where the stage says."""
    for begin, lasts, points in curve:
        low, high = max(stage["from"], begin), min(stage["until"], begin + lasts)
        if low > high:
            continue
        for p in between(points, (low - begin) / lasts, (high - begin) / lasts):
            require(stage["groups"] and all(group[0][1].holds(p) for group in stage["groups"]),
                    f"at {float(low)} s the flight is beside the region in which it brakes")


def require_all_times(stages, duration):
    reached = F(0)
    for stage in sorted(stages, key=lambda one: one["from"]):
        require(stage["from"] <= reached, f"nothing is said of the time from {float(reached)} s to {float(stage['from'])} s")
        reached = max(reached, stage["until"])
    require(reached >= duration - ROUNDED, f"nothing is said of the time from {float(reached)} s on")


def require_all_legs(points, stages):
    """That parts of each leg that lie along it are all of it."""
    for a, b in zip(points, points[1:]):
        way = [q - p for p, q in zip(a, b)]
        squared = sum(w * w for w in way)
        if squared == 0:
            continue
        spans = []
        for stage in stages:
            shares = [sum((c - p) * w for c, p, w in zip(place, a, way)) / squared for place in stage["where"]]
            beside = max(max(abs(p + s * w - c) for p, w, c in zip(a, way, place)) for s, place in zip(shares, stage["where"]))
            if beside <= HAIR:
                spans.append((min(shares), max(shares)))
        reached, spare = F(0), HAIR / max(abs(w) for w in way)
        for low, high in sorted(spans):
            require(low <= reached + spare, "nothing is said of a part of a leg")
            reached = max(reached, high)
        require(reached >= 1 - spare, "nothing is said of the end of a leg")


def require_mission(points, way, stages):
    """That the way is the record's, with ascent and descent, and that each place of it is one from which a return begins."""
    require(len(way) >= 2, "the way of the mission has no legs")
    count = len(points)
    # The ascent begins, and the descent ends, in the vertical; where there is none, the record's own points are the ends.
    found = [i for i in range(len(way) - count + 1) if way[i:i + count] == points]
    require(any(i <= 1 and i + count >= len(way) - 1 and (i == 0 or way[0][:2] == way[1][:2]) and
                (i + count == len(way) or way[-1][:2] == way[-2][:2]) for i in found), "the way is not that of the record")
    faces = [hull_faces(stage["where"]) for stage in stages]
    for a, b in zip(way, way[1:]):
        spans = [part_between(one, a, b) for one in faces]
        reached = F(0)
        for low, high in sorted(span for span in spans if span):
            require(low <= reached, "nothing is said of a part of the way")
            reached = max(reached, high)
        require(reached >= 1, "nothing is said of the end of a leg")


# ---- What is claimed of it.

def ends_of(record):
    """Its first and its last place."""
    if record["type"] == "trajectory":
        curve = curve_of(record)[0]
        return [curve[0][2][0], curve[-1][2][-1]]
    points = [fractions(numbers(p, 3, "a point")) for p in entries(record.get("points"), "points")]
    require(points, "the record has no points")
    return [points[0], points[-1]]


class Claim:
    def __init__(self, record, certificate, box_map):
        self.is_mission = certificate.get("of") == "mission"
        sides = [numbers(s, 3, "the bounds") for s in entries(certificate.get("bounds"), "the bounds of the certificate")]
        require(sides == list(box_map.bounds), "the certificate has other bounds than the map")
        asked = said_by(record, box_map, "the record", (), (box_map.hash, box_map.always_there))
        made = said_by(certificate, box_map, "the certificate", ("map", "frame", "vehicle", "margin"), (box_map.hash,))
        self.half = [max(F(a) + F(asked["margin"]), F(m) + F(made["margin"])) for a, m in zip(asked["half"], made["half"])]
        self.start = times_claimed(record, certificate, box_map).get("start")
        self.action = text(certificate, "action", "the certificate")
        require(self.action in ("rtl", "land", "hold"), f"the action {self.action!r} is not known")
        self.ends = ends_of(record)
        if self.is_mission:
            self.way = [fractions(numbers(p, 3, "a place of the way")) for p in entries(certificate.get("way"), "way")]
            require(self.way, "the way is empty")
            self.ends = [self.way[0], self.way[-1]]
        self.home = fractions(numbers(certificate.get("home"), 3, "home"))
        self.box_map = box_map

    def is_there(self, index, begin, end):
        times = self.box_map.times
        if self.start is None or index not in times:
            return True
        low, high = times[index]
        return (high is None or high >= self.start + begin) and (low is None or low <= self.start + end)


def is_below(places, low, high):
    """Whether a box that is grown by the vehicle is so near to these places in plan that the vehicle there stands on it."""
    return all(low[i] - BESIDE <= places[i][1] and places[i][0] - BESIDE <= high[i] for i in (0, 1))


def is_low_above_an_end(claim, stands, stage):
    """Whether all of the stage is beside one end of the record, and not far above what it stands on; a mission may rise from there,
    or come down to it."""
    def is_near(place, end):
        low = stands <= place[2] and (claim.is_mission or place[2] <= stands + ABOVE)
        return low and all(abs(place[i] - end[i]) <= BESIDE for i in (0, 1))
    return any(all(is_near(place, end) for place in stage["where"]) for end in claim.ends)


def require_clear(claim, obstacles, half, group, prism, sweep, stage):
    low, high = (fractions(side) for side in claim.box_map.bounds)
    stands = sweep.get("stands_on")
    places = group[-1][1].sides if sweep["phase"] in SINKS else stage["sides"]
    if stands is not None:
        stands = F(number(stands, "stands_on"))
        may = stands == claim.home[2] if sweep["phase"] in SINKS else is_low_above_an_end(claim, stands, stage)
        require(may or claim.is_mission,
                "only a way down to home's ground, and a flight low above its first or last place, may stand on something")
        stands = stands if may else None  # of a mission: then it must be clear of all boxes
    if stands is not None and sweep["phase"] not in SINKS:
        require(prism.low >= stands, f"the {sweep['phase']} is below what it stands on")
    require(all(l + h <= side[0] and side[1] <= u - h for l, u, h, side in zip(low, high, half, prism.sides)) and
            prism.high <= high[2] - half[2] and (stands is not None or prism.low >= low[2] + half[2]),
            f"the {sweep['phase']} leaves the bounds")
    for index, (box_low, box_high, top) in enumerate(obstacles):
        if stands is not None and top <= stands and is_below(places, box_low, box_high):
            continue
        if prism.is_apart(box_low, box_high) or not claim.is_there(index, stage["from"], stage["until"] + stage["lasts"]):
            continue
        raise Refused(f"the {sweep['phase']} from {float(stage['from'])} s on meets box {index}")


def require_whole(claim, groups):
    """That each return hangs together, begins by braking, and ends on the ground."""
    for group in groups:
        for (_, before), (_, after) in zip(group, group[1:]):
            require(before.meets(after), "two regions of a return do not meet")
        phases = [sweep["phase"] for sweep, _ in group]
        require(phases[0] == "braking" and phases == sorted(phases, key=PHASES.index), f"a return of {phases}")
        if claim.action == "hold":
            continue
        require(phases[-1] in SINKS and group[-1][1].low <= claim.home[2], "a return does not come down to home's ground")
        require(claim.action == "land" or {"climb", "way"} <= set(phases), f"a return home of {phases}")


def a_stage(one):
    an_object(one, "a stage")
    stage = {key: F(number(one.get(key), key, 0, LONGEST)) for key in ("from", "until", "lasts")}
    require(stage["from"] <= stage["until"], "a stage ends before it begins")
    stage["where"] = [fractions(numbers(p, 3, "a place")) for p in entries(one.get("where"), "where")]
    require(stage["where"], "a stage is nowhere")
    stage["sides"] = [(min(p[i] for p in stage["where"]), max(p[i] for p in stage["where"])) for i in (0, 1)]
    stage["groups"] = []
    for sweep in entries(one.get("sweeps"), "sweeps"):
        phase = text(an_object(sweep, "a sweep"), "phase", "a sweep")
        require(phase in PHASES, f"the phase {phase!r} is not known")
        if phase == "braking":
            stage["groups"].append([])
        require(stage["groups"], "a return does not begin by braking")
        stage["groups"][-1].append((sweep, Prism(sweep, f"the {phase}")))
    require(stage["groups"], "a stage has no return")
    for group in stage["groups"]:
        require(all(group[0][1].holds(p) for p in stage["where"]), "a stage is beside the region in which it brakes")
    return stage


def verify(record, certificate, box_map):
    """Raises Refused; else says what has been shown."""
    require(certificate.get("type") == "returns" and certificate.get("id") == record.get("id"), "it is no certificate of this record")
    require(certificate.get("of") in (record.get("type"), "mission" if record.get("type") == "path" else ""), f"the certificate is of a {certificate.get('of')}")
    claim = Claim(record, certificate, box_map)
    names = []
    for one in entries(certificate.get("autopilots"), "autopilots"):
        names.append(text(an_object(one, "an autopilot"), "autopilot", "an autopilot"))
        half = fractions(numbers(one.get("half"), 3, "half", 0))
        require(all(h >= c + HAIR for h, c in zip(half, claim.half)), "an autopilot needs less room than the vehicle")
        obstacles = [([F(c) - h for c, h in zip(box[:3], half)], [F(c) + h for c, h in zip(box[3:], half)], F(box[5]))
                     for box in box_map.boxes]
        stages = [a_stage(stage) for stage in entries(one.get("stages"), "stages")]
        for stage in stages:
            require_whole(claim, stage["groups"])
            for group in stage["groups"]:
                for sweep, prism in group:
                    require_clear(claim, obstacles, half, group, prism, sweep, stage)
        if record["type"] == "trajectory":
            curve, duration = curve_of(record)
            for stage in stages:
                require_curve(curve, stage)
        elif claim.is_mission:
            points = [fractions(numbers(p, 3, "a point")) for p in entries(record.get("points"), "points")]
            require_mission(points, claim.way, stages)
            continue  # its times are estimates
        else:
            require_all_legs([fractions(numbers(p, 3, "a point")) for p in entries(record.get("points"), "points")], stages)
            duration = F(number(certificate.get("duration"), "duration", 0, LONGEST))
        require_all_times(stages, duration)
    require(names and len(set(names)) == len(names), f"the autopilots {names}")
    shown = {"action": claim.action, "home": [float(c) for c in claim.home], "autopilots": names}
    if claim.is_mission:  # whether it was shown for the ways up from the ground and down to it
        points = [fractions(p) for p in record["points"]]
        shown |= {"ascent": claim.way[:len(points)] != points, "descent": claim.way[-len(points):] != points}
    return shown


def verify_files(record_file, map_file, certificate_file):
    """Prints what became of each record, and says how many were refused."""
    box_map, records = BoxMap(map_file), by_id(record_file)
    certificates = by_id(certificate_file, ("certificate", "apart", "together", "clear_of", "clear_of_moving"))
    refused = [f"{name!a}: refused: there is no record of this certificate" for name in certificates if name not in records]
    for name, record in records.items():
        try:
            require(name in certificates, "there is no certificate")
            print(f"{name!a}: returns are clear for {json.dumps(verify(record, certificates[name], box_map))}")
        except Refused as reason:
            refused.append(f"{name!a}: refused: {reason}")
    print("\n".join(refused), end="\n" if refused else "")
    return len(refused)


if __name__ == "__main__":
    run_main(__doc__, 3, verify_files)
