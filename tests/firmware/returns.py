#!/usr/bin/env python3
"""Makes missions up, flies them, and ends each by a return, a landing or a hold at an instant of chance.

returns.py OUT --firmware px4 --seed 1 --count 50 [--kind KIND] [-- options of fly.py]: OUT gets the missions (.plan), the
tracks (.csv), what fly.py printed (.txt), and returns.csv, the table for judge_returns. The same seed makes the same
missions and orders. What was flown already is not flown again. With --judge that program is run at once.
With --exports TOOLS (the folder of Skyway's tools) the missions are planned through a made-up town instead, and exported with two
rally points that skyway-export --rally proves ways to: each flight then comes home by those.
"""

import argparse
import concurrent.futures
import json
import math
import pathlib
import random
import re
import subprocess
import sys
import tempfile

FLY = pathlib.Path(__file__).resolve().parent / "fly.py"
HOME = (37.75, -122.5)  # kept exactly by PX4's simulator
METRES = 111195.0  # a degree of latitude, near enough for missions at random
ORDERED = re.compile(r", (\w+) at ([\d.]+) s from ")
KINDS = ("corners", "climbs", "near", "fast", "rally", "starts", "past")


def place(east, north):
    return HOME[0] + north / METRES, HOME[1] + east / (METRES * math.cos(math.radians(HOME[0])))


def waypoints(chance, kind):
    """East, north and height of the take-off and of each waypoint; metres."""
    height = chance.uniform(5, 60)
    if kind == "past":  # fast past home, mostly so high that no climb comes first
        height, side = chance.uniform(25, 60), chance.choice((-1, 1)) * chance.uniform(0, 80)
        return [(0.0, 0.0, height), (-140.0, side, height), (140.0, side + chance.uniform(-30, 30), height)]
    reach = {"near": 25, "fast": 220}.get(kind, 110)
    points = [(0.0, 0.0, height)]
    for _ in range(chance.randint(2, 5)):
        if kind == "climbs":
            height = chance.uniform(6, 75)
        points.append((chance.uniform(-reach, reach), chance.uniform(-reach, reach), height))
    return points


def item(command, frame, params):
    return {"type": "SimpleItem", "autoContinue": True, "command": command, "frame": frame, "params": params}


def made(seed, kind, firmware):
    """(document of a plan, seconds after arming, action, parameters, airframe)"""
    chance = random.Random(f"{firmware} {kind} {seed}")
    points = waypoints(chance, kind)
    speed = chance.uniform(9, 12) if kind in ("fast", "starts", "past") else chance.choice((3, 5, 8, 12))
    items = [item(22, 3, [0, 0, 0, None, *HOME, points[0][2]]), item(178, 2, [1, speed, -1, 0, 0, 0, 0])]
    for east, north, height in points:
        hold = 3 if kind == "starts" else chance.choice((0, 0, 3))  # "starts": each leg begins at a rest
        items.append(item(16, 3, [hold, chance.choice((2, 2, 0)), 0, None, *place(east, north), height]))
    items[-1]["params"][0] = 90  # it waits there, so that the order always comes in time
    way = sum(math.dist(a, b) for a, b in zip(points, points[1:]))
    lasts = 5 + points[0][2] / 2 + way / speed + 8 * len(points)
    rally = []
    if kind == "rally":
        for _ in range(chance.choice((1, 2))):
            rally.append([*place(chance.uniform(-90, 90), chance.uniform(-90, 90)), chance.choice((5, 15, 30))])
    if kind == "places":  # so near to home that PX4 leaves it out, or so far away that ArduPilot does
        away, angle = chance.uniform(*((6, 13) if firmware == "px4" else (220, 420))), chance.uniform(0, 6.28)
        rally.append([*place(away * math.cos(angle), away * math.sin(angle)), 15])
    plan = {"fileType": "Plan", "version": 1, "groundStation": "made up",
            "geoFence": {"version": 2, "polygons": [], "circles": []}, "rallyPoints": {"version": 2, "points": rally},
            "mission": {"version": 2, "firmwareType": 12 if firmware == "px4" else 3, "vehicleType": 2, "cruiseSpeed": 10,
                        "hoverSpeed": 10, "globalPlanAltitudeMode": 1, "plannedHomePosition": [*HOME, 0.0], "items": items}}
    action = chance.choice(("rtl",) * 8 + ("land", "hold"))
    if firmware == "px4":
        params = {"RTL_RETURN_ALT": chance.choice((15, 30, 60)), "RTL_CONE_ANG": chance.choice((0, 25, 45, 80)),
                  "RTL_MIN_DIST": chance.choice((10, 10, 60)), "NAV_ACC_RAD": chance.choice((10, 10, 3)),
                  "RTL_LAND_DELAY": chance.choice((0, 0, 2))}
        airframe = chance.choice(("quad2kg", "quad2kg", "stock"))
    else:
        params = {"RTL_ALT": chance.choice((1000, 1500, 4000)), "RTL_CLIMB_MIN": chance.choice((0, 0, 500)),
                  "RTL_CONE_SLOPE": chance.choice((3, 3, 1, 0)), "RALLY_INCL_HOME": chance.choice((1, 1, 0))}
        airframe = "quad2kg"
    first = lasts - 8 - 280 / speed if kind == "past" else 3
    return plan, round(chance.uniform(first, lasts), 1), action, params, airframe


