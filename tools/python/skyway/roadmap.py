"""Roadmaps: places where a path may bend, and which of them see each other."""

from __future__ import annotations

import numpy
from numpy.typing import NDArray

from . import _skyway
from .arguments import File, Floats, file
from .vehicle import MadeFor


class Roadmap(MadeFor):
    """Places at the edges of boxes where a path may bend, and the edges between those that see each other. `len` is the number
    of bends. docs/formats.md explains the arrays."""

    __slots__ = ()

    def __init__(self) -> None:
        raise TypeError("a Roadmap comes from read_roadmap; skyway-roadmap makes its file")

    def __len__(self) -> int:
        return len(self._native)

    @property
    def part(self) -> float:
        """The longest stretch of a box edge that gets one bend, metres."""
        return self._native.part

    @property
    def reach(self) -> float:
        """The longest edge, metres."""
        return self._native.reach

    @property
    def tile_index(self) -> NDArray[numpy.int32]:
        """(t, 2): the place of each tile in plan."""
        return self._native.tile_index

    @property
    def tile_extent(self) -> NDArray[numpy.float32]:
        """(t, 6): the bounding box of the bends of each tile, metres, rounded outward."""
        return self._native.tile_extent

    @property
    def tile_first(self) -> NDArray[numpy.uint64]:
        """(t + 1): bends of tile k are `tile_first[k]` to before `tile_first[k + 1]`."""
        return self._native.tile_first

    @property
    def tile_edges(self) -> NDArray[numpy.uint64]:
        """(t + 1): edges of its bends, in the same way."""
        return self._native.tile_edges

    @property
    def bend_position(self) -> Floats:
        """(n, 3), metres."""
        return self._native.bend_position

    @property
    def bend_axis(self) -> NDArray[numpy.int8]:
        """(n): the axis along which its box edge runs."""
        return self._native.bend_axis

    @property
    def bend_outward(self) -> NDArray[numpy.int8]:
        """(n, 2): signs along the next two axes, away from the box."""
        return self._native.bend_outward

    @property
    def edge_first(self) -> NDArray[numpy.uint32]:
        """(n): where the edges of each bend begin, counted from the first of its tile."""
        return self._native.edge_first

    @property
    def edge_split(self) -> NDArray[numpy.uint32]:
        """(n): how many of them lead to one side of the bend; the others lead to the other side."""
        return self._native.edge_split

    @property
    def edge_to(self) -> NDArray[numpy.uint32]:
        """The bend at the end of each edge."""
        return self._native.edge_to

    def __repr__(self) -> str:
        return f"Roadmap({len(self)} bends, {len(self.edge_to)} edges)"


def read_roadmap(path: File) -> Roadmap:
    """A roadmap from its file, which is mapped."""
    return Roadmap._of(_skyway.read_roadmap(file("path", path)))
