"""together_test.py BIN_DIR: what keeps flights apart holds for the independent verifier, and not once tampered with;
flights of many kinds give the same bytes for any number of threads."""

import contextlib
import copy
import io
import os
import random
import tempfile
from fractions import Fraction as F

from tool_runs import read, tool, write
from verify_together import Claim, Flight, Refused, Traffic, beyond, clearly_beyond, verify, verify_files

random.seed(5)


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


def require_sound_traffic(parked, far):
    """No two parts that exact boxes leave near each other are missing from what floats find."""
    records = many(12) + [flight(f"far {i}", 20, [far, far, 40 + 3 * i], [far + 30, far, 40 + 3 * i]) for i in range(2)]
    flights = [Flight(record) for record in records]
    line = {"parked": parked, "flights": [f.id for f in flights], "epoch": records[0]["epoch"], "separation": {"shape": "cylinder", "reach": [12, 12, 5]}}
    claim = Claim(line, flights, records)
    traffic, near = Traffic(flights, claim), 0
    pairs = traffic.pairs()
    for k, b in enumerate(flights):
        for i, a in enumerate(flights[:k]):
            parts = [[f.part(n, parked) for n in range(len(traffic.parts[j]))] for f, j in ((a, i), (b, k))]
            assert [len(p) for p in parts] == [len(f.lengths) + 2 * (parked == "pad") for f in (a, b)]
            reach = [r + a.gap + b.gap for r in claim.zone[1]]
            found = {(p, q) for p, one in enumerate(parts[0]) for q, other in enumerate(parts[1])
                     if not (one.is_over_before(other) or other.is_over_before(one) or one.away_from(other, reach, [float(r) for r in reach]))}
            assert not found or (i, k) in pairs, (a.id, b.id)
            assert found <= set(traffic.near(i, k)), (a.id, b.id)
            near += len(found)
    assert near > 2 and (far > 1e6 or len(pairs) < len(flights) * (len(flights) - 1) // 2), (near, len(pairs))


def require_clear_is_beyond():
    """What floats call clear is beyond in fractions; they see it of what is further than a tenth of a millimetre."""
    clear = 0
    for _ in range(3000):
        zone = random.choice(("cylinder", "box")), [F(random.uniform(1, 40))] * 2 + [F(random.uniform(1, 10))]
        side = random.choice(([random.randint(-2**31 + 1, 2**31 - 1), random.randint(1, 2**31 - 1), 0], [0, 0, 1], [-3, 0, 0], [5, -4, 0]))
        gap, size = F(random.choice((0, 1e-9, 0.5))), sum(n * n for n in side) ** 0.5
        level = zone[0] == "cylinder" and side[2] == 0
        edge = float(zone[1][0]) if level else sum(abs(n) * float(r) for n, r in zip(side, zone[1])) / size
        edge += float(gap) * sum(map(abs, side)) / size
        off, along = random.choice((1e-7, -1e-7, 3e-6, 1e-4, 0.0, -1e-4)), random.uniform(-1e5, 1e5)
        point = [n / size * (edge + off) + along * t for n, t in zip(side, (-side[1] / size, side[0] / size, 0))]
        exact, found = beyond(zone, gap, side, [F(c) for c in point]), clearly_beyond(zone, gap, side, [point])
        assert exact or not found, (zone, side, point)
        assert found or off < 1e-4
        clear += found
    assert clear > 500


def require_floats_near_fractions():
    for record in many(20):
        one = Flight(record)
        for _ in range(5):
            times = sorted(F(random.uniform(float(one.joints[0]), float(one.joints[1]))) for _ in range(2))
            for rough, exact in zip(one.roughly_over(*times), one.over(*times)):
                assert all(abs(F(a) - b) < 1e-9 for a, b in zip(rough, exact))


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


require_clear_is_beyond()
require_floats_near_fractions()
for parked in ("pad", "gone"):
    require_sound_traffic(parked, 500)
    require_sound_traffic(parked, 5e6)
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
