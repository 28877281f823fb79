"""bound_test.py BIN_DIR [MAPS [MUTANTS]]: every bound has a certificate that holds for the independent verifier; of certificates that
were tampered with, none holds that says what is false."""

import contextlib
import copy
import io
import json
import os
import pathlib
import random
import sys
import tempfile

import verify_bound
from verify_bound import BoxMap, verify
from tools_and_claims import Tools, objects, refused  # where the verifiers look, too
from verify_certificate import run_main

tool = Tools(sys.argv[1])
maps = int(sys.argv[2]) if len(sys.argv) > 2 else 10
most = int(sys.argv[3]) if len(sys.argv) > 3 else 1500
SIDE = 10
SEED = 31


def random_boxes(chance):
    """Half of the maps on whole metres, where faces are flush and edges cross."""
    whole = chance.random() < 0.5
    boxes = []
    for _ in range(chance.randrange(3, 12)):
        low = [float(chance.randrange(SIDE - 1)) if whole else chance.uniform(0, SIDE - 1) for _ in range(3)]
        size = [float(chance.randrange(1, 6)) if whole else chance.uniform(0.2, 6) for _ in range(3)]
        boxes.append(low + [min(float(SIDE), a + b) for a, b in zip(low, size)])
    return boxes


def ask(map_file, queries, gap, margin, folder="."):
    pathlib.Path("queries.jsonl").write_text("".join(json.dumps(q) + "\n" for q in queries))
    tool("skyway-plan", map_file, "--queries", "queries.jsonl", "--vehicle", "box:0.25,0.25,0.25", "--margin", margin, "-q", "--bound",
         gap, "--certificate", "why.jsonl", "-o", "paths.jsonl")
    paths = {r["id"]: r for r in objects(pathlib.Path("paths.jsonl").read_text()) if r["status"] == "found"}
    bounds = [r for r in objects(pathlib.Path("why.jsonl").read_text()) if r["type"] == "bound"]
    assert {r["id"] for r in bounds} == set(paths)
    assert all(r["bound"] == paths[r["id"]]["bound"] for r in bounds)
    return paths, bounds


def states(record, keys=("come", "go")):
    """Where the lines of states stand: level, key, part, at which of the row's numbers."""
    for n, level in enumerate(record["levels"]):
        for key in keys:
            for i, row in enumerate(level.get(key, ())):
                if i > (key == "go"):
                    yield from ((n, key, i, at) for at, value in enumerate(row) if value is not None)


def raise_label(record, chance):
    lines = list(states(record))
    if not lines:
        return
    n, key, i, at = chance.choice(lines)
    record["levels"][n][key][i][at] += chance.choice((1e-6, 0.01, 1.0)) * (1 + record["bound"])


def forget_label(record, chance):
    level = chance.choice(record["levels"])
    rows = level[chance.choice([key for key in ("come", "go") if key in level])]
    rows[chance.randrange(1, len(rows))] = [None, None]


def claim_hidden(record, chance):
    level = chance.choice(record["levels"])
    count = len(level["come"])
    if record["occluders"]:
        level["hidden"].append([chance.randrange(count), chance.randrange(count), chance.randrange(len(record["occluders"]))])


def move_occluder(record, chance):
    if record["occluders"]:
        box = chance.choice(record["occluders"])
        up, k = chance.randrange(2), chance.randrange(3)
        box[up][k] += (2 * up - 1) * chance.choice((1e-9, 1e-3, 0.3, 3))


def swap_occluder(record, chance):
    rows = [row for level in record["levels"] for row in level["hidden"]]
    if rows:
        row = chance.choice(rows)
        row[chance.randrange(2, len(row), 2)] = chance.randrange(len(record["occluders"]))


def drop_part(record, chance):
    parts = record["levels"][0]["parts"]
    if parts:
        i = chance.randrange(len(parts))
        parts.pop(i)
        record["levels"] = record["levels"][:1]
        for key in ("come", "go"):
            if key in record["levels"][0]:
                record["levels"][0][key].pop(i + 2)
        record["levels"][0]["hidden"] = []


def cut_part(record, chance):
    parts = [part for level in record["levels"] for part in level["parts"] if len(part) in (7, 3)]
    if parts:
        part = chance.choice(parts)
        part[3 if len(part) == 7 else 1] -= chance.choice((1e-9, 0.1))


def turn_part(record, chance):
    parts = [part for part in record["levels"][0]["parts"] if len(part) == 7]
    if parts:
        part = chance.choice(parts)
        part[chance.choice((5, 6))] *= -1


def forget_goal(record, chance):
    record["levels"] = record["levels"][:chance.randrange(1, len(record["levels"]) + 1)]
    record["levels"][-1]["come"][1] = [None, None]


def say_nothing(record, chance):
    level = chance.choice(record["levels"])
    level[chance.choice(("come", "go"))] = [[None, None]] * len(level["come"])