def made_town(chance, folder, pads):
    """A table of buildings of 6 to 24 m around home, none near the pads."""
    rows = [f"lat0 {HOME[0]}, lon0 {HOME[1]}", "posX,posY,posZ,halfSizeX,halfSizeY,halfSizeZ"]
    while len(rows) < 30:
        north, east, half = chance.uniform(-130, 130), chance.uniform(-130, 130), [chance.uniform(3, 9) for _ in range(2)]
        if all(max(abs(north - p[1]), abs(east - p[0])) > 25 for p in pads):
            height = chance.uniform(3, 12)
            rows.append(f"{north},{east},{height},{half[0]},{half[1]},{height}")
    (folder / "town.csv").write_text("\n".join(rows) + "\n")


def exported(seed, firmware, tools):
    """As made(), of a mission through a town, exported with rally points."""
    chance = random.Random(f"{firmware} export {seed}")
    around = lambda angle: (100 * math.sin(angle), 100 * math.cos(angle))
    turn = chance.uniform(0, 6.28)
    pads, goal = [around(turn), around(turn + chance.uniform(1.5, 2.5))], around(turn + chance.uniform(3.5, 5))
    start, end, height = (0, 0, chance.uniform(8, 20)), (goal[1], goal[0], chance.uniform(8, 30)), chance.choice((35, 45))
    with tempfile.TemporaryDirectory() as scratch:
        folder = pathlib.Path(scratch)
        made_town(chance, folder, [(0, 0), goal, *pads])

        def tool(name, *arguments):
            return subprocess.run([str(word) for word in (tools / name, *arguments)], cwd=scratch, check=True, capture_output=True, text=True)

        tool("skyway-import", "town.csv", "-q", "--bounds=-250,-250,0,250,250,120", "-o", "town.boxmap")
        place = lambda p: ",".join(str(c) for c in p)
        vehicle = pathlib.Path(__file__).resolve().parents[2] / "data/vehicles/quad2kg.json"
        tool("skyway-plan", "town.boxmap", f"--from={place(start)}", f"--to={place(end)}", "--vehicle", vehicle, "--margin", 1, "-o", "path.jsonl")
        rally = [f"--rally={pad[1]},{pad[0]},{chance.choice((10, 20))}" for pad in pads]
        kind = "px4:1.17" if firmware == "px4" else "ardupilot:4.7"
        said = tool("skyway-export", "town.boxmap", "path.jsonl", "--format", "qgc-plan", "--speed", 6, "--spare", 0.05, "--autopilot", kind,
                    "--return-height", height, *rally, "-o", "town.plan").stderr
        proved = re.search(r"its return is proved for ([\d.]+) %", said)
        print(f"export {seed}: its return is proved for {proved[1] if proved else 100} % of the time", flush=True)
        plan = json.loads((folder / "town.plan").read_text())
    way = math.dist(start, end)
    first = 8 + start[2] / 1.5
    params = {"RTL_RETURN_ALT": height} if firmware == "px4" else {"RTL_ALT": 100 * height}
    return plan, round(chance.uniform(first, first + way / 6), 1), "rtl", params, "quad2kg"


