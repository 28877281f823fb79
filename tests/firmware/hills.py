#!/usr/bin/env python3
"""Makes up ground and missions with heights above it, and flies them with ArduCopter.

hills.py OUT --seed 1 --count 40 [--kind KIND] [-- options of fly.py]: OUT gets the grounds (.asc), the missions (.waypoints),
the tracks (.csv), what fly.py printed (.txt), and flights.csv, the table for judge_flights. The autopilot's terrain is wrong by
as much as its claim allows. The same seed makes the same flights. What was flown already is not flown again. With --judge that
program is run at once.
"""

import argparse
import concurrent.futures
import dataclasses
import math
import pathlib
import random
import subprocess
import sys

import terrain

FLY = pathlib.Path(__file__).resolve().parent / "fly.py"
# Posts count from whole degrees, and are furthest from where they are thought to be at the other end of a degree.
HOMES = ((47.97, 8.95), (46.98, 7.45), (60.93, 10.9), (-33.05, 18.04), (37.02, -122.1))
SEA = 400.0  # m above it: the ground at home
HALF, CELL = 800, 40  # m: the ground reaches so far from home
KINDS = ("hills", "ridge", "cliff", "steps", "saw", "pits")


def heights(chance, kind):
    """A function of east and north: metres of the ground over that at home, which is near 0, 0."""
    turn = chance.uniform(0, 2 * math.pi)
    along = lambda e, n: e * math.cos(turn) + n * math.sin(turn)
    high, at, width = chance.uniform(15, 70), chance.uniform(60, 220), chance.uniform(60, 200)
    if kind == "hills":
        bumps = [(chance.uniform(-350, 350), chance.uniform(-350, 350), chance.uniform(60, 160), chance.uniform(-30, 50)) for _ in range(8)]
        return lambda e, n: sum(h * math.exp(-((e - x) ** 2 + (n - y) ** 2) / (2 * s * s)) for x, y, s, h in bumps)
    if kind == "ridge":
        return lambda e, n: high * max(0.0, 1 - abs(along(e, n) - at) / width)
    if kind == "cliff":
        sign = chance.choice((-1, 1))
        return lambda e, n: sign * high * (along(e, n) > at)
    if kind == "steps":
        return lambda e, n: 0.5 * high * math.floor(along(e, n) / width + 0.5)
    if kind == "saw":
        return lambda e, n: high * ((along(e, n) / (2 * width)) % 1)
    holes = [(chance.uniform(-300, 300), chance.uniform(-300, 300)) for _ in range(12)]
    return lambda e, n: sum((-1) ** k * high * (math.hypot(e - x, n - y) < 50) for k, (x, y) in enumerate(holes))


def made_ground(chance, kind):
    height = heights(chance, kind)
    ticks = range(-HALF, HALF + 1, CELL)
    return terrain.Ground(-HALF, -HALF, CELL, [[round(SEA + height(e, n) - height(0, 0), 1) for e in ticks] for n in ticks])


@dataclasses.dataclass
class Flight:
    name: str
    ground: terrain.Ground
    mission: str
    error: tuple  # metres, how, seed
    settings: dict
    return_height: str


