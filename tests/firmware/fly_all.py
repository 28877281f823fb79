#!/usr/bin/env python3
"""Flies many missions with fly.py, two at once, and prints a table of how they ended.

fly_all.py OUTDIR MISSION... [-- options of fly.py]: a mission a/b.plan becomes OUTDIR/b.csv; what fly.py printed is
kept beside the track, OUTDIR/b.txt. A mission whose track exists already is not flown again.
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


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0], epilog="Options after -- go to fly.py.")
    parser.add_argument("outdir", type=pathlib.Path)
    parser.add_argument("missions", type=pathlib.Path, nargs="+", metavar="MISSION")
    parser.add_argument("-j", "--jobs", type=int, default=2, help="flights at once (2)")
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
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
