"""view_data_test.py BIN_DIR DATA_DIR: the data in skyway-view's page against the tools it came from.

The map is north-east-up, so that everything must be turned into east-north-up on the way.
"""

import json
import math
import pathlib
import subprocess
import sys
import tempfile

from page_data import Page

bin_dir, data = (pathlib.Path(a) for a in sys.argv[1:3])


def run(*args, text=None):
    return subprocess.run([str(bin_dir / args[0]), *map(str, args[1:])], check=True, text=True,
                          input=text, capture_output=True).stdout


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
    header = ("id,t_s,x_m,y_m,z_m,vx_mps,vy_mps,vz_mps,qw,qx,qy,qz,p_radps,q_radps,r_radps,setpoint_x_m,"
              "setpoint_y_m,setpoint_z_m,setpoint_vx_mps,setpoint_vy_mps,setpoint_vz_mps,setpoint_yaw_rad,"
              "motor1,motor2,motor3,motor4,saturated")
    rows = [header]
    for i in range(count):
        t = record["duration"] * i / (count - 1)
        p, v = enu(evaluate(record, t, 0)), enu(evaluate(record, t, 1))
        values = [t, p[0], p[1], p[2] + 0.25, *v, 1, 0, 0, 0, 0, 0, 0, *p, *v, 0, 0.5, 0.5, 0.5, 0.5, i % 2]
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
    run("skyway-import-flight", data / "hop.ulg", "-q", "--map", folder / "map", "--geoid", "-32", "-o", folder / "hop.csv")
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


with tempfile.TemporaryDirectory() as name:
    main(pathlib.Path(name))
print("page data: as the tools say")
