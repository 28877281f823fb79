"""returns_test.py BIN_DIR: why vehicles come home from every instant holds for the independent verifier, and not once tampered
with."""

import copy
import json
import os
import random
import tempfile

from other_flights import tampered_of_record
from tool_runs import read, tool, write
from verify_certificate import BoxMap, Refused
from verify_returns import verify

random.seed(11)


def make_maps():
    """A town whose houses are lower than 30 m; and one with a no-fly volume for a time."""
    with open("town.csv", "w", encoding="utf-8") as file:
        file.write("lat0 37.792480, lon0 -122.397450\nposX,posY,posZ,halfSizeX,halfSizeY,halfSizeZ\n")
        for _ in range(25):
            height = random.uniform(3, 15)
            file.write(f"{random.uniform(-150, 150)},{random.uniform(-150, 150)},{height},"
                       f"{random.uniform(2, 9)},{random.uniform(2, 9)},{height}\n")
    tool("skyway-import", "town.csv", "-q", "--bounds=-300,-300,0,300,300,150", "-o", "m.boxmap")
    with open("z.geojson", "w", encoding="utf-8") as file:
        json.dump({"type": "Feature", "properties": {"lower": 55, "upper": 90, "from": 5000, "until": 9000},
                   "geometry": {"type": "Polygon", "coordinates": [[[-40, -40], [40, -40], [40, 40], [-40, 40], [-40, -40]]]}}, file)
    tool("skyway-map", "patch", "m.boxmap", "--keep-out", "z.geojson", "--keep-out-local", "--epoch", "2026-05-04T06:30:00Z",
         "-o", "timed.boxmap")


def flight(name, **keys):
    """Bends between a few places above the houses, at rest at each."""
    places = [[random.uniform(-100, 100), random.uniform(-100, 100), random.uniform(36, 50)] for _ in range(3)]
    along = lambda a, b: [a, a, a, a + (b - a) / 4, b - (b - a) / 4, b, b, b]
    return {"type": "trajectory", "id": name, "status": "solved", "vehicle": {"name": "v", "half": [0.5, 0.5, 0.32]}, "margin": 0.25,
            "segments": [{"duration": 40, **{axis: along(a[i], b[i]) for i, axis in enumerate("xyz")}}
                         for a, b in zip(places, places[1:])], **keys}


def from_the_ground(name):
    """Straight up from a place without houses, and across."""
    record = flight(name)
    along = lambda a, b: [a, a, a, a + (b - a) / 4, b - (b - a) / 4, b, b, b]
    places = [[250, 250, 0.6], [250, 250, 40], [250, -250, 40]]
    record["segments"] = [{"duration": 60, **{axis: along(a[i], b[i]) for i, axis in enumerate("xyz")}} for a, b in zip(places, places[1:])]
    return record


def path(name):
    return {"type": "path", "id": name, "status": "found", "vehicle": {"name": "v", "half": [0.5, 0.5, 0.32]}, "margin": 0.25,
            "points": [[random.uniform(-100, 100), random.uniform(-100, 100), random.uniform(36, 50)] for _ in range(4)]}


def proved(map_file, records, *options):
    """What the check accepts, with its certificates."""
    write("in.jsonl", records)
    tool("skyway-check", map_file, "in.jsonl", "--certificate", "c.jsonl", "-o", "r.jsonl", "-q", "--no-least-height", *options,
         codes=(0, 1))
    found = {line["id"]: line for line in read("c.jsonl") if line["type"] == "returns"}
    ok = {line["id"] for line in read("r.jsonl") if line["ok"]}
    assert set(found) == ok, (set(found), ok)
    return [(record, found[record["id"]]) for record in records if record["id"] in found]


def proved_mission(name, file, export, *options):
    """A mission that skyway-export writes, as the path that it is read as, with its certificate."""
    write("p.jsonl", [path(name)])
    tool("skyway-export", "m.boxmap", "p.jsonl", "-o", file, "--speed", "4", "-q", *export)
    tool("skyway-import-trajectory", file, "--map", "m.boxmap", "--ground", "0", "-o", "in.jsonl")
    tool("skyway-check", "m.boxmap", file, "--ground", "0", "--vehicle", "box:0.5,0.5,0.32", "--margin", "0.2", "--return", *options, "--return-height", "60",
         "--no-least-height", "--certificate", "c.jsonl", "-o", "r.jsonl", "-q")
    (certificate,) = (line for line in read("c.jsonl") if line["type"] == "returns")
    assert certificate["of"] == "mission", certificate["of"]
    return read("in.jsonl")[0], certificate


