"""Returns and ways home: what a vehicle does if its mission ends early."""

from __future__ import annotations

import json
from typing import Any, Mapping, Optional, Sequence, Union

from numpy.typing import ArrayLike

from . import _skyway
from .arguments import File, array, file, limits as limits_from, native, number, text
from .collision import CollisionScene
from .native import of_same_file
from .path import Path
from .solving import way
from .trajectory import Trajectory


def check_return(scene: CollisionScene, what: Union[Path, Trajectory, ArrayLike], *, action: str = "rtl",
                 return_height: Optional[float] = None, home_place: Optional[Sequence[float]] = None,
                 limits: Optional[Mapping[str, float]] = None, autopilot: str = "any",
                 navigation: Optional[Sequence[float]] = None) -> dict[str, Any]:
    """The report of skyway-check --return: whether the autopilot's own return is clear from every instant.

    Its key "return" has the share of the time and the gaps, as docs/formats.md has it. `action` is "rtl", "land" or "hold". A path is
    flown with `limits={"vmax": …}`. `navigation` is how wrong the vehicle may be about its place: metres across, and up or down.
    """
    report: dict[str, Any] = _skyway.check_return(
        native("scene", scene, CollisionScene), way("what", what), action=text("action", action),
        return_height=None if return_height is None else number("return_height", return_height),
        home_place=_numbers("home_place", home_place, 3), limits=limits_from(limits), autopilot=text("autopilot", autopilot),
        navigation=_numbers("navigation", navigation, 2))
    return of_same_file(scene.map, report)


def ways_home(scene: CollisionScene, what: Union[Path, Trajectory, ArrayLike], sites: File, *, local: bool = False,
              limits: Optional[Mapping[str, float]] = None, autopilot: str = "any",
              navigation: Optional[Sequence[float]] = None) -> list[dict[str, Any]]:
    """Ways to landing sites from every instant of a flight: the records "contingency" of skyway-plan --home.

    `sites` is a GeoJSON file with points and polygons, in degrees or, with `local`, in the map's metres. The battery is not looked at. The
    scene's margin must be at least what the autopilots stray.
    """
    ways = _skyway.ways_home(native("scene", scene, CollisionScene), way("what", what), file("sites", sites), local=_flag("local", local),
                             limits=limits_from(limits), autopilot=text("autopilot", autopilot),
                             navigation=_numbers("navigation", navigation, 2))
    return of_same_file(scene.map, list(ways))


def check_ways_home(scene: CollisionScene, what: Union[Path, Trajectory, ArrayLike], ways: Sequence[Mapping[str, Any]], *,
                    limits: Optional[Mapping[str, float]] = None, autopilot: str = "any",
                    navigation: Optional[Sequence[float]] = None) -> dict[str, Any]:
    """The report of skyway-check --contingencies: `ways`, as ways_home() gives them, proved anew."""
    if isinstance(ways, (str, bytes)) or not hasattr(ways, "__iter__"):
        raise TypeError(f"ways: expected records of ways home, found {type(ways).__name__}")
    lines = [json.dumps(dict(one)) for one in ways]
    report: dict[str, Any] = _skyway.check_ways_home(native("scene", scene, CollisionScene), way("what", what), lines,
                                                     limits=limits_from(limits), autopilot=text("autopilot", autopilot),
                                                     navigation=_numbers("navigation", navigation, 2))
    return of_same_file(scene.map, report)


def _flag(name: str, value: Any) -> bool:
    if not isinstance(value, bool):
        raise TypeError(f"{name}: expected True or False, found {type(value).__name__}")
    return value


def _numbers(name: str, value: Optional[Sequence[float]], count: int) -> Optional[list[float]]:
    if value is None:
        return None
    numbers: list[float] = array(name, value, (count,)).tolist()
    return numbers
