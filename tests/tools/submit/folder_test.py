"""folder_test.py TOOLS SOURCE_DIR: folders of skyway-submit, and changed ones, which must be refused.

A folder with a trajectory, a mission and people is made. Then each of its files is changed, removed and added to; and
values within are changed by somebody who also writes a new manifest. skyway-check must refuse each, and verify_folder.py
what it looks at.
"""

import hashlib
import json
import os
import pathlib
import re
import shutil
import struct
import subprocess
import sys
import tempfile
import zipfile

tools = pathlib.Path(sys.argv[1])
source = pathlib.Path(sys.argv[2])
sys.path.insert(0, str(source / "tests/support"))
import schemas  # noqa: E402

EPOCH = "2026-05-04T06:30:00Z"


def run(*command, **more):
    return subprocess.run([str(part) for part in command], capture_output=True, text=True, check=False, **more)


def tool(name, *arguments):
    return run(tools / f"skyway-{name}", *arguments)


def make(where):
    """The city, a trajectory with times, and two folders: one with both kinds of contingency."""
    city, flights = where / "city.boxmap", where / "flights.jsonl"
    assert tool("import", source / "data/downtown.csv", "-q", "-o", city).returncode == 0
    lines = (source / "data/samples/trajectories.jsonl").read_text(encoding="utf-8").splitlines()
    timed = [line.replace('"status"', f'"epoch":"{EPOCH}","start":{60 * i},"status"', 1) for i, line in enumerate(lines)]
    flights.write_text("\n".join(timed) + "\n", encoding="utf-8")
    common = (city, flights, source / "data/samples/mission.plan", "--operation", source / "data/samples/operation.json",
              "--vehicle", "quad2kg", "--origin", "37,-122,10", "--ground", "0", "--between", f"{EPOCH},2026-05-04T07:00:00Z")
    margin = ("--margin", "1")
    for name, more in (("stop", ("--buffer", "2", "--together", "--separation", "2,1", "--parked", "gone")), ("return", ("--contingency", "return", "--autopilot", "px4",
                                                               "--ground-buffer", "ballistic", "--return-height", "60"))):
        made = tool("submit", *common, *margin, *more, "-q", "-o", where / name)
        assert made.returncode == 0, made.stderr
    return [where / "stop", where / "return"]


def keep_their_schemas(folder, report):
    """Each record of a folder has its schema, and none of its members is unknown to it."""
    known = schemas.validators(source)
    records = [("manifest", (folder / "manifest.json").read_text()), ("submission", (folder / "submission.json").read_text()),
               ("operation", (folder / "operation.json").read_text()), ("folder_report", report)]
    for name, kind in (("claims.jsonl", "flight_claims"), ("flights.jsonl", "trajectory"), ("pairs.jsonl", None)):
        if (folder / name).exists():
            records += [(kind or json.loads(line)["type"], line) for line in (folder / name).read_text().splitlines()]
    for kind, text in records:
        record = json.loads(text)
        fault = next(iter(known[kind].iter_errors(record)), None)
        assert fault is None, f"{folder.name}: {kind}: {fault.message}"
        for key in known[kind].schema["required"]:
            assert not known[kind].is_valid({k: v for k, v in record.items() if k != key}), f"{kind}: {key} is not needed"


def make_with_tubes(where):
    """A folder whose volumes hold proved tubes."""
    flights, tubes = where / "flights.jsonl", where / "tubes.jsonl"
    flown = tool("fly", flights, "--vehicle", "quad2kg", "--controller", "geometric", "--proved-tube", "--wind", "1,0,0",
                 "--gust-most", "0.3", "--hover-time", "0.5", "--settle", "0.5", "--report-file", tubes, "-o", where / "log.csv")
    assert flown.returncode == 0, flown.stderr
    made = tool("submit", where / "city.boxmap", flights, "--operation", source / "data/samples/operation.json", "--vehicle", "quad2kg",
                "--origin", "37,-122,10", "--tube", tubes, "--no-page", "-q", "-o", where / "tubes")
    assert made.returncode == 0, made.stderr
    return where / "tubes"


