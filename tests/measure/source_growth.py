"""source_growth.py BIN_DIR [--only WORD] [--runs N] [--before DIR]: what each source of boxes takes at 1, 4 and 16 times a size.

Made-up data at the same density, in BIN_DIR's tools (build/test/tools; the peers are in build/test/tests/measure). For each source
and size: CPU seconds of the process on one thread, the least of N runs (default 3), boxes, the time beside the size before (1.0 where
it grows as the source does), and beside what GDAL, PCL or our JSON parser alone takes to read the same file. --before: the
same of another build's tools, in turn.
"""

import argparse
import array
import json
import math
import os
import pathlib
import random
import struct
import subprocess
import tempfile

TIMES = (1, 4, 16)


def houses(count):
    """Corner, sides, angle and height; 40 m apart."""
    random.seed(1)
    side = math.ceil(count**0.5)
    for i in range(count):
        yield (40.0 * (i % side), 40.0 * (i // side), random.uniform(8, 25), random.uniform(8, 25),
               random.uniform(0, 1.5), round(random.uniform(4, 40), 1))


def outline(x, y, a, b, turn):
    """An L-shaped house."""
    corners = [(0, 0), (a, 0), (a, b / 2), (a / 2, b / 2), (a / 2, b), (0, b)]
    cos, sin = math.cos(turn), math.sin(turn)
    return [(x + u * cos - v * sin, y + u * sin + v * cos) for u, v in corners]


def degrees(x, y):
    return 16 + x / 74000, 48 + y / 111200


def geojson(path, times):
    with open(path, "w") as out:
        out.write('{"type":"FeatureCollection","features":[\n')
        for i, (x, y, a, b, turn, height) in enumerate(houses(1000 * times)):
            ring = [degrees(*p) for p in outline(x, y, a, b, turn)]
            geometry = {"type": "Polygon", "coordinates": [ring + ring[:1]]}
            feature = {"type": "Feature", "properties": {"height": height}, "geometry": geometry}
            out.write(("," if i else "") + json.dumps(feature) + "\n")
        out.write("]}\n")


def osm(path, times):
    with open(path, "w") as out:
        ways = []
        out.write('<?xml version="1.0"?>\n<osm version="0.6">\n')
        for i, (x, y, a, b, turn, height) in enumerate(houses(1000 * times)):
            refs = []
            for k, p in enumerate(outline(x, y, a, b, turn)):
                lon, lat = degrees(*p)
                refs.append(10 * i + k + 1)
                out.write(f'<node id="{refs[-1]}" version="1" lat="{lat:.8f}" lon="{lon:.8f}"/>\n')
            nodes = "".join(f'<nd ref="{r}"/>' for r in refs + refs[:1])
            ways.append(f'<way id="{i + 1}" version="1">{nodes}<tag k="building" v="yes"/>'
                        f'<tag k="height" v="{height}"/></way>\n')
        out.writelines(ways)
        out.write("</osm>\n")


def city_json(path, times):
    """Houses with a roof of two slopes."""
    objects, vertices = {}, []
    for i, (x, y, a, b, turn, height) in enumerate(houses(500 * times)):
        cos, sin = math.cos(turn), math.sin(turn)
        first = len(vertices)
        for u, v, z in [(0, 0, 0), (a, 0, 0), (a, b, 0), (0, b, 0), (0, 0, height), (a, 0, height), (a, b, height),
                        (0, b, height), (0, b / 2, height + 4), (a, b / 2, height + 4)]:
            vertices.append([round(1000 * c) for c in (x + u * cos - v * sin, y + u * sin + v * cos, z)])
        faces = [[0, 3, 2, 1], [0, 1, 5, 4], [1, 2, 6, 9, 5], [2, 3, 7, 6], [3, 0, 4, 8, 7], [4, 5, 9, 8], [6, 7, 8, 9]]
        shell = [[[first + k for k in face]] for face in faces]
        objects[f"h{i}"] = {"type": "Building", "geometry": [{"type": "Solid", "lod": "2", "boundaries": [shell]}]}
    model = {"type": "CityJSON", "version": "1.1", "transform": {"scale": [0.001] * 3, "translate": [6e5, 5.34e6, 0]},
             "metadata": {"referenceSystem": "https://www.opengis.net/def/crs/EPSG/0/32633"},
             "CityObjects": objects, "vertices": vertices}
    path.write_text(json.dumps(model))


def height_rows(width, height):
    random.seed(1)
    blocks = {}
    for j in range(height):
        row = array.array("f")
        for i in range(width):
            key = (i // 24, j // 24)
            if key not in blocks:
                blocks[key] = random.uniform(4, 30) if random.random() < 0.5 else 0
            house = blocks[key] if 4 <= i % 24 < 20 and 4 <= j % 24 < 20 else 0
            tree = random.uniform(0, 6) if random.random() < 0.2 else 0
            row.append(200 + 40 * math.sin(i / 180) * math.cos(j / 140) + house + tree)
        yield row.tobytes()


def height_model(cell):
    """A GeoTIFF of 4-byte floats in UTM: streets, houses and trees on hills; 757 x 1,132 cells at the largest."""

    def write(path, times):
        width, height = [round(side * math.sqrt(times / 16)) for side in (757, 1132)]
        keys = [1, 1, 0, 3, 1024, 0, 1, 1, 1025, 0, 1, 1, 3072, 0, 1, 32633]
        scale, tie = (cell, cell, 0.0), (0, 0, 0, 600000.0, 5340000.0, 0)
        entries = 13
        at_scale = 8 + 2 + 12 * entries + 4
        at_tie = at_scale + 24
        at_keys = at_tie + 48
        data = at_keys + 2 * len(keys)
        tags = [(256, 4, 1, width), (257, 4, 1, height), (258, 3, 1, 32), (259, 3, 1, 1), (262, 3, 1, 1), (273, 4, 1, data),
                (277, 3, 1, 1), (278, 4, 1, height), (279, 4, 1, 4 * width * height), (339, 3, 1, 3), (33550, 12, 3, at_scale),
                (33922, 12, 6, at_tie), (34735, 3, len(keys), at_keys)]
        with open(path, "wb") as out:
            out.write(b"II*\0" + struct.pack("<IH", 8, entries) + b"".join(struct.pack("<HHII", *tag) for tag in tags))
            out.write(struct.pack("<I3d6d", 0, *scale, *tie) + struct.pack(f"<{len(keys)}H", *keys))
            for row in height_rows(width, height):
                out.write(row)

    return write


def scan(path, times):
    """20 returns a square metre of a plane with blocks, as binary PCD."""
    random.seed(1)
    side = 40 * times**0.5
    points = array.array("f")
    for _ in range(int(20 * side * side)):
        x, y = random.uniform(0, side), random.uniform(0, side)
        block = x % 20 < 8 and y % 20 < 8
        points.extend((x, y, 9 + random.uniform(-0.05, 0.05) if block else random.uniform(-0.05, 0.05)))
    count = len(points) // 3
    head = (f"VERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\nWIDTH {count}\nHEIGHT 1\n"
            f"VIEWPOINT 0 0 0 1 0 0 0\nPOINTS {count}\nDATA binary\n")
    path.write_bytes(head.encode() + points.tobytes())


def mesh(path, times):
    """Round columns, closed."""
    random.seed(1)
    corners = 24
    with open(path, "w") as out:
        first = 1
        for x, y, a, _, _, height in houses(100 * times):
            for z in (0, height):
                for k in range(corners):
                    turn = 2 * math.pi * k / corners
                    out.write(f"v {x + a / 8 * math.cos(turn):.4f} {y + a / 8 * math.sin(turn):.4f} {z}\n")
            for k in range(corners):
                low, next_low = first + k, first + (k + 1) % corners
                high, next_high = low + corners, next_low + corners
                out.write(f"f {low} {next_low} {next_high}\nf {low} {next_high} {high}\n")
                if 0 < k < corners - 1:
                    out.write(f"f {first} {next_low} {low}\nf {first + corners} {high} {next_high}\n")
            first += 2 * corners


GDAL, JSON, PCL = "read_gdal", "read_json", "read_pcl"
SOURCES = [
    ("footprints, GeoJSON", geojson, "geojson", ["skyway-footprints", "--threads", "1"], GDAL),
    ("footprints, OSM", osm, "osm", ["skyway-footprints", "--threads", "1"], GDAL),
    ("city model, CityJSON LoD2", city_json, "city.json", ["skyway-footprints", "--threads", "1"], JSON),
    ("height model, cells of 1 m", height_model(1.0), "tif", ["skyway-footprints", "--threads", "1"], GDAL),
    ("height model, cells of 10 m", height_model(10.0), "tif", ["skyway-footprints", "--threads", "1"], GDAL),
    ("cloud, columns", scan, "pcd", ["skyway-cloud"], PCL),
    ("cloud, columns without ground", scan, "pcd", ["skyway-cloud", "--ground-points", "drop"], PCL),
    ("cloud, objects", scan, "pcd", ["skyway-cloud", "--mode", "objects"], PCL),
    ("mesh, solid, OBJ", mesh, "obj", ["skyway-mesh", "--solid", "--threads", "1"], None),
]


def seconds(command):
    child = subprocess.Popen([str(word) for word in command], stdout=subprocess.PIPE, stderr=subprocess.PIPE)
    _, errors = child.stdout.read(), child.stderr.read()
    _, status, usage = os.wait4(child.pid, 0)
    child.returncode = os.waitstatus_to_exitcode(status)
    if child.returncode != 0:
        raise SystemExit(f"{command}: {errors.decode()}")
    return usage.ru_utime + usage.ru_stime


def boxes_of(map_file, tools):
    found = subprocess.run([tools / "skyway-map", "info", map_file], capture_output=True, text=True, check=True).stdout
    return next(int(line.split()[1]) for line in found.splitlines() if line.startswith("boxes:"))


def measure(name, write, suffix, command, peer, options):
    before = {}
    for times in TIMES:
        with tempfile.TemporaryDirectory() as folder:
            folder = pathlib.Path(folder)
            source = folder / f"source.{suffix}"
            write(source, times)
            folders = [options.tools] + ([options.before] if options.before else [])
            commands = [[tools / command[0], source, *command[1:], "-q", "-o", folder / f"{k}.map"]
                        for k, tools in enumerate(folders)]
            if peer:
                commands.append([options.tools.parent / "tests/measure" / peer, source])
            runs = [[seconds(c) for c in commands] for _ in range(options.runs)]
            least = [min(run[k] for run in runs) for k in range(len(commands))]
            line = f"{name} x {times}: {source.stat().st_size / 1e6:.2f} MB"
            for k, tools in enumerate(folders):
                growth = f", {least[k] / before[k] / 4:.2f} times that of its size" if k in before else ""
                beside = f", {least[k] / least[-1]:.1f} times {peer}" if peer else ""
                label = "; before:" if k else ":"
                line += f"{label} {boxes_of(folder / f'{k}.map', options.tools)} boxes, {least[k]:.3f} s{growth}{beside}"
                before[k] = least[k]
            print(line + (f" ({least[-1]:.3f} s)" if peer else ""), flush=True)


parser = argparse.ArgumentParser()
parser.add_argument("tools", type=pathlib.Path)
parser.add_argument("--only", default="")
parser.add_argument("--runs", type=int, default=3)
parser.add_argument("--before", type=pathlib.Path)
arguments = parser.parse_args()
for each in SOURCES:
    if arguments.only in each[0]:
        measure(*each, arguments)
