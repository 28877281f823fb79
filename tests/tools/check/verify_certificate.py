"""verify_certificate.py RECORDS MAP.boxmap CERTIFICATES: follows every certificate in exact fractions.

RECORDS are trajectories or paths and CERTIFICATES what `skyway-check --certificate` wrote of them (JSON
Lines). Nothing is taken on trust: the map's hash is worked out of its frame, bounds and boxes, and each
box is looked at for each piece. Exit 0 when there is a record, and every one has a certificate that
holds; 1 when one is refused, with the reason; 2 for wrong usage; 3 when a file cannot be read as what it
should be. docs/certificates.md says what is checked, and what is not.
"""

import ast
import concurrent.futures
import functools
import hashlib
import json
import math
import multiprocessing
import os
import re
import struct
import sys
import zipfile
import zlib
from fractions import Fraction as F

GRAVITY = 9.80665
LARGEST = 1e8  # of coordinates, sizes and margins, m: what the tools read
SHORTEST, LONGEST = 1e-9, 1e9  # s, of a segment
LEAST_LIMIT, LARGEST_LIMIT = 1e-9, 1e9
DEEPEST = 60
LIMITS = ("vmax", "vmax_h", "vmax_v", "amax", "jmax", "tilt", "thrust", "body_rate", "yaw_rate")
COVERS = {"speed": "vmax", "acceleration": "amax", "jerk": "jmax", "tilt": "tilt", "horizontal_speed": "vmax_h",
          "vertical_speed": "vmax_v", "thrust": "thrust", "body_rate": "body_rate", "yaw_rate": "yaw_rate"}


class Refused(Exception):
    pass


def require(holds, what):
    if not holds:
        raise Refused(what)


# ---- What is written, taken as nothing but what it should be.

def shown(value):
    text = repr(value)
    return text if len(text) <= 60 else text[:57] + "..."


def number(value, what, least=-LARGEST, most=LARGEST):
    """A JSON number that is a double, as a float: no string, bool, NaN, nor anything a double is not."""
    if type(value) not in (int, float) or not abs(value) <= sys.float_info.max:
        raise Refused(f"{what} must be a number, found {shown(value)}")
    if float(value) != value:
        raise Refused(f"{what} must be a double, found {shown(value)}")
    if not least <= value <= most:
        raise Refused(f"{what} must be within {least} and {most}, found {shown(value)}")
    return float(value)


def numbers(value, count, what, least=-LARGEST):
    require(type(value) is list and len(value) == count, f"{what} must be {count} numbers, found {shown(value)}")
    return [number(v, f"{what}[{i}]", least) for i, v in enumerate(value)]


def text(record, key, what):
    require(type(record.get(key)) is str, f"{what} must have a text {key!r}, found {shown(record.get(key))}")
    return record[key]


def entries(value, what):
    require(type(value) is list, f"{what} must be a list, found {shown(value)}")
    return value


def an_object(value, what):
    require(type(value) is dict, f"{what} must be an object, found {shown(value)}")
    return value


def whole_number(value, what, below):
    require(type(value) is int and 0 <= value < below, f"{what} must be a whole number below {below}, found {shown(value)}")
    return value


def strict_json(line):
    def pairs(found):
        out = dict(found)
        require(len(out) == len(found), f"a key stands twice in {shown([k for k, _ in found])}")
        return out

    def constant(word):
        raise Refused(f"{word} is no JSON")

    def decimal(digits):
        value = float(digits)
        require(math.isfinite(value), f"{digits} is larger than any double")
        require(value or not any(d in "123456789" for d in digits.lower().split("e")[0]), f"{digits} is smaller than any double")
        return value

    return json.loads(line, object_pairs_hook=pairs, parse_constant=constant, parse_float=decimal)


def by_id(path, others=()):
    """The records of a file of JSON Lines, each under its id. Those of the types `others` are left out."""
    out = {}
    with open(path, encoding="utf-8", newline="\n") as file:
        for row, line in enumerate(file, 1):
            if not line.strip(" \t\r\n"):
                continue
            try:
                record = an_object(strict_json(line), "a line")
                if record.get("type") in others:
                    continue
                name = text(record, "id", "a record")
                require(name not in out, f"the id {name!r} stands twice")
            except (Refused, RecursionError, ValueError) as reason:
                raise Refused(f"{path}:{row}: {reason}") from None
            out[name] = record
    require(out, f"{path}: there is no record")
    return out