MISSION = """QGC WPL 110
0 1 0 16 0 0 0 0 46.979985 7.450026 547 1
1 0 3 22 0 0 0 0 46.979985 7.450026 60 1
2 0 2 178 0 3 0 0 0 0 0 1
3 0 10 16 2 0 0 0 46.979985 7.450600 60 1
4 0 10 16 2 0 0 0 46.979985 7.450026 60 1
5 0 10 21 0 0 0 0 46.979985 7.450026 0 1
"""


def make_over_terrain(where):
    """A folder with a mission above terrain, its height model, and all else that missions may have; and another height model."""
    tif, hill, ground, other = source / "data/samples/town-ground.tif", where / "hill.boxmap", where / "hill.ground", where / "other.ground"
    assert tool("footprints", tif, "--origin", "46.979985,7.450026", "--ceiling", "690", "-q", "-o", where / "low.boxmap").returncode == 0
    assert tool("map", "bounds", where / "low.boxmap", "--ceiling", "700", "-o", hill).returncode == 0  # which the folder has to say
    for name, error in ((ground, "1"), (other, "2")):
        made = tool("footprints", tif, "--ground-of", hill, "--cell", "10", "--vertical-error", error, "-q", "-o", name)
        assert made.returncode == 0, made.stderr
    (where / "town.wpl").write_text(MISSION.replace(" ", "\t").replace("QGC\tWPL\t", "QGC WPL "), encoding="utf-8")
    (where / "slow.param").write_text("TERRAIN_SPACING,30\nWPNAV_SPEED,300\nWPNAV_SPEED_UP,150\n", encoding="utf-8")
    levels = struct.pack(">4d2i", 46.5, 7.0, 0.5, 0.5, 3, 3) + struct.pack(">9f", *[48.0] * 9)
    (where / "sea.gtx").write_bytes(levels)
    made = tool("submit", hill, where / "town.wpl", "--operation", source / "data/samples/operation.json", "--vehicle", "quad2kg",
                "--params", where / "slow.param", "--ground", "547", "--origin", "46.979985,7.450026,590",
                "--geoid-grid", where / "sea.gtx", "--vmax", "11", "--navigation", "0.2,0.3", "--between", f"{EPOCH},2026-05-04T07:00:00Z",
                "--ground-model", ground, "--terrain-error", "3", "--ground-buffer", "ballistic", "--population", tif, "--no-page",
                "-q", "-o", where / "terrain")
    assert made.returncode == 0, made.stderr
    return where / "terrain"


WAYLINES = """<?xml version="1.0" encoding="UTF-8"?>
<kml xmlns="http://www.opengis.net/kml/2.2" xmlns:wpml="http://www.dji.com/wpmz/1.0.6"><Document>
<wpml:missionConfig><wpml:flyToWaylineMode>safely</wpml:flyToWaylineMode><wpml:finishAction>autoLand</wpml:finishAction>
<wpml:exitOnRCLost>goContinue</wpml:exitOnRCLost><wpml:takeOffSecurityHeight>20</wpml:takeOffSecurityHeight>
<wpml:takeOffRefPoint>46.979985,7.450026,0</wpml:takeOffRefPoint><wpml:globalTransitionalSpeed>8</wpml:globalTransitionalSpeed>
<wpml:droneInfo><wpml:droneEnumValue>77</wpml:droneEnumValue></wpml:droneInfo></wpml:missionConfig>
<Folder><wpml:templateId>0</wpml:templateId><wpml:executeHeightMode>realTimeFollowSurface</wpml:executeHeightMode>
<wpml:waylineId>0</wpml:waylineId><wpml:autoFlightSpeed>5</wpml:autoFlightSpeed>
{}</Folder></Document></kml>
"""
WAYPOINT = """<Placemark><Point><coordinates>{},{}</coordinates></Point><wpml:index>{}</wpml:index><wpml:executeHeight>40</wpml:executeHeight>
<wpml:waypointTurnParam><wpml:waypointTurnMode>coordinateTurn</wpml:waypointTurnMode>
<wpml:waypointTurnDampingDist>4</wpml:waypointTurnDampingDist></wpml:waypointTurnParam></Placemark>
"""


