"""What a certificate of a tube claims: a vehicle, its controller, what may disturb it, and the parts of winds and masses.

verify_tube.py follows the proof of each part in doubles, and verify_hover.py that of a hover in exact numbers.
"""

import importlib
import json
import math
import types
from fractions import Fraction as F

from verify_certificate import LARGEST, LONGEST, SHORTEST, Refused, an_object, by_id, entries, number, numbers, require, shown, text, whole_number

def positive(value, what, most=LARGEST):
    found = number(value, what, 0, most)
    require(found > 0, f"{what} must be above 0, found {found}")
    return found


def positives(value, count, what):
    return [positive(v, f"{what}[{i}]") for i, v in enumerate(numbers(value, count, what))]


def keys_of(value, keys, what):
    require(set(an_object(value, what)) == set(keys), f"{what} must have the keys {sorted(keys)}, found {sorted(value)}")
    return value


STEP = 1e-3  # s
BOUNDED = {"geometric": 25, "cascade": 34}  # coordinates that have bounds, of each controller
VEHICLE = ("mass", "inertia", "arm", "torque_per_thrust", "motor_time_constant", "motor_least", "motor_most", "drag")
GAINS = ("position", "velocity", "attitude", "rates", "lead")
CASCADE_GAINS = ("position", "velocity", "attitude", "rates", "feed_forward", "tilt_max")
NOISE = ("place_noise", "velocity_noise", "attitude_noise", "rate_noise")
CLAIM = ("type", "id", "frame", "vehicle", "controller", "gains", "attitude_period_ms", "hover", "settle", "wind", "wind_spread", "gust_most", "gust_lag",
         "mass_error", "drag_error", "motor_lag_error", "inertia_error", "gain_error", "start_error", "start_speed", *NOISE, "period", "tilt", "radius", "cells")


class Pid:
    """The gains of a loop of the cascade; the output of each axis is clipped."""

    def __init__(self, gains, what):
        an_object(gains, what)
        keys_of(gains, ("p", "i", "d", "clip") if "clip" in gains else ("p", "i", "d"), f"the gains {what}")
        self.p, self.i, self.d = (numbers(gains[k], 3, f"the gains {what}.{k}", least=0) for k in "pid")
        self.clip = positive(gains["clip"], f"the gains {what}.clip") if "clip" in gains else math.inf


