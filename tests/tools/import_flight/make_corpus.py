"""make_corpus.py FOLDER: PX4 logs for the fuzz target, good and bad, each as small as it can be."""

import pathlib
import struct
import sys

from make_hop import REFERENCE, VALID
from ulog import ATTITUDE, BATTERY, GLOBAL, LANDED, LOCAL, MAGIC, MOTORS, OLD_SETPOINT, RATES, SETPOINT, Log, message


def flight(**options):
    log = Log(**options)
    for name, text in (("vehicle_local_position", LOCAL), ("vehicle_attitude", ATTITUDE), ("vehicle_angular_velocity", RATES),
                       ("trajectory_setpoint", SETPOINT), ("vehicle_local_position_setpoint", OLD_SETPOINT),
                       ("battery_status", BATTERY), ("actuator_motors", MOTORS), ("vehicle_land_detected", LANDED)):
        log.topic(name, text)
    for k in range(3):
        for name in list(log.formats)[1:]:
            log.row(name, timestamp=1000 * k, q=[1, 0, 0, 0], xyz=[0, 0, 0], position=[1, 2, 3], velocity=[0, 0, 0],
                    control=[0.5] * 4 + [float("nan")] * 8, landed=k == 0, remaining=0.5, connected=True)
        log.row("vehicle_local_position", timestamp=1000 * k, x=k, **REFERENCE, **VALID)
    return log


def flags(byte, *offsets):
    return message("B", bytes(8) + bytes([byte]) + bytes(7) + struct.pack("<3Q", *offsets, *[0] * (3 - len(offsets))))


def corpus():
    good = bytes(flight())
    yield "flight", good
    yield "empty", b""
    yield "head", good[:12]
    yield "cut", good[:-7]
    other = Log()
    other.topic("vehicle_global_position", GLOBAL)
    for k in range(2):
        other.row("vehicle_global_position", timestamp=k, lat=47, lon=8, alt=400, alt_ellipsoid=448)
    yield "global", bytes(other)
    nested = Log()
    nested.format("inner", "float x;uint8_t[3] _padding0;")
    nested.topic("vehicle_attitude", "inner[2] pair;uint64_t timestamp;float[4] q;uint8_t[7] _padding0;")
    yield "nested", bytes(nested)
    circle = Log()
    circle.format("a", "b x;")
    circle.format("b", "a[9] x;")
    circle.format("vehicle_attitude", "uint64_t timestamp;a x;")
    circle.data += message("A", struct.pack("<BH", 0, 0) + b"vehicle_attitude")
    yield "circle", bytes(circle)
    unknown = Log()
    unknown.formats["vehicle_attitude"] = ""
    unknown.definitions += message("F", b"vehicle_attitude:uint64_t timestamp;quad[4] q;")
    unknown.topic("vehicle_attitude", "")
    yield "unknown_type", bytes(unknown)
    late = flight()
    late.row("vehicle_local_position", timestamp=1, **REFERENCE, **VALID)
    late.row("vehicle_local_position", timestamp=2 ** 64 - 1, **REFERENCE, **VALID)
    late.row("vehicle_local_position", timestamp=5000, x=float("nan"), **REFERENCE, **VALID)
    late.row("vehicle_local_position", timestamp=6000, x=float("inf"), **{**REFERENCE, "ref_lat": 1e300}, **VALID)
    late.dropout(2000)
    for kind in "IMPQLCSRX\x07":
        late.raw(kind, b"????")
    yield "odd", bytes(late)
    yield "long", good + struct.pack("<HB", 65535, ord("D")) + b"short"
    yield "incompatible", good[:16] + flags(2) + good[59:]
    yield "appended", good[:16] + flags(1, len(good) - 5) + good[59:] + message("O", b"\1\0")
    yield "appended_nowhere", good[:16] + flags(1, 3) + good[59:]
    yield "version", MAGIC + bytes([9]) + good[8:]


if __name__ == "__main__":
    for name, data in corpus():
        (pathlib.Path(sys.argv[1]) / name).write_bytes(data)