def make_over_surface(where):
    """A folder with a mission of DJI that follows the surface, over the hill and the ground of the other."""
    places = (("7.4501", "46.979985"), ("7.4506", "46.979985"), ("7.4506", "46.9802"))
    text = WAYLINES.format("".join(WAYPOINT.format(*place, i) for i, place in enumerate(places)))
    with zipfile.ZipFile(where / "town.kmz", "w") as archive:
        archive.writestr("wpmz/waylines.wpml", text)
    made = tool("submit", where / "hill.boxmap", where / "town.kmz", "--operation", source / "data/samples/operation.json", "--vehicle", "m3e",
                "--ground", "547", "--origin", "46.979985,7.450026,590", "--between", f"{EPOCH},2026-05-04T07:00:00Z",
                "--ground-model", where / "hill.ground", "--surface-band", "30,60", "--no-page", "-q", "-o", where / "surface")
    assert made.returncode == 0, made.stderr
    return where / "surface"


def require_whole_band(folder):
    """Volumes reach as far up and down as the band of heights, and as its ground and the landing."""
    volumes = [one["volume"] for one in json.loads((folder / "volumes/town.json").read_text(encoding="utf-8"))["volumes"]]
    low, high = ([v[f"altitude_{end}"]["value"] - 590 for v in volumes] for end in ("lower", "upper"))
    band = json.loads((folder / "claims.jsonl").read_text(encoding="utf-8"))["terrain"]["band"]
    assert max(b - a for a, b in zip(low, high)) > band > 30, (low, high, band)
    # The hill is 551.5 m high and 60 m more; along the surface nothing is nearer to its ground of 540 m and more than 30 m.
    assert max(high) > 611.5 - 5 and any(570 <= a < 590 for a in low), (low, high)


def change_surface(folder, where):
    """What is said of the band of heights, signed anew."""
    def try_it(what, old, new, names):
        mutant = copy(folder, where)
        set_text(mutant / "submission.json", (old, new))
        sign(mutant)
        expect_refused(mutant, what, names, script=False)

    said = '"surface_band":[30,60]'
    try_it("a lower band", said, '"surface_band":[29,60]', "volumes/town.json")
    try_it("a higher band", said, '"surface_band":[30,61]', "volumes/town.json")
    try_it("a narrower band", said, '"surface_band":[31,60]', "volumes/town.json")
    try_it("no band that is one", said, '"surface_band":[60,30]', "surface_band must be [low, high]")
    try_it("a terrain error that nobody uses", said, '"terrain_error":3,' + said, "no mission counts its heights from terrain")
    try_it("a terrain error in place of the band", said, '"terrain_error":3', "found heights above the surface")


def listed(folder):
    files = sorted(str(path.relative_to(folder)) for path in folder.rglob("*") if path.is_file())
    return [name for name in files if name != "manifest.json"]


def sign(folder):
    """A manifest of what is there now, as its owner would write it."""
    rows = []
    for name in listed(folder):
        data = (folder / name).read_bytes()
        rows.append(json.dumps({"path": name, "bytes": len(data), "sha256": hashlib.sha256(data).hexdigest()},
                               separators=(",", ":")))
    head = (folder / "manifest.json").read_text(encoding="utf-8").split("\n")[0]
    (folder / "manifest.json").write_text(head + "\n" + ",\n".join(rows) + "\n]}\n", encoding="utf-8")


def copy(folder, where):
    out = where / "mutant"
    shutil.rmtree(out, ignore_errors=True)
    shutil.copytree(folder, out)
    return out


refused = 0
accepted = []


def expect_refused(folder, what, names=None, script=True):
    global refused
    checked = tool("check", folder)
    if checked.returncode not in (1, 3):
        return accepted.append(what)
    assert names is None or names in checked.stdout + checked.stderr, f"{what}: {checked.stderr}"
    if script:
        followed = run(sys.executable, "-B", source / "tests/tools/submit/verify_folder.py", folder)
        assert followed.returncode in (1, 3), f"{what}: the script accepts it"
    refused += 1


