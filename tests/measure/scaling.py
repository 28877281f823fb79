"""scaling.py BIN_DIR FOLDER ROADMAP_MOST MAP [MAP ...]: what each step costs on ever larger maps.

For each map, smallest first: the 5 m lattice with 6 neighbours and, for maps of at most ROADMAP_MOST
boxes, the roadmap of 40 m reach, both into FOLDER; then the same number of street-level queries of
200 m whose straight line is blocked, all over the map, planned with nothing prepared and with that
roadmap; the check of the paths, and trajectories of them. One process and one thread a step: CPU
seconds, peak megabytes, megabytes written. A step that asks is run twice, and the second time counts.
At the end the exponents: the slope of the straight line through the logarithms.
"""

import json
import math
import os
import pathlib
import subprocess
import sys

from street_queries import VEHICLE, blocked, info

BIN, FOLDER = map(pathlib.Path, sys.argv[1:3])
LIMITS = ["--vmax", "8", "--amax", "6"]
QUERIES = 50
LENGTH = 200  # metres


def run(tool, *args, output):
    """CPU seconds, peak megabytes, megabytes written."""
    command = [str(BIN / tool), *map(str, args), "--threads", "1", "-q", "-o", str(output)]
    child = subprocess.Popen(command, stdin=subprocess.DEVNULL)
    _, status, usage = os.wait4(child.pid, 0)
    code = os.waitstatus_to_exitcode(status)
    assert code in (0, 1), command
    return usage.ru_utime + usage.ru_stime, usage.ru_maxrss / 1024, output.stat().st_size / 1e6


def asked(*args, output):
    run(*args, output=output)
    return run(*args, output=output)


def queries(map_file, low, high):
    """In a file, as JSON Lines."""
    chosen = blocked(BIN, map_file, low, high, LENGTH, QUERIES, 8 * QUERIES)
    assert len(chosen) == QUERIES
    path = FOLDER / "queries.jsonl"
    path.write_text("".join(json.dumps({"id": f"q{i}", "from": a, "to": b}) + "\n" for i, (a, b) in enumerate(chosen)))
    return path


def measure(map_file, boxes, low, high, with_roadmap):
    paths, steps = FOLDER / "paths.jsonl", {}
    steps["lattice"] = run("skyway-lattice", map_file, *VEHICLE, "--spacing", 5, output=FOLDER / "l.lattice")
    asking = ["skyway-plan", map_file, *VEHICLE, "--queries", queries(map_file, low, high)]
    if with_roadmap:
        roadmap = FOLDER / "r.roadmap"
        steps["roadmap"] = run("skyway-roadmap", map_file, *VEHICLE, "--reach", 40, output=roadmap)
        steps["plan --roadmap"] = asked(*asking, "--roadmap", roadmap, output=paths)
    steps["plan"] = asked(*asking, output=paths)
    steps["check"] = asked("skyway-check", map_file, paths, output=FOLDER / "reports.jsonl")
    steps["traj"] = asked("skyway-traj", map_file, paths, *LIMITS, output=FOLDER / "trajectories.jsonl")
    return steps


def exponent(points):
    x = [math.log(boxes) for boxes, _ in points]
    y = [math.log(max(value, 1e-3)) for _, value in points]
    mean_x, mean_y = sum(x) / len(x), sum(y) / len(y)
    return (sum((a - mean_x) * (b - mean_y) for a, b in zip(x, y)) / sum((a - mean_x) ** 2 for a in x))


table = {}
for file in sys.argv[4:]:
    boxes, low, high = info(BIN, file)
    for step, costs in measure(file, boxes, low, high, boxes <= float(sys.argv[3])).items():
        table.setdefault(step, []).append((boxes, costs))
        print(f"{boxes} boxes, {step}: CPU {costs[0]:.2f} s, peak {costs[1]:.0f} MB, file {costs[2]:.2f} MB", flush=True)
for step, rows in table.items():
    if len(rows) > 1:
        slopes = [exponent([(boxes, costs[k]) for boxes, costs in rows]) for k in range(3)]
        print(f"{step}: exponents of CPU {slopes[0]:.2f}, peak {slopes[1]:.2f}, file {slopes[2]:.2f}")