def made(seed, kind, ends, narrow=False):
    """`narrow`: posts are near to one another, and off by a metre at most. `ends`: land, land_here, return; not claimed:
    land_home_frame, return_terrain."""
    chance = random.Random(f"{kind} {ends} {seed}")
    home = chance.choice(HOMES)
    ground = made_ground(chance, kind)
    north, east = terrain.metres_of_degrees(home[0])
    bias = chance.choice((0, 0, 4, -4))  # the autopilot's height above the sea, which its terrain is set to when it arms
    rows = []

    def add(command, frame, e, n, height, hold=0.0):
        place = (home[0] + n / north, home[1] + e / east)
        rows.append(f"{len(rows)}\t0\t{frame}\t{command}\t{hold:g}\t0\t0\t0\t{place[0]:.7f}\t{place[1]:.7f}\t{height:g}\t1")

    low = chance.uniform(25, 45)
    add(16, 0, 0, 0, SEA + bias)
    add(22, chance.choice((3, 10)), 0, 0, round(low, 1))
    rows.append(f"{len(rows)}\t0\t2\t178\t1\t{chance.choice((3, 6, 10, 14))}\t-1\t0\t0\t0\t0\t1")
    height = low
    count = chance.randint(2, 5)
    e = n = 0.0
    for k in range(count):
        while True:
            to = chance.uniform(-350, 350), chance.uniform(-350, 350)
            if math.hypot(to[0] - e, to[1] - n) > 60:
                break
        e, n = to
        if chance.random() < 0.4:
            height = chance.uniform(25, 70)
        last = k + 1 == count
        rests = 3 if last and ends.startswith("return") else chance.choice((0, 0, 2, 4))
        add(16, 10, e, n, round(height, 1), rests)
    settings = {"TERRAIN_SPACING": chance.choice((100, 100, 50, 30)), "WPNAV_TER_MARGIN": chance.choice((10, 10, 3, 25)),
                "WPNAV_SPEED_UP": chance.choice((250, 250, 500)), "WPNAV_SPEED_DN": chance.choice((150, 150, 300))}
    return_height = ""
    if ends in ("land", "land_home_frame"):
        add(21, 10 if ends == "land" else 3, e + chance.uniform(-200, 200), n + chance.uniform(-200, 200), 0)
    elif ends == "land_here":
        rows.append(f"{len(rows)}\t0\t{chance.choice((3, 10))}\t21\t0\t0\t0\t0\t0\t0\t0\t1")
    else:
        rows.append(f"{len(rows)}\t0\t2\t20\t0\t0\t0\t0\t0\t0\t0\t1")
        return_height = str(chance.choice((150, 200)))
        settings |= {"RTL_ALT": 100 * int(return_height), "RTL_CONE_SLOPE": chance.choice((3, 0))}
        if ends == "return_terrain":
            settings["RTL_ALT_TYPE"] = 1
    error = (chance.choice((0, 3, 6, 10)), chance.choice(terrain.ERRORS[1:]), seed)
    if narrow:
        error, settings["TERRAIN_SPACING"] = (0, *error[1:]), chance.choice((20, 30))
    return Flight(f"{kind}_{ends}_{seed}", ground, "QGC WPL 110\n" + "\n".join(rows) + "\n", error, settings, return_height)


def fly(one, folder, options):
    ground, mission, track, notes = (folder / f"{one.name}.{end}" for end in ("asc", "waypoints", "csv", "txt"))
    if not (track.exists() and notes.exists()):
        one.ground.write(ground)
        mission.write_text(one.mission)
        command = [sys.executable, FLY, mission, "-o", track, "--firmware", "arducopter", "--terrain", ground,
                   "--terrain-error", ",".join(str(part) for part in one.error), *options]
        for key, value in one.settings.items():
            command += ["--set", f"{key}={value}"]
        done = subprocess.run(command, capture_output=True, text=True)
        notes.write_text(done.stderr + done.stdout)
    said = notes.read_text().strip().splitlines()[-1:] or [""]
    if not track.exists():
        return None, f"{one.name}: failed: {said[0][-200:]}"
    settings = " ".join(f"{key}={value}" for key, value in one.settings.items())
    return f"{track.name},{mission.name},ardupilot:4.7,,{one.return_height},{{}},,{ground.name},{one.error[0]},{settings}", f"{one.name}: {said[0][-200:]}"


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0], epilog="Options after -- go to fly.py.")
    parser.add_argument("outdir", type=pathlib.Path)
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--count", type=int, default=10)
    parser.add_argument("--kind", choices=KINDS, help="of all grounds (default: each in its turn)")
    parser.add_argument("--ends", help="of all missions (default: each of land, land_here and return in its turn)")
    parser.add_argument("--narrow", action="store_true", help="close posts without an error, which make the claim narrow")
    parser.add_argument("--navigation", default="0,0", help="metres across, and up or down, as skyway-check takes them (0,0)")
    parser.add_argument("-j", "--jobs", type=int, default=2, help="flights at once (2)")
    parser.add_argument("--judge", type=pathlib.Path, metavar="JUDGE_FLIGHTS", help="the program of that name, to run afterwards")
    at = sys.argv.index("--") if "--" in sys.argv else len(sys.argv)
    options, rest = parser.parse_args(sys.argv[1:at]), sys.argv[at + 1 :]
    options.outdir.mkdir(parents=True, exist_ok=True)
    ends = (options.ends,) if options.ends else ("land", "return", "land_here", "land", "return")
    flights = [made(1000 * options.seed + k, options.kind or KINDS[k % len(KINDS)], ends[k % len(ends)], options.narrow)
               for k in range(options.count)]
    rows = []
    with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        for row, said in pool.map(lambda one: fly(one, options.outdir, rest), flights):
            print(said, flush=True)
            rows += [row.format(options.navigation)] if row else []
    table = options.outdir / "flights.csv"
    table.write_text("track,mission,autopilot,acceptance,return_height,navigation_across,navigation_vertical,drag,ground,"
                     "terrain_error,settings\n" + "".join(f"{row}\n" for row in rows))
    if options.judge:
        return subprocess.run([options.judge, table]).returncode
    return 0


if __name__ == "__main__":
    sys.exit(main())
