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

from tube_flight import GRAVITY, GUST, LAG, LIFT, LIGHTNESS, SPIN, STATES, STEP, TURNED, VELOCITY, WIND, Track, fly
from tube_period import ROUNDING, Period, SidewaysError
from verify_certificate import (LARGEST, LONGEST, SHORTEST, Refused, an_object, by_id, entries, number, numbers, require, run_main, shown, text,
                                whole_number)

SLACK = 1e-9  # by so much the simulator may differ from the equations in each coordinate and period,
SPIN_SLACK = 1e-7  # but in angular accelerations by so much, which are larger numbers
LEAST_SCALE = 1e-9  # of a symbol: slopes are needed of coordinates that do not vary, too
BOUNDED = 25  # rows whose bounds a certificate has
CHANGING = 25  # rows that are not the same for ever
CHUNK = 500  # periods whose maps are worked out together
SLACKS = np.full(CHANGING, SLACK)
SLACKS[SPIN:TURNED] = SPIN_SLACK
BLOCK = 25  # periods whose disturbances grow old together
JOINED = 5  # periods whose gusts are added up
SLOW = [0, 1, 2, 3, 4, 5, 9]  # lift, velocity and heading, which what is fast soon follows
AGED = 10  # blocks, then what they did is joined
OLD = 4  # of those, then it becomes a box
UP = 1 + 1e-12


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
         "mass_error", "period", "tilt", "radius", "span", "cells")


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
        self.mass_error = number(c["mass_error"], "mass_error", 0, 0.5)
        require(number(c["period"], "period") == 0.1, "period must be 0.1")
        self.tilt = number(c["tilt"], "tilt", 0, math.pi)
        self.radius = [number(r, f"radius[{i}]", 0) for i, r in enumerate(entries(c["radius"], "radius"))]
        self.span = whole_number(c["span"], "span", 1001)
        require(self.span > 0, "span must be above 0")

    def read_vehicle(self, vehicle):
        for name in ("mass", "torque_per_thrust", "motor_time_constant"):
            setattr(self, name, positive(vehicle[name], name))
        self.inertia, self.arm = positives(vehicle["inertia"], 3, "inertia"), positives(vehicle["arm"], 2, "arm")
        self.drag = numbers(vehicle["drag"], 3, "drag", least=0)
        self.motor_least, self.motor_most = (number(vehicle[name], name) for name in ("motor_least", "motor_most"))
        self.drag_rate = self.drag[0] / self.mass

    @staticmethod
    def steps(seconds, what):
        return round(number(seconds, what, 0, 600) / STEP)

    def gust_kept(self, milliseconds):
        return math.exp(-milliseconds * STEP / self.gust_lag)

    def said(self):
        return {"mass": self.mass, "mass_error": self.mass_error, "wind": self.wind, "wind_spread": self.wind_spread,
                "gust_most": self.gust_most, "gust_lag": self.gust_lag, "largest": max(self.radius), "tilt": self.tilt}


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
        """Wind and lightness (believed over true mass) of the middle, and radii that cover the cell."""
        wind = [float(w) for w in self.wind]
        radius = [above(self.half + abs(w - F(c))) for w, c in zip(self.wind, wind)]
        least, most = 1 / self.masses[1], 1 / self.masses[0]
        lightness = float((least + most) / 2)
        return wind, radius, lightness, above(max(most - F(lightness), F(lightness) - least))


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
        keys_of(one, ("part", "bounds"), f"cells[{i}]")
        part = [whole_number(k, f"cells[{i}].part", 16) for k in entries(one["part"], "part")]
        require(len(part) <= 8, f"cells[{i}] is halved more than 8 times")
        bounds = [positives(row, BOUNDED, f"cells[{i}].bounds[{k}]") for k, row in enumerate(entries(one["bounds"], "bounds"))]
        cell = Cell(claim, part)
        cell.bounds = np.array(bounds).reshape(-1, BOUNDED)
        out.append(cell)
    require(out, "there is no cell")
    require_cover(claim, out)
    return out


# ---- What deviations there may be.

