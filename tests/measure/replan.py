"""replan.py BIN_DIR MAP [MOVED [SEED]]: patching and replanning after MOVED random boxes (10) moved by up to 15 m.

Times a patched roadmap against a rebuilt one, which must be the same bytes, and 1,000 replanned paths
against planning them anew; one thread, whole processes. The vehicle is box:1,1,1.
"""

import json
import os
import random
import subprocess
import sys
import tempfile
import time

bin_dir, box_map = os.path.abspath(sys.argv[1]), os.path.abspath(sys.argv[2])
moved = int(sys.argv[3]) if len(sys.argv) > 3 else 10
draw = random.Random(int(sys.argv[4]) if len(sys.argv) > 4 else 1)


def tool(name, *arguments):
    started = time.perf_counter()
    done = subprocess.run([os.path.join(bin_dir, name), *arguments], capture_output=True, text=True)
    if done.returncode > 1:
        sys.exit(done.stderr)
    return done.stdout, time.perf_counter() - started


def move_boxes():
    info = json.loads(tool("skyway-info", "--json", box_map)[0])
    low, high = info["bounds_min_m"], info["bounds_max_m"]
    open("nothing.csv", "w").write("min_x_m,min_y_m,min_z_m,max_x_m,max_y_m,max_z_m,label\n0,0,0,1,1,1,\n")
    tool("skyway-import", "-q", "nothing.csv", "-o", "nothing.boxmap")
    boxes = [json.loads(line) for line in tool("skyway-map", "diff", box_map, "nothing.boxmap")[0].splitlines()]
    boxes = [b for b in boxes if b.get("change") == "removed" and
             all(low[k] + 15 < b["min"][k] and b["max"][k] < high[k] - 15 for k in (0, 1))]
    chosen = draw.sample(boxes, moved)
    with open("add.csv", "w") as out:
        print("min_x_m,min_y_m,min_z_m,max_x_m,max_y_m,max_z_m,label", file=out)
        for box in chosen:
            by = [draw.uniform(-15, 15), draw.uniform(-15, 15), 0]
            numbers = [box[end][k] + by[k] for end in ("min", "max") for k in range(3)]
            print(*map(repr, numbers), "", sep=",", file=out)
    ids = ",".join(str(box["id"]) for box in chosen)
    tool("skyway-map", "patch", box_map, "--add", "add.csv", "--remove", ids, "-o", "new.boxmap")
    with open("queries.jsonl", "w") as out:
        for i in range(1000):
            ends = [[draw.uniform(low[0], high[0]), draw.uniform(low[1], high[1]), draw.uniform(3, 40)] for _ in "ab"]
            print(json.dumps({"id": f"q{i}", "from": ends[0], "to": ends[1]}), file=out)


def compare_roadmaps(*options):
    one = ["--threads", "1"]
    tool("skyway-roadmap", box_map, *options, *one, "-o", "old")
    rebuilt = min(tool("skyway-roadmap", "new.boxmap", *options, *one, "-o", "rebuilt")[1] for _ in range(5))
    patch = ["--patch", "old", "--old-map", box_map]
    patched = min(tool("skyway-roadmap", "new.boxmap", *patch, *one, "-o", "patched")[1] for _ in range(5))
    same = open("rebuilt", "rb").read() == open("patched", "rb").read()
    print(f"roadmap: rebuilt {rebuilt * 1e3:.0f} ms, patched {patched * 1e3:.0f} ms, {'same' if same else 'OTHER'} bytes")


def lengths(file):
    return {r["id"]: r for r in map(json.loads, open(file)) if r["status"] == "found"}


with tempfile.TemporaryDirectory() as folder:
    os.chdir(folder)
    move_boxes()
    vehicle = ["--vehicle", "box:1,1,1"]
    compare_roadmaps(*vehicle)
    plan = ["--queries", "queries.jsonl", *vehicle, "--threads", "1"]
    tool("skyway-plan", box_map, *plan, "-o", "paths")
    _, replanning = tool("skyway-replan", "new.boxmap", "paths", "--threads", "1", "--stats", "stats", "-o", "replanned")
    _, planning = tool("skyway-plan", "new.boxmap", *plan, "-o", "anew")
    anew, replanned = lengths("anew"), lengths("replanned")
    ratios = [r["length"] / anew[i]["length"] for i, r in replanned.items() if r["mended"] and i in anew]
    print(json.dumps(json.load(open("stats"))))
    print(f"replanned in {replanning * 1e3:.0f} ms, planned anew in {planning * 1e3:.0f} ms")
    if ratios:
        print(f"mended over planned anew: mean {sum(ratios) / len(ratios):.4f}, longest {max(ratios):.4f}")
    kept = sum(b - a for r in replanned.values() if r["mended"] for a, b in r["kept"])
    legs = sum(len(r["points"]) - 1 for r in replanned.values() if r["mended"])
    print(f"of the legs of mended paths {kept} of {legs} are kept")
