"""edge_inputs_test.py BIN_DIR: importers and planners on inputs that say less, or other, than they seem.

A hundred processes of each kind: files in some unit, obstacles that cannot be built, degrees for metres. Each
answer must be right or a refusal (exit 2 or 3); a map that says nothing of what was left out is a failure.
"""

import json
import os
import pathlib
import random
import struct
import subprocess
import sys
import tempfile

BIN = pathlib.Path(sys.argv[1]).resolve()
CASES = int(sys.argv[2]) if len(sys.argv) > 2 else 100
FEET, SURVEY = 0.3048, 1200 / 3937
random.seed(15)
failures = []


def run(tool, *options, stdin=""):
    return subprocess.run([BIN / tool, *map(str, options)], input=stdin, capture_output=True, text=True, timeout=60)


def expect(kind, case, holds, done):
    if not holds:
        failures.append(f"{kind} {case}: exit {done.returncode}: {done.stderr.strip()[:200]}")


def info(path):
    return dict(line.split(": ", 1) for line in run("skyway-map", "info", path).stdout.splitlines())


def las(points, records):
    body = b"".join(struct.pack("<H16sHH32s", 0, user, number, len(data), b"") + data for user, number, data in records)
    head = bytearray(227)
    head[:4], head[24], head[25] = b"LASF", 1, 2
    struct.pack_into("<HII", head, 94, 227, 227 + len(body), len(records))
    struct.pack_into("<HI", head, 105, 20, len(points))
    struct.pack_into("<3d", head, 131, 0.01, 0.01, 0.01)
    return bytes(head) + body + b"".join(struct.pack("<3i8x", *(round(v * 100) for v in p)) for p in points)


def wkt(unit):
    length = {"m": 1, "ft": FEET, "us-ft": SURVEY}[unit]
    return f'PROJCS["p",GEOGCS["g",UNIT["degree",0.0174532925199433]],PROJECTION["Transverse_Mercator"],UNIT["{unit}",{length!r}]]'


