"""export_test.py BIN_DIR SOURCE_DIR: every drone file against a reader that shares no code with ours.

GDAL reads KML and GeoJSON, PROJ turns their degrees into metres, jsonschema judges the plan, a stand-in
for DJITelloPy takes what the Tello program sends, and the rules of the other formats are written here anew.
"""

import csv
import json
import math
import pathlib
import struct
import subprocess
import sys
import tempfile
import types

import numpy

bin_dir, source = (pathlib.Path(a) for a in sys.argv[1:3])
sys.path.insert(0, str(source / "tests/support"))
import schemas  # noqa: E402
data = source / "tests/golden/data"
scratch = tempfile.TemporaryDirectory()
folder = pathlib.Path(scratch.name)
LAT, LON = 37.792480, -122.397450  # of village.csv
VEHICLE = ("--vehicle", "box:0.1,0.1,0.06", "--margin", "0.3")
FORMATS = ("tello", "crazyflie", "qgc-plan", "wpl", "setpoints", "kml", "geojson", "gltf")


def run(*args, exits=0):
    done = subprocess.run([str(bin_dir / args[0]), *map(str, args[1:])], capture_output=True)
    assert done.returncode == exits, (args, done.returncode, done.stderr)
    return done.stdout


def agree(what, ours, theirs, most):
    """Says how far two tables of numbers are apart."""
    worst = numpy.abs(numpy.array(ours) - numpy.array(theirs)).max()
    print(f"{what}: {worst:.2g}")
    assert worst <= most, what


def make_maps():
    """The same city twice: north first with its origin, and east first."""
    run("skyway-import", data / "village.csv", "-q", "--bounds", "0,0,0,80,60,60", "-o", folder / "neu")
    rows = run("skyway-map", "to-csv", folder / "neu").decode().splitlines()
    boxes = [[r[1], r[0], r[2], r[4], r[3], r[5], ""] for r in csv.reader(rows[1:])]
    (folder / "enu.csv").write_text("\n".join([rows[0]] + [",".join(b) for b in boxes]) + "\n")
    run("skyway-import", folder / "enu.csv", "-q", "--bounds", "0,0,0,60,80,60", "-o", folder / "enu")


def make_flights():
    """One flight of 76 m, in both."""
    path = run("skyway-plan", folder / "neu", "--from", "5,30,5", "--to", "70,10,5", *VEHICLE)
    (folder / "path").write_bytes(path)
    flight = run("skyway-traj", folder / "neu", folder / "path", "--vmax", "4", "--amax", "4")
    (folder / "flight.neu").write_bytes(flight)
    record = json.loads(flight)
    for segment in record["segments"]:
        segment["x"], segment["y"] = segment["y"], segment["x"]
    record["frame"] = "enu"
    del record["map"]
    (folder / "flight.enu").write_text(json.dumps(record) + "\n")
    return record


def export(form, frame, *options):
    out = folder / f"{form}.{frame}"
    on_earth = form not in ("crazyflie", "gltf", "setpoints", "tello")
    extra = ("--origin", f"{LAT},{LON},0") if frame == "enu" and on_earth else ()
    run("skyway-export", folder / frame, folder / f"flight.{frame}", "--format", form, *extra, *options,
        "-o", out)
    return out


def position(record, t):
    """Of the trajectory, by Bernstein's formula."""
    for segment in record["segments"]:
        if t <= segment["duration"] or segment is record["segments"][-1]:
            u = min(t / segment["duration"], 1)
            return [sum(math.comb(7, i) * u**i * (1 - u)**(7 - i) * segment[a][i] for i in range(8))
                    for a in "xyz"]
        t -= segment["duration"]


def distance_to_flight(record, points):
    total = sum(s["duration"] for s in record["segments"])
    curve = numpy.array([position(record, k * total / 4000) for k in range(4001)])
    return max(numpy.linalg.norm(curve - numpy.array(p), axis=1).min() for p in points)


def check_crazyflie(record):
    """The columns as uav_trajectories takes them: one line of header, then duration and four times eight."""
    table = numpy.loadtxt(folder / "crazyflie.enu", delimiter=",", skiprows=1, usecols=range(33), ndmin=2)
    start, got, want = 0.0, [], []
    for row in table:
        for u in numpy.linspace(0, 1, 20):
            t = u * row[0]
            got.append([sum(row[1 + 8 * a + k] * t**k for k in range(8)) for a in range(3)])
            want.append(position(record, start + t))
        start += row[0]
    agree("Crazyflie polynomials against the trajectory, m", got, want, 1e-9)
    assert math.isclose(start, sum(s["duration"] for s in record["segments"]), rel_tol=1e-12)


