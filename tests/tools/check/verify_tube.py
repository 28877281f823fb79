"""verify_tube.py RECORDS CERTIFICATES: follows the proofs of tubes.

RECORDS are trajectories and CERTIFICATES what `skyway-fly --proved-tube --certificate` wrote of them (JSON Lines). The script flies
the middle of each cell with a quadrotor's own equations, works out for each period of the attitude loop how deviations go on,
with a bound of what is not linear, and adds up what winds, gusts and masses can do. Exit 0 when there is a record, and every one
has a certificate that holds; 1 when one is refused, with the reason; 2 for wrong usage; 3 when a file cannot be read as what it
should be, or NumPy is not there. docs/certificates.md says what is checked, and what is trusted.
"""

import json
import math
import sys
from fractions import Fraction as F

try:
    import numpy as np
except ImportError:
    print("verify_tube.py needs NumPy (Debian: python3-numpy); every other script of these needs only Python", file=sys.stderr)
    sys.exit(3)

from tube_deviations import BLOCK, BOUNDED, CHANGING, SLACK, SLACKS, UP, Deviations
from tube_flight import GRAVITY, GUST, LIFT, LIGHTNESS, STATES, STEP, VELOCITY, WIND, Track, fly
from tube_period import ROUNDING, Period, SidewaysError
from verify_certificate import (LARGEST, LONGEST, SHORTEST, Refused, an_object, by_id, entries, number, numbers, require, run_main, shown, text,
                                whole_number)

LEAST_SCALE = 1e-9  # of a symbol: slopes are needed of coordinates that do not vary, too
CHUNK = 500  # periods whose maps are worked out together, whole blocks


# ---- What is claimed.

def positive(value, what, most=LARGEST):
    found = number(value, what, 0, most)
    require(found > 0, f"{what} must be above 0, found {found}")
    return found


def positives(value, count, what):
    return [positive(v, f"{what}[{i}]") for i, v in enumerate(numbers(value, count, what))]


def keys_of(value, keys, what):
    require(set(an_object(value, what)) == set(keys), f"{what} must have the keys {sorted(keys)}, found {sorted(value)}")
    return value


VEHICLE = ("mass", "inertia", "arm", "torque_per_thrust", "motor_time_constant", "motor_least", "motor_most", "drag")
GAINS = ("position", "velocity", "attitude", "rates", "lead")
CLAIM = ("type", "id", "frame", "vehicle", "gains", "attitude_period_ms", "hover", "settle", "wind", "wind_spread", "gust_most", "gust_lag",
         "mass_error", "drag_error", "motor_lag_error", "inertia_error", "period", "tilt", "radius", "cells")


class Claim:
    """The vehicle, its controller and what may disturb it, as the certificate says."""

    def __init__(self, certificate):
        c = keys_of(certificate, CLAIM, "the certificate")
        self.read_vehicle(keys_of(c["vehicle"], VEHICLE, "the vehicle"))
        gains = keys_of(c["gains"], GAINS, "the gains")
        for name in GAINS:
            setattr(self, name, numbers(gains[name], 3, f"the gains {name}", least=0))
        positives(self.position, 3, "the gains position")
        self.period = whole_number(c["attitude_period_ms"], "attitude_period_ms", 5)
        require(self.period > 0, "attitude_period_ms must be above 0")
        self.before = self.steps(c["hover"], "hover")
        require(self.before > 0, "hover must be at least a millisecond: the proof starts at rest")
        self.settle = number(c["settle"], "settle", 0, 600)
        self.wind = numbers(c["wind"], 3, "wind")
        self.wind_spread = number(c["wind_spread"], "wind_spread", 0, 1000)
        self.gust_most = number(c["gust_most"], "gust_most", 0, 1000)
        self.gust_lag = positive(c["gust_lag"], "gust_lag")
        require(self.gust_lag >= 0.001, "gust_lag must be at least 0.001 s")
        for name in ("mass_error", "drag_error", "motor_lag_error", "inertia_error"):
            setattr(self, name, number(c[name], name, 0, 0.5))
        require(number(c["period"], "period") == 0.1, "period must be 0.1")
        self.tilt = number(c["tilt"], "tilt", 0, math.pi)
        self.radius = [number(r, f"radius[{i}]", 0) for i, r in enumerate(entries(c["radius"], "radius"))]

    def read_vehicle(self, vehicle):
        for name in ("mass", "torque_per_thrust", "motor_time_constant"):
            setattr(self, name, positive(vehicle[name], name))
        self.inertia, self.arm = positives(vehicle["inertia"], 3, "inertia"), positives(vehicle["arm"], 2, "arm")
        require(2 * max(self.inertia) <= sum(self.inertia) * (1 + 1e-9), "no body has more inertia about one axis than about the other two together")
        self.drag = numbers(vehicle["drag"], 3, "drag", least=0)
        self.motor_least, self.motor_most = (number(vehicle[name], name) for name in ("motor_least", "motor_most"))
        self.drag_rate = self.drag[0] / self.mass

    @staticmethod
    def steps(seconds, what):
        return round(number(seconds, what, 0, 600) / STEP)

    def gust_kept(self, milliseconds):
        return math.exp(-milliseconds * STEP / self.gust_lag)