def holds(record, certificate, box_map):
    try:
        verify(record, certificate, box_map)
        return True
    except Refused:
        return False


# ---- Tampering: each makes a change that must be refused, or nothing where the certificate has no place for it.

def pick(certificate):
    autopilot = random.choice(certificate["autopilots"])
    return autopilot, random.choice(autopilot["stages"])


def a_sweep(certificate, *phases):
    autopilot, stage = pick(certificate)
    found = [s for s in stage["sweeps"] if s["phase"] in phases]
    return random.choice(found) if found else None


def drop_stage(certificate, record):
    autopilot, stage = pick(certificate)
    if record["type"] == "path" and stage["from"] == stage["until"]:
        return False
    autopilot["stages"].remove(stage)


def shorten_stage(certificate, record):
    autopilot, stage = pick(certificate)
    if record["type"] == "path" or stage["until"] - stage["from"] < 1e-3:
        return False
    stage["until"] -= 1e-3


def drop_climb(certificate, record):
    autopilot, stage = pick(certificate)
    if certificate["action"] != "rtl":
        return False
    stage["sweeps"] = [s for s in stage["sweeps"] if s["phase"] != random.choice(("climb", "way"))]


def drop_descent(certificate, record):
    autopilot, stage = pick(certificate)
    if certificate["action"] == "hold":
        return False
    stage["sweeps"] = [s for s in stage["sweeps"] if s["phase"] not in ("descent", "landing")]


def drop_braking(certificate, record):
    autopilot, stage = pick(certificate)
    stage["sweeps"] = stage["sweeps"][1:]


def move_braking(certificate, record):
    sweep = a_sweep(certificate, "braking")
    by = random.choice((-1, 1)) * 500
    sweep["plan"] = [[x + by, y] for x, y in sweep["plan"]]


def lift_braking(certificate, record):
    sweep = a_sweep(certificate, "braking")
    sweep["low"] += 60
    sweep["high"] += 60


def lower_way(certificate, record):
    sweep = a_sweep(certificate, "way")
    if not sweep:
        return False
    sweep["low"] = -50


def raise_way(certificate, record):
    sweep = a_sweep(certificate, "way")
    if not sweep:
        return False
    sweep["high"] = 170


def widen_way(certificate, record):
    sweep = a_sweep(certificate, "way")
    if not sweep:
        return False
    sweep["plan"] = [[-400, -400], [400, -400], [400, 400], [-400, 400]]


def stand_high(certificate, record):
    sweep = a_sweep(certificate, "braking", "climb", "way", "descent")
    sweep["stands_on"] = 100


def less_room(certificate, record):
    autopilot, _ = pick(certificate)
    axis = random.randrange(3)
    autopilot["half"][axis] = (certificate["vehicle"]["half"][axis] + certificate["margin"]) * random.choice((0.5, 1))


def no_autopilot(certificate, record):
    certificate["autopilots"] = []


def twice(certificate, record):
    certificate["autopilots"].append(copy.deepcopy(certificate["autopilots"][0]))


def other_map(certificate, record):
    certificate["map"] = "sha256:" + "0" * 64


def other_bounds(certificate, record):
    certificate["bounds"][1][2] += 1


def home_in_the_air(certificate, record):
    if certificate["action"] == "hold":
        return False
    certificate["home"][2] += 3


def elsewhere(certificate, record):
    _, stage = pick(certificate)
    stage["where"][0] = [stage["where"][0][0] + 300, *stage["where"][0][1:]]


def other_action(certificate, record):
    certificate["action"] = {"hold": "rtl", "land": "rtl", "rtl": "fly"}[certificate["action"]]


