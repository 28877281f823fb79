"""Drone files that are proved."""

from __future__ import annotations

from typing import Any, Optional, Sequence, Union

from numpy.typing import ArrayLike

from . import _skyway
from .arguments import native, number, text
from .collision import CollisionScene
from .native import of_same_file
from .path import Path
from .solving import way
from .trajectory import Trajectory


def export_mission(scene: CollisionScene, what: Union[Path, Trajectory, ArrayLike], format: str, *,
                   origin: Optional[Sequence[float]] = None, geoid: Optional[float] = None,
                   ground: Optional[float] = None, takeoff_height: Optional[float] = None,
                   heading: Optional[float] = None, rate: Optional[float] = None, axes: Optional[str] = None,
                   tolerance: Optional[float] = None, speed: Optional[float] = None, hover: Optional[bool] = None,
                   wpml_version: Optional[str] = None, aircraft: Optional[str] = None, turns: Optional[float] = None,
                   takeoff_place: Optional[Sequence[float]] = None, lost_link: Optional[str] = None,
                   gimbal: Optional[float] = None, autopilot: Optional[str] = None, navigation: Optional[Sequence[float]] = None,
                   tracking: Optional[Sequence[float]] = None, volumes: Optional[int] = None,
                   buffer: Optional[float] = None, spare: Optional[float] = None) -> dict[str, Any]:
    """The drone file of skyway-export, proved from its bytes: `{"ok": True, "bytes": …, "warnings": […]}`, of a Tello also
    "python" and "table". Refused: `{"ok": False, "message": …}` and, where that is known, "reason" and "place".

    The options are those of skyway-export, with lists for several numbers: `origin=(47, 8, 400)`. One that the format does not
    use is a `UsageError`. `spare` is how many metres of the margin the file may use up.
    """
    asked = dict(locals())
    for name in ("scene", "what", "format"):
        del asked[name]
    asked["spare"] = None if spare is None else number("spare", spare)
    made: dict[str, Any] = _skyway.export_mission(native("scene", scene, CollisionScene), way("what", what),
                                                  text("format", format),
                                                  **{name: value for name, value in asked.items() if value is not None})
    return of_same_file(scene.map, made)