class Claim:
    """The vehicle, its controller and what may disturb it, as the certificate says."""

    def __init__(self, certificate):
        self.controller = text(certificate, "controller", "the certificate")
        require(self.controller in BOUNDED, f"controller must be geometric or cascade, found {self.controller!a}")
        is_cascade = self.controller == "cascade"
        c = keys_of(certificate, (*CLAIM, "position_period_ms") if is_cascade else CLAIM, "the certificate")
        self.read_vehicle(keys_of(c["vehicle"], (*VEHICLE, "body_rate_max") if is_cascade else VEHICLE, "the vehicle"))
        self.period = self.milliseconds(c, "attitude_period_ms", 4)
        if is_cascade:
            self.read_cascade(c)
        else:
            gains = keys_of(c["gains"], GAINS, "the gains")
            for name in GAINS:
                setattr(self, name, numbers(gains[name], 3, f"the gains {name}", least=0))
            positives(self.position, 3, "the gains position")
        self.before = self.steps(c["hover"], "hover")
        require(self.before > 0, "hover must be at least a millisecond: the proof starts at rest")
        self.settle = number(c["settle"], "settle", 0, 600)
        self.wind = numbers(c["wind"], 3, "wind")
        self.wind_spread = number(c["wind_spread"], "wind_spread", 0, 1000)
        self.gust_most = number(c["gust_most"], "gust_most", 0, 1000)
        self.gust_lag = positive(c["gust_lag"], "gust_lag")
        require(self.gust_lag >= 0.001, "gust_lag must be at least 0.001 s")
        for name in ("mass_error", "drag_error", "motor_lag_error", "inertia_error", "gain_error"):
            setattr(self, name, number(c[name], name, 0, 0.5))
        self.start_error, self.start_speed = (number(c[name], name, 0, 1000) for name in ("start_error", "start_speed"))
        self.place_noise, self.velocity_noise, self.attitude_noise, self.rate_noise = (number(c[name], name, 0, 1000) for name in NOISE)
        require(self.attitude_noise <= 1, "attitude_noise must be at most 1")
        require(number(c["period"], "period") == 0.1, "period must be 0.1")
        self.tilt = number(c["tilt"], "tilt", 0, math.pi)
        self.radius = [number(r, f"radius[{i}]", 0) for i, r in enumerate(entries(c["radius"], "radius"))]

    @property
    def law(self):
        """The module with the controller's equations in doubles."""
        return importlib.import_module("tube_" + self.controller)

    def read_vehicle(self, vehicle):
        for name in ("mass", "torque_per_thrust", "motor_time_constant"):
            setattr(self, name, positive(vehicle[name], name))
        self.inertia, self.arm = positives(vehicle["inertia"], 3, "inertia"), positives(vehicle["arm"], 2, "arm")
        require(2 * max(self.inertia) <= sum(self.inertia) * (1 + 1e-9), "no body has more inertia about one axis than about the other two together")
        self.drag = numbers(vehicle["drag"], 3, "drag", least=0)
        self.motor_least, self.motor_most = (number(vehicle[name], name) for name in ("motor_least", "motor_most"))
        self.drag_rate = self.drag[0] / self.mass

    def read_cascade(self, c):
        gains = keys_of(c["gains"], CASCADE_GAINS, "the gains")
        self.position_period = self.milliseconds(c, "position_period_ms", 100)
        self.body_rate_max = positives(c["vehicle"]["body_rate_max"], 3, "body_rate_max")
        position, self.velocity, self.rates = (Pid(gains[name], name) for name in ("position", "velocity", "rates"))
        self.position = positives(position.p, 3, "the gains position.p")
        require(not any(position.i + position.d), "the proof knows no i and d of the position loop")
        positives(self.velocity.p, 3, "the gains velocity.p")
        self.clips = types.SimpleNamespace(position=position.clip, velocity=self.velocity.clip, rates=self.rates.clip)
        self.attitude = numbers(gains["attitude"], 3, "the gains attitude", least=0)
        forward = keys_of(gains["feed_forward"], ("velocity", "acceleration", "body_rates"), "feed_forward")
        self.forward = types.SimpleNamespace(**{name: number(value, f"feed_forward.{name}", 0, 2) for name, value in forward.items()})
        self.tilt_max = positive(gains["tilt_max"], "tilt_max", 1.5)

    @property
    def is_noisy(self):
        return self.place_noise + self.velocity_noise + self.attitude_noise + self.rate_noise > 0

    @staticmethod
    def milliseconds(c, name, most):
        found = whole_number(c[name], name, most + 1)
        require(found > 0, f"{name} must be above 0")
        return found

    @staticmethod
    def steps(seconds, what):
        return round(number(seconds, what, 0, 600) / STEP)

    def gust_kept(self, milliseconds):
        return math.exp(-milliseconds * STEP / self.gust_lag)


def segments_of(record, frame):
    """The trajectory of the record, in ENU axes: (duration, 8 control points, 8 yaws) of each segment."""
    require(record.get("type") == "trajectory" and record.get("status", "solved") == "solved", "the record is no solved trajectory")
    require(frame in ("enu", "neu"), f"frame must be enu or neu, found {shown(frame)}")
    require(record.get("frame", frame) == frame, f"the record has the frame {shown(record.get('frame'))}")
    segments = []
    for i, segment in enumerate(entries(record.get("segments"), "segments")):
        an_object(segment, f"segments[{i}]")
        duration = number(segment.get("duration"), f"segments[{i}].duration", SHORTEST, LONGEST)
        x, y, z = (numbers(segment.get(axis), 8, f"segments[{i}].{axis}") for axis in "xyz")
        yaw = numbers(segment["yaw"], 8, f"segments[{i}].yaw") if "yaw" in segment else None
        if frame == "neu":
            x, y = y, x
            yaw = yaw and [1.5707963267948966 - a for a in yaw]
        segments.append((duration, list(zip(x, y, z)), yaw or [0.0] * 8))
    require(segments, "there is no segment")
    duration = sum(segment[0] for segment in segments)
    require(duration <= 36000, f"the trajectory takes {duration} s")
    return segments


# ---- Cells.

