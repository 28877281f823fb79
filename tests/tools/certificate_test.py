"""certificate_test.py BIN_DIR CITY.csv: certificates hold for the independent verifier, and none does once tampered with."""

import copy
import json
import os
import subprocess
import sys
import tempfile

from verify_certificate import F, Refused, verify

bin_dir, city = sys.argv[1:3]
QUERIES = ["5,30,5,70,10,5", "10,5,3,60,50,8", "70,50,4,5,6,5", "40,3,6,35,55,5"]


def tool(*arguments, text=None):
    done = subprocess.run([os.path.join(bin_dir, arguments[0]), *arguments[1:]], input=text,
                          capture_output=True, text=True)
    assert done.returncode in (0, 1), done.stderr
    return done.stdout


def objects(text):
    return [json.loads(line) for line in text.splitlines()]


def dump(records):
    return "".join(json.dumps(r) + "\n" for r in records)


def shifted(record):
    """The same with the second segment a third of a nanometre off: there is a step to be clear of."""
    out = copy.deepcopy(record)
    out["segments"][1]["x"] = [x + 2**-31 if abs(x) < 2**20 else x for x in out["segments"][1]["x"]]
    return out


def holds(record, certificate, boxes, bounds):
    try:
        verify(record, certificate, boxes, bounds)
        return True
    except (Refused, LookupError, TypeError, ValueError):
        return False


def tampered(record, certificate, boxes, bounds):
    """(what, record, certificate, boxes, bounds) of each way to lie that applies."""
    def changed(of, change):
        out = copy.deepcopy(of)
        change(out)
        return out

    segments = certificate["segments"]
    for i, proof in enumerate(segments):
        for key in ("clear", "bounds", "speed", "acceleration", "jerk", "tilt", "horizontal_speed", "vertical_speed",
                    "thrust", "body_rate", "yaw_rate"):
            if key in proof:
                yield (f"a piece of {key} missing", record,
                       changed(certificate, lambda c: c["segments"][i][key].pop()), boxes, bounds)
                yield (f"a piece of {key} too many", record,
                       changed(certificate, lambda c: c["segments"][i][key].append(3)), boxes, bounds)
        if len(proof["clear"]) > 1:
            yield ("pieces joined", record,
                   changed(certificate, lambda c: c["segments"][i].update(clear=[0])), boxes, bounds)
        for k, (_, _, plane) in enumerate(proof.get("planes", [])):
            other = ("-" if plane[0] == "+" else "+") + plane[1]
            yield ("a plane flipped", record,
                   changed(certificate, lambda c: c["segments"][i]["planes"][k].__setitem__(2, other)), boxes, bounds)
            yield ("a plane missing", record,
                   changed(certificate, lambda c: c["segments"][i]["planes"].pop(k)), boxes, bounds)
        if "gap" in proof:
            yield "a gap left out", record, changed(certificate, lambda c: c["segments"][i].pop("gap")), boxes, bounds
    yield "a segment missing", record, changed(certificate, lambda c: c["segments"].pop()), boxes, bounds

    if "points" in record:
        middle = [F(a + b) / 2 for a, b in zip(*record["points"][:2])]
    else:
        middle = [F(record["segments"][0][axis][-1]) for axis in "xyz"]
    yield "a box in the way", record, certificate, boxes + [(middle, middle)], bounds
    half = [F(h) + F(record["margin"]) for h in record["vehicle"]["half"]]
    beside = [m + h if a == 0 else m for a, (m, h) in enumerate(zip(middle, half))]
    moved = [(beside, [b + 1 for b in beside])] + boxes[1:]
    yield "a box moved to touch", record, certificate, moved, bounds
    yield "bounds drawn closer", record, certificate, boxes, (bounds[0], [m + h - F(1, 10**9) for m, h in zip(middle, half)])
    if "segments" in record:
        yield "a limit lowered", changed(record, lambda r: r["limits"].update(vmax=0.5)), certificate, boxes, bounds
        yield ("a jump", changed(record, lambda r: r["segments"][-1].update(duration=r["segments"][-1]["duration"] * 0.9)),
               certificate, boxes, bounds)
        yield ("a curve bent", changed(record, lambda r: r["segments"][0]["z"].__setitem__(4, 1e4)),
               certificate, boxes, bounds)