def change_files(folder, where):
    for name in listed(folder):
        mutant = copy(folder, where)
        with open(mutant / name, "ab") as file:
            file.write(b" ")
        expect_refused(mutant, f"{name} with a space more", name)
        mutant = copy(folder, where)
        (mutant / name).unlink()
        expect_refused(mutant, f"without {name}", name)
        if name != "page.html" and not name.startswith("verify/"):
            sign(mutant)
            expect_refused(mutant, f"without {name} in the manifest too", script=False)
    for name in ("more.txt", "volumes/more.json", ".hidden", "more/deep/file"):
        mutant = copy(folder, where)
        (mutant / name).parent.mkdir(parents=True, exist_ok=True)
        (mutant / name).write_text("{}", encoding="utf-8")
        expect_refused(mutant, f"with {name}", name)
        sign(mutant)
        expect_refused(mutant, f"with {name} in the manifest", name, script=False)
    mutant = copy(folder, where)
    os.replace(mutant / "summary.html", where / "summary.html")
    os.symlink(where / "summary.html", mutant / "summary.html")
    expect_refused(mutant, "with a link", "summary.html")


def places_in(value, at=()):
    """Paths to all numbers and texts of a JSON value."""
    if isinstance(value, dict):
        for key, one in value.items():
            yield from places_in(one, (*at, key))
    elif isinstance(value, list):
        for i, one in enumerate(value):
            yield from places_in(one, (*at, i))
    else:
        yield at


def at(value, path):
    for key in path[:-1]:
        value = value[key]
    return value, path[-1]


def changed(old):
    if isinstance(old, bool):
        return not old
    if isinstance(old, (int, float)):
        return old + 1 if isinstance(old, int) else old * 1.001 + 1e-3
    return {EPOCH: "2026-05-04T06:30:01Z"}.get(old, old + "x") if isinstance(old, str) else 1


def change_values(folder, where, name, step=1, keep=(), unread=None):
    """Each value of a JSON or JSON Lines file, signed anew; `keep`: keys whose larger value still holds; `unread`: of claims, those that
    the script does not look at, or that may be larger. Without it the script is not asked."""
    lines = (folder / name).read_text(encoding="utf-8").splitlines()
    texts = lines if name.endswith(".jsonl") else ["\n".join(lines)]
    for row, text in enumerate(texts):
        if not text.strip():
            continue
        for path in list(places_in(json.loads(text)))[::step]:
            if set(path) & set(keep):
                continue
            value = json.loads(text)
            holder, key = at(value, path)
            holder[key] = changed(holder[key])
            mutant = copy(folder, where)
            new = [*texts]
            new[row] = json.dumps(value, separators=(",", ":"), ensure_ascii=False)
            (mutant / name).write_text("\n".join(new) + "\n", encoding="utf-8")
            sign(mutant)
            script = unread is not None and json.loads(text)["kind"] == "trajectory" and not set(path) & set(unread)
            expect_refused(mutant, f"{name}, line {row + 1}, {path}", script=script)


def hide_doubts(folder, where):
    """What the map's history leaves open is said neither in submission.json nor in the summary, and all else agrees."""
    mutant = copy(folder, where)
    for name, doubt in (("submission.json", r',"doubts":\{[^}]*\}'), ("summary.html", r"<li>Nothing stands between the map's first bounds[^<]*(</li>)?")):
        text, count = re.subn(doubt, "", (mutant / name).read_text(encoding="utf-8"))
        assert count == 1, (name, count)
        (mutant / name).write_text(text, encoding="utf-8")
    sign(mutant)
    expect_refused(mutant, "without doubts", "its doubts are not those of the map's history", script=False)


