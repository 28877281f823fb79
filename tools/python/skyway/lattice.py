"""Lattices: a regular grid of points, and its free edges."""

from __future__ import annotations

import numpy
from numpy.typing import NDArray

from . import _skyway
from .arguments import File, Tuple3, file
from .vehicle import MadeFor


class Lattice(MadeFor):
    """A regular grid of points, and which of its edges are free. `len` is the number of its points."""

    __slots__ = ()

    def __init__(self) -> None:
        raise TypeError("a Lattice comes from read_lattice; skyway-lattice makes its file")

    def __len__(self) -> int:
        return len(self._native)

    @property
    def spacing(self) -> float:
        """Metres between neighbours along an axis."""
        return self._native.spacing

    @property
    def origin(self) -> Tuple3:
        """The point from which its planes are counted, metres."""
        return self._native.origin

    @property
    def connectivity(self) -> int:
        """6, 18 or 26 neighbours."""
        return self._native.connectivity

    @property
    def first(self) -> list[int]:
        """The index of its lowest point on each axis, counted from the origin."""
        return self._native.first

    @property
    def dims(self) -> list[int]:
        """How many points it has along x, y and z."""
        return self._native.dims

    @property
    def nodes(self) -> int:
        """How many points are free."""
        return self._native.nodes

    @property
    def edges(self) -> int:
        """How many edges are free."""
        return self._native.edges

    @property
    def block_record(self) -> NDArray[numpy.uint32]:
        """The record of each block, as docs/formats.md says."""
        return self._native.block_record

    @property
    def records(self) -> NDArray[numpy.uint8]:
        """The packed records, as docs/formats.md says."""
        return self._native.records

    def masks(self) -> NDArray[numpy.uint32]:
        """(nz, ny, nx): bit 31 where the point is free, bit d where its edge in direction d is."""
        return self._native.masks()

    def __repr__(self) -> str:
        return f"Lattice({' x '.join(map(str, self.dims))} points, {self.spacing:g} m apart, {self.nodes} free)"


def read_lattice(path: File) -> Lattice:
    """A lattice from its file, which is mapped."""
    return Lattice._of(_skyway.read_lattice(file("path", path)))