with tempfile.TemporaryDirectory() as folder:
    box_map, certificates = os.path.join(folder, "m.boxmap"), os.path.join(folder, "c.jsonl")
    tool("skyway-import", "-q", city, "--bounds", "0,0,0,80,60,60", "-o", box_map)
    boxes = [([F(float(c)) for c in row[:3]], [F(float(c)) for c in row[3:6]])
             for row in (line.split(",") for line in tool("skyway-map", "to-csv", box_map).splitlines()[1:])]
    bounds = ([F(0), F(0), F(0)], [F(80), F(60), F(60)])
    queries = "".join(json.dumps({"id": f"q{i}", "from": n[:3], "to": n[3:]}) + "\n" for i, n in
                      enumerate([[float(c) for c in q.split(",")] for q in QUERIES]))
    paths = tool("skyway-plan", box_map, "--vehicle", "box:1,0.7,0.4", "--margin", "0.1", "--snap-ends", "20",
                 "--queries", "-", text=queries)
    closed = tool("skyway-traj", box_map, "--vmax", "8", "--amax", "6", text=paths)
    looking = tool("skyway-traj", box_map, "--vmax", "8", "--amax", "6", "--yaw", "along", text=paths)
    straight = tool("skyway-traj", box_map, "--vmax", "8", "--amax", "6", "--solver", "stop-and-go", text=paths)
    limited = [{**r, "id": "limited " + r["id"], "limits": {**r["limits"], "jmax": 1000, "tilt": 1.2, "vmax_h": 8, "vmax_v": 2, "thrust": 12, "body_rate": 9}}
               for r in objects(closed)]
    yawing = [{**r, "id": "yaw " + r["id"]} for r in objects(looking)]
    apart = [{**shifted(r), "id": "apart " + r["id"]} for r in objects(straight)]
    batches = {"paths": objects(paths), "closed": objects(closed), "straight": objects(straight),
               "limited": limited, "yawing": yawing, "apart": apart}

    def script(records):
        """What the script itself says of these records, by its exit code."""
        names = {"records": dump(records), "boxes": tool("skyway-map", "to-csv", box_map)}
        for name, text in names.items():
            with open(os.path.join(folder, name), "w") as file:
                file.write(text)
        return subprocess.run([sys.executable, os.path.join(os.path.dirname(__file__), "verify_certificate.py"),
                               *(os.path.join(folder, name) for name in names), "0,0,0,80,60,60", certificates],
                              capture_output=True).returncode

    lies = 0
    planes = 0
    gaps = 0
    for name, records in batches.items():
        reports = objects(tool("skyway-check", box_map, "--certificate", certificates, text=dump(records)))
        good = objects(open(certificates).read())
        ids = [r["id"] for r in reports if r["ok"]]
        assert [c["id"] for c in good] == ids, "one certificate for each record that was accepted"
        assert len(ids) >= 3, f"{name}: too few to test: {reports}"
        by_id = {c["id"]: c for c in good}
        assert script([r for r in records if r["id"] in by_id]) == 0
        assert script([{**records[0], "id": ids[1]}]) == 1, "the certificate of another record"
        for record in records:
            if record["id"] not in by_id:
                continue
            certificate = by_id[record["id"]]
            verify(record, certificate, boxes, bounds)
            planes += sum(len(s.get("planes", [])) for s in certificate["segments"])
            gaps += sum("gap" in s for s in certificate["segments"])
            for what, *lie in tampered(record, certificate, boxes, bounds):
                assert not holds(*lie), f"{name}: {record['id']}: {what} was not seen"
                lies += 1
    assert planes and gaps
print(f"every certificate holds; {lies} lies were seen; {planes} planes, {gaps} gaps")