def change_people(folder, where):
    """Other numbers of people than the cells below have, and cells that a raster does not have."""
    text = (folder / "claims.jsonl").read_text(encoding="utf-8")
    people, unknown = (json.loads(text)[key] for key in ("people", "people_unknown"))
    said = re.search('"people":([^,]*)', text)[1]
    for new in (2 * people + 1, people / 2):
        mutant = copy(folder, where)
        set_text(mutant / "claims.jsonl", (f'"people":{said}', f'"people":{new}'))
        sign(mutant)
        expect_refused(mutant, f"{new} people in place of {people}")
    mutant = copy(folder, where)
    set_text(mutant / "claims.jsonl", (f'"people_unknown":{unknown}', f'"people_unknown":{unknown + 1000}'))
    sign(mutant)
    expect_refused(mutant, "more cells without a number")
    rows = (folder / "population.csv").read_text(encoding="utf-8").splitlines()
    fewer = [",".join([*row.split(",")[:2], "-1", *row.split(",")[3:]]) for row in rows[1:]]
    for what, cells in (("fewer people than none", fewer), ("a cell twice", [*rows[1:], rows[-1]]), ("without a cell", rows[1:-1])):
        mutant = copy(folder, where)
        (mutant / "population.csv").write_text("\n".join([rows[0], *cells]) + "\n", encoding="utf-8")
        sign(mutant)
        expect_refused(mutant, what, "population.csv")


def grow_vehicle(folder, where):
    """The operation says a vehicle for which the boxes have no room, or one that is smaller than its profile."""
    for size, script in (("1.4", True), ("0.69", False)):
        mutant = copy(folder, where)
        for name, key in (("operation.json", '"dimension_m": '), ("submission.json", '"dimension":')):
            set_text(mutant / name, (f"{key}0.7", f"{key}{size}"))
        sign(mutant)
        expect_refused(mutant, f"a vehicle of {size} m", "the operation says that", script=script)


def raise_ground(folder, where):
    """The floor of all ground lies above a flight: then buffers would be too narrow."""
    mutant = copy(folder, where)
    set_text(mutant / "submission.json", (f'"floor":{floor_of(folder)}', '"floor":14.5'))
    sign(mutant)
    expect_refused(mutant, "a floor above the flights", "lower than all ground")


def shrink_vehicle(folder, where):
    """In certificates and claims, but not in the flights: their volumes would be held for a smaller one."""
    half = json.loads((folder / "certificates.jsonl").read_text(encoding="utf-8").splitlines()[0])["vehicle"]["half"]
    said = json.dumps(half, separators=(",", ":"))
    for old, new in ((f'"half":{said}', '"half":[0.1,0.1,0.1]'), ('"margin":1,', '"margin":0,')):
        mutant = copy(folder, where)
        for name in ("certificates.jsonl", "claims.jsonl"):
            set_text(mutant / name, (old, new))
        sign(mutant)
        expect_refused(mutant, f"{new} in certificates and claims")


def say_twice(folder, where):
    """A key of two values, of which readers see one or the other, and a word in place of a number."""
    for name, old, new in (("claims.jsonl", '"margin":1,', '"margin":2,"margin":1,'), ("operation.json", '"class": "C3",', '"class": "C1", "class": "C3",'),
                           ("claims.jsonl", '"margin":1,', '"margin":NaN,')):
        mutant = copy(folder, where)
        set_text(mutant / name, (old, new))
        sign(mutant)
        expect_refused(mutant, new, name)


def lose_vehicle(folder, where):
    """Then nobody knows what flies its missions."""
    mutant = copy(folder, where)
    text, count = re.subn(r'"vehicle":\{"name".*?\},("margin")', r"\1", (mutant / "submission.json").read_text(encoding="utf-8"), count=1)
    assert count == 1
    (mutant / "submission.json").write_text(text, encoding="utf-8")
    sign(mutant)
    expect_refused(mutant, "without a vehicle", "submission.json: refused: it has missions and no vehicle", script=False)


def shrink(folder, where, name, key):
    """Volumes that are a metre lower, or drawn together: what is written as Skyway writes it, and does not hold."""
    text = (folder / name).read_text(encoding="utf-8")
    data = json.loads(text)
    for i in range(len(data[key])):
        for how in ("upper", "lower", "ring"):
            changed_text = text.split("\n")
            row = next(r for r, line in enumerate(changed_text) if r >= 1 and line.startswith('{"') and key_of(line, key) == i)
            changed_text[row] = squeezed(changed_text[row], how)
            mutant = copy(folder, where)
            (mutant / name).write_text("\n".join(changed_text), encoding="utf-8")
            sign(mutant)
            expect_refused(mutant, f"{name}: {how} of {i}", script=False)


