"""fast_path.py BIN_DIR MAP VEHICLE PATHS [--vmax 8 --amax 6] [--most 20]: trajectories beside smooth paths through boxes.

The peer is written after T. Marcucci, P. Nobel, R. Tedrake, S. Boyd, "Fast Path Planning Through Large Collections of Safe
Boxes" (2024): Bezier curves of degree 9 in a sequence of boxes, four times differentiable, of least snap in a given time;
in turns it solves for the points at fixed times and for points and times around the last ones (section 5), with cvxopt.
It has no limits of speed and acceleration, and gets the time that skyway-traj took. A curve that breaks the limits is slowed
down as a whole until it keeps them. The boxes are the largest empty ones along the path, as skyway-query gives them. Prints
for each path what both came to, how many times as long the peer takes within the limits, and the seconds of CPU of the
process skyway-traj and of the peer's solver; then medians. Needs python3-cvxopt.
"""

import argparse
import json
import math
import pathlib
import resource
import subprocess
import tempfile
import time

import numpy
from cvxopt import matrix, solvers

ORDER = 4  # of the derivative whose square is least: snap
DEGREE = 2 * ORDER + 1
REACH = 60  # metres: of a box from the place it is made at
STEPS = (2, 0.5, 0.1)  # metres between places, the next where the boxes do not join
TRUST, SHRINK, TOLERANCE = 1.0, 3.0, 1e-2  # as in the paper
solvers.options["show_progress"] = False


def gram(degree):
    """The matrix whose quadratic form is the integral over [0, 1] of the square of a Bezier curve."""
    size = degree + 1
    entries = [[math.comb(degree, i) * math.comb(degree, j) / math.comb(2 * degree, i + j) for j in range(size)] for i in range(size)]
    return numpy.array(entries) / (2 * degree + 1)


def boxes_around(asked, places):
    """The largest empty box around each place: its two corners."""
    lines = "".join(json.dumps({"segment": [list(p), list(p)], "empty_box": REACH}) + "\n" for p in places)
    told = subprocess.run([asked.tools / "skyway-query", asked.map, "--vehicle", asked.vehicle], input=lines, text=True, capture_output=True, check=True)
    return [numpy.array(json.loads(line)["empty_box"]) for line in told.stdout.splitlines()]


def places_along(points, step):
    """Places of a polyline, no more than a step apart."""
    out = [points[0]]
    for a, b in zip(points, points[1:]):
        pieces = max(1, math.ceil(numpy.linalg.norm(b - a) / step))
        out += [a + (b - a) * i / pieces for i in range(1, pieces + 1)]
    return out


def box_sequence(places, boxes):
    """Few boxes that follow each other along the places, and the shares of the way that each is for."""
    holds = lambda box, p: (box[0] <= p + 1e-9).all() and (p - 1e-9 <= box[1]).all()
    sequence, shares, at = [], [], 0
    while at + 1 < len(places):
        best, furthest = None, at
        for candidate in range(at, min(len(places), at + 40)):
            if not holds(boxes[candidate], places[at]):
                continue
            end = at
            while end + 1 < len(places) and holds(boxes[candidate], places[end + 1]):
                end += 1
            if end > furthest:
                best, furthest = boxes[candidate], end
        if best is None:
            return None, None
        sequence.append(best)
        shares.append(sum(numpy.linalg.norm(b - a) for a, b in zip(places[at:furthest], places[at + 1:furthest + 1])))
        at = furthest
    return sequence, numpy.array(shares)


class Derivatives:
    """The control points of a piece's derivatives as affine in its own points and, around a time, in its duration."""

    def __init__(self, duration, around=None):
        identity = numpy.eye(DEGREE + 1)
        zero = numpy.zeros((DEGREE + 1, 3))
        self.by_points, self.by_time, self.fixed = [identity], [zero], [zero]
        for derivative in range(ORDER):
            scale = (DEGREE - derivative) / duration
            self.by_points.append(numpy.diff(self.by_points[-1], axis=0) * scale)
            now = around[derivative + 1] if around else numpy.zeros((DEGREE - derivative, 3))
            self.by_time.append(numpy.diff(self.by_time[-1], axis=0) * scale - now / duration)
            self.fixed.append(numpy.diff(self.fixed[-1], axis=0) * scale + now)

    def values(self, points):
        """The points of each derivative where the duration is the one that it is around."""
        return [factors @ points for factors in self.by_points]