# ---- The map.

def array_rows(data, name, dtype, columns):
    """The bytes of each row of an array of so many 8-byte numbers a row."""
    require(data[:6] == b"\x93NUMPY" and data[6] in (1, 2), f"{name}.npy is no NumPy array")
    at = 8 + (2 if data[6] == 1 else 4)
    end = at + int.from_bytes(data[8:at], "little")
    header = an_object(ast.literal_eval(data[at:end].decode("ascii")), f"the header of {name}.npy")
    row = 8 * columns
    count = (len(data) - end) // row
    require(header.get("descr") == dtype and header.get("fortran_order") is False and
            header.get("shape") == ((count,) if columns == 1 else (count, columns)) and len(data) - end == row * count,
            f"{name}.npy is not n x {columns} {dtype}: {header}")
    return [data[i:i + row] for i in range(end, len(data), row)]


def float_rows(data):
    """The bytes of each row of an array of float64, six a row."""
    return array_rows(data, "boxes", "<f8", 6)


SECONDS = 1e9  # from the epoch, at most: what the tools read
EPOCH = re.compile(r"(\d{4}-\d\d-\d\dT\d\d:\d\d:\d\d)(\.\d+)?(?:Z|\+00:00)")


def an_epoch(value, what):
    """As the tools write it: without zeros at its end, and with Z."""
    found = EPOCH.fullmatch(value) if type(value) is str else None
    require(found, f"the epoch of {what} must be an instant such as 2026-05-04T06:30:00Z, found {shown(value)}")
    return found[1] + (found[2] or "").rstrip("0").rstrip(".") + "Z"


def same_epoch(values, wanted, what):
    """Whether all are this instant; where it is nothing, none may have one."""
    wanted = None if wanted is None else an_epoch(wanted, what)
    return all((None if v is None else an_epoch(v, what)) == wanted for v in values)


class BoxMap:
    """A .boxmap of which everything that is used here is looked at, and the hash worked out of it."""

    def __init__(self, path):
        with zipfile.ZipFile(path) as archive:
            names = archive.namelist()
            require(len(set(names)) == len(names), "a file stands twice in the map")
            meta = an_object(strict_json(archive.read("meta.json")), "meta.json")
            rows = float_rows(archive.read("boxes.npy"))
            timed = "timed.npy" in names or "times.npy" in names
            indices = array_rows(archive.read("timed.npy"), "timed", "<u8", 1) if timed else []
            spans = array_rows(archive.read("times.npy"), "times", "<f8", 2) if timed else []
        require(meta.get("format") == "skyway-boxmap" and meta.get("version") == (2 if timed else 1),
                "the map is no skyway-boxmap of version 1, or of version 2 with times")
        require(meta.get("boxes") == len(rows), f"the map says {shown(meta.get('boxes'))} boxes and has {len(rows)}")
        self.boxes = [struct.unpack("<6d", row) for row in rows]
        for i, box in enumerate(self.boxes):
            corners(box, f"box {i}")
        self.epoch = an_epoch(meta["epoch"], "the map") if "epoch" in meta else None
        self.times = self.looked_at(indices, spans)
        require(not timed or self.times, "a map of version 2 must have boxes that are there for a time")
        self.frame = text(meta, "frame", "the map")
        require(self.frame in ("enu", "neu"), f"the frame must be enu or neu, found {self.frame!r}")
        sides = entries(meta.get("bounds"), "the bounds of the map")
        require(len(sides) == 2, "the bounds of the map must be two corners")
        self.bounds = corners(sum((numbers(side, 3, "the bounds of the map") for side in sides), []), "the bounds of the map")
        self.hash = self.worked_out(meta, rows, range(len(rows)))
        # Of the map before boxes with times were added, which records may name.
        self.always_there = self.worked_out(meta, rows, [i for i in range(len(rows)) if i not in self.times])
        require(meta.get("hash") == self.hash, f"the map says the hash {shown(meta.get('hash'))}, its content has {self.hash}")

    def looked_at(self, indices, spans):
        """From when until when boxes are there, seconds after the epoch, by their number; None: no such end."""
        require(len(indices) == len(spans), f"{len(indices)} timed boxes, {len(spans)} times")
        require(not indices or self.epoch is not None, "boxes have times, and the map has no epoch")
        out, before = {}, -1
        for index, span in zip(indices, spans):
            i, (start, end) = struct.unpack("<Q", index)[0], struct.unpack("<2d", span)
            require(before < i < len(self.boxes), f"timed box {i} is out of order, or none")
            require(start <= end and (abs(start) <= SECONDS or start == -math.inf) and (abs(end) <= SECONDS or end == math.inf) and
                    (start, end) != (-math.inf, math.inf), f"box {i} is there from {start} until {end}")
            out[i] = (None if start == -math.inf else F(start), None if end == math.inf else F(end))
            before = i
        self.raw_times = dict(zip(out, spans))
        return out

    def worked_out(self, meta, rows, some):
        """The hash of the map of some of its boxes."""
        timed = [i for i in some if i in self.times]
        head = f"timed\n{len(timed)}\n{self.epoch}\n" if timed else ""
        total = hashlib.sha256(f"{head}{self.frame}\n{text(meta, 'crs', 'the map')}\n".encode())
        if "origin" in meta:
            total.update(struct.pack("<3d", *numbers(meta["origin"], 3, "the origin of the map")))
        total.update(struct.pack("<6d", *self.bounds[0], *self.bounds[1]))
        for i in sorted(some, key=self.boxes.__getitem__):
            total.update(rows[i])
        for i in sorted(timed, key=lambda i: (self.boxes[i], struct.unpack("<2d", self.raw_times[i]))):
            total.update(rows[i] + self.raw_times[i])
        return "sha256:" + total.hexdigest()