def clouds():
    codes = {"m": 9001, "ft": 9002, "us-ft": 9003}
    systems = {"m": 26910, "ft": 2992, "us-ft": 2263}  # of that unit, which PROJ knows
    for case in range(CASES):
        unit = random.choice(list(codes))
        other = random.choice([u for u in codes if u != unit])
        how = random.choice(["text", "keys", "named", "no unit", "degrees", "contradiction", "contradicting keys"])
        keys = {"keys": [1024, 0, 1, 1, 3072, 0, 1, systems[unit], 3076, 0, 1, codes[unit]],
                "contradicting keys": [1024, 0, 1, 1, 3072, 0, 1, systems[unit], 3076, 0, 1, codes[other]],
                "named": [1024, 0, 1, 1, 3072, 0, 1, systems[unit]], "no unit": [1024, 0, 1, 1, 3072, 0, 1, 32767],
                "degrees": [1024, 0, 1, 2, 2048, 0, 1, 4326]}.get(how)
        if keys:
            record = (b"LASF_Projection", 34735, struct.pack(f"<{4 + len(keys)}H", 1, 1, 0, len(keys) // 4, *keys))
        else:
            record = (b"LASF_Projection", 2112, wkt(unit).encode() + b"\0")
        pathlib.Path("c.las").write_bytes(las([(1000, 2000, 300), (1300, 2100, 330)], [record]))
        options = ["--units", other] if how == "contradiction" else []
        done = run("skyway-cloud", "c.las", "-o", "c.boxmap", *options)
        if how in ("no unit", "degrees", "contradiction", "contradicting keys"):
            expect("cloud", (case, how), done.returncode == 3, done)
            continue
        length = {"m": 1, "ft": FEET, "us-ft": SURVEY}[unit]
        top = json.loads(info("c.boxmap").get("bounds_max_m", "[0,0,0]"))
        right = all(v - 1e-6 <= found <= v + 1.1 for v, found in zip((1300 * length, 2100 * length, 330 * length), top))
        expect("cloud", (case, how, unit), done.returncode == 0 and right and "crs" in info("c.boxmap"), done)


def skipped(kind, case, tool, file, *options):
    done = run(tool, file, "-o", "s.boxmap", *options)
    expect(kind, (case, file), done.returncode == 3 and "--allow-skipped" in done.stderr, done)
    done = run(tool, file, "-o", "s.boxmap", "--allow-skipped", *options)
    expect(kind, (case, file, "allowed"), done.returncode == 0 and int(info("s.boxmap").get("skipped_obstacles", 0)) > 0, done)


def osm(nodes, ways, relations=""):
    text = "".join(f'<node id="{i}" lat="{60.17 + y / 111000}" lon="{24.94 + x / 55000}">{tags}</node>' for i, x, y, tags in nodes)
    text += "".join(f'<way id="{i}">' + "".join(f'<nd ref="{r}"/>' for r in refs) + f"{tags}</way>" for i, refs, tags in ways)
    pathlib.Path("o.osm").write_text(f'<osm version="0.6">{text}{relations}</osm>')


BUILDING = '<tag k="building" v="yes"/><tag k="height" v="30"/>'


def obstacles():
    for case in range(CASES):
        word = random.choice(["blok", "Block", "blocks", "block:", "bolck", "wall"])
        pathlib.Path("b.txt").write_text(f"boundary 0 0 0 9 9 9\nblock 1 1 0 2 2 3\n{word} 4 4 0 5 5 9\n")
        skipped("block text", case, "skyway-import", "b.txt", "--format", "block-text")
        corners = [(1, 0, 0, ""), (2, 30, 0, ""), (3, 30, 30, ""), (4, 0, 30, "")]
        lost = random.randrange(4)
        refs = [1, 2, 3, 4, 1]
        osm([n for i, n in enumerate(corners) if i != lost], [(9, refs, BUILDING)])
        skipped("OSM corner", case, "skyway-footprints", "o.osm")
        tag = random.choice(['k="building" v="hut"', 'k="man_made" v="mast"', 'k="power" v="tower"'])
        osm(corners + [(7, 60, 60, f"<tag {tag}/>")], [(9, refs, BUILDING)])
        skipped("OSM point", case, "skyway-footprints", "o.osm")
        # What stands there and nothing measures: as a point, a line, an area.
        tag = random.choice(['k="natural" v="tree"', 'k="highway" v="street_lamp"', 'k="barrier" v="wall"',
                             'k="bridge" v="yes"', 'k="landuse" v="forest"', 'k="man_made" v="bridge"'])
        more = {"node": ([(7, 60, 60, f"<tag {tag}/>")], [], ""),
                "way": ([(7, 60, 60, ""), (8, 90, 60, "")], [(10, [7, 8], f"<tag {tag}/>")], ""),
                "relation": ([], [], f'<relation id="1"><member type="way" ref="9" role="outer"/>'
                                     f'<tag k="type" v="multipolygon"/><tag {tag}/></relation>')}
        nodes, ways, relations = more[random.choice(list(more))]
        osm(corners + nodes, [(9, refs, BUILDING)] + ways, relations)
        skipped("OSM other", case, "skyway-footprints", "o.osm")
        # New corners of an editor have negative numbers: they are read like all others.
        new = [(-i if random.random() < 0.5 else i, x, y, t) for i, x, y, t in corners]
        osm(sorted(new), [(-9, [n[0] for n in new] + [new[0][0]], BUILDING)])
        done = run("skyway-footprints", "o.osm", "--pad", "0", "-o", "o.boxmap")
        found = info("o.boxmap")
        reach = [b - a for a, b in zip(json.loads(found["bounds_min_m"]), json.loads(found["bounds_max_m"]))]
        expect("OSM new nodes", case, done.returncode == 0 and min(reach[:2]) > 29 and reach[2] == 30, done)
        odd = random.choice([{"type": "Point", "coordinates": [24.94, 60.17]}, None,
                             {"type": "LineString", "coordinates": [[24.94, 60.17], [24.941, 60.17]]},
                             {"type": "GeometryCollection", "geometries": [{"type": "Point", "coordinates": [24.94, 60.17]}]}])
        square = [[24.94, 60.17], [24.941, 60.17], [24.941, 60.171], [24.94, 60.17]]
        features = [{"type": "Feature", "properties": {"height": 9}, "geometry": g}
                    for g in ({"type": "Polygon", "coordinates": [square]}, odd)]
        random.shuffle(features)
        pathlib.Path("g.geojson").write_text(json.dumps({"type": "FeatureCollection", "features": features}))
        skipped("GeoJSON", case, "skyway-footprints", "g.geojson")


def degrees():
    pathlib.Path("f.csv").write_text("lat0 60.17, lon0 24.94\nposX,posY,posZ,halfSizeX,halfSizeY,halfSizeZ\n0,0,5,200,200,5\n")
    run("skyway-import", "f.csv", "--ceiling", 100, "-o", "f.boxmap")
    for case in range(CASES):
        a = [60.17 + random.uniform(-0.01, 0.01), 24.94 + random.uniform(-0.01, 0.01)]
        b = [60.17 + random.uniform(-0.01, 0.01), 24.94 + random.uniform(-0.01, 0.01)]
        if random.random() < 0.5:
            a, b = a[::-1], b[::-1]
        ends = ["--from", f"{a[0]},{a[1]},60", "--to", f"{b[0]},{b[1]},60", "--vehicle", "box:1,1,1"]
        done = run("skyway-plan", "f.boxmap", *ends)
        expect("degrees", case, done.returncode == 2 and "--metres" in done.stderr, done)
        done = run("skyway-plan", "f.boxmap", *ends, "--metres")
        expect("degrees insisted", case, done.returncode == 0, done)
        record = json.dumps({"segment": [a + [60], b + [60]]})
        done = run("skyway-query", "f.boxmap", "--vehicle", "box:1,1,1", stdin=record)
        expect("degrees asked", case, done.returncode == 3 and not done.stdout, done)
        far = [f"{random.uniform(-190, 190):.3f},{random.uniform(-190, 190):.3f},60" for _ in range(2)]
        done = run("skyway-plan", "f.boxmap", "--from=" + far[0], "--to=" + far[1], "--vehicle", "box:1,1,1")
        expect("metres", case, done.returncode == 0, done)


with tempfile.TemporaryDirectory() as folder:
    os.chdir(folder)
    clouds()
    obstacles()
    degrees()
for failure in failures[:20]:
    print(failure)
print(f"{CASES} of each kind, {len(failures)} failures")
sys.exit(bool(failures))
