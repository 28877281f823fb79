"""A period of the closed loop in Taylor models of order 1, for many periods at once.

docs/tube.md derives the equations; verify_tube.py uses what comes out. Each model says of a quantity, for each period, that
it is c + l . s + e for all symbols s in [-1, 1] and some e with |e| <= r. Second-order terms and rounding go to r.
"""

import numpy as np

from tube_flight import (AGILITY, DRAG, FILTER_SHARE, FILTERED, GRAVITY, GUST, HEADING, LAG, LIFT, LIGHTNESS, QUICKNESS, RATES, SPIN, STATES,
                         STEP, TURNED, VELOCITY, WIND)

UNIT = 2.0**-53
ROUNDING = 400 * UNIT  # of the parts of an operation, each a sum of at most 46 + 3 products, with room
LIBM = 4e-15  # of sine, cosine, arcus sine


class SidewaysError(Exception):
    """A thrust or a lift may point sideways in this period (counted from 0)."""

    def __init__(self, bad):
        super().__init__()
        self.period = int(np.argmax(bad))


class Model:
    """c, r: a number for each period; l: a row for each symbol."""

    __slots__ = ("c", "l", "r", "_swing")
    __array_ufunc__ = None  # arrays leave operations with a model to the model

    def __init__(self, c, l, r):
        self.c, self.l, self.r, self._swing = c, l, r, None

    @property
    def swing(self):
        if self._swing is None:
            self._swing = np.abs(self.l).sum(axis=0)
        return self._swing

    def size(self):
        """Of all its parts: what the rounding of an operation is a share of."""
        return np.abs(self.c) + self.swing + self.r

    def radius(self):
        return (self.swing + self.r) * (1 + ROUNDING)

    def least(self):
        return self.c - self.radius() - ROUNDING * np.abs(self.c)

    def most(self):
        return self.c + self.radius() + ROUNDING * np.abs(self.c)

    def __neg__(self):
        return Model(-self.c, -self.l, self.r)

    def __add__(self, other):
        if isinstance(other, Model):
            return Model(self.c + other.c, self.l + other.l, self.r + other.r + ROUNDING * (self.size() + other.size()))
        return Model(self.c + other, self.l, self.r + ROUNDING * (self.size() + abs(other)))

    __radd__ = __add__

    def __sub__(self, other):
        return self + -other

    def __rsub__(self, other):
        return -self + other

    def __mul__(self, other):
        if not isinstance(other, Model):
            factor = abs(other)
            return Model(self.c * other, self.l * other, self.r * factor + ROUNDING * factor * self.size())
        a, b = self, other
        r = np.abs(a.c) * b.r + np.abs(b.c) * a.r + (a.swing + a.r) * (b.swing + b.r) + ROUNDING * a.size() * b.size()
        return Model(a.c * b.c, a.c * b.l + b.c * a.l, r)

    __rmul__ = __mul__

    def through(self, value, slope, bend):
        """g(self), of g and its slope at c and a bound of its second derivative over all values."""
        radius = self.radius()
        size = np.abs(value) + np.abs(slope) * self.size()
        r = np.abs(slope) * self.r + 0.5 * bend * radius * radius * (1 + ROUNDING) + (ROUNDING + LIBM) * size
        return Model(value, slope * self.l, r)


def require_all(holds):
    if not np.all(holds):
        raise SidewaysError(~holds)


def inverse(a):
    least = a.least()
    require_all(least > 0)
    return a.through(1 / a.c, -1 / (a.c * a.c), 2 / (least * least * least))


def root(a):
    least = a.least()
    require_all(least > 0)
    value = np.sqrt(a.c)
    return a.through(value, 0.5 / value, 0.25 / (least * np.sqrt(least)))


def sine(a):
    return a.through(np.sin(a.c), np.cos(a.c), 1.0)


def cosine(a):
    return a.through(np.cos(a.c), -np.sin(a.c), 1.0)


def arcus_sine(a):
    most = np.maximum(a.most(), -a.least())
    require_all(most < 1)
    room = 1 - most * most
    return a.through(np.arcsin(a.c), 1 / np.sqrt(1 - a.c * a.c), most / (room * np.sqrt(room)))


# ---- Vectors of three models or numbers.

def dot(a, b):
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def plus(a, b):
    return [x + y for x, y in zip(a, b)]


