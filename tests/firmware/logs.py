"""The simulator's ground truth out of the firmwares' own logs: PX4's ULog and ArduPilot's DataFlash log.

Both give (seconds since the clock's start, latitude, longitude, altitude), in double precision and without the
losses of a telemetry link; and the moments of arming and disarming.
"""

import bisect
import dataclasses
import math
import pathlib
import struct



@dataclasses.dataclass
class Truth:
    samples: list  # (seconds, latitude, longitude, altitude) of the simulator
    armed: float | None  # seconds
    disarmed: float | None
    lost_ms: int = 0  # what the logger lost
    sensors: list = dataclasses.field(default_factory=list)  # for each sensor, the moments at which it spoke
    estimate: list = dataclasses.field(default_factory=list)  # as samples, but what the firmware believed
    modes: list = dataclasses.field(default_factory=list)  # (seconds, number of the mode that began or goes on)

    def longest_silence(self, start, end):
        """The longest pause of any sensor between two moments, in seconds."""
        longest = 0.0
        for stamps in self.sensors:
            within = [start, *(s for s in stamps if start < s < end), end]
            longest = max(longest, *(b - a for a, b in zip(within, within[1:])))
        return longest

    def estimate_error(self, start, end):
        """Root mean square of estimate less truth, in metres: (across, up). None without an estimate."""
        stamps = [e[0] for e in self.estimate]
        across = up = count = 0
        for moment, latitude, longitude, altitude in self.samples:
            at = bisect.bisect_left(stamps, moment)
            if start <= moment <= end and at < len(stamps):
                _, lat, lon, alt = self.estimate[at]
                north, east = (lat - latitude) * 111195, (lon - longitude) * 111195 * math.cos(math.radians(latitude))
                across, up, count = across + north**2 + east**2, up + (alt - altitude) ** 2, count + 1
        return (math.sqrt(across / count), math.sqrt(up / count)) if count else None


_ULOG_TYPES = {"int8_t": "b", "uint8_t": "B", "bool": "?", "char": "c", "int16_t": "h", "uint16_t": "H", "int32_t": "i",
               "uint32_t": "I", "int64_t": "q", "uint64_t": "Q", "float": "f", "double": "d"}


def _ulog_offsets(fields):
    """Field name to (offset, struct code), as far as plain types reach."""
    offsets, at = {}, 0
    for field in fields.rstrip(";").split(";"):
        kind, name = field.split(" ")
        kind, _, count = kind.partition("[")
        code = _ULOG_TYPES.get(kind)
        if code is None:
            break
        count = int(count[:-1]) if count else 1
        offsets[name] = (at, "<" + code)
        at += struct.calcsize(code) * count
    return offsets


def _ulog(path, wanted):
    """Rows of the wanted topics: {topic: {field, ...}} -> {topic: [(values in the order of sorted fields), ...]}."""
    data = pathlib.Path(path).read_bytes()
    if data[:7] != b"ULog\x01\x12\x35":
        raise ValueError(f"{path}: the file is not a ULog.")
    formats, readers, dropped = {}, {}, 0
    rows = {topic: [] for topic in wanted}
    at = 16
    while at + 3 <= len(data):
        size, kind = struct.unpack_from("<HB", data, at)
        body = at + 3
        at = body + size
        if at > len(data):
            break
        if kind == 0x44:  # D: data
            reader = readers.get(int.from_bytes(data[body : body + 2], "little"))
            if reader:
                out, fields = reader
                out.append(tuple(struct.unpack_from(code, data, body + 2 + offset)[0] for offset, code in fields))
        elif kind == 0x46:  # F: format
            name, _, fields = data[body:at].decode().partition(":")
            formats[name] = fields
        elif kind == 0x41:  # A: subscription
            number, topic = int.from_bytes(data[body + 1 : body + 3], "little"), data[body + 3 : at].decode()
            if topic in wanted and data[body] == 0:
                offsets = _ulog_offsets(formats[topic])
                readers[number] = (rows[topic], [offsets[field] for field in sorted(wanted[topic])])
        elif kind == 0x4F:  # O: dropout
            dropped += int.from_bytes(data[body : body + 2], "little")
    return rows, dropped


_SENSORS = ("vehicle_air_data", "vehicle_gps_position")  # both are logged several times a second


