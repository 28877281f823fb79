"""verify_contingencies.py RECORDS MAP.boxmap CONTINGENCIES CERTIFICATES: follows in exact fractions why ways home hold from
every instant.

RECORDS are trajectories or paths, CONTINGENCIES their ways home of `skyway-plan --home`, and CERTIFICATES what
`skyway-check --contingencies --certificate` wrote of them (JSON Lines). That each record itself is clear is
verify_certificate.py's affair. Nothing is taken on trust: regions, hulls and legs are held against every box of the map, and
the parts of the flight must be all of it. Exit 0 when all ways home are shown to hold; 1 when not, with the reason; 2 for wrong
usage; 3 when a file cannot be read as what it should be. docs/certificates.md says what is checked, and what is not.
"""

import json
import math
from fractions import Fraction as F

from verify_certificate import (LONGEST, BoxMap, Refused, an_object, by_id, entries, number, numbers, require, run_main,
                                said_by, shown, strict_json, text)
from verify_returns import HAIR, Prism, curve_of, fractions, require_all_legs, require_all_times, require_curve

SAME_INSTANT = F(1, 10**6)  # s, in a flight's times and the battery's


# ---- Convex solids.

def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def minus(a, b):
    return [x - y for x, y in zip(a, b)]


AXES = [[F(1), F(0), F(0)], [F(0), F(1), F(0)], [F(0), F(0), F(1)]]


def prism_corners(prism):
    return [[*p, z] for z in (prism.low, prism.high) for p in prism.plan]


class Hull:
    """The convex hull of a prism and a point. Two convex solids are apart if a plane lies between them along a face of either,
    or across an edge of each."""

    def __init__(self, prism, to):
        self.points = prism_corners(prism) + [to]
        self.low, self.high = ([side(p[i] for p in self.points) for i in range(3)] for side in (min, max))
        edges = [[b[0] - a[0], b[1] - a[1], F(0)] for a, b in zip(prism.plan, prism.plan[1:] + prism.plan[:1])]
        self.normals = [[e[1], -e[0], F(0)] for e in edges]
        for corner in self.points[:-1]:
            self.normals += [cross(minus(to, corner), other) for other in AXES + edges]
        self.extents = None

    def is_apart(self, low, high):
        if any(self.low[i] > high[i] or self.high[i] < low[i] for i in range(3)):
            return True
        if self.extents is None:
            along = [[dot(n, p) for p in self.points] for n in self.normals]
            self.extents = [(min(a), max(a)) for a in along]
        for n, (least, most) in zip(self.normals, self.extents):
            ends = [sorted((n[i] * low[i], n[i] * high[i])) for i in range(3)]
            if least > sum(e[1] for e in ends) or most < sum(e[0] for e in ends):
                return True
        return False


def point_prism(p):
    return Prism({"plan": [[float(p[0]), float(p[1])]], "low": float(p[2]), "high": float(p[2])}, "a point")


# ---- What is claimed.