def check_setpoints(record):
    for axes in ("enu", "ned"):
        out = export("setpoints", "enu", "--axes", axes, "--rate", "20")
        rows = list(csv.reader(out.open()))
        got = [[float(v) for v in row[1:4]] for row in rows[1:]]
        want = [position(record, float(row[0])) for row in rows[1:]]
        if axes == "ned":
            want = [[p[1], p[0], -p[2]] for p in want]
        agree(f"setpoints in {axes} against the trajectory, m", got, want, 1e-9)
        p = numpy.array([[float(v) for v in row] for row in rows[1:-1]])
        h = p[1, 0] - p[0, 0]
        assert numpy.allclose((p[2:, 1:4] - p[:-2, 1:4]) / (2 * h), p[1:-1, 4:7], atol=2e-2), "velocity"
        assert numpy.allclose((p[2:, 4:7] - p[:-2, 4:7]) / (2 * h), p[1:-1, 7:10], atol=1e-1), "acceleration"


def to_metres(points):
    """Longitude and latitude to east and north of the origin, by PROJ."""
    from osgeo import osr
    earth = osr.SpatialReference()
    earth.SetFromUserInput("+proj=longlat +datum=WGS84 +no_defs")
    local = osr.SpatialReference()
    local.SetFromUserInput(f"+proj=tmerc +lat_0={LAT} +lon_0={LON} +k=1 +x_0=0 +y_0=0 +datum=WGS84 +units=m")
    earth.SetAxisMappingStrategy(osr.OAMS_TRADITIONAL_GIS_ORDER)
    turn = osr.CoordinateTransformation(earth, local)
    return [[*turn.TransformPoint(lon, lat)[:2], height] for lon, lat, height in points]


def read_gltf(path):
    raw = path.read_bytes()
    magic, version, length, json_length = struct.unpack_from("<4sIII", raw)
    assert (magic, version, length) == (b"glTF", 2, len(raw))
    gltf = json.loads(raw[20:20 + json_length])
    accessor = gltf["accessors"][gltf["meshes"][0]["primitives"][0]["attributes"]["POSITION"]]
    assert gltf["meshes"][0]["primitives"][0]["mode"] == 3, "a line strip"
    points = numpy.frombuffer(raw, "<f4", 3 * accessor["count"], 28 + json_length).reshape(-1, 3)
    assert numpy.array_equal(points.min(0), numpy.array(accessor["min"], "f4"))
    assert numpy.array_equal(points.max(0), numpy.array(accessor["max"], "f4"))
    x, y, z = (points.astype(float) + gltf["nodes"][0]["translation"]).T
    return numpy.array([x, -z, y]).T


def check_lines(record):
    from osgeo import ogr
    ogr.UseExceptions()
    lines = {"gltf": read_gltf(folder / "gltf.enu")}
    for form, driver in (("kml", "KML"), ("geojson", "GeoJSON")):
        opened = ogr.GetDriverByName(driver).Open(str(folder / f"{form}.enu"))
        feature = opened.GetLayer(0).GetNextFeature()
        lines[form] = numpy.array(to_metres(feature.GetGeometryRef().GetPoints()))
    assert lines["kml"].shape == lines["geojson"].shape == lines["gltf"].shape
    agree("KML against GeoJSON, by GDAL, m", lines["kml"], lines["geojson"], 1e-6)
    agree("KML by GDAL and PROJ against glTF, m", lines["kml"], lines["gltf"], 3e-4)
    ends = [record["segments"][0], record["segments"][-1]]
    assert numpy.allclose(lines["gltf"][0], [ends[0][a][0] for a in "xyz"], atol=1e-6)
    assert numpy.allclose(lines["gltf"][-1], [ends[1][a][7] for a in "xyz"], atol=1e-5)
    assert distance_to_flight(record, lines["gltf"]) < 0.25
    return lines["gltf"]