def over_a_tower(certificate, record):
    """A region with a house inside of it."""
    sweep = a_sweep(certificate, "climb", "braking")
    low = random.choice([box for box in towers if box[5] > 10])
    sweep["plan"] = [[low[0], low[1]], [low[3], low[1]], [low[3], low[4]], [low[0], low[4]]]
    sweep["low"] = 5


def drop_leg(certificate, record):
    """Of a mission: all from which a return begins at the middle of a leg."""
    if certificate["of"] != "mission":
        return False
    autopilot, _ = pick(certificate)
    at = random.randrange(len(certificate["way"]) - 1)
    a, b = certificate["way"][at:at + 2]
    middle = [(p + q) / 2 for p, q in zip(a, b)]
    def reaches(stage):
        sides = list(zip(*stage["where"]))
        return all(min(side) - 1e-6 <= c <= max(side) + 1e-6 for side, c in zip(sides, middle))
    autopilot["stages"] = [stage for stage in autopilot["stages"] if not reaches(stage)]


def other_way(certificate, record):
    if certificate["of"] != "mission":
        return False
    random.choice(certificate["way"][1:-1])[random.randrange(3)] += random.choice((-1, 1)) * 1e-3


def shorter_way(certificate, record):
    if certificate["of"] != "mission":
        return False
    certificate["way"] = certificate["way"][2:]


OF_RECORDS = (drop_stage, shorten_stage, stand_high)  # stages of missions overlap, and what they stand on is only a hint
TAMPERINGS = (drop_leg, other_way, shorter_way, drop_stage, shorten_stage, drop_climb, drop_descent, drop_braking, move_braking, lift_braking, lower_way, raise_way,
              widen_way, stand_high, less_room, no_autopilot, twice, other_map, other_bounds, home_in_the_air, elsewhere,
              other_action, over_a_tower)


os.chdir(tempfile.mkdtemp())
make_maps()
tried, accepted = {}, []
count = 0
for map_file in ("m.boxmap", "timed.boxmap"):
    box_map = BoxMap(map_file)
    towers = BoxMap("m.boxmap").boxes
    keys = {} if map_file == "m.boxmap" else {"epoch": "2026-05-04T06:30:00Z", "start": 20000}
    flights = [flight(f"f{i}", **keys) for i in range(4)]
    if not keys:
        flights.append(from_the_ground("ground"))
    cases = proved(map_file, flights, "--return", "--return-height", "60")
    if map_file == "m.boxmap":
        cases += proved(map_file, flights, "--return", "hold")
        cases += proved(map_file, flights, "--return", "land", "--autopilot", "px4")
        cases += proved(map_file, [path(f"p{i}") for i in range(3)], "--return", "--return-height", "60", "--vmax", "4")
        cases.append(proved_mission("rally", "m.plan", ("--format", "qgc-plan", "--rally=120,120,20", "--fence", "auto", "--autopilot", "px4:1.17",
                                                        "--return-height", "60"), "--autopilot", "px4:1.17"))
        cases.append(proved_mission("wpl", "m.waypoints", ("--format", "wpl",)))
        cases.append(proved_mission("dji", "m.kmz", ("--format", "dji-wpml", "--aircraft", "m3e")))
    for record, certificate in cases:
        verify(record, certificate, box_map)
        count += 1
        for tampering in TAMPERINGS:
            if certificate["of"] == "mission" and tampering in OF_RECORDS:
                continue
            for _ in range(2):
                changed = copy.deepcopy(certificate)
                if tampering(changed, record) is False or changed == certificate:
                    continue
                tried[tampering.__name__] = tried.get(tampering.__name__, 0) + 1
                if holds(record, changed, box_map):
                    accepted.append((map_file, record["id"], certificate["action"], tampering.__name__))
        for _ in range(3):
            other = tampered_of_record(record)
            tried["record"] = tried.get("record", 0) + 1
            if holds(other, certificate, box_map):
                accepted.append((map_file, record["id"], certificate["action"], "another record"))
assert count >= 8, count
assert set(tried) == {t.__name__ for t in TAMPERINGS} | {"record"}, tried
assert not accepted, accepted
print(f"{count} certificates hold; {sum(tried.values())} changes are refused")