class Claim:
    def __init__(self, record, certificate, contingencies, box_map):
        sides = [numbers(s, 3, "the bounds") for s in entries(certificate.get("bounds"), "the bounds of the certificate")]
        require(sides == list(box_map.bounds), "the certificate has other bounds than the map")
        hashes = (box_map.hash, box_map.always_there)
        asked = [said_by(record, box_map, "the record", (), hashes)]
        asked += [said_by(one, box_map, "a contingency", (), hashes) for one in contingencies]
        made = said_by(certificate, box_map, "the certificate", ("map", "frame", "vehicle", "margin"), (box_map.hash,))
        # A contingency may have more margin than its flight: the certificate must have the largest.
        self.whole = [max([F(m) + F(made["margin"])] + [F(h) + F(one["margin"]) for one in asked for h in [one["half"][i]]])
                      for i, m in enumerate(made["half"])]
        self.half = fractions(numbers(certificate.get("half"), 3, "half", 0))
        require(all(h >= w + HAIR for h, w in zip(self.half, self.whole)), "less room than the vehicle needs")
        low, high = (fractions(side) for side in box_map.bounds)
        self.low = [l + w for l, w in zip(low, self.whole)]
        self.high = [h - w for h, w in zip(high, self.whole)]
        self.floor = low[2]
        self.overshoot = F(number(certificate.get("overshoot"), "overshoot", 0))
        self.flying_time = None
        if "flying_time" in certificate:
            self.flying_time = F(number(certificate["flying_time"], "flying_time", 0))
        self.boxes = box_map.boxes
        # Grown boxes in floats and a micrometre larger, to pass by quickly what is clearly far away.
        room = [float(h) + 1e-6 for h in self.half]
        self.rough = [([c - r for c, r in zip(box[:3], room)], [c + r for c, r in zip(box[3:], room)]) for box in box_map.boxes]

    def require_inside(self, low, high, what, stands=False):
        require(all(a >= l for a, l in list(zip(low, self.low))[:2 if stands else 3]) and
                all(b <= h for b, h in zip(high, self.high)), f"{what} leaves the bounds")

    def near(self, low, high, half):
        """Boxes that may meet a box, with their numbers, grown by `half`."""
        low, high = [float(c) - 1e-6 for c in low], [float(c) + 1e-6 for c in high]
        for index, (least, most) in enumerate(self.rough):
            if all(low[i] <= most[i] and least[i] <= high[i] for i in range(3)):
                box = self.boxes[index]
                yield index, [F(c) - h for c, h in zip(box[:3], half)], [F(c) + h for c, h in zip(box[3:], half)], F(box[5])

    def require_clear(self, solid, low, high, what, half=None):
        self.require_inside(low, high, what)
        for index, box_low, box_high, _ in self.near(low, high, self.half if half is None else half):
            require(solid.is_apart(box_low, box_high), f"{what} meets box {index}")

    def require_prism_clear(self, prism, what):
        low, high = ([side[i] for side in prism.sides] + [z] for i, z in enumerate((prism.low, prism.high)))
        self.require_clear(prism, low, high, what)


# ---- One way.

def require_overshoot(claim, prism, places, to, what):
    """That what is overshot at `to` on the way from each of the places is in the prism."""
    require(prism.holds(to), f"{what} is elsewhere")
    for p in places:
        way = minus(to, p)
        length = math.sqrt(float(dot(way, way)))
        if length > 0:
            share = F(float(claim.overshoot) / length)
            require(prism.holds([c + share * w for c, w in zip(to, way)]), f"{what} is smaller than the overshoot")


def a_prism(value, what):
    return Prism(an_object(value, what), what)


def require_legs(claim, points, way):
    beyond = entries(way.get("beyond"), "beyond")
    require(len(beyond) == len(points) - 2, "a region beyond each leg but the last")
    for i, (a, b) in enumerate(zip(points, points[1:-1])):
        leg = Hull(point_prism(a), b)
        claim.require_clear(leg, leg.low, leg.high, f"leg {i}", claim.whole)
        prism = a_prism(beyond[i], f"the region beyond leg {i}")
        require_overshoot(claim, prism, [a], b, f"the region beyond leg {i}")
        claim.require_prism_clear(prism, f"the region beyond leg {i}")


def require_landing(claim, above, ground):
    """Straight down to the floor, or to the top of a box below; what is higher is not in the way."""
    require(above[:2] == ground[:2] and above[2] > ground[2], "the way down is not straight")
    claim.require_inside(ground, above, "the way down", stands=True)
    stands = ground[2] == claim.floor
    column = Hull(point_prism(ground), above)
    for index, low, high, top in claim.near(column.low, column.high, claim.half):
        if top > ground[2]:
            require(column.is_apart(low, high), f"the way down meets box {index}")
        stands = stands or (top == ground[2] and all(low[i] <= ground[i] <= high[i] for i in (0, 1)))
    require(stands, "there is no ground where the way ends")


def a_join(one, what):
    an_object(one, what)
    join = {key: F(number(one.get(key), key, 0, LONGEST)) for key in ("from", "until", "lasts")}
    require(join["from"] <= join["until"], f"{what} ends before it begins")
    join["where"] = [fractions(numbers(p, 3, "a place")) for p in entries(one.get("where"), "where")]
    require(join["where"], f"{what} is nowhere")
    join["braking"] = a_prism(one.get("braking"), "the region where it brakes")
    join["beyond"] = a_prism(one.get("beyond"), "the region beyond the first point")
    require(all(join["braking"].holds(p) for p in join["where"]), "a part is beside the region where it brakes")
    # As verify_returns.py has the regions of a stage, for require_curve().
    join["groups"] = [[(None, join["braking"])]]
    return join


