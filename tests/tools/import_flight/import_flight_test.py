"""import_flight_test.py BIN_DIR [FLIGHTS]: PX4 logs to flight logs, and those against maps, as processes.

What is read is held against ulog.py, which shares no code with the product, and against pyulog where it is installed. Places
are held against the formulas of a sphere (PX4's local projection, by the direct problem of navigation) and of Krüger's
series for the transverse Mercator projection. Verdicts are held against exact fractions. With SKYWAY_REALDATA a log of a real
vehicle is read too.
"""

import csv
import io
import json
import math
import os
import pathlib
import random
import subprocess
import sys
import tempfile
from fractions import Fraction

from make_hop import VALID, hop
from ulog import ATTITUDE, LOCAL, SETPOINT, Log, read

bin_dir = pathlib.Path(sys.argv[1])
wrong = []


def expect(what, condition, more=""):
    if not condition:
        wrong.append(f"{what}: {more}")


def run(tool, *arguments, data=b""):
    done = subprocess.run([bin_dir / tool, *map(str, arguments)], input=data, capture_output=True, timeout=600)
    return done.returncode, done.stdout.decode(), done.stderr.decode()


def rows_of(text):
    return list(csv.DictReader(io.StringIO(text)))


def number(text):
    return float(text) if text else math.nan


def vector(row, *names):
    return [number(row[name]) for name in names]


def place(reference, north, east):
    """Latitude and longitude by great circle: PX4's sphere."""
    lat, lon = math.radians(reference[0]), math.radians(reference[1])
    angle, course = math.hypot(north, east) / 6371000, math.atan2(east, north)
    to = math.asin(math.sin(lat) * math.cos(angle) + math.cos(lat) * math.sin(angle) * math.cos(course))
    across = math.atan2(math.sin(course) * math.sin(angle) * math.cos(lat), math.cos(angle) - math.sin(lat) * math.sin(to))
    return math.degrees(to), math.degrees(lon + across)


def mercator(latitude, longitude, meridian):
    """Easting and northing from the equator: Krüger 1912, to the fourth power of the flattening; scale 1, WGS 84."""
    a, f = 6378137.0, 1 / 298.257223563
    n = f / (2 - f)
    e = math.sqrt(f * (2 - f))
    radius = a / (1 + n) * (1 + n ** 2 / 4 + n ** 4 / 64)
    alpha = [n / 2 - 2 * n ** 2 / 3 + 5 * n ** 3 / 16 + 41 * n ** 4 / 180, 13 * n ** 2 / 48 - 3 * n ** 3 / 5 + 557 * n ** 4 / 1440,
             61 * n ** 3 / 240 - 103 * n ** 4 / 140, 49561 * n ** 4 / 161280]
    phi, across = math.radians(latitude), math.radians(longitude - meridian)
    t = math.sinh(math.atanh(math.sin(phi)) - e * math.atanh(e * math.sin(phi)))
    xi, eta = math.atan2(t, math.cos(across)), math.atanh(math.sin(across) / math.hypot(1, t))
    north = radius * (xi + sum(v * math.sin(2 * k * xi) * math.cosh(2 * k * eta) for k, v in enumerate(alpha, 1)))
    east = radius * (eta + sum(v * math.cos(2 * k * xi) * math.sinh(2 * k * eta) for k, v in enumerate(alpha, 1)))
    return east, north


