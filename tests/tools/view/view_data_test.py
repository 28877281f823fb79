"""view_data_test.py BIN_DIR DATA_DIR: the data in skyway-view's page against the tools it came from.

The map is north-east-up, so that everything must be turned into east-north-up on the way.
"""

import hashlib
import json
import math
import pathlib
import random
import struct
import subprocess
import sys
import tempfile

from page_data import Page

bin_dir, data = (pathlib.Path(a) for a in sys.argv[1:3])


def run(*args, text=None, yes=True):
    done = subprocess.run([str(bin_dir / args[0]), *map(str, args[1:])], text=True, input=text, capture_output=True)
    assert done.returncode in ((0,) if yes else (0, 1)), (args, done.stderr)
    return done.stdout


def enu(p):
    return (p[1], p[0], p[2])


def close(a, b, within=1e-4):
    assert all(abs(x - y) <= within for x, y in zip(a, b, strict=True)), (a, b)


def bernstein(values, u):
    n = len(values) - 1
    return sum(math.comb(n, i) * u**i * (1 - u) ** (n - i) * v for i, v in enumerate(values))


def evaluate(record, t, derivative):
    """Of a trajectory record, from the definition."""
    for last, segment in enumerate(record["segments"]):
        if t < segment["duration"] or last == len(record["segments"]) - 1:
            break
        t -= segment["duration"]
    out = []
    for axis in "xyz":
        values = segment[axis]
        for k in range(derivative):
            values = [(len(values) - 1) * (b - a) / segment["duration"] for a, b in zip(values, values[1:])]
        out.append(bernstein(values, min(t / segment["duration"], 1)))
    return out


def check_map(page, folder):
    rows = [line.split(",") for line in run("skyway-map", "to-csv", folder / "map").splitlines()[1:]]
    corners = page.points(page.meta["map"]["corners"])
    assert page.meta["map"]["boxes"] == len(rows) == len(corners) // 2
    assert page.meta["map"]["bounds_from"] == "option"
    assert len(page.meta["map"]["colours"]) == len(page.meta["map"]["labels"])
    for i, row in enumerate(rows):
        values = [float(v) for v in row[:6]]
        close(corners[2 * i], enu(values[:3]))
        close(corners[2 * i + 1], enu(values[3:]))


def check_path(page, path):
    layer = page.meta["paths"][0]
    assert layer["length"] == path["length"]
    for shown, point in zip(page.points(layer["points"]), path["points"], strict=True):
        close(shown, enu(point))


def check_trajectory(page, record, folder):
    layer = next(m for m in page.meta["motions"] if m["kind"] == "trajectory")
    count = layer["samples"]
    assert 2 <= count <= 2000 and layer["limits"] == record["limits"]
    positions = page.points(layer["position"])
    others = [page.array(layer[k]) for k in ("velocity", "acceleration", "jerk")]
    for i in range(0, count, 7):
        t = layer["duration"] * i / (count - 1)
        close(positions[i], enu(evaluate(record, t, 0)))
        for order, values in enumerate(others, 1):
            close(values[3 * i:3 * i + 3], enu(evaluate(record, t, order)), 2e-4)
    joints = page.array(layer["joints"])
    assert len(joints) == len(record["segments"]) - 1
    check_clearance(page, layer, folder, lambda t: evaluate(record, t, 0))


def check_clearance(page, layer, folder, position):
    """Each step has the least of what skyway-query says at nine points of it, or less by what lies between them."""
    ends = page.array(layer["clearance_end"])
    steps = list(zip((0, *ends), ends, page.array(layer["clearance"]), strict=False))
    assert abs(ends[-1] - layer["duration"]) < 1e-3 and list(ends) == sorted(ends)
    steps = steps[::5]
    times = [begin + (end - begin) * k / 8 for begin, end, _ in steps for k in range(9)]
    points = "".join(json.dumps({"point": position(t)}) + "\n" for t in times)
    answers = run("skyway-query", folder / "map", "--vehicle", "box:1,1,1", text=points).splitlines()
    found = [json.loads(answer)["clearance"] for answer in answers]
    for i, (begin, end, least) in enumerate(steps):
        sampled = min(found[9 * i:9 * i + 9])
        assert sampled - 0.05 < least <= sampled + 2e-3, (begin, end, least, sampled)


