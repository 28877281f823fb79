"""fences.py BIN_DIR COLLIDERS.csv QUERIES.csv [COUNT [FIRST]] [-- EXPORT OPTIONS]: fences compiled for missions over a city.

Paths of the public queries (street-local 0 to 99, street-global 0 to 59, each counted from FIRST; quad2kg, margin 0.6, --spare 0.05) become plans
(--speed 8), the first COUNT (100) that are exported without a fence. Each is exported again with --fence auto. A table says how
many have fences within the budget, how many corners these have, how many keep out of every obstacle as high as the returns, how many
hold every return that is proved without them, what the others lose at most (points of the share of the time), and from how much of
the time a return is proved. Without options: PX4 at 60, 90 and 120 m, ArduPilot at 60 m."""

import json
import pathlib
import re
import statistics
import subprocess
import sys
import tempfile
import time

words = sys.argv[1:]
asked = words[words.index("--") + 1:] if "--" in words else None
words = words[:words.index("--")] if "--" in words else words
bin_dir, colliders, queries = (pathlib.Path(word).resolve() for word in words[:3])
count = int(words[3]) if len(words) > 3 else 100
first = int(words[4]) if len(words) > 4 else 0
KINDS = [asked] if asked else [["--autopilot", "px4", "--return-height", str(height)] for height in (60, 90, 120)] + [
    ["--autopilot", "ardupilot", "--return-height", "60"]]


def run(*command, check=False):
    return subprocess.run([str(word) for word in command], capture_output=True, text=True, check=check)


def share(said):
    """The per cent of the time from which a return is proved."""
    told = re.search(r"is proved for (\S+) %", said)
    return float(told[1]) if told else 100


def export(path, *options):
    return run(bin_dir / "skyway-export", boxmap, path, "--format", "qgc-plan", "--speed", "8", "--spare", "0.05", "-o", plan_file, *options)


with tempfile.TemporaryDirectory() as folder:
    work = pathlib.Path(folder)
    boxmap, plan_file = work / "city.boxmap", work / "x.plan"
    # The ceiling leaves room for returns over the highest roof.
    run(bin_dir / "skyway-import", colliders, "-o", boxmap, "--ceiling", "400", check=True)
    most = {"street-local": 100, "street-global": 60}
    rows = [line for line in queries.read_text().splitlines()[1:] if first <= int(line.split(",")[1]) < first + most.get(line.split(",")[0], 0)]
    header = queries.read_text().splitlines()[0]
    (work / "q.csv").write_text("\n".join([header, *rows]) + "\n")
    vehicle = ["--vehicle", pathlib.Path(__file__).resolve().parents[2] / "data/vehicles/quad2kg.json", "--margin", "0.65"]
    paths = run(bin_dir / "skyway-plan", boxmap, "--queries", work / "q.csv", *vehicle).stdout.splitlines()
    missions = []
    for line in paths:
        if len(missions) == count or json.loads(line)["status"] != "found":
            continue
        path = work / f"{len(missions)}.jsonl"
        path.write_text(line + "\n")
        if export(path, *KINDS[0]).returncode == 0:
            missions.append(path)
    print(f"{len(missions)} missions of {len(paths)} paths")
    print("export                                    fences  corners: median  most  all boxes out  returns held: all  loss  proved: all  mean    seconds: mean  most")
    for kind in KINDS:
        corners, seconds, shares, losses, closed, refused = [], [], [], [], 0, {}
        for path in missions:
            begun = time.perf_counter()
            done = export(path, "--fence", "auto", *kind)
            seconds.append(time.perf_counter() - begun)
            if done.returncode != 0:
                why = re.search(r"obstacles: (.*?)(: give|$)", done.stderr) or re.search("refused: (.*)", done.stderr)
                refused[path.stem] = why[1] if why else done.stderr
                continue
            plan = json.loads(plan_file.read_text())
            corners.append(sum(len(p["polygon"]) for p in plan["geoFence"]["polygons"]))
            closed += "do not keep out of" not in done.stderr
            shares.append(share(done.stderr))
            losses.append(share(export(path, *kind).stderr) - shares[-1])
        print(f"{' '.join(kind):40} {len(corners):7} {statistics.median(corners or [0]):16} {max(corners, default=0):5} {closed:14} "
              f"{sum(loss <= 0 for loss in losses):18} {max(losses, default=0):5.2f} {sum(one == 100 for one in shares):12} {statistics.mean(shares or [0]):5.1f} % {statistics.mean(seconds):14.2f} {max(seconds):5.2f}")
        for name, why in refused.items():
            print(f"    {name}: {why.strip()[:150]}")
