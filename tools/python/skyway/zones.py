"""Zones of airspace as states publish them: ED-269, ED-318, and UAS facility maps of the FAA."""

from __future__ import annotations

from typing import Any

from . import _skyway
from .arguments import File, file


def read_zones(path: File) -> dict[str, Any]:
    """All zones of a file, read to the safe side as skyway-map patch --zones reads them.

    Keys: "format", "title", "issued", "valid_from", "valid_to", "warnings" and "zones". A zone has "identifier", "name", "country", "type",
    "authority", "message", "volumes" and "periods" (none: always). A volume has "ring" and "holes", or "centre" and "radius" (metres), in
    (latitude, longitude), and "lower" and "upper": (metres, "AGL", "AMSL" or "WGS84"), or None where it is open.
    """
    zones: dict[str, Any] = _skyway.read_zones(file("path", path))
    return zones