def turned(q, v):
    """A vector turned by a quaternion w, x, y, z."""
    w, x, y, z = q
    rows = [[1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
            [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
            [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)]]
    return [sum(a * b for a, b in zip(row, v)) for row in rows]


def compare(what, data, rows, origin, geoid):
    """Rows of our log against the messages, latitude, longitude and height of the map's origin."""
    messages = [m for m in read(data)["vehicle_local_position"] if m["xy_valid"] and m["z_valid"]]
    attitude = read(data)["vehicle_attitude"]
    expect(what, len(rows) == len(messages), f"{len(rows)} rows of {len(messages)}")
    base = mercator(origin[0], origin[1], origin[1])
    furthest = most = 0
    for row, m in zip(rows, messages):
        expect(what, abs(number(row["t_s"]) - (m["timestamp"] - messages[0]["timestamp"]) * 1e-6) < 1e-9, row["t_s"])
        east, north = mercator(*place((m["ref_lat"], m["ref_lon"]), m["x"], m["y"]), origin[1])
        up = m["ref_alt"] - m["z"] + geoid - origin[2]
        at = [east - base[0], north - base[1], up]
        furthest = max(furthest, math.dist(at, vector(row, "east_m", "north_m", "up_m")))
        v = vector(row, "v_east_mps", "v_north_mps", "v_up_mps")
        known = m["v_xy_valid"] and m["v_z_valid"]
        if known:
            expect(what, math.dist(v, [m["vy"], m["vx"], -m["vz"]]) < 1e-3 * math.hypot(*v) + 1e-9, v)
        else:
            expect(what, all(map(math.isnan, v)), v)
        last = [a for a in attitude if a["at"] < m["at"]][-1:]
        if not last or m["timestamp"] - last[0]["timestamp"] > 900_000:
            continue
        q = vector(row, "qw", "qx", "qy", "qz")
        for axis, sign in ((0, 1), (1, -1), (2, -1)):  # forward, left, up in the vehicle's forward, right, down
            unit = [float(i == axis) for i in range(3)]
            ned = turned(last[0]["q"], [sign * u for u in unit])
            most = max(most, math.dist(turned(q, unit), [ned[1], ned[0], -ned[2]]))
    expect(what, furthest < 1e-5, f"{furthest} m off")
    expect(what, most < 2e-3, f"attitude off by {most}")
    print(f"{what}: {len(rows)} rows, {furthest:.2g} m off")


def random_flight(seed):
    dice = random.Random(seed)
    log = Log()
    for name, text in (("vehicle_local_position", LOCAL), ("vehicle_attitude", ATTITUDE), ("trajectory_setpoint", SETPOINT)):
        log.topic(name, text)
    reference = {"ref_lat": dice.uniform(-60, 60), "ref_lon": dice.uniform(-179, 179), "ref_alt": dice.uniform(-50, 3000)}
    for k in range(200):
        time = 1000 + 50_000 * k
        q = [dice.gauss(0, 1) for _ in range(4)]
        size = math.hypot(*q)
        log.row("vehicle_attitude", timestamp=time - 5, q=[v / size for v in q])
        log.row("vehicle_local_position", timestamp=time, x=dice.uniform(-3000, 3000), y=dice.uniform(-3000, 3000),
                z=dice.uniform(-120, 5), vx=dice.gauss(0, 5), vy=dice.gauss(0, 5), vz=dice.gauss(0, 1), **reference,
                **{**VALID, "xy_valid": dice.random() < 0.9, "v_xy_valid": dice.random() < 0.9})
    return bytes(log), reference


def check_places():
    for seed in range(10):
        data, reference = random_flight(seed)
        origin = (reference["ref_lat"] + 0.01, reference["ref_lon"] - 0.01, 12.5)
        code, out, err = run("skyway-import-flight", "-", "--origin", ",".join(map(repr, origin)), "--geoid", "31.5", data=data)
        expect(f"flight {seed}", code == 0, err)
        compare(f"flight {seed}", data, rows_of(out), origin, 31.5)


def check_real():
    folder = os.environ.get("SKYWAY_REALDATA")
    file = pathlib.Path(folder or "/nowhere") / "flights" / "px4_small.ulg"
    if not file.exists():
        print("real log: skipped, SKYWAY_REALDATA does not name it")
        return
    data = file.read_bytes()
    code, out, err = run("skyway-import-flight", file)
    expect("real log", code == 3 and "636 rows of vehicle_local_position" in err, err)  # it never knew where it was
    # The same bytes, with a vehicle that does know: flags and a reference are set in each message.
    start = data.index(b"vehicle_local_position:")
    fields = data[start:start + int.from_bytes(data[start - 3:start - 1], "little")].decode().partition(":")[2]
    changed = bytearray(data)
    for m in read(data)["vehicle_local_position"]:
        log = Log()
        log.topic("vehicle_local_position", fields)
        before = len(log.data)
        log.row("vehicle_local_position", **{**m, **VALID, "ref_lat": 47.4, "ref_lon": 8.5, "ref_alt": 488.0})
        new = log.data[before + 5:]
        changed[m["at"] - len(new):m["at"]] = new
    changed = bytes(changed)
    code, out, err = run("skyway-import-flight", "-", "--origin", "47.4,8.5,500", data=changed)
    expect("real log", code == 0, err)
    compare("real log", changed, rows_of(out), (47.4, 8.5, 500), 0)
    try:
        from pyulog import ULog
    except ImportError:
        print("pyulog: skipped, not installed")
        return
    theirs = {d.name: d.data for d in ULog(io.BytesIO(data)).data_list if d.multi_id == 0}
    ours = read(data)["vehicle_local_position"]
    for field in ("timestamp", "x", "y", "z", "vx"):
        expect("pyulog", list(theirs["vehicle_local_position"][field]) == [m[field] for m in ours], field)


def check_damage(folder):
    """Every cut and many changes of bytes end in a log that is whole, or a refusal."""
    data = bytes(hop())
    (folder / "m.csv").write_text("min_x_m,min_y_m,min_z_m,max_x_m,max_y_m,max_z_m,label\n10,10,0,20,20,30,\n")
    code, out, err = run("skyway-import", folder / "m.csv", "-q", "--bounds=-1e5,-1e5,-1e5,1e5,1e5,1e5", "-o", folder / "m")
    expect("map", code == 0, err)
    dice = random.Random(7)
    cases = [data[:size] for size in range(0, len(data), 211)]
    for _ in range(150):
        changed = bytearray(data)
        for _ in range(dice.randrange(1, 6)):
            changed[dice.randrange(len(data))] = dice.randrange(256)
        cases.append(bytes(changed))
    read_back = 0
    for k, case in enumerate(cases):
        code, out, err = run("skyway-import-flight", "-", "--id", "f", data=case)
        expect(f"damage {k}", code in (0, 3) and err.startswith("skyway-import-flight: "), (code, err))
        if code != 0:
            continue
        read_back += 1
        rows = rows_of(out)
        expect(f"damage {k}", all(number(b["t_s"]) > number(a["t_s"]) for a, b in zip(rows, rows[1:])))
        if k % 10 == 0:
            code, report, err = run("skyway-check", folder / "m", "-", "--file-format", "flight-log", "--vehicle", "box:1,1,1",
                                    data=out.encode())
            expect(f"damage {k}", code == 1 and '"ok":true' not in report, (code, report, err))
    print(f"damage: {len(cases)} logs, {read_back} read")
    expect("damage", 50 < read_back < len(cases))


def touches(box, a, b):
    """Whether the closed segment meets the closed box, in fractions."""
    low, high = Fraction(0), Fraction(1)
    for i in range(3):
        step = b[i] - a[i]
        if step == 0:
            if not box[i] <= a[i] <= box[i + 3]:
                return False
            continue
        enter, leave = sorted(((box[i] - a[i]) / step, (box[i + 3] - a[i]) / step))
        low, high = max(low, enter), min(high, leave)
    return low <= high


def in_the_air(box, points):
    """The points but for those at the beginning and the end at which a vehicle stands on the box."""
    def stands(p):
        return all(box[i] <= p[i] <= box[i + 3] for i in (0, 1)) and box[5] - 0.5 <= p[2] <= box[5] + 1

    def beside(spot, p):
        return math.hypot(p[0] - spot[0], p[1] - spot[1]) <= 2 and abs(p[2] - spot[2]) <= 1.5

    begin, end = 0, len(points)
    while stands(points[0]) and begin < end and beside(points[0], points[begin]):
        begin += 1
    while stands(points[-1]) and end > begin and beside(points[-1], points[end - 1]):
        end -= 1
    return points[begin:end]


def check_verdicts(folder, flights):
    """No flight that touches in the air is called sampled, and none that keeps 1e-6 m away is refused."""
    dice = random.Random(11)
    box = [10, 10, 0, 20, 20, 30]
    header = run("skyway-import-flight", "-", "-q", data=bytes(hop()))[1].split("\n")[0].removesuffix(",battery_share,end")
    lines, truth = [header], {}
    for k in range(flights):
        points = [[dice.choice((dice.uniform(0, 30), dice.randrange(0, 31), 9, 21)) for _ in range(2)] +
                  [dice.choice((dice.uniform(1, 40), 31, 15))] for _ in range(dice.randrange(1, 5))]
        for i, p in enumerate(points):
            lines.append(",".join([f"f{k}", str(0.5 * i), *map(repr, map(float, p))] + [""] * 23))
        exact = [[Fraction(float(v)) for v in p] for p in in_the_air(box, points)]
        legs = list(zip(exact, exact[1:])) or [(p, p) for p in exact]
        half = 1  # the vehicle's
        grown = [Fraction(v) - half for v in box[:3]] + [Fraction(v) + half for v in box[3:]]
        far = Fraction(1, 10 ** 6)
        larger = [v - far for v in grown[:3]] + [v + far for v in grown[3:]]
        truth[f"f{k}"] = (any(touches(grown, a, b) for a, b in legs), any(touches(larger, a, b) for a, b in legs))
    code, out, err = run("skyway-check", folder / "m", "-", "--file-format", "flight-log", "--vehicle", "box:1,1,1", "-q",
                         data=("\n".join(lines) + "\n").encode())
    expect("verdicts", code == 1 and '"ok":true' not in out, err)
    reports = [json.loads(line) for line in out.splitlines()]
    expect("verdicts", len(reports) == flights, len(reports))
    for report in reports:
        touched, near = truth[report["id"]]
        expect("verdicts", not (touched and report["reason"] == "sampled"), report)
        expect("verdicts", near or report["reason"] == "sampled", report)
    # What an option accepts touches nothing and, where that was asked, kept its distance.
    log = ("\n".join(lines) + "\n").encode()
    for option in (["--sampled"], ["--require-clearance", "0.5"]):
        code, out, err = run("skyway-check", folder / "m", "-", "--vehicle", "box:1,1,1", "-q", *option, data=log)
        expect("verdicts", code == 1 and '"ok":true' not in out, "a log that does not say its map")
        code, out, err = run("skyway-check", folder / "m", "-", "--vehicle", "box:1,1,1", "-q", "--override", *option, data=log)
        reports = [json.loads(line) for line in out.splitlines()]
        expect("verdicts", code == (0 if all(r["ok"] for r in reports) else 1) and len(reports) == flights, (option, code, err))
        for report in reports:
            touched, near = truth[report["id"]]
            kept = report["clearance"] >= 0.5 if "clearance" in report else False
            accepted = report["samples"] > 1 and not touched and (option == ["--sampled"] or kept)  # one place is no flight
            expect("verdicts", report["ok"] == accepted or near and not touched, (option, report))
            expect("verdicts", not (report["ok"] and (touched or report["samples"] == 1)), (option, report))
    count = sum(touched for touched, _ in truth.values())
    print(f"verdicts: {flights} flights, {count} touch")
    expect("verdicts", 300 < count < flights - 300, count)


with tempfile.TemporaryDirectory() as name:
    check_places()
    check_real()
    check_damage(pathlib.Path(name))
    check_verdicts(pathlib.Path(name), int(sys.argv[2]) if len(sys.argv) > 2 else 3000)
for line in wrong[:40]:
    print("wrong:", line)
sys.exit(bool(wrong))