def check_tree(page, lines):
    head, nodes = json.loads(lines[0]), [json.loads(line) for line in lines[1:]]
    layer = page.meta["trees"][0]
    assert layer["nodes"] == head["nodes"] == len(nodes)
    for shown, node in zip(page.points(layer["points"]), nodes, strict=True):
        close(shown, enu(node["point"]))
    for key in ("parent", "first_parent", "tree"):
        assert list(page.array(layer[key])) == [n[key] for n in nodes], key


def check_lattice(page, folder, layer):
    """Nodes and edges as the exact predicate decides them."""
    mask, dims, step, first = page.array(layer["mask"]), layer["dims"], layer["spacing"], layer["first"]
    assert len(mask) == dims[0] * dims[1] * dims[2]
    assert sum(m & 1 for m in mask) == layer["nodes"]
    ways = [(1, 0, 0), (0, 1, 0), (0, 0, 1)] + ([(1, 1, 0), (1, -1, 0)] if layer["connectivity"] > 6 else [])
    where = lambda i: [first[k] + page.meta["origin"][k] + i[k] * step for k in range(3)]
    inside = lambda i: all(0 <= i[k] < dims[k] for k in range(3))
    asked, expected = [], []
    for z in range(dims[2]):
        for y in range(dims[1]):
            for x in range(dims[0]):
                for bit, way in enumerate([(0, 0, 0), *ways]):
                    other = [x + way[0], y + way[1], z + way[2]]
                    if not inside(other):
                        continue
                    segment = [enu(where((x, y, z))), enu(where(other))]
                    asked.append(json.dumps({"segment": segment}))
                    expected.append(mask[x + dims[0] * (y + dims[1] * z)] >> bit & 1)
    answers = run("skyway-query", folder / "map", "--vehicle", "box:1,1,1", text="\n".join(asked) + "\n")
    for line, free in zip(answers.splitlines(), expected, strict=True):
        answer = json.loads(line)
        assert (not answer["hit"] and answer["inside_bounds"]) == bool(free), (line, free)


def check_corridor(page, record):
    """Each region is all behind its planes and holds its own straight piece; edges join neighbours of faces."""
    layer = page.meta["corridors"][0]
    points, edges = page.points(layer["points"]), page.array(layer["edges"])
    triangles, last = page.array(layer["triangles"]), 0
    assert layer["pieces"] == len(record["pieces"]) > 0
    for piece, end, edge_end in zip(record["pieces"], page.array(layer["triangle_end"]),
                                    page.array(layer["edge_end"]), strict=True):
        used = set(triangles[last:end])
        assert [points[i] for i in sorted(used)] and len(used) == len(piece["vertices"])
        for shown, vertex in zip((points[i] for i in sorted(used)), piece["vertices"], strict=True):
            close(shown, enu(vertex))
        faces = len(piece["faces"])
        assert end - last == 3 * sum(len(f) - 2 for f in piece["faces"])
        last = end
        ends = edges[:edge_end] if piece is record["pieces"][0] else None
        if ends is not None:  # Euler: vertices - edges + faces = 2
            assert len(used) - len(ends) // 2 + faces == 2, (len(used), len(ends), faces)


def flight_rows(record, count):
    """A flight log that is 0.25 m too high all the time, in ENU."""
    header = ("id,t_s,east_m,north_m,up_m,v_east_mps,v_north_mps,v_up_mps,qw,qx,qy,qz,p_radps,q_radps,r_radps,setpoint_east_m,"
              "setpoint_north_m,setpoint_up_m,setpoint_v_east_mps,setpoint_v_north_mps,setpoint_v_up_mps,setpoint_yaw_rad,"
              "motor1,motor2,motor3,motor4,saturated,map")
    rows = [header]
    for i in range(count):
        t = record["duration"] * i / (count - 1)
        p, v = enu(evaluate(record, t, 0)), enu(evaluate(record, t, 1))
        values = [t, p[0], p[1], p[2] + 0.25, *v, 1, 0, 0, 0, 0, 0, 0, *p, *v, 0, 0.5, 0.5, 0.5, 0.5, i % 2, ""]
        rows.append(",".join([record["id"], *map(str, values)]))
    return "\n".join(rows) + "\n"