def shrink_all(folder, where, name):
    """Every volume at once, since those of a mission may be alike."""
    for how in ("upper", "lower", "ring"):
        mutant = copy(folder, where)
        rows = (folder / name).read_text(encoding="utf-8").split("\n")
        (mutant / name).write_text("\n".join(squeezed(row, how) if row.startswith('{"volume"') else row for row in rows), encoding="utf-8")
        sign(mutant)
        expect_refused(mutant, f"{name}: {how} of all", "no volume holds the vehicle", script=False)


def change_tubes(folder, where):
    """Tubes, signed anew wherever their hash stands: what they say is not what the other files say."""
    lines = [json.loads(line) for line in (folder / "tubes.jsonl").read_text(encoding="utf-8").splitlines()]

    def wider(tube):
        tube["radius"] = [100 * r for r in tube["radius"]]
        tube["largest"] = max(tube["radius"])

    def set_to(key, value):
        return lambda tube: tube.__setitem__(key, value)

    cut = lambda tube: tube["radius"].pop()
    for what, change, claims in (
            ("wider", wider, False), ("wider, and claims", wider, True), ("cut", cut, False), ("not proved", set_to("ok", False), False),
            ("of another", set_to("trajectory", "0" * 64), False), ("tilted", set_to("tilt", 1.2), True),
            ("for less wind", set_to("gust_most", 0.1), False), ("of more", set_to("rain", 1), False),
            ("null", lambda tube: tube["radius"].__setitem__(0, None), False)):
        mutant, new = copy(folder, where), json.loads(json.dumps(lines))
        change(new[0]["proved_tube"])
        (mutant / "tubes.jsonl").write_text("".join(json.dumps(one, separators=(",", ":")) + "\n" for one in new), encoding="utf-8")
        old, now = (hashlib.sha256((f / "tubes.jsonl").read_bytes()).hexdigest() for f in (folder, mutant))
        for name in ("submission.json", "summary.html"):
            (mutant / name).write_text((mutant / name).read_text(encoding="utf-8").replace(old, now), encoding="utf-8")
        if claims:
            rows = [json.loads(line) for line in (mutant / "claims.jsonl").read_text(encoding="utf-8").splitlines()]
            rows[0]["tube"].update({key: new[0]["proved_tube"][key] for key in ("largest", "tilt")})
            (mutant / "claims.jsonl").write_text("".join(json.dumps(one, separators=(",", ":")) + "\n" for one in rows), encoding="utf-8")
        sign(mutant)
        expect_refused(mutant, f"a tube that is {what}", script=what not in ("of more",))


def set_text(path, *changes):
    text = path.read_text(encoding="utf-8")
    for old, new in changes:
        assert old in text, (path.name, old)
        text = text.replace(old, new)
    path.write_text(text, encoding="utf-8")


