"""moving_test.py BIN_DIR: what keeps flights clear of obstacles that move holds for the independent verifier, and not once
tampered with; whatever it still accepts of changed flights and obstacles is what the check accepts of them, too."""

import copy
import os
import random
import tempfile

from tool_runs import read, tool, write
from verify_moving import Refused, verify

random.seed(7)
EPOCH = "2026-05-04T06:30:00Z"


def flight(name, start, *points, seconds=8):
    """From point to point, at rest at each."""
    at = lambda a, b, axis: [a[axis]] * 4 + [b[axis]] * 4
    return {"type": "trajectory", "id": name, "status": "solved", "epoch": EPOCH, "start": start,
            "vehicle": {"name": "v", "half": [0.5, 0.5, 0.3]}, "margin": 0.1,
            "segments": [{"duration": seconds, "x": at(a, b, 0), "y": at(a, b, 1), "z": at(a, b, 2)}
                         for a, b in zip(points, points[1:])]}


def obstacle(name, start, end, middle, half, velocity, growth=(0, 0, 0)):
    return {"type": "moving", "id": name, "epoch": EPOCH, "from": start, "until": end,
            "min": [m - h for m, h in zip(middle, half)], "max": [m + h for m, h in zip(middle, half)],
            "velocity": list(velocity), "growth": list(growth)}


def somewhere(reach=90):
    return [random.uniform(-reach, reach), random.uniform(-reach, reach), random.uniform(20, 90)]


def flights(count):
    """Some here and there; one that crosses behind and before an obstacle, so that one face is not enough."""
    out = [flight(f"f{i}", random.uniform(0, 60), somewhere(), somewhere(), somewhere(), seconds=random.uniform(5, 15))
           for i in range(count)]
    return [flight("crossing", 10, [-60, 0, 15], [60, 0, 15], seconds=20)] + out


def obstacles(count):
    out = [obstacle(f"m{i}", start, start + random.uniform(1, 60), somewhere(), [random.uniform(0, 5) for _ in range(3)],
                    [random.uniform(-3, 3) for _ in range(3)], [random.choice([0, random.uniform(0, 0.3)]) for _ in range(3)])
           for i, start in enumerate(random.uniform(-20, 90) for _ in range(count))]
    # Along y through the way of "crossing" while that is elsewhere.
    return [obstacle("train", 0, 40, [30, -40, 15], [4, 4, 4], [0, 2.2, 0], [0.01, 0.01, 0.01])] + out


def those_clear(records, moving, *options):
    """Flights that touch none."""
    write("all.jsonl", records)
    write("m.jsonl", moving)
    tool("skyway-check", "m.boxmap", "all.jsonl", "--moving", "m.jsonl", *options, "-o", "r.jsonl", codes=(0, 1))
    hit = {line["id"] for line in read("r.jsonl") if line["type"] == "moving_conflict"}
    return [r for r in records if r["id"] not in hit]


def holds(records, moving, certificate):
    try:
        verify(write("v.jsonl", records), "m.boxmap", write("w.jsonl", moving), write("c.jsonl", certificate))
        return True
    except Refused:
        return False


def accepted(records, moving, *options):
    """By the tool itself, exactly."""
    write("v.jsonl", records)
    write("w.jsonl", moving)
    done = tool("skyway-check", "m.boxmap", "v.jsonl", "--moving", "w.jsonl", "--exact", "--no-clearance", *options, "-o", "r.jsonl", codes=(0, 1, 3))
    return done.returncode != 3 and [line["ok"] for line in read("r.jsonl") if line["type"] == "clear_of_moving"] == [True]