def rows_of(claim):
    """Linear forms whose bounds are asked for: the rows of the certificate, and the place."""
    forms = np.zeros((BOUNDED + 3, STATES))
    forms[:BOUNDED, :BOUNDED] = np.eye(BOUNDED)
    drag = claim.drag_rate
    for i in range(3):
        if drag:
            forms[GUST + i, [LIFT + i, VELOCITY + i, GUST + i, WIND + i]] = 1, -drag, drag, drag
        forms[BOUNDED + i, [LIFT + i, VELOCITY + i]] = -1 / claim.position[i], -claim.velocity[i] / claim.position[i]
    return forms


def ball_norms(images):
    """Of images (..., 3 n) of n balls: the sum of their lengths."""
    return lengths(images).sum(-1)


def lengths(images):
    a, b, c = (images[..., i::3] for i in range(3))
    return np.sqrt(a * a + b * b + c * c)


def ball_reach(images):
    """Of images (..., 3, 3 n) in space of n balls: the sum of bounds of how far each reaches."""
    return stretches(images).sum(-1)


def stretches(images):
    """Gershgorin's bound, of k^T k for the image k of each ball."""
    a, b, c = (images[..., i::3] for i in range(3))
    ab, bc, ca = (np.abs((x * y).sum(-2)) for x, y in ((a, b), (b, c), (c, a)))
    rows = ((a * a).sum(-2) + ab + ca, (b * b).sum(-2) + ab + bc, (c * c).sum(-2) + bc + ca)
    return np.sqrt(np.maximum(np.maximum(rows[0], rows[1]), rows[2]))


class Terms:
    """Deviations as a sum: columns times numbers in [-1, 1], and threes of columns times vectors of length at most 1."""

    def __init__(self, intervals, balls):
        self.intervals, self.balls = intervals, balls

    @staticmethod
    def all(terms):
        return Terms(np.hstack([t.intervals for t in terms]), np.hstack([t.balls for t in terms]))

    def moved(self, matrix):
        return Terms(matrix @ self.intervals, matrix @ self.balls)

    def sizes(self):
        """Of each row, at most: the sum of all columns."""
        return np.abs(self.intervals).sum(1) + np.abs(self.balls).sum(1)

    def bounds(self, forms):
        """Of linear forms (..., STATES)."""
        shape, forms = forms.shape[:-1], np.ascontiguousarray(forms.reshape(-1, STATES))
        rounding = ROUNDING * (np.abs(forms) @ self.sizes())
        out = (np.abs(forms @ self.intervals).sum(-1) + ball_norms(forms @ self.balls)) * UP + rounding
        return out.reshape(shape)

    def reach(self, forms):
        """Of forms (..., 3, STATES): what intervals do along each axis, and how far balls reach."""
        rounding = ROUNDING * (np.abs(forms) @ self.sizes())
        return np.abs(forms @ self.intervals).sum(-1) * UP + rounding, ball_reach(forms @ self.balls) * UP