def change_ground(folder, where):
    """Height models and what is said of them, signed anew: lost, swapped, damaged, and of no use."""
    def hash_of(path):
        return hashlib.sha256(path.read_bytes()).hexdigest()

    def swap(mutant, data):
        """As its owner would, wherever the hash stands."""
        old = hash_of(mutant / "terrain.ground")
        (mutant / "terrain.ground").write_bytes(data)
        for name in ("submission.json", "summary.html"):
            set_text(mutant / name, (old, hash_of(mutant / "terrain.ground")))

    def try_it(what, change, names):
        mutant = copy(folder, where)
        change(mutant)
        sign(mutant)
        expect_refused(mutant, what, names, script=False)

    model = json.loads((folder / "submission.json").read_text(encoding="utf-8"))["method"]["ground_model"]
    said = '"ground_model":' + json.dumps(model, separators=(",", ":")) + ',"terrain_error":3,'
    other = (where / "other.ground").read_bytes()
    damaged = bytearray((folder / "terrain.ground").read_bytes())
    damaged[len(damaged) // 2] ^= 1

    def forget(mutant, left=""):
        set_text(mutant / "submission.json", (said, left))
        (mutant / "terrain.ground").unlink()

    try_it("another height model", lambda m: (m / "terrain.ground").write_bytes(other), "terrain.ground: refused: it is not hill.ground")
    try_it("another height model, and its hash", lambda m: swap(m, other), "volumes/town.json")
    try_it("a damaged height model", lambda m: swap(m, bytes(damaged)), "terrain.ground")
    try_it("no height model", lambda m: (m / "terrain.ground").unlink(), "terrain.ground: refused: it is missing")
    try_it("no word of a height model", forget, "found one above terrain")
    try_it("a height model that nobody names", lambda m: set_text(m / "submission.json", (said, "")), "terrain.ground: refused: no part")
    try_it("no terrain error", lambda m: set_text(m / "submission.json", (',"terrain_error":3', "")), "terrain_error")
    try_it("a terrain error alone", lambda m: forget(m, '"terrain_error":3,'), "submission.json: refused: skyway-submit does not write it so")
    try_it("less terrain error", lambda m: set_text(m / "submission.json", ('"terrain_error":3', '"terrain_error":0')), "claims.jsonl")
    try_it("more terrain error", lambda m: set_text(m / "submission.json", ('"terrain_error":3', '"terrain_error":9')), "volumes/town.json")
    try_it("a mission above home", lambda m: set_text(m / "missions/town.wpl", ("\t10\t", "\t3\t")), "no mission counts its heights from terrain")
    try_it("a floor above the ground", lambda m: set_text(m / "submission.json", (f'"floor":{floor_of(folder)}', '"floor":539.0000000001')), "the ground below is as low as")


def floor_of(folder):
    return json.dumps(json.loads((folder / "submission.json").read_text(encoding="utf-8"))["method"]["floor"])


def members(record, schema):
    """Of the properties of a schema of an object, and of its objects, those that the record has; and all."""
    found, known = set(), set()
    for key, one in schema.get("properties", {}).items():
        known.add(key)
        if key in record:
            found.add(key)
        inner = members(record.get(key) if isinstance(record.get(key), dict) else {}, one)
        found |= {f"{key}.{name}" for name in inner[0]}
        known |= {f"{key}.{name}" for name in inner[1]}
    return found, known


def require_all_members(folders):
    """All that the schemas of submission.json and claims.jsonl name stands in a folder that was made, but for other shapes of a separation, and other doubts of a map."""
    never = {"submission": {"method.together.separation_box", "method.together.downwash", "doubts.skipped", "doubts.unknown_free", "doubts.gap"},
             "flight_claims": set()}
    for kind, name in (("submission", "submission.json"), ("flight_claims", "claims.jsonl")):
        found = set()
        for folder in folders:
            for line in (folder / name).read_text(encoding="utf-8").splitlines():
                some, known = members(json.loads(line), schemas.written(source)[kind])
                found |= some
        assert known - found <= never[kind], (kind, known - found - never[kind])


rows_of = {}


def key_of(line, key):
    return rows_of.setdefault(key, {}).setdefault(line, len(rows_of[key]))


def squeezed(line, how):
    comma = line.endswith(",")
    one = json.loads(line.rstrip(","))
    if "volume" in one:
        volume = one["volume"]
        if how == "ring":
            ring = volume["outline_polygon"]["vertices"]
            for axis in ("lat", "lng"):
                middle = sum(v[axis] for v in ring) / len(ring)
                for v in ring:
                    v[axis] = round(middle + 0.9 * (v[axis] - middle), 9)
        else:
            by = min(1, (volume["altitude_upper"]["value"] - volume["altitude_lower"]["value"]) / 2)
            said = volume[f"altitude_{how}"]
            value = round(said["value"] + (-by if how == "upper" else by), 2)
            said["value"] = int(value) if value == int(value) else value  # as it is written
    else:
        said = one["properties"]
        if how == "ring":
            ring = one["geometry"]["coordinates"][0]
            for axis in (0, 1):
                middle = sum(v[axis] for v in ring[:-1]) / (len(ring) - 1)
                for v in ring:
                    v[axis] = round(middle + 0.9 * (v[axis] - middle), 9)
        else:
            said[f"{how}_m"] += -1 if how == "upper" else 1
    return json.dumps(one, separators=(",", ":")) + ("," if comma else "")


def main():
    with tempfile.TemporaryDirectory() as name:
        where = pathlib.Path(name)
        folders = make(where)
        for folder in folders:
            checked = tool("check", folder)
            assert checked.returncode == 0, checked.stderr
            assert json.loads(checked.stdout)["not_verified"] == ["page.html"]
            keep_their_schemas(folder, checked.stdout)
            followed = run(sys.executable, "-B", folder / "verify/verify_folder.py", folder)
            assert followed.returncode == 0, followed.stdout
        change_files(folders[0], where)
        for folder in folders:
            change_values(folder, where, "submission.json", keep=("volumes",))  # at most so many
            change_values(folder, where, "claims.jsonl", unread=("type", "clearance", "returns", "people", "people_unknown"))
            for kind, key in (("volumes/north.json", "volumes"), ("risk/north.geojson", "features")):
                rows_of.clear()
                shrink(folder, where, kind, key)
        raise_ground(folders[0], where)
        shrink_vehicle(folders[0], where)
        grow_vehicle(folders[0], where)
        say_twice(folders[0], where)
        lose_vehicle(folders[0], where)
        change_values(folders[0], where, "operation.json")
        change_values(folders[0], where, "flights.jsonl", step=29, keep=("solver", "yaw"))
        change_values(folders[0], where, "certificates.jsonl", step=11)
        change_values(folders[0], where, "pairs.jsonl")
        change_values(folders[0], where, "pair_certificates.jsonl", step=11)
        change_values(folders[0], where, "volumes/mission.json", step=7)
        tubes = make_with_tubes(where)
        checked = tool("check", tubes)
        assert checked.returncode == 0, checked.stderr
        keep_their_schemas(tubes, checked.stdout)
        assert json.loads(checked.stdout)["not_verified"] == ["the proofs of the tubes in tubes.jsonl"]
        followed = run(sys.executable, "-B", tubes / "verify/verify_folder.py", tubes)
        assert followed.returncode == 0, followed.stdout
        change_files(tubes, where)
        change_tubes(tubes, where)
        change_values(tubes, where, "submission.json", keep=("volumes", "drag", "geoid"))  # of missions
        change_values(tubes, where, "claims.jsonl")
        folders.append(tubes)
        if (tools / "skyway-footprints").exists():  # a build without GDAL has no height models
            terrain = make_over_terrain(where)
            checked = tool("check", terrain)
            assert checked.returncode == 0 and json.loads(checked.stdout)["not_verified"] == [
                "that population.csv is of town-ground.tif", "that terrain.ground is of hill.ground"], checked
            followed = run(sys.executable, "-B", terrain / "verify/verify_folder.py", terrain)
            assert followed.returncode == 0, followed.stdout
            keep_their_schemas(terrain, checked.stdout)
            hide_doubts(terrain, where)
            change_files(terrain, where)
            change_ground(terrain, where)
            change_people(terrain, where)
            # Looser limits of the vehicle are true of a mission, too; it ends without a return, and its sea level is the grid's.
            change_values(terrain, where, "submission.json", keep=("volumes", "limits", "return_height", "geoid"))
            change_values(terrain, where, "claims.jsonl")
            shrink_all(terrain, where, "volumes/town.json")
            surface = make_over_surface(where)
            checked = tool("check", surface)
            assert checked.returncode == 0, checked.stderr
            followed = run(sys.executable, "-B", surface / "verify/verify_folder.py", surface)
            assert followed.returncode == 0, followed.stdout
            keep_their_schemas(surface, checked.stdout)
            require_whole_band(surface)
            change_surface(surface, where)
            change_values(surface, where, "claims.jsonl")
            shrink_all(surface, where, "volumes/town.json")
            require_all_members([*folders, terrain, surface])
        # A page is for looking: the check says that it is not verified.
        mutant = copy(folders[0], where)
        (mutant / "page.html").write_text("<p>another</p>", encoding="utf-8")
        sign(mutant)
        checked = tool("check", mutant)
        assert checked.returncode == 0 and "page.html" in checked.stdout
    assert not accepted, accepted
    print(f"{refused} changed folders were refused")


main()
