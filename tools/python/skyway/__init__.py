"""Skyway in Python: every artefact as NumPy arrays, collision queries in batches, planning, solving,
checking and proved drone files."""

from ._skyway import (BoxMap, CollisionScene, FlightLog, InputError, Lattice, Path, Planner, Roadmap, Trajectory,
                      UsageError, Vehicle, __version__, check, export_mission, read_box_map, read_flight_logs,
                      read_lattice, read_paths, read_queries, read_roadmap, read_trajectories, solve, write_paths,
                      write_trajectories)
from .reports import read_reports

__all__ = [
    "BoxMap", "CollisionScene", "FlightLog", "InputError", "Lattice", "Path", "Planner", "Roadmap", "Trajectory",
    "UsageError", "Vehicle", "__version__", "check", "export_mission", "read_box_map", "read_flight_logs", "read_lattice",
    "read_paths", "read_queries", "read_reports", "read_roadmap", "read_trajectories", "solve", "write_paths", "write_trajectories"
]
