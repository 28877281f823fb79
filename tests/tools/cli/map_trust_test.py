"""map_trust_test.py BIN_DIR SOURCE_DIR: what files say of themselves, as processes.

Maps whose tiles' extents hide boxes, whose boxes are gone under the old hash, or whose bytes changed under the old
checksums; lattices and roadmaps that call everything free. The files are written anew with right checksums. No tool may
say yes of them to what the true boxes refuse.
"""

import json
import os
import pathlib
import random
import subprocess
import sys
import tempfile
import time
import zipfile

import numpy

BIN, SOURCE = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
VEHICLE = ["--vehicle", "box:0.5,0.5,0.5"]
PROFILE = ["--vehicle", SOURCE / "data/vehicles/quad2kg.json"]
failed = []
counts = {}


def expect(kind, ok, what):
    refused, tried = counts.get(kind, (0, 0))
    counts[kind] = (refused + bool(ok), tried + 1)
    if not ok:
        failed.append(f"{kind}: {what}")


def run(*args, stdin=None):
    try:
        done = subprocess.run([str(BIN / args[0]), *map(str, args[1:])], input=stdin, capture_output=True, timeout=60)
    except subprocess.TimeoutExpired:
        return None, b"", "took more than 60 s"
    return done.returncode, done.stdout, done.stderr.decode(errors="replace")


def read(path):
    with zipfile.ZipFile(path) as archive:
        meta = json.loads(archive.read("meta.json"))
    return meta, {name: values for name, values in numpy.load(path).items() if name != "meta.json"}


def write(path, meta, arrays):
    """With right checksums, and data aligned as Skyway reads them."""
    with zipfile.ZipFile(path, "w", zipfile.ZIP_STORED) as archive:
        archive.writestr(zipfile.ZipInfo("meta.json"), json.dumps(meta))
        for name, values in arrays.items():
            info = zipfile.ZipInfo(name + ".npy")
            before = archive.fp.tell() + 30 + len(info.filename) + 4
            pad = -before % 64
            info.extra = b"\x35\xd9" + pad.to_bytes(2, "little") + bytes(pad)
            with archive.open(info, "w") as entry:
                numpy.lib.format.write_array(entry, numpy.ascontiguousarray(values), version=(1, 0))
    return path


def records(a, b):
    """A path and a trajectory straight from a to b, at rest at both ends, that say nothing of a map."""
    path = {"type": "path", "id": "p", "status": "found", "length": 1.0, "points": [a, b]}
    segment = {"duration": 60.0}
    for axis, name in enumerate("xyz"):
        segment[name] = [a[axis]] * 4 + [b[axis]] * 4
    trajectory = {"type": "trajectory", "id": "p", "status": "solved", "duration": 60.0, "segments": [segment]}
    return json.dumps(path), json.dumps(trajectory)


