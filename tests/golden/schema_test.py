"""schema_test.py SOURCE_DIR: each record in the golden sessions that a tool printed keeps its schema in docs/schema, which names all of its keys. Also
those that are written into files there and read, where they are obstacles that move; and what these must not say breaks their schema."""

import copy
import json
import pathlib
import re
import sys

import jsonschema

source = pathlib.Path(sys.argv[1])
sys.path.insert(0, str(source / "tests/support"))
import schemas  # noqa: E402

within = schemas.within
WRITTEN = {"moving"}  # which no tool prints
WITHOUT = {"boxmap", "name"}  # what skyway-info says, and a name in a GeoJSON
PLACEHOLDER = re.compile(r'"map":"[A-Z]+"')  # of a session that hides the hash
HIDDEN = re.compile(r'"manifest":"…"')


def require_one_definition_each():
    """Each reference leads to a definition, each definition is used, and none is written out a second time."""
    defined = schemas.definitions(source)
    plain = lambda node: {key: value for key, value in node.items() if key != "description"}
    used = {node["$ref"].removeprefix("#/$defs/") for node in within(defined) if type(node) is dict and "$ref" in node}
    for kind, schema in schemas.written(source).items():
        assert not set(defined) & set(schema.get("$defs", ())), f"{kind}.schema.json has a name of {schemas.SHARED}"
        for node in within(schema):
            if type(node) is not dict:
                continue
            if "$ref" in node:
                file, _, name = node["$ref"].partition("#/$defs/")
                assert file or name in schema["$defs"], node
                used |= {name} if file else set()
                continue
            copied = [name for name, one in defined.items() if plain(one) == plain(node) and len(str(plain(node))) > 50]
            assert not copied, f"{kind}.schema.json writes out what {schemas.SHARED} calls {copied[0]}"
    assert used == set(defined), used ^ set(defined)


def require_all_limits():
    """The definitions name each limit and each quantity of geom::kLimitKinds."""
    table = (source / "libgeom/include/geom/vehicle/limits.h").read_text(encoding="utf-8")
    rows = re.findall(r'\{Limit::\w+, "(\w+)", "(\w+)"', table)
    defined = schemas.definitions(source)
    assert rows and {name for name, _ in rows} == set(defined["limit"]["enum"])
    assert {quantity for _, quantity in rows} == set(defined["quantity"]["enum"])
    for _, quantity in rows:
        for kind, key in (("extremes", quantity), ("extremes", quantity + "_time"), ("pieces_of_quantities", quantity)):
            assert any(re.search(pattern, key) for pattern in defined[kind]["patternProperties"]), key


def records():
    """Each with its place and whether it is what a tool printed."""
    for path in sorted((source / "tests/golden").glob("*.txt")):
        for row, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
            printed = not line.startswith("> ")
            try:
                line = HIDDEN.sub(f'"manifest":"{"0" * 64}"', line)
                record = json.loads(PLACEHOLDER.sub(f'"map":"sha256:{"0" * 64}"', line if printed else line[2:]))
            except ValueError:
                continue
            if type(record) is dict:
                yield f"{path.name}:{row}", printed, record


require_one_definition_each()
require_all_limits()
known = schemas.validators(source)
count = {}
for place, printed, record in records():
    kind = "tree_node" if "first_parent" in record else record.get("type")
    if printed and kind and kind not in WITHOUT:
        assert kind in known, f"{place}: no schema of {kind}"
    if kind not in known or not (printed or kind in WRITTEN):
        continue
    fault = jsonschema.exceptions.best_match(known[kind].iter_errors(record))
    assert fault is None, f"{place}: {fault.message}"
    unknown = schemas.unknown_keys(known[kind].schema, record)
    assert not unknown, f"{place}: no schema names {unknown}"
    count.setdefault(kind, []).append(record)
for kind in ("path", "trajectory", "bound", "report", "together", "pair", "moving", "moving_conflict", "clear_of", "clear_of_moving", "returns", "contingency", "contingencies", "answer", "box", "diff", "fleet", "tree", "tree_node"):
    assert count.get(kind), f"no session has a record of type {kind}"

balloon = count["moving"][0]
for key in known["moving"].schema["required"]:
    wrong = copy.deepcopy(balloon)
    del wrong[key]
    assert not known["moving"].is_valid(wrong), key
for change in ({"speed": 3}, {"growth": [0, -1, 0]}, {"velocity": [0, 0, 2e4]}, {"min": [0, 0]}, {"until": None}, {"frame": "ned"}, {"from": "10"}):
    assert not known["moving"].is_valid(balloon | change), change
# A key that no schema names would be found, wherever it stands.
for kind, inner in (("path", "search"), ("trajectory", "solver"), ("report", "vehicle")):
    for record in (one for one in count[kind] if inner in one):
        for changed, where in ((record | {"other": 1}, "other"), (record | {inner: record[inner] | {"other": 1}}, f"{inner}.other")):
            assert schemas.unknown_keys(known[kind].schema, changed) == [f"{kind}.{where}"], (where, changed)
# What several records share is as strict through a reference: one wrong limit refuses each of them.
for kind in ("report", "trajectory", "path", "certificate"):
    for record in (record for _, _, record in records() if record.get("type") == kind and "limits" in record.get("vehicle", ())):
        limits = record["vehicle"]["limits"]
        for wrong in ({"vmax": 0}, {"tilt": 1.6}, {"tilt": "35 deg"}, {"vmin": 1}):
            changed = record | {"vehicle": record["vehicle"] | {"limits": limits | wrong}}
            assert not known[kind].is_valid(changed), (kind, wrong)
print({kind: len(some) for kind, some in count.items()})

asked = known["query"]
for line in (source / "data/samples/queries.jsonl").read_text().splitlines():
    assert asked.is_valid(json.loads(line)), line
for place in ([1, 2, 3], "60.1719N,24.9414E,30", "60.1719N,24.9414E,2above"):
    assert asked.is_valid({"from": place, "to": [4, 5, 6]}), place
for place in ([1, 2], "60.1719N,24.9414E", 7):
    assert not asked.is_valid({"from": [4, 5, 6], "to": place}), place