class Program:
    """The rows that all pieces share. Unknowns: the points, axis by axis and piece by piece; then one time a piece."""

    def __init__(self, pieces, start, goal):
        self.pieces, self.start, self.goal = pieces, start, goal
        self.times = 3 * len(pieces) * (DEGREE + 1)

    def place(self, axis, piece):
        """Where the points of a piece begin."""
        return (axis * len(self.pieces) + piece) * (DEGREE + 1)

    def row(self, columns, terms):
        """A row and its constant of a sum of (sign, axis, piece, derivative, point)."""
        out, constant = numpy.zeros(columns), 0.0
        for sign, axis, piece, derivative, point in terms:
            parts, at = self.pieces[piece], self.place(axis, piece)
            out[at:at + DEGREE + 1] += sign * parts.by_points[derivative][point]
            constant += sign * parts.fixed[derivative][point, axis]
            if columns > self.times:
                out[self.times + piece] += sign * parts.by_time[derivative][point, axis]
        return out, constant

    def equations(self, columns):
        """Rest at both ends, and joints that are continuous in all derivatives: the matrix and the right sides."""
        rows, right = [], []
        for axis in range(3):
            for derivative in range(ORDER):
                for piece, point, place in ((0, 0, self.start), (len(self.pieces) - 1, -1, self.goal)):
                    row, constant = self.row(columns, [(1, axis, piece, derivative, point)])
                    rows.append(row)
                    right.append((place[axis] if derivative == 0 else 0.0) - constant)
            for piece in range(len(self.pieces) - 1):
                for derivative in range(ORDER + 1):
                    row, constant = self.row(columns, [(1, axis, piece, derivative, -1), (-1, axis, piece + 1, derivative, 0)])
                    rows.append(row)
                    right.append(-constant)
        return numpy.array(rows), numpy.array(right)

    def within(self, columns, boxes):
        """Each point in the box of its piece, as G x <= h."""
        rows, most = [], []
        for axis in range(3):
            for piece, box in enumerate(boxes):
                for point in range(DEGREE + 1):
                    for sign, bound in ((1, box[1][axis]), (-1, -box[0][axis])):
                        row = numpy.zeros(columns)
                        row[self.place(axis, piece) + point] = sign
                        rows.append(row)
                        most.append(bound)
        return numpy.array(rows), numpy.array(most)

    def points(self, solution):
        """The points of each piece, (DEGREE + 1) x 3."""
        x = numpy.array(solution).ravel()
        return [numpy.column_stack([x[self.place(axis, piece):][:DEGREE + 1] for axis in range(3)]) for piece in range(len(self.pieces))]


def points_at(times, start, goal, boxes):
    """Least snap at these times: the points of each piece, and the cost."""
    program = Program([Derivatives(duration) for duration in times], start, goal)
    columns, snap_gram = program.times, gram(DEGREE - ORDER)
    hessian = numpy.zeros((columns, columns))
    for axis in range(3):
        for piece, duration in enumerate(times):
            snap, at = program.pieces[piece].by_points[ORDER], program.place(axis, piece)
            hessian[at:at + DEGREE + 1, at:at + DEGREE + 1] = 2 * duration * snap.T @ snap_gram @ snap
    equal, right = program.equations(columns)
    rows, most = program.within(columns, boxes)
    answer = solvers.qp(matrix(hessian), matrix(0.0, (columns, 1)), matrix(rows), matrix(most), matrix(equal), matrix(right))
    return program.points(answer["x"]), answer["primal objective"]


def tangent(times, points, trust, start, goal, boxes):
    """Points and times of least snap by the product of both at these, within the trust: the times, and the cost."""
    around = [Derivatives(duration).values(own) for duration, own in zip(times, points)]
    program = Program([Derivatives(duration, now) for duration, now in zip(times, around)], start, goal)
    count = len(times)
    first_cost = program.times + count
    columns = first_cost + count
    equal, right = program.equations(columns)
    total = numpy.zeros(columns)
    total[program.times:first_cost] = 1
    equal, right = numpy.vstack([equal, total]), numpy.append(right, sum(times))
    rows, most = program.within(columns, boxes)
    rows, most = list(rows), list(most)
    for piece, duration in enumerate(times):
        for sign, bound in ((-1, -duration / (1 + trust)), (1, duration * (1 + trust))):
            row = numpy.zeros(columns)
            row[program.times + piece] = sign
            rows.append(row)
            most.append(bound)
    linear, cones = len(rows), []
    root = numpy.linalg.cholesky(gram(DEGREE - ORDER)).T
    for piece in range(count):  # |2 root d|^2 <= 4 s t, d the differences of jerk, as a second-order cone
        for sign in (-1, 1):
            row = numpy.zeros(columns)
            row[first_cost + piece], row[program.times + piece] = -1, sign
            rows.append(row)
            most.append(0.0)
        for axis in range(3):
            terms = [program.row(columns, [(1, axis, piece, ORDER - 1, k + 1), (-1, axis, piece, ORDER - 1, k)]) for k in range(len(root))]
            scale = 2 * (DEGREE - ORDER + 1)
            for line in root:
                rows.append(-scale * sum(factor * row for factor, (row, _) in zip(line, terms)))
                most.append(scale * sum(factor * constant for factor, (_, constant) in zip(line, terms)))
        cones.append(2 + 3 * len(root))
    cost = matrix([0.0] * first_cost + [1.0] * count)
    answer = solvers.conelp(cost, matrix(numpy.array(rows)), matrix(numpy.array(most)), {"l": linear, "q": cones, "s": []}, matrix(equal), matrix(right))
    if answer["status"] != "optimal":
        return None, None
    return numpy.array(answer["x"]).ravel()[program.times:first_cost], answer["primal objective"]


