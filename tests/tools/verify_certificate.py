"""verify_certificate.py RECORDS MAP.csv BOUNDS CERTIFICATES: follows every certificate in exact fractions.

RECORDS are trajectories or paths (JSON Lines), MAP.csv is what `skyway-map to-csv` writes, BOUNDS are
the map's, x0,y0,z0,x1,y1,z1. Nothing is taken on trust: each box of the map is looked at for each piece.
Exit 0 when every record has a certificate that holds, else 1 with the reason. docs/certificates.md.
"""

import csv
import json
import math
import sys
from fractions import Fraction as F


class Refused(Exception):
    pass


def require(holds, what):
    if not holds:
        raise Refused(what)


def whole_number(value, what):
    require(type(value) is int and value >= 0, f"{what} must be a whole number, found {value!r}")
    return value


def halves(points):
    """The control points (lists of coordinates) of both halves, by de Casteljau."""
    left, right, row = [points[0]], [points[-1]], points
    while len(row) > 1:
        row = [[(a + b) / 2 for a, b in zip(p, q)] for p, q in zip(row, row[1:])]
        left.append(row[0])
        right.append(row[-1])
    return left, right[::-1]


def pieces(points, cover):
    """The pieces of a cover in order; refuses one that leaves out, or repeats, a part of the curve."""
    require(cover, "a cover is missing")
    stack = [(points, 0)]  # what is still to be covered, the first on top
    for depth in cover:
        whole_number(depth, "a depth")
        require(stack and depth <= 200, "the pieces are more than the curve")
        piece, above = stack.pop()
        require(depth >= above, "a piece begins where it cannot")
        for level in range(above, depth):
            piece, later = halves(piece)
            stack.append((later, level + 1))
        yield piece
    require(not stack, "the pieces leave out a part of the curve")


def derivative(points, times):
    """Control points of the derivative, times the duration to that power."""
    for _ in range(times):
        degree = len(points) - 1
        points = [[degree * (b - a) for a, b in zip(p, q)] for p, q in zip(points, points[1:])]
    return points


def square(p):
    """Bernstein coefficients of |p|^2."""
    n = len(p) - 1
    out = [F(0)] * (2 * n + 1)
    for i in range(n + 1):
        for j in range(n + 1):
            weight = F(math.comb(n, i) * math.comb(n, j), math.comb(2 * n, i + j))
            out[i + j] += weight * sum(a * b for a, b in zip(p[i], p[j]))
    return out


def product(p, q):
    """Bernstein coefficients of the product of two polynomials."""
    n, m = len(p) - 1, len(q) - 1
    out = [F(0)] * (n + m + 1)
    for i in range(n + 1):
        for j in range(m + 1):
            out[i + j] += F(math.comb(n, i) * math.comb(m, j), math.comb(n + m, i + j)) * p[i] * q[j]
    return out


def column(points, axis):
    return [p[axis] for p in points]


def require_not_negative(polynomial, cover, what):
    for piece in pieces([[c] for c in polynomial], cover):
        require(all(c >= 0 for (c,) in piece), f"{what} is not shown on a piece")


def tangent_below(angle):
    """The fraction of docs/certificates.md that is at most tan(angle)."""
    term, sums = F(1), [F(0), F(0)]
    for k in range(41):
        term = term * angle / k if k else term
        sums[k % 2] += term if k % 4 < 2 else -term
    return F(math.floor(sums[1] / sums[0] * 2**64), 2**64)


def bounding_box(points):
    return [min(c) for c in zip(*points)], [max(c) for c in zip(*points)]


def apart(points, low, high, plane):
    """Whether the plane's normal has all points strictly on one side of the box, the side it says."""
    require(plane in ("+x", "-x", "+y", "-y", "+z", "-z"), f"unknown plane {plane!r}")
    i = "xyz".index(plane[1])
    j, k = (i + 1) % 3, (i + 2) % 3
    normal = [F(0)] * 3
    normal[j], normal[k] = points[0][k] - points[-1][k], points[-1][j] - points[0][j]
    if plane[0] == "-":
        normal = [-c for c in normal]
    nearest = sum(n * (l if n > 0 else h) for n, l, h in zip(normal, low, high))
    return max(sum(n * c for n, c in zip(normal, p)) for p in points) < nearest


