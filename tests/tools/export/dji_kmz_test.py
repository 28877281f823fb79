"""dji_kmz_test.py BIN_DIR [COUNT [SEED]]: DJI's missions, by a reader that shares no code with ours.

What skyway-export writes is read by Python's zipfile and ElementTree, and what they write by ours: the same
points to 1e-7 degrees. COUNT (60) random missions, of which one part (the rise, the way to the first
waypoint, a leg, a turn, the way to the next wayline, the return) goes through a tower by construction, are
never accepted; the same missions beside the tower are. Archives that are damaged or made to deceive are refused.
"""

import io
import json
import random
import re
import sys
import xml.etree.ElementTree as ElementTree
import zipfile

from one_tower import OneTower

count = int(sys.argv[2]) if len(sys.argv) > 2 else 60
rng = random.Random(int(sys.argv[3]) if len(sys.argv) > 3 else 20)
LAT, LON = 47.0, 8.0
PLACE = ("--origin", f"{LAT},{LON},400")
VEHICLE = ("--vehicle", "box:0.45,0.45,0.35")  # that holds a Mavic 3
NORTH = 1 / 111174.0  # degrees a metre
EAST = 1 / 76057.0
TOWER = (100, -50, 0, 120, 50, 80)
site = OneTower(sys.argv[1], TOWER, "-300,-300,0,500,300,300")
run, folder = site.run, site.folder
SPACES = {"kml": "http://www.opengis.net/kml/2.2"}
failures = []


def require(holds, what, *shown):
    if not holds:
        failures.append(what)
        print(what, *shown)


def element(name, inside=""):
    return f"<wpml:{name}>{inside}</wpml:{name}>"


def kml(inside, version="1.0.6"):
    return ('<?xml version="1.0" encoding="UTF-8"?>\n<kml xmlns="http://www.opengis.net/kml/2.2" '
            f'xmlns:wpml="http://www.dji.com/wpmz/{version}"><Document>{inside}</Document></kml>\n')


def config(takeoff, finish="noAction", approach="safely", security=20, rth=None):
    lat, lon = LAT + takeoff[1] * NORTH, LON + takeoff[0] * EAST
    inside = (element("flyToWaylineMode", approach) + element("finishAction", finish) +
              element("exitOnRCLost", "goContinue") + element("takeOffSecurityHeight", security) +
              element("takeOffRefPoint", f"{lat:.9f},{lon:.9f},400") + element("globalTransitionalSpeed", 9) +
              element("droneInfo", element("droneEnumValue", 77)))
    return element("missionConfig", inside + (element("globalRTHHeight", rth) if rth else ""))


def turn_element(mode="toPointAndStopWithDiscontinuityCurvature", damping=0):
    return element("waypointTurnParam", element("waypointTurnMode", mode) + element("waypointTurnDampingDist", damping))


def placemark(index, point, more="", turn=turn_element()):
    return (f"<Placemark><Point><coordinates>{LON + point[0] * EAST:.9f},{LAT + point[1] * NORTH:.9f}</coordinates>"
            f"</Point>{element('index', index)}{element('executeHeight', point[2])}{turn}{more}</Placemark>")


def corner(damping, mode="coordinateTurn"):
    """Around an edge of the tower, 5 m from it; the legs are free."""
    z = rng.uniform(25, 79)
    turn = turn_element(mode, f"{damping:.3f}") + element("useStraightLine", 1)
    points = [(95, 10, z), (95, 55, z), (150, 55, z)]
    if rng.random() < 0.5:
        points.reverse()
    return config(points[0]) + ("<Folder>" + element("templateId", 0) +
                                element("executeHeightMode", "relativeToStartPoint") + element("waylineId", 0) +
                                element("autoFlightSpeed", 5) + placemark(0, points[0]) +
                                placemark(1, points[1], turn=turn) + placemark(2, points[2]) + "</Folder>")


def wayline(points, number=0, more=""):
    return ("<Folder>" + element("templateId", number) + element("executeHeightMode", "relativeToStartPoint") +
            element("waylineId", number) + element("autoFlightSpeed", 5) + more +
            "".join(placemark(i, p) for i, p in enumerate(points)) + "</Folder>")


