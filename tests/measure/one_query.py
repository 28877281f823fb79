"""one_query.py BIN_DIR LENGTH MAP ROADMAP [MAP ROADMAP ...]: what one query costs that has a process to itself.

For each map, smallest first: street-level queries of that many metres whose straight line is blocked, all over the map,
each planned by a skyway-plan of its own with the roadmap, one thread, after all were planned once. CPU milliseconds (the
median, least and greatest of the queries, each the less of two runs) and peak megabytes. Then the exponent: the slope of the
straight line through the logarithms of the medians over those of the numbers of boxes.
"""

import math
import os
import pathlib
import statistics
import subprocess
import sys

from street_queries import VEHICLE, blocked, info

BIN, LENGTH = pathlib.Path(sys.argv[1]), float(sys.argv[2])
QUERIES = 20


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
    boxes, low, high = info(BIN, map_file)
    pairs = blocked(BIN, map_file, low, high, LENGTH, QUERIES, 16 * QUERIES)
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