def check_flight(page, record, folder):
    layer = next(m for m in page.meta["motions"] if m["kind"] == "flight")
    summary = layer["summary"]
    assert summary["rows"] == 5000 and abs(summary["error_max"] - 0.25) < 1e-9
    assert abs(summary["error_rms"] - 0.25) < 1e-9 and summary["saturated"] == 0.5
    time = page.array(layer["time"])
    assert layer["samples"] == len(time) <= 2000 and time[0] == 0
    assert abs(time[-1] - record["duration"]) < 1e-3
    for i in range(0, len(time), 97):
        expected = enu(evaluate(record, time[i], 0))
        close(page.points(layer["setpoint"])[i], expected, 1e-2)
        close(page.points(layer["position"])[i], (expected[0], expected[1], expected[2] + 0.25), 1e-2)

    def position(t):
        north, east, up = evaluate(record, t, 0)
        return north, east, up + 0.25

    check_clearance(page, layer, folder, position)


def check_imported(folder):
    """What a log does not say is not in the page."""
    run("skyway-import-flight", data / "hop.ulg", "-q", "--map", folder / "map", "--ground", "1", "-o", folder / "hop.csv")
    lines = (folder / "hop.csv").read_text().splitlines()
    some = [line.split(",") for line in lines[:1] + lines[1:]]
    for row in some[1:]:
        row[8:22] = [""] * 14  # attitude, rates, setpoints
    (folder / "some.csv").write_text("\n".join(map(",".join, some)) + "\n")
    for name, has in (("hop.csv", True), ("some.csv", False)):
        run("skyway-view", folder / "map", folder / name, "--vehicle", "box:0.3,0.3,0.2", "-o", folder / "hop.html")
        layer = Page(folder / "hop.html").meta["motions"][0]
        assert layer["samples"] == 61 and layer["summary"]["rows"] == 61 and "velocity" in layer and "clearance" in layer
        for key in ("attitude", "rates", "setpoint", "error"):
            assert (key in layer) == has, key
        assert ("error_max" in layer["summary"]) == has and "saturated" in layer["summary"]


def hop():
    """A trajectory of 3 s that a quadrotor follows."""
    return {"type": "trajectory", "frame": "neu", "segments": [
        {"duration": 3, "x": [20] * 4 + [23] * 4, "y": [50] * 4 + [52] * 4, "z": [30] * 8}]}


def check_tubes(folder, record):
    """The tube of a report, of its own trajectory alone, and never called proved where it is not."""
    own = dict(record, id="q1")
    (folder / "flown").write_text(json.dumps(own) + "\n")
    asked = ("--vehicle", data / "quad.json", "--hover-time", "0.5", "--settle", "0.5", "-o", folder / "log.csv", "--report-file")
    run("skyway-fly", folder / "flown", *asked, folder / "proved", "--controller", "geometric", "--proved-tube", "--gust-most", "0.1")
    run("skyway-fly", folder / "flown", *asked, folder / "runs", "--runs", "3")
    reports = {kind: json.loads((folder / kind).read_text()) for kind in ("proved", "runs")}
    for kind, tube in (("proved", reports["proved"]["proved_tube"]), ("runs", reports["runs"]["monte_carlo"]["tube"])):
        run("skyway-view", folder / "flown", folder / kind, "-o", folder / "tube.html")
        page = Page(folder / "tube.html")
        shown = page.meta["motions"][0]["tube"]
        assert shown["kind"] == {"proved": "proved", "runs": "statistics"}[kind]
        assert ("proved for the simulated vehicle" in shown["words"]) == (kind == "proved"), shown["words"]
        close(page.array(shown["radius"]), tube["radius"], 1e-6)
    own["segments"][0]["duration"] *= 1.5
    own["duration"] = sum(s["duration"] for s in own["segments"])
    (folder / "flown").write_text(json.dumps(own) + "\n")
    run("skyway-view", folder / "flown", folder / "proved", "-o", folder / "tube.html")
    assert "tube" not in Page(folder / "tube.html").meta["motions"][0]