class Case:
    """A map, a box of it, and a straight way through the middle of that box."""

    def __init__(self, folder, meta, arrays, rng):
        boxes = arrays["boxes"]
        self.folder, self.meta, self.arrays = folder, meta, {k: v.copy() for k, v in arrays.items()}
        while True:
            self.box = rng.randrange(len(boxes))
            low, high = boxes[self.box, :3], boxes[self.box, 3:]
            if high[2] - low[2] > 4 and low[0] > meta["bounds"][0][0] + 9 and high[0] < meta["bounds"][1][0] - 9:
                break
        middle = (low + high) / 2
        self.a = [float(low[0] - 3), float(middle[1]), float(middle[2])]
        self.b = [float(high[0] + 3), float(middle[1]), float(middle[2])]
        first, count = arrays["tile_range"][:, 0], arrays["tile_range"][:, 1]
        self.tile = int(numpy.nonzero((first <= self.box) & (self.box < first + count))[0][0])
        # All boxes that the way meets, that tile's or others'.
        self.meets = numpy.nonzero((boxes[:, 0] <= self.b[0] + 1) & (boxes[:, 3] >= self.a[0] - 1) &
                                   (abs((boxes[:, 1] + boxes[:, 4]) / 2 - middle[1]) <= (boxes[:, 4] - boxes[:, 1]) / 2 + 1) &
                                   (boxes[:, 2] <= middle[2] + 1) & (boxes[:, 5] >= middle[2] - 1))[0]

    def hide(self, rng):
        """Shrinks the extents of the tiles of what the way meets, towards one of their corners."""
        first, count = self.arrays["tile_range"][:, 0], self.arrays["tile_range"][:, 1]
        for t in {int(numpy.nonzero((first <= i) & (i < first + count))[0][0]) for i in self.meets}:
            extent = self.arrays["tile_extent"][t]
            if rng.random() < 0.5:
                extent[3:] = extent[:3]
            else:
                extent[:3] = extent[3:]

    def remove(self):
        keep = numpy.ones(len(self.arrays["boxes"]), bool)
        keep[self.meets] = False
        ends = numpy.concatenate([[0], numpy.cumsum(keep)])
        ranges = self.arrays["tile_range"]
        first = ends[ranges[:, 0].astype(int)]
        count = ends[(ranges[:, 0] + ranges[:, 1]).astype(int)] - first
        for name in ("boxes", "ids", "label"):
            self.arrays[name] = self.arrays[name][keep]
        left = count > 0
        self.arrays["tile_range"] = numpy.stack([first, count], 1).astype("<u8")[left]
        for name in ("tile_index", "tile_large", "tile_extent"):
            self.arrays[name] = self.arrays[name][left]
        self.meta = dict(self.meta, boxes=int(keep.sum()))

    def save(self):
        self.map = write(self.folder / "lying.boxmap", self.meta, self.arrays)
        path, trajectory = records(self.a, self.b)
        self.path, self.trajectory = self.folder / "path.jsonl", self.folder / "trajectory.jsonl"
        self.path.write_text(path + "\n")
        self.trajectory.write_text(trajectory + "\n")

    def ends(self):
        return ["--from=" + ",".join(map(repr, self.a)), "--to=" + ",".join(map(repr, self.b))]

    def deciding(self):
        """Commands whose yes is for good."""
        limits = ["--vmax", 1000, "--amax", 1000]
        out = ["-o", self.folder / "out"]
        return {
            "check": ["skyway-check", self.map, self.path, *VEHICLE],
            "check trajectory": ["skyway-check", self.map, self.trajectory, *VEHICLE, *limits],
            "check --exact": ["skyway-check", self.map, self.path, *VEHICLE, "--exact"],
            "check --certificate": ["skyway-check", self.map, self.path, *VEHICLE, "--certificate", self.folder / "why"],
            "export": ["skyway-export", self.map, self.trajectory, *VEHICLE, "--format", "setpoints", *out],
            "fly": ["skyway-fly", self.map, self.trajectory, *PROFILE, *out, "--report-file", self.folder / "report"],
            "map crop": ["skyway-map", "crop", self.map, "--bounds=-1e4,-1e4,-1e4,1e4,1e4,1e4", *out],
            "map join": ["skyway-map", "join", self.map, self.map, *out],
            "map merge": ["skyway-map", "merge", self.map, *out],
            "map tile": ["skyway-map", "tile", self.map, "--tile", 50, *out],
            "map inflate": ["skyway-map", "inflate", self.map, "--by", 0.1, *out],
            "map patch": ["skyway-map", "patch", self.map, "--remove", int(self.arrays["ids"][0]), *out],
            "map diff": ["skyway-map", "diff", self.map, self.map, *out],
            "map to-ply": ["skyway-map", "to-ply", self.map, *out],
            "map to-csv": ["skyway-map", "to-csv", self.map, *out],
            "import-flight": ["skyway-import-flight", self.path, "--map", self.map, *out],
            "import-trajectory": ["skyway-import-trajectory", self.path, "--map", self.map, *out],
        }

    def asking(self):
        """Commands that ask a scene."""
        out = ["-o", self.folder / "out"]
        box = ",".join(repr(v) for v in (self.a[0] - 20, self.a[1] - 20, 0, self.b[0] + 20, self.b[1] + 20, 60))
        return {
            "plan": ["skyway-plan", self.map, *VEHICLE, *self.ends()],
            "plan rrt": ["skyway-plan", self.map, *VEHICLE, *self.ends(), "--method", "rrt-connect"],
            "replan": ["skyway-replan", self.map, self.path, *VEHICLE],
            "traj": ["skyway-traj", self.map, self.path, *VEHICLE, "--vmax", 8, "--amax", 6],
            "lattice": ["skyway-lattice", self.map, *VEHICLE, "--spacing", 25, *out],
            "roadmap": ["skyway-roadmap", self.map, *VEHICLE, "--region=" + box, *out],
            "bench": ["skyway-bench", self.map, *VEHICLE, "--trials", 3],
            "map info": ["skyway-map", "info", self.map],
        }