def kmz(waylines, template=None, method=zipfile.ZIP_DEFLATED, names=("wpmz/template.kml", "wpmz/waylines.wpml")):
    out = io.BytesIO()
    with zipfile.ZipFile(out, "w", method) as archive:
        if template:
            archive.writestr(names[0], template)
        archive.writestr(names[1], waylines)
    return out.getvalue()


def check(data, *options):
    path = folder / "mission.kmz"
    path.write_bytes(data)
    done = run("skyway-check", folder / "map", path, "--file-format", "dji-wpml", *VEHICLE, *PLACE, *options)
    return done.returncode, done.stdout.decode(), done.stderr.decode(errors="replace")


def read_apart(data):
    """Points (latitude, longitude, height) of waylines.wpml, by code that is not ours."""
    with zipfile.ZipFile(io.BytesIO(data)) as archive:
        assert archive.testzip() is None
        root = ElementTree.fromstring(archive.read("wpmz/waylines.wpml"))
        ElementTree.fromstring(archive.read("wpmz/template.kml"))
    wpml = re.search(r"http://www.dji.com/wpmz/[0-9.]+", ElementTree.tostring(root).decode()).group()
    points = []
    for place in root.iter("{http://www.opengis.net/kml/2.2}Placemark"):
        lon, lat = place.find("kml:Point/kml:coordinates", SPACES).text.strip().split(",")
        points.append((float(lat), float(lon), float(place.find(f"{{{wpml}}}executeHeight").text)))
    return points


def geographic(points):
    """What skyway-export's GeoJSON says of a path: the projection is ours, the two writers are not one."""
    record = json.dumps({"type": "path", "id": "p", "status": "found", "frame": "enu", "points": points})
    done = run("skyway-export", "--unchecked", "--format", "geojson", *PLACE, input=record.encode())
    return [(c[1], c[0], c[2] - 400) for c in
            json.loads(done.stdout)["features"][0]["geometry"]["coordinates"]]


def export_agrees():
    for version in ("1.0.2", "1.0.6"):
        points = [[0, 0, 30]] + [[rng.uniform(-200, 80), rng.uniform(-200, 200), rng.uniform(10, 90)]
                                 for _ in range(rng.randint(1, 30))]
        record = json.dumps({"type": "path", "id": "p", "status": "found", "frame": "enu", "points": points})
        done = run("skyway-export", folder / "map", "-", "--format", "dji-wpml", "--wpml-version", version, *VEHICLE,
                   *PLACE, "-q", input=record.encode())
        require(done.returncode == 0, "export", done.stderr)
        if done.returncode:
            continue
        apart = read_apart(done.stdout)
        same = len(apart) == len(points) and all(
            abs(a[0] - b[0]) <= 1e-7 and abs(a[1] - b[1]) <= 1e-7 and abs(a[2] - b[2]) <= 1e-3
            for a, b in zip(apart, geographic(points)))
        require(same, "export: another reader finds other points", apart, points)
        code, report, said = check(done.stdout)
        require(code == 0 and '"ok":true' in report, "export: what was written is not accepted", said, report)


def turns_agree():
    points = [[50, 0, 30], [95, 10, 30], [95, 55, 30], [150, 55, 30], [150, 55.3, 30]]
    record = json.dumps({"type": "path", "id": "p", "status": "found", "frame": "enu", "points": points})
    done = run("skyway-export", folder / "map", "-", "--format", "dji-wpml", "--turns", 20, *VEHICLE, *PLACE,
               input=record.encode())
    require(done.returncode == 0, "export with turns", done.stderr)
    with zipfile.ZipFile(io.BytesIO(done.stdout)) as archive:
        texts = [archive.read(name).decode() for name in ("wpmz/waylines.wpml", "wpmz/template.kml")]
    for text in texts:
        found = re.findall(r"<wpml:waypointTurnDampingDist>([0-9.]+)", text)
        require([d for d in found if d != "0"] == ["20", "5"], "export with turns: other turns", found)
    require(b"no room to turn at 1 of 5 waypoints (counted from 0: 3): it stops there" in done.stderr,
            "export with turns: what it says", done.stderr)
    code, report, said = check(done.stdout)
    require(code == 0, "export with turns: what was written is not accepted", said, report)


