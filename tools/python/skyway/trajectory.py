"""Trajectories: where a vehicle is at each time."""

from __future__ import annotations

import json
import math
from typing import Any, Iterable, Mapping, Optional, Self

import numpy
from numpy.typing import ArrayLike

from . import _skyway
from .arguments import File, Floats, array, file, limits as limits_from, natives, text
from .notebook import small
from .vehicle import MadeFor

_POINTS = 8  # of a segment: polynomials of degree 7


class Trajectory(MadeFor):
    """A curve over time in polynomials of degree 7: solved, read from a file, or made here.

    `durations` (n) has the seconds of each segment, `points` (n, 8, 3) its Bernstein control points in metres, `yaw` (n, 8)
    those of the yaw in radians. `Trajectory.through` makes one of waypoints with times, `Trajectory.from_coefficients` one of
    the coefficients of polynomials. `limits` are those that the trajectory claims to keep. What was made here is proved by
    nobody: `check` does that.
    """

    __slots__ = ()

    def __init__(self, durations: ArrayLike, points: ArrayLike, *, yaw: Optional[ArrayLike] = None, id: str = "q1",
                 limits: Optional[Mapping[str, float]] = None) -> None:
        seconds = array("durations", durations, (None,))
        if not len(seconds):
            raise ValueError("durations: expected at least one segment, found none")
        curve = array("points", points, (len(seconds), _POINTS, 3))
        segments = [{"duration": t, **dict(zip("xyz", p.T.tolist()))} for t, p in zip(seconds.tolist(), curve)]
        if yaw is not None:
            for segment, row in zip(segments, array("yaw", yaw, (len(seconds), _POINTS)).tolist()):
                segment["yaw"] = row
        if not (numpy.isfinite(seconds).all() and numpy.isfinite(curve).all()):
            raise ValueError("durations and points: expected finite numbers")
        record = {"type": "trajectory", "id": text("id", id), "status": "solved", "segments": segments,
                  "limits": limits_from(limits) or {}}
        self._native = _skyway.Trajectory.from_json(json.dumps(record), "Trajectory")

    @classmethod
    def from_coefficients(cls, durations: ArrayLike, coefficients: ArrayLike, *, id: str = "q1",
                          limits: Optional[Mapping[str, float]] = None) -> Self:
        """A trajectory of polynomials: `coefficients` (n, k, 3), k at most 8, has for each segment the factors of 1, t, t^2 and
        so on, where t is the time since the segment began."""
        seconds = array("durations", durations, (None,))
        powers = array("coefficients", coefficients, (len(seconds), None, 3))
        k = powers.shape[1]
        if k > _POINTS:
            raise ValueError(f"coefficients: expected at most {_POINTS} powers of t, found {k}")
        scaled = powers * seconds[:, None, None]**numpy.arange(k)[None, :, None]  # in powers of t over the duration
        basis = [[math.comb(i, j) / math.comb(_POINTS - 1, j) for j in range(k)] for i in range(_POINTS)]
        return cls(seconds, numpy.einsum("ij,njd->nid", numpy.array(basis), scaled), id=id, limits=limits)

    @classmethod
    def through(cls, points: ArrayLike, times: ArrayLike, *, id: str = "q1",
                limits: Optional[Mapping[str, float]] = None) -> Self:
        """The trajectory of least snap that passes `points` (n, 3) at `times` (n), ascending, from rest to rest."""
        rows = array("points", points, (None, 3))
        at = array("times", times, (len(rows),))
        if len(rows) < 2 or not (numpy.diff(at) > 0).all():
            raise ValueError(f"times: expected two or more that ascend, found {at.tolist()}")
        curve = _skyway.min_snap(rows, numpy.diff(at))
        return cls(curve.durations, curve.points, id=id, limits=limits)

    @property
    def id(self) -> str:
        """The name of its path."""
        return self._native.id

    @property
    def status(self) -> str:
        """"solved", or why there is none: "no_path", "infeasible", "stopped"."""
        return self._native.status

    @property
    def message(self) -> str:
        """Why there is none, in words; may be empty."""
        return self._native.message

    @property
    def rung(self) -> str:
        """Which solver made it: "closed", "banded", "ipopt", "stop_and_go"; "" where nobody says."""
        return self._native.rung

    @property
    def bound(self) -> Optional[float]:
        """Metres that no path between its ends undercuts, where that was proved."""
        return self._native.bound

    @property
    def duration_bound(self) -> Optional[float]:
        """Seconds that no flight between its ends undercuts, where that was proved."""
        return self._native.duration_bound

    @property
    def limits(self) -> dict[str, float]:
        """The limits that it was solved for, in SI units by the names of records."""
        return self._native.limits

    @property
    def solver(self) -> Optional[dict[str, Any]]:
        """What the optimiser tells of itself."""
        return self._native.solver

    @property
    def duration(self) -> float:
        """Seconds."""
        return self._native.duration

    @property
    def durations(self) -> Floats:
        """(n): seconds of each segment."""
        return self._native.durations

    @property
    def points(self) -> Floats:
        """(n, 8, 3): Bernstein control points, metres."""
        return self._native.points

    @property
    def yaw(self) -> Optional[Floats]:
        """(n, 8): Bernstein control points of the yaw in radians, or None."""
        return self._native.yaw

    def sample(self, times: ArrayLike) -> tuple[Floats, Floats, Floats, Floats]:
        """Position, velocity, acceleration and jerk at the times (n), each (n, 3), in metres and seconds. Before its start and
        after its end it stands still."""
        position, velocity, acceleration, jerk = self._native.sample(array("times", times, (None,)))
        return position, velocity, acceleration, jerk

    def to_json(self) -> str:
        """The line of its file, with a newline."""
        return self._native.to_json()

    @classmethod
    def from_json(cls, line: str) -> Self:
        """The trajectory of a line of JSON."""
        return cls._of(_skyway.Trajectory.from_json(text("line", line), "record"))

    def __len__(self) -> int:
        return len(self._native.durations)

    def __reduce__(self) -> Any:
        return Trajectory.from_json, (self.to_json(),)

    def __repr__(self) -> str:
        solved = f"{len(self)} segments, {self.duration:.1f} s" if self.status == "solved" else self.status
        return f"Trajectory({self.id!r}, {solved})"

    def _repr_svg_(self) -> Optional[str]:
        """The trajectory from above; `plot_plan` draws it on its map."""
        return small(_skyway.plan_svg(None, [self._native])) if len(self) else None


def read_trajectories(path: File) -> list[Trajectory]:
    """The trajectories of a file of JSON Lines."""
    return [Trajectory._of(one) for one in _skyway.read_trajectories(file("path", path))]


def write_trajectories(path: File, records: Iterable[Trajectory]) -> None:
    """Writes trajectories as JSON Lines, the whole file or nothing."""
    _skyway.write_trajectories(file("path", path), natives("records", records, Trajectory))