def fleet_records(count):
    """Trajectories of an early and a late part that meet only in position, side by side, each 3 s after the one before."""
    pick = random.Random(6)
    records = []
    for i in range(count):
        x = [5 + i + pick.uniform(-0.2, 0.2) for _ in range(8)]
        y = [pick.uniform(2, 50) for _ in range(8)]
        z = [pick.uniform(40, 50) for _ in range(8)]
        segments = [{"duration": pick.uniform(2, 9), "x": x, "y": y, "z": z},
                    {"duration": pick.uniform(2, 9), "x": x[::-1], "y": y[::-1], "z": z[::-1]}]
        segments[1].update({k: [segments[0][k][7]] + [pick.uniform(45, 46) for _ in range(7)] for k in "z"})
        segments[1].update({k: [segments[0][k][7]] + segments[1][k][1:] for k in "xy"})
        records.append({"type": "trajectory", "id": f"f{i}", "status": "solved", "frame": "neu", "margin": 0,
                        "vehicle": {"name": "v", "half": [0.1, 0.1, 0.1]}, "epoch": "2026-05-04T06:30:00Z",
                        "start": 100 + 3 * i, "earliest": 100 + 2 * i,
                        "duration": sum(s["duration"] for s in segments), "segments": segments})
    return records


def knot_state(page, layer, t, derivative):
    """Of the polynomial of degree 7 that has the states of the knots around t, by Bernstein's form of their ends."""
    steps, columns = page.array(layer["step"]), {k: page.array(layer[k]) for k in ("position", "velocity", "acceleration", "jerk")}
    i, begin = 0, 0
    while i + 2 < layer["knots"] and begin + steps[i + 1] <= t:
        i += 1
        begin += steps[i]
    h, out = steps[i + 1], []
    for axis in range(3):
        at = lambda key, k: columns[key][3 * k + axis] + (page.meta["origin"][axis] if key == "position" else 0)
        ends = []
        for k, d in ((i, h), (i + 1, -h)):
            p, v, a, j = (at(key, k) for key in columns)
            ends.append([p, p + d * v / 7, p + 2 * d * v / 7 + d * d * a / 42,
                         p + 3 * d * v / 7 + 3 * d * d * a / 42 + d**3 * j / 210])
        values = ends[0] + ends[1][::-1]
        for k in range(derivative):
            values = [(len(values) - 1) * (b - a) / h for a, b in zip(values, values[1:])]
        out.append(bernstein(values, min(max((t - begin) / h, 0), 1)))
    return out


def check_fleet(folder):
    """Many flights: knots that give back the polynomials, times, nearest approaches, and pairs as the check said."""
    records = fleet_records(40)
    (folder / "fleet.jsonl").write_text("".join(json.dumps(r) + "\n" for r in records))
    run("skyway-view", folder / "map", folder / "fleet.jsonl", "-o", folder / "fleet.html")
    page = Page(folder / "fleet.html")
    fleet = page.meta["fleet"]
    assert fleet["begin"] == 100 and fleet["epoch"] == "2026-05-04T06:30:00Z" and "check" not in fleet
    for i, (record, layer) in enumerate(zip(records, page.meta["motions"], strict=True)):
        assert layer["knots"] == 4 and "samples" not in layer  # two at the joint, where the parts do not meet
        assert layer["start"] == 3 * i and layer["delay"] == i and abs(layer["duration"] - record["duration"]) < 1e-12
        for t in (0, 0.3, 1.7, record["segments"][0]["duration"] + 0.4, record["duration"] - 1e-3):
            close(knot_state(page, layer, t, 0), enu(evaluate(record, t, 0)), 1e-3)
            close(knot_state(page, layer, t, 1), enu(evaluate(record, t, 1)), 5e-3)
    check_approaches(page, records, fleet)
    separation = ("--separation", "1.5,1.5", "--parked", "gone")
    report = subprocess.run([str(bin_dir / "skyway-check"), str(folder / "map"), str(folder / "fleet.jsonl"), "--together", *separation,
                             "--vmax", "1000", "-q"], text=True, capture_output=True).stdout
    (folder / "report.jsonl").write_text(report)
    run("skyway-view", folder / "map", folder / "fleet.jsonl", folder / "report.jsonl", "-o", folder / "fleet.html")
    lines = [json.loads(line) for line in report.splitlines()]
    refused = sorted((r for r in lines if r["type"] == "pair"), key=lambda r: r["share"])
    shown = [p for p in Page(folder / "fleet.html").meta["fleet"]["pairs"] if "reason" in p]
    assert len(shown) == len(refused) > 0
    for pair, said in zip(shown, refused, strict=True):
        assert [f"f{i}" for i in pair["of"]] == said["ids"] and abs(pair["time"] - (said["time"] - 100)) < 1e-9
        assert abs(pair["distance"] - math.hypot(said["across"], said["up"])) < 1e-9
        assert pair["across"] == said["across"] and pair["up"] == said["up"] and pair["asked"] == [1.5, 1.5]
    check = Page(folder / "fleet.html").meta["fleet"]["check"]
    assert not check["ok"] and check["refused"] == len(refused) and check["pairs"] == 40 * 39 // 2
    assert check["asked"] == [1.5, 1.5]
    check_verdict(folder, lines[-1])
    few = [json.dumps({**r, "start": None, "earliest": None, "epoch": None}) for r in records[:5]]
    (folder / "few.jsonl").write_text("\n".join(few) + "\n")  # no times, few flights: as ever
    run("skyway-view", folder / "map", folder / "few.jsonl", "-o", folder / "few.html")
    meta = Page(folder / "few.html").meta
    assert "fleet" not in meta and all("samples" in m and "start" not in m for m in meta["motions"])


