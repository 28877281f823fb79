"""verify_folder.py FOLDER: follows the claims of a folder of skyway-submit, without any code of Skyway.

Python's standard library is enough. The script works out

- the SHA-256 of every file, and that no file is missing or is not in manifest.json;
- the certificates of all trajectories in exact fractions (verify_certificate.py, beside this script), and of
  pairs of them, where the folder says that all keep apart (verify_together.py);
- at many instants of each trajectory, and at all its joints, that a volume of that time holds the box of
  the vehicle with the buffer and its margin or, where there is one, its proved tube;
- that a tube of tubes.jsonl is proved, of this very trajectory (by its hash) and as long as it; the proof
  of the tube itself is not in the folder;
- how far contingency volumes and ground risk buffers reach around what they are around, from the numbers
  of the formulas;
- the people in all cells of population.csv that a ground risk buffer touches, how many of these have no number,
  and that the cells hold every buffer whole;
- of claims.jsonl all but clearances and returns, which the verdict names; no flight is below the ground;
- that the box of each vehicle has room for two points as far apart as the operation says.

It reads no page: summary.html and page.html count as files alone, and the verdict names them, as it does zones
and doubts of submission.json, which skyway-check FOLDER compares with the map's history. skyway-check FOLDER
proves that summary.html says what the other files say. Nothing in the folder shows that population.csv is of
the raster that submission.json names.

It does not know how autopilots fly: of a mission (a flight of the kind "mission") it follows the files, the
sizes of contingency volumes and ground risk buffers for the speed that the claims say, and the people, but not
where and how fast the mission is flown, its clearance, its time and its energy. It says so, and skyway-check
FOLDER proves these.

Places are brought to metres by a projection of its own (an equirectangular one with the ellipsoid's two
radii at the middle of a polygon), so lengths agree to some centimetres: TOLERANCE says how much is let
pass. Exit 0 if all of this holds, 1 if something does not, with the file and the reason; 2 for wrong
usage; 3 if a file is not what it should be.
"""

import hashlib
import json
import math
import operator
import os
import struct
import subprocess
import sys
from collections import Counter
from datetime import datetime, timezone
from fractions import Fraction

GRAVITY = 9.80665
TOLERANCE = 0.05  # m
INSTANTS = 24  # of each segment
BEND = 4e-3  # of a cell's longest side: more than its edges may bend
A, F = 6378137.0, 1 / 298.257223563
E2 = F * (2 - F)


class Refused(Exception):
    pass


def require(holds, file, what):
    if not holds:
        raise Refused(f"{file}: {what}")


# ---- files

def once(pairs):
    """An object whose keys all differ: of two members of one key, readers see one or the other."""
    if len({key for key, _ in pairs}) < len(pairs):
        raise ValueError(f"a key stands twice in {[key for key, _ in pairs]}"[:100])
    return dict(pairs)


def no_number(word):
    raise ValueError(f"{word} is no number")


def parsed(text):
    return json.loads(text, object_pairs_hook=once, parse_constant=no_number)


def parsed_file(folder, name):
    with open(os.path.join(folder, name), encoding="utf-8") as file:
        return parsed(file.read())


def listed(folder):
    manifest = parsed_file(folder, "manifest.json")
    names = [one["path"] for one in manifest["files"]]
    require(len(set(names)) == len(names), "manifest.json", "a file comes twice")
    return {one["path"]: one for one in manifest["files"]}


def check_files(folder):
    files = listed(folder)
    found = set()
    for where, folders, names in os.walk(folder):
        for name in folders + names:
            path = os.path.relpath(os.path.join(where, name), folder).replace(os.sep, "/")
            require(not os.path.islink(os.path.join(where, name)), path, "it is a link, and no file")
        for name in names:
            path = os.path.relpath(os.path.join(where, name), folder).replace(os.sep, "/")
            if path != "manifest.json":
                found.add(path)
    for path in sorted(set(files) | found):
        require(path in found, path, "it is missing")
        require(path in files, path, "it is not in the manifest")
        data = open(os.path.join(folder, path), "rb").read()
        require(hashlib.sha256(data).hexdigest() == files[path]["sha256"], path, "it was changed")
    return found


