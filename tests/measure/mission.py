"""mission.py BIN_DIR MAP [ITEMS]: how long skyway-check takes of a mission of ITEMS (10,000) waypoints without a rest.

Legs of 60 m, at random over the map and below the upper bound by up to 9 m. Three processes each,
as they are and with a cache of their own, so that the map is verified first.
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


def timed(path, cache):
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    done = subprocess.run([bin_dir / "skyway-check", city, path, "-q", "--file-format", "wpl", "--vehicle", "box:0.3,0.3,0.2",
                           "--origin", "47,8,0", "--ground", "0", "--braking", "10"],
                          capture_output=True, text=True, env={**os.environ, **cache})
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    report = json.loads(done.stdout)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime, report["ok"], report.get("reason")


with tempfile.TemporaryDirectory() as folder:
    path = pathlib.Path(folder) / "m.wpl"
    path.write_text(mission(*bounds()))
    for name, caches in (("verified before", [{}] * 3),
                         ("first use", [{"XDG_CACHE_HOME": f"{folder}/{i}"} for i in range(3)])):
        for cache in caches:
            seconds, ok, reason = timed(path, cache)
            print(f"{name}: {seconds:.3f} s of CPU, ok {ok} {reason or ''}")
