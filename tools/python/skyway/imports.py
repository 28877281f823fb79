"""Box maps from what others write: tables and worlds, footprints and city models, point clouds, models of triangles."""

from __future__ import annotations

import importlib
import warnings
from typing import Any, Optional, Sequence, Union

from numpy.typing import ArrayLike

from . import _skyway
from .arguments import File, array, file
from .box_map import BoxMap

_PACKAGES = {"_skyway_gis": "skyway-footprints", "_skyway_cloud": "skyway-cloud", "_skyway_mesh": "skyway-mesh"}


def _part(name: str) -> Any:
    """A module that is there only where its package is installed."""
    try:
        return importlib.import_module(name)
    except ModuleNotFoundError as error:
        message = f"this needs the Debian package {_PACKAGES[name]}, or a build with its readers: {error}"
        raise ImportError(message, name=error.name) from None


def _made(function: Any, keywords: dict[str, Any]) -> BoxMap:
    path = file("path", keywords.pop("path"))
    if keywords["bounds"] is not None:
        keywords["bounds"] = array("bounds", keywords["bounds"], (2, 3)).tolist()
    box_map, said = function(path, keywords)
    for text in said:
        warnings.warn(_skyway.in_python(text), stacklevel=3)
    return BoxMap._of(box_map)


def import_boxes(path: File, *, format: str = "auto", frame: Optional[str] = None, units: str = "m",
                 unknown: str = "free", slack: float = 0.1, collisions_only: bool = False,
                 without: Sequence[str] = (), model_path: Sequence[File] = (), allow_skipped: bool = False,
                 seal: Optional[float] = None, floor: Optional[float] = None, ceiling: Optional[float] = None,
                 pad: Optional[float] = None, scale: float = 1.0, bloat_percent: float = 0.0, inflate: float = 0.0,
                 bounds: Optional[ArrayLike] = None, tile: float = 100.0) -> BoxMap:
    """A table, block text, world, voxel map or octree, as skyway-import makes it.

    The keyword arguments of this and of the other three are the options of the tool. A value out of its range is a
    `UsageError`. What the tool warns of goes to `warnings`. `bounds` are two corners, lengths are metres.
    """
    keywords = dict(locals())
    try:
        reader = _part("_skyway_mesh")  # which reads meshes of COLLADA, too
    except ImportError:
        reader = _skyway
    return _made(reader.import_boxes, keywords)


def import_footprints(path: File, *, format: str = "auto", slack: float = 0.5,
                      height_attribute: Optional[str] = None, storey: float = 3.0,
                      default_height: Optional[float] = None, types: Sequence[str] = (), label_by: str = "type",
                      where: Optional[str] = None, height_step: float = 0.5, terrain: Optional[File] = None, origin: Optional[Sequence[float]] = None,
                      height_units: Optional[str] = None, axes: Optional[str] = None, metres: bool = False,
                      allow_skipped: bool = False, seal: Optional[float] = None, floor: Optional[float] = None,
                      ceiling: Optional[float] = None, pad: Optional[float] = None, scale: float = 1.0,
                      bloat_percent: float = 0.0, inflate: float = 0.0, bounds: Optional[ArrayLike] = None,
                      tile: float = 100.0, threads: int = 0) -> BoxMap:
    """GeoJSON, OpenStreetMap, CityJSON, CityGML, height models and more, as skyway-footprints makes it.

    It needs the package skyway-footprints; an `ImportError` says so. `origin` is latitude and longitude in degrees.
    """
    keywords = {**locals(), "terrain": None if terrain is None else file("terrain", terrain)}
    return _made(_part("_skyway_gis").import_footprints, keywords)


def import_cloud(path: File, *, format: str = "auto", mode: str = "columns", cell: float = 1.0, step: float = 0.5,
                 gap: float = 2.0, unknown: str = "free", classes: Sequence[Union[str, int]] = (),
                 noise_points: str = "keep", outliers: Optional[tuple[int, float]] = None, voxel: Optional[float] = None,
                 resolution: Optional[float] = None, ground_points: str = "keep", ground_by: str = "auto",
                 ground_cell: float = 2.0, ground_slope: float = 0.1, ground_height: float = 0.3,
                 ground_step: float = 1.0, ground_widest: float = 200.0, tolerance: float = 1.0, min_points: int = 1,
                 crs: Optional[str] = None, units: Optional[str] = None, vertical_units: Optional[str] = None,
                 origin: Union[None, str, Sequence[float]] = None, allow_skipped: bool = False,
                 seal: Optional[float] = None, floor: Optional[float] = None, ceiling: Optional[float] = None,
                 pad: Optional[float] = None, scale: float = 1.0, bloat_percent: float = 0.0, inflate: float = 0.0,
                 bounds: Optional[ArrayLike] = None, tile: float = 100.0, threads: int = 0) -> BoxMap:
    """LAS, LAZ, COPC, PCD, PLY or XYZ, as skyway-cloud makes it.

    It needs the package skyway-cloud; an `ImportError` says so. `origin` is latitude, longitude and perhaps height, or "auto".
    """
    keywords = dict(locals())
    return _made(_part("_skyway_cloud").import_cloud, keywords)


def import_model(path: File, *, format: str = "auto", slack: float = 0.25, solid: bool = False,
                 up: Optional[str] = None, units: Optional[str] = None, origin: Optional[Sequence[float]] = None,
                 allow_skipped: bool = False, seal: Optional[float] = None, floor: Optional[float] = None,
                 ceiling: Optional[float] = None, pad: Optional[float] = None, scale: float = 1.0, bloat_percent: float = 0.0,
                 inflate: float = 0.0, bounds: Optional[ArrayLike] = None, tile: float = 100.0,
                 threads: int = 0) -> BoxMap:
    """OBJ, PLY, STL, glTF, COLLADA, 3DS or 3D Tiles, as skyway-mesh makes it.

    It needs the package skyway-mesh; an `ImportError` says so. `origin` is latitude, longitude and perhaps height.
    """
    keywords = dict(locals())
    return _made(_part("_skyway_mesh").import_model, keywords)
