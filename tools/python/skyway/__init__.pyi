"""Skyway in Python. Lengths are metres, times seconds, angles radians, in the map's frame; see docs/python.md."""

import os
from typing import Any, Optional, Sequence, TypedDict, Union, Unpack

import numpy
from numpy.typing import NDArray

_Floats = NDArray[numpy.float64]
_Bools = NDArray[numpy.bool_]
_Point = Union[Sequence[float], _Floats]
_Tuple3 = tuple[float, float, float]
_Corners = tuple[_Point, _Point]
_Path = Union[str, os.PathLike[str]]

__version__: str


class InputError(ValueError):
    """A bad file, a bad record, or artefacts that do not belong together: the message of the tools, and its fields, "" or
    None where it does not say them."""

    source: str
    line: Optional[int]
    item: str
    """The part of the source: `feature 3`."""
    key: str
    """What has the wrong value: `margin`."""
    expected: str
    found: str
    advice: str


class UsageError(ValueError):
    """What the tools refuse with exit status 2: an unknown vehicle, too few limits, or looser ones than the vehicle's."""


class Vehicle:
    name: str

    @property
    def half(self) -> _Tuple3: ...

    @property
    def limits(self) -> dict[str, float]:
        """What its profile allows; `tilt` is the one up to which `half` holds it."""


class _MadeFor:

    @property
    def map(self) -> Optional[str]: ...

    @property
    def frame(self) -> Optional[str]: ...

    @property
    def vehicle(self) -> Optional[Vehicle]: ...

    @property
    def margin(self) -> Optional[float]: ...


class BoxMap:
    """Arrays are read-only views of the mapped file."""

    def __len__(self) -> int: ...

    @property
    def boxes(self) -> _Floats: ...

    @property
    def ids(self) -> NDArray[numpy.uint64]: ...

    @property
    def label(self) -> NDArray[numpy.uint32]: ...

    @property
    def labels(self) -> list[str]: ...

    @property
    def hash(self) -> str: ...

    @property
    def frame(self) -> str: ...

    @property
    def origin(self) -> Optional[_Tuple3]: ...

    @property
    def crs(self) -> str: ...

    @property
    def bounds(self) -> tuple[_Tuple3, _Tuple3]: ...

    @property
    def tile_size(self) -> float: ...

    @property
    def history(self) -> Optional[list[dict[str, Any]]]: ...


class Lattice(_MadeFor):

    def __len__(self) -> int: ...

    @property
    def spacing(self) -> float: ...

    @property
    def origin(self) -> _Tuple3: ...

    @property
    def connectivity(self) -> int: ...

    @property
    def first(self) -> list[int]: ...

    @property
    def dims(self) -> list[int]: ...

    @property
    def nodes(self) -> int: ...

    @property
    def edges(self) -> int: ...

    @property
    def block_record(self) -> NDArray[numpy.uint32]: ...

    @property
    def records(self) -> NDArray[numpy.uint8]: ...

    def masks(self) -> NDArray[numpy.uint32]:
        """(nz, ny, nx): bit 31 where the node is free, bit d where its edge in direction d is."""


class Roadmap(_MadeFor):

    def __len__(self) -> int: ...

    @property
    def part(self) -> float: ...

    @property
    def reach(self) -> float: ...

    @property
    def tile_index(self) -> NDArray[numpy.int32]: ...

    @property
    def tile_extent(self) -> NDArray[numpy.float32]: ...

    @property
    def tile_first(self) -> NDArray[numpy.uint64]: ...

    @property
    def tile_edges(self) -> NDArray[numpy.uint64]: ...

    @property
    def bend_position(self) -> _Floats: ...

    @property
    def bend_axis(self) -> NDArray[numpy.int8]: ...

    @property
    def bend_outward(self) -> NDArray[numpy.int8]: ...

    @property
    def edge_first(self) -> NDArray[numpy.uint32]: ...

    @property
    def edge_split(self) -> NDArray[numpy.uint32]: ...

    @property
    def edge_to(self) -> NDArray[numpy.uint32]: ...


class Path(_MadeFor):
    id: str
    status: str
    message: str

    @property
    def length(self) -> float: ...

    @property
    def points(self) -> _Floats: ...

    @property
    def hold(self) -> Optional[_Floats]: ...

    @property
    def velocity(self) -> Optional[_Floats]: ...

    @property
    def search(self) -> Optional[dict[str, Any]]: ...

    def to_json(self) -> str: ...

    @staticmethod
    def from_json(line: str) -> Path: ...


class Trajectory(_MadeFor):
    id: str
    status: str
    message: str
    rung: str
    bound: Optional[float]
    duration_bound: Optional[float]

    @property
    def limits(self) -> dict[str, float]: ...

    @property
    def solver(self) -> Optional[dict[str, Any]]: ...

    @property
    def duration(self) -> float: ...

    @property
    def durations(self) -> _Floats: ...

    @property
    def points(self) -> _Floats:
        """(segments, 8, 3): Bernstein control points."""

    @property
    def yaw(self) -> Optional[_Floats]:
        """(segments, 8), or None."""

    def sample(self, times: _Floats) -> tuple[_Floats, _Floats, _Floats, _Floats]:
        """Position, velocity, acceleration and jerk at the times, each (n, 3)."""

    def to_json(self) -> str: ...

    @staticmethod
    def from_json(line: str) -> Trajectory: ...


