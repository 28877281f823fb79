"""shards.py BIN_DIR FOLDER MAP [MAP ...]: what shards cost as maps grow.

For each map, with shards of about 100,000 boxes: the 5 m lattice by shards and joined, 1,000 street-level
queries of 50 to 500 m by four shards on that lattice, and trajectories of all paths found by four shards.
What single trajectories cost is measured once more by traj_bench, built beside the tools.
CPU seconds (user and system, one thread) and peak megabytes are of single processes; joined files are kept in
FOLDER until the next map.
"""

import json
import math
import os
import pathlib
import random
import subprocess
import sys
import tempfile

BIN = pathlib.Path(sys.argv[1])
FOLDER = pathlib.Path(sys.argv[2])
VEHICLE = ["--vehicle", "box:1,1,1"]


def run(*args):
    """CPU seconds and peak megabytes of one process."""
    with tempfile.TemporaryFile() as errors:
        child = subprocess.Popen([str(BIN / args[0]), *map(str, args[1:])], stderr=errors,
                                 stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL)
        _, status, usage = os.wait4(child.pid, 0)
        errors.seek(0)
        assert os.waitstatus_to_exitcode(status) in (0, 1), errors.read().decode()
    return usage.ru_utime + usage.ru_stime, usage.ru_maxrss / 1024


def sharded(name, count, args, output):
    """Runs all shards of a command and joins them; prints what they took."""
    costs = []
    for k in range(1, count + 1):
        costs.append(run(*args, "--threads", 1, "--shard", f"{k}/{count}", "-o", FOLDER / f"shard.{k}"))
    joined = run("skyway-join", *(FOLDER / f"shard.{k}" for k in range(1, count + 1)), "--threads", 1, "-o", output)
    for k in range(1, count + 1):
        (FOLDER / f"shard.{k}").unlink()
    seconds = [c for c, _ in costs]
    print(f"  {name}: {count} shards, {sum(seconds):.1f} s CPU in all, longest {max(seconds):.2f} s, "
          f"peak {max(m for _, m in costs):.0f} MB; joining {joined[0]:.2f} s, {joined[1]:.0f} MB; "
          f"{os.path.getsize(output) / 1e6:.1f} MB", flush=True)
    return sum(seconds)


def queries(side, count):
    random.seed(5)
    for i in range(count):
        a = [random.uniform(-0.4, 0.4) * side, random.uniform(-0.4, 0.4) * side, random.uniform(2, 20)]
        turn, length = random.uniform(0, 2 * math.pi), random.uniform(50, 500)
        b = [a[0] + length * math.cos(turn), a[1] + length * math.sin(turn), random.uniform(2, 20)]
        yield json.dumps({"id": f"street-{i}", "from": a, "to": b})


for city in sys.argv[3:]:
    about = json.loads(subprocess.check_output([BIN / "skyway-info", "--json", city]))
    side = about["bounds_max_m"][0] - about["bounds_min_m"][0]
    print(f"{about['boxes']} boxes, {about['tiles']} tiles:")
    lattice = FOLDER / "lattice"
    shards = max(1, round(about["boxes"] / 1e5))
    total = sharded("lattice", shards, ["skyway-lattice", city, "--spacing", 5, *VEHICLE], lattice)
    print(f"  {1e3 * total / about['tiles']:.3f} ms a tile", flush=True)
    (FOLDER / "queries").write_text("\n".join(queries(side, 1000)))
    sharded("paths", 4, ["skyway-plan", city, "--lattice", lattice, "--queries", FOLDER / "queries", "--snap-ends", 30,
                         *VEHICLE], FOLDER / "paths")
    found = [line for line in (FOLDER / "paths").read_text().splitlines() if '"found"' in line]
    (FOLDER / "found").write_text("\n".join(found))
    print(f"  {len(found)} paths found", flush=True)
    sharded("trajectories", 4, ["skyway-traj", city, FOLDER / "found", "--vmax", 8, "--amax", 6, *VEHICLE],
            FOLDER / "trajectories")
    each = subprocess.check_output([BIN.parent / "tests/bench/traj_bench", city, FOLDER / "found", "1e-3"])
    print(f"  {each.decode().strip()}", flush=True)