def fly(one, folder, firmware, options):
    name, (plan, seconds, action, params, airframe) = one
    mission, track, notes = (folder / f"{name}.{end}" for end in ("plan", "csv", "txt"))
    if not (track.exists() and notes.exists()):
        mission.write_text(json.dumps(plan))
        command = [sys.executable, FLY, mission, "-o", track, "--firmware", firmware, "--airframe", airframe,
                   "--return-at", f"{seconds},{action}", *options]
        for key, value in params.items():
            command += ["--set", f"{key}={value}"]
        done = subprocess.run(command, capture_output=True, text=True)
        notes.write_text(done.stderr + done.stdout)
    found = ORDERED.search(notes.read_text())
    if not found or not track.exists():
        return None, f"{name}: failed: {notes.read_text().strip()[-200:]}"
    drag = "" if firmware == "arducopter" else "1" if airframe == "stock" else "0.122"
    autopilot = "px4:1.17" if firmware == "px4" else "ardupilot:4.7"
    settings = " ".join(f"{key}={value}" for key, value in params.items())
    row = f"{track.name},{mission.name},{autopilot},{found[1]},{found[2]},{settings},{drag}"
    return row, f"{name}: {notes.read_text().strip().splitlines()[-1][-160:]}"


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0], epilog="Options after -- go to fly.py.")
    parser.add_argument("outdir", type=pathlib.Path)
    parser.add_argument("--firmware", choices=("px4", "arducopter"), default="px4")
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--count", type=int, default=10)
    parser.add_argument("--kind", choices=(*KINDS, "places"), help="of all missions (default: each but places in its turn)")
    parser.add_argument("--action", choices=("rtl", "land", "hold"), help="of all orders (default: mostly rtl)")
    parser.add_argument("--usual", action="store_true", help="with the firmware's own parameters (default: at random)")
    parser.add_argument("--exports", type=pathlib.Path, metavar="TOOLS", help="fly exports of skyway-export --rally instead")
    parser.add_argument("-j", "--jobs", type=int, default=2, help="flights at once (2)")
    parser.add_argument("--judge", type=pathlib.Path, metavar="JUDGE_RETURNS", help="the program of that name, to run afterwards")
    at = sys.argv.index("--") if "--" in sys.argv else len(sys.argv)
    options, rest = parser.parse_args(sys.argv[1:at]), sys.argv[at + 1 :]
    options.outdir.mkdir(parents=True, exist_ok=True)
    flights = []
    for number in range(options.count):
        kind = options.kind or KINDS[number % len(KINDS)]
        seed = 1000 * options.seed + number
        kind = "export" if options.exports else kind
        plan, seconds, action, params, airframe = (
            exported(seed, options.firmware, options.exports.resolve()) if options.exports else made(seed, kind, options.firmware))
        name = f"{options.firmware[:3]}_{kind}_{seed}" + (f"_{options.action}" if options.action else "")
        flights.append((name, (plan, seconds, options.action or action, {} if options.usual else params, airframe)))
    table = options.outdir / "returns.csv"
    rows = []
    with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        for row, said in pool.map(lambda one: fly(one, options.outdir, options.firmware, rest), flights):
            print(said, flush=True)
            rows += [row] if row else []
    table.write_text("track,mission,autopilot,action,seconds,settings,drag\n" + "".join(f"{row}\n" for row in rows))
    if options.judge:
        return subprocess.run([options.judge, table]).returncode
    return 0


if __name__ == "__main__":
    sys.exit(main())
