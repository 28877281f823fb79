"""together_test.py BIN_DIR: what keeps flights apart holds for the independent verifier, and not once tampered with;
flights of many kinds give the same bytes for any number of threads."""

import contextlib
import copy
import io
import json
import os
import random
import subprocess
import sys
import tempfile

from verify_together import Refused, verify, verify_files

bin_dir = sys.argv[1]
random.seed(5)


def tool(name, *arguments, codes=(0,)):
    done = subprocess.run([os.path.join(bin_dir, name), *arguments], capture_output=True, text=True)
    assert done.returncode in codes, (done.returncode, done.stderr)
    return done


def flight(name, start, *points, seconds=8, vehicle=(0.5, 0.5, 0.25)):
    """From point to point, at rest at each."""
    at = lambda a, b, axis: [a[axis]] * 4 + [b[axis]] * 4
    return {"type": "trajectory", "id": name, "status": "solved", "epoch": "2026-05-04T06:30:00Z", "start": start,
            "vehicle": {"name": "v", "half": list(vehicle)}, "margin": 0.25,
            "segments": [{"duration": seconds, "x": at(a, b, 0), "y": at(a, b, 1), "z": at(a, b, 2)}
                         for a, b in zip(points, points[1:])]}


def somewhere():
    return [random.uniform(-90, 90), random.uniform(-90, 90), random.uniform(20, 90)]


def many(count):
    """Some here and there, and two side by side, 12.02 m apart across their way: boxes alone do not keep these apart."""
    out = [flight(f"f{i}", random.uniform(0, 300), somewhere(), somewhere(), somewhere(), seconds=random.uniform(5, 15))
           for i in range(count)]
    beside = [flight(name, 20, [-80 + x, -80 - x, 97], [80 + x, 80 - x, 97]) for name, x in (("left", 0), ("right", 8.5))]
    return beside + out


def write(name, records):
    with open(name, "w", encoding="utf-8") as file:
        file.write("".join(json.dumps(r) + "\n" for r in records))
    return name


def read(name):
    with open(name, encoding="utf-8") as file:
        return [json.loads(line) for line in file]


def those_apart(records, *options):
    """Flights without those that conflict with one before."""
    write("all.jsonl", records)
    tool("skyway-check", "m.boxmap", "all.jsonl", "--together", *options, "-o", "r.jsonl", codes=(0, 1))
    out = set()
    for line in read("r.jsonl"):
        if line["type"] == "pair" and not set(line["ids"]) & out:
            out.add(line["ids"][1])
    return [r for r in records if r["id"] not in out]


def holds(records, certificate):
    try:
        verify(write("v.jsonl", records), write("w.jsonl", certificate))
        return True
    except Refused:
        return False