def check_missions(record):
    """WPL 110: the first line, then 12 fields between tabs; the plan must say the same."""
    text = (folder / "wpl.enu").read_bytes()
    assert b"\r" not in text and b"," not in text and text.endswith(b"\n")
    lines = text.decode().splitlines()
    assert lines[0] == "QGC WPL 110"
    items = []
    for index, line in enumerate(lines[1:]):
        fields = line.split("\t")
        assert len(fields) == 12 and fields[0] == str(index) and fields[11] == "1"
        assert fields[1] == ("1" if index == 0 else "0")
        items.append([int(fields[2]), int(fields[3]), *map(float, fields[4:11])])
    assert items[0][:2] == [0, 16] and items[1][:2] == [3, 22] and items[-1][:2] == [3, 21]

    validator = schemas.validators(source)["plan"]
    plan = json.loads((folder / "qgc-plan.enu").read_text())
    validator.validate(plan)
    for key, wrong in (("version", 2), ("fileType", "plan")):
        assert not validator.is_valid({**plan, key: wrong}), "a schema that takes anything"
    assert len(plan["mission"]["items"]) == len(items) - 1
    for simple, item in zip(plan["mission"]["items"], items[1:]):
        params = [0 if p is None else p for p in simple["params"]]
        assert [simple["frame"], simple["command"], *params] == item
    assert plan["mission"]["plannedHomePosition"] == items[0][6:9]

    flown = [i for i in items[1:] if i[1] in (16, 22)]
    points = to_metres([(i[7], i[6], i[8] + items[0][8]) for i in flown])
    assert distance_to_flight(record, points) < 0.5
    ours = json.loads(run("skyway-import-trajectory", folder / "wpl.enu", "--origin", f"{LAT},{LON},0"))
    agree("WPL by PROJ against skyway-import-trajectory, m", points, ours["points"], 1e-6)
    assert ours["hold"] == [i[2] for i in flown]


class FakeTello:
    """What DJITelloPy would have sent."""
    sent = []

    def __init__(self, retry_count=3):
        assert retry_count == 1, "a leg that is sent twice is flown twice"

    def connect(self):
        self.sent.append("command")

    def get_battery(self):
        return 87

    def takeoff(self):
        self.sent.append("takeoff")

    def land(self):
        self.sent.append("land")

    def send_control_command(self, command, timeout=7):
        assert isinstance(timeout, int)
        length = math.hypot(*map(int, command.split()[1:4]))
        assert timeout > 2 * length / int(command.split()[4]), "it must not give up in flight"
        self.sent.append(command)


def check_tello(record, heading):
    out = folder / "tello.txt"
    run("skyway-export", folder / "enu", folder / "flight.enu", "--format", "tello", "--heading", heading,
        "--speed", "0.8", "-o", out, "--python", folder / "tello.py", "--table", folder / "tello.csv")
    script = out.read_text().splitlines()
    assert script[:2] == ["command", "takeoff"] and script[-1] == "land"
    at = numpy.array([position(record, 0)[0], position(record, 0)[1], 1.0])
    forward = numpy.array([math.sin(math.radians(heading)), math.cos(math.radians(heading)), 0])
    left = numpy.array([-forward[1], forward[0], 0])
    points = [at]
    for line in script[2:-1]:
        word, *numbers = line.split(" ")
        x, y, z, speed = map(int, numbers)
        assert word == "go" and speed == 80
        assert max(map(abs, (x, y, z))) <= 500 and max(map(abs, (x, y, z))) > 20
        points.append(points[-1] + (x * forward + y * left + [0, 0, z]) / 100)
    table = list(csv.DictReader((folder / "tello.csv").open()))
    got = numpy.array([[float(r[k]) for k in ("east_m", "north_m", "up_m")] for r in table])
    agree("Tello script against its table, m", points, got, 1e-4)
    assert numpy.linalg.norm(points[-1] - position(record, 1e9)) < 0.02
    assert distance_to_flight(record, [p for p in points if p[2] > 4.9]) < 0.5

    fake = types.ModuleType("djitellopy")
    fake.Tello = FakeTello
    sys.modules["djitellopy"] = fake
    FakeTello.sent = []
    exec(compile((folder / "tello.py").read_text(), "tello.py", "exec"), {})
    assert FakeTello.sent == script

    start = ",".join(str(v) for v in (*position(record, 0)[:2], 0))
    report = json.loads(run("skyway-check", folder / "enu", out, "--file-format", "tello", "--takeoff-place", start,
                            "--heading", heading, *VEHICLE))
    assert report["ok"] and report["clearance"] > 0.3


def check_round_trips():
    """What was exported is imported and checked again."""
    for form in ("crazyflie", "wpl", "qgc-plan", "gltf"):
        ground = ("--ground", "0") if form in ("wpl", "qgc-plan") else ()
        record = run("skyway-import-trajectory", "-q", folder / f"{form}.neu", "--map", folder / "neu", *ground)
        (folder / "again").write_bytes(record)
        run("skyway-check", folder / "neu", folder / "again", *VEHICLE)


make_maps()
flight = make_flights()
for name in FORMATS:
    assert export(name, "enu").read_bytes() == export(name, "neu").read_bytes(), name
check_crazyflie(flight)
check_setpoints(flight)
check_lines(flight)
check_missions(flight)
for degrees in (0, 90, -137.5):
    check_tello(flight, degrees)
check_round_trips()
print("independent readers agree")