def extents(folder, meta, arrays):
    rng = random.Random(1)
    for i in range(100):
        case = Case(folder, meta, arrays, rng)
        case.hide(rng)
        case.save()
        commands = case.asking() | case.deciding()
        names = ["plan", "check", "export"] + [list(commands)[i % len(commands)]]
        for name in names:
            code, out, error = run(*commands[name])
            expect("lying extents", code == 3 and "inside the extent" in error, f"{i}, {name}: {code} {error}{out[:200]}")
        query = json.dumps({"segment": [case.a, case.b]}).encode()
        code, out, error = run("skyway-query", case.map, *VEHICLE, stdin=query)
        expect("lying extents", code == 3 and b'"hit":false' not in out, f"{i}, query: {code} {out}{error}")
        with open(case.map, "rb") as file:
            code, out, error = run("skyway-check", "-", case.path, *VEHICLE, stdin=file.read())
        expect("lying extents, stdin", code == 3, f"{i}: {code} {out}")


def old_hash(folder, meta, arrays):
    rng = random.Random(2)
    for i in range(4):
        case = Case(folder, meta, arrays, rng)
        case.remove()
        case.save()
        for name, command in case.deciding().items():
            (folder / "out").unlink(missing_ok=True)
            code, out, error = run(*command)
            expect("boxes removed under the old hash", code == 3 and "hash" in error and not (folder / "out").exists(),
                   f"{i}, {name}: {code} {error}{out[:200]}")
        code, out, _ = run("skyway-info", "--verify", case.map)
        expect("boxes removed under the old hash", code == 3, f"{i}, info --verify: {code}")


def damaged(folder, meta, arrays):
    rng = random.Random(3)
    for i in range(20):
        case = Case(folder, meta, arrays, rng)
        case.save()
        data = bytearray(case.map.read_bytes())
        with zipfile.ZipFile(case.map) as archive:
            entry = archive.getinfo(rng.choice(["boxes.npy", "ids.npy", "label.npy", "tile_extent.npy"]))
        at = entry.header_offset + 200 + rng.randrange(entry.file_size - 200)
        data[at] ^= 1 << rng.randrange(8)
        case.map.write_bytes(data)
        name, command = rng.choice(list(case.deciding().items()))
        code, out, error = run(*command)
        expect("a bit flipped under the old checksum", code == 3, f"{i}, {name}: {code} {error}{out[:200]}")


def lying_lattice(path, out):
    meta, arrays = read(path)
    arrays["block_record"] = numpy.full_like(arrays["block_record"], 0xFFFFFFFE)
    arrays["records"] = arrays["records"][:0]
    write(out, meta, arrays)


def lying_roadmap(path, out, rng, move):
    """Edges lead anywhere; where asked, bends lie anywhere too, and tiles reach over all of them."""
    meta, arrays = read(path)
    n = len(arrays["bend_axis"])
    tile = numpy.searchsorted(arrays["tile_edges"], numpy.arange(len(arrays["edge_to"])), "right") - 1
    counts = numpy.diff(arrays["tile_first"])
    index, around = {tuple(i): t for t, i in enumerate(arrays["tile_index"].tolist())}, 5  # of a reach of 500 m
    slot = arrays["edge_to"] >> 24
    column = arrays["tile_index"][tile, 0] + slot % (2 * around + 1) - around
    row = arrays["tile_index"][tile, 1] + slot // (2 * around + 1) - around
    there = counts[[index[place] for place in zip(column.tolist(), row.tolist())]]
    arrays["edge_to"] = slot << 24 | (rng.random(len(slot)) * there).astype("<u4")
    if move:
        low, high = arrays["bend_position"].min(0), arrays["bend_position"].max(0)
        arrays["bend_position"] = rng.uniform(low, high, (n, 3))
        arrays["tile_extent"][:] = numpy.hstack([low - 1, high + 1])
    write(out, meta, arrays)


