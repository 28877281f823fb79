"""From a path to a proved trajectory, and the proof alone."""

from __future__ import annotations

from typing import Any, Mapping, Optional, Union

from numpy.typing import ArrayLike

from . import _skyway
from .arguments import array, limits as limits_from, native, number, text
from .collision import CollisionScene
from .native import of_same_file
from .path import Path
from .trajectory import Trajectory


def solve(scene: CollisionScene, path: Union[Path, ArrayLike], *, limits: Optional[Mapping[str, float]] = None,
          solver: str = "auto", times: Optional[str] = None, corridor: str = "planes", rho: float = 1e-3,
          yaw: Union[None, str, float, tuple[float, float]] = None) -> Trajectory:
    """A proved trajectory along a path or points (n, 3), or one whose status says why not.

    `limits` (`{"vmax": 8, "amax": 6}`, SI units) may be no looser than the vehicle's, and the path's vehicle, margin and limits
    must be the scene's. `solver`, `times`, `corridor` and `rho` are those of skyway-traj. `yaw` is "along", an angle in radians,
    or the (x, y) to look at. One optimisation runs at a time in a process.
    """
    solved = _skyway.solve(native("scene", scene, CollisionScene), way("path", path), limits=limits_from(limits),
                           solver=text("solver", solver), times=None if times is None else text("times", times),
                           corridor=text("corridor", corridor), rho=number("rho", rho), yaw=_yaw(yaw))
    return of_same_file(scene.map, Trajectory._of(solved))


def _yaw(value: Any) -> Any:
    if value is None or isinstance(value, str):
        return value
    return array("yaw", value, (2,)).tolist() if hasattr(value, "__len__") else number("yaw", value)


def check(scene: CollisionScene, what: Union[Path, Trajectory, ArrayLike], *,
          limits: Optional[Mapping[str, float]] = None, exact: bool = False) -> dict[str, Any]:
    """The report of skyway-check about a path, a trajectory or points (n, 3), as docs/formats.md has it.

    Of `limits`, the record's and both vehicles' the smallest hold. A scene of less room than the record's is refused. `exact`
    proves it once more in exact numbers.
    """
    report: dict[str, Any] = _skyway.check(native("scene", scene, CollisionScene), way("what", what),
                                           limits=limits_from(limits), exact=bool(exact))
    return of_same_file(scene.map, report)


def way(name: str, value: Union[Path, Trajectory, ArrayLike]) -> Any:
    """A path, a trajectory, or points as an array."""
    if isinstance(value, (Path, Trajectory)):
        return value._native
    return array(name, value, (None, 3))
