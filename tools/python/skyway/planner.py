"""Planners: from queries to paths."""

from __future__ import annotations

from typing import Any, Optional, Sequence

from numpy.typing import ArrayLike

from . import _skyway
from .arguments import array, native, number, text, texts, whole
from .collision import CollisionScene
from .lattice import Lattice
from .native import Native, of_same_file
from .path import Path
from .roadmap import Roadmap


class Planner(Native):
    """Plans paths in a scene, with a lattice or a roadmap of the same map, vehicle and margin where there is one.

    `method` and `quality` are those of skyway-plan. `raw` gives the search's own path, neither shortened nor pulled taut.
    `resample` cuts the path into equal parts of at most so many metres. `snap_ends` lets a blocked or outside end move so many
    metres. Equal seeds give equal paths.
    """

    __slots__ = ("_scene", )
    _scene: CollisionScene

    def __init__(self, scene: CollisionScene, lattice: Optional[Lattice] = None,
                 roadmap: Optional[Roadmap] = None) -> None:
        self._native = _skyway.Planner(native("scene", scene, CollisionScene),
                                       None if lattice is None else native("lattice", lattice, Lattice),
                                       None if roadmap is None else native("roadmap", roadmap, Roadmap))
        self._scene = scene

    def plan(self, start: ArrayLike, goal: ArrayLike, *, id: str = "q1", method: str = "auto", quality: str = "normal",
             raw: bool = False, resample: float = 0.0, snap_ends: float = 0.0, seed: int = 0) -> Path:
        """The path between two points (3), or one whose status says why there is none."""
        path = self._native.plan(array("start", start, (3,)), array("goal", goal, (3,)), id=text("id", id),
                                 **_words(method, quality, raw, resample, snap_ends, seed))
        return of_same_file(self._scene.map, Path._of(path))

    def plan_batch(self, queries: ArrayLike, *, ids: Optional[Sequence[str]] = None, method: str = "auto",
                   quality: str = "normal", raw: bool = False, resample: float = 0.0, snap_ends: float = 0.0,
                   seed: int = 0, threads: int = 0) -> list[Path]:
        """A path for each row of queries (n, 6), from and to. The ids are q1, q2 and so on where none are given."""
        names = None if ids is None else texts("ids", ids)
        paths = self._native.plan_batch(array("queries", queries, (None, 6)), ids=names, threads=whole("threads", threads),
                                        **_words(method, quality, raw, resample, snap_ends, seed))
        return of_same_file(self._scene.map, [Path._of(path) for path in paths])

    def __repr__(self) -> str:
        return f"Planner({self._scene!r})"


def _words(method: str, quality: str, raw: bool, resample: float, snap_ends: float, seed: int) -> dict[str, Any]:
    return dict(method=text("method", method), quality=text("quality", quality), raw=bool(raw),
                resample=number("resample", resample), snap_ends=number("snap_ends", snap_ends), seed=whole("seed", seed))
