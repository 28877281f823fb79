"""verify_enclosure.py MAP.boxmap ENCLOSURES: follows every proof that there is no way, in exact numbers.

ENCLOSURES is what `skyway-plan --certificate` wrote (JSON Lines); records of bounds are left to verify_bound.py. The map's hash is worked out of its frame, bounds and
boxes. Exit 0 when there is a record and each holds, a line each saying what it proves; 1 when one is refused, with the
reason; 2 for wrong usage; 3 when a file cannot be read as what it should be. docs/certificates.md says what is checked.
"""

import math
import pathlib
import sys
from fractions import Fraction as F

sys.path.append(str(pathlib.Path(__file__).resolve().parent.parent / "check"))
from verify_certificate import BoxMap, Refused, an_object, by_id, corners, entries, number, numbers, require, run_main, text

LARGEST = 1e8


def slack(value):
    """What grown boxes reach further, and bounds less far: how the tools round."""
    return max(F(1, 10**9), 4 * F(math.ulp(float(value))))


def grown(box, half):
    low, high = ([F(v) for v in corner] for corner in (box[:3], box[3:]))
    return ([a - h - slack(a - h) for a, h in zip(low, half)], [b + h + slack(b + h) for b, h in zip(high, half)])


def holds_point(cell, point):
    return all(a <= p <= b for a, p, b in zip(cell[0], point, cell[1]))


def overlap(a, b):
    return all(x <= w and z <= y for x, y, z, w in zip(a[0], a[1], b[0], b[1]))


def steps(low, high, marks):
    """The stretches that marks cut low to high into; of no length where these are one."""
    if low == high:
        return [(low, high)]
    lines = sorted({low, high} | {m for m in marks if low < m < high})
    return list(zip(lines, lines[1:]))


def covered(cell, axis, covers):
    """Whether the face of a cell across an axis lies in the union of what covers it, all closed."""
    p, q = (a for a in range(3) if a != axis)
    for x in steps(cell[0][p], cell[1][p], [v for c in covers for v in (c[0][p], c[1][p])]):
        for y in steps(cell[0][q], cell[1][q], [v for c in covers for v in (c[0][q], c[1][q])]):
            if not any(c[0][p] <= x[0] and x[1] <= c[1][p] and c[0][q] <= y[0] and y[1] <= c[1][q] for c in covers):
                return False
    return True


class Enclosure:
    def __init__(self, record, box_map):
        require(record.get("type") == "enclosure", "the record is no enclosure")
        require(record.get("map") == box_map.hash, "it is of another map")
        require(record.get("frame") == box_map.frame, "it is of another frame")
        vehicle = an_object(record.get("vehicle"), "the vehicle")
        margin = F(number(record.get("margin"), "the margin", 0))
        self.half = [F(v) + margin for v in numbers(vehicle.get("half"), 3, "the half sizes", 0)]
        bounds = corners(sum((numbers(c, 3, "a corner") for c in self.pair(record.get("bounds"), "the bounds")), []), "the bounds")
        require(bounds == box_map.bounds, "the bounds are not the map's")
        self.inner = ([F(a) + h for a, h in zip(bounds[0], self.half)], [F(b) - h for b, h in zip(bounds[1], self.half)])
        self.ends = {key: [F(v) for v in numbers(record.get(key), 3, key)] for key in ("from", "to")}
        self.around = text(record, "around", "the record")
        require(self.around in self.ends, "around must be from or to")
        self.cells = [self.cell(value) for value in entries(record.get("cells"), "cells")]
        self.boxes = [grown(box, self.half) for box in box_map.boxes]

    @staticmethod
    def pair(value, what):
        require(type(value) is list and len(value) == 2, f"{what} must be two corners")
        return value

    def cell(self, value):
        low, high = ([F(v) for v in numbers(c, 3, "a corner of a cell")] for c in self.pair(value, "a cell"))
        for axis, (a, b) in enumerate(zip(low, high)):
            flat = self.inner[1][axis] - self.inner[0][axis] <= 2 * slack(a)
            require(a < b or (a == b and flat), "a cell has no inside")
        return low, high

    def at_bounds(self, cell, axis, up):
        edge = cell[up][axis]
        limit = self.inner[up][axis]
        return edge >= limit - slack(limit) if up else edge <= limit + slack(limit)

    def verify(self):
        inside, outside = (self.ends[key] for key in ((self.around, "to" if self.around == "from" else "from")))
        require(any(holds_point(cell, inside) for cell in self.cells), f"no cell holds {self.around}")
        require(not any(holds_point(cell, outside) for cell in self.cells), "a cell holds both ends' sides")
        against = [{}, {}, {}], [{}, {}, {}]  # cells by where they begin and end along an axis
        for cell in self.cells:
            for up in (0, 1):
                for axis in range(3):
                    against[up][axis].setdefault(cell[up][axis], []).append(cell)
        for cell in self.cells:
            near = [box for box in self.boxes if overlap(box, cell)]
            for axis in range(3):
                for up in (0, 1):
                    edge = cell[up][axis]
                    if cell[0][axis] == cell[1][axis] or self.at_bounds(cell, axis, up):
                        continue
                    covers = [c for c in against[1 - up][axis].get(edge, ()) if c is not cell and overlap(c, cell)]
                    covers += [box for box in near if box[0][axis] <= edge <= box[1][axis]]
                    require(covered(cell, axis, covers), f"a face of the cell {[float(v) for v in cell[0] + cell[1]]} is open")


def verify(record, box_map):
    Enclosure(record, box_map).verify()


def verify_files(map_file, enclosures):
    box_map = BoxMap(map_file)
    refused = found = 0
    for name, record in by_id(enclosures).items():
        if record.get("type") == "bound":
            continue
        found += 1
        try:
            verify(record, box_map)
            half = ", ".join(f"{v:g}" for v in record["vehicle"]["half"])
            print(f"{name}: no way from {record['from']} to {record['to']} for half sizes {half} and margin {record['margin']:g}")
        except Refused as reason:
            refused += 1
            print(f"{name}: refused: {reason}", file=sys.stderr)
    require(found, f"{enclosures}: there is no enclosure")
    return refused


def main():
    run_main(__doc__, 2, verify_files)


if __name__ == "__main__":
    main()