class FlightLog:
    """ENU, whatever the map's axes; attitude is w, x, y, z. `map` is the hash of its map, or "". What the log does
    not say is NaN. `cut`: the log broke off."""
    id: str
    map: str
    cut: bool

    def __len__(self) -> int: ...

    @property
    def time(self) -> _Floats: ...

    @property
    def position(self) -> _Floats: ...

    @property
    def velocity(self) -> _Floats: ...

    @property
    def attitude(self) -> _Floats: ...

    @property
    def body_rates(self) -> _Floats: ...

    @property
    def setpoint_position(self) -> _Floats: ...

    @property
    def setpoint_velocity(self) -> _Floats: ...

    @property
    def setpoint_yaw(self) -> _Floats: ...

    @property
    def motors(self) -> _Floats: ...

    @property
    def battery(self) -> _Floats: ...

    @property
    def saturated(self) -> _Bools: ...


class CollisionScene:
    """Batches are C-contiguous float64 arrays, used where they are; threads=0 is all of them."""

    def __init__(self, map: BoxMap, vehicle: Union[str, Vehicle], margin: float = 0.0) -> None: ...

    @property
    def map(self) -> BoxMap: ...

    @property
    def vehicle(self) -> Vehicle: ...

    @property
    def margin(self) -> float: ...

    @property
    def limits(self) -> dict[str, float]: ...

    @property
    def free_bounds(self) -> Optional[tuple[_Tuple3, _Tuple3]]: ...

    def hits(self, queries: _Floats, *, threads: int = 0) -> _Bools:
        """Whether segments (n, 6) or points (n, 3) meet an obstacle. Bounds are not looked at."""

    def free(self, queries: _Floats, *, threads: int = 0) -> _Bools:
        """Inside the bounds and clear of every obstacle."""

    def sweep_hits(self, segments: _Floats, half: _Point, *, threads: int = 0) -> _Bools:
        """Whether a box of these half sizes, in place of the vehicle, hits anything on the way."""

    def nearest(self, points: _Floats, radius: float = ..., *,
                threads: int = 0) -> tuple[_Floats, NDArray[numpy.int64]]:
        """Distance to the nearest obstacle (inf where none is within the radius) and its row in map.boxes (-1)."""

    def boxes_meeting(self, min: _Point, max: _Point) -> NDArray[numpy.uint64]:
        """Rows in map.boxes, ascending, of the boxes that once grown meet the closed region."""


class Planner:

    def __init__(self, scene: CollisionScene, lattice: Optional[Lattice] = None,
                 roadmap: Optional[Roadmap] = None) -> None: ...

    def plan(self, start: _Point, goal: _Point, *, id: str = "q1", method: str = "auto", quality: str = "normal",
             raw: bool = False, resample: float = 0.0, snap_ends: float = 0.0, seed: int = 0) -> Path: ...

    def plan_batch(self, queries: _Floats, *, ids: Optional[Sequence[str]] = None, method: str = "auto",
                   quality: str = "normal", raw: bool = False, resample: float = 0.0, snap_ends: float = 0.0,
                   seed: int = 0, threads: int = 0) -> list[Path]: ...


# Arguments of these four are those of the tools' options, `import_boxes(path, model_path=[…])` for --model-path. A value
# out of its range is a UsageError. What a tool warns of is warned of by `warnings`. `bounds` are the two corners.


def import_boxes(path: _Path, *, format: str = "auto", frame: Optional[str] = None, units: str = "m",
                 unknown: str = "free", slack: float = 0.1, collisions_only: bool = False,
                 without: Sequence[str] = (), model_path: Sequence[str] = (), allow_skipped: bool = False,
                 seal: Optional[float] = None, floor: Optional[float] = None, ceiling: Optional[float] = None,
                 pad: Optional[float] = None, scale: float = 1.0, bloat_percent: float = 0.0, inflate: float = 0.0,
                 bounds: Optional[_Corners] = None, tile: float = 100.0) -> BoxMap:
    """A table, block text, world, voxel map or octree, as skyway-import makes it."""


def import_footprints(path: _Path, *, format: str = "auto", slack: float = 0.5,
                      height_attribute: Optional[str] = None, storey: float = 3.0,
                      default_height: Optional[float] = None, types: Sequence[str] = (), label_by: str = "type",
                      where: Optional[str] = None, height_step: float = 0.5,
                      terrain: Optional[str] = None, origin: Optional[Sequence[float]] = None,
                      height_units: Optional[str] = None, axes: Optional[str] = None, metres: bool = False,
                      allow_skipped: bool = False, seal: Optional[float] = None, floor: Optional[float] = None,
                      ceiling: Optional[float] = None, pad: Optional[float] = None, scale: float = 1.0,
                      bloat_percent: float = 0.0, inflate: float = 0.0, bounds: Optional[_Corners] = None,
                      tile: float = 100.0, threads: int = 0) -> BoxMap:
    """GeoJSON, OpenStreetMap, CityJSON, CityGML, height models and more, as skyway-footprints makes it. ImportError
    where the package skyway-footprints is not installed. `origin`: latitude, longitude."""


