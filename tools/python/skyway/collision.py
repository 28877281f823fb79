"""Collision scenes: what is free for one vehicle."""

from __future__ import annotations

import math
from typing import Optional, Union

import numpy
from numpy.typing import ArrayLike, NDArray

from . import _skyway
from .arguments import Bools, File, Floats, Tuple3, array, native, number, whole
from .box_map import BoxMap
from .native import Native, of_same_file
from .vehicle import Vehicle, vehicle_from


class CollisionScene(Native):
    """A map for one vehicle and margin (metres added to each half size).

    Batches are arrays or lists of numbers. C-contiguous float64 is used where it is, all else is copied. `threads` is how many
    work at once, 0 for all. A call releases the GIL, and threads may share a scene.
    """

    __slots__ = ()

    def __init__(self, map: BoxMap, vehicle: Union[File, Vehicle], margin: float = 0.0) -> None:
        self._native = _skyway.CollisionScene(native("map", map, BoxMap), vehicle_from(vehicle)._native,
                                              number("margin", margin))

    @property
    def map(self) -> BoxMap:
        """Its map."""
        return BoxMap._of(self._native.map)

    @property
    def vehicle(self) -> Vehicle:
        """Its vehicle."""
        return Vehicle._of(self._native.vehicle)

    @property
    def margin(self) -> float:
        """Metres that are added to each half size of the vehicle."""
        return self._native.margin

    @property
    def limits(self) -> dict[str, float]:
        """The limits of its vehicle."""
        return self._native.limits

    @property
    def free_bounds(self) -> Optional[tuple[Tuple3, Tuple3]]:
        """The corners of the box in which the reference point stays; None where the vehicle does not fit into the bounds."""
        return self._native.free_bounds

    def hits(self, queries: ArrayLike, *, threads: int = 0) -> Bools:
        """Whether segments (n, 6) or points (n, 3) meet an obstacle. Bounds are not looked at."""
        return of_same_file(self.map, self._native.hits(_queries(queries), threads=whole("threads", threads)))

    def free(self, queries: ArrayLike, *, threads: int = 0) -> Bools:
        """Whether segments (n, 6) or points (n, 3) are inside the bounds and clear of every obstacle."""
        return of_same_file(self.map, self._native.free(_queries(queries), threads=whole("threads", threads)))

    def sweep_hits(self, segments: ArrayLike, half: ArrayLike, *, threads: int = 0) -> Bools:
        """Whether a box of these half sizes (3), in place of the vehicle, hits anything along segments (n, 6)."""
        rows, size = array("segments", segments, (None, 6), (None, 3)), array("half", half, (3,))
        return of_same_file(self.map, self._native.sweep_hits(rows, size, threads=whole("threads", threads)))

    def nearest(self, points: ArrayLike, radius: float = math.inf, *,
                threads: int = 0) -> tuple[Floats, NDArray[numpy.int64]]:
        """Distance in metres from points (n, 3) to the nearest obstacle, and its row in `map.boxes`. Where none is within the
        radius they are inf and -1. Obstacles are grown by the vehicle, without the margin."""
        distance, box = self._native.nearest(array("points", points, (None, 3)), number("radius", radius),
                                             threads=whole("threads", threads))
        return of_same_file(self.map, (distance, box))

    def boxes_meeting(self, min: ArrayLike, max: ArrayLike) -> NDArray[numpy.uint64]:
        """Rows in `map.boxes`, ascending, of the boxes that once grown meet the closed region between two corners."""
        return of_same_file(self.map, self._native.boxes_meeting(array("min", min, (3,)), array("max", max, (3,))))

    def __repr__(self) -> str:
        return f"CollisionScene({self.map!r}, {self.vehicle!r}, margin {self.margin:g} m)"


def _queries(queries: ArrayLike) -> Floats:
    return array("queries", queries, (None, 6), (None, 3))