def mutants(records, certificate):
    """Changes of which none may hold, with what they are."""
    proofs = [i for i, line in enumerate(certificate) if line["type"] == "apart"]
    claim = next(i for i, line in enumerate(certificate) if line["type"] == "together")

    def changed(change):
        out = copy.deepcopy((records, certificate))
        change(*out)
        return out

    def cover(lines):
        """Of a pair, one that is cut."""
        covers = [c for i in proofs for s in lines[i]["stretches"] for c in s]
        return max(covers, key=lambda c: len(c["pieces"]))

    yield "no claim", changed(lambda r, c: c.pop(claim))
    yield "two claims", changed(lambda r, c: c.append(c[claim]))
    if type(certificate[claim]["separation"]) is dict and certificate[claim]["separation"]["shape"] == "cylinder":
        yield "no proofs", (records, [c for c in certificate if c["type"] != "apart"])
        yield "an oval zone", changed(lambda r, c: c[claim]["separation"]["reach"].__setitem__(1, 1e-3))
    yield "a piece less", changed(lambda r, c: [cover(c)[k].pop() for k in ("pieces", "sides")])
    yield "a side less", changed(lambda r, c: cover(c)["sides"].pop())
    yield "a side more", changed(lambda r, c: cover(c)["sides"].append([0, 0, 1]))
    yield "a side turned round", changed(lambda r, c: cover(c)["sides"].__setitem__(0, [-x for x in cover(c)["sides"][0]]))
    yield "no side", changed(lambda r, c: cover(c)["sides"].__setitem__(0, [0, 0, 0]))
    yield "a side that is true", changed(lambda r, c: cover(c)["sides"].__setitem__(0, [True, 0, 0]))
    yield "a side that leans", changed(lambda r, c: cover(c)["sides"].__setitem__(0, [1, 0, 1]))
    yield "a deeper piece", changed(lambda r, c: cover(c)["pieces"].__setitem__(0, 61))
    yield "a stretch less", changed(lambda r, c: c[proofs[0]]["stretches"].pop())
    yield "a stretch more", changed(lambda r, c: c[proofs[0]]["stretches"].append(c[proofs[0]]["stretches"][0]))
    yield "a zone less", changed(lambda r, c: c[proofs[0]]["stretches"][0].pop())
    yield "the pair the other way round", changed(lambda r, c: c[proofs[0]]["ids"].reverse())
    yield "the pair twice", changed(lambda r, c: c.append(c[proofs[0]]))
    yield "a stranger", changed(lambda r, c: c[proofs[0]]["ids"].__setitem__(1, "stranger"))
    yield "flights in another order", changed(lambda r, c: c[claim]["flights"].reverse())
    yield "a flight more", changed(lambda r, c: r.append(flight("more", 0, somewhere(), somewhere())))
    yield "a flight twice", changed(lambda r, c: r.append(r[0]))
    yield "another epoch", changed(lambda r, c: c[claim].__setitem__("epoch", "2026-05-04T07:30:00Z"))
    yield "another epoch of one", changed(lambda r, c: r[0].__setitem__("epoch", "2026-05-04T07:30:00Z"))
    yield "another map of one", changed(lambda r, c: [r[i].__setitem__("map", m) for i, m in ((0, "sha256:a"), (1, "sha256:b"))])
    yield "another frame of one", changed(lambda r, c: [r[i].__setitem__("frame", f) for i, f in ((0, "enu"), (1, "neu"))])
    yield "neither pad nor gone", changed(lambda r, c: c[claim].__setitem__("parked", "hidden"))
    yield "a status", changed(lambda r, c: r[0].__setitem__("status", "infeasible"))
    first = certificate[proofs[0]]["ids"]
    other = next(r for r in records if r["id"] == first[1])
    met = {"segments": next(r for r in records if r["id"] == first[0])["segments"], "start": next(r for r in records if r["id"] == first[0])["start"]}
    yield "the one where the other is", changed(lambda r, c: next(x for x in r if x["id"] == other["id"]).update(met))
    if "rooms" in certificate[claim]:
        yield "less room", changed(lambda r, c: c[claim]["rooms"][0].__setitem__(2, 0.25))
        yield "no size", changed(lambda r, c: [r[0].pop("vehicle"), c[claim]["rooms"].__setitem__(0, [0, 0, 0])])
        yield "no rooms", changed(lambda r, c: c[claim].pop("rooms"))
    else:
        yield "a wider zone", changed(lambda r, c: c[claim]["separation"].__setitem__("reach", [90, 90, 90]))
        yield "no number", changed(lambda r, c: c[claim]["separation"]["reach"].__setitem__(2, None))


def check(records, *options):
    records = those_apart(records, *options)
    write("t.jsonl", records)
    command = ["skyway-check", "m.boxmap", "t.jsonl", "--together", *options]
    done = [tool(*command, "--threads", threads, "--certificate", f"c{threads}.jsonl").stdout for threads in ("1", "2", "7")]
    assert done[0] == done[1] == done[2] and read("c1.jsonl") == read("c2.jsonl") == read("c7.jsonl")
    certificate = [line for line in read("c1.jsonl") if line["type"] != "certificate"]
    assert holds(records, certificate), options
    assert any(line["type"] == "apart" for line in certificate), options
    assert holds([r | {"epoch": r["epoch"].replace("Z", ".000+00:00")} for r in records], certificate), options
    for what, (some, lines) in mutants(records, certificate):
        assert not holds(some, lines), (what, options)


with tempfile.TemporaryDirectory() as folder:
    os.chdir(folder)
    with open("e.csv", "w", encoding="utf-8") as file:
        file.write("min_x_m,min_y_m,min_z_m,max_x_m,max_y_m,max_z_m,label\n-99,-99,0,-98,-98,1,x\n")
    tool("skyway-import", "e.csv", "--format", "box-csv", "--bounds", "-100,-100,0,100,100,100", "-q", "-o", "m.boxmap")
    check(many(25))
    check(many(25), "--parked", "gone", "--separation", "12,5")
    check(many(20), "--parked", "gone", "--separation-box", "9,9,4", "--downwash", "2,25")
    # What is said to hold is what was looked at: pairs, and no map.
    for parked, said in (("pad", "each on its pad before and after, for the others"), ("gone", "each gone before and after")):
        tool("skyway-check", "m.boxmap", write("one.jsonl", [flight("one", 0, [0, 0, 30], [9, 0, 30])]), "--together", "--parked", parked,
             "--certificate", "one.certificate")
        certificates = read("one.certificate")
        assert not any("parked" in line for line in certificates if line["type"] == "certificate")
        with contextlib.redirect_stdout(io.StringIO()) as out:
            assert verify_files("one.jsonl", "one.certificate") == 0
        assert "vehicles of the rooms {'one': [" in out.getvalue(), out.getvalue()
        assert said in out.getvalue() and "nothing is said of a map" in out.getvalue(), out.getvalue()
print("every proof held, and none of its changes")
