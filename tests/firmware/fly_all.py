#!/usr/bin/env python3
"""Flies many missions with fly.py, two at once, and prints a table of how they ended.

fly_all.py OUTDIR MISSION... [-- options of fly.py]: a mission a/b.plan becomes OUTDIR/b.csv; what fly.py printed is
kept beside the track, OUTDIR/b.txt. A mission whose track exists already is not flown again. OUTDIR/flights.csv lists
the tracks for judge_flights, and with --judge that is run at once.
"""

import argparse
import concurrent.futures
import pathlib
import re
import subprocess
import sys

FLY = pathlib.Path(__file__).resolve().parent / "fly.py"
ENDED = re.compile(r": (\w+) after ([\d.]+) s, .*?([\d.]+) times real time")


def report(text):
    """(seconds, ended how, times real time) out of what fly.py printed."""
    for line in reversed(text.splitlines()):
        found = ENDED.search(line)
        if found:
            return found[2], found[1], found[3]
    last = text.strip().splitlines()
    return "", f"failed: {last[-1].removeprefix('fly.py: ') if last else 'no reason given'}", ""


def fly(mission, folder, options):
    track, notes = folder / f"{mission.stem}.csv", folder / f"{mission.stem}.txt"
    if track.exists() and notes.exists():
        return report(notes.read_text())
    done = subprocess.run([sys.executable, FLY, mission, "-o", track, *options], capture_output=True, text=True)
    notes.write_text(done.stderr + done.stdout)
    return report(notes.read_text())


def value_set(rest, name):
    """The value that --set gives a parameter; empty without."""
    values = [text.split("=", 1)[1] for text in rest if text.startswith(name + "=")]
    return values[-1] if values else ""


def drag(options, rest):
    """Over the mass, 1/s, as --drag says or as fly.py flies; empty: the simulator's own vehicle of ArduCopter."""
    if options.drag or "arducopter" in rest:
        return options.drag
    return value_set(rest, "SIH_KDV") or "1" if "stock" in rest else "0.122"


def table(options, rest):
    """Writes the tracks that there are, with what judge_flights must know of each."""
    autopilot = options.autopilot or ("ardupilot" if "arducopter" in rest else "px4")
    across, vertical = options.navigation.split(",")
    path = options.outdir / "flights.csv"
    with open(path, "w") as out:
        out.write("track,mission,autopilot,acceptance,return_height,navigation_across,navigation_vertical,drag,ground,terrain_error,settings\n")
        for mission in options.missions:
            if not (options.outdir / f"{mission.stem}.csv").exists():
                continue
            fields = [f"{mission.stem}.csv", str(mission.resolve()), autopilot, value_set(rest, "NAV_ACC_RAD"),
                      options.return_height or value_set(rest, "RTL_RETURN_ALT"), across, vertical, drag(options, rest), "", "", ""]
            out.write(",".join(fields) + "\n")
    return path


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0], epilog="Options after -- go to fly.py.")
    parser.add_argument("outdir", type=pathlib.Path)
    parser.add_argument("missions", type=pathlib.Path, nargs="+", metavar="MISSION")
    parser.add_argument("-j", "--jobs", type=int, default=2, help="flights at once (2)")
    parser.add_argument("--judge", type=pathlib.Path, metavar="JUDGE_FLIGHTS", help="the program of that name, to run afterwards")
    parser.add_argument("--autopilot", help="whose claim the tracks are held against, as skyway-check takes it (the firmware's)")
    parser.add_argument("--return-height", default="", help="metres above home (PX4's: as --set RTL_RETURN_ALT says)")
    parser.add_argument("--drag", default="", help="the airframe's drag over its mass, 1/s (what fly.py gives PX4's vehicle)")
    parser.add_argument("--navigation", default="0,0", help="metres across, and up or down, as skyway-check takes them (0,0)")
    at = sys.argv.index("--") if "--" in sys.argv else len(sys.argv)
    options, rest = parser.parse_args(sys.argv[1:at]), sys.argv[at + 1 :]
    stems = [mission.stem for mission in options.missions]
    twice = {stem for stem in stems if stems.count(stem) > 1}
    if twice:
        parser.error(f"two missions have the name {', '.join(sorted(twice))}; their tracks would be one file")
    options.outdir.mkdir(parents=True, exist_ok=True)
    failed = 0
    print("| mission | seconds | ended | times real time |\n|---|---|---|---|", flush=True)
    with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        for mission, (seconds, ended, rate) in zip(
            options.missions, pool.map(lambda m: fly(m, options.outdir, rest), options.missions)):
            print(f"| {mission.name} | {seconds} | {ended} | {rate} |", flush=True)
            failed += ended.startswith("failed")
    flights = table(options, rest)
    if options.judge:
        return subprocess.run([options.judge, flights]).returncode or (1 if failed else 0)
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
