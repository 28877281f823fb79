"""contingencies_test.py BIN_DIR: why ways home hold from every instant holds for the independent verifier, and not once tampered
with."""

import copy
import json
import os
import random
import tempfile

from other_flights import tampered_of_record
from tool_runs import read, tool, write
from verify_certificate import BoxMap, Refused
from verify_contingencies import verify

random.seed(12)
PADS = [(120, 120), (-120, 100), (0, -130)]


def make_map():
    """A town of towers and houses, with room around its pads."""
    with open("town.csv", "w", encoding="utf-8") as file:
        file.write("lat0 37.792480, lon0 -122.397450\nposX,posY,posZ,halfSizeX,halfSizeY,halfSizeZ\n")
        for _ in range(40):
            x, y = random.uniform(-110, 110), random.uniform(-110, 110)
            if any(max(abs(x - a), abs(y - b)) < 20 for a, b in PADS):
                continue
            height = random.choice((random.uniform(3, 8), random.uniform(15, 28)))
            file.write(f"{x},{y},{height},{random.uniform(2, 9)},{random.uniform(2, 9)},{height}\n")
    tool("skyway-import", "town.csv", "-q", "--bounds=-300,-300,0,300,300,150", "-o", "m.boxmap")
    with open("pads.geojson", "w", encoding="utf-8") as file:
        point = lambda i, place: {"type": "Feature", "properties": {"id": f"pad-{i}"}, "geometry": {"type": "Point", "coordinates": place}}
        json.dump({"type": "FeatureCollection", "features": [point(i, place) for i, place in enumerate(PADS)]}, file)
    with open("quad.json", "w", encoding="utf-8") as file:
        json.dump({"name": "quad", "body": [0.4, 0.4, 0.15], "tilt_max_deg": 20, "limits": {"vmax": 6}, "mass_kg": 2, "battery_wh": 120,
                   "endurance_s": 1500, "energy": {"climb_w": 330, "reserve": 0.2, "wind_m_s": 2}}, file)


def flight(name):
    """Bends between a few places, at rest at each; lower than the towers."""
    places = [[random.uniform(-100, 100), random.uniform(-100, 100), random.uniform(20, 62)] for _ in range(3)]
    along = lambda a, b: [a, a, a, a + (b - a) / 4, b - (b - a) / 4, b, b, b]
    return {"type": "trajectory", "id": name, "status": "solved", "vehicle": {"name": "v", "half": [0.5, 0.5, 0.3]}, "margin": 0.25,
            "segments": [{"duration": 60, **{axis: along(a[i], b[i]) for i, axis in enumerate("xyz")}}
                         for a, b in zip(places, places[1:])]}


def path(name):
    return {"type": "path", "id": name, "status": "found", "vehicle": {"name": "v", "half": [0.5, 0.5, 0.3]}, "margin": 0.25,
            "points": [[random.uniform(-100, 100), random.uniform(-100, 100), random.uniform(20, 62)] for _ in range(4)],
            "hold": [0, 2, 0, 0]}


def proved(records, *options):
    """Flights whose ways home the check accepts, with these and the certificates."""
    write("in.jsonl", records)
    tool("skyway-plan", "m.boxmap", "--home", "pads.geojson", "--home-local", "in.jsonl", "--autopilot", "px4:1.17", "-o", "home.jsonl", "-q",
         *options, codes=(0, 1))
    tool("skyway-check", "m.boxmap", "in.jsonl", "--contingencies", "home.jsonl", "--autopilot", "px4:1.17", "--certificate", "c.jsonl",
         "-o", "r.jsonl", "-q", *options, codes=(0, 1))
    found = {line["id"]: line for line in read("c.jsonl")}
    reports = read("r.jsonl")
    assert set(found) == {line["id"] for line in reports if line["ok"]}, (set(found), reports)
    assert all(line["exact"]["ok"] for line in reports if "exact" in line), reports
    ways = lambda record: [one for one in read("home.jsonl") if one["id"] == record["id"]]
    return [(record, found[record["id"]], ways(record)) for record in records if record["id"] in found]


def holds(record, certificate, contingencies):
    try:
        verify(record, certificate, contingencies, box_map)
        return True
    except Refused:
        return False


# ---- Tampering: each makes a change that must be refused, or False where the certificate has no place for it.

def a_join(certificate):
    way = random.choice(certificate["ways"])
    return way, random.choice(way["joins"])


def a_leg(certificate):
    found = [way for way in certificate["ways"] if way["beyond"]]
    return random.choice(found) if found else None


def drop_way(certificate, ways):
    certificate["ways"].pop(random.randrange(len(certificate["ways"])))


def drop_contingency(certificate, ways):
    at = random.randrange(len(ways))
    ways.pop(at)
    certificate["ways"].pop(at)


def drop_join(certificate, ways):
    way, join = a_join(certificate)
    if join["from"] == join["until"]:
        return False
    way["joins"].remove(join)


def shorten_join(certificate, ways):
    way, join = a_join(certificate)
    if join["until"] - join["from"] < 1e-3 or join["until"] > way["until"] or join["from"] < way["from"]:
        return False
    join["until"] -= 1e-4


def shorten_way(certificate, ways):
    at = random.randrange(len(ways))
    certificate["ways"][at]["until"] -= 1e-3


def longer_contingency(certificate, ways):
    random.choice(ways)["until"] += 1


def other_points(certificate, ways):
    random.choice(random.choice(ways)["points"])[0] += 1