def mutants(records, moving, certificate):
    """Changes of which none may hold, with what they are."""
    claim = next(i for i, line in enumerate(certificate) if line["type"] == "clear_of_moving")
    proofs = [i for i, line in enumerate(certificate) if line["type"] == "clear_of" and line["stretches"]]
    cut = max(proofs, key=lambda i: max(len(s["pieces"]) for s in certificate[i]["stretches"]))
    k = max(range(len(certificate[cut]["stretches"])), key=lambda k: len(certificate[cut]["stretches"][k]["pieces"]))
    opposite = lambda side: {"+": "-", "-": "+"}[side[0]] + side[1]

    def changed(change):
        out = copy.deepcopy((records, moving, certificate))
        change(*out)
        return out

    def cover(lines):
        return lines[cut]["stretches"][k]

    assert len(cover(certificate)["pieces"]) > 1, "one face is enough everywhere"
    yield "no claim", changed(lambda r, m, c: c.pop(claim))
    yield "two claims", changed(lambda r, m, c: c.append(c[claim]))
    for i in range(len(certificate)):
        if i != claim:
            yield f"without line {i}", changed(lambda r, m, c: c.pop(i))
    yield "a proof twice", changed(lambda r, m, c: c.append(c[cut]))
    yield "two proofs swapped", changed(lambda r, m, c: [c[claim].update(obstacles=c[claim]["obstacles"][::-1])])
    yield "the proof of another obstacle", changed(lambda r, m, c: [c[i]["ids"].reverse() for i in proofs[:1]])
    yield "a stranger", changed(lambda r, m, c: c[cut]["ids"].__setitem__(1, "stranger"))
    yield "a piece less", changed(lambda r, m, c: [cover(c)[key].pop() for key in ("pieces", "sides")])
    yield "a side less", changed(lambda r, m, c: cover(c)["sides"].pop())
    yield "a side more", changed(lambda r, m, c: cover(c)["sides"].append("+x"))
    yield "a side turned round", changed(lambda r, m, c: cover(c)["sides"].__setitem__(0, opposite(cover(c)["sides"][0])))
    yield "a side by time", changed(lambda r, m, c: cover(c)["sides"].__setitem__(0, "+t"))
    yield "a side that is a number", changed(lambda r, m, c: cover(c)["sides"].__setitem__(0, 0))
    yield "all in one piece", changed(lambda r, m, c: cover(c).update(pieces=[0], sides=cover(c)["sides"][:1]))
    yield "a deeper piece", changed(lambda r, m, c: cover(c)["pieces"].__setitem__(0, 61))
    yield "a stretch less", changed(lambda r, m, c: c[cut]["stretches"].pop())
    yield "a stretch more", changed(lambda r, m, c: c[cut]["stretches"].append(c[cut]["stretches"][0]))
    yield "flights in another order", changed(lambda r, m, c: c[claim]["flights"].reverse())
    yield "a flight more", changed(lambda r, m, c: r.append(flight("more", 0, somewhere(), somewhere())))
    yield "an obstacle more", changed(lambda r, m, c: m.append(obstacle("more", 0, 1, [0, 0, 5000], [1, 1, 1], [0, 0, 0])))
    yield "an obstacle less", changed(lambda r, m, c: m.pop())
    yield "an obstacle twice", changed(lambda r, m, c: m.append(m[0]))
    yield "no obstacle", changed(lambda r, m, c: [m.clear(), c[claim].update(obstacles=[])])
    yield "another epoch", changed(lambda r, m, c: c[claim].__setitem__("epoch", "2026-05-04T07:30:00Z"))
    yield "another epoch of a flight", changed(lambda r, m, c: r[0].__setitem__("epoch", "2026-05-04T07:30:00Z"))
    yield "another epoch of an obstacle", changed(lambda r, m, c: m[0].__setitem__("epoch", "2026-05-04T07:30:00Z"))
    yield "no epoch of an obstacle", changed(lambda r, m, c: m[0].pop("epoch"))
    yield "another frame of an obstacle", changed(lambda r, m, c: m[0].__setitem__("frame", "neu"))
    yield "another map of an obstacle", changed(lambda r, m, c: m[0].__setitem__("map", "sha256:a"))
    yield "another map of a flight", changed(lambda r, m, c: r[0].__setitem__("map", "sha256:a"))
    yield "another map", changed(lambda r, m, c: c[claim].__setitem__("map", "sha256:a"))
    yield "neither pad nor gone", changed(lambda r, m, c: c[claim].__setitem__("parked", "hidden"))
    yield "a status", changed(lambda r, m, c: r[0].__setitem__("status", "infeasible"))
    yield "less room", changed(lambda r, m, c: c[claim]["rooms"][0].__setitem__(2, 0.39))
    yield "no rooms", changed(lambda r, m, c: c[claim].pop("rooms"))
    yield "much room", changed(lambda r, m, c: c[claim]["rooms"].__setitem__(0, [60, 60, 60]))
    yield "a key more", changed(lambda r, m, c: m[0].__setitem__("acceleration", [0, 0, 1]))
    for key, value in (("until", None), ("until", -99), ("growth", [0, 0, -0.1]), ("growth", [0, 0]), ("velocity", [0, 0, 2e4]),
                       ("velocity", [0, 0, "1"]), ("min", [99, 99, 99]), ("type", "trajectory"), ("from", 1e-12)):
        yield f"an obstacle of {key} {value}", changed(lambda r, m, c: m[0].__setitem__(key, value))
    where = next(s for s in records if s["id"] == "crossing")["segments"][0]
    inside = [where["x"][7], where["y"][7], where["z"][7]]
    yield "the obstacle where the flight ends", changed(lambda r, m, c: m[0].update(
        {"from": 29.5, "until": 40, "min": [v - 1 for v in inside], "max": [v + 1 for v in inside], "velocity": [0, 0, 0]}))
    yield "later", changed(lambda r, m, c: m[0].update({"from": 8, "until": 48}))
    yield "wide", changed(lambda r, m, c: m[0].update(growth=[0.01, 30, 0.01]))