def lines(folder, name):
    path = os.path.join(folder, name)
    if not os.path.exists(path):
        return []
    return [parsed(line) for line in open(path, encoding="utf-8") if line.strip()]


# ---- places

def metres(origin_lat, lat, lng, lat0, lng0):
    """East and north of (lat0, lng0), by the ellipsoid's radii between the two latitudes."""
    s = math.sin(math.radians((lat + lat0) / 2))
    w = 1 - E2 * s * s
    north = A * (1 - E2) / w ** 1.5 * math.radians(lat - lat0)
    east = A / math.sqrt(w) * math.cos(math.radians(lat)) * math.radians(lng - lng0)
    return east, north


def geodetic(origin, east, north):
    """The place so many metres east and north: a transverse Mercator projection of scale 1, inverted to
    the third order about the origin, and refined by projecting again."""
    lat, lng = origin[0], origin[1]
    for _ in range(12):
        e, n = transverse_mercator(origin, lat, lng)
        s = math.sin(math.radians(lat))
        w = 1 - E2 * s * s
        lat += math.degrees((north - n) / (A * (1 - E2) / w ** 1.5))
        lng += math.degrees((east - e) / (A / math.sqrt(w) * math.cos(math.radians(lat))))
    return lat, lng


def meridian(lat):
    """Metres from the equator: Helmert's series in n = f / (2 - f)."""
    n = F / (2 - F)
    p = math.radians(lat)
    a0 = 1 + n ** 2 / 4 + n ** 4 / 64
    a2 = 1.5 * (n - n ** 3 / 8)
    a4 = 15 / 16 * (n ** 2 - n ** 4 / 4)
    a6 = 35 / 48 * n ** 3
    a8 = 315 / 512 * n ** 4
    return A / (1 + n) * (a0 * p - a2 * math.sin(2 * p) + a4 * math.sin(4 * p) - a6 * math.sin(6 * p)
                          + a8 * math.sin(8 * p))


def transverse_mercator(origin, lat, lng):
    """East and north of the origin (Snyder, Map Projections, 8-9 and 8-10)."""
    p, dl = math.radians(lat), math.radians(lng - origin[1])
    ep2 = E2 / (1 - E2)
    nu = A / math.sqrt(1 - E2 * math.sin(p) ** 2)
    t, c, a = math.tan(p) ** 2, ep2 * math.cos(p) ** 2, dl * math.cos(p)
    east = nu * (a + (1 - t + c) * a ** 3 / 6 + (5 - 18 * t + t * t + 72 * c - 58 * ep2) * a ** 5 / 120)
    north = meridian(lat) - meridian(origin[0]) + nu * math.tan(p) * (
        a * a / 2 + (5 - t + 9 * c + 4 * c * c) * a ** 4 / 24
        + (61 - 58 * t + t * t + 600 * c - 330 * ep2) * a ** 6 / 720)
    return east, north


def outward(ring):
    """Edges of a convex ring in metres: (point, unit normal outward)."""
    area = sum(a[0] * b[1] - a[1] * b[0] for a, b in zip(ring, ring[1:] + ring[:1]))
    sign = 1 if area > 0 else -1
    edges = []
    for a, b in zip(ring, ring[1:] + ring[:1]):
        dx, dy = b[0] - a[0], b[1] - a[1]
        length = math.hypot(dx, dy)
        if length > 0:
            edges.append((a, (sign * dy / length, -sign * dx / length)))
    return edges


def room_around(outer, inner):
    """How far the inner ring stays inside every edge of the outer one, m; below 0 where it does not."""
    return min(-max((p[0] - a[0]) * n[0] + (p[1] - a[1]) * n[1] for p in inner) for a, n in outward(outer))


def disjoint(one, other, room=0.0):
    for ring, points in ((one, other), (other, one)):
        for a, n in outward(ring):
            if min((p[0] - a[0]) * n[0] + (p[1] - a[1]) * n[1] for p in points) > room:
                return True
    return False


# ---- volumes

def instant(text):
    return datetime.fromisoformat(text.replace("Z", "+00:00")).astimezone(timezone.utc)


def ring_of(places, origin):
    return [transverse_mercator(origin, lat, lng) for lat, lng in places]