CHANGES = (raise_label, forget_label, claim_hidden, move_occluder, swap_occluder, drop_part, cut_part, turn_part, forget_goal, say_nothing)


def false_of(record, length, chance):
    """A mutant with a bound above the length of a path: it says what is false, however it says so."""
    out = copy.deepcopy(record)
    out["bound"] = length * (1 + chance.choice((1e-6, 1e-3, 0.1)))
    for _ in range(chance.randrange(4)):
        chance.choice(CHANGES)(out, chance)
    return out


def strange(record, chance):
    """Mutants of which no part may stand, true or not."""
    for key, value in (("map", "sha256:" + "0" * 64), ("frame", "neu"), ("type", "enclosure"), ("bounds", [[0, 0, 0], [SIDE] * 2 + [SIDE + 1]]),
                       ("bound", "1"), ("levels", 3), ("margin", -1), ("from", [1, 1])):
        yield key, record | {key: value}
    if record["occluders"]:  # found to be none in no time
        yield "an occluder larger than all", record | {"occluders": [[[-1e8] * 3, [1e8] * 3]] * len(record["occluders"])}
    for key in ("bound", "levels", "vehicle", "occluders"):
        yield key, {k: v for k, v in record.items() if k != key}


class Tally:
    def __init__(self):
        self.holding = self.tried = self.still = 0

    def try_false(self, record, length, box_map, finders, chance):
        mutant = false_of(record, length, chance)
        assert refused(verify, mutant, box_map, finders), mutant
        self.tried += 1

    def try_change(self, record, box_map, finders, chance):
        """What still holds says no more than before, which is true."""
        change = chance.choice(CHANGES)
        mutant = copy.deepcopy(record)
        change(mutant, chance)
        if mutant == record:
            return
        self.tried += 1
        self.still += not refused(verify, mutant, box_map, finders)

    def try_fewer_boxes(self, record, boxes, margin, box_map, chance):
        """The map without a box, under the hash of the whole: where it holds, it must be true of that map."""
        i = chance.randrange(len(boxes))
        fewer = copy.copy(box_map)
        fewer.boxes = [box for box in box_map.boxes if box != tuple(boxes[i])]
        self.tried += 1
        if refused(verify, record, fewer, {}):
            return
        self.still += 1
        tool.make_map(".", "fewer.boxmap", SIDE, [box for box in boxes if box != boxes[i]])
        paths, _ = ask("fewer.boxmap", [{"id": "q", "from": record["from"], "to": record["to"]}], "1e-4", margin)
        assert paths["q"]["length"] >= record["bound"], (record, boxes, i)


def script(*arguments):
    """What it prints where it accepts all."""
    with contextlib.redirect_stdout(io.StringIO()) as said:
        sys.argv[1:] = arguments
        try:
            run_main(verify_bound.__doc__, 2, verify_bound.verify_files)
        except SystemExit as end:
            assert end.code == 0, said.getvalue()
    return said.getvalue()


def run():
    chance = random.Random(SEED)
    tally = Tally()
    for n in range(maps):
        boxes = random_boxes(chance)
        tool.make_map(".", "m.boxmap", SIDE, boxes)
        margin = chance.choice(("0", "0.1"))
        ends = [[[round(chance.uniform(0.5, SIDE - 0.5), 2) for _ in range(3)] for _ in range(2)] for _ in range(14)]
        queries = [{"id": f"q{i}", "from": a, "to": b} for i, (a, b) in enumerate(ends)]
        paths, bounds = ask("m.boxmap", queries, chance.choice(("1e-2", "1e-3", "1e-4")), margin)
        if not bounds:
            continue
        assert script("m.boxmap", "why.jsonl").count("is shorter than") == len(bounds)
        tally.holding += len(bounds)
        box_map, finders = BoxMap("m.boxmap"), {}
        bounds = [record for record in bounds if record["levels"]]
        for record in bounds:
            for what, mutant in strange(record, chance):
                assert refused(verify, mutant, box_map, finders), what
                tally.tried += 1
        for _ in range(most * (n + 1) // maps - tally.tried if bounds else 0):
            record = chance.choice(bounds)
            tally.try_false(record, paths[record["id"]]["length"], box_map, finders, chance)
            tally.try_change(record, box_map, finders, chance)
            if tally.tried % 40 == 0:
                tally.try_fewer_boxes(record, boxes, margin, box_map, chance)
            if tally.tried >= most * (n + 1) // maps:
                break
    assert tally.holding > 3 * maps and tally.still < 0.4 * tally.tried, vars(tally)
    print(f"{tally.holding} bounds hold; of {tally.tried} mutants, {tally.still} are still true, the others refused")


with tempfile.TemporaryDirectory() as temporary:
    os.chdir(temporary)
    run()