def artefacts(folder, city, small):
    """Every path that is said to be found passes the exact check on the map; some lies are met."""
    rng = numpy.random.default_rng(4)
    lattice, roadmap = folder / "true.lattice", folder / "true.roadmap"
    assert run("skyway-lattice", small, *VEHICLE, "--spacing", 10, "--connect", 26, "-o", lattice)[0] == 0
    assert run("skyway-roadmap", small, *VEHICLE, "-o", roadmap)[0] == 0
    lies = {"lattice": folder / "lying.lattice", "edges": folder / "edges.roadmap", "bends": folder / "bends.roadmap"}
    lying_lattice(lattice, lies["lattice"])
    lying_roadmap(roadmap, lies["edges"], rng, False)
    lying_roadmap(roadmap, lies["bends"], rng, True)
    meta, arrays = read(small)
    low, high = numpy.array(meta["bounds"]) + [[5, 5, 2], [-5, -5, 0]]
    high[2] = 15
    options = {"lattice": [["--lattice", lies["lattice"], "--raw"], ["--lattice", lies["lattice"]],
                           ["--lattice", lies["lattice"], "--method", "astar", "--raw"],
                           ["--lattice", lies["lattice"], "--quality", "best"]]}
    for kind in ("edges", "bends"):
        options[kind] = [["--roadmap", lies[kind], "--raw"], ["--roadmap", lies[kind]],
                         ["--roadmap", lies[kind], "--quality", "best"],
                         ["--roadmap", lies[kind], "--lattice", lies["lattice"]]]
    refusals = 0
    for i in range(8):
        a, b = rng.uniform(low, high), rng.uniform(low, high)
        ends = [f"--from={a[0]},{a[1]},{a[2]}", f"--to={b[0]},{b[1]},{b[2]}", "--snap-ends", 20]
        for kind, each in options.items():
            for more in each:
                code, out, error = run("skyway-plan", small, *VEHICLE, *ends, *more)
                ok = code in (0, 1, 3) and (code != 3 or "blocked on this map" in error)
                refusals += code == 3
                if code == 0:
                    ok = run("skyway-check", small, *VEHICLE, "--exact", stdin=out)[0] == 0
                expect(f"lying {kind}", ok, f"{i}, {more}: {code} {error}")
    expect("lies of lattices and roadmaps were met", refusals > 5, refusals)
    code, out, error = run("skyway-bench", small, *VEHICLE, "--lattice", lies["lattice"], "--roadmap", lies["edges"],
                           "--trials", 20, "--seed", 1)
    expect("lying lattice", code != 0 or b'"invalid": 0' in out, f"bench: {code} {error}")
    data = bytearray(roadmap.read_bytes())
    with zipfile.ZipFile(roadmap) as archive:
        entry = archive.getinfo("edge_to.npy")
    data[entry.header_offset + 400] ^= 1
    lies["edges"].write_bytes(data)
    code, out, error = run("skyway-roadmap", small, *VEHICLE, "--patch", lies["edges"], "--old-map", small, "-o",
                           folder / "out")
    expect("a damaged roadmap to patch", code == 3 and "CRC" in error, f"{code} {error}")


def directory(folder):
    """300,000 entries in the directory of a ZIP: refused at once."""
    path = folder / "many.boxmap"
    with zipfile.ZipFile(path, "w") as archive:
        for i in range(300000):
            archive.writestr(zipfile.ZipInfo(f"{i}.npy"), b"")
    begin = time.monotonic()
    code, _, error = run("skyway-map", "info", path)
    expect("a directory of 300,000 entries", code == 3 and time.monotonic() - begin < 5, f"{code} {error}")


with tempfile.TemporaryDirectory() as name:
    folder = pathlib.Path(name)
    os.environ["XDG_CACHE_HOME"] = str(folder / "cache")
    table, city, small = folder / "city.csv", folder / "city.boxmap", folder / "small.boxmap"
    for side, out in ((1400, city), (300, small)):
        assert run("skyway-synth", "--seed", 1, "--size", side, "-o", table)[0] == 0
        assert run("skyway-import", table, "-o", out)[0] == 0
    meta, arrays = read(city)
    assert len(arrays["boxes"]) > 8192  # more than one group
    extents(folder, meta, arrays)
    old_hash(folder, meta, arrays)
    damaged(folder, meta, arrays)
    artefacts(folder, city, small)
    directory(folder)

for kind, (refused, tried) in counts.items():
    print(f"{kind}: {refused} of {tried} as they should be")
for line in failed[:20]:
    print(line)
sys.exit(bool(failed))
