"""Skyway: maps of cities as boxes, what is free for a vehicle, paths, proved trajectories and drone files.

Lengths are metres, times seconds, angles radians, in the axes of the map. Wherever a file is taken, its name may be text or a
pathlib.Path; wherever an array is taken, a list does as well. docs/python.md has the whole story.
"""

from .errors import InputError, UsageError  # first: the compiled part raises them
from ._skyway import __version__
from .box_map import BoxMap, read_box_map, write_box_map
from .collision import CollisionScene
from .flight_log import FlightLog, read_flight_logs
from .home import check_return, check_ways_home, ways_home
from .imports import import_boxes, import_cloud, import_footprints, import_model
from .lattice import Lattice, read_lattice
from .mission import export_mission
from .path import Path, read_paths, read_queries, write_paths
from .pictures import Page, Picture, page, plot_clearance, plot_plan, plot_profile, plot_tracking
from .planner import Planner
from .reports import read_reports
from .roadmap import Roadmap, read_roadmap
from .solving import check, solve
from .submission import check_submission
from .trajectory import Trajectory, read_trajectories, write_trajectories
from .vehicle import Vehicle
from .zones import read_zones

__all__ = [
    "BoxMap", "CollisionScene", "FlightLog", "InputError", "Lattice", "Page", "Path", "Picture", "Planner", "Roadmap",
    "Trajectory", "UsageError", "Vehicle", "__version__", "check", "check_return", "check_submission", "check_ways_home", "export_mission", "import_boxes", "import_cloud",
    "import_footprints", "import_model", "page", "plot_clearance", "plot_plan", "plot_profile", "plot_tracking", "read_box_map",
    "read_flight_logs", "read_lattice", "read_paths", "read_queries", "read_reports", "read_roadmap", "read_trajectories", "read_zones",
    "solve", "ways_home", "write_box_map", "write_paths", "write_trajectories"
]

for _name in __all__:  # messages and pickles say skyway.Path
    if hasattr(globals()[_name], "__module__"):
        globals()[_name].__module__ = "skyway"
del _name