def minus(a, b):
    return [x - y for x, y in zip(a, b)]


def times(k, a):
    return [k * x for x in a]


def scaled(a, b):
    return [x * y for x, y in zip(a, b)]


class Frame:
    """Axes whose z is along a force and whose x has a heading: across it and what is to its left."""

    def __init__(self, force, sin, cos):
        self.size = root(dot(force, force))
        self.z = times(inverse(self.size), force)
        self.sin, self.cos = sin, cos
        z = self.z
        across = [cos * z[2], sin * z[2], -(sin * z[1]) - cos * z[0]]
        self.across = root(dot(across, across))
        self.x = times(inverse(self.across), across)
        self.y = cross(self.z, self.x)

    def left(self, b):
        """The vector to the left of the heading, times b."""
        return [self.cos * b[2], self.sin * b[2], -(self.sin * b[1]) - self.cos * b[0]]

    def ahead(self, b):
        """The vector along the heading, times b."""
        return [self.sin * b[2], -(self.cos * b[2]), self.cos * b[1] - self.sin * b[0]]

    def seen(self, v):
        return [dot(self.x, v), dot(self.y, v), dot(self.z, v)]

    def outside(self, v):
        return [v[0] * self.x[i] + v[1] * self.y[i] + v[2] * self.z[i] for i in range(3)]


# ---- A period.

class Body:
    NAMES = ("moved", "velocity", "lag", "missing", "heading", "rates", "spin", "turned")

    def __init__(self, **parts):
        self.__dict__.update(parts)

    def moved_by(self, slope, h):
        step = lambda a, d: [x + h * y for x, y in zip(a, d)] if isinstance(a, list) else a + h * d
        return Body(**{name: step(getattr(self, name), getattr(slope, name)) for name in self.NAMES})