def intent_volumes(folder, name, origin, key):
    out = []
    for one in parsed_file(folder, name).get(key, []):
        space = one["volume"]
        places = [(v["lat"], v["lng"]) for v in space["outline_polygon"]["vertices"]]
        out.append({"ring": ring_of(places, origin), "low": space["altitude_lower"]["value"],
                    "high": space["altitude_upper"]["value"], "from": instant(one["time_start"]["value"]),
                    "until": instant(one["time_end"]["value"])})
    return out


def risk_volumes(folder, name, origin):
    out = {"flight geography": [], "contingency volume": [], "ground risk buffer": []}
    for one in parsed_file(folder, name)["features"]:
        said = one["properties"]
        places = [(lat, lng) for lng, lat in one["geometry"]["coordinates"][0][:-1]]
        out[said["volume"]].append({"ring": ring_of(places, origin), "low": said["lower_m"],
                                    "high": said["upper_m"], "from": instant(said["from"]),
                                    "until": instant(said["until"]), "said": said})
    return out


# Of each instant of a segment, the shares of its eight control points.
SHARES = [[math.comb(7, i) * (k / INSTANTS) ** i * (1 - k / INSTANTS) ** (7 - i) for i in range(8)]
          for k in range(INSTANTS + 1)]


def places_of(record, enu):
    """Times after the start and places (east, north, up), at many instants."""
    begin = 0.0
    for segment in record["segments"]:
        axes = [segment[axis] for axis in ("xyz" if enu else "yxz")]
        for k, shares in enumerate(SHARES):
            yield begin + k / INSTANTS * segment["duration"], [sum(map(operator.mul, shares, points)) for points in axes]
        begin += segment["duration"]


def sides_for(ring, room):
    """Of each edge (x, y, most): the middle p of a box of half sizes `room` has p . (x, y) <= most where all of the box is inside."""
    return [(x, y, a[0] * x + a[1] * y - abs(x) * room[0] - abs(y) * room[1] + TOLERANCE / 10) for a, (x, y) in outward(ring)]


def check_held(record, volumes, method, claims, enu):
    stray = claims["tube"]["largest"] if "tube" in claims else claims["margin"]
    room = [h + stray + method["around"] for h in claims["half"]]
    if not enu:
        room[0], room[1] = room[1], room[0]
    begin = instant(record["epoch"]).timestamp() + record["start"]
    height = method["origin"][2]
    spaces = [(v["from"].timestamp() - 1e-6, v["until"].timestamp() + 1e-6, v["low"] - height - 1e-6 + room[2],
               v["high"] - height + 1e-6 - room[2], sides_for(v["ring"], room)) for v in volumes]
    for seconds, (east, north, up) in places_of(record, enu):
        now = begin + seconds
        there = [space for space in spaces if space[0] <= now <= space[1]]
        if not there:
            raise Refused(f"{claims['volumes']}: no volume is there {seconds:.3f} s after the start")
        if not any(low <= up <= high and all(east * x + north * y <= most for x, y, most in sides) for _, _, low, high, sides in there):
            raise Refused(f"{claims['volumes']}: no volume holds the vehicle {seconds:.3f} s after the start")


def contingency_size(risk, speed):
    if risk["contingency"] == "return":
        return 0.0, 0.0
    errors = risk["position_error"] + risk["holding_error"] + risk["map_error"]
    stop = speed ** 2 / (2 * GRAVITY * math.tan(risk["tilt"]))
    return (errors + speed * risk["reaction"] + stop,
            risk["altitude_error"] + 0.7072 * speed * risk["reaction"] + speed ** 2 / (2 * GRAVITY))


def ground_buffer(risk, speed, height):
    fall = height if risk["buffer"] == "1:1" else speed * math.sqrt(2 * height / GRAVITY)
    return fall + risk["dimension"] / 2


def check_around(outer, inner, across, vertical, file, what):
    require(outer["from"] <= inner["from"] and outer["until"] >= inner["until"], file, f"{what} is not there all the time")
    require(outer["low"] <= inner["low"] - vertical + 0.011 and outer["high"] >= inner["high"] + vertical - 0.011,
            file, f"{what} does not reach {vertical:.2f} m up and down")
    have = room_around(outer["ring"], inner["ring"])
    require(have >= across - TOLERANCE, file, f"{what} reaches {have:.2f} m around, expected {across:.2f} m")


