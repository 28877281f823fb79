"""fleet_check.py BIN_DIR MAP TRAJECTORIES PATHS: what many records cost with one thread and with two.

8,000 records are made of the trajectories, with other ids and one of four smaller vehicles each, in random order and
sorted by vehicle. Prints wall seconds, the least of three times, of skyway-check, of skyway-check --together and of
skyway-traj along the paths, and the ratio of one thread to two. PATHS are of any length, for the same map.
"""

import json
import os
import pathlib
import random
import subprocess
import sys
import tempfile
import time

BIN, MAP, TRAJECTORIES, PATHS = sys.argv[1:5]
RECORDS = 8000
SHARES = (1, 0.9, 0.7, 0.5)  # of the vehicle's half sizes
random.seed(1)


def fleet():
    """Of each record its vehicle and its line."""
    solved = [r for r in map(json.loads, open(TRAJECTORIES, encoding="utf-8")) if r["status"] == "solved"]
    for k in range(RECORDS):
        record = dict(solved[k % len(solved)], id=f"f{k}")
        kind = random.randrange(len(SHARES))
        half = [SHARES[kind] * size for size in record["vehicle"]["half"]]
        yield kind, json.dumps(dict(record, vehicle={"name": f"kind {kind}", "half": half})) + "\n"


def least_seconds(*command):
    least = 1e9
    for _ in range(3):
        begin = time.monotonic()
        done = subprocess.run([os.path.join(BIN, command[0]), *command[1:], "-q", "-o", "/dev/null"], check=False)
        least = min(least, time.monotonic() - begin)
        assert done.returncode in (0, 1)
    return least


def row(name, *command):
    one, two = (least_seconds(*command, "--threads", str(threads)) for threads in (1, 2))
    print(f"{name}: {one:.2f} s, two threads {two:.2f} s, ratio {one / two:.2f}", flush=True)


def main():
    records = list(fleet())
    with tempfile.TemporaryDirectory() as folder:
        for order in ("mixed", "sorted"):
            file = pathlib.Path(folder) / order
            lines = records if order == "mixed" else sorted(records, key=lambda record: record[0])
            file.write_text("".join(line for _, line in lines), encoding="utf-8")
            row(f"check, {order}", "skyway-check", MAP, str(file))
            row(f"together, {order}", "skyway-check", MAP, str(file), "--together", "--separation", "1,1")
    row("traj", "skyway-traj", MAP, PATHS, "--vmax", "8", "--amax", "6")


main()
