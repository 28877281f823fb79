"""certificate_test.py BIN_DIR CITY.csv: certificates hold for the independent verifier, and none does once tampered with."""

import contextlib
import copy
import io
import json
import os
import subprocess
import sys
import tempfile

from certificate_mutants import Bundle, mutants, still_true
from tools_and_claims import Tools, changed, objects, refused
from verify_certificate import BoxMap, F, main, verify

tool = Tools(sys.argv[1])
city = sys.argv[2]
QUERIES = ["5,30,5,70,10,5", "10,5,3,60,50,8", "70,50,4,5,6,5", "40,3,6,35,55,5"]


def dump(records):
    return "".join(json.dumps(r) + "\n" for r in records)


def shifted(record):
    """The same with the second segment a third of a nanometre off: there is a step to be clear of."""
    out = copy.deepcopy(record)
    out["segments"][1]["x"] = [x + 2**-31 if abs(x) < 2**20 else x for x in out["segments"][1]["x"]]
    return out


def with_boxes(box_map, boxes):
    out = copy.copy(box_map)
    out.boxes = boxes
    return out


def with_bounds(box_map, bounds):
    out = copy.copy(box_map)
    out.bounds = bounds
    return out


def tampered(record, certificate, box_map):
    """(what, record, certificate, map) of each way to lie that applies."""
    segments = certificate["segments"]
    for i, proof in enumerate(segments):
        for k, (_, _, plane) in enumerate(proof.get("planes", [])):
            other = ("-" if plane[0] == "+" else "+") + plane[1]
            yield ("a plane flipped", record,
                   changed(certificate, lambda c: c["segments"][i]["planes"][k].__setitem__(2, other)), box_map)
            yield ("a plane missing", record,
                   changed(certificate, lambda c: c["segments"][i]["planes"].pop(k)), box_map)
        if "gap" in proof:
            yield "a gap left out", record, changed(certificate, lambda c: c["segments"][i].pop("gap")), box_map
    yield "a segment missing", record, changed(certificate, lambda c: c["segments"].pop()), box_map

    if "points" in record:
        middle = [F(a + b) / 2 for a, b in zip(*record["points"][:2])]
    else:
        middle = [F(record["segments"][0][axis][-1]) for axis in "xyz"]
    yield "a box in the way", record, certificate, with_boxes(box_map, box_map.boxes + [(*middle, *middle)])
    half = [F(h) + F(record["margin"]) for h in record["vehicle"]["half"]]
    beside = [m + h if a == 0 else m for a, (m, h) in enumerate(zip(middle, half))]
    moved = [(*beside, *(b + 1 for b in beside))] + box_map.boxes[1:]
    yield "a box moved to touch", record, certificate, with_boxes(box_map, moved)
    closer = (box_map.bounds[0], [float(m + h) - 1e-9 for m, h in zip(middle, half)])
    yield ("bounds drawn closer", record, changed(certificate, lambda c: c.update(bounds=list(closer))),
           with_bounds(box_map, closer))
    if "segments" in record:
        yield "a limit lowered", changed(record, lambda r: r["limits"].update(vmax=0.5)), certificate, box_map
        yield ("a jump", changed(record, lambda r: r["segments"][-1].update(duration=r["segments"][-1]["duration"] * 0.9)),
               certificate, box_map)
        yield ("a curve bent", changed(record, lambda r: r["segments"][0]["z"].__setitem__(4, 1e4)),
               certificate, box_map)


def bundle(record, box_map, certificate):
    return Bundle(*(json.dumps(r).encode() + b"\n" if isinstance(r, dict) else r for r in (record, box_map, certificate)))


written = {}  # what stands in which file


def write_bundle(folder, files):
    names = [os.path.join(folder, name) for name in ("record.jsonl", "map.boxmap", "certificate.jsonl")]
    for name, data in zip(names, files):
        if written.get(name) != data:
            with open(name, "wb") as file:
                file.write(data)
            written[name] = data
    return names


def verdict(folder, files):
    """Exit code and words of the verifier's main() on these bytes, in this process."""
    sys.argv = ["verify_certificate.py", *write_bundle(folder, files)]
    said = io.StringIO()
    with contextlib.redirect_stdout(said), contextlib.redirect_stderr(said):
        try:
            main()
        except SystemExit as exit_:
            return int(exit_.code), said.getvalue()
    raise AssertionError("main() came back")


def as_process(folder, files):
    done = subprocess.run([sys.executable, os.path.join(os.path.dirname(__file__), "verify_certificate.py"),
                           *write_bundle(folder, files)], capture_output=True, text=True)
    assert "Traceback" not in done.stderr, done.stderr
    return done.returncode, done.stdout + done.stderr