def check_verdict(folder, failed):
    """Of several checks one that failed is shown; none that says ok of other flights."""
    good = {**failed, "ok": True, "refused": 0}

    def shown(*lines):
        (folder / "verdicts.jsonl").write_text("".join(json.dumps(line) + "\n" for line in lines))
        run("skyway-view", folder / "map", folder / "fleet.jsonl", folder / "verdicts.jsonl", "-o", folder / "verdicts.html")
        return Page(folder / "verdicts.html").meta["fleet"].get("check")

    assert shown(good)["ok"]
    assert not shown(good, failed)["ok"] and not shown(failed, good)["ok"]
    others = {**good, "flights_hash": hashlib.sha256(b"as many, but others").hexdigest()}
    assert shown(others) is None
    assert shown(others, good)["flights"] == 40
    records = [json.loads(line) for line in (folder / "fleet.jsonl").read_text().splitlines()]
    assert good["flights_hash"] == flights_hash(records)


def flights_hash(records):
    """As docs/formats.md says it."""
    total = hashlib.sha256((records[0]["epoch"] + "\n").encode())
    for record in sorted(records, key=lambda r: r["id"]):
        numbers = [record["start"], len(record["segments"])]
        for segment in record["segments"]:
            points = zip(segment["x"], segment["y"], segment["z"], strict=True)
            numbers += [segment["duration"], *(number for point in points for number in point)]
        total.update((record["id"] + "\n").encode() + struct.pack(f"<{len(numbers)}d", *numbers))
    return total.hexdigest()


def check_approaches(page, records, fleet):
    """No farther than samples, and at the place and time that they say."""
    at = lambda r, t: evaluate(r, t - r["start"], 0)
    nearest = page.array(fleet["nearest"])
    assert fleet["pairs"] and fleet["near"] >= len(fleet["pairs"])
    for pair in fleet["pairs"][:10]:
        a, b = (records[i] for i in pair["of"])
        time = pair["time"] + fleet["begin"]
        assert abs(math.dist(at(a, time), at(b, time)) - pair["distance"]) < 1e-5
        begin, end = max(a["start"], b["start"]), min(a["start"] + a["duration"], b["start"] + b["duration"])
        sampled = min(math.dist(at(a, t), at(b, t)) for t in (begin + (end - begin) * k / 300 for k in range(301)))
        assert pair["distance"] <= sampled + 2e-3, (pair, sampled)
        assert abs(math.hypot(pair["across"], pair["up"]) - pair["distance"]) < 1e-9
        assert all(nearest[3 * i] <= pair["distance"] + 1e-5 for i in pair["of"])
    for i in range(len(records)):
        distance, across, up = nearest[3 * i:3 * i + 3]
        assert math.isnan(distance) or abs(math.hypot(across, up) - distance) < 1e-5 * max(1, distance)


