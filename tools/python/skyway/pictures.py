"""Pictures of maps, paths and motion, and the page that shows all of them."""

from __future__ import annotations

import html
import pathlib
from typing import Any, Iterable, Mapping, Optional, Union

from . import _skyway
from .arguments import File, native, natives, text, whole
from .box_map import BoxMap
from .collision import CollisionScene
from .flight_log import FlightLog
from .lattice import Lattice
from .native import of_same_file
from .path import Path
from .trajectory import Trajectory

_Way = Union[Path, Trajectory, FlightLog]
_WAYS = (Path, Trajectory, FlightLog)


class Picture:
    """An SVG picture. Notebooks show it."""

    def __init__(self, svg: str) -> None:
        self.svg = svg
        """The picture as text."""

    def save(self, path: File) -> None:
        """Writes the picture to a file."""
        pathlib.Path(path).write_text(self.svg, encoding="utf-8")

    def __repr__(self) -> str:
        return f"Picture({len(self.svg)} bytes of SVG)"

    def _repr_svg_(self) -> str:
        return self.svg


class Page:
    """The page of skyway-view: one HTML file that needs nothing else. Notebooks show it in a frame."""

    def __init__(self, text: str) -> None:
        self.html = text
        """The page as text."""

    def save(self, path: File) -> None:
        """Writes the page to a file, which any browser opens."""
        pathlib.Path(path).write_text(self.html, encoding="utf-8")

    def __repr__(self) -> str:
        return f"Page({len(self.html)} bytes of HTML)"

    def _repr_html_(self) -> str:
        return f'<iframe srcdoc="{html.escape(self.html)}" style="width:100%;height:640px;border:0"></iframe>'


def plot_plan(map: BoxMap, records: Union[_Way, Iterable[_Way]] = ()) -> Picture:
    """The map from above, with paths, trajectories and flights."""
    drawn = _skyway.plan_svg(native("map", map, BoxMap), natives("records", records, *_WAYS))
    return of_same_file(map, Picture(drawn))


def plot_profile(trajectory: Trajectory) -> Picture:
    """Position, speed, acceleration, jerk, thrust and tilt over time, with the limits of the trajectory."""
    return Picture(_skyway.profile_svg(native("trajectory", trajectory, Trajectory)))


def plot_clearance(scene: CollisionScene, records: Union[_Way, Iterable[_Way]]) -> Picture:
    """The distance to the nearest obstacle over time, or along paths where there are only those."""
    drawn = _skyway.clearance_svg(native("scene", scene, CollisionScene), natives("records", records, *_WAYS))
    return of_same_file(scene.map, Picture(drawn))


def plot_tracking(flight: FlightLog, trajectory: Optional[Trajectory] = None) -> Picture:
    """A flight beside its setpoints, and beside the trajectory that it followed."""
    return Picture(_skyway.tracking_svg(native("flight", flight, FlightLog),
                                        None if trajectory is None else native("trajectory", trajectory, Trajectory)))


def page(map: Optional[BoxMap] = None, records: Union[_Way, Lattice, Iterable[Union[_Way, Lattice]]] = (), *,
         reports: Iterable[Mapping[str, Any]] = (), title: str = "Skyway", threads: int = 0) -> Page:
    """The page of skyway-view, in three dimensions: the map, lattices, paths, trajectories and flights, and what reports of
    `check` say of them."""
    drawn = _skyway.page_html(None if map is None else native("map", map, BoxMap),
                              natives("records", records, *_WAYS, Lattice), [dict(report) for report in reports],
                              text("title", title), whole("threads", threads))
    return Page(drawn) if map is None else of_same_file(map, Page(drawn))
