"""Box maps from what others write: tables and worlds, footprints and city models, point clouds, models of triangles."""

import importlib
import os
import warnings

from . import _skyway

_PACKAGES = {"_skyway_gis": "skyway-footprints", "_skyway_cloud": "skyway-cloud", "_skyway_mesh": "skyway-mesh"}


def _part(name):
    """A module that is there only where its package is installed."""
    try:
        return importlib.import_module(name)
    except ModuleNotFoundError as error:
        message = f"this needs the Debian package {_PACKAGES[name]}, or a build with its readers: {error}"
        raise ImportError(message, name=error.name) from None


def _made(function, keywords):
    path = os.fspath(keywords.pop("path"))
    box_map, said = function(path, keywords)
    for text in said:
        warnings.warn(text, stacklevel=3)
    return box_map


def import_boxes(path, *, format="auto", frame=None, units="m", unknown="free", slack=0.1, collisions_only=False,
                 without=(), model_path=(), allow_skipped=False, seal=None, floor=None, ceiling=None, pad=None,
                 scale=1.0, bloat_percent=0.0, inflate=0.0, bounds=None, tile=100.0):
    """A table, block text, world, voxel map or octree as a BoxMap, as skyway-import makes it."""
    keywords = locals()
    try:
        reader = _part("_skyway_mesh")  # which reads meshes of COLLADA, too
    except ImportError:
        reader = _skyway
    return _made(reader.import_boxes, keywords)


def import_footprints(path, *, format="auto", slack=0.5, height_attribute=None, storey=3.0, default_height=None,
                      types=(), label_by="type", where=None, height_step=0.5, terrain=None, origin=None, height_units=None, axes=None,
                      metres=False, allow_skipped=False, seal=None, floor=None, ceiling=None, pad=None, scale=1.0,
                      bloat_percent=0.0, inflate=0.0, bounds=None, tile=100.0, threads=0):
    """Footprints, a city model or a height model as a BoxMap, as skyway-footprints makes it."""
    keywords = locals()
    return _made(_part("_skyway_gis").import_footprints, keywords)


def import_cloud(path, *, format="auto", mode="columns", cell=1.0, step=0.5, gap=2.0, unknown="free", classes=(),
                 noise_points="keep", outliers=None, voxel=None, resolution=None, ground_points="keep", ground_by="auto",
                 ground_cell=2.0, ground_slope=0.1, ground_height=0.3, ground_step=1.0, ground_widest=200.0,
                 tolerance=1.0, min_points=1, crs=None, units=None, vertical_units=None, origin=None,
                 allow_skipped=False, seal=None, floor=None, ceiling=None, pad=None, scale=1.0, bloat_percent=0.0,
                 inflate=0.0, bounds=None, tile=100.0, threads=0):
    """A point cloud as a BoxMap, as skyway-cloud makes it."""
    keywords = locals()
    return _made(_part("_skyway_cloud").import_cloud, keywords)


def import_model(path, *, format="auto", slack=0.25, solid=False, up=None, units=None, origin=None,
                 allow_skipped=False, seal=None, floor=None, ceiling=None, pad=None, scale=1.0, bloat_percent=0.0,
                 inflate=0.0, bounds=None, tile=100.0, threads=0):
    """A model of triangles or 3D Tiles as a BoxMap, as skyway-mesh makes it."""
    keywords = locals()
    return _made(_part("_skyway_mesh").import_model, keywords)
