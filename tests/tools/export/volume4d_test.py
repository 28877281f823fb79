"""volume4d_test.py BIN_DIR VILLAGE_CSV: volumes of airspace hold a flight, by latitudes and longitudes worked out here."""

import datetime
import json
import math
import pathlib
import subprocess
import sys
import tempfile

bin_dir, village = (pathlib.Path(a).resolve() for a in sys.argv[1:3])
LATITUDE, LONGITUDE, HEIGHT = 37.79248, -122.39745, -12.5
EPOCH = datetime.datetime(2026, 5, 4, 6, 30, tzinfo=datetime.timezone.utc)
BUFFER = 0.75


def run(*words, stdin="", exit_code=0):
    done = subprocess.run([bin_dir / words[0], *words[1:]], input=stdin, text=True, capture_output=True)
    assert done.returncode == exit_code, (words, done.returncode, done.stderr)
    return done.stdout


def radii():
    """Of the ellipsoid's curvature along the meridian and across it, metres."""
    a, f = 6378137, 1 / 298.257223563
    e2 = f * (2 - f)
    w = math.sqrt(1 - e2 * math.sin(math.radians(LATITUDE)) ** 2)
    return a * (1 - e2) / w**3, a / w


MERIDIAN, ACROSS = radii()


def metres(vertex):
    """East and north of the origin; within a tenth of a millimetre of the truth on 100 m."""
    north = math.radians(vertex["lat"] - LATITUDE) * MERIDIAN
    east = math.radians(vertex["lng"] - LONGITUDE) * ACROSS * math.cos(math.radians(LATITUDE) + north / MERIDIAN / 2)
    return east, north


def within(ring, x, y):
    inside = False
    for (ax, ay), (bx, by) in zip(ring, ring[1:] + ring[:1]):
        if (ay > y) != (by > y) and x < ax + (y - ay) / (by - ay) * (bx - ax):
            inside = not inside
    return inside


def position(segments, t):
    for s in segments:
        if t <= s["duration"] or s is segments[-1]:
            u = min(t / s["duration"], 1)
            points = list(zip(s["x"], s["y"], s["z"]))
            while len(points) > 1:
                points = [[(1 - u) * p + u * q for p, q in zip(a, b)] for a, b in zip(points, points[1:])]
            return points[0]
        t -= s["duration"]


def seconds(time):
    assert time["format"] == "RFC3339" and time["value"].endswith("Z")
    instant = datetime.datetime.fromisoformat(time["value"].replace("Z", "+00:00"))
    return (instant - EPOCH) / datetime.timedelta(seconds=1)


def padded(text):
    """As old Pythons read fractions: three digits."""
    for volume in text["volumes"]:
        for key in ("time_start", "time_end"):
            whole, _, fraction = volume[key]["value"][:-1].partition(".")
            volume[key]["value"] = f"{whole}.{fraction:0<3}Z"
    return text


def check(record, intent, axes):
    volumes = padded(intent)["volumes"]
    start = record["start"]
    half = [h + record["margin"] + BUFFER for h in record["vehicle"]["half"]]
    flown = sum(s["duration"] for s in record["segments"])
    assert seconds(volumes[0]["time_start"]) <= start and seconds(volumes[-1]["time_end"]) >= start + flown
    looked = 0
    for before, after in zip(volumes, volumes[1:]):
        assert before["time_end"] == after["time_start"]
    for volume in volumes:
        space = volume["volume"]
        ring = [metres(v) for v in space["outline_polygon"]["vertices"]]
        low, high = (space[f"altitude_{which}"] for which in ("lower", "upper"))
        assert {k: low[k] for k in ("reference", "units")} == {"reference": "W84", "units": "M"}
        begin, end = (min(max(seconds(volume[k]) - start, 0), flown) for k in ("time_start", "time_end"))
        for i in range(201):
            x, y, z = position(record["segments"], begin + (end - begin) * i / 200)
            east, north = (y, x) if axes == "neu" else (x, y)
            assert low["value"] <= z - half[2] + HEIGHT and z + half[2] + HEIGHT <= high["value"]
            for a in (-half[0], half[0]):
                for b in (-half[1], half[1]):
                    assert within(ring, east + a, north + b), (volume, east, north)
                    looked += 1
    return looked


with tempfile.TemporaryDirectory() as name:
    folder = pathlib.Path(name)
    boxmap, trajectory = folder / "m.boxmap", folder / "t.jsonl"
    run("skyway-import", village, "-q", "--bounds", "0,0,0,80,60,60", "-o", boxmap)
    query = {"id": "q", "from": [5, 30, 5], "to": [70, 10, 5], "epoch": "2026-05-04T06:30:00Z", "start": 3600.1}
    path = run("skyway-plan", boxmap, "--queries", "-", "--vehicle", "box:1,1,0.5", "--margin", "0.25",
               stdin=json.dumps(query))
    trajectory.write_text(run("skyway-traj", boxmap, "--vmax", "8", "--amax", "6", "--solver", "stop-and-go", stdin=path))
    record = json.loads(trajectory.read_text())
    place = f"{LATITUDE},{LONGITUDE},{HEIGHT}"
    sizes = []
    for most in (1, 3, 12):
        text = run("skyway-export", boxmap, trajectory, "--format", "volume4d", "--volumes", str(most), "--buffer", str(BUFFER),
                   "--origin", place)
        intent = json.loads(text)
        assert 1 <= len(intent["volumes"]) <= most and intent["off_nominal_volumes"] == [] and "priority" not in intent
        assert check(record, intent, record["frame"]) == 804 * len(intent["volumes"])
        sizes.append(len(intent["volumes"]))
    assert sizes == sorted(sizes) and sizes[0] == 1 and sizes[-1] > 3
print("volumes hold the flight")
