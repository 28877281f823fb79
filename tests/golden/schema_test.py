"""schema_test.py SOURCE_DIR: each record in the golden sessions that has a schema in docs/schema keeps it. Also those that are
written into files there and read, where they are obstacles that move; and what these must not say breaks their schema."""

import copy
import json
import pathlib
import re
import sys

import jsonschema

source = pathlib.Path(sys.argv[1])
WRITTEN = {"moving"}  # which no tool prints
PLACEHOLDER = re.compile(r'"map":"[A-Z]+"')  # of a session that hides the hash


def validators():
    out = {}
    for path in sorted((source / "docs/schema").glob("*.schema.json")):
        schema = json.loads(path.read_text(encoding="utf-8"))
        jsonschema.Draft202012Validator.check_schema(schema)
        out[path.name.split(".")[0]] = jsonschema.Draft202012Validator(schema)
    return out


def records():
    """Each with its place and whether it is what a tool printed."""
    for path in sorted((source / "tests/golden").glob("*.txt")):
        for row, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
            printed = not line.startswith("> ")
            try:
                record = json.loads(PLACEHOLDER.sub(f'"map":"sha256:{"0" * 64}"', line if printed else line[2:]))
            except ValueError:
                continue
            if type(record) is dict:
                yield f"{path.name}:{row}", printed, record


known = validators()
count = {}
for place, printed, record in records():
    kind = record.get("type")
    if kind not in known or not (printed or kind in WRITTEN):
        continue
    fault = jsonschema.exceptions.best_match(known[kind].iter_errors(record))
    assert fault is None, f"{place}: {fault.message}"
    count.setdefault(kind, []).append(record)
for kind in ("report", "together", "pair", "moving", "moving_conflict", "clear_of", "clear_of_moving"):
    assert count.get(kind), f"no session has a record of type {kind}"

balloon = count["moving"][0]
for key in known["moving"].schema["required"]:
    wrong = copy.deepcopy(balloon)
    del wrong[key]
    assert not known["moving"].is_valid(wrong), key
for change in ({"speed": 3}, {"growth": [0, -1, 0]}, {"velocity": [0, 0, 2e4]}, {"min": [0, 0]}, {"until": None}, {"frame": "ned"}, {"from": "10"}):
    assert not known["moving"].is_valid(balloon | change), change
print({kind: len(some) for kind, some in count.items()})
