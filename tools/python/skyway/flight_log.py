"""Flight logs: what a vehicle did."""

from __future__ import annotations

from . import _skyway
from .arguments import Bools, File, Floats, file
from .native import Native


class FlightLog(Native):
    """A flight, flown or simulated, a row an instant. Always ENU, whatever the map's axes. What the log does not say is NaN."""

    __slots__ = ()

    def __init__(self) -> None:
        raise TypeError("a FlightLog comes from read_flight_logs; skyway-fly and skyway-import-flight make its file")

    @property
    def id(self) -> str:
        """The id of the trajectory that it followed."""
        return self._native.id

    @property
    def map(self) -> str:
        """The hash of its map, or ""."""
        return self._native.map

    @property
    def cut(self) -> bool:
        """Whether the log does not hold the whole flight: it broke off, or begins or ends without positions."""
        return self._native.cut

    def __len__(self) -> int:
        return len(self._native)

    @property
    def time(self) -> Floats:
        """(n), seconds."""
        return self._native.time

    @property
    def position(self) -> Floats:
        """(n, 3), metres."""
        return self._native.position

    @property
    def velocity(self) -> Floats:
        """(n, 3), metres a second."""
        return self._native.velocity

    @property
    def attitude(self) -> Floats:
        """(n, 4): the quaternion w, x, y, z."""
        return self._native.attitude

    @property
    def body_rates(self) -> Floats:
        """(n, 3), radians a second."""
        return self._native.body_rates

    @property
    def setpoint_position(self) -> Floats:
        """(n, 3): where it should have been, metres."""
        return self._native.setpoint_position

    @property
    def setpoint_velocity(self) -> Floats:
        """(n, 3): how fast it should have been, metres a second."""
        return self._native.setpoint_velocity

    @property
    def setpoint_yaw(self) -> Floats:
        """(n), radians."""
        return self._native.setpoint_yaw

    @property
    def motors(self) -> Floats:
        """(n, 4): what each motor was told, as docs/formats.md says."""
        return self._native.motors

    @property
    def battery(self) -> Floats:
        """(n): the share that was left, 0 to 1."""
        return self._native.battery

    @property
    def saturated(self) -> Bools:
        """(n): whether a motor was at its limit."""
        return self._native.saturated

    def __repr__(self) -> str:
        seconds = self.time[-1] - self.time[0] if len(self) else 0.0
        return f"FlightLog({self.id!r}, {len(self)} rows, {seconds:.1f} s{', cut' if self.cut else ''})"


def read_flight_logs(path: File) -> list[FlightLog]:
    """The flights of a table of CSV."""
    return [FlightLog._of(one) for one in _skyway.read_flight_logs(file("path", path))]