def import_cloud(path: _Path, *, format: str = "auto", mode: str = "columns", cell: float = 1.0, step: float = 0.5,
                 gap: float = 2.0, unknown: str = "free", classes: Sequence[Union[str, int]] = (),
                 noise_points: str = "keep", outliers: Optional[tuple[int, float]] = None, voxel: Optional[float] = None,
                 resolution: Optional[float] = None, ground_points: str = "keep", ground_by: str = "auto",
                 ground_cell: float = 2.0, ground_slope: float = 0.1, ground_height: float = 0.3,
                 ground_step: float = 1.0, ground_widest: float = 200.0, tolerance: float = 1.0, min_points: int = 1,
                 crs: Optional[str] = None, units: Optional[str] = None, vertical_units: Optional[str] = None,
                 origin: Union[None, str, Sequence[float]] = None, allow_skipped: bool = False,
                 seal: Optional[float] = None, floor: Optional[float] = None, ceiling: Optional[float] = None,
                 pad: Optional[float] = None, scale: float = 1.0, bloat_percent: float = 0.0, inflate: float = 0.0,
                 bounds: Optional[_Corners] = None, tile: float = 100.0, threads: int = 0) -> BoxMap:
    """LAS, LAZ, PCD, PLY or XYZ, as skyway-cloud makes it. ImportError where the package skyway-cloud is not installed.
    `origin`: latitude, longitude and perhaps height, or "auto"."""


def import_model(path: _Path, *, format: str = "auto", slack: float = 0.25, solid: bool = False,
                 up: Optional[str] = None, units: Optional[str] = None, origin: Optional[Sequence[float]] = None,
                 allow_skipped: bool = False, seal: Optional[float] = None, floor: Optional[float] = None,
                 ceiling: Optional[float] = None, pad: Optional[float] = None, scale: float = 1.0, bloat_percent: float = 0.0,
                 inflate: float = 0.0, bounds: Optional[_Corners] = None, tile: float = 100.0,
                 threads: int = 0) -> BoxMap:
    """OBJ, PLY, STL, glTF, COLLADA, 3DS or 3D Tiles, as skyway-mesh makes it. ImportError where the package skyway-mesh is
    not installed. `origin`: latitude, longitude and perhaps height."""


def read_box_map(path: str) -> BoxMap: ...


def read_lattice(path: str) -> Lattice: ...


def read_roadmap(path: str) -> Roadmap: ...


def read_paths(path: str) -> list[Path]: ...


def read_trajectories(path: str) -> list[Trajectory]: ...


def read_queries(path: str) -> tuple[list[str], _Floats]:
    """The ids, and (n, 6): from and to."""


def read_reports(path: Union[str, os.PathLike[str]]) -> NDArray[Any]:
    """One row a report, a field a number; NaN, "" or -1 where a report does not say."""


def read_flight_logs(path: str) -> list[FlightLog]: ...


def write_box_map(path: str, map: BoxMap) -> None: ...


def write_paths(path: str, records: Sequence[Path]) -> None: ...


def write_trajectories(path: str, records: Sequence[Trajectory]) -> None: ...


def solve(scene: CollisionScene, path: Union[Path, _Floats], *, limits: Optional[dict[str, float]] = None,
          solver: str = "auto", times: Optional[str] = None, corridor: str = "planes", rho: float = 1e-3,
          yaw: Union[None, str, float, tuple[float, float]] = None) -> Trajectory:
    """A proved trajectory along the path, or one whose status says why not. `limits` may be no looser than the vehicle's,
    and the path's vehicle, margin and limits must be the scene's. One optimisation runs at a time in a
    process."""


def check(scene: CollisionScene, what: Union[Path, Trajectory, _Floats], *,
          limits: Optional[dict[str, float]] = None, exact: bool = False) -> dict[str, Any]:
    """The report of skyway-check, as docs/formats.md has it. Of `limits`, the record's and both vehicles' the smallest
    hold; a scene of less room than the record's is refused."""


class _ExportOptions(TypedDict, total=False):
    """As the options of skyway-export; one that the format does not use is refused."""
    origin: tuple[float, float, float]
    geoid: float
    ground: float
    takeoff_height: float
    heading: float
    rate: float
    axes: str
    tolerance: float
    speed: float
    hover: bool
    wpml_version: str
    aircraft: str
    turns: float
    takeoff_place: Sequence[float]
    lost_link: str
    gimbal: float
    autopilot: str
    navigation: tuple[float, float]
    tracking: tuple[float, float]
    volumes: int
    buffer: float


def export_mission(scene: CollisionScene, what: Union[Path, Trajectory, _Floats], format: str,
                   **options: Unpack[_ExportOptions]) -> dict[str, Any]:
    """The drone file of skyway-export, proved from its bytes: {"ok": True, "bytes": …, "warnings": […]}; of a Tello also
    "python" and "table". Refused: {"ok": False, "message": …} and, where that is known, "reason" and "place"."""