class Cell:
    """A part of the winds and masses: exact, until the script asks for the doubles around it."""

    def __init__(self, claim, part=()):
        self.claim, self.part = claim, tuple(part)
        self.wind = [F(w) for w in claim.wind]
        self.half = F(claim.wind_spread)
        error = F(claim.mass_error)
        self.masses = [1 - error, 1 + error]
        for k in self.part:
            self.half /= 2
            self.wind = [w + (self.half if k >> i & 1 else -self.half) for i, w in enumerate(self.wind)]
            middle = sum(self.masses) / 2
            self.masses = [middle, self.masses[1]] if k & 8 else [self.masses[0], middle]
        self.is_ball = not self.part

    def meets(self):
        beyond = [max(abs(w - F(c)) - self.half, 0) for w, c in zip(self.wind, self.claim.wind)]
        return sum(b * b for b in beyond) <= F(self.claim.wind_spread) ** 2

    def parts(self):
        """Those that are asked for."""
        for k in range(16):
            if (self.half or not k & 7) and (self.claim.mass_error or not k & 8):
                part = Cell(self.claim, (*self.part, k))
                if part.meets():
                    yield part

    def nominal(self):
        """Of the middle the wind, and how the true vehicle differs from the believed one (the coordinates from `lightness` on); and
        of both the radii that cover the cell."""
        claim = self.claim
        wind = [float(w) for w in self.wind]
        radius = [above(self.half + abs(w - F(c))) for w, c in zip(self.wind, wind)]
        drag = [1 - F(claim.drag_error), 1 + F(claim.drag_error)]
        inverses = [self.masses, *([1 - F(e), 1 + F(e)] for e in (claim.motor_lag_error, *[claim.inertia_error] * 3))]
        lightness, *others = [[1 / most, 1 / least] for least, most in inverses]
        factors, halves = zip(*(middle(*bounds) for bounds in (lightness, drag, *others)))
        return wind, radius, list(factors), list(halves)


def middle(least, most):
    """A double between the two, and a radius around it that covers both."""
    found = float((least + most) / 2)
    return found, above(max(most - F(found), F(found) - least))


def above(fraction):
    value = float(fraction)
    return value if F(value) >= fraction else math.nextafter(value, math.inf)


def require_cover(claim, cells):
    """The cells are all winds and masses."""
    names = [cell.part for cell in cells]
    require(len(set(names)) == len(names), "a cell stands twice")
    begun = {name[:k] for name in names for k in range(len(name) + 1)}

    def look(cell):
        if cell.part in names:
            return
        require(cell.part in begun, f"no cell covers the part {list(cell.part)} of winds and masses")
        for part in cell.parts():
            look(part)

    look(Cell(claim))


def cells_of(claim, listed):
    out = []
    for i, one in enumerate(entries(listed, "cells")):
        keys_of(one, ("part", "periods", "bounds"), f"cells[{i}]")
        part = [whole_number(k, f"cells[{i}].part", 16) for k in entries(one["part"], "part")]
        require(len(part) <= 8, f"cells[{i}] is halved more than 8 times")
        cell = Cell(claim, part)
        cell.periods = [whole_number(k, f"cells[{i}].periods[{j}]", 1001) for j, k in enumerate(entries(one["periods"], "periods"))]
        require(all(k > 0 for k in cell.periods), f"cells[{i}].periods must be above 0")
        bounded = BOUNDED[claim.controller]
        bounds = [positives(row, bounded, f"cells[{i}].bounds[{k}]") for k, row in enumerate(entries(one["bounds"], "bounds"))]
        require(len(bounds) == len(cell.periods), f"cells[{i}] has {len(bounds)} bounds for {len(cell.periods)} spans")
        cell.bounds = bounds
        out.append(cell)
    require(out, "there is no cell")
    require_cover(claim, out)
    return out


# ---- Files.

def verify_files(verify, words, record_file, certificate_file):
    """Prints what became of each record by verify(record, certificate), and says how many were refused."""
    records, certificates = by_id(record_file), by_id(certificate_file)
    refused = [f"{name!a}: refused: there is no record of this certificate" for name in certificates if name not in records]
    for name, record in records.items():
        try:
            require(name in certificates, "there is no certificate")
            print(f"{name!a}: {words} {json.dumps(verify(record, certificates[name]))}", flush=True)
        except Refused as reason:
            refused.append(f"{name!a}: refused: {reason}")
    print("\n".join(refused), end="\n" if refused else "")
    return len(refused)
