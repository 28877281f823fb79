"""returns.py BIN_DIR MAP TRAJECTORIES… [-- CHECK OPTIONS]: the autopilot's own return from every instant of many flights, at
several heights.

The records may be of another map over the same place (such as one with a lower ceiling): what they say of their map is left out.
For 60, 90 and 120 m, and with the least heights: the share of the flights' time from which a return is proved, flights without a
gap, what gaps are for, and seconds of the CPU. Options go to skyway-check (default: --autopilot px4:1.17).
"""

import collections
import json
import pathlib
import re
import resource
import statistics
import subprocess
import sys
import tempfile

words = sys.argv[1:]
options = words[words.index("--") + 1:] if "--" in words else ["--autopilot", "px4:1.17"]
words = words[:words.index("--")] if "--" in words else words
bin_dir, city, *files = map(pathlib.Path, words)


def checked(flights, *more):
    """Reports of all flights, and seconds of the CPU."""
    before, reports = resource.getrusage(resource.RUSAGE_CHILDREN), []
    for path in flights:
        command = [bin_dir / "skyway-check", city, path, "--return", "--no-clearance", "-q", *more, *options]
        run = subprocess.run([str(word) for word in command], stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True)
        reports += [json.loads(line)["return"] for line in run.stdout.splitlines() if '"return":' in line]
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return reports, after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


with tempfile.TemporaryDirectory() as folder:
    flights = []
    for path in files:
        flights.append(pathlib.Path(folder) / path.name)
        with open(path) as lines, open(flights[-1], "w") as out:
            out.writelines(re.sub(r'"map":"[^"]*",', "", line) for line in lines)
    for height in (60, 90, 120):
        reports, seconds = checked(flights, "--return-height", str(height), "--no-least-height")
        whole = sum(one["duration"] for one in reports)
        lost = collections.Counter()
        for gap in (gap for one in reports for gap in one["gaps"]):
            lost[f"{gap['phase']} ({gap['reason']})"] += gap["until"] - gap["from"]
        proved = sum(one["share"] * one["duration"] for one in reports) / whole
        print(f"{height} m: {len(reports)} flights, {100 * proved:.2f} % of the time, {sum(not one['gaps'] for one in reports)} without a gap, "
              f"{seconds:.0f} s of CPU; without a return: {', '.join(f'{what} {100 * time / whole:.2f} %' for what, time in lost.most_common())}")
    reports, seconds = checked(flights, "--return-height", "60")
    best = sorted(one.get("least_height", one.get("best_height", 0)) for one in reports)
    share = statistics.mean(one.get("best_share", 1) for one in reports)
    print(f"least heights from which more gains nothing: median {best[len(best) // 2]:.1f}, p90 {best[int(0.9 * len(best))]:.1f}, most {best[-1]:.1f} m; "
          f"there {100 * share:.2f} % of the time in the mean, {sum('least_height' in one for one in reports)} flights without a gap; {seconds:.0f} s of CPU")
