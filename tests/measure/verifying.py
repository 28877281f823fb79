"""verifying.py BEFORE_BIN AFTER_BIN MAP [MAP ...]: what holding maps against their files costs, as processes.

For each map one street-level query of 45 to 50 m whose straight line is blocked, its path and trajectory, and then
skyway-plan, skyway-check and skyway-export of two builds: with the file in the system's cache and not, and of the later
build without a mark of an earlier run and with one. Median wall and CPU seconds of RUNS (default 5) processes,
and the largest peak megabytes. Where caches may not be dropped whole, that file is.
"""

import json
import math
import os
import pathlib
import random
import shutil
import statistics
import subprocess
import sys
import tempfile
import time

BEFORE, AFTER = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
RUNS = int(os.environ.get("RUNS", 5))
VEHICLE = ["--vehicle", "box:1,1,1", "--margin", "0.5"]


def output(*args, text=None):
    done = subprocess.run([str(AFTER / args[0]), *map(str, args[1:])], input=text, capture_output=True, text=True)
    return done.returncode, done.stdout


def blocked_query(city):
    """Free ends under 20 m, 45 to 50 m apart, that do not see each other, and a path between them."""
    about = json.loads(output("skyway-info", "--json", city)[1])
    low, high = about["bounds_min_m"], about["bounds_max_m"]
    rng = random.Random(5)
    pairs = []
    for _ in range(400):
        a = [rng.uniform(low[i] + 0.1 * (high[i] - low[i]), high[i] - 0.1 * (high[i] - low[i])) for i in (0, 1)]
        turn, length = rng.uniform(0, 2 * math.pi), rng.uniform(45, 50)
        b = [a[0] + length * math.cos(turn), a[1] + length * math.sin(turn)]
        pairs.append((a + [low[2] + rng.uniform(5, 20)], b + [low[2] + rng.uniform(5, 20)]))
    lines = [json.dumps(q) for a, b in pairs for q in ({"segment": [a, b]}, {"point": a}, {"point": b})]
    answers = [json.loads(line)["hit"] for line in
               output("skyway-query", city, *VEHICLE, text="\n".join(lines))[1].splitlines()]
    for i, (a, b) in enumerate(pairs):
        ends = ["--from=" + ",".join(map(repr, a)), "--to=" + ",".join(map(repr, b))]
        if answers[3 * i:3 * i + 3] != [True, False, False]:
            continue
        code, path = output("skyway-plan", city, *VEHICLE, *ends)
        if code == 0:
            code, trajectory = output("skyway-traj", city, "--vmax", 5, "--amax", 4, text=path)
        if code == 0 and output("skyway-check", city, text=trajectory)[0] == 0:
            return ends, trajectory
    raise SystemExit(f"{city}: no query that is blocked and can be flown")


def drop(city):
    os.sync()
    try:
        pathlib.Path("/proc/sys/vm/drop_caches").write_text("1")
    except OSError:
        with open(city, "rb") as file:
            os.posix_fadvise(file.fileno(), 0, 0, os.POSIX_FADV_DONTNEED)


def measure(command, environment):
    """Wall and CPU seconds and peak megabytes of one process."""
    begin = time.monotonic()
    child = subprocess.Popen([str(part) for part in command], env=environment, stdout=subprocess.DEVNULL,
                             stdin=subprocess.DEVNULL)
    _, status, usage = os.wait4(child.pid, 0)
    assert os.waitstatus_to_exitcode(status) == 0, command
    return time.monotonic() - begin, usage.ru_utime + usage.ru_stime, usage.ru_maxrss / 1024


def row(command, city, cache, cached, mark):
    environment = dict(os.environ, XDG_CACHE_HOME=str(cache))
    shutil.rmtree(cache, ignore_errors=True)
    measure(command, environment)
    if mark:
        assert list((cache / "skyway/verified").iterdir()), "no mark was left"
    walls, times, peaks = [], [], []
    for _ in range(RUNS):
        if not mark:
            shutil.rmtree(cache, ignore_errors=True)
        if not cached:
            drop(city)
        wall, cpu, peak = measure(command, environment)
        walls.append(wall)
        times.append(cpu)
        peaks.append(peak)
    return f"{statistics.median(walls):.3f} s {statistics.median(times):.3f} s {max(peaks):.0f} MB"


for city in sys.argv[3:]:
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        os.environ["XDG_CACHE_HOME"] = str(folder / "prepared")
        time.sleep(max(0, 4 - (time.time() - os.stat(city).st_ctime)))  # marks are of settled files
        ends, trajectory = blocked_query(city)
        file = folder / "trajectory.jsonl"
        file.write_text(trajectory)
        out = ["-o", folder / "out"]
        commands = {"plan": ["skyway-plan", city, *VEHICLE, *ends, *out], "check": ["skyway-check", city, file, *out],
                    "export": ["skyway-export", city, file, "--format", "setpoints", *out]}
        boxes = json.loads(output("skyway-info", "--json", city)[1])["boxes"]
        print(f"{pathlib.Path(city).name}, {boxes} boxes, {os.path.getsize(city) / 1e6:.1f} MB")
        print(f"  {'':20}{'before':>26}{'after, no mark':>26}{'after, mark':>26}")
        for tool, command in commands.items():
            for cached in (True, False):
                cells = [row([binaries / command[0], *command[1:]], city, folder / "cache", cached, mark)
                         for binaries, mark in ((BEFORE, False), (AFTER, False), (AFTER, True))]
                print(f"  {tool + (', cached' if cached else ', not cached'):20}" + "".join(f"{c:>26}" for c in cells),
                      flush=True)