def corners(six, what):
    if not all(-LARGEST <= a <= b <= LARGEST for a, b in zip(six[:3], six[3:])):
        raise Refused(f"{what} must be two corners within 1e8 m, found {six}")
    return list(six[:3]), list(six[3:])


# ---- Bernstein forms.

def halves(points):
    """The control points (lists of coordinates) of both halves, by de Casteljau."""
    left, right, row = [points[0]], [points[-1]], points
    while len(row) > 1:
        row = [[(a + b) / 2 for a, b in zip(p, q)] for p, q in zip(row, row[1:])]
        left.append(row[0])
        right.append(row[-1])
    return left, right[::-1]


def pieces(points, cover, halved=halves):
    """The pieces of a cover in order; refuses one that leaves out, or repeats, a part of the curve."""
    require(cover is not None, "a cover is missing")
    stack = [(points, 0)]  # what is still to be covered, the first on top
    for depth in entries(cover, "a cover"):
        whole_number(depth, "a depth", DEEPEST + 1)
        require(stack, "the pieces are more than the curve")
        piece, above = stack.pop()
        require(depth >= above, "a piece begins where it cannot")
        for level in range(above, depth):
            piece, later = halved(piece)
            stack.append((later, level + 1))
        yield piece
    require(not stack, "the pieces leave out a part of the curve")


def derivative(points, times):
    """Control points of the derivative, times the duration to that power."""
    scale = math.perm(len(points) - 1, times)
    return [[scale * c for c in p] for p in differences(points, times)]


def at_begin(points, order):
    """The derivative where the curve begins, times the duration to that power."""
    return [math.perm(len(points) - 1, order) * c for c in differences(points[:order + 1], order)[0]]


def at_end(points, order):
    """The derivative where the curve ends, times the duration to that power."""
    return [math.perm(len(points) - 1, order) * c for c in differences(points[-order - 1:], order)[0]]


def differences(points, times):
    """Differences of neighbours, taken so many times."""
    for _ in range(times):
        points = [[b - a for a, b in zip(p, q)] for p, q in zip(points, points[1:])]
    return points


