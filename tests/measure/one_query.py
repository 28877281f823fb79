"""one_query.py BIN_DIR LENGTH MAP ROADMAP [MAP ROADMAP ...]: what one query costs that has a process to itself.

For each map, smallest first: street-level queries of that many metres whose straight line is blocked, all over the map,
each planned by a skyway-plan of its own with the roadmap, one thread, after all were planned once. CPU milliseconds (the
median, least and greatest of the queries, each the less of two runs) and peak megabytes. Then the exponent: the slope of the
straight line through the logarithms of the medians over those of the numbers of boxes.
"""

import json
import math
import os
import pathlib
import random
import statistics
import subprocess
import sys

BIN, LENGTH = pathlib.Path(sys.argv[1]), float(sys.argv[2])
VEHICLE = ["--vehicle", "box:1,1,1"]
QUERIES = 20


def info(map_file):
    lines = subprocess.run([BIN / "skyway-info", map_file], check=True, capture_output=True, text=True).stdout
    fields = dict(line.split(": ", 1) for line in lines.splitlines() if ": " in line)
    return int(fields["boxes"]), json.loads(fields["bounds_min_m"]), json.loads(fields["bounds_max_m"])


def queries(map_file, low, high):
    """Free ends under 20 m that do not see each other."""
    random.seed(7)
    pairs = []
    for _ in range(16 * QUERIES):
        a = [random.uniform(low[k] + LENGTH + 2, high[k] - LENGTH - 2) for k in range(2)] + [random.uniform(2, 20)]
        turn = random.uniform(0, 2 * math.pi)
        pairs.append((a, [a[0] + LENGTH * math.cos(turn), a[1] + LENGTH * math.sin(turn), random.uniform(2, 20)]))
    lines = [json.dumps(q) for a, b in pairs for q in ({"segment": [a, b]}, {"point": a}, {"point": b})]
    answers = subprocess.run([BIN / "skyway-query", map_file, *VEHICLE], input="\n".join(lines), check=True,
                             capture_output=True, text=True).stdout
    hit = [json.loads(line)["hit"] for line in answers.splitlines()]
    return [pair for i, pair in enumerate(pairs) if hit[3 * i:3 * i + 3] == [True, False, False]][:QUERIES]


def planned(map_file, roadmap, pair):
    """CPU seconds, peak megabytes, whether it was found."""
    ends = [f"--{name}={','.join(map(str, p))}" for name, p in zip(("from", "to"), pair)]
    command = [BIN / "skyway-plan", map_file, *VEHICLE, "--roadmap", roadmap, *ends, "--threads", "1", "-q", "-o", os.devnull]
    child = subprocess.Popen(command)
    _, status, usage = os.wait4(child.pid, 0)
    assert os.waitstatus_to_exitcode(status) in (0, 1), command
    return usage.ru_utime + usage.ru_stime, usage.ru_maxrss / 1024, status == 0


sizes, medians = [], []
for map_file, roadmap in zip(sys.argv[3::2], sys.argv[4::2]):
    boxes, low, high = info(map_file)
    pairs = queries(map_file, low, high)
    runs = [[planned(map_file, roadmap, pair) for pair in pairs] for _ in range(3)][1:]
    times = sorted(1000 * min(a[0], b[0]) for a, b in zip(*runs))
    peak = max(run[1] for run in runs[0])
    found = sum(run[2] for run in runs[0])
    sizes.append(math.log(boxes))
    medians.append(math.log(statistics.median(times)))
    print(f"{boxes} boxes: {statistics.median(times):.1f} ms ({times[0]:.1f} to {times[-1]:.1f}), {peak:.0f} MB, "
          f"{found} of {len(pairs)} found", flush=True)
if len(sizes) > 1:
    print(f"exponent {statistics.linear_regression(sizes, medians).slope:.2f}")