def require_join(claim, join, first):
    at = f"from {float(join['from'])} s on"
    claim.require_prism_clear(join["braking"], f"the braking {at}")
    hull = Hull(join["braking"], first)
    claim.require_clear(hull, hull.low, hull.high, f"the way to the first point {at}")
    require_overshoot(claim, join["beyond"], prism_corners(join["braking"]), first, f"the region beyond the first point {at}")
    claim.require_prism_clear(join["beyond"], f"what is overshot at the first point {at}")
    if claim.flying_time is not None:
        require(join["until"] + join["lasts"] <= claim.flying_time + SAME_INSTANT, f"the battery is not enough {at}")


def require_way(claim, way, contingency):
    """That a way is that of its contingency, and clear; gives the parts of the flight from which it is joined."""
    for key in ("from", "until", "site", "points"):
        require(way.get(key) == contingency.get(key), f"a contingency has another {key} than its certificate")
    if "latest_departure" in contingency or claim.flying_time is not None:
        require(contingency.get("latest_departure") == contingency["until"], "the battery is not enough for a contingency")
    points = [fractions(numbers(p, 3, "a point")) for p in entries(way.get("points"), "points")]
    require(len(points) >= 2, "a way of one point")
    require_legs(claim, points, way)
    require_landing(claim, points[-2], points[-1])
    joins = [a_join(one, "a join") for one in entries(way.get("joins"), "joins")]
    begin, end = (F(number(way.get(key), key, 0, LONGEST)) for key in ("from", "until"))
    reached = begin
    for join in sorted(joins, key=lambda one: one["from"]):
        require(join["from"] <= reached, f"a way is not shown from {float(reached)} s on")
        reached = max(reached, join["until"])
        require_join(claim, join, points[0])
    require(joins and reached >= end, f"a way is not shown from {float(reached)} s on")
    return joins


def verify(record, certificate, contingencies, box_map):
    """Raises Refused; else says what has been shown."""
    require(certificate.get("type") == "contingencies" and certificate.get("id") == record.get("id"), "it is no certificate of this record")
    require(certificate.get("of") == record.get("type"), f"the certificate is of a {shown(certificate.get('of'))}")
    found = [one for one in contingencies if one.get("status", "found") == "found"]
    claim = Claim(record, certificate, found, box_map)
    ways = [an_object(way, "a way") for way in entries(certificate.get("ways"), "ways")]
    require(len(ways) == len(found), f"{len(ways)} ways for {len(found)} contingencies")
    joins = [join for way, one in zip(ways, found) for join in require_way(claim, way, one)]
    if record["type"] == "trajectory":
        curve, duration = curve_of(record)
        for join in joins:
            require_curve(curve, join)
    else:
        require_all_legs([fractions(numbers(p, 3, "a point")) for p in entries(record.get("points"), "points")], joins)
        duration = F(number(certificate.get("duration"), "duration", 0, LONGEST))
    require_all_times(joins, duration)
    return {"half": [float(w) for w in claim.whole], "autopilot": text(certificate, "autopilot", "the certificate"),
            "flying_time": None if claim.flying_time is None else float(claim.flying_time), "ways": len(ways)}


def contingencies_of(path):
    """The contingencies of a file of JSON Lines, those of each flight under its id."""
    out = {}
    with open(path, encoding="utf-8", newline="\n") as file:
        for row, line in enumerate(file, 1):
            if not line.strip(" \t\r\n"):
                continue
            try:
                one = an_object(strict_json(line), "a line")
                require(one.get("type") == "contingency", f"a record of type {shown(one.get('type'))}")
                out.setdefault(text(one, "id", "a contingency"), []).append(one)
            except (Refused, RecursionError, ValueError) as reason:
                raise Refused(f"{path}:{row}: {reason}") from None
    return out


def verify_files(record_file, map_file, contingency_file, certificate_file):
    """Prints what became of each record, and says how many were refused."""
    box_map, records, contingencies = BoxMap(map_file), by_id(record_file), contingencies_of(contingency_file)
    certificates = by_id(certificate_file)
    refused = [f"{name!a}: refused: there is no record of this {what}" for what, names in
               (("certificate", certificates), ("contingency", contingencies)) for name in names if name not in records]
    for name, record in records.items():
        try:
            require(name in certificates, "there is no certificate")
            shown_to_hold = verify(record, certificates[name], contingencies.get(name, []), box_map)
            print(f"{name!a}: ways home hold for {json.dumps(shown_to_hold)}")
        except Refused as reason:
            refused.append(f"{name!a}: refused: {reason}")
    print("\n".join(refused), end="\n" if refused else "")
    return len(refused)


if __name__ == "__main__":
    run_main(__doc__, 4, verify_files)
