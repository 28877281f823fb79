"""Paths and the queries that they answer."""

from __future__ import annotations

import json
from typing import Any, Iterable, Optional, Self

import numpy
from numpy.typing import ArrayLike

from . import _skyway
from .arguments import File, Floats, array, file, native, natives, text
from .collision import CollisionScene
from .notebook import small
from .vehicle import MadeFor


class Path(MadeFor):
    """A path, planned, read from a file, or made here of its points (n, 3) in metres.

    A path that was made here names no map, vehicle or margin, so that it is taken as one for the scene that it is used with.
    `hold` (n) has seconds to stand still at each point, `velocity` (n, 3) metres a second, NaN where it is free.
    """

    __slots__ = ()

    def __init__(self, points: ArrayLike, *, id: str = "q1", hold: Optional[ArrayLike] = None,
                 velocity: Optional[ArrayLike] = None) -> None:
        rows = array("points", points, (None, 3))
        if not len(rows):
            raise ValueError("points: expected at least one, found none")
        record: dict[str, Any] = {"type": "path", "id": text("id", id), "status": "found", "points": _finite("points", rows)}
        if hold is not None:
            record["hold"] = _finite("hold", array("hold", hold, (len(rows),)))
        if velocity is not None:
            given = array("velocity", velocity, (len(rows), 3))
            record["velocity"] = [None if numpy.isnan(v).all() else _finite("velocity", v) for v in given]
        self._native = _skyway.Path.from_json(json.dumps(record), "Path")

    @property
    def id(self) -> str:
        """Its name, by which reports and trajectories refer to it."""
        return self._native.id

    @property
    def status(self) -> str:
        """"found", or why there is no path: "unreachable", "start_blocked", "goal_blocked", "start_outside", "goal_outside",
        "stopped"."""
        return self._native.status

    @property
    def message(self) -> str:
        """Why there is no path, in words; may be empty."""
        return self._native.message

    @property
    def length(self) -> float:
        """Metres."""
        return self._native.length

    @property
    def points(self) -> Floats:
        """(n, 3), metres; empty where there is no path."""
        return self._native.points

    @property
    def hold(self) -> Optional[Floats]:
        """(n): seconds to stand still at each point, or None."""
        return self._native.hold

    @property
    def velocity(self) -> Optional[Floats]:
        """(n, 3): metres a second, NaN where it is free; or None."""
        return self._native.velocity

    @property
    def search(self) -> Optional[dict[str, Any]]:
        """What its planner tells: the method, its effort, ends that it moved."""
        return self._native.search

    def to_json(self) -> str:
        """The line of its file, with a newline."""
        return self._native.to_json()

    @classmethod
    def from_json(cls, line: str) -> Self:
        """The path of a line of JSON."""
        return cls._of(_skyway.Path.from_json(text("line", line), "record"))

    def __len__(self) -> int:
        return len(self._native.points)

    def __reduce__(self) -> Any:
        return Path.from_json, (self.to_json(),)

    def __repr__(self) -> str:
        found = f"{len(self)} points, {self.length:.1f} m" if self.status == "found" else self.status
        return f"Path({self.id!r}, {found})"

    def _repr_svg_(self) -> Optional[str]:
        """The path from above; `plot_plan` draws it on its map."""
        return small(_skyway.plan_svg(None, [self._native])) if len(self) else None


def _finite(name: str, values: Floats) -> Any:
    if not numpy.isfinite(values).all():
        raise ValueError(f"{name}: expected finite numbers, found {values[~numpy.isfinite(values)][0]}")
    return values.tolist()


def read_paths(path: File) -> list[Path]:
    """The paths of a file of JSON Lines."""
    return [Path._of(one) for one in _skyway.read_paths(file("path", path))]


def write_paths(path: File, records: Iterable[Path]) -> None:
    """Writes paths as JSON Lines, the whole file or nothing."""
    _skyway.write_paths(file("path", path), natives("records", records, Path))


def read_queries(path: File, scene: Optional[CollisionScene] = None) -> tuple[list[str], Floats]:
    """The ids of a file of queries, and (n, 6): from and to, in metres.

    A query that says a map, frame, vehicle or margin is refused unless a `scene` is given that has just these.
    """
    ids, ends = _skyway.read_queries(file("path", path), None if scene is None else native("scene", scene, CollisionScene))
    return ids, ends
