"""extremes_test.py BIN_DIR SOURCE_DIR: numbers of any size in records end in an answer or a refusal: no tool dies, hangs or
fills the memory, and every line of JSON that one writes is JSON."""

import copy
import json
import os
import resource
import subprocess
import sys
import tempfile

bin_dir, source_dir = sys.argv[1:3]
MEMORY = 3 << 30  # bytes of address space: Embree and its threads take a good part
SECONDS = 60


def bounded():
    if "--sanitized" not in sys.argv:  # a sanitizer maps terabytes for itself
        resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))


def tool(*arguments):
    try:
        done = subprocess.run([os.path.join(bin_dir, arguments[0]), *arguments[1:]], capture_output=True, text=True,
                              timeout=SECONDS, preexec_fn=bounded)
    except subprocess.TimeoutExpired:
        raise AssertionError(f"{arguments}: no answer after {SECONDS} s") from None
    assert 0 <= done.returncode <= 4, f"{arguments}: ended by {done.returncode}: {done.stderr[-300:]}"
    assert done.returncode < 3 or done.stderr.strip(), f"{arguments}: exit {done.returncode} without a word"
    return done


def no_constant(word):
    raise ValueError(f"{word} is no JSON")


def strict(text, what):
    for line in text.splitlines():
        try:
            json.loads(line, parse_constant=no_constant)
        except ValueError as error:
            raise AssertionError(f"{what}: {error}: {line[:300]}") from None


def changed(tree, path, value):
    out = copy.deepcopy(tree)
    place = out
    for key in path[:-1]:
        place = place.setdefault(key, {}) if isinstance(place, dict) else place[key]
    place[path[-1]] = value
    return out


def standing(duration, **keys):
    axes = {axis: [value] * 8 for axis, value in (("x", 40.0), ("y", 30.0), ("z", 50.0))}
    return {"type": "trajectory", "id": "standing", "status": "solved", "vehicle": {"name": "b", "half": [0.5, 0.5, 0.5]},
            "segments": [{"duration": duration, **axes}], **keys}


def moving(duration):
    out = standing(duration)
    out["segments"][0]["x"] = [30.0, 30.0, 30.0, 30.0, 50.0, 50.0, 50.0, 50.0]
    return out


SIZES = [5e-324, 1e-310, 1e-300, 1e-155, 1e-12, 1e-10, 1e-9, 1e-6, 1e8, 9.9e8, 1e9, 1e10, 1e15, 1e77, 1e154, 1e155, 1e300, 1.7e308]
LIMITS = ["vmax", "vmax_h", "vmax_v", "amax", "jmax", "tilt", "thrust", "body_rate", "yaw_rate"]


def records():
    """(what, record, whether the tools that draw it shall have it too)"""
    for size in SIZES:
        yield f"lasts {size}", standing(size), True
        yield f"moves for {size}", moving(size), True
        yield f"margin {size}", standing(1.0, margin=size), True
        yield f"half {size}", changed(standing(1.0), ("vehicle", "half"), [0.5, size, 0.5]), True
        for k in (0, 3, 7):
            yield f"x[{k}] {size}", changed(standing(1.0), ("segments", 0, "x", k), size), k == 3
        yield f"yaw {size}", changed(standing(1.0), ("segments", 0, "yaw"), [0.0] * 4 + [size] * 4), True
        for limit in LIMITS:
            yield f"{limit} {size}", changed(moving(20.0), ("limits", limit), size), False
    for tilt in (1.5707963267948966, 1.6, 3.2):
        yield f"tilt {tilt}", changed(moving(20.0), ("limits", "tilt"), tilt), False
    falling = standing(2.0)
    falling["segments"][0]["z"] = [50 - 9.80665 / 2 * 4 * k * (k - 1) / 42 for k in range(8)]
    for limit in LIMITS:
        yield f"falls freely, {limit}", changed(falling, ("limits", limit), 12.0 if limit == "thrust" else 1.0), False
    for size in SIZES:
        yield f"a path with {size}", {"type": "path", "id": "p", "status": "found", "vehicle": {"half": [0.5, 0.5, 0.5]},
                                      "points": [[40, 30, 50], [40, 30, size]]}, False


with tempfile.TemporaryDirectory() as folder:
    def file(name):
        return os.path.join(folder, name)

    box_map = file("m.boxmap")
    tool("skyway-import", "-q", os.path.join(source_dir, "tests/golden/data/village.csv"), "--bounds", "0,0,0,80,60,60",
         "-o", box_map)
    count = 0
    said = 0
    accepted = 0
    for what, record, drawn in records():
        with open(file("r.jsonl"), "w") as out:
            out.write(json.dumps(record) + "\n")
        done = tool("skyway-check", box_map, file("r.jsonl"), "--certificate", file("c.jsonl"), "--stats", file("s.json"))
        strict(done.stdout, f"{what}: report")
        said += len(done.stdout.splitlines())
        accepted += done.returncode == 0
        profile = tool("skyway-check", box_map, file("r.jsonl"), "--profile", file("p.csv"), "-o", file("o.jsonl"))
        strict(open(file("o.jsonl")).read() if profile.returncode < 2 else "", f"{what}: report")
        count += 2
        if not drawn:
            continue
        for arguments in (["skyway-map", "to-gltf", box_map, file("r.jsonl"), "-o", file("m.glb")],
                          ["skyway-map", "to-ply", box_map, file("r.jsonl"), "-o", file("m.ply")],
                          ["skyway-plot", "plan", box_map, file("r.jsonl"), "-o", file("m.svg")],
                          ["skyway-plot", "profile", file("r.jsonl"), "-o", file("m.svg")],
                          ["skyway-plot", "clearance", box_map, file("r.jsonl"), "-o", file("m.svg")],
                          ["skyway-view", box_map, file("r.jsonl"), "-o", file("m.html")],
                          ["skyway-render", box_map, file("r.jsonl"), "--view", "plan", "--image-size", "64x48", "-o", file("m.png")],
                          ["skyway-info", "--json", file("r.jsonl")],
                          ["skyway-export", box_map, file("r.jsonl"), "--format", "setpoints", "-o", file("e.csv")],
                          ["skyway-export", box_map, file("r.jsonl"), "--format", "crazyflie", "-o", file("e.csv")],
                          ["skyway-export", box_map, file("r.jsonl"), "--format", "gltf", "-o", file("e.glb")],
                          ["skyway-fly", file("r.jsonl"), "--vehicle", os.path.join(source_dir, "data/vehicles/quad2kg.json"),
                           "--report-file", file("f.jsonl"), "-o", file("f.csv")]):
            done = tool(*arguments)
            count += 1
            if arguments[0] == "skyway-fly" and done.returncode < 2:
                strict(open(file("f.jsonl")).read(), f"{what}: flight report")
            if "--json" in arguments and done.returncode == 0:
                strict(done.stdout, f"{what}: {arguments[0]}")
assert accepted > 20 and said > 100
print(f"{count} runs, {said} reports, {accepted} accepted")
