"""make_hop.py FILE: the small PX4 log of the golden cases.

A hop between two houses of village.csv, onto a roof: 4 s on the ground at 5 m north, 30 m east of its origin, up to 8 m, 20 m to the
north, 5 samples a second, with attitude, rates, setpoints, battery and motors.
"""

import sys

from ulog import ATTITUDE, BATTERY, LANDED, LOCAL, MOTORS, RATES, SETPOINT, Log

REFERENCE = {"ref_lat": 37.792525, "ref_lon": -122.397109, "ref_alt": 32.0}  # 0 m above the ellipsoid
VALID = {key: True for key in ("xy_valid", "z_valid", "v_xy_valid", "v_z_valid", "xy_global", "z_global")}


def place(t):
    """North, east, down from the reference, and the velocity."""
    if t < 4:
        return (0, 0, -1), (0, 0, 0)
    if t < 8:
        return (0, 0, -1 - 1.75 * (t - 4)), (0, 0, -1.75)
    return (5 * (t - 8), 0, -8), (5, 0, 0)


def hop():
    log = Log(start=1_000_000)
    for name, text in (("vehicle_local_position", LOCAL), ("vehicle_attitude", ATTITUDE), ("vehicle_angular_velocity", RATES),
                       ("trajectory_setpoint", SETPOINT), ("battery_status", BATTERY), ("actuator_motors", MOTORS),
                       ("vehicle_land_detected", LANDED)):
        log.topic(name, text)
    nan = float("nan")
    for k in range(61):
        time = 1_000_000 + 200_000 * k
        at, velocity = place(k / 5)
        if k % 5 == 0:
            log.row("vehicle_land_detected", timestamp=time - 3, landed=k <= 20 or k == 60)
            log.row("battery_status", timestamp=time - 3, remaining=0.9 - k / 500, connected=True)
        log.row("vehicle_attitude", timestamp=time - 2, q=[1, 0, 0, 0])
        log.row("vehicle_angular_velocity", timestamp=time - 2, xyz=[0.01, 0.02, 0.03])
        log.row("trajectory_setpoint", timestamp=time - 1, position=at if k > 20 else [nan] * 3, velocity=velocity, yaw=0)
        log.row("actuator_motors", timestamp=time - 1, control=[0.5] * 4 + [nan] * 8)
        log.row("vehicle_local_position", timestamp=time, x=at[0], y=at[1], z=at[2], vx=velocity[0], vy=velocity[1],
                vz=velocity[2], eph=0.3, epv=0.5, **REFERENCE, **VALID)
    return log


if __name__ == "__main__":
    with open(sys.argv[1], "wb") as out:
        out.write(bytes(hop()))
