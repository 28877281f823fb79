"""Missions as files give them: QGC WPL 110 (.waypoints) and QGroundControl's .plan (simple items, fence, rally)."""

import dataclasses
import json
import math
import pathlib

NAN = math.nan
GLOBAL_FRAMES = {0, 3, 5, 6, 10, 11}  # absolute, above home, their integer kin, above terrain
DO_JUMP = 177


@dataclasses.dataclass
class Item:
    command: int
    frame: int
    params: list  # seven numbers; 5 to 7 are latitude, longitude and altitude in a global frame
    autocontinue: int = 1

    def wire(self):
        """The numbers of MISSION_ITEM_INT."""
        scale = 1e7 if self.frame in GLOBAL_FRAMES else 1
        x, y = (0 if math.isnan(v) else round(v * scale) for v in self.params[4:6])
        p = self.params
        return dict(param1=p[0], param2=p[1], param3=p[2], param4=p[3], x=x, y=y, z=p[6], command=self.command,
                    frame=self.frame, autocontinue=self.autocontinue)


@dataclasses.dataclass
class Mission:
    home: tuple | None  # latitude, longitude, altitude
    items: list = dataclasses.field(default_factory=list)  # without home; a jump's target counts home as 0
    fence: list = dataclasses.field(default_factory=list)
    rally: list = dataclasses.field(default_factory=list)


def _wpl(text, name):
    lines = [line for line in text.splitlines() if line.strip()]
    if not lines or not lines[0].startswith("QGC WPL 110"):
        raise ValueError(f"{name}: the first line is not QGC WPL 110.")
    rows = []
    for line in lines[1:]:
        cells = line.split()
        if len(cells) != 12:
            raise ValueError(f"{name}: a row has {len(cells)} columns, expected 12: {line!r}.")
        rows.append((int(cells[2]), int(cells[3]), [float(c) for c in cells[4:11]], int(float(cells[11]))))
    if not rows:
        raise ValueError(f"{name}: the file has no items.")
    home = tuple(rows[0][2][4:7])
    return Mission(home, [Item(command, frame, params, go) for frame, command, params, go in rows[1:]])


def _number(value):
    return NAN if value is None else float(value)


def _plan(text, name):
    document = json.loads(text)
    mission = document["mission"]
    home = mission.get("plannedHomePosition")
    result = Mission(tuple(float(v) for v in home) if home else None)
    for item in mission["items"]:
        if item["type"] != "SimpleItem":
            raise ValueError(f"{name}: an item has the type {item['type']!r}, expected SimpleItem.")
        params = [_number(v) for v in item["params"]]
        result.items.append(Item(item["command"], item["frame"], params, int(item.get("autoContinue", True))))
    fence = document.get("geoFence", {})
    for polygon in fence.get("polygons", []):
        corners = polygon["polygon"]
        command = 5001 if polygon.get("inclusion", True) else 5002
        for latitude, longitude in corners:
            result.fence.append(Item(command, 0, [len(corners), 0, 0, 0, latitude, longitude, 0]))
    for circle in fence.get("circles", []):
        command = 5003 if circle.get("inclusion", True) else 5004
        round_ = circle["circle"]
        result.fence.append(Item(command, 0, [round_["radius"], 0, 0, 0, *round_["center"], 0]))
    for latitude, longitude, altitude in document.get("rallyPoints", {}).get("points", []):
        result.rally.append(Item(5100, 3, [0, 0, 0, 0, latitude, longitude, altitude]))
    return result


def read(path):
    """The mission of a file, by what the file begins with."""
    text = pathlib.Path(path).read_text(encoding="utf-8-sig")
    return _plan(text, path) if text.lstrip().startswith("{") else _wpl(text, path)


def shifted(items, by):
    """The items with the targets of their jumps moved, for an autopilot that counts home or one that does not."""
    moved = []
    for item in items:
        params = list(item.params)
        if item.command == DO_JUMP:
            params[0] += by
        moved.append(dataclasses.replace(item, params=params))
    return moved