def check_reports_of_others(folder, record):
    """A report of another trajectory of the same id says nothing of what is shown: refused."""
    run("skyway-check", "-q", folder / "map", folder / "trajectory", "-o", folder / "own", yes=False)
    slower = {**record, "duration": 2 * record["duration"], "segments": [{**s, "duration": 2 * s["duration"]} for s in record["segments"]]}
    (folder / "slower").write_text(json.dumps(slower) + "\n")

    def shown(*files):
        done = subprocess.run([str(bin_dir / "skyway-view"), *map(str, files), "-o", folder / "others.html"], text=True, capture_output=True)
        return done.returncode, done.stderr

    assert shown(folder / "map", folder / "trajectory", folder / "own") == (0, "")
    assert shown(folder / "map", folder / "slower", folder / "trajectory", folder / "own") == (0, "")  # it is of one of them
    code, said = shown(folder / "map", folder / "slower", folder / "own")
    assert code == 3 and "own:1: expected a report of the trajectory" in said and "found one of another: it lasts" in said, said


def check_home(folder, record):
    """Returns of a report and planned ways, turned like all else; what is not said is not there."""
    run("skyway-check", folder / "map", folder / "trajectory", "-q", "--return", "--home-place", "5,30,0", "--return-height", "12",
        "-o", folder / "returns", yes=False)
    report = json.loads((folder / "returns").read_text())
    assert report["return"]["gaps"], "the houses are in no way"
    made_for = {key: record[key] for key in ("map", "frame", "vehicle", "margin")}
    way = {"type": "contingency", "id": record["id"], **made_for, "from": 0, "until": 4, "site": "pad", "length": 30.5, "duration": 20.5,
           "latest_departure": 3, "points": [[5, 30, 20], [5, 40, 20], [5, 40, 0]]}
    none = {"type": "contingency", "id": record["id"], **made_for, "status": "unreachable", "from": 4, "until": 6, "message": "none"}
    unbound = {key: value for key, value in way.items() if key != "latest_departure"}
    (folder / "ways").write_text("".join(json.dumps(r) + "\n" for r in (way, none, unbound, {**way, "latest_departure": None})))
    run("skyway-view", *[folder / f for f in ("map", "trajectory", "returns", "ways")], "-o", folder / "home.html")
    page = Page(folder / "home.html")
    local = lambda p: [v + o for v, o in zip(p, page.meta["origin"], strict=True)]
    shown, said = page.meta["reports"][0]["return"], report["return"]
    for key in ("action", "autopilot", "height", "share", "duration", "longest"):
        assert shown[key] == said[key], key
    assert shown.get("least_height") == said.get("least_height")
    close(local(shown["home"]), enu(said["home"]))
    for one, gap in zip(shown["gaps"], said["gaps"], strict=True):
        assert all(one[key] == gap[key] for key in ("from", "until", "phase", "reason", "autopilot")) and one.get("box") == gap.get("box")
        close(local(one["place"]), enu(gap["at"]))
    ways = page.meta["contingencies"]
    for point, given in zip(page.points(ways[0]["points"]), way["points"], strict=True):
        close(point, enu(given))
    assert (ways[0]["from"], ways[0]["until"], ways[0]["site"], ways[0]["length"], ways[0]["duration"]) == (0, 4, "pad", 30.5, 20.5)
    assert [w.get("energy") for w in ways] == [True, None, False, True]
    assert [w.get("latest") for w in ways] == [3, None, 4, None]
    assert "points" not in ways[1] and ways[1]["message"] == "none"