def check_risk(risk, nominal, off_nominal, method, claims):
    file, rules, speed = claims["risk"], method["risk"], claims["speed"]
    across, vertical = contingency_size(rules, speed)
    inner = nominal + (off_nominal if rules["contingency"] == "return" else [])
    contingency, buffers = risk["contingency volume"], risk["ground risk buffer"]
    require(len(contingency) == len(inner) == len(buffers), file, "volumes are missing")
    for i, (volume, around, buffer) in enumerate(zip(inner, contingency, buffers)):
        check_around(around, volume, across, vertical, file, f"contingency volume {i}")
        height = max(0.0, around["high"] - method["origin"][2] - method["floor"])
        require(buffer["said"]["height_m"] >= height - 1e-6, file, f"buffer {i} counts from too low a top")
        wide = ground_buffer(rules, speed, height)
        require(buffer["said"]["buffer_m"] >= wide - 1e-6, file, f"buffer {i} is too narrow")
        have = room_around(buffer["ring"], around["ring"])
        require(have >= wide - TOLERANCE, file, f"ground risk buffer {i} reaches {have:.2f} m, expected {wide:.2f} m")
    return buffers


# ---- people
def require_cells(rows):
    """Each row has a place and no fewer than nobody, and together they are all cells of some rows and columns."""
    file, known = "population.csv", {(int(fields[0]), int(fields[1])) for fields in rows}
    require(all(len(fields) == 11 for fields in rows), file, "a line has not 11 fields")
    require(all(fields[2] == "" or 0 <= float(fields[2]) <= 1e10 for fields in rows), file, "people are no number from 0 to 1e10")
    sides = [max(place) - min(place) + 1 for place in zip(*known)]
    require(known and len(rows) == len(known) == math.prod(sides), file, "a cell is missing or comes twice")


def population(folder, origin):
    """The cells of a population raster, and the edges that only one of them has."""
    path = os.path.join(folder, "population.csv")
    if not os.path.exists(path):
        return None
    cells, edges = [], Counter()
    rows = [line.split(",") for line in open(path, encoding="utf-8").read().splitlines()[1:]]
    require_cells(rows)
    for fields in rows:
        places = [(float(fields[4 + 2 * i]), float(fields[3 + 2 * i])) for i in range(4)]
        nodes = [(round(lat, 8), round(lng, 8)) for lat, lng in places]
        edges.update(frozenset(pair) for pair in zip(nodes, nodes[1:] + nodes[:1]))
        ring = ring_of(places, origin)
        cells.append((ring, float(fields[2]) if fields[2] else None, *extent(ring)))
    border = [ring_of(sorted(edge), origin) for edge, count in edges.items() if count == 1]
    return cells, [(edge, *extent(edge)) for edge in border]


def extent(ring):
    return min(p[0] for p in ring), max(p[0] for p in ring), min(p[1] for p in ring), max(p[1] for p in ring)


def touching(ring, others, room=0.0):
    """Those of the others that the ring comes nearer to than `room`."""
    w, e, s, n = extent(ring)
    return [one for one in others
            if not (one[-3] < w - room or e < one[-4] - room or one[-1] < s - room or n < one[-2] - room
                    or disjoint(one[0], ring, room))]


def counts(cells):
    """The people in these cells, and how many of them have no number."""
    people = [cell[1] for cell in cells.values()]
    return sum(one or 0 for one in people), people.count(None)


def people_below(population, buffers, file):
    """The counts of all cells that a buffer touches, and of those that are as near as cells may bend; cells must hold each buffer."""
    cells, border = population
    below, near = {}, {}
    widest = max(math.dist(a, b) for cell in cells for a, b in zip(cell[0], cell[0][1:] + cell[0][:1]))
    for buffer in buffers:
        ring = buffer["ring"]
        touched = touching(ring, cells)
        middle = [sum(p[axis] for p in ring) / len(ring) for axis in (0, 1)]
        held = any(room_around(cell[0], [middle]) >= -1e-6 for cell in touched)
        require(held and not touching(ring, border), file, "the cells do not hold a ground risk buffer")
        below.update((id(cell), cell) for cell in touched)
        near.update((id(cell), cell) for cell in touching(ring, cells, 2 * TOLERANCE + BEND * widest))
    return counts(below), counts(near)


