"""show_test.py BIN_DIR SHOW_MD: the commands of docs/show.md, as they stand there, and what they must lead to."""

import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile

bin_dir, page = (pathlib.Path(a).resolve() for a in sys.argv[1:3])


def commands():
    return re.findall(r"```sh\n(.*?)```", page.read_text(), re.S)


def run(command, folder, exit_code=0):
    path = {**os.environ, "PATH": f"{bin_dir}:{os.environ['PATH']}"}
    done = subprocess.run(["sh", "-c", command], cwd=folder, env=path, text=True, capture_output=True)
    assert done.returncode == exit_code, (command, done.returncode, done.stderr)
    return done


def records(path):
    return [json.loads(line) for line in path.read_text().splitlines()]


def listed(text):
    """What is in show.yaml, without a YAML reader: its values are JSON."""
    head, flights = text.split("flights:\n")
    values = dict(line.split(": ", 1) for line in head.splitlines() if not line.startswith("#"))
    entries = []
    for entry in re.split(r"^  - ", flights, flags=re.M)[1:]:
        entries.append({k: json.loads(v) for k, v in (line.strip().split(": ", 1) for line in entry.splitlines())})
    return {k: json.loads(v) for k, v in values.items()}, entries


def check_folder(folder, flights, show):
    head, entries = listed((show / "show.yaml").read_text())
    assert head == {"checked": True}
    by_id = {f["id"]: f for f in flights}
    assert {e["id"] for e in entries} == set(by_id) and len(entries) == len(flights) == 30
    assert [e["start"] for e in entries] == sorted(e["start"] for e in entries)
    assert sorted(p.name for p in show.iterdir()) == sorted([e["file"] for e in entries] + ["show.yaml"])
    for entry in entries:
        record = by_id[entry["id"]]
        assert entry["start"] == record["start"] and abs(entry["duration"] - record["duration"]) < 1e-9
        rows = (show / entry["file"]).read_text().splitlines()
        assert len(rows) == 1 + len(record["segments"]) and rows[0].startswith("duration,x^0,")
        begin = [float(rows[1].split(",")[k]) for k in (1, 9, 17)]
        assert all(abs(a - b) < 1e-6 for a, b in zip(begin, entry["initial_position"]))
        alone = run(f"skyway-export room.boxmap flights.jsonl --id {entry['id']} --format crazyflie -q", folder)
        assert alone.stdout == (show / entry["file"]).read_text()  # the same file as of one


def check_refusals(folder):
    """Nothing is left of a show where a pair or a flight is refused, and nothing is written over."""
    export = "skyway-export room.boxmap {} --format crazyflie --separation 0.25,0.3 --show {}"
    at_once = run(export.format("wishes.jsonl", "near"), folder, 1)
    assert "too near" in at_once.stderr and "m apart across" in at_once.stderr
    text = (folder / "flights.jsonl").read_text()
    cut = text.splitlines()
    wide = json.loads(cut[3])
    wide["margin"] = 0.6  # more than the window has
    (folder / "wide.jsonl").write_text("\n".join([*cut[:3], json.dumps(wide), *cut[4:]]) + "\n")
    refused = run(export.format("wide.jsonl", "wide"), folder, 1)
    assert "cf4: refused" in refused.stderr and "1 of 30 flights were refused: no folder" in refused.stderr, refused.stderr
    (folder / "twice.jsonl").write_text("\n".join([*cut, cut[0]]) + "\n")
    assert "different files" in run(export.format("twice.jsonl", "twice"), folder, 3).stderr
    same = cut[1].replace('"id":"cf2"', '"id":"c/f"') + "\n" + cut[2].replace('"id":"cf3"', '"id":"c?f"') + "\n"
    (folder / "same.jsonl").write_text(same)
    assert "c_f.csv" in run(export.format("same.jsonl", "same"), folder, 3).stderr
    case = cut[0] + "\n" + cut[1].replace('"id":"cf2"', '"id":"CF1"') + "\n"  # one file where names have no case
    (folder / "case.jsonl").write_text(case)
    assert "CF1.csv" in run(export.format("case.jsonl", "case"), folder, 3).stderr
    epoch = cut[1].replace('"start":', '"epoch":"2026-05-04T06:30:00Z","start":', 1)
    (folder / "epoch.jsonl").write_text("\n".join([cut[0], epoch]) + "\n")
    assert "epoch" in run(export.format("epoch.jsonl", "epoch"), folder, 3).stderr
    before = (folder / "show" / "cf1.csv").read_bytes()
    assert "is there" in run(export.format("wishes.jsonl", "show"), folder, 2).stderr
    assert (folder / "show" / "cf1.csv").read_bytes() == before
    for name in ("near", "wide", "twice", "same", "case", "epoch"):
        assert not (folder / name).exists(), name
    assert not list(folder.glob("*.part")), list(folder.glob("*.part"))


def check_words(folder):
    """show.yaml claims no more than was proved."""
    def words(name, *options):
        command = " ".join(["skyway-export room.boxmap flights.jsonl --format crazyflie --show", name, *options])
        run(command, folder)
        return (folder / name / "show.yaml").read_text().split("checked:")[0]

    stands = "stands before or after was not looked at"
    assert stands not in words("pad", "--separation 0.25,0.3")
    assert stands in words("gone", "--separation 0.25,0.3 --parked gone")
    assert "with their margins less 0.05 m, while" in words("spared", "--spare 0.05")


def check_unchecked(folder):
    run("skyway-export --unchecked wishes.jsonl --format crazyflie --show free", folder)
    text = (folder / "free" / "show.yaml").read_text()
    head, entries = listed(text)
    assert "UNCHECKED" in text and head == {"checked": False} and len(entries) == 30
    refused = run("skyway-export --unchecked wishes.jsonl --format crazyflie --separation 1,1 --show no", folder, 2)
    assert "--separation" in refused.stderr


def main(folder):
    for command in commands():
        run(command, folder)
    flights = records(folder / "flights.jsonl")
    reports = records(folder / "report.jsonl")
    together = [r for r in reports if r["type"] == "together"]
    assert len(together) == 1 and together[0]["ok"] and together[0]["pairs"] == 435
    assert len(reports) == 31 and all(r["ok"] for r in reports)
    check_folder(folder, flights, folder / "show")
    assert "Thirty Crazyflies" in (folder / "show.html").read_text()
    assert "30 flights" in (folder / "fleet.svg").read_text()
    check_refusals(folder)
    check_words(folder)
    check_unchecked(folder)


with tempfile.TemporaryDirectory() as name:
    main(pathlib.Path(name))
print("show: as docs/show.md says")
