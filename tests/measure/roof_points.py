"""roof_points.py MODEL.json MAP.csv [N]: random points on the surfaces of a CityJSON model without a reference
system, held against the boxes of its map (skyway-footprints, then skyway-map to-csv).

N points (default 1e6) on all surfaces of each object's finest level of detail, by area: in a surface's own plane,
inside its outer ring and outside its holes. Prints how many of them, and of points below them, no box holds, and
the free volume beside prisms up to the highest point of each surface.
"""

import csv
import json
import random
import sys

MODEL, MAP = sys.argv[1:3]
N = int(float(sys.argv[3])) if len(sys.argv) > 3 else 1_000_000
random.seed(1)


def surfaces_of(model):
    scale, shift = [1, 1, 1], [0, 0, 0]
    if "transform" in model:
        scale, shift = model["transform"]["scale"], model["transform"]["translate"]
    vertices = [[v * s + t for v, s, t in zip(p, scale, shift)] for p in model["vertices"]]

    def flat(boundaries):
        if boundaries and boundaries[0] and isinstance(boundaries[0][0], int):
            yield [[vertices[i] for i in ring] for ring in boundaries]
        else:
            for part in boundaries:
                yield from flat(part)

    for item in model["CityObjects"].values():
        shapes = [g for g in item.get("geometry", []) if "Surface" in g["type"] or "Solid" in g["type"]]
        if shapes:
            best = max(float(g["lod"]) for g in shapes)
            rings = [s for g in shapes if float(g["lod"]) == best for s in flat(g["boundaries"])]
            low = min(p[2] for s in rings for p in s[0])
            yield from ((s, low) for s in rings)


def normal_of(ring):
    """Newell's."""
    n = [0.0, 0.0, 0.0]
    for a, b in zip(ring, ring[1:] + ring[:1]):
        for i in range(3):
            j, k = (i + 1) % 3, (i + 2) % 3
            n[i] += (a[j] - b[j]) * (a[k] + b[k]) / 2
    return n


def inside(ring, u, v):
    odd = False
    for (a, b), (c, d) in zip(ring, ring[1:] + ring[:1]):
        if (b > v) != (d > v) and u < a + (v - b) / (d - b) * (c - a):
            odd = not odd
    return odd


class Boxes:
    def __init__(self, path, cell=2.0):
        self.cell, self.at = cell, {}
        with open(path) as file:
            for row in csv.reader(file):
                if row[0] == "min_x_m":
                    continue
                box = [float(v) for v in row[:6]]
                for i in range(int(box[0] // cell), int(box[3] // cell) + 1):
                    for j in range(int(box[1] // cell), int(box[4] // cell) + 1):
                        self.at.setdefault((i, j), []).append(box)

    def hold(self, p):
        near = self.at.get((int(p[0] // self.cell), int(p[1] // self.cell)), ())
        return any(b[0] <= p[0] <= b[3] and b[1] <= p[1] <= b[4] and b[2] <= p[2] <= b[5] for b in near)


def points_on(surface, count):
    """Each with the distance of the corners from the plane, which its height may be off."""
    ring = surface[0]
    n = normal_of(ring)
    k = max(range(3), key=lambda i: abs(n[i]))
    if n[k] == 0:
        return
    i, j = (k + 1) % 3, (k + 2) % 3
    c = [sum(p[a] for p in ring) / len(ring) for a in range(3)]

    def lifted(u, v):
        p = [0.0] * 3
        p[i], p[j] = u, v
        p[k] = c[k] - (n[i] * (u - c[i]) + n[j] * (v - c[j])) / n[k]
        return p

    off = max(abs(lifted(p[i], p[j])[k] - p[k]) for p in ring) + 1e-9
    rings = [[(p[i], p[j]) for p in r] for r in surface]
    reach = [(min(p[a] for p in ring), max(p[a] for p in ring)) for a in (i, j)]
    top = max(p[2] for p in ring)
    while count > 0:
        u, v = (random.uniform(*r) for r in reach)
        if not inside(rings[0], u, v) or any(inside(r, u, v) for r in rings[1:]):
            count -= 0.01  # of a sliver, not for ever
            continue
        count -= 1
        p = lifted(u, v)
        p[2] = min(p[2], top)
        yield p, off if k == 2 else 0.0


def main():
    with open(MODEL) as file:
        surfaces = list(surfaces_of(json.load(file)))
    boxes = Boxes(MAP)
    area = [sum(v * v for v in normal_of(s[0])) ** 0.5 for s, _ in surfaces]
    points = outside = aside = 0
    for (surface, low), share in zip(surfaces, area):
        for p, off in points_on(surface, N * share / sum(area)):
            points += 1
            p[2] = max(low, p[2])  # the floor, rounded
            below = [p[0], p[1], random.uniform(low, p[2])]
            if not boxes.hold([p[0], p[1], max(low, p[2] - off)]) or not boxes.hold(below):
                outside += 1
                aside += off == 0.0
    print(f"{len(surfaces)} surfaces, {points} points: {outside} outside the boxes ({aside} of walls)")
    return outside


sys.exit(bool(main()))