# ---- all of it

def check_sizes(claims, method, nominal, buffers):
    file, (across, vertical) = "claims.jsonl", contingency_size(method["risk"], claims["speed"])
    top = max([0.0, *(v["high"] - method["origin"][2] - method["floor"] for v in nominal)])
    for key, size in (("contingency_across", across), ("contingency_vertical", vertical), ("top", top),
                      ("buffer", max(b["said"]["buffer_m"] for b in buffers))):
        require(abs(claims[key] - size) <= 1e-6 * max(1, size), file, f"{claims['id']}: {key} is {size}")


def check_claims(record, claims, method, certificate):
    file, duration = "claims.jsonl", float(sum(Fraction(s["duration"]) for s in record["segments"]))
    require(abs(claims["duration"] - duration) <= 1e-9 * max(1, duration), file, f"{claims['id']} lasts {duration} s")
    begin = instant(record["epoch"]).timestamp() + record["start"]
    begins, ends = (instant(claims[key]).timestamp() for key in ("begins", "ends"))
    require(-1e-6 <= begin - begins <= 0.0011, file, f"{claims['id']} begins at another time")
    require(-1e-6 <= ends - begin - duration <= 0.0011, file, f"{claims['id']} ends at another time")
    vehicle, most = certificate["vehicle"], [certificate["limits"].get(key, math.inf) for key in ("vmax", "vmax_h", "vmax_v")]
    speed = min(most[0], math.hypot(*most[1:]))
    half = record.get("vehicle", vehicle)["half"]
    require([claims["vehicle"], claims["half"], half] == [vehicle["name"], vehicle["half"], vehicle["half"]], file, "the vehicle is another")
    require(claims["margin"] == certificate["margin"] >= record.get("margin", 0), file, "the margin is another")
    require(abs(claims["speed"] - speed) <= 1e-12 * speed, file, f"the certificate of {claims['id']} is for {speed} m/s")
    lowest = min(s["z"][end] for s in record["segments"] for end in (0, 7))
    require(lowest >= method["floor"] - 1, file, f"{claims['id']} comes down to z = {lowest}, below the floor of all ground")
    require(("energy" in claims) == ("energy" in method), file, "an energy without a battery, or a battery without one")
    if "energy" in method:
        energy = method["energy"]
        require(abs(claims["energy"] - energy["power"] * duration) <= 1e-6 * claims["energy"], file, "another energy follows")
        require(claims["energy"] <= energy["capacity"] * (1 - energy["reserve"]), file, "the battery does not last")
    if "endurance" in method:
        require(duration <= method["endurance"], file, "it flies longer than the vehicle can")


def check_method(method, claims):
    """Its numbers are such that skyway-check reads them, and the operation's dimension fits into the box of each vehicle."""
    file, risk = "submission.json", method["risk"]
    stops = ["position_error", "holding_error", "map_error", "altitude_error", "reaction"] if risk["contingency"] == "stop" else []
    sizes = [method["around"], *(risk[key] for key in ["dimension", *stops])]
    require(all(0 <= size <= 1e4 for size in sizes), file, "a size is no number from 0 to 10000")
    require(not stops or 1e-3 <= risk["tilt"] <= 1.55, file, "its tilt is no angle from 0.001 to 1.55 rad")
    require(-1e5 <= method["floor"] <= 1e5, file, "its floor is no height from -100000 to 100000 m")
    for one in claims:
        room = 2 * math.hypot(min(one["half"][:2]), one["half"][2])
        require(risk["dimension"] <= room * (1 + 1e-9), file, f"the box of {one['id']} has no room for a vehicle of {risk['dimension']} m")


def follow(folder, script, names):
    """Runs a script that stands beside this one, or in the folder `check` beside this one's."""
    here = os.path.dirname(os.path.abspath(__file__))
    path = os.path.join(here, script)
    if not os.path.exists(path):
        path = os.path.join(here, "..", "check", script)
    command = [sys.executable, "-B", path, *(os.path.join(folder, name) for name in names)]
    ran = subprocess.run(command, capture_output=True, text=True, check=False)
    require(ran.returncode == 0, names[-1], (ran.stdout + ran.stderr).strip().splitlines()[-1:])