class Period:
    """All periods of a chunk: what the state is at their ends, and what it is on the way."""

    def __init__(self, claim, states, scales, references):
        """`states`: the nominal ones, (periods + 1, STATES). `scales`: the radius of each symbol, (periods, STATES), those of the
        gust of the acceleration that lift and drag give. `references`: as Track.at() gives them for the starts and the last end."""
        self.claim, self.count = claim, len(states) - 1
        self.symbols = STATES + 3 * claim.period
        self.scales, self.middle = scales, states
        self.references = references
        self.commands, self.moved, self.upright = [], [], []
        self.start()
        self.run()

    def zero(self):
        return Model(np.zeros(self.count), np.zeros((self.symbols, self.count)), np.zeros(self.count))

    def symbol(self, row, middle=None):
        out = self.zero()
        out.c = self.middle[:-1, row].copy() if middle is None else middle
        out.l[row] = self.scales[:, row]
        return out

    def within(self, radius):
        out = self.zero()
        out.r = out.r + radius
        return out

    def named(self, model, symbol):
        """The same with its remainder as a symbol that has not been in use."""
        l = model.l.copy()
        l[symbol] = model.r
        return Model(model.c, l, np.zeros(self.count))

    def start(self):
        three = lambda row: [self.symbol(row + i) for i in range(3)]
        self.lift, self.velocity, self.wind = three(LIFT), three(VELOCITY), three(WIND)
        self.start_factors(three)
        drag = self.claim.drag_rate
        if not drag:
            self.gust = three(GUST)
        else:  # acceleration = lift + drag (gust + wind - velocity), all as deviations
            self.gust = []
            for i in range(3):
                away = self.symbol(GUST + i, np.zeros(self.count)) - (self.lift[i] - self.middle[:-1, LIFT + i])
                air = (self.velocity[i] - self.middle[:-1, VELOCITY + i]) - (self.wind[i] - self.middle[:-1, WIND + i])
                self.gust.append((1 / drag) * away + air + self.middle[:-1, GUST + i])
        none = [self.zero() for _ in range(3)]
        self.body = Body(moved=none, velocity=self.velocity, lag=three(LAG), missing=self.zero(), heading=self.symbol(HEADING),
                         rates=three(RATES), spin=three(SPIN), turned=three(TURNED))
        self.filtered = three(FILTERED)

    def start_factors(self, three):
        """How the true vehicle differs from the believed one; nothing where that has no range."""
        claim = self.claim
        self.lightness = self.symbol(LIGHTNESS)
        self.drag_share = self.symbol(DRAG) if claim.drag_error else None
        self.lag = 1 / claim.motor_time_constant
        if claim.motor_lag_error:
            self.lag = self.lag * self.symbol(QUICKNESS)
        self.agility = three(AGILITY) if claim.inertia_error else None

    def want(self):
        """The wanted frame and body rates."""
        _, _, _, jerk, yaw, yaw_rate = (r[:-1] for r in self.references)
        jerk = [jerk[:, i] for i in range(3)]
        self.wanted = w = Frame(self.lift, np.sin(yaw), np.cos(yaw))
        along = dot(w.z, jerk)
        dz = times(inverse(w.size), [jerk[i] - along * w.z[i] for i in range(3)])
        across = plus(times(-yaw_rate, w.ahead(w.z)), w.left(dz))
        self.wanted_rates = [-dot(dz, w.y), dot(dz, w.x), dot(across, w.y) * inverse(w.across)]

    def frame(self, body):
        """The body's, seen from the wanted one."""
        return Frame([-body.lag[0], -body.lag[1], self.wanted.size - body.lag[2]], sine(body.heading), cosine(body.heading))

    def gyroscopic(self, w):
        """J^-1 (w x J w) of the believed inertia"""
        inertia = self.claim.inertia
        return [(1 / inertia[i]) * t for i, t in enumerate(cross(w, scaled(inertia, w)))]

    def angular_acceleration(self, w, spin):
        """Of the true inertia, which is the believed one over the agility."""
        if self.agility is None:
            return minus(spin, self.gyroscopic(w))
        inertia = self.claim.inertia
        turn = cross(w, [inertia[i] * (w[i] * inverse(self.agility[i])) for i in range(3)])
        return scaled(self.agility, [spin[i] - (1 / inertia[i]) * turn[i] for i in range(3)])

    def drag(self, frame, air):
        """Of the true vehicle."""
        d = self.claim.drag
        out = times(d[0], air)
        for more, axis in ((d[1] - d[0], frame.y), (d[2] - d[0], frame.z)):
            if more:
                there = self.wanted.outside(axis)
                out = plus(out, times(more * dot(there, air), there))
        return out if self.drag_share is None else times(self.drag_share, out)

    def slope(self, body, wind):
        frame = self.frame(body)
        air = self.drag(frame, minus(body.velocity, wind))
        rest = minus(minus(self.lift, self.wanted.outside(body.lag)), times(1 / self.claim.mass, air))
        velocity = times(self.lightness, rest)
        velocity[2] = velocity[2] - GRAVITY
        w = body.rates
        z = [w[1] * frame.x[i] - w[0] * frame.y[i] for i in range(3)]
        lacks = self.lag * body.missing
        rates = self.angular_acceleration(w, body.spin)
        heading = (w[2] * frame.across - dot(frame.left(z), frame.y)) * inverse(-dot(frame.ahead(frame.z), frame.y))
        return Body(moved=body.velocity, velocity=velocity, lag=[-(lacks * frame.z[i]) - frame.size * z[i] for i in range(3)],
                    missing=-lacks, heading=heading, rates=rates, turned=rates, spin=times(self.lag, minus(self.asked, body.spin)))

    def attitude_error(self, frame):
        dx = [1.0 - frame.x[0], -frame.x[1], -frame.x[2]]
        dz = [-frame.z[0], -frame.z[1], 1.0 - frame.z[2]]
        second, shrink, lag = cross(dz, dx), inverse(self.wanted.size), self.body.lag
        return [shrink * dot(frame.y, lag) - 0.5 * dot(frame.z, second), -(shrink * dot(frame.x, lag)) - 0.5 * dot(dz, dx),
                0.5 * dot(frame.x, second) - frame.y[0]]

    def command(self, millisecond):
        """What thrust and torque the motors are told; the second-order terms of the torque become symbols."""
        claim, body = self.claim, self.body
        frame = self.frame(body)
        error = self.attitude_error(frame)
        follow = [dot(axis, self.wanted_rates) for axis in (frame.x, frame.y, frame.z)]
        self.filtered = [(1 - FILTER_SHARE) * f + (FILTER_SHARE / STEP) * t for f, t in zip(self.filtered, body.turned)]
        body.turned = [self.zero() for _ in range(3)]
        body.missing = dot(body.lag, frame.z)
        turn, carried = self.gyroscopic(body.rates), cross(body.rates, follow)
        asked = []
        for i in range(3):
            spin = turn[i] - claim.attitude[i] * error[i] - claim.rates[i] * (body.rates[i] - follow[i]) - claim.lead[i] * self.filtered[i]
            asked.append(self.named(spin - carried[i], STATES + 3 * millisecond + i))
        self.asked = asked
        self.commands.append(self.motors((claim.mass / 4) * (self.wanted.size * frame.z[2])))

    def motors(self, mean):
        claim = self.claim
        x, y, z = (claim.inertia[i] / (4 * arm) * self.asked[i]
                   for i, arm in enumerate((claim.arm[1], claim.arm[0], claim.torque_per_thrust)))
        return [mean - x - y - z, mean + x + y - z, mean + x - y + z, mean - x + y + z]

    def run_millisecond(self, millisecond):
        self.command(millisecond)
        kept = self.claim.gust_kept(millisecond)
        more = self.within((1 - kept) * self.claim.gust_most * (1 + ROUNDING))
        wind = [self.wind[i] + kept * self.gust[i] + more for i in range(3)]
        body, h = self.body, STEP
        k1 = self.slope(body, wind)
        k2 = self.slope(body.moved_by(k1, h / 2), wind)
        k3 = self.slope(body.moved_by(k2, h / 2), wind)
        k4 = self.slope(body.moved_by(k3, h), wind)
        self.body = body.moved_by(k1.moved_by(k2, 2).moved_by(k3, 2).moved_by(k4, 1), h / 6)
        self.moved.append(self.body.moved)
        z = self.frame(self.body).z
        self.upright.append(self.wanted.outside(z)[2])

    def run(self):
        claim = self.claim
        self.want()
        for millisecond in range(claim.period):
            self.run_millisecond(millisecond)
        p, v, a = (r[1:] - r[:-1] for r in self.references[:3])
        faster = minus(self.body.velocity, self.velocity)
        change = [claim.position[i] * p[:, i] + claim.velocity[i] * v[:, i] + a[:, i]
                  - (claim.position[i] * self.body.moved[i] + claim.velocity[i] * faster[i]) for i in range(3)]
        self.turn_wanted_frame(change)
        self.after = [*plus(self.lift, change), *self.body.velocity, *self.body.lag, self.body.heading, *self.body.rates,
                      *self.body.spin, *self.filtered, *self.body.turned, *times(claim.gust_kept(claim.period), self.gust)]

    def turn_wanted_frame(self, change):
        """Lag and heading as the wanted frame of the next period sees them. All changes are small with that of the lift."""
        w, body = self.wanted, self.body
        e = w.seen(change)
        longer = 2.0 * w.size * e[2] + dot(e, e)  # of the squares
        size = root(w.size * w.size + longer)
        growth, shrink = longer * inverse(size + w.size), inverse(size)
        dz = [shrink * e[0], shrink * e[1], shrink * (e[2] - growth)]
        now, then = self.references[4][:-1], self.references[4][1:]
        half, mean = 2 * np.sin((then - now) / 2), (then + now) / 2
        turn = w.seen([-half * np.cos(mean), -half * np.sin(mean), np.zeros(self.count)])  # of what is to the left
        left = [0.0, w.across, w.cos * w.z[1] - w.sin * w.z[0]]
        z = [dz[0], dz[1], 1.0 + dz[2]]
        across = plus([left[1] * dz[2] - left[2] * dz[1], left[2] * dz[0], -(left[1] * dz[0])], cross(turn, z))
        wider = 2.0 * w.across * across[0] + dot(across, across)
        across_size = root(w.across * w.across + wider)
        across[0] = across[0] - wider * inverse(across_size + w.across)
        dx = times(inverse(across_size), across)
        x = self.frame(body).x
        dy = plus(plus([-dx[1], dx[0], self.zero()], [self.zero(), dz[2], -dz[1]]), cross(dz, dx))
        to_x, to_y = dot(dx, x), dot(dy, x)
        before = root(x[0] * x[0] + x[1] * x[1])
        next_x, next_y = x[0] + to_x, x[1] + to_y
        after = root(next_x * next_x + next_y * next_y)
        body.heading = body.heading + arcus_sine((x[0] * to_y - x[1] * to_x) * inverse(before * after))
        lag = plus(body.lag, e)
        body.lag = plus(lag, [dot(d, lag) for d in (dx, dy, dz)])
