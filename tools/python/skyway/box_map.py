"""Box maps: a city or a room as closed boxes."""

from __future__ import annotations

from typing import Any, Optional, Sequence

import numpy
from numpy.typing import ArrayLike, NDArray

from . import _skyway
from .arguments import File, Floats, Tuple3, array, file, native, number, require_unmasked, texts
from .native import Native
from .notebook import small

_MOST_DRAWN = 20000  # boxes in a picture inside a notebook


class BoxMap(Native):
    """A map of closed boxes, read from a file or made here.

    `boxes` (n, 6) has the lower and the upper corner of each obstacle, in metres: min x, y, z, max x, y, z. `bounds` are the
    two corners of the box in which the whole vehicle stays. Without them the bounds are the bounding box of the obstacles,
    with `floor`, `ceiling` and `pad` metres sideways and upward. `frame` is "enu" or "neu", `origin` the latitude, longitude
    and height of (0, 0, 0). There may be `ids` and `labels`, one a box.

    The arrays of a map are read-only views of its memory, and keep it alive.
    """

    __slots__ = ()

    def __init__(self, boxes: ArrayLike, *, bounds: Optional[ArrayLike] = None, frame: str = "enu",
                 ids: Optional[ArrayLike] = None, labels: Optional[Sequence[str]] = None,
                 origin: Optional[Sequence[float]] = None, floor: Optional[float] = None,
                 ceiling: Optional[float] = None, pad: Optional[float] = None, seal: float = 0.0, inflate: float = 0.0,
                 tile: float = 100.0) -> None:
        rows = array("boxes", boxes, (None, 6))
        wrong = numpy.flatnonzero((rows[:, :3] > rows[:, 3:]).any(axis=1))
        if wrong.size:
            raise ValueError(f"boxes[{wrong[0]}]: expected min <= max on every axis, found {rows[wrong[0]].tolist()}")
        corners = None if bounds is None else array("bounds", bounds, (2, 3)).tolist()
        self._native = _skyway.make_box_map(
            rows, _ids(ids, len(rows)), _labels(labels, len(rows)),
            dict(bounds=corners, frame=frame, origin=origin, floor=floor, ceiling=ceiling, pad=pad,
                 seal=number("seal", seal), inflate=inflate, tile=tile, scale=1.0, bloat_percent=0.0))

    def __len__(self) -> int:
        return len(self._native)

    @property
    def boxes(self) -> Floats:
        """(n, 6), metres: the lower and the upper corner of each, in the order of the file."""
        return self._native.boxes

    @property
    def ids(self) -> NDArray[numpy.uint64]:
        """(n): the number of each box in its source."""
        return self._native.ids

    @property
    def label(self) -> NDArray[numpy.uint32]:
        """(n): where the label of each box stands in `labels`."""
        return self._native.label

    @property
    def labels(self) -> list[str]:
        """Each label once; the first is "", for boxes without."""
        return self._native.labels

    @property
    def hash(self) -> str:
        """"sha256:" and 64 digits, of frame, bounds and boxes. Records name their map by it."""
        return self._native.hash

    @property
    def frame(self) -> str:
        """The axes: "enu" (x east, y north) or "neu" (x north, y east)."""
        return self._native.frame

    @property
    def origin(self) -> Optional[Tuple3]:
        """Latitude and longitude in degrees and height in metres of (0, 0, 0); None where nobody knows."""
        return self._native.origin

    @property
    def crs(self) -> str:
        """The coordinate reference system of the source, or ""."""
        return self._native.crs

    @property
    def bounds(self) -> tuple[Tuple3, Tuple3]:
        """The two corners of the closed box in which the whole vehicle stays, metres."""
        return self._native.bounds

    @property
    def tile_size(self) -> float:
        """The side of its tiles, metres."""
        return self._native.tile_size

    @property
    def history(self) -> Optional[list[dict[str, Any]]]:
        """How it was made, a dictionary a step."""
        return self._native.history

    def __repr__(self) -> str:
        low, high = (f"({', '.join(f'{x:g}' for x in corner)})" for corner in self.bounds)
        boxes = "1 box" if len(self) == 1 else f"{len(self)} boxes"
        return f"BoxMap({boxes}, bounds {low} to {high} m, {self.frame})"

    def _repr_svg_(self) -> Optional[str]:
        """The map from above; None for more boxes than a notebook should hold."""
        return small(_skyway.plan_svg(self._native, [])) if len(self) <= _MOST_DRAWN else None


def _ids(ids: Optional[ArrayLike], count: int) -> Optional[list[int]]:
    if ids is None:
        return None
    require_unmasked("ids", ids)
    given = numpy.asarray(ids)
    if given.dtype.kind not in "iu" and given.size:
        raise TypeError(f"ids: expected whole numbers, found {ids!r}")
    if given.shape != (count,):
        raise ValueError(f"ids: expected shape ({count},), one a box, found {given.shape}")
    if count and given.min() < 0:
        raise ValueError(f"ids: expected whole numbers >= 0, found {given.min()}")
    return given.tolist()


def _labels(labels: Optional[Sequence[str]], count: int) -> Optional[list[str]]:
    if labels is None:
        return None
    given = texts("labels", labels)
    if len(given) != count:
        raise ValueError(f"labels: expected {count}, one a box, found {len(given)}")
    return given


def read_box_map(path: File) -> BoxMap:
    """A map from its file, which is mapped, not copied. The extents of its tiles are verified when boxes are first read, and
    all of it by `check`."""
    return BoxMap._of(_skyway.read_box_map(file("path", path)))


def write_box_map(path: File, map: BoxMap) -> None:
    """Writes the map to a file, whole or not at all."""
    _skyway.write_box_map(file("path", path), native("map", map, BoxMap))