def mutate(folder, good, other):
    """How many mutants were refused; each must be, with a word of why."""
    assert len(json.loads(good.certificate)["segments"]) != len(json.loads(other.certificate)["segments"])
    for what, files in still_true(good):
        assert verdict(folder, files)[0] == 0, f"{what}: refused: {verdict(folder, files)[1]}"
    count = 0
    accepted = []
    for what, files in mutants(good, other):
        assert files != good, f"{what}: nothing is changed"
        code, said = (as_process if count % 100 == 0 else verdict)(folder, files)
        if code == 0 or "refused: " not in said:
            accepted.append(f"{what}: exit {code}: {said}")
        count += 1
    assert not accepted, f"{len(accepted)} of {count} mutants were accepted:\n" + "\n".join(accepted)
    return count


with tempfile.TemporaryDirectory() as folder:
    box_map, certificates = os.path.join(folder, "m.boxmap"), os.path.join(folder, "c.jsonl")
    tool("skyway-import", "-q", city, "--bounds", "0,0,0,80,60,60", "-o", box_map)
    city_map = BoxMap(box_map)
    rows = [[float(c) for c in line.split(",")[:6]] for line in tool("skyway-map", "to-csv", box_map).splitlines()[1:]]
    assert rows == [list(box) for box in city_map.boxes], "the rows that certificates count are those of to-csv"
    queries = "".join(json.dumps({"id": f"q{i}", "from": n[:3], "to": n[3:]}) + "\n" for i, n in
                      enumerate([[float(c) for c in q.split(",")] for q in QUERIES]))
    paths = tool("skyway-plan", box_map, "--vehicle", "box:1,0.7,0.4", "--margin", "0.1", "--snap-ends", "20",
                 "--queries", "-", text=queries)
    closed = tool("skyway-traj", box_map, "--vmax", "8", "--amax", "6", text=paths)
    looking = tool("skyway-traj", box_map, "--vmax", "8", "--amax", "6", "--yaw", "along", text=paths)
    straight = tool("skyway-traj", box_map, "--vmax", "8", "--amax", "6", "--solver", "stop-and-go", text=paths)
    limited = [{**r, "id": "limited " + r["id"], "limits": {**r["limits"], "jmax": 1000, "tilt": 1.2, "vmax_h": 8, "vmax_v": 2, "thrust": 12, "body_rate": 9}}
               for r in objects(closed)]
    yawing = [{**r, "id": "yaw " + r["id"], "limits": {**r["limits"], "yaw_rate": 2}} for r in objects(looking)]
    apart = [{**shifted(r), "id": "apart " + r["id"]} for r in objects(straight)]
    batches = {"paths": objects(paths), "closed": objects(closed), "straight": objects(straight),
               "limited": limited, "yawing": yawing, "apart": apart}

    with open(box_map, "rb") as file:
        map_bytes = file.read()

    def script(records, good):
        return as_process(folder, Bundle(dump(records).encode(), map_bytes, dump(good).encode()))[0]

    lies = 0
    killed = 0
    planes = 0
    gaps = 0
    for name, records in batches.items():
        reports = objects(tool("skyway-check", box_map, "--certificate", certificates, text=dump(records)))
        good = objects(open(certificates).read())
        ids = [r["id"] for r in reports if r["ok"]]
        assert [c["id"] for c in good] == ids, "one certificate for each record that was accepted"
        assert len(ids) >= 3, f"{name}: too few to test: {reports}"
        by_id = {c["id"]: c for c in good}
        assert script([r for r in records if r["id"] in by_id], good) == 0
        assert script(records + [{**records[0], "id": "another"}], good) == 1, "a record without a certificate"
        for record in records:
            if record["id"] not in by_id:
                continue
            certificate = by_id[record["id"]]
            verify(record, certificate, city_map)
            planes += sum(len(s.get("planes", [])) for s in certificate["segments"])
            gaps += sum("gap" in s for s in certificate["segments"])
            for what, *lie in tampered(record, certificate, city_map):
                assert refused(verify, *lie), f"{name}: {record['id']}: {what} was not seen"
                lies += 1
        if name in ("closed", "straight"):
            continue
        # Of those with the most planes the shortest, and one that cannot be taken for it.
        rich = max(good, key=lambda c: (any("planes" in s for s in c["segments"]), -len(c["segments"])))
        other = next(c for c in good if len(c["segments"]) != len(rich["segments"]))
        record_of = {r["id"]: r for r in records}
        killed += mutate(folder, *(bundle(record_of[c["id"]], map_bytes, c) for c in (rich, other)))
    assert planes and gaps
print(f"every certificate holds; {lies} lies and {killed} mutants were refused; {planes} planes, {gaps} gaps")