def check_levels(folder):
    """Of many boxes: every box is in the page, to the millimetre, and blocks of each level hold the boxes of their tile."""
    random.seed(8)
    rows = []
    for house in range(700):
        x, y, top = random.uniform(-900, 900), random.uniform(-900, 900), random.uniform(4, 40)
        rows += [(x + 0.8 * k, y + random.random(), 0, x + 0.8 * (k + 1), y + 12 + random.random(), top) for k in range(33)]
    table = "min_x_m,min_y_m,min_z_m,max_x_m,max_y_m,max_z_m,label\n" + "".join(",".join(map(str, r)) + ",\n" for r in rows)
    (folder / "many.csv").write_text(table)
    run("skyway-import", "-q", folder / "many.csv", "-o", folder / "many")
    run("skyway-view", folder / "many", "-o", folder / "many.html")
    page = Page(folder / "many.html")
    layer, origin = page.meta["map"], page.meta["origin"]
    boxes = page.boxes(layer["corners"], layer["step"])
    assert len(boxes) == layer["boxes"] == len(rows)
    ids = page.array(layer["ids"])
    assert sorted(ids) == sorted(set(ids))
    by_id = {line: row[:6] for line, row in enumerate(rows, 2)}  # an id is the line of the table
    for i, (low, high) in zip(ids, boxes, strict=True):
        close([*(low[k] + origin[k] for k in range(3)), *(high[k] + origin[k] for k in range(3))], by_id[i], 2e-3)
    tiles = page.array(layer["tiles"])
    assert tiles[0] == 0 and tiles[-1] == len(boxes) and list(tiles) == sorted(tiles)
    assert layer["far"] and layer["far"][-1]["count"] < len(boxes) / 5
    for level in layer["far"]:
        blocks, first = page.boxes(level["corners"], layer["step"]), page.array(level["first"])
        assert len(first) == len(tiles) and len(page.columns(level["look"])[0]) == len(blocks) == first[-1]
        for t in random.sample(range(len(tiles) - 1), 12):
            near = blocks[first[t]:first[t + 1]]
            for low, high in boxes[tiles[t]:tiles[t + 1]]:
                for share in (0.01, 0.5, 0.99):
                    p = [a + share * (b - a) for a, b in zip(low, high)]
                    assert any(all(a - 2e-3 <= v <= b + 2e-3 for a, v, b in zip(*block[:1], p, *block[1:])) for block in near), (t, p)


def main(folder):
    run("skyway-import", data / "village.csv", "-q", "--bounds", "0,0,0,80,60,60", "-o", folder / "map")
    vehicle = ["--vehicle", "box:1,1,1"]
    ends = ["--from", "5,30,5", "--to", "70,10,5"]
    for ways in ("6", "26"):
        run("skyway-lattice", folder / "map", "-q", "--spacing", "5", "--connect", ways, *vehicle,
            "-o", folder / f"lattice{ways}")
    path = run("skyway-plan", folder / "map", "-q", *ends, *vehicle)
    run("skyway-plan", folder / "map", "-q", *ends, *vehicle, "--method", "rrt-star", "--iterations", "500",
        "--tree", folder / "tree", "-o", folder / "sampled")
    trajectory = run("skyway-traj", folder / "map", "--vmax", "8", "--amax", "6", "--corridor-file",
                     folder / "corridor", text=path)
    (folder / "path").write_text(path)
    (folder / "trajectory").write_text(trajectory)
    record = json.loads(trajectory)
    (folder / "flight").write_text(flight_rows(record, 5000))
    files = [folder / f for f in ("flight", "path", "trajectory", "tree", "corridor", "lattice6", "lattice26", "map")]
    page_file = folder / "page.html"
    run("skyway-view", *files, "--title", "A < B & C", "-o", page_file)
    page = Page(page_file)
    assert page.title == "A < B & C"
    assert "http://" not in page.text.split("<script>")[0] and "src=" not in page.text.split("<script>")[0]
    check_map(page, folder)
    check_path(page, json.loads(path))
    check_trajectory(page, record, folder)
    check_tree(page, (folder / "tree").read_text().splitlines())
    assert [layer["connectivity"] for layer in page.meta["lattices"]] == [6, 26]
    for layer in page.meta["lattices"]:
        check_lattice(page, folder, layer)
    check_corridor(page, json.loads((folder / "corridor").read_text()))
    check_flight(page, record, folder)
    run("skyway-view", *files, "--title", "A < B & C", "-o", folder / "again.html")
    assert (folder / "again.html").read_bytes() == page_file.read_bytes()
    check_imported(folder)
    check_home(folder, record)
    check_reports_of_others(folder, record)
    check_levels(folder)
    check_tubes(folder, hop())
    check_fleet(folder)


with tempfile.TemporaryDirectory() as name:
    main(pathlib.Path(name))
print("page data: as the tools say")