def px4(path):
    place = {"timestamp", "alt", "lat", "lon"}
    rows, lost = _ulog(path, {"vehicle_global_position_groundtruth": place, "vehicle_global_position": place,
                              "actuator_armed": {"armed", "timestamp"},
                              "vehicle_status": {"nav_state", "timestamp"}, **{topic: {"timestamp"} for topic in _SENSORS}})
    samples, estimate = ([(stamp * 1e-6, lat, lon, alt) for alt, lat, lon, stamp in rows[topic]]
                         for topic in ("vehicle_global_position_groundtruth", "vehicle_global_position"))
    armed = disarmed = None
    for is_armed, stamp in rows["actuator_armed"]:
        if is_armed and armed is None:
            armed = stamp * 1e-6
        elif not is_armed and armed is not None and disarmed is None:
            disarmed = stamp * 1e-6
    return Truth(samples, armed, disarmed, lost, [[row[0] * 1e-6 for row in rows[topic]] for topic in _SENSORS], estimate,
                 [(stamp * 1e-6, mode) for mode, stamp in rows["vehicle_status"]])


_FLASH_TYPES = {"a": "64s", "b": "b", "B": "B", "h": "h", "H": "H", "i": "i", "I": "I", "f": "f", "d": "d", "n": "4s",
                "N": "16s", "Z": "64s", "c": "h", "C": "H", "e": "i", "E": "I", "L": "i", "M": "B", "q": "q", "Q": "Q",
                "g": "e"}
_METRES = 0.011131884502145034  # ArduPilot's metres to 1e-7 degrees of latitude
_ARMED, _DISARMED = 10, 11  # events


def arducopter(path, home):
    """SIM2 of a DataFlash log holds metres from home; they become degrees the way that ArduPilot does it."""
    data = pathlib.Path(path).read_bytes()
    home = (round(home[0], 7), round(home[1], 7), home[2])  # the firmware's own digits
    formats = {128: (89, "FMT", None, None)}
    samples, modes, armed, disarmed = [], [], None, None
    at = 0
    while at + 3 <= len(data):
        if data[at] != 0xA3 or data[at + 1] != 0x95:
            at = data.find(b"\xa3\x95", at + 1)
            if at < 0:
                break
            continue
        if data[at + 2] not in formats:
            at += 1
            continue
        length, name, layout, columns = formats[data[at + 2]]
        if at + length > len(data):
            break
        if name == "FMT":
            number, size, label, kinds, names = struct.unpack_from("<BB4s16s64s", data, at + 3)
            kinds = kinds.rstrip(b"\0").decode()
            known = all(k in _FLASH_TYPES for k in kinds)
            formats[number] = (size, label.rstrip(b"\0").decode(),
                               struct.Struct("<" + "".join(_FLASH_TYPES[k] for k in kinds)) if known else None,
                               names.rstrip(b"\0").decode().split(","))
        elif name in ("SIM2", "EV", "MODE"):
            row = dict(zip(columns, layout.unpack_from(data, at + 3)))
            seconds = row["TimeUS"] * 1e-6
            if name == "SIM2":
                latitude = home[0] + row["PN"] / _METRES * 1e-7
                scale = max(math.cos(math.radians(0.5 * (home[0] + latitude))), 0.01)
                samples.append((seconds, latitude, home[1] + row["PE"] / _METRES / scale * 1e-7, -row["PD"]))
            elif name == "MODE":
                modes.append((seconds, row["ModeNum"]))
            elif row["Id"] == _ARMED and armed is None:
                armed = seconds
            elif row["Id"] == _DISARMED and armed is not None and disarmed is None:
                disarmed = seconds
        at += length
    if samples:  # the vehicle's centre stands above the ground; the take-off place has home's altitude
        lift = home[2] - samples[0][3]
        samples = [(*s[:3], s[3] + lift) for s in samples]
    return Truth(samples, armed, disarmed, modes=modes)


def at_ten_hertz(samples, start, end):
    """The track at 10 Hz: seconds since `start`. Samples that come at 10 Hz are taken as they are."""
    stamps = [s[0] for s in samples]
    first, last = bisect.bisect_left(stamps, start), bisect.bisect_right(stamps, end)
    chosen = samples[first:last]
    if len(chosen) < 2:
        return []
    if (chosen[-1][0] - chosen[0][0]) / (len(chosen) - 1) > 0.05:
        return [(s[0] - start, *s[1:]) for s in chosen]
    track = []
    for step in range(int((end - start) * 10 + 1e-6) + 1):
        moment = start + 0.1 * step
        after = min(max(bisect.bisect_left(stamps, moment), 1), len(stamps) - 1)
        a, b = samples[after - 1], samples[after]
        share = min(max((moment - a[0]) / (b[0] - a[0]), 0.0), 1.0) if b[0] > a[0] else 0.0
        track.append((moment - start, *(p + share * (q - p) for p, q in zip(a[1:], b[1:]))))
    return track


def write_track(track, path):
    with open(path, "w", encoding="ascii") as out:
        out.write("t_s,latitude,longitude,altitude_m\n")
        for row in track:
            out.write("%.3f,%.9f,%.9f,%.3f\n" % row)
