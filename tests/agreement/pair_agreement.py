"""pair_agreement.py FILE: cases of `pair_agreement CASES EXACT FILE` decided anew, in fractions, by a search of its
own; and each proof of the exact check followed. Exit 1 when the exact check and this script do not agree on one."""

import json
import math
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "tools" / "check"))

from verify_certificate import Refused, halves  # noqa: E402
from verify_together import Claim, Flight, beyond, stretches, verify_pair  # noqa: E402

AXES = [[0, 0, 1], [0, 0, -1], [1, 0, 0], [-1, 0, 0], [0, 1, 0], [0, -1, 0]]


def upright(points):
    """The directions of both ends and of the middle of the chord, in plan."""
    first, last = ([float(c) for c in p[:2]] for p in (points[0], points[-1]))
    for share in (0, 0.25, 0.5, 0.75, 1):
        x, y = (a + share * (b - a) for a, b in zip(first, last))
        length = math.hypot(x, y)
        if length:
            yield [round(x / length * 2**24), round(y / length * 2**24), 0]


def inside(zone, point):
    shape, reach = zone
    x, y, z = (abs(c) for c in point)
    if shape == "cylinder":
        return z <= reach[2] and x * x + y * y <= reach[0] ** 2
    return all(c <= r for c, r in zip((x, y, z), reach))


def apart(points, zone, depth=0):
    """By halving until all is beyond a plane, or an end is inside."""
    sides = AXES + (list(upright(points)) if zone[0] == "cylinder" else [])
    if any(all(beyond(zone, 0, side, p) for p in points) for side in sides):
        return True
    if inside(zone, points[0]) or inside(zone, points[-1]) or depth == 60:
        return False
    return all(apart(half, zone, depth + 1) for half in halves(points))


def decided(a, b, claim):
    (zone,) = claim.zones(a, b)
    return all(apart([[p - q for p, q in zip(u, v)] for u, v in zip(a.over(*t), b.over(*t))], zone)
               for t in stretches(a, b, claim.parked))


def main():
    cases = accepted = wrong = unproved = 0
    with open(sys.argv[1], encoding="utf-8") as file:
        for row, line in enumerate(file, 1):
            case = json.loads(line)
            records = case["a"], case["b"]
            a, b = map(Flight, records)
            claim = Claim(case["claim"], [a, b], records)
            cases += 1
            accepted += case["exact"]
            found = decided(a, b, claim)
            if found != case["exact"] or (case["fast"] and not found):
                wrong += 1
                print(f"line {row}: here {found}, exact {case['exact']}, fast {case['fast']}")
            if not case["exact"]:
                continue
            try:
                verify_pair(a, b, claim, case["proof"]["stretches"])
            except Refused as reason:
                unproved += 1
                print(f"line {row}: {reason}")
    print(f"{cases} cases: {accepted} accepted by the exact check; {wrong} decided otherwise here; {unproved} proofs do not hold")
    return wrong + unproved > 0


if __name__ == "__main__":
    sys.exit(main())
