"""folder_test.py TOOLS SOURCE_DIR: folders of skyway-submit, and changed ones, which must be refused.

A folder with a trajectory, a mission and people is made. Then each of its files is changed, removed and added to; and
values within are changed by somebody who also writes a new manifest. skyway-check must refuse each, and verify_folder.py
what it looks at.
"""

import hashlib
import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

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
    expect_refused(mutant, "with a link", "summary.html", script=False)


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


def change_values(folder, where, name, step=1, keep=()):
    """Each value of a JSON or JSON Lines file, signed anew; `keep`: keys whose larger value still holds."""
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
            expect_refused(mutant, f"{name}, line {row + 1}, {path}", script=False)


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
            volume[f"altitude_{how}"]["value"] += -1 if how == "upper" else 1
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
            change_values(folder, where, "claims.jsonl")
            for kind, key in (("volumes/north.json", "volumes"), ("risk/north.geojson", "features")):
                rows_of.clear()
                shrink(folder, where, kind, key)
        change_values(folders[0], where, "operation.json")
        change_values(folders[0], where, "flights.jsonl", step=29, keep=("solver", "yaw"))
        change_values(folders[0], where, "certificates.jsonl", step=11)
        change_values(folders[0], where, "pairs.jsonl")
        change_values(folders[0], where, "pair_certificates.jsonl", step=11)
        change_values(folders[0], where, "volumes/mission.json", step=7)
        tubes = make_with_tubes(where)
        checked = tool("check", tubes)
        assert checked.returncode == 0, checked.stderr
        assert json.loads(checked.stdout)["not_verified"] == ["the proofs of the tubes in tubes.jsonl"]
        followed = run(sys.executable, "-B", tubes / "verify/verify_folder.py", tubes)
        assert followed.returncode == 0, followed.stdout
        change_files(tubes, where)
        change_tubes(tubes, where)
        change_values(tubes, where, "submission.json", keep=("volumes", "drag", "geoid"))  # of missions
        change_values(tubes, where, "claims.jsonl")
        # A page is for looking: the check says that it is not verified.
        mutant = copy(folders[0], where)
        (mutant / "page.html").write_text("<p>another</p>", encoding="utf-8")
        sign(mutant)
        checked = tool("check", mutant)
        assert checked.returncode == 0 and "page.html" in checked.stdout
    assert not accepted, accepted
    print(f"{refused} changed folders were refused")


main()
