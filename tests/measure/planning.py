"""planning.py BIN_DIR MAP paths|rooms [COUNT]: what a planner must not get wrong, on a map and vehicle box:1,1,1.

paths: COUNT random queries (10,000 found ones) each of 45-50 m and 600-700 m, with ends anywhere and with both ends
under 30 m and the straight line blocked, planned with a roadmap; every leg of every path is held against every
box by the separating-axis test in NumPy, grown by a vehicle a nanometre smaller. Exit 1 when one touches.
rooms: 12 closed rooms put onto the map; queries into and out of them must be `unreachable`. Says how long they took.
"""

import json
import math
import os
import pathlib
import random
import subprocess
import sys
import tempfile

import numpy as np

BIN = pathlib.Path(sys.argv[1])
MAP = sys.argv[2]
HALF = 1.0
ROOM_SIDES = [25, 50, 100]
ROOM_HEIGHT = 20


def run(*args, text=None):
    done = subprocess.run([str(BIN / args[0]), *map(str, args[1:])], input=text, capture_output=True, text=True)
    if done.returncode > 1:
        sys.exit(done.stderr)
    return done.stdout


def read_boxes(box_map):
    lines = run("skyway-map", "to-csv", box_map).splitlines()[1:]
    table = np.array([[float(c) for c in line.split(",")[:6]] for line in lines])
    return table[:, :3] - (HALF - 1e-9), table[:, 3:] + (HALF - 1e-9)


def legs_touching(points, low, high):
    """Which legs touch a closed box: the nine axes and three faces of Ericson's segment against box."""
    middle, half = (low + high) / 2, (high - low) / 2
    for a, b in zip(points, points[1:]):
        m, d = (np.array(a) + b) / 2 - middle, np.abs(np.subtract(b, a)) / 2
        near = np.all(np.abs(m) <= half + d, axis=1)
        m, half_near, e = m[near], half[near], np.subtract(b, a) / 2
        apart = np.zeros(len(m), bool)
        for i in range(3):
            j, k = (i + 1) % 3, (i + 2) % 3
            apart |= np.abs(m[:, j] * e[k] - m[:, k] * e[j]) > half_near[:, j] * d[k] + half_near[:, k] * d[j]
        yield bool((~apart).any())


def random_queries(bounds, length, street, seed):
    chance = random.Random(seed)
    low, high = bounds
    top = min(30, high[2] - 1.1) if street else high[2] - 1.1
    while True:
        a = [chance.uniform(low[i] + 1.1, high[i] - 1.1) for i in range(2)] + [chance.uniform(low[2] + 1.1, top)]
        z, way = chance.uniform(low[2] + 1.1, top), chance.uniform(0, 2 * math.pi)
        across = chance.uniform(*length) ** 2 - (z - a[2]) ** 2
        if across < 0:
            continue
        b = [a[0] + math.sqrt(across) * math.cos(way), a[1] + math.sqrt(across) * math.sin(way), z]
        if all(low[i] + 1.1 < b[i] < high[i] - 1.1 for i in range(2)):
            yield {"from": a, "to": b}


def found_paths(folder, roadmap, length, street, count):
    """Batches of queries until so many have a path (at street level: one that is not the straight line)."""
    queries, found, batch = random_queries(map_bounds(MAP), length, street, seed=len(str(length)) + street), [], 0
    while len(found) < count:
        lines = "".join(json.dumps({"id": f"{batch}-{i}", **next(queries)}) + "\n" for i in range(20000))
        batch += 1
        for line in run("skyway-plan", MAP, "--vehicle", f"box:{HALF},{HALF},{HALF}", "--roadmap", roadmap,
                        "--queries", "-", "-q", text=lines).splitlines():
            record = json.loads(line)
            if record["status"] == "found" and not (street and record["search"]["method"] == "straight"):
                found.append(record)
    return found[:count]


def map_bounds(box_map):
    info = dict(line.split(": ", 1) for line in run("skyway-info", box_map).splitlines())
    return json.loads(info["bounds_min_m"]), json.loads(info["bounds_max_m"])


def paths(count):
    low, high = read_boxes(MAP)
    bad = 0
    with tempfile.TemporaryDirectory() as folder:
        roadmap = os.path.join(folder, "r.roadmap")
        run("skyway-roadmap", MAP, "--vehicle", f"box:{HALF},{HALF},{HALF}", "-q", "-o", roadmap)
        for street in (False, True):
            for length in ((45, 50), (600, 700)):
                found = found_paths(folder, roadmap, length, street, count)
                touching = sum(any(legs_touching(record["points"], low, high)) for record in found)
                bad += touching
                print(f"{'street' if street else 'anywhere'} {length[0]}-{length[1]} m: {len(found)} paths, "
                      f"{touching} touch a box", flush=True)
    sys.exit(bad > 0)


def room(x, y, side):
    """Four walls and a roof of a metre."""
    top = ROOM_HEIGHT
    return [(x, y, 0, x + 1, y + side, top), (x + side - 1, y, 0, x + side, y + side, top),
            (x, y, 0, x + side, y + 1, top), (x, y + side - 1, 0, x + side, y + side, top),
            (x, y, top, x + side, y + side, top + 1)]


def rooms(count):
    chance = random.Random(7)
    low, high = map_bounds(MAP)
    walls, queries = [], []
    for n in range(count):
        side = chance.choice(ROOM_SIDES)
        x, y = (chance.uniform(low[i] + 65, high[i] - 65 - side) for i in range(2))
        walls += room(x, y, side)
        for k in range(6):
            inside = [x + chance.uniform(3, side - 3), y + chance.uniform(3, side - 3),
                      chance.uniform(3, ROOM_HEIGHT - 3)]
            outside = [chance.uniform(low[i] + 15, high[i] - 15) for i in range(2)] + [chance.uniform(3, 100)]
            ends = (outside, inside) if k % 2 else (inside, outside)
            queries.append({"id": f"{n}.{k}", "from": ends[0], "to": ends[1]})
    with tempfile.TemporaryDirectory() as folder:
        table, closed, roadmap, asked, report = (os.path.join(folder, name) for name in
                                                 ("walls.csv", "c.boxmap", "c.roadmap", "q.jsonl", "report.json"))
        with open(table, "w") as file:
            file.write("min_x_m,min_y_m,min_z_m,max_x_m,max_y_m,max_z_m,label\n")
            file.writelines(",".join(map(str, wall)) + ",\n" for wall in walls)
        with open(asked, "w") as file:
            file.writelines(json.dumps(q) + "\n" for q in queries)
        run("skyway-map", "patch", MAP, "--add", table, "-o", closed)
        run("skyway-roadmap", closed, "--vehicle", f"box:{HALF},{HALF},{HALF}", "-q", "-o", roadmap)
        run("skyway-bench", closed, "--vehicle", f"box:{HALF},{HALF},{HALF}", "--roadmap", roadmap, "--queries", asked,
            "-q", "-o", report)
        with open(report) as file:
            method = json.load(file)["methods"][0]
    print(f"{method['unreachable']} unreachable, {method['found']} found, {method['failed']} with a blocked end; "
          f"ms {method['time_ms']}")
    sys.exit(method["found"] > 0)


if sys.argv[3] == "paths":
    paths(int(sys.argv[4]) if len(sys.argv) > 4 else 10000)
else:
    rooms(int(sys.argv[4]) if len(sys.argv) > 4 else 12)