def random_change(records, moving):
    """Some number of a flight or an obstacle made another: by little, or by much."""
    records, moving = copy.deepcopy((records, moving))
    by = random.choice([1e-9, 1e-3, 0.3, 3, 30]) * random.choice([-1, 1])
    one, what = random.choice(moving[:3]), random.choice(["from", "until", "both", "min", "max", "velocity", "growth", "start", "duration", "point"])
    if what in ("from", "until"):
        one[what] += by
    elif what == "both":
        one["from"] += by
        one["until"] += by
    elif what in ("min", "max", "velocity", "growth"):
        one[what][random.randrange(3)] += by
    elif what == "start":
        random.choice(records)["start"] += by
    elif what == "duration":
        random.choice(random.choice(records)["segments"])["duration"] += abs(by)
    else:
        random.choice(random.choice(records)["segments"])[random.choice("xyz")][random.randrange(1, 7)] += by
    return records, moving


def check(count, *options):
    moving = obstacles(count)
    records = those_clear(flights(count), moving, *options)
    assert any(r["id"] == "crossing" for r in records)
    write("t.jsonl", records)
    command = ["skyway-check", "m.boxmap", "t.jsonl", "--moving", "m.jsonl", "--no-clearance", *options]
    done = [tool(*command, "--threads", threads, "--certificate", f"c{threads}.jsonl", "-o", f"r{threads}.jsonl") for threads in ("1", "2", "7")]
    assert all(read(f"{name}1.jsonl") == read(f"{name}{n}.jsonl") for name in "rc" for n in (2, 7)), done
    certificate = [line for line in read("c1.jsonl") if line["type"] in ("clear_of", "clear_of_moving")]
    assert len(certificate) == len(records) * len(moving) + 1
    assert holds(records, moving, certificate), options
    lies = 0
    for what, mutant in mutants(records, moving, certificate):
        assert not holds(*mutant), (what, options)
        lies += 1
    still_true = 0
    for i in range(80):
        some = random_change(records, moving)
        if holds(*some, certificate):
            assert accepted(*some, *options), (i, options)
            still_true += 1
    return lies, still_true


with tempfile.TemporaryDirectory() as folder:
    os.chdir(folder)
    with open("e.csv", "w", encoding="utf-8") as file:
        file.write("min_x_m,min_y_m,min_z_m,max_x_m,max_y_m,max_z_m,label\n-99,-99,0,-98,-98,1,x\n")
    tool("skyway-import", "e.csv", "--format", "box-csv", "--bounds", "-100,-100,0,100,100,100", "-q", "-o", "m.boxmap")
    for lies, still_true in (check(3), check(3, "--parked", "gone"), check(3, "--margin", "0.25", "--together", "--separation", "5,5", "--parked", "gone")):
        print(f"the proofs held; {lies} changes were refused, and of 80 random ones {80 - still_true}; the check accepts the others")