def whole_numbers(values):
    """Fractions as whole numbers over one denominator."""
    below = math.lcm(*(v.denominator for v in values))
    return [v.numerator * (below // v.denominator) for v in values], below


def product(p, q):
    """Bernstein coefficients of the product of two polynomials."""
    n, m = len(p) - 1, len(q) - 1
    (a, below_a), (b, below_b) = whole_numbers(p), whole_numbers(q)
    out = [0] * (n + m + 1)
    for i in range(n + 1):
        for j in range(m + 1):
            out[i + j] += math.comb(n, i) * math.comb(m, j) * a[i] * b[j]
    return [F(c, math.comb(n + m, k) * below_a * below_b) for k, c in enumerate(out)]


def square(p):
    """Bernstein coefficients of |p|^2."""
    axes = [product(column(p, axis), column(p, axis)) for axis in range(len(p[0]))]
    return [sum(of_axis) for of_axis in zip(*axes)]


def column(points, axis):
    return [p[axis] for p in points]


def doubled_halves(points):
    """Both halves of a polynomial in whole numbers, times a power of two: signs stay."""
    degree, row = len(points) - 1, points
    left, right = [], []
    for k in range(degree + 1):
        left.append([row[0][0] << (degree - k)])
        right.append([row[-1][0] << (degree - k)])
        row = [[a + b] for (a,), (b,) in zip(row, row[1:])]
    return left, right[::-1]


def require_not_negative(polynomial, cover, what):
    for piece in pieces([[c] for c in whole_numbers(polynomial)[0]], cover, doubled_halves):
        require(all(c >= 0 for (c,) in piece), f"{what} is not shown on a piece")


@functools.lru_cache
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
    require(plane in ("+x", "-x", "+y", "-y", "+z", "-z"), f"unknown plane {shown(plane)}")
    i = "xyz".index(plane[1])
    j, k = (i + 1) % 3, (i + 2) % 3
    normal = [F(0)] * 3
    normal[j], normal[k] = points[0][k] - points[-1][k], points[-1][j] - points[0][j]
    if plane[0] == "-":
        normal = [-c for c in normal]
    nearest = sum(n * (l if n > 0 else h) for n, l, h in zip(normal, low, high))
    return max(sum(n * c for n, c in zip(normal, p)) for p in points) < nearest


class GrownBoxes:
    """The boxes of a map, larger by the vehicle: exact where they are asked for. In floats and micrometres larger they lie in
    squares, to pass by quickly what is clearly far away."""

    SIDE = 50.0  # m, of a square
    MOST = 400  # squares of a box; those of more are near every region

    def __init__(self, boxes, grow):
        self.raw, self.grow, self.exact = boxes, grow, {}
        reach = [float(g) + 2e-6 for g in grow]
        self.rough = [tuple([c - r for c, r in zip(box, reach)] + [c + r for c, r in zip(box[3:], reach)]) for box in boxes]
        self.squares, self.wide = {}, []
        for index, box in enumerate(self.rough):
            across, along = self.square(box[0], box[3]), self.square(box[1], box[4])
            if len(across) * len(along) > self.MOST:
                self.wide.append(index)
                continue
            for at in ((i, j) for i in across for j in along):
                self.squares.setdefault(at, []).append(index)

    def square(self, low, high):
        return range(math.floor(low / self.SIDE), math.floor(high / self.SIDE) + 1)

    def __len__(self):
        return len(self.raw)

    def __getitem__(self, index):
        if index not in self.exact:
            box = self.raw[index]
            self.exact[index] = ([F(c) - g for c, g in zip(box[:3], self.grow)], [F(c) + g for c, g in zip(box[3:], self.grow)])
        return self.exact[index]

    def near(self, low, high):
        """In order, those that may meet the box of these two corners, floats."""
        across, along = self.square(low[0], high[0]), self.square(low[1], high[1])
        if len(across) * len(along) > len(self.squares):
            found = range(len(self.raw))
        else:
            found = set(self.wide).union(*(self.squares.get((i, j), ()) for i in across for j in along))
        for index in sorted(found):
            a, b, c, d, e, f = self.rough[index]
            if not (high[0] < a or high[1] < b or high[2] < c or low[0] > d or low[1] > e or low[2] > f):
                yield index


def grown_boxes(box_map, grow):
    """Of a map, made once for all records of the same vehicle."""
    kept = getattr(box_map, "kept", None)
    if kept is None or kept[0] is not box_map.boxes:
        kept = box_map.kept = (box_map.boxes, {})
    if tuple(grow) not in kept[1]:
        kept[1][tuple(grow)] = GrownBoxes(box_map.boxes, grow)
    return kept[1][tuple(grow)]


class Verifier:
    """The proofs of one record, held against what is claimed of it."""

    def __init__(self, box_map, claim):
        grow = [F(h) + F(claim["margin"]) for h in claim["half"]]
        self.boxes = grown_boxes(box_map, grow)
        self.low = [F(b) + g for b, g in zip(box_map.bounds[0], grow)]
        self.high = [F(b) - g for b, g in zip(box_map.bounds[1], grow)]
        self.limits = claim["limits"]
        # When boxes are there, where the record says when it begins; else always.
        self.start, self.stands = claim.get("start"), claim.get("parked") == "pad"
        self.times = box_map.times if self.start is not None else {}

    def later(self, index, when):
        """1 where the box is there only after that stretch of time, -1 where only before; else 0."""
        start, end = self.times.get(index, (None, None))
        if start is not None and start > when[1]:
            return 1
        return -1 if end is not None and end < when[0] else 0

    def planes(self, proof, parts, whens):
        """The planes by piece and box; each must do what it says, needed or not."""
        out = {}
        for entry in entries(proof.get("planes", []), "planes"):
            require(type(entry) is list and len(entry) == 3, f"a plane must be [piece, box, plane], found {shown(entry)}")
            at = (whole_number(entry[0], "a piece", len(parts)), whole_number(entry[1], "a box", len(self.boxes)))
            require(at not in out, f"two planes for box {at[1]} and piece {at[0]}")
            by_time = entry[2] in ("+t", "-t")
            if by_time:
                require(self.later(at[1], whens[at[0]]) == (1 if entry[2] == "+t" else -1),
                        f"box {at[1]} is there while piece {at[0]} is flown, or on its other side")
            require(by_time or apart(parts[at[0]], *self.boxes[at[1]], entry[2]), f"a plane does not part box {at[1]} from piece {at[0]}")
            out[at] = entry[2]
        return out

    def clear(self, points, proof, when=(F(0), F(0))):
        parts = list(pieces(points, proof.get("clear")))
        whens, at = [], F(0)
        for depth in proof["clear"]:
            length = F(1, 2**depth)
            whens.append([when[0] + (when[1] - when[0]) * share for share in (at, at + length)])
            at += length
        planes = self.planes(proof, parts, whens)
        for piece_number, piece in enumerate(parts):
            low, high = bounding_box(piece)
            for index in self.boxes.near([float(c) for c in low], [float(c) for c in high]):
                box = self.boxes[index]
                if any(h < l for h, l in zip(high, box[0])) or any(l > h for l, h in zip(low, box[1])):
                    continue
                require((piece_number, index) in planes, f"box {index} is not shown to miss piece {piece_number}")

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
        thrust = [[x, y, z + F(GRAVITY) * duration**2] for x, y, z in derivative(points, 2)]
        upward = [z for _, _, z in thrust]
        tangent = tangent_below(F(self.limits["tilt"]))
        cone = [tangent**2 * u - s
                for u, s in zip(square([[z] for z in upward]), square([[x, y] for x, y, _ in thrust]))]
        require_not_negative(upward, proof.get("tilt"), "tilt")
        require_not_negative(cone, proof.get("tilt"), "tilt")

    def thrust(self, points, duration, proof):
        if "thrust" not in self.limits:
            return
        thrust = [[x, y, z + F(GRAVITY) * duration**2] for x, y, z in derivative(points, 2)]
        most = (F(self.limits["thrust"]) * duration**2) ** 2
        require_not_negative([most - c for c in square(thrust)], proof.get("thrust"), "thrust")

    def body_rate(self, points, duration, proof):
        if "body_rate" not in self.limits:
            return
        force = [[x, y, z + F(GRAVITY) * duration**2] for x, y, z in derivative(points, 2)]
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

    def step_of(self, limit, before, after):
        """How far two segments may miss each other, where a limit on the next derivative holds."""
        return F(1e-3) * F(1001, 1000) * F(self.limits[limit]) * min(before[0], after[0])

    def yaw_joint(self, before, after):
        if before[2] is None or after[2] is None:
            return
        step = abs(before[2][-1] - after[2][0])
        require("yaw_rate" not in self.limits or step <= self.step_of("yaw_rate", before, after),
                "the yaw of two segments does not join")
        for order, most in enumerate([1e-9, 1e-6]):
            end = at_end([[y] for y in before[2]], order)[0] / before[0]**order
            begin = at_begin([[y] for y in after[2]], order)[0] / after[0]**order
            require(abs(begin - end) <= F(most) * F(1001, 1000), "the yaw of two segments does not join")

    def standing(self, segments, end):
        """No timed box holds the first point before the start, nor the last one after the end."""
        for i, (start, until) in self.times.items():
            low, high = self.boxes[i]
            for p, free in ((segments[0][1][0], start is not None and start > self.start),
                            (segments[-1][1][-1], until is not None and until < end)):
                require(free or not all(l <= c <= h for l, c, h in zip(low, p, high)), f"box {i} meets it where it stands")

    def joint(self, before, after, proof, instant):
        self.yaw_joint(before, after)
        for order, most in enumerate([1e-9, 1e-6, 1e-4]):
            end = at_end(before[1], order)
            begin = at_begin(after[1], order)
            step = [b / after[0]**order - e / before[0]**order for b, e in zip(begin, end)]
            square = sum(c * c for c in step)
            require(square <= (F(most) * F(1001, 1000)) ** 2, "two segments do not join")
            for limit in (("vmax", "vmax_h", "vmax_v"), ("amax",), ("jmax", "body_rate"))[order]:
                force = [c / before[0]**2 for c in end] if limit == "body_rate" else None
                unit = sum((c + (F(GRAVITY) if axis == 2 else 0)) ** 2 for axis, c in enumerate(force)) if force else 1
                require(limit not in self.limits or square <= self.step_of(limit, before, after) ** 2 * unit,
                        "two segments do not join")
        if before[1][-1] != after[1][0]:
            require("gap" in proof, "the step between two segments is not shown to be clear")
            self.clear([before[1][-1], after[1][0]], proof["gap"], (instant, instant))

    def trajectory(self, record, proofs):
        segments = [a_segment(s, f"segments[{i}]") for i, s in enumerate(entries(record.get("segments"), "segments"))]
        require(segments, "there is no segment")
        require_near(record, "duration", float(sum(s[0] for s in segments)))
        check_keys(proofs, len(segments), lambda i: {"clear", "bounds", "planes", "gap"} | {
            cover for cover, limit in COVERS.items()
            if limit in self.limits and (cover != "yaw_rate" or segments[i][2] is not None)})
        with_yaw = [s[2] is not None for s in segments]
        require("yaw_rate" not in self.limits or all(with_yaw) or not any(with_yaw), "a segment without yaw between others")
        instants = [F(0) if self.start is None else self.start]
        for duration, _, _ in segments:
            instants.append(instants[-1] + duration)
        if self.stands:
            self.standing(segments, instants[-1])
        for i, ((duration, points, yaw), proof) in enumerate(zip(segments, proofs)):
            self.clear(points, proof, instants[i:i + 2])
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
        for before, after, proof, instant in zip(segments, segments[1:], proofs, instants[1:]):
            self.joint(before, after, proof, instant)
        require("gap" not in proofs[-1], "a gap after the last segment")

    def path(self, record, proofs):
        points = [[F(c) for c in numbers(p, 3, f"points[{i}]")] for i, p in enumerate(entries(record.get("points"), "points"))]
        require(points, "there is no point")
        stops(record, len(points))
        legs = list(zip(points, points[1:])) or [(points[0], points[0])]
        require_near(record, "length", math.fsum(math.dist(*([float(c) for c in p] for p in leg)) for leg in legs))
        check_keys(proofs, len(legs), lambda _: {"clear", "bounds", "planes"})
        for leg, proof in zip(legs, proofs):
            self.clear(list(leg), proof)
            self.inside(list(leg), proof)


def a_segment(segment, what):
    """Its duration, control points, and yaw values or None."""
    an_object(segment, what)
    duration = number(segment.get("duration"), f"{what}.duration", SHORTEST, LONGEST)
    axes = [numbers(segment.get(axis), 8, f"{what}.{axis}") for axis in "xyz"]
    yaw = [F(y) for y in numbers(segment["yaw"], 8, f"{what}.yaw")] if "yaw" in segment else None
    return F(duration), [[F(c) for c in p] for p in zip(*axes)], yaw


def require_near(record, key, value):
    """What a record says of itself, where it does, is what its curve is."""
    if key in record:
        found = number(record[key], key, 0)
        require(abs(found - value) <= 1e-9 * value, f"{key} is {value}, found {found}")


def stops(record, count):
    """The holds and velocities of a path are no part of what is shown; they must be what they should."""
    if "hold" in record:
        numbers(record["hold"], count, "hold", least=0)
    if "velocity" in record:
        velocities = entries(record["velocity"], "velocity")
        require(len(velocities) == count, f"velocity must have {count} entries, found {len(velocities)}")
        for i, v in enumerate(velocities):
            if v is not None:
                numbers(v, 3, f"velocity[{i}]")


def check_keys(proofs, count, allowed):
    """A proof for each segment or leg, and in it nothing that would not be looked at."""
    require(len(entries(proofs, "segments of a certificate")) == count, f"{len(proofs)} proofs for {count} parts")
    for i, proof in enumerate(proofs):
        an_object(proof, f"proof {i}")
        require(set(proof) <= allowed(i), f"proof {i} speaks of {sorted(set(proof) - allowed(i))}, for which nothing is claimed")
        gap = an_object(proof.get("gap", {}), "a gap")
        require(set(gap) <= {"clear", "planes"}, f"a gap of {sorted(gap)}")


# ---- What is claimed.

def limits_of(record):
    """Those of a record, or of a vehicle."""
    limits = an_object(record.get("limits", {}), "limits")
    require(set(limits) <= set(LIMITS), f"unknown limits: {sorted(set(limits) - set(LIMITS))}")
    for key, value in limits.items():
        number(value, f"limits.{key}", LEAST_LIMIT, LARGEST_LIMIT)
    require(limits.get("tilt", 1) <= math.pi / 2, f"limits.tilt must be below a right angle, found {limits.get('tilt')}")
    require(limits.get("thrust", 10) > GRAVITY, f"limits.thrust must be > {GRAVITY}, found {limits.get('thrust')}")
    return limits


def said_by(record, box_map, what, keys, hashes):
    """What a record, or a certificate, says was asked. All of `keys` must be there."""
    missing = [key for key in keys if key not in record]
    require(not missing, f"{what} does not say {missing}")
    require(record.get("map", box_map.hash) in hashes, f"{what} is of another map: {shown(record.get('map'))}, this one is {box_map.hash}")
    require(record.get("frame", box_map.frame) == box_map.frame, f"{what} is in the frame {shown(record.get('frame'))}, the map in {box_map.frame}")
    vehicle = an_object(record.get("vehicle", {"half": [0, 0, 0]}), f"the vehicle of {what}")
    if "name" in vehicle:
        text(vehicle, "name", "a vehicle")
    return {"half": numbers(vehicle.get("half"), 3, f"vehicle.half of {what}", least=0),
            "margin": number(record.get("margin", 0), f"margin of {what}", least=0),
            "limits": stricter(limits_of(record), limits_of(vehicle))}


def stricter(some, others):
    """Of each limit the smaller, or the only one."""
    return {key: min(limits[key] for limits in (some, others) if key in limits)
            for key in LIMITS if key in some or key in others}


def claim_of(record, certificate, box_map):
    """The stricter of what was asked for the record and what the certificate was made with."""
    sides = [numbers(s, 3, "the bounds") for s in entries(certificate.get("bounds"), "the bounds of the certificate")]
    require(sides == list(box_map.bounds), "the certificate has other bounds than the map")
    asked = said_by(record, box_map, "the record", (), (box_map.hash, box_map.always_there))
    made = said_by(certificate, box_map, "the certificate", ("map", "frame", "vehicle", "margin"), (box_map.hash,))
    claim = {"half": [max(pair) for pair in zip(asked["half"], made["half"])],
             "margin": max(asked["margin"], made["margin"]), "limits": stricter(asked["limits"], made["limits"])}
    return claim | times_claimed(record, certificate, box_map)


def times_claimed(record, certificate, box_map):
    """When the flight begins by the map's clock, where the certificate counts boxes by time."""
    for one, what in ((record, "the record"), (certificate, "the certificate")):
        if box_map.epoch is not None and "epoch" in one:
            require(an_epoch(one["epoch"], what) == box_map.epoch, f"{what} counts from {one['epoch']}, the map from {box_map.epoch}")
    require("parked" not in certificate or ("start" in certificate and certificate["parked"] == "pad"), "parked must be \"pad\", with a start")
    if "start" not in certificate:
        return {}
    require(record.get("type") == "trajectory" and box_map.times, "a start is claimed where no time counts")
    require("epoch" in record and "epoch" in certificate, "a start without the epoch that it counts from")
    start = F(number(record.get("start"), "start of the record", -SECONDS, SECONDS))
    require(F(number(certificate["start"], "start of the certificate", -SECONDS, SECONDS)) == start, "the certificate has another start than the record")
    return {"start": start} | {key: certificate[key] for key in ("parked",) if key in certificate}


def verify(record, certificate, box_map):
    """Raises Refused; else says what has been shown."""
    kind = text(record, "type", "a record")
    require(kind in ("trajectory", "path"), f"a record of type {shown(kind)}")
    status = record.get("status", "solved" if kind == "trajectory" else "found")
    require(status == ("solved" if kind == "trajectory" else "found"), f"the record says {shown(status)}")
    require(certificate.get("type") == "certificate" and certificate.get("id") == record.get("id"), "it is no certificate of this record")
    require(certificate.get("of") == kind, f"the certificate is of a {shown(certificate.get('of'))}")
    claim = claim_of(record, certificate, box_map)
    verifier = Verifier(box_map, claim)
    proofs = certificate.get("segments")
    if kind == "trajectory":
        verifier.trajectory(record, proofs)
        return {key: float(value) if key == "start" else value for key, value in claim.items()}
    verifier.path(record, proofs)
    return {"half": claim["half"], "margin": claim["margin"]}


def verify_files(record_file, map_file, certificate_file):
    """Prints what became of each record, and says how many were refused."""
    box_map, records, certificates = BoxMap(map_file), by_id(record_file), by_id(certificate_file, ("apart", "together", "clear_of", "clear_of_moving", "returns"))
    print(f"map {box_map.hash}: {len(box_map.boxes)} boxes, bounds {json.dumps(box_map.bounds)}")
    refused = [f"{name!a}: refused: there is no record of this certificate" for name in certificates if name not in records]
    names = list(records)

    def look(i):
        """Whether a record has a certificate that holds, and what to say of it."""
        name = names[i]
        try:
            require(name in certificates, "there is no certificate")
            return True, f"{name!a}: holds for {json.dumps(verify(records[name], certificates[name], box_map))}"
        except Refused as reason:
            return False, f"{name!a}: refused: {reason}"

    for holds, words in on_all_cores(look, len(names)):
        if holds:
            print(words)
        else:
            refused.append(words)
    print("\n".join(refused), end="\n" if refused else "")
    return len(refused)


ALONE = 16  # that are not worth several processes
look_of_all = None  # for other processes, which have it from the start


def look_at(i):
    return look_of_all(i)


def on_all_cores(look, count):
    """What look(i) gives for each i below `count`, in order; by several processes if there are many."""
    global look_of_all
    cores = os.cpu_count() or 1
    if cores == 1 or count < ALONE:
        yield from map(look, range(count))
        return
    look_of_all = look
    with concurrent.futures.ProcessPoolExecutor(cores, multiprocessing.get_context("fork")) as pool:
        yield from pool.map(look_at, range(count), chunksize=max(1, count // (64 * cores)))


def run_main(usage, files, verified):
    """Of a script like this one: how many are refused of what its arguments name, as an exit code."""
    if len(sys.argv) != files + 1:
        print(usage, file=sys.stderr)
        sys.exit(2)
    try:
        sys.exit(verified(*sys.argv[1:]) > 0)
    except (Refused, EOFError, KeyError, OSError, RecursionError, SyntaxError, ValueError, NotImplementedError,
            RuntimeError, struct.error, zipfile.BadZipFile, zlib.error) as reason:
        print(f"refused: {type(reason).__name__}: {reason}".replace("Refused: ", ""), file=sys.stderr)
        sys.exit(3)


def main():
    run_main(__doc__, 3, verify_files)


if __name__ == "__main__":
    main()