def track_of(record, frame):
    """The trajectory of the record, in ENU axes."""
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
    track = Track(segments)
    require(track.duration <= 36000, f"the trajectory takes {track.duration} s")
    return track


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
        """Of the middle the wind, and how the true vehicle differs from the believed one (the coordinates from LIGHTNESS on); and
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
        bounds = [positives(row, BOUNDED, f"cells[{i}].bounds[{k}]") for k, row in enumerate(entries(one["bounds"], "bounds"))]
        require(len(bounds) == len(cell.periods), f"cells[{i}] has {len(bounds)} bounds for {len(cell.periods)} spans")
        cell.bounds = np.array(bounds).reshape(-1, BOUNDED)
        out.append(cell)
    require(out, "there is no cell")
    require_cover(claim, out)
    return out


# ---- A cell.

class CellProof:
    def __init__(self, claim, track, cell):
        self.claim, self.cell = claim, cell
        steps = round((track.duration + claim.settle) / STEP)
        self.count = (claim.before + steps) // claim.period + 1
        self.track = track
        self.wind, radius, self.factors, halves = cell.nominal()
        require(sum(cell.periods) == self.count, f"a cell must have bounds of {self.count} periods, found {sum(cell.periods)}")
        self.scales = np.empty((self.count, STATES))
        self.scales[:, :BOUNDED] = np.maximum(np.repeat(cell.bounds, cell.periods, axis=0), LEAST_SCALE)
        self.scales[:, WIND:WIND + 3] = np.maximum(radius, LEAST_SCALE)
        self.scales[:, LIGHTNESS:] = np.maximum(halves, LEAST_SCALE)
        self.require_start()

    def instant(self, period):
        return (period * self.claim.period - self.claim.before) * STEP

    def require_start(self):
        claim = self.claim
        for mass in self.cell.masses:
            weight = claim.mass * float(mass) * GRAVITY / 4
            require(claim.motor_least * (1 + 1e-12) <= weight <= claim.motor_most * (1 - 1e-12), "its weight is beyond its motors")

    def follow(self):
        claim = self.claim
        self.states, self.places = fly(claim, self.track, self.wind, self.factors, self.count)
        self.references = self.track.at(-claim.before, (self.count + 1) * claim.period - claim.before)
        deviations = Deviations(claim, self.cell)
        for first in range(0, self.count, CHUNK):
            self.follow_chunk(first, min(first + CHUNK, self.count), deviations)

    def follow_chunk(self, first, last, deviations):
        claim = self.claim
        references = [r[first * claim.period:last * claim.period + 1:claim.period] for r in self.references]
        try:
            period = Period(claim, self.states[first:last + 1], self.scales[first:last], references)
        except SidewaysError as reason:
            raise Refused(f"a thrust or lift may point sideways at {self.instant(first + reason.period):.3f} s") from None
        maps, named, box = self.maps(first, last, period)
        further, least = self.within_periods(first, last, period)
        rooms = self.motor_rooms(period)
        for begin in range(0, last - first, BLOCK):
            block = slice(begin, min(begin + BLOCK, last - first))
            deviations.begin(maps[block], named[block], box[block])
            bounds, reach = deviations.bounds()
            self.require_bounds(first + begin, bounds)
            self.require_radius(first + begin, reach, further[block])
            self.require_motors(first + begin, begin, period, rooms[block], deviations)
            deviations.end()
        self.require_tilt(first, least)

    # How deviations go on.

    def maps(self, first, last, period):
        """Of the deviations at a period's start those at its end: a matrix, columns of named errors, and a box around the next
        nominal state."""
        count = last - first
        scales = self.scales[first:last]
        maps = np.zeros((count, STATES, STATES))
        maps[:, CHANGING:, CHANGING:] = np.eye(STATES - CHANGING)
        named = np.empty((count, CHANGING, 3 * self.claim.period))
        box = np.empty((count, CHANGING))
        for i, model in enumerate(period.after):
            maps[:, i], lost = self.by_coordinates(model.l[:STATES], scales)
            named[:, i] = model.l[STATES:].T
            off = np.abs(model.c - self.states[first + 1:last + 1, i])
            self.require_agreement(first, off, SLACKS[i])
            box[:, i] = (model.r + ROUNDING * model.size() + lost + off) * UP + SLACKS[i]
        return maps, named, box

    def by_coordinates(self, slopes, scales):
        """Slopes by symbols as slopes by coordinates of the state, and what rounding loses over all deviations."""
        drag = self.claim.drag_rate
        out = slopes.T / scales
        lost = ROUNDING * (np.abs(out) * scales).sum(1)
        if drag:
            for i in range(3):
                a = out[:, GUST + i].copy()
                balance = ((LIFT + i, 1.0), (VELOCITY + i, -drag), (GUST + i, drag), (WIND + i, drag))
                for row, factor in balance:
                    size = self.claim.gust_most if row == GUST + i else scales[:, row]
                    lost = lost + ROUNDING * np.abs(a * factor) * size
                    out[:, row] = (0.0 if row == GUST + i else out[:, row]) + factor * a
        return out, lost

    def require_agreement(self, first, off, slack):
        worst = int(np.argmax(off))
        require(off[worst] <= slack, f"the equations differ from a quadrotor's own by {off[worst]:.2g} at {self.instant(first + worst):.3f} s")

    # What must hold.

    def require_bounds(self, first, bounds):
        claimed = self.scales[first:first + len(bounds), :BOUNDED]
        if not np.all(bounds[:, :BOUNDED] <= claimed):
            j, row = np.unravel_index(np.argmax(bounds[:, :BOUNDED] / claimed), claimed.shape)
            raise Refused(f"at {self.instant(first + j):.3f} s row {row} may reach {bounds[j, row]:.6g}, claimed {claimed[j, row]:.6g}")

    def within_periods(self, first, last, period):
        """How far the vehicle moves from the reference during each period, and the least cosine of its tilt."""
        claim = self.claim
        further, least = np.zeros(last - first), np.full(last - first, np.inf)
        for j, (moved, upright) in enumerate(zip(period.moved, period.upright), 1):
            here, there = (self.references[0][first * claim.period + k:last * claim.period + k - claim.period + 1:claim.period] for k in (0, j))
            away = [np.abs(m.c - (there - here)[:, i]) + m.radius() for i, m in enumerate(moved)]
            further = np.maximum(further, np.sqrt(sum(a * a for a in away)) * UP)
            least = np.minimum(least, upright.least() - SLACK)
        return further, least

    def require_radius(self, first, reach, further):
        claim = self.claim
        for j in range(len(reach)):
            step = (first + j) * claim.period - claim.before
            if step + claim.period <= 0:
                continue
            place = self.references[0][(first + j) * claim.period]
            radius = math.dist(self.places[first + j], place) + reach[j] + further[j] + SLACK
            for k in range(max(step, 0) // 100, (step + claim.period - 1) // 100 + 1):
                claimed = claim.radius[min(k, len(claim.radius) - 1)]
                require(radius <= claimed, f"at {step * STEP:.3f} s it may be {radius:.6g} m off, claimed {claimed:.6g} m")

    def require_tilt(self, first, least):
        for j, cosine in enumerate(least):
            if self.instant(first + j + 1) > 0:
                require(cosine > math.cos(self.claim.tilt) + 1e-15, f"at {self.instant(first + j):.3f} s it may tilt by "
                        f"{math.acos(max(min(cosine, 1), -1)):.6g}, claimed {self.claim.tilt:.6g}")

    def motor_rooms(self, period):
        """Of each period, millisecond and motor: whether the command is within the motor's range by the bounds alone."""
        return np.array([[self.room(m) - m.radius() - SLACK > 0 for m in commands] for commands in period.commands]).transpose(2, 0, 1)

    def room(self, m, at=slice(None)):
        return np.minimum(self.claim.motor_most - m.c[at], m.c[at] - self.claim.motor_least) - ROUNDING * m.size()[at]

    def require_motors(self, first, begin, period, has_room, deviations):
        unsure = np.argwhere(~has_room)
        if not len(unsure):
            return
        models = [(period.commands[k][i], begin + j) for j, k, i in unsure]
        scales = self.scales[first + unsure[:, 0]]
        forms, lost = self.by_coordinates(np.array([m.l[:STATES, at] for m, at in models]).T, scales)
        rest = np.array([np.abs(m.l[STATES:, at]).sum() * UP + m.r[at] for m, at in models]) + lost + SLACK
        room = np.array([self.room(m, at) for m, at in models]) - deviations.bounds_at(unsure[:, 0], forms) - rest
        if not np.all(room > 0):
            worst = int(np.argmin(room))
            j, _, motor = unsure[worst]
            raise Refused(f"motor {motor + 1} may leave its range at {self.instant(first + j):.3f} s, by {-room[worst]:.4g} N")