class Verifier:
    def __init__(self, boxes, bounds, half, margin, limits):
        grow = [F(h) + F(margin) for h in half]
        self.boxes = [([l - g for l, g in zip(low, grow)], [h + g for h, g in zip(high, grow)])
                      for low, high in boxes]
        # The same in floats and a micrometre larger, to pass by quickly what is clearly far away.
        self.rough = [([float(c) - 1e-6 for c in low], [float(c) + 1e-6 for c in high])
                      for low, high in self.boxes]
        self.low = [b + g for b, g in zip(bounds[0], grow)]
        self.high = [b - g for b, g in zip(bounds[1], grow)]
        self.limits = limits

    def clear(self, points, proof):
        planes = {}
        for piece, box, plane in proof.get("planes", []):
            planes[whole_number(piece, "a piece"), whole_number(box, "a box")] = plane
        for number, piece in enumerate(pieces(points, proof.get("clear"))):
            low, high = bounding_box(piece)
            (x0, y0, z0), (x1, y1, z1) = map(float, low), map(float, high)
            for index, ((a, b, c), (d, e, f)) in enumerate(self.rough):
                if x1 < a or y1 < b or z1 < c or x0 > d or y0 > e or z0 > f:
                    continue
                box = self.boxes[index]
                if any(h < l for h, l in zip(high, box[0])) or any(l > h for l, h in zip(low, box[1])):
                    continue
                plane = planes.get((number, index))
                require(plane and apart(piece, *box, plane), f"box {index} is not shown to miss piece {number}")

    def inside(self, points, proof):
        for piece in pieces(points, proof.get("bounds")):
            require(all(l <= c <= h for p in piece for l, c, h in zip(self.low, p, self.high)),
                    "a piece is not shown to be inside the bounds")

    def norm(self, points, duration, order, key, what, proof, axes=(0, 1, 2)):
        if key not in self.limits:
            return
        points = [[p[axis] for axis in axes] for p in points]
        most = (F(self.limits[key]) * duration**order) ** 2
        require_not_negative([most - c for c in square(derivative(points, order))], proof.get(what), what)

    def tilt(self, points, duration, proof):
        if "tilt" not in self.limits:
            return
        thrust = [[x, y, z + F(9.80665) * duration**2] for x, y, z in derivative(points, 2)]
        upward = [z for _, _, z in thrust]
        tangent = tangent_below(F(self.limits["tilt"]))
        cone = [tangent**2 * u - s
                for u, s in zip(square([[z] for z in upward]), square([[x, y] for x, y, _ in thrust]))]
        require_not_negative(upward, proof.get("tilt"), "tilt")
        require_not_negative(cone, proof.get("tilt"), "tilt")

    def thrust(self, points, duration, proof):
        if "thrust" not in self.limits:
            return
        thrust = [[x, y, z + F(9.80665) * duration**2] for x, y, z in derivative(points, 2)]
        most = (F(self.limits["thrust"]) * duration**2) ** 2
        require_not_negative([most - c for c in square(thrust)], proof.get("thrust"), "thrust")

    def body_rate(self, points, duration, proof):
        if "body_rate" not in self.limits:
            return
        force = [[x, y, z + F(9.80665) * duration**2] for x, y, z in derivative(points, 2)]
        jerk = derivative(points, 3)
        turn = [[a - b for a, b in zip(product(column(force, k), column(jerk, m)),
                                       product(column(force, m), column(jerk, k)))]
                for k, m in ((1, 2), (2, 0), (0, 1))]
        turned = product(square([list(p) for p in zip(*turn)]), [F(1)] * 3)
        most = (F(self.limits["body_rate"]) * duration) ** 2
        of_force = square(force)
        require_not_negative([most * a - b for a, b in zip(product(of_force, of_force), turned)],
                             proof.get("body_rate"), "body_rate")

    def yaw_rate(self, yaw, duration, proof):
        if "yaw_rate" not in self.limits or yaw is None:
            return
        most = (F(self.limits["yaw_rate"]) * duration) ** 2
        require_not_negative([most - c for c in square(derivative([[y] for y in yaw], 1))],
                             proof.get("yaw_rate"), "yaw_rate")

    def yaw_joint(self, before, after):
        if before[2] is None or after[2] is None:
            return
        for order, most in enumerate([1e-9, 1e-6]):
            end = derivative([[y] for y in before[2]], order)[-1][0] / before[0]**order
            begin = derivative([[y] for y in after[2]], order)[0][0] / after[0]**order
            require(abs(begin - end) <= F(most) * F(1001, 1000), "the yaw of two segments does not join")

    def joint(self, before, after, proof):
        self.yaw_joint(before, after)
        for order, most in enumerate([1e-9, 1e-6, 1e-4]):
            end = derivative(before[1], order)[-1]
            begin = derivative(after[1], order)[0]
            step = [b / after[0]**order - e / before[0]**order for b, e in zip(begin, end)]
            require(sum(c * c for c in step) <= (F(most) * F(1001, 1000)) ** 2, "two segments do not join")
        if before[1][-1] != after[1][0]:
            require("gap" in proof, "the step between two segments is not shown to be clear")
            self.clear([before[1][-1], after[1][0]], proof["gap"])

    def trajectory(self, record, proofs):
        segments = [(F(s["duration"]), [[F(c) for c in p] for p in zip(s["x"], s["y"], s["z"])],
                     [F(y) for y in s["yaw"]] if "yaw" in s else None) for s in record["segments"]]
        require(segments and len(proofs) == len(segments), "a segment has no proof")
        for (duration, points, yaw), proof in zip(segments, proofs):
            require(duration > 0 and len(points) == 8, "a segment is not a trajectory's")
            self.clear(points, proof)
            self.inside(points, proof)
            self.norm(points, duration, 1, "vmax", "speed", proof)
            self.norm(points, duration, 2, "amax", "acceleration", proof)
            self.norm(points, duration, 3, "jmax", "jerk", proof)
            self.tilt(points, duration, proof)
            self.norm(points, duration, 1, "vmax_h", "horizontal_speed", proof, axes=(0, 1))
            self.norm(points, duration, 1, "vmax_v", "vertical_speed", proof, axes=(2,))
            self.thrust(points, duration, proof)
            self.body_rate(points, duration, proof)
            self.yaw_rate(yaw, duration, proof)
        for before, after, proof in zip(segments, segments[1:], proofs):
            self.joint(before, after, proof)

    def path(self, record, proofs):
        points = [[F(c) for c in p] for p in record["points"]]
        legs = list(zip(points, points[1:])) or [(points[0], points[0])]
        require(len(proofs) == len(legs), "a leg has no proof")
        for leg, proof in zip(legs, proofs):
            self.clear(list(leg), proof)
            self.inside(list(leg), proof)


