"""fleet_stream_test.py BIN_DIR: skyway-fleet refuses flights whose coordinates cannot be compared, also where the first
says nothing of its map and frame."""

import json
import os
import subprocess
import sys
import tempfile

bin_dir = sys.argv[1]


def flight(name, a, b, **more):
    segment = {axis: [a[k]] * 4 + [b[k]] * 4 for k, axis in enumerate("xyz")}
    return {"type": "trajectory", "id": name, "status": "solved", **more, "segments": [{"duration": 8, **segment}]}


def fleet(records, ways=None, code=0):
    """What it wrote on stderr, and its report."""
    for name, lines in (("in.jsonl", records), ("ways.jsonl", ways or [])):
        with open(name, "w", encoding="utf-8") as file:
            file.write("".join(json.dumps(line) + "\n" for line in lines))
    options = ["--alternatives", "ways.jsonl"] if ways else []
    done = subprocess.run([os.path.join(bin_dir, "skyway-fleet"), "in.jsonl", *options, "--separation", "2,2", "-o", "out.jsonl",
                           "--report-file", "report.json"], capture_output=True, text=True)
    assert done.returncode == code, (done.returncode, done.stderr)
    if code:
        return done.stderr, None
    with open("report.json", encoding="utf-8") as file:
        return done.stderr, json.load(file)


with tempfile.TemporaryDirectory() as folder:
    os.chdir(folder)
    ends = (-80, -80, 5), (-80, -70, 5)
    silent = flight("n", *ends)
    # The same way: x is east in the one, north in the other.
    east, north = ((20, 0, 30), (30, 10, 30)), ((0, 20, 30), (10, 30, 30))
    enu, neu = flight("a", *east, frame="enu"), flight("b", *north, frame="neu")
    for records in ([enu, neu], [silent, enu, neu], [enu, silent, neu]):
        assert "expected frame enu" in fleet(records, code=3)[0]
    one, other = flight("a", *east, map="one"), flight("b", *north, map="other")
    for records in ([one, other], [silent, one, other]):
        assert "made for another map" in fleet(records, code=3)[0]
    assert "expected frame enu" in fleet([silent, enu], [flight("n", *north, frame="neu")], code=3)[0]
    assert "expected frame enu" in fleet([silent], [flight("n", *ends, frame="enu"), flight("n", *ends, frame="neu")], code=3)[0]
    report = fleet([silent, one, flight("c", *north, map="one", frame="enu")])[1]
    assert report["ok"] and report["map"] == "one"
    # Another way of a flight goes to the same place, with as much room.
    assert "begins at (-80, -80, 5), found one that begins at (20, 0, 30)" in fleet([silent], [flight("n", *east)], code=3)[0]
    sized = [flight("n", *ends, vehicle={"half": [half] * 3}, margin=0) for half in (1, 0.9)]
    assert "as much room" in fleet(sized[:1], sized[1:], code=3)[0]
    assert fleet(sized[1:], sized[:1])[1]["ok"]
print("fleet: flights of one map and frame")
