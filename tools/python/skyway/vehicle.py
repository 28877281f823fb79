"""Vehicles, and what a record says of its origin."""

from __future__ import annotations

from typing import Optional, Union

from . import _skyway
from .arguments import File, Tuple3, file
from .native import Native


class Vehicle(Native):
    """The box that holds a vehicle in every attitude, and what the vehicle may do.

    `name` is a vehicle that Skyway knows ("tello"), a vehicle file (FILE.json), "box:HX,HY,HZ" or "sphere:R" (half sizes
    and radius in metres).
    """

    __slots__ = ()

    def __init__(self, name: File) -> None:
        self._native = _skyway.vehicle(file("vehicle", name))

    @property
    def name(self) -> str:
        """What it was made from, or the name in its file."""
        return self._native.name

    @property
    def half(self) -> Tuple3:
        """Half sizes in metres around the reference point."""
        x, y, z = self._native.half
        return x, y, z

    @property
    def limits(self) -> dict[str, float]:
        """What its profile allows, in SI units by the names of records. `tilt` is the one up to which `half` holds it."""
        return self._native.limits

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Vehicle):
            return NotImplemented
        return bool(self._native == other._native)

    def __hash__(self) -> int:
        return hash((self.name, self.half))

    def __repr__(self) -> str:
        return f"Vehicle({self.name!r}, half=({', '.join(f'{h:g}' for h in self.half)}) m)"


def vehicle_from(value: Union[File, Vehicle]) -> Vehicle:
    """A vehicle, or what names one."""
    return value if isinstance(value, Vehicle) else Vehicle(value)


class MadeFor(Native):
    """What a record says of its origin; None where it does not say."""

    __slots__ = ()

    @property
    def map(self) -> Optional[str]:
        """The hash of its map."""
        return self._native.map

    @property
    def frame(self) -> Optional[str]:
        """The axes of its coordinates, "enu" or "neu"."""
        return self._native.frame

    @property
    def vehicle(self) -> Optional[Vehicle]:
        """The vehicle that it was made for."""
        return None if self._native.vehicle is None else Vehicle._of(self._native.vehicle)

    @property
    def margin(self) -> Optional[float]:
        """Metres that were added to each half size of the vehicle."""
        return self._native.margin