def trajectory_hash(record):
    numbers = [float(len(record["segments"]))]
    for s in record["segments"]:
        numbers.append(float(s["duration"]))
        for i in range(8):
            numbers += [float(s[axis][i]) for axis in "xyz"]
        yaw = s.get("yaw")
        numbers += [8.0, *(float(y) for y in yaw)] if yaw else [0.0]
    return hashlib.sha256(struct.pack(f"<{len(numbers)}d", *(n + 0.0 for n in numbers))).hexdigest()


def check_tube(record, claims, tubes, tilt_most):
    file, said = "tubes.jsonl", claims["tube"]
    require(record["id"] in tubes, file, f"it has no tube of {record['id']}")
    tube = tubes[record["id"]]["proved_tube"]
    require(tube["ok"] is True and said["kind"] == "proved", file, f"the tube of {record['id']} is not proved")
    require(tube["trajectory"] == trajectory_hash(record), file, f"the tube of {record['id']} is of another trajectory")
    require(all(0 <= r < math.inf for r in tube["radius"]), file, "a radius is no length")
    require(max(tube["radius"]) == said["largest"], "claims.jsonl", f"the tube of {record['id']} is of another width")
    require(len(tube["radius"]) * tube["period"] >= claims["duration"] - 1e-9, file, f"the tube of {record['id']} is cut")
    require(tube["tilt"] <= tilt_most, file, f"{record['id']} tilts further than the half sizes hold")
    require(said["controller"] == tubes[record["id"]]["controller"], "claims.jsonl", "another controller flies")
    for key in set(said) - {"kind", "largest", "tilt", "controller"}:
        require(tube[key] == said[key], "claims.jsonl", f"the tube of {record['id']} is proved for another {key}")


def check_tubes(folder, method, records, claims):
    """Every trajectory has a proved tube where the method names the file of them; else none has."""
    if "tubes" not in method:
        require(all("tube" not in one for one in claims), "claims.jsonl", "it names tubes, and the method none")
        return
    data = open(os.path.join(folder, "tubes.jsonl"), "rb").read()
    require(hashlib.sha256(data).hexdigest() == method["tubes"]["sha256"], "tubes.jsonl", "it has another hash")
    tubes = {one["id"]: one for one in lines(folder, "tubes.jsonl")}
    for one in claims:
        require("tube" in one and one["kind"] == "trajectory", "claims.jsonl", f"{one['id']} has no tube")
        limits = records[one["id"]].get("vehicle", {}).get("limits", {})
        check_tube(records[one["id"]], one, tubes, limits.get("tilt", math.inf))


def check_certificates(folder, found):
    """The certificates by their ids."""
    if "flights.jsonl" not in found:
        return {}
    follow(folder, "verify_certificate.py", ["flights.jsonl", "map.boxmap", "certificates.jsonl"])
    return {one["id"]: one for one in lines(folder, "certificates.jsonl")}


def check_pairs(folder, found, submission, flights):
    """A folder that says which pairs come too near is honest, and no yes."""
    asked, said = submission["method"].get("together"), submission.get("pairs")
    require((asked is None) == (said is None) == ("pairs.jsonl" not in found), "submission.json", "pairs are missing")
    if asked is None:
        return
    records = lines(folder, "pairs.jsonl")
    pairs, together = records[:-1], records[-1]
    require(together["type"] == "together" and all(one["type"] == "pair" for one in pairs), "pairs.jsonl", "other records")
    require(said["too_near"] == len(pairs) == together["refused"], "pairs.jsonl", "another number of pairs")
    require(said["compared"] == together["pairs"] == flights * (flights - 1) // 2, "pairs.jsonl",
            "not all pairs were compared")
    require(not pairs, "pairs.jsonl", f"{len(pairs)} of {said['compared']} pairs of flights come too near, as the folder says itself")
    for key, sides in (("separation", asked.get("separation", asked.get("separation_box"))), ("downwash", asked.get("downwash"))):
        wanted = "vehicles" if key == "separation" else None
        if sides:
            reach = [sides[0], *sides] if len(sides) == 2 else sides
            wanted = {"shape": "cylinder" if len(sides) == 2 else "box", "reach": reach}
        require(together.get(key) == wanted, "pairs.jsonl", f"its {key} is another")
    require(together["parked"] == asked["parked"], "pairs.jsonl", "it is for other rests")
    follow(folder, "verify_together.py", ["flights.jsonl", "pair_certificates.jsonl"])


