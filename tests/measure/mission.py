"""mission.py BIN_DIR MAP [ITEMS]: how long skyway-check takes of a mission of ITEMS (10,000) waypoints without a rest.

Legs of 60 m, at random over the map and below the upper bound by up to 9 m. Three processes each,
as they are and with a cache of their own, so that the map is verified first; then a mission of DJI's through
the same points, with coordinated turns.
"""

import json
import math
import os
import pathlib
import random
import resource
import subprocess
import sys
import tempfile

bin_dir, city = pathlib.Path(sys.argv[1]), sys.argv[2]
count = int(sys.argv[3]) if len(sys.argv) > 3 else 10000
rng = random.Random(5)
NORTH, EAST = 111171, 76057  # metres a degree at 47 N


def bounds():
    said = subprocess.run([bin_dir / "skyway-info", city], capture_output=True, text=True, check=True).stdout
    lines = dict(line.split(": ", 1) for line in said.splitlines() if ": " in line)
    return json.loads(lines["bounds_min_m"]), json.loads(lines["bounds_max_m"])


def mission(low, high):
    lines = ["QGC WPL 110"]
    east, north = 0.0, 0.0
    side = 0.5 * min(high[0], high[1])
    for number in range(count):
        angle = rng.uniform(0, 2 * math.pi)
        east = min(max(east + 60 * math.cos(angle), -side), side)
        north = min(max(north + 60 * math.sin(angle), -side), side)
        height = high[2] - rng.uniform(1, 9)
        lines.append(f"{number}\t0\t3\t16\t0\t0\t0\t0\t{47 + north / NORTH:.7f}\t{8 + east / EAST:.7f}\t{height:.3f}\t1")
    return "\n".join(lines) + "\n"


def dji(folder, text, high):
    """A KMZ through the waypoints of a WPL, from a ground 20 m below the upper bound."""
    items = [line.split("\t") for line in text.splitlines()[1:]]
    points = [[(float(i[9]) - 8) * EAST, (float(i[8]) - 47) * NORTH, float(i[10])] for i in items]
    record = {"type": "path", "id": "m", "status": "found", "frame": "enu", "points": points}
    path = pathlib.Path(folder) / "m.kmz"
    subprocess.run([bin_dir / "skyway-export", "--unchecked", "--format", "dji-wpml", "--turns", "5", "--hover", "--origin",
                    "47,8,0", "--ground", str(high[2] - 20), "-q", "-o", path], input=json.dumps(record), text=True, check=True)
    return path


def timed(path, cache, form="wpl"):
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    done = subprocess.run([bin_dir / "skyway-check", city, path, "-q", "--file-format", form, "--vehicle", "box:0.3,0.3,0.2",
                           "--origin", "47,8,0", *(["--ground", "0", "--braking", "10"] if form == "wpl" else [])],
                          capture_output=True, text=True, env={**os.environ, **cache})
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    report = json.loads(done.stdout)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime, report["ok"], report.get("reason")


with tempfile.TemporaryDirectory() as folder:
    path = pathlib.Path(folder) / "m.wpl"
    low, high = bounds()
    path.write_text(mission(low, high))
    for name, caches in (("verified before", [{}] * 3),
                         ("first use", [{"XDG_CACHE_HOME": f"{folder}/{i}"} for i in range(3)])):
        for cache in caches:
            seconds, ok, reason = timed(path, cache)
            print(f"{name}: {seconds:.3f} s of CPU, ok {ok} {reason or ''}")
    for _ in range(3):
        seconds, ok, reason = timed(dji(folder, path.read_text(), high), {}, "dji-wpml")
        print(f"DJI: {seconds:.3f} s of CPU, ok {ok} {reason or ''}")