def smooth(shares, total, start, goal, boxes):
    """The peer's curve in that time: times, points of each piece, cost."""
    times, trust = shares * (total / sum(shares)), TRUST
    points, cost = points_at(times, start, goal, boxes)
    while True:
        changed, promised = tangent(times, points, trust, start, goal, boxes)
        if changed is None or (cost - promised) / cost < TOLERANCE:
            return times, points, cost
        ratios = changed / times
        found, lower = points_at(changed, start, goal, boxes)
        if lower < cost:
            times, points, cost = changed, found, lower
        trust = (max(ratios.max(), 1 / ratios.min()) - 1) / SHRINK


def largest(times, pieces, derivative):
    """The largest length of a derivative, at 50 samples a piece."""
    most, degree = 0.0, DEGREE - derivative
    for duration, points in zip(times, pieces):
        control = Derivatives(duration).values(points)[derivative]
        for s in numpy.linspace(0, 1, 50):
            weights = [math.comb(degree, k) * s**k * (1 - s)**(degree - k) for k in range(degree + 1)]
            most = max(most, float(numpy.linalg.norm(weights @ control)))
    return most


def main():
    options = argparse.ArgumentParser(description=__doc__)
    options.add_argument("tools", type=pathlib.Path)
    options.add_argument("map")
    options.add_argument("vehicle")
    options.add_argument("paths", type=pathlib.Path)
    options.add_argument("--vmax", type=float, default=8)
    options.add_argument("--amax", type=float, default=6)
    options.add_argument("--most", type=int, default=20)
    asked = options.parse_args()
    ratios, costs = [], []
    for line in asked.paths.read_text(encoding="utf-8").splitlines()[:asked.most]:
        path = json.loads(line)
        with tempfile.TemporaryDirectory() as folder:
            one, out = pathlib.Path(folder) / "path", pathlib.Path(folder) / "out"
            one.write_text(line + "\n", encoding="utf-8")
            before = resource.getrusage(resource.RUSAGE_CHILDREN)
            subprocess.run([asked.tools / "skyway-traj", asked.map, one, "--vmax", str(asked.vmax), "--amax", str(asked.amax), "-o", out, "-q"], check=False)
            after = resource.getrusage(resource.RUSAGE_CHILDREN)
            used = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
            ours = json.loads(out.read_text(encoding="utf-8"))
        points = [numpy.array(p) for p in path["points"]]
        for step in STEPS:
            places = places_along(points, step)
            boxes, shares = box_sequence(places, boxes_around(asked, places))
            if boxes is not None:
                break
        else:
            print(f"{path['id']}: the empty boxes do not join")
            continue
        begin = time.process_time()
        try:
            times, pieces, cost = smooth(shares, ours["duration"], points[0], points[-1], boxes)
        except (ArithmeticError, ValueError) as error:
            print(f"{path['id']}: the peer's solver gives up: {error}")
            continue
        spent = time.process_time() - begin
        speed, acceleration = largest(times, pieces, 1), largest(times, pieces, 2)
        slower = max(speed / asked.vmax, math.sqrt(acceleration / asked.amax))
        ratios.append(slower)
        costs.append((used, spent))
        print(f"{path['id']}: {len(boxes)} boxes; in {ours['duration']:.1f} s snap {ours['solver']['snap']:.1f} and {cost:.1f}, the peer at most {speed:.1f} m/s, "
              f"{acceleration:.1f} m/s2; within the limits it takes {slower:.2f} times as long; CPU {used:.3f} and {spent:.2f} s", flush=True)
    if ratios:
        print(f"median of {len(ratios)}: the peer takes {numpy.median(ratios):.2f} times as long; CPU {numpy.median([a for a, _ in costs]):.3f} and {numpy.median([b for _, b in costs]):.2f} s")


if __name__ == "__main__":
    main()