def verify(record, certificate):
    """Raises Refused; else says what has been shown."""
    require(certificate.get("type") == "tube_certificate" and certificate.get("id") == record.get("id"), "it is no certificate of this record")
    claim = Claim(certificate)
    track = track_of(record, certificate["frame"])
    require(len(claim.radius) == math.ceil(track.duration / 0.1), f"{len(claim.radius)} radii for {track.duration} s")
    cells = cells_of(claim, certificate["cells"])
    try:
        with np.errstate(all="ignore"):  # what is not finite is within no bound
            for cell in cells:
                CellProof(claim, track, cell).follow()
    except (ArithmeticError, ValueError, np.linalg.LinAlgError) as reason:
        raise Refused(f"its numbers are out of range: {reason}") from None
    said = {key: certificate[key] for key in CLAIM if key not in ("type", "id", "period", "radius", "cells")}
    return {"largest": max(claim.radius), **said}


def verify_files(record_file, certificate_file):
    """Prints what became of each record, and says how many were refused."""
    records, certificates = by_id(record_file), by_id(certificate_file)
    refused = [f"{name!a}: refused: there is no record of this certificate" for name in certificates if name not in records]
    for name, record in records.items():
        try:
            require(name in certificates, "there is no certificate")
            print(f"{name!a}: the tube holds for {json.dumps(verify(record, certificates[name]))}", flush=True)
        except Refused as reason:
            refused.append(f"{name!a}: refused: {reason}")
    print("\n".join(refused), end="\n" if refused else "")
    return len(refused)


if __name__ == "__main__":
    run_main(__doc__, 2, verify_files)
