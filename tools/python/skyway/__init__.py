"""Skyway in Python: maps made of what others write, every artefact as NumPy arrays, collision queries in batches, planning,
solving, checking and proved drone files."""

from ._skyway import (BoxMap, CollisionScene, FlightLog, InputError, Lattice, Path, Planner, Roadmap, Trajectory,
                      UsageError, Vehicle, __version__, check, export_mission, read_box_map, read_flight_logs,
                      read_lattice, read_paths, read_queries, read_roadmap, read_trajectories, solve, write_box_map,
                      write_paths, write_trajectories)
from .imports import import_boxes, import_cloud, import_footprints, import_model
from .reports import read_reports

__all__ = [
    "BoxMap", "CollisionScene", "FlightLog", "InputError", "Lattice", "Path", "Planner", "Roadmap", "Trajectory",
    "UsageError", "Vehicle", "__version__", "check", "export_mission", "import_boxes", "import_cloud", "import_footprints",
    "import_model", "read_box_map", "read_flight_logs", "read_lattice", "read_paths", "read_queries", "read_reports",
    "read_roadmap", "read_trajectories", "solve", "write_box_map", "write_paths", "write_trajectories"
]