def verify(record, certificate, boxes, bounds):
    """Raises Refused; else says what has been shown. What the record does not say is the certificate's."""
    said = {**certificate, **record}
    limits = {**certificate.get("limits", {}), **record.get("limits", {})}
    for name, most in record.get("vehicle", {}).get("limits", {}).items():
        limits[name] = min(most, limits.get(name, most))
    unknown = set(limits) - {"vmax", "vmax_h", "vmax_v", "amax", "jmax", "tilt", "thrust", "body_rate", "yaw_rate"}
    require(not unknown, f"unknown limits: {unknown}")
    verifier = Verifier(boxes, bounds, said["vehicle"]["half"], said.get("margin", 0), limits)
    kind = record.get("type", "trajectory")
    require(certificate.get("of") == kind, "the certificate is of something else")
    (verifier.path if kind == "path" else verifier.trajectory)(record, certificate["segments"])
    return {"half": said["vehicle"]["half"], "margin": said.get("margin", 0),
            "limits": limits if kind == "trajectory" else {}}


def lines(path):
    with open(path) as file:
        return [json.loads(line) for line in file if line.strip()]


def main():
    if len(sys.argv) != 5:
        sys.exit(__doc__)
    with open(sys.argv[2]) as file:
        rows = [[F(float(c)) for c in row[:6]] for row in list(csv.reader(file))[1:]]
    boxes = [(row[:3], row[3:]) for row in rows]
    numbers = [F(float(c)) for c in sys.argv[3].split(",")]
    certificates = {c["id"]: c for c in lines(sys.argv[4])}
    failed = 0
    for record in lines(sys.argv[1]):
        try:
            require(record["id"] in certificates, "there is no certificate")
            shown = verify(record, certificates[record["id"]], boxes, (numbers[:3], numbers[3:]))
            print(f"{record['id']}: holds for {json.dumps(shown)}")
        except (Refused, ArithmeticError, AttributeError, LookupError, TypeError, ValueError) as reason:
            failed += 1
            print(f"{record['id']}: refused: {reason}")
    sys.exit(failed > 0)


if __name__ == "__main__":
    main()
