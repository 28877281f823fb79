"""timed_certificate_test.py BIN_DIR: certificates of flights past boxes that are there for a time, and lies about times."""

import copy
import json
import os
import random
import sys
import tempfile

from tools_and_claims import Tools, changed, objects, refused
from verify_certificate import BoxMap, F, Refused, Verifier, verify

tool = Tools(sys.argv[1])
EPOCH = "2026-05-04T06:30:00Z"
random.seed(5)


def square(x, y, side, properties):
    ring = [[x, y], [x + side, y], [x + side, y + side], [x, y + side], [x, y]]
    return {"type": "Feature", "properties": {"lower": 0, "upper": 30, **properties}, "geometry": {"type": "Polygon", "coordinates": [ring]}}


def flight(name, start, seconds, points):
    """Straight legs of so many seconds each, with a stop at both ends of each."""
    segments = []
    for a, b in zip(points, points[1:]):
        segments.append({"duration": seconds, **{axis: [a[i]] * 4 + [b[i]] * 4 for i, axis in enumerate("xyz")}})
    return {"type": "trajectory", "id": name, "status": "solved", "epoch": EPOCH, "start": start, "vehicle": {"name": "box:1,1,1", "half": [1, 1, 1]},
            "margin": 0, "limits": {}, "segments": segments}


with tempfile.TemporaryDirectory() as folder:
    os.chdir(folder)
    with open("b.csv", "w") as file:
        file.write("min_x_m,min_y_m,min_z_m,max_x_m,max_y_m,max_z_m,label\n0,0,-9,100,100,-5,\n")
    tool("skyway-import", "b.csv", "-q", "--bounds=-50,-50,-50,150,150,50", "-o", "m.boxmap")
    zones = [square(20 * (i % 5), 20 * (i // 5), 8, random.choice([{"from": 60 * i}, {"until": 60 * i}, {"from": 30 * i, "until": 30 * i + 90}, {}]))
             for i in range(25)]
    zones.append(square(200, 200, 8, {"from": 5}))
    with open("z.geojson", "w") as file:
        json.dump({"type": "FeatureCollection", "features": zones}, file)
    tool("skyway-map", "patch", "m.boxmap", "--keep-out", "z.geojson", "--keep-out-local", "--epoch", EPOCH, "-o", "t.boxmap")
    box_map = BoxMap("t.boxmap")
    # Always-there volumes as well: the map that only the timed ones were added to.
    with open("a.geojson", "w") as file:
        json.dump({"type": "FeatureCollection", "features": [z for z in zones if not {"from", "until"} & set(z["properties"])]}, file)
    tool("skyway-map", "patch", "m.boxmap", "--keep-out", "a.geojson", "--keep-out-local", "-o", "a.boxmap")
    without = BoxMap("a.boxmap")
    assert box_map.times and len({box_map.hash, without.hash, BoxMap("m.boxmap").hash}) == 3 and without.always_there == without.hash
    place = lambda: [random.uniform(0, 100), random.uniform(0, 100), random.uniform(5, 20)]
    records = [flight(f"f{i}", random.choice([random.uniform(-300, 1800), random.randrange(0, 1500, 30)]), random.uniform(5, 60),
                      [place() for _ in range(random.randint(2, 4))]) for i in range(300)]
    text = "".join(json.dumps(r) + "\n" for r in records)
    verified = planes = lies = standing = 0
    for options in ((), ("--together", "--separation", "3,3"), ("--together", "--separation", "3,3", "--parked", "gone")):
        reports = objects(tool("skyway-check", "t.boxmap", "--certificate", "c.jsonl", "--no-clearance", *options, text=text))
        with open("c.jsonl") as file:
            certificates = {c["id"]: c for c in map(json.loads, file) if c["type"] == "certificate"}
        by_id = {r["id"]: r for r in reports if r.get("type") == "report"}
        assert {i for i, r in by_id.items() if r["ok"]} == set(certificates) and len(certificates) > 10, len(certificates)
        for record in records:
            certificate = certificates.get(record["id"])
            if certificate is None:
                continue
            assert by_id[record["id"]]["timed_boxes"] == "by_time"
            assert ("parked" in certificate) == (len(options) == 3)
            verify(record, certificate, box_map)
            verify(changed(record, lambda r: r.update(map=without.hash)), certificate, box_map)
            assert refused(verify, record, changed(certificate, lambda c: c.update(map=without.hash)), box_map)
            verified += 1
            standing += "parked" in certificate
            assert refused(verify, changed(record, lambda r: r.update(start=r["start"] + 1)), certificate, box_map)
            assert refused(verify, changed(record, lambda r: r.pop("start")), certificate, box_map)
            assert refused(verify, changed(record, lambda r: r.update(epoch="2026-05-04T06:30:01Z")), certificate, box_map)
            assert refused(verify, record, changed(certificate, lambda c: c.pop("epoch")), box_map)
            by_time = [(i, k) for i, s in enumerate(certificate["segments"]) for k, p in enumerate(s.get("planes", [])) if p[2][1] == "t"]
            planes += len(by_time)
            for i, k in by_time:
                box = certificate["segments"][i]["planes"][k][1]
                plane = certificate["segments"][i]["planes"][k][2]
                assert refused(verify, record, changed(certificate, lambda c: c["segments"][i]["planes"].pop(k)), box_map)
                assert refused(verify, record, changed(certificate, lambda c: c["segments"][i]["planes"][k].__setitem__(2, "-t" if plane == "+t" else "+t")), box_map)
                assert refused(verify, record, changed(certificate, lambda c: c.pop("start")), box_map)
                longer = copy.copy(box_map)  # there until, or from, an instant of the flight
                longer.times = dict(box_map.times)
                begin = F(record["start"]) + sum(F(s["duration"]) for s in record["segments"][:i])
                end = begin + F(record["segments"][i]["duration"])
                from_, until = box_map.times[box]
                longer.times[box] = (begin, until) if plane == "+t" else (from_, end)
                assert refused(verify, record, certificate, longer)
                lies += 4
    assert planes > 20 and standing > 5, (planes, standing)

# It stands at its first point until 0 and at its last one from 10 on, all closed.
class OneBox:
    bounds = ([-9, -9, -9], [9, 9, 9])

    def __init__(self, place, times):
        self.boxes, self.times = [(*place, *place)], {0: times}


leg = [(F(10), [[F(c) for c in p] for p in ([0, 0, 0],) * 4 + ([5, 5, 5],) * 4], None)]
for place, times, free in (((0, 0, 0), (F(1, 2**60), None), True), ((0, 0, 0), (F(0), F(20)), False), ((0, 0, 0), (None, F(-1)), False),
                           ((5, 5, 5), (None, F(10) - F(1, 2**60)), True), ((5, 5, 5), (F(10), F(10)), False), ((5, 5, 5), (F(99), None), False),
                           ((2, 2, 2), (F(0), F(0)), True)):
    claim = {"half": [1, 1, 1], "margin": 0, "limits": {}, "start": F(0), "parked": "pad"}
    try:
        Verifier(OneBox(place, times), claim).standing(leg, F(10))
        assert free, (place, times)
    except Refused:
        assert not free, (place, times)
print(f"{verified} certificates hold, {planes} pieces by time alone; {lies} lies were refused")