def import_agrees():
    points = [(rng.uniform(-200, 80), rng.uniform(-200, 200), rng.uniform(30, 90)) for _ in range(50)]
    data = kmz(kml(config(points[0]) + wayline(points)), template=kml(""))
    (folder / "mission.kmz").write_bytes(data)
    done = run("skyway-import-trajectory", folder / "mission.kmz", *PLACE, "-q")
    require(done.returncode == 0, "import", done.stderr)
    read = json.loads(done.stdout)["points"]
    apart = read_apart(data)
    back = geographic(read)
    require(len(back) == len(apart) and all(abs(a[0] - b[0]) <= 1e-7 and abs(a[1] - b[1]) <= 1e-7 and
                                            abs(a[2] - b[2]) <= 2e-4 for a, b in zip(apart, back)),
            "import: another reader finds other points", apart, back)


def beside():
    return (rng.uniform(-200, 80), rng.uniform(-200, 200), rng.uniform(25, 90))


def across():
    """Two points between which the tower stands, by up to a metre or far."""
    y = rng.choice([rng.uniform(-49, 49), rng.choice([-1, 1]) * (50.45 - rng.uniform(0.02, 1))])
    z = rng.choice([rng.uniform(25, 79), 80.35 - rng.uniform(0.02, 1)])
    pair = [(rng.uniform(0, 90), y, z), (rng.uniform(130, 200), y, z)]
    rng.shuffle(pair)
    return pair


def blocked(part):
    """A mission of which that part alone goes through the tower."""
    a, b = across()
    way = [beside() for _ in range(rng.randint(1, 3))]
    if part == "leg":
        points = [*way, a, b]
        if a[0] > 120:  # the way to a would go through the tower too: that is blocked as well
            points = [a, b, *way]
        return config((points[0][0], points[0][1])) + wayline(points)
    if part == "approach":
        return config((a[0], a[1]), security=2) + wayline([b])
    if part == "coordinated turn":
        return corner(rng.uniform(10, 40))  # its chord goes through the edge from 9.4 m on
    if part == "turn through the waypoint":
        return corner(rng.uniform(5, 40), "toPointAndPassWithContinuityCurvature")
    if part == "return without a rise":  # from 22 to 49 m, below the tower's top and above it
        low, high = rng.uniform(30, 70), rng.uniform(90, 120)
        y = rng.uniform(-40, 40)
        return (config((125, y), finish="goHome", security=100, rth=high) +
                wayline([(rng.uniform(80, 98), y, 100), (rng.uniform(80, 98), y, low)]))
    if part == "rise":
        return config((110, rng.uniform(-50, 50)), security=2) + wayline([beside()])
    if part == "from point to point":
        return config((a[0], a[1]), approach="pointToPoint", security=a[2]) + wayline([b])
    if part == "security height":
        return config((a[0], a[1]), security=79) + wayline([(b[0], b[1], rng.uniform(2, 70))])
    if part == "next wayline":
        return config((a[0], a[1])) + wayline([a]) + wayline([b], 1)
    home = (a[0], a[1])
    return config(home, finish="goHome", security=100, rth=rng.uniform(2, a[2])) + wayline([(b[0], b[1], 100), b])


def soundness():
    parts = ("leg", "approach", "rise", "from point to point", "security height", "next wayline", "return",
             "coordinated turn", "turn through the waypoint", "return without a rise")
    for i in range(count):
        part = parts[i % len(parts)]
        mission = kml(blocked(part))
        code, report, said = check(kmz(mission), "-q")
        require(code in (1, 3) and '"ok":true' not in report, f"{part}: accepted through the tower", mission, report)
        require(code == 1, f"{part}: refused as a file", said, mission)
        points = [beside() for _ in range(4)]
        if i % 4 == 1:
            free = rng.choice([corner(rng.uniform(1, 9)), corner(rng.uniform(1, 4.6), "toPointAndPassWithContinuityCurvature")])
        elif i % 3 == 0 and (points[0][0] - points[-1][0]) ** 2 + (points[0][1] - points[-1][1]) ** 2 > 51 ** 2:
            free = config(points[0], finish="goHome", rth=60) + wayline(points[:2]) + wayline(points[2:], 1)
        else:
            free = config(points[0], finish="autoLand") + wayline(points)
        code, report, said = check(kmz(kml(free)), "-q")
        require(code == 0, "beside the tower: refused", said, report)


