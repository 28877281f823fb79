"""enclosure_test.py BIN_DIR [MAPS]: each goal that is unreachable has an enclosure that holds for the independent verifier, and
none holds once tampered with."""

import contextlib
import copy
import io
import json
import os
import pathlib
import random
import sys
import tempfile

from verify_enclosure import BoxMap, main, verify
from tools_and_claims import Tools, changed, objects, refused  # where the verifier looks, too

tool = Tools(sys.argv[1])
maps = int(sys.argv[2]) if len(sys.argv) > 2 else 12
SIDE = 5
SEED = 23


def random_map(chance, folder):
    """Panels and boxes on whole metres that cut the room into parts."""
    boxes = []
    for i in range(chance.randrange(24, 48)):
        low = [chance.randrange(SIDE) for _ in range(3)]
        high = [min(SIDE, v + chance.randrange(1, 5)) for v in low]
        if i % 4:
            flat = chance.randrange(3)
            high[flat] = low[flat]
        boxes.append(low + high)
    tool.make_map(folder, "m.boxmap", SIDE, boxes)


def queries(chance, folder):
    lines = []
    for i in range(40):
        ends = [[chance.randrange(SIDE) + 0.5 for _ in range(3)] for _ in range(2)]
        lines.append(json.dumps({"id": f"q{i}", "from": ends[0], "to": ends[1]}))
    (folder / "queries.jsonl").write_text("\n".join(lines) + "\n")


def mutants(record, chance):
    """Each makes the statement false, or says another's."""
    cells = record["cells"]
    other = {"from": "to", "to": "from"}
    i = chance.randrange(len(cells))
    axis = chance.randrange(3)
    up = chance.randrange(2)
    middle = [(a + b) / 2 for a, b in zip(*cells[i])]
    if all(b - a > 1e-6 for cell in cells for a, b in zip(*cell)):  # else what is missing may be as thin as rounding
        yield "a cell is missing", changed(record, lambda r: r["cells"].pop(i))
        yield "a cell ends sooner", changed(record, lambda r: r["cells"][i][up].__setitem__(axis, middle[axis]))
    yield "around the other end", changed(record, lambda r: r.update(around=other[r["around"]]))
    yield "the other end is in a cell", changed(record, lambda r: r.update({other[r["around"]]: middle}))
    yield "a cell holds all", changed(record, lambda r: r["cells"].append([[0, 0, 0], [SIDE] * 3]))
    yield "a cell has no inside", changed(record, lambda r: r["cells"][i].reverse())
    yield "another map", changed(record, lambda r: r.update(map="sha256:" + "0" * 64))
    yield "another frame", changed(record, lambda r: r.update(frame="neu"))
    yield "other bounds", changed(record, lambda r: r["bounds"][1].__setitem__(axis, SIDE + 1))
    yield "no number", changed(record, lambda r: r["cells"][i][up].__setitem__(axis, "1"))
    yield "no type", changed(record, lambda r: r.pop("type"))


def without_what_encloses(record, box_map, chance):
    """The map without a box that a face of a cell leans on."""
    out = copy.copy(box_map)
    cell = record["cells"][chance.randrange(len(record["cells"]))]
    near = [b for b in box_map.boxes if all(a - 1e-6 <= high and low <= c + 1e-6 for a, c, low, high in zip(*cell, b[:3], b[3:]))]
    out.boxes = [b for b in box_map.boxes if b not in near]
    return out, bool(near)


def run():
    chance = random.Random(SEED)
    holding = tried = 0
    for _ in range(maps):
        folder = pathlib.Path(".")
        random_map(chance, folder)
        queries(chance, folder)
        tool("skyway-plan", "m.boxmap", "--queries", "queries.jsonl", "--vehicle", "box:0,0,0", "-q",
             "--certificate", "why.jsonl", "-o", "paths.jsonl")
        unreachable = {r["id"] for r in objects(pathlib.Path("paths.jsonl").read_text()) if r["status"] == "unreachable"}
        enclosures = objects(pathlib.Path("why.jsonl").read_text())
        assert {r["id"] for r in enclosures} == unreachable, unreachable
        if not enclosures:
            continue
        box_map = BoxMap("m.boxmap")
        for record in enclosures:
            verify(record, box_map)
            holding += 1
            for what, mutant in mutants(record, chance):
                assert refused(verify, mutant, box_map), (what, mutant)
                tried += 1
            fewer, some = without_what_encloses(record, box_map, chance)
            if some:
                assert refused(verify, record, fewer), ("an obstacle is missing", record)
                tried += 1
        with contextlib.redirect_stdout(io.StringIO()) as said:
            sys.argv[1:] = ["m.boxmap", "why.jsonl"]
            try:
                main()
            except SystemExit as end:
                assert end.code == 0, said.getvalue()
        assert said.getvalue().count("no way from") == len(enclosures)
    assert holding > maps, holding
    print(f"{holding} enclosures hold, {tried} mutants are refused")


with tempfile.TemporaryDirectory() as temporary:
    os.chdir(temporary)
    run()
