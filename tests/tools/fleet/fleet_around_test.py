"""fleet_around_test.py BIN_DIR: small fleets among flights of others and obstacles that move. What skyway-fleet lets depart
keeps apart from all of them at many instants, in exact fractions, and is proved by skyway-check and by its independent
verifier; others that meet each other are named; no share of the work, and no number of threads, changes a byte."""

import os
import random
import sys
import tempfile
from fractions import Fraction as F
from math import comb

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "check"))
from tool_runs import read, tool, write
from verify_together import verify

ACROSS, UP, HALF = 6, 3, 0.5
INSTANTS = [F(k, 4) for k in range(-80, 800)]


def somewhere(chance):
    return [chance.uniform(-30, 30), chance.uniform(-30, 30), chance.uniform(20, 30)]


def flight(chance, name, **more):
    """From point to point, at rest at each."""
    points = [somewhere(chance) for _ in range(chance.randint(2, 3))]
    return {"type": "trajectory", "id": name, "status": "solved", **more, "vehicle": {"name": "v", "half": [HALF] * 3}, "margin": 0,
            "segments": [{"duration": chance.uniform(5, 15), **{axis: [a[k]] * 4 + [b[k]] * 4 for k, axis in enumerate("xyz")}}
                         for a, b in zip(points, points[1:])]}


def obstacle(chance, name):
    low = somewhere(chance)
    from_ = chance.uniform(-10, 60)
    return {"type": "moving", "id": name, "from": from_, "until": from_ + chance.uniform(1, 60), "min": low,
            "max": [c + chance.uniform(0, 8) for c in low], "velocity": [chance.uniform(-3, 3) for _ in range(3)],
            "growth": [chance.choice([0, chance.uniform(0, 0.5)]) for _ in range(3)]}


def places(record, parked):
    """Where it is at each of the instants, exactly; None where it is not there."""
    out, begin = [], F(record["start"])
    for t in INSTANTS:
        t -= begin
        where = None
        for i, segment in enumerate(record["segments"]):
            length = F(segment["duration"])
            first, last = i == 0, i + 1 == len(record["segments"])
            if 0 <= t <= length or (parked and ((first and t < 0) or (last and t > length))):
                u = min(max(t / length, F(0)), F(1))
                where = [sum(comb(7, k) * u**k * (1 - u)**(7 - k) * F(segment[axis][k]) for k in range(8)) for axis in "xyz"]
                break
            t -= length
        out.append(where)
    return out


def meet(a, b):
    """Whether two flights are too near at an instant."""
    return any(p and q and (p[0] - q[0])**2 + (p[1] - q[1])**2 <= ACROSS**2 and abs(p[2] - q[2]) <= UP for p, q in zip(a, b))


def touch(a, box):
    """Whether a flight's box touches an obstacle at an instant."""
    for t, p in zip(INSTANTS, a):
        age = t - F(box["from"])
        if p is None or age < 0 or t > F(box["until"]):
            continue
        faces = ((F(box["min"][k]) + (F(box["velocity"][k]) - F(box["growth"][k])) * age - F(HALF),
                  F(box["max"][k]) + (F(box["velocity"][k]) + F(box["growth"][k])) * age + F(HALF)) for k in range(3))
        if all(low <= c <= high for c, (low, high) in zip(p, faces)):
            return True
    return False


def check_fleet(seed):
    """How many depart, wait and are refused."""
    chance = random.Random(seed)
    parked = chance.choice(["pad", "gone"])
    own = [flight(chance, f"f{i}", earliest=chance.uniform(0, 20)) for i in range(7)]
    others = [flight(chance, f"o{i}", start=chance.uniform(-5, 40)) for i in range(4)]
    boxes = [obstacle(chance, f"b{i}") for i in range(3)]
    write("own.jsonl", own), write("others.jsonl", others), write("boxes.jsonl", boxes)
    rule = ("--separation", f"{ACROSS},{UP}", "--parked", parked)
    command = ("own.jsonl", *rule, "--others", "others.jsonl", "--moving", "boxes.jsonl", "--improve", "3", "--max-delay", "60")
    tool("skyway-fleet", *command, "--threads", "1", "-o", "out.jsonl", "--report-file", "report.json", codes=(0, 1))
    tool("skyway-fleet", *command, "--threads", "7", "-o", "again.jsonl", codes=(0, 1))
    out, report = read("out.jsonl"), read("report.json")[0]
    assert out == read("again.jsonl") and [r["id"] for r in out] == [r["id"] for r in own]
    departing = [r for r in out if r["status"] == "solved"]
    assert report["others"] == len(others) and report["departing"] == len(departing) == len(own) - len(report["refused"])
    at = {r["id"]: places(r, parked == "pad") for r in departing + others}
    for i, a in enumerate(departing):
        assert not any(meet(at[a["id"]], at[b["id"]]) for b in departing[i + 1:] + others), (seed, a["id"])
        assert not any(touch(at[a["id"]], box) for box in boxes), (seed, a["id"])
    near = report.get("others_too_near", [])
    for i, a in enumerate(others):
        for b in others[i + 1:]:
            assert not meet(at[a["id"]], at[b["id"]]) or [a["id"], b["id"]] in near, (seed, a["id"], b["id"])
    assert report["ok"] == (not report["refused"])  # whatever others are among themselves
    tool("skyway-fleet", *command, "--drop-refused", "-o", "left.jsonl", "--report-file", "left.json", codes=(0,) if departing else (1,))
    left = read("left.json")[0]
    assert read("left.jsonl") == departing and left["ok"] == bool(departing), seed
    assert left["dropped"] == [r["id"] for r in out if r["status"] != "solved"], seed
    alone = {name for pair in near for name in pair[1:]}
    apart = write("apart.jsonl", departing + [r for r in others if r["id"] not in alone])
    tool("skyway-check", "m.boxmap", apart, "--no-clearance", "--together", *rule, "--certificate", "c.jsonl", "-o", "r.jsonl")
    verify(apart, write("pairs.jsonl", [line for line in read("c.jsonl") if line["type"] != "certificate"]))
    if departing:
        tool("skyway-check", "m.boxmap", write("departing.jsonl", departing), "--no-clearance", "--parked", parked, "--moving", "boxes.jsonl",
             "-o", "r.jsonl")
    waiting = sum(r["start"] > r["earliest"] for r in departing)
    named = [who for refused in report["refused"] for who in refused.get("others", []) + refused.get("moving", [])]
    return len(departing), waiting, len(report["refused"]), len(near), len(named)


with tempfile.TemporaryDirectory() as folder:
    os.chdir(folder)
    with open("e.csv", "w", encoding="utf-8") as file:
        file.write("min_x_m,min_y_m,min_z_m,max_x_m,max_y_m,max_z_m,label\n-99,-99,0,-98,-98,1,x\n")
    tool("skyway-import", "e.csv", "--format", "box-csv", "--bounds=-100,-100,0,100,100,100", "-q", "-o", "m.boxmap")
    departing, waiting, refused, near, named = (sum(counts) for counts in zip(*map(check_fleet, range(12))))
    assert departing > 20 and waiting > 10 and refused > 3 and near > 1 and named > 3, (departing, waiting, refused, near, named)
print(f"{departing} flights depart, {waiting} of them later than asked; {refused} are refused; {near} pairs of others meet")