def move_way(certificate, ways):
    """Of both, through the ground or through a building."""
    at = random.randrange(len(ways))
    point = random.randrange(len(ways[at]["points"]))
    box = random.choice(box_map.boxes)
    place = [0.5 * (a + b) for a, b in zip(box[:3], box[3:])]
    for one in (ways[at], certificate["ways"][at]):
        one["points"][point] = place


def above_ground(certificate, ways):
    at = random.randrange(len(ways))
    for one in (ways[at], certificate["ways"][at]):
        one["points"][-1][2] += 0.5


def slanting_landing(certificate, ways):
    at = random.randrange(len(ways))
    for one in (ways[at], certificate["ways"][at]):
        one["points"][-1][0] += 0.01


def move_braking(certificate, ways):
    _, join = a_join(certificate)
    by = random.choice((-1, 1)) * 200
    join["braking"]["plan"] = [[x + by, y] for x, y in join["braking"]["plan"]]


def lift_braking(certificate, ways):
    _, join = a_join(certificate)
    join["braking"]["low"] += 20
    join["braking"]["high"] += 20


def thin_braking(certificate, ways):
    _, join = a_join(certificate)
    if max(abs(p[0] - join["where"][0][0]) for p in join["where"]) < 1e-3:
        return False
    join["braking"]["plan"] = [join["where"][0][:2]]


def wide_braking(certificate, ways):
    """Over a whole block, or out of the bounds."""
    _, join = a_join(certificate)
    join["braking"]["plan"] = [[-400, -400], [400, -400], [400, 400], [-400, 400]]


def high_braking(certificate, ways):
    _, join = a_join(certificate)
    join["braking"]["high"] = 150


def over_a_tower(certificate, ways):
    """The region reaches a building: its other parts stay."""
    _, join = a_join(certificate)
    box = max(box_map.boxes, key=lambda box: box[5])
    join["braking"]["plan"] = [[box[0], box[1]], [box[3], box[1]], *join["braking"]["plan"]]
    join["braking"]["low"] = min(join["braking"]["low"], box[5] - 1)


def no_beyond(certificate, ways):
    way = a_leg(certificate)
    if not way:
        return False
    way["beyond"].pop()


def short_beyond(certificate, ways):
    way = a_leg(certificate)
    if not way:
        return False
    at = random.randrange(len(way["beyond"]))
    end = way["points"][at + 1]
    way["beyond"][at] = {"plan": [end[:2]], "low": end[2], "high": end[2]}


def short_overshoot(certificate, ways):
    way, join = a_join(certificate)
    first = way["points"][0]
    join["beyond"] = {"plan": [first[:2]], "low": first[2], "high": first[2]}


def wide_overshoot(certificate, ways):
    _, join = a_join(certificate)
    join["beyond"]["low"] = -5


def less_room(certificate, ways):
    axis = random.randrange(3)
    certificate["half"][axis] -= random.choice((1e-9, 0.1))


def less_margin(certificate, ways):
    certificate["margin"] -= 0.01
    certificate["half"] = [h - 0.01 for h in certificate["half"]]


def other_map(certificate, ways):
    certificate["map"] = "sha256:" + "0" * 64


def other_bounds(certificate, ways):
    certificate["bounds"][1][2] += 1


def elsewhere(certificate, ways):
    _, join = a_join(certificate)
    join["where"][0] = [join["where"][0][0] + 300, *join["where"][0][1:]]


def other_kind(certificate, ways):
    certificate["of"] = {"path": "trajectory", "trajectory": "path"}[certificate["of"]]


def weak_battery(certificate, ways):
    certificate["flying_time"] = max(join["lasts"] for way in certificate["ways"] for join in way["joins"])


def late_departure(certificate, ways):
    way = random.choice(ways)
    way["latest_departure"] = random.choice((None, 0.5 * (way["from"] + way["until"])))


TAMPERINGS = (drop_way, drop_contingency, drop_join, shorten_join, shorten_way, longer_contingency, other_points, move_way, above_ground,
              slanting_landing, move_braking, lift_braking, thin_braking, wide_braking, high_braking, over_a_tower, no_beyond, short_beyond,
              short_overshoot, wide_overshoot, less_room, less_margin, other_map, other_bounds, elsewhere, other_kind, weak_battery,
              late_departure)


os.chdir(tempfile.mkdtemp())
make_map()
box_map = BoxMap("m.boxmap")
cases = proved([flight(f"f{i}") for i in range(9)])
cases += proved([flight(f"e{i}") for i in range(6)], "--vehicle", "quad.json")
cases += proved([path(f"p{i}") for i in range(9)], "--vmax", "4")
tried, accepted = {}, []
for record, certificate, contingencies in cases:
    verify(record, certificate, contingencies, box_map)
    for tampering in TAMPERINGS:
        for _ in range(2):
            changed, ways = copy.deepcopy(certificate), copy.deepcopy(contingencies)
            if tampering(changed, ways) is False or (changed == certificate and ways == contingencies):
                continue
            tried[tampering.__name__] = tried.get(tampering.__name__, 0) + 1
            if holds(record, changed, ways):
                accepted.append((record["id"], tampering.__name__))
    for _ in range(3):
        tried["record"] = tried.get("record", 0) + 1
        if holds(tampered_of_record(record), certificate, contingencies):
            accepted.append((record["id"], "another record"))
assert len(cases) >= 6 and {certificate["of"] for _, certificate, _ in cases} == {"path", "trajectory"}, len(cases)
assert any("flying_time" in certificate for _, certificate, _ in cases)
assert set(tried) == {t.__name__ for t in TAMPERINGS} | {"record"}, set(TAMPERINGS) - set(tried)
assert not accepted, accepted
print(f"{len(cases)} certificates hold; {sum(tried.values())} changes are refused")
