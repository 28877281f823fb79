"""ways_home.py BIN_DIR FOLDER FLIGHTS.csv [PADS]: ways home of an hour of flights over Vienna to its busiest pads, and their check.

FOLDER is that of tools/cluster/vienna/run.sh, with city.boxmap and trajectories.*.jsonl; FLIGHTS.csv the table that it was
made from. The landing sites are the PADS (10) places that most flights begin or end at. Prints the share of time with a way
home, the mean and the least length, and seconds of the wall and of the CPU.
"""

import ast
import collections
import csv
import json
import pathlib
import resource
import subprocess
import sys
import tempfile
import time

VEHICLES = pathlib.Path(__file__).parents[2] / "tools/cluster/vienna"


def busiest_pads(table, count):
    """Longitudes and latitudes, the most frequent first."""
    uses = collections.Counter()
    with open(table, newline="") as lines:
        for row in csv.reader(lines):
            uses.update(ast.literal_eval(field) for field in (row[4], row[5]))
    return [place for place, _ in sorted(uses.items(), key=lambda use: (-use[1], use[0]))[:count]]


def geojson(places):
    point = lambda i, place: {"type": "Feature", "properties": {"id": f"pad-{i}"}, "geometry": {"type": "Point", "coordinates": place}}
    return {"type": "FeatureCollection", "features": [point(i + 1, place) for i, place in enumerate(places)]}


def timed(*command):
    """Seconds of the wall and of the CPU, and the exit code, which is 0 or 1."""
    before, begin = resource.getrusage(resource.RUSAGE_CHILDREN), time.monotonic()
    code = subprocess.run([str(word) for word in command], stderr=subprocess.DEVNULL).returncode
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    assert code <= 1, command
    return time.monotonic() - begin, after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime, code


def measure(bin_dir, folder, sites, flights):
    """What came of the flights of one vehicle."""
    profile = VEHICLES / f"{flights.name.split('.')[1]}.json"
    with tempfile.TemporaryDirectory() as scratch:
        home, stats, reports = (pathlib.Path(scratch) / name for name in ("home.jsonl", "stats.json", "reports.jsonl"))
        city = folder / "city.boxmap"
        planned = timed(bin_dir / "skyway-plan", city, "--home", sites, flights, "--vehicle", profile, "-o", home, "--stats", stats, "-q")
        checked = timed(bin_dir / "skyway-check", city, flights, "--contingencies", home, "--vehicle", profile, "-o", reports, "-q")
        reasons = collections.Counter(json.loads(line).get("reason", "ok") for line in open(reports))
        return {**json.loads(stats.read_text()), "wall": planned[0], "cpu": planned[1], "check_wall": checked[0], "reasons": reasons}


def main():
    bin_dir, folder, table = map(pathlib.Path, sys.argv[1:4])
    sites = folder / "busiest-pads.geojson"
    sites.write_text(json.dumps(geojson(busiest_pads(table, int(sys.argv[4]) if len(sys.argv) > 4 else 10))))
    found = [measure(bin_dir, folder, sites, flights) for flights in sorted(folder.glob("trajectories.MP?0.jsonl"))]
    total = lambda key: sum(one[key] for one in found)
    covered = sum(one["seconds"] * one["share"] for one in found)
    print(f"{total('flights')} flights, {total('ways')} ways, {100 * covered / total('seconds'):.2f} % of {total('seconds') / 3600:.0f} h")
    mean = sum(one["mean_length"] * one["seconds"] * one["share"] for one in found) / covered
    print(f"length: mean {mean:.0f} m, least {min(one['least_length'] for one in found):.0f} m")
    print(f"planning: {total('wall'):.1f} s of wall, {total('cpu'):.1f} s of CPU; check: {total('check_wall'):.1f} s of wall")
    print("check:", dict(sum((one["reasons"] for one in found), collections.Counter())))


main()