def check(folder):
    found = check_files(folder)
    submission = lines(folder, "submission.json")[0]
    method, claims = submission["method"], lines(folder, "claims.jsonl")
    origin, enu = method["origin"], submission["frame"] == "enu"
    flights = lines(folder, "flights.jsonl")
    records = {one["id"]: one for one in flights}
    require(len(records) == len(flights), "flights.jsonl", "an id comes twice")
    require(len({one["id"] for one in claims}) == len(claims), "claims.jsonl", "an id comes twice")
    require(len(claims) == submission["flights"], "claims.jsonl", "flights are missing")
    require(set(records) == {c["id"] for c in claims if c["kind"] == "trajectory"}, "claims.jsonl", "its flights are others")
    uas = parsed_file(folder, "operation.json")["uas"]
    same = [method["risk"]["dimension"], method.get("endurance")] == [uas["dimension_m"], uas.get("endurance_s")]
    require(same, "submission.json", "its dimension and endurance are not those of the operation")
    check_method(method, claims)
    require(("population" in submission) == ("population.csv" in found), "submission.json", "population.csv and its source are not both there")
    certificates = check_certificates(folder, found)
    check_pairs(folder, found, submission, len(records))
    check_tubes(folder, method, records, claims)
    cells = population(folder, origin)
    for one in claims:
        nominal = intent_volumes(folder, one["volumes"], origin, "volumes")
        off_nominal = intent_volumes(folder, one["volumes"], origin, "off_nominal_volumes")
        if one["kind"] == "trajectory":
            check_claims(records[one["id"]], one, method, certificates[one["id"]])
            check_held(records[one["id"]], nominal, method, one, enu)
        buffers = check_risk(risk_volumes(folder, one["risk"], origin), nominal, off_nominal, method, one)
        check_sizes(one, method, nominal, buffers)
        require(("people" in one) == (cells is not None), "claims.jsonl", "people without a raster of them, or a raster without people")
        if cells is not None:
            (below, unknown), (most, most_unknown) = people_below(cells, buffers, "population.csv")
            hair = 1e-6 * max(1, most)
            require(below - hair <= one["people"] <= most + hair, "claims.jsonl", f"{below} people are below {one['id']}")
            require(unknown <= one["people_unknown"] <= most_unknown, "claims.jsonl", f"{unknown} cells below {one['id']} have no number")
    unread = ["zones and doubts of the map"]
    if any("clearance" in one and one["kind"] == "trajectory" for one in claims):
        unread.append("clearance")
    if method["risk"]["contingency"] == "return":
        unread.append("returns and the off-nominal volumes that hold them")
    if cells is not None:
        unread.append(f"that population.csv is of {submission['population']['name']}")
    return claims, unread + sorted(path for path in found if path.endswith(".html"))


def verdict(claims, pages):
    missions = sum(one["kind"] == "mission" for one in claims)
    unread = f"; not looked at: {', '.join(pages)}" if pages else ""
    if not missions:
        return f"{len(claims)} flights: files, certificates, volumes and claims hold{unread}"
    return f"{len(claims)} flights, missions among them: {missions}; files, certificates and sizes hold; only skyway-check FOLDER " \
           f"proves where and how fast a mission is flown, its clearance, its time and its energy{unread}"


def main():
    if len(sys.argv) != 2:
        print(__doc__.splitlines()[0], file=sys.stderr)
        return 2
    try:
        claims, pages = check(sys.argv[1])
    except Refused as refusal:
        print(f"refused: {refusal}")
        return 1
    except (OSError, KeyError, ValueError, TypeError, IndexError) as error:
        print(f"{sys.argv[1]}: {type(error).__name__}: {error}")
        return 3
    print(verdict(claims, pages))
    return 0


if __name__ == "__main__":
    sys.exit(main())