def refused(name, data, words):
    code, report, said = check(data)
    require(code == 3 and words in said and len(said) < 1000, f"{name}: expected a refusal with \"{words}\"", code, said)


def hostile():
    good = kml(config((0, 0)) + wayline([(0, 0, 30), (50, 0, 30)]))
    data = kmz(good, template=kml(""))
    require(check(kmz(good))[0] == 0, "the mission that others are made of")
    refused("a KML", good.encode(), "put it into a ZIP archive (.kmz)")
    refused("nothing", b"", "an empty file")
    for size in range(1, len(data), max(1, len(data) // 40)):
        code, _, said = check(data[:size])
        require(code == 3 and said.count("\n") <= 2, f"cut at {size}", code, said)
    refused("a KMZ of Google Earth", kmz(good, names=("x", "doc.kml")), "this is a KMZ file")
    refused("a KMZ without waylines", kmz(good, names=("", "wpmz/other")), "expected wpmz/waylines.wpml")
    refused("a bomb", kmz(" " * (65 << 20)), "expected at most 67108864 bytes")
    refused("a smaller bomb", kmz("<kml>" + "<a/>" * (2 << 20)), "packed at most 100 to 1")
    refused("two missions", kmz(good, good, names=("wpmz/other.wpml", "wpmz/waylines.wpml")), "expected no other file")
    refused("an entry twice", zipped_twice(good), "found it twice")
    refused("a name that leads out", kmz(good, good, names=("wpmz/../../x", "wpmz/waylines.wpml")), "inside the archive")
    refused("another compression", kmz(good, method=zipfile.ZIP_BZIP2), "found method 12")
    refused("something before it", b"#!/bin/sh\n" + data, "expected")
    refused("a hidden mission before it", kmz(good) + kmz(good), "")
    refused("an unknown version", kmz(good.replace("1.0.6", "1.7.3")), "found 1.7.3")
    refused("no XML", kmz("waypoints"), "expected well-formed XML, found \"waypoints\"")
    refused("another template", kmz(good, template_of([(0, 0, 30), (60, 0, 30)])), "save it in that app again")
    require(check(kmz(good, template_of([(0, 0, 30), (50, 0, 30)])))[0] == 0, "its own template")
    damaged = bytearray(data)
    damaged[damaged.rfind(b"wpmz/waylines.wpml", 0, damaged.rfind(b"PK\1\2") - 200) + 60] ^= 0x10
    require(check(bytes(damaged))[0] == 3, "a damaged entry")


def template_of(points):
    folder_text = ("<Folder>" + element("templateType", "waypoint") + element("templateId", 0) +
                   element("waylineCoordinateSysParam", element("heightMode", "relativeToStartPoint")))
    for i, p in enumerate(points):
        folder_text += (f"<Placemark><Point><coordinates>{LON + p[0] * EAST:.9f},{LAT + p[1] * NORTH:.9f}</coordinates>"
                        f"</Point>{element('index', i)}{element('height', p[2])}</Placemark>")
    return kml(folder_text + "</Folder>")


def zipped_twice(text):
    out = io.BytesIO()
    with zipfile.ZipFile(out, "w", zipfile.ZIP_DEFLATED) as archive:
        archive.writestr("wpmz/waylines.wpml", text)
        archive.writestr("wpmz/waylinez.wpml", text)
    return out.getvalue().replace(b"waylinez", b"waylines")


export_agrees()
turns_agree()
import_agrees()
soundness()
hostile()
sys.exit(bool(failures))