class Deviations:
    """All that disturbances so far may have done, from block to block."""

    def __init__(self, claim, cell):
        self.claim = claim
        wind, radius, lightness, lightness_half = cell.nominal()
        held = np.zeros((STATES, 3))
        held[WIND:WIND + 3] = np.diag(radius)
        mass = np.zeros((STATES, 1))
        mass[LIGHTNESS] = lightness_half
        mass[LAG + 2] = GRAVITY / lightness**2 * lightness_half
        none = np.zeros((STATES, 0))
        self.held = Terms(mass, held) if cell.is_ball else Terms(np.hstack([held, mass]), none)
        start = np.zeros((STATES, 1))
        start[LAG + 2] = GRAVITY * lightness_half**2 / (lightness - lightness_half) ** 3 * UP + SLACK
        start[:CHANGING, 0] += SLACKS
        self.tail = Terms(np.diag(start[:, 0]), none)
        self.recent, self.aged, self.old = Terms(none, none), [], []
        self.gust = np.zeros((STATES, 3))
        self.gust[GUST:GUST + 3] = np.eye(3) * (1 - claim.gust_kept(claim.period)) * claim.gust_most * UP
        self.forms = rows_of(claim)

    def parts(self):
        return self.held, self.now

    def begin(self, maps, named, box):
        """A block of periods: their maps (n, STATES, STATES), columns of named errors, and boxes."""
        self.now = Terms.all([self.tail, *self.old, *self.aged, self.recent])
        sizes = self.sizes = sum(part.bounds(np.eye(STATES)) for part in self.parts())
        self.products, self.lost = [np.eye(STATES)], [np.zeros(STATES)]  # lost: by the rounding of the products
        for m in maps:
            self.lost.append(np.abs(m) @ (self.lost[-1] + ROUNDING * (np.abs(self.products[-1]) @ sizes)))
            self.products.append(m @ self.products[-1])
        none = np.zeros((STATES, 0))
        self.own = [Terms(none, none)]  # of this block, at the start of each period and at the end
        for j, m in enumerate(maps):
            now, width = self.own[-1], named.shape[2]
            fresh = np.zeros((STATES, width + CHANGING))
            fresh[:CHANGING, :width] = named[j]
            fresh[:CHANGING, width:] = np.diag(box[j] + ROUNDING * (np.abs(m) @ now.sizes())[:CHANGING])
            moved = now.moved(m)
            self.own.append(Terms(np.hstack([moved.intervals, fresh]), np.hstack([moved.balls, self.gust])))

    def bounds(self):
        """At the start of each period: of the forms of rows_of(), and of the length of what the last three give."""
        count = len(self.products) - 1
        products = np.array(self.products[:-1])
        forms = self.forms @ products
        bounds = np.array(self.lost[:-1]) @ np.abs(self.forms).T * UP
        bounds = bounds + ROUNDING * ((np.abs(self.forms) @ np.abs(products)) @ self.sizes)
        across, reach = bounds[:, BOUNDED:], np.zeros(count)
        for part in self.parts():
            bounds = bounds + part.bounds(forms)
            along, balls = part.reach(forms[:, BOUNDED:])
            across, reach = across + along, reach + balls
        own_bounds, own_across, own_reach = self.own_bounds()
        return bounds + own_bounds, np.sqrt(((across + own_across) ** 2).sum(-1)) * UP + reach + own_reach

    def own_bounds(self):
        """Of what this block has added, at the start of each period: of the forms, of the place along each axis, and its reach."""
        bounds, across, reach = np.zeros((len(self.own) - 1, len(self.forms))), np.zeros((len(self.own) - 1, 3)), np.zeros(len(self.own) - 1)
        if len(self.own) > 2:
            some = self.own[1:-1]  # nothing has been added at the start of the block
            whole = Terms.all(some)
            at, ball_at = (np.cumsum([0, *widths[:-1]]) for widths in zip(*((t.intervals.shape[1], t.balls.shape[1] // 3) for t in some)))
            sums = np.add.reduceat(np.abs(self.forms @ whole.intervals), at, axis=1).T * UP
            balls = self.forms @ whole.balls
            rounding = ROUNDING * (np.array([t.sizes() for t in some]) @ np.abs(self.forms).T)
            bounds[1:] = sums + np.add.reduceat(lengths(balls), ball_at, axis=1).T * UP + rounding
            across[1:] = sums[:, BOUNDED:] + rounding[:, BOUNDED:]
            reach[1:] = np.add.reduceat(stretches(balls[BOUNDED:]), ball_at) * UP
        return bounds, across, reach

    def bounds_at(self, periods, forms):
        """Of some forms, each at the start of some period of the block."""
        products = np.array(self.products)[periods]
        before = np.einsum("fi,fij->fj", forms, products)
        rounding = ROUNDING * (np.einsum("fi,fij->fj", np.abs(forms), np.abs(products)) @ self.sizes)
        out = sum(part.bounds(before) for part in self.parts()) + (np.abs(forms) * np.array(self.lost)[periods]).sum(-1) * UP
        for j in np.unique(periods):
            out[periods == j] += self.own[j].bounds(forms[periods == j])
        return out + rounding

    def end(self):
        """To the start of the next block."""
        through = self.products[-1]
        lost = self.lost[-1] + ROUNDING * (np.abs(through) @ sum(part.sizes() for part in self.parts()))
        self.held, self.tail, recent = (part.moved(through) for part in (self.held, self.tail, self.recent))
        self.old, self.aged = ([part.moved(through) for part in parts] for parts in (self.old, self.aged))
        if recent.balls.shape[1] == 3 * BLOCK:
            self.age(recent)
        self.recent = self.own[-1]
        self.recent.intervals[:CHANGING, -CHANGING:] += np.diag(lost[:CHANGING])

    def age(self, block):
        """Adds up errors of a kind over the periods of a block. Few columns hold how they differ from their mean."""
        balls, rest = added_up(block.balls, JOINED)
        columns = block.intervals.reshape(STATES, BLOCK, -1)
        kinds = columns[:, :, :-CHANGING].reshape(STATES, -1, 3), columns[:, :, -CHANGING:]
        means = [kind.mean(1, keepdims=True) for kind in kinds]
        rest = [rest, *((kind - middle).reshape(STATES, -1) for kind, middle in zip(kinds, means))]
        sums = [middle[:, 0] * kind.shape[1] for kind, middle in zip(kinds, means)]
        self.aged.append(Terms(np.hstack([*sums, around(np.hstack(rest), ROUNDING * block.sizes())]), balls))
        if len(self.aged) == 2 * AGED:
            self.old.append(self.joined(self.aged[:AGED]))
            del self.aged[:AGED]
        if len(self.old) == 2 * OLD:
            oldest = Terms.all([self.tail, *self.old[:OLD]])
            self.tail = Terms(around(np.hstack([oldest.intervals, oldest.balls]), np.zeros(STATES)), np.zeros((STATES, 0)))
            del self.old[:OLD]

    @staticmethod
    def joined(blocks):
        terms = Terms.all(blocks)
        balls, rest = added_up(terms.balls, BLOCK // JOINED)
        return Terms(around(np.hstack([terms.intervals, rest]), ROUNDING * terms.sizes()), balls)


def added_up(balls, count):
    """One ball in place of so many neighbouring ones, their sum, and a box for how they differ from their mean."""
    balls = balls.reshape(STATES, -1, count, 3)
    mean = balls.mean(2, keepdims=True)
    return (mean * count).reshape(STATES, -1), np.diag(ball_norms((balls - mean).reshape(STATES, -1)))


def around(columns, more):
    """Few columns around many and a box: a box of what is slow, to which what is fast is tied, and a box for what that leaves.
    Any tie is right."""
    box = np.abs(columns).sum(1)
    scaled = columns[SLOW] / np.maximum(box[SLOW], 1e-300)[:, None]
    gram = scaled @ scaled.T
    ties = np.linalg.solve(gram + np.eye(len(SLOW)) * (1e-9 * np.trace(gram) + 1e-300), scaled @ columns.T).T
    ties[SLOW] = np.diag(box[SLOW])
    rest = np.abs(columns - ties @ scaled).sum(1) + ROUNDING * (box + np.abs(ties) @ np.abs(scaled).sum(1)) + more
    return np.hstack([ties, np.diag(rest)]) * UP


# ---- A cell.

class CellProof:
    def __init__(self, claim, track, cell):
        self.claim, self.cell = claim, cell
        steps = round((track.duration + claim.settle) / STEP)
        self.count = (claim.before + steps) // claim.period + 1
        self.track = track
        self.wind, radius, self.lightness, lightness_half = cell.nominal()
        spans = -(-self.count // claim.span)
        require(len(cell.bounds) == spans, f"a cell must have bounds of {spans} spans, found {len(cell.bounds)}")
        bounds = np.repeat(cell.bounds, claim.span, axis=0)[:self.count]
        self.scales = np.empty((self.count, STATES))
        self.scales[:, :BOUNDED] = np.maximum(bounds, LEAST_SCALE)
        self.scales[:, WIND:WIND + 3] = np.maximum(radius, LEAST_SCALE)
        self.scales[:, LIGHTNESS] = max(lightness_half, LEAST_SCALE)
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
        self.states, self.places = fly(claim, self.track, self.wind, self.lightness, self.count)
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
        count, drag = last - first, self.claim.drag_rate
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
    return {**claim.said(), "frame": certificate["frame"], "cells": len(cells)}


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
