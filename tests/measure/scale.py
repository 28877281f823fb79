"""scale.py BIN_DIR SIDE [SIDE ...]: made-up cities of these sides (metres), imported and planned in.

For each: boxes; wall seconds and peak megabytes of the import; then 20 processes of skyway-plan, each
one street-level query of 45 to 50 m whose straight line is blocked, without lattice, the file cached.
"""

import json
import math
import os
import pathlib
import random
import subprocess
import sys
import tempfile
import time

BIN = pathlib.Path(sys.argv[1])
VEHICLE = ["--vehicle", "box:1,1,1"]


def run(*args, text=None):
    """Output, wall seconds and peak megabytes of one process."""
    out = tempfile.TemporaryFile()
    begin = time.monotonic()
    child = subprocess.Popen([str(BIN / args[0]), *map(str, args[1:])], stdout=out,
                             stdin=subprocess.PIPE if text else subprocess.DEVNULL)
    if text:
        child.stdin.write(text.encode())
        child.stdin.close()
    _, status, usage = os.wait4(child.pid, 0)
    seconds = time.monotonic() - begin
    out.seek(0)
    return out.read().decode(), seconds, usage.ru_maxrss / 1024, os.waitstatus_to_exitcode(status)


def blocked_pairs(city, side):
    """Free ends under 20 m, 45 to 50 m apart, that do not see each other."""
    random.seed(5)
    pairs = []
    for _ in range(400):
        a = [random.uniform(-0.45, 0.45) * side, random.uniform(-0.45, 0.45) * side, random.uniform(2, 20)]
        turn, length = random.uniform(0, 2 * math.pi), random.uniform(45, 50)
        b = [a[0] + length * math.cos(turn), a[1] + length * math.sin(turn), random.uniform(2, 20)]
        pairs.append((a, b))
    lines = [json.dumps(q) for a, b in pairs for q in ({"segment": [a, b]}, {"point": a}, {"point": b})]
    answers = [json.loads(line)["hit"] for line in
               run("skyway-query", city, *VEHICLE, text="\n".join(lines))[0].splitlines()]
    return [p for i, p in enumerate(pairs) if answers[3 * i:3 * i + 3] == [True, False, False]][:20]


for side in sys.argv[2:]:
    with tempfile.TemporaryDirectory() as folder:
        table, city = os.path.join(folder, "city.csv"), os.path.join(folder, "city.boxmap")
        run("skyway-synth", "--seed", 1, "--size", side, "-o", table)
        _, seconds, megabytes, code = run("skyway-import", table, "-o", city)
        assert code == 0
        boxes = [line for line in run("skyway-info", city)[0].splitlines() if line.startswith("boxes:")][0]
        walls, peaks, found = [], [], 0
        for a, b in blocked_pairs(city, float(side)):
            ends = ["--from=" + ",".join(map(repr, a)), "--to=" + ",".join(map(repr, b))]
            run("skyway-plan", city, *VEHICLE, *ends)
            out, wall, peak, _ = run("skyway-plan", city, *VEHICLE, *ends)
            found += json.loads(out)["status"] == "found"
            walls.append(wall)
            peaks.append(peak)
        walls.sort()
        print(f"{boxes}; import {seconds:.2f} s, {megabytes:.0f} MB; {found} of {len(walls)} queries found, "
              f"wall median {walls[(len(walls) - 1) // 2]:.3f} s, max {walls[-1]:.3f} s, peak {max(peaks):.0f} MB",
              flush=True)
