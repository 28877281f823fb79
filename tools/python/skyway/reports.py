"""The reports of skyway-check as one NumPy table."""

from __future__ import annotations

import json
from typing import Any

import numpy
from numpy.typing import NDArray

from ._skyway import _limited_quantities, _refuse
from .arguments import File, file

_EXTREMES = ("clearance", *_limited_quantities)
_NUMBERS = ("time", "worst", "duration", *(name for e in _EXTREMES for name in (e, e + "_time")))


def _parse(line: str, source: str, number: int) -> dict[str, Any]:
    def refuse(**fault: str) -> None:
        _refuse(source=source, line=number, **fault)

    try:
        record = json.loads(line)
    except ValueError as error:
        refuse(says=f"not JSON: {error}")
    if not isinstance(record, dict) or record.get("type") != "report":
        found = record.get("type") if isinstance(record, dict) else line[:40]
        refuse(expected='a record of type "report"', found=json.dumps(found))
    if not isinstance(record.get("id"), str):
        refuse(key="id", expected="text", found=json.dumps(record.get("id")))
    if not isinstance(record.get("ok"), bool):
        refuse(key="ok", expected="true or false", found=json.dumps(record.get("ok")))
    for key in _NUMBERS:
        value = record.get(key, 0)
        if isinstance(value, bool) or not isinstance(value, (int, float)):
            refuse(key=key, expected="a number", found=json.dumps(value))
    for key, size in (("place", 3), ("jumps", 7)):
        value = record.get(key)
        if value is not None and not (isinstance(value, list) and len(value) == size
                                      and all(isinstance(v, (int, float)) for v in value)):
            refuse(key=key, expected=f"a list of {size} numbers", found=json.dumps(value))
    return record


def read_reports(path: File) -> NDArray[Any]:
    """One row a report: id, checked, ok, exact_ok, reason, box, place, jumps and the numbers of docs/formats.md; NaN,
    "" or -1 where a report does not say."""
    source = file("path", path)
    with open(source, encoding="utf-8", errors="replace") as lines:
        records = [_parse(line, source, number) for number, line in enumerate(lines, 1) if line.strip()]
    if not records:
        _refuse(source=source, expected="at least one record", found="none")

    def width(key: str) -> str:
        return f"U{max(1, *(len(str(r.get(key, ''))) for r in records))}"

    table = numpy.zeros(len(records), dtype=[
        ("id", width("id")), ("checked", width("checked")), ("ok", bool), ("exact_ok", bool), ("reason", width("reason")),
        ("box", "i8"), ("place", "f8", 3), ("jumps", "f8", 7), *((name, "f8") for name in _NUMBERS)])
    for row, record in zip(table, records):
        for key in ("id", "checked", "reason"):
            row[key] = record.get(key, "")
        row["ok"] = record["ok"]
        row["exact_ok"] = bool((record.get("exact") or {}).get("ok"))
        row["box"] = record.get("box", -1)
        for key in ("place", "jumps", *_NUMBERS):
            row[key] = record.get(key, numpy.nan)
    return table
