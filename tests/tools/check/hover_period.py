"""A period of the closed loop about a hovering vehicle's equilibrium, in the Taylor models of hover_models.py.

A period is the shortest time after which all loops of the controller run in the same way again: one run of the geometric controller, but several of the
cascade's loops.

docs/tube.md names the coordinates. Here the reference rests, so the wanted frame turns by changes of the lift alone. The acceleration that lift and drag
give (the lift's deviation, and the drag of gust, wind and velocity) stands for the gust.
"""

import math
from fractions import Fraction as F
from math import isqrt

from hover_models import BITS, FAULT, ONE, Symbols, arcus_sine, cos_of, cosine, exp_of, fixed, inverse, root, sin_of, sine

GRAVITY = F(980665, 100000)
STEP = F(1, 1000)
FILTER_SHARE = STEP / (STEP + 1 / (2 * F(3.141592653589793) * 30))
VELOCITY_FILTER = 1 / (2 * F(3.141592653589793) * 5)  # s, of the derivative in the cascade's velocity loop
YAW_WEIGHT = F(2, 5)  # of the error about the vertical axis
LEAST_LIFT = F(3, 10) * GRAVITY
HELD = 9  # symbols: mean wind (3), lightness, drag, quickness of the motors, agility (3)


def half_of(middle, half):
    """Of a range around this middle, which is rounded, too."""
    return 0 if half == 0 and F(fixed(F(middle)), ONE) == F(middle) else fixed(F(half)) + 2


# ---- Vectors of three models.

def add(a, b):
    return [x + y for x, y in zip(a, b)]


def subtract(a, b):
    return [x - y for x, y in zip(a, b)]


def scale(k, a):
    """k: a model."""
    return [k * x for x in a]


def times(k, a):
    """k: a fraction, or three."""
    return [x.times(y) for x, y in zip(a, k if isinstance(k, list) else [k] * 3)]


def dot(a, b):
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


class Axes:
    """With this z. The horizontal part of x has a heading."""

    def __init__(self, z, sin, cos):
        self.z = z
        self.left = [cos * z[2], sin * z[2], -(sin * z[1]) - cos * z[0]]  # (-sin, cos, 0) x z
        self.width = root(dot(self.left, self.left))
        self.x = scale(inverse(self.width), self.left)
        self.y = cross(z, self.x)

    def outside(self, v):
        return [v[0] * self.x[i] + v[1] * self.y[i] + v[2] * self.z[i] for i in range(3)]

    def seen(self, v):
        return [dot(axis, v) for axis in (self.x, self.y, self.z)]


class Wanted(Axes):
    """The wanted frame: z is along the lift, and x has the heading of the reference."""

    def __init__(self, lift, sin, cos):
        self.size = root(dot(lift, lift))
        super().__init__(scale(inverse(self.size), lift), sin, cos)
        self.sin, self.cos = sin, cos

    def turned(self, change):
        """When the lift changes: the change as this frame sees it, by how much the lift grows, and what is added to each axis, seen from this frame."""
        e = self.seen(change)
        longer = (self.size * e[2]).times(F(2)) + dot(e, e)  # of the squares
        after = root(self.size * self.size + longer)
        growth = longer * inverse(after + self.size)
        dz = scale(inverse(after), [e[0], e[1], e[2] - growth])
        # What is to the left of the heading lies in the plane of y and z here.
        left_z = self.cos * self.z[1] - self.sin * self.z[0]
        more = [self.width * dz[2] - left_z * dz[1], left_z * dz[0], -(self.width * dz[0])]
        wider = (self.width * more[0]).times(F(2)) + dot(more, more)
        width = root(self.width * self.width + wider)
        more[0] = more[0] - wider * inverse(width + self.width)
        dx = scale(inverse(width), more)
        dy = add([-dx[1], dx[0] + dz[2], -dz[1]], cross(dz, dx))
        return e, growth, (dx, dy, dz)


def turned_heading(heading, x, d):
    """The body's heading in the next wanted frame, of its x axis in this one; the frame's axes change by d."""
    to_x, to_y = dot(d[0], x), dot(d[1], x)
    next_x, next_y = x[0] + to_x, x[1] + to_y
    sizes = root(x[0] * x[0] + x[1] * x[1]) * root(next_x * next_x + next_y * next_y)
    return heading + arcus_sine((x[0] * to_y - x[1] * to_x) * inverse(sizes))


# ---- A period.

class Loop:
    """The closed loop about its equilibrium in a cell. A controller adds its own coordinates and what it commands."""

    IS_SLOW = False  # whether some deviations die away far more slowly than most

    def __init__(self, claim, cell, yaw):
        self.claim = claim
        f = lambda values: [F(v) for v in values]
        self.span = self.milliseconds(claim)
        self.mass, self.inertia, self.arm, self.drag_gains = F(claim.mass), f(claim.inertia), f(claim.arm), f(claim.drag)
        self.reach, self.motor_lag = F(claim.torque_per_thrust), F(claim.motor_time_constant)
        self.drag_rate = self.drag_gains[0] / self.mass
        self.position, self.attitude = f(claim.position), f(claim.attitude)
        self.sin, self.cos = sin_of(fixed(F(yaw))), cos_of(fixed(F(yaw)))
        self.kept = exp_of(fixed(-STEP / F(claim.gust_lag)))  # of a gust after a millisecond
        self.gust_most = fixed(F(claim.gust_most)) + 1
        wind, radius, factors, halves = cell.nominal()
        self.held = [fixed(F(m)) for m in (*wind, *factors)]
        self.halves = [half_of(m, h) for m, h in zip((*wind, *factors), (*radius, *halves))]
        self.gusts = self.COUNT + HELD  # where slopes by gusts begin, and by named errors
        self.named = self.gusts + 3 * self.span
        self.middle = self.equilibrium()

    def start_period(self, bounds):
        """With these bounds of the coordinates, a list for each set."""
        of = self.of = Symbols([[*b, *self.halves] for b in bounds])
        self.gust_symbols, self.named_symbols = [], []
        at = lambda i: of.symbol(i, self.middle[i])
        self.state = [at(i) for i in range(self.COUNT)]
        held = [of.symbol(self.COUNT + i, m) for i, m in enumerate(self.held)]
        self.wind, self.lightness, self.drag_share, self.agility = held[:3], held[3], held[4], held[6:]
        self.lag = held[5].times(1 / self.motor_lag)
        self.heading = [of.constant(x, 64) for x in (self.sin, self.cos)]
        self.lift, self.velocity = self.state[:3], self.state[3:6]
        self.gust = self.state[-3:]
        if self.drag_rate:
            for i, a in enumerate(self.gust):
                away = a - self.away(i, self.lift[i])
                self.gust[i] = away.times(1 / self.drag_rate) + self.away(3 + i, self.velocity[i]) - self.wind_away(i)
        self.commands, self.moved, self.axes = [], [], []  # axes: the body's z axis after each millisecond

    def level(self, off, speed):
        """The vehicle before the controller first runs: how far off it is, how it moves, and what its thrust lacks of the believed weight."""
        self.start_period([[off] * 3 + [speed] * 3 + [0] * (self.COUNT - 6)])
        zero = self.of.constant(0)
        self.lift, self.gust = [zero, zero, zero.plus(fixed(GRAVITY))], [zero] * 3
        self.wanted = Wanted(self.lift, *self.heading)
        place, speed = ([self.of.symbol(k + i) for i in range(3)] for k in (0, 3))
        return place, speed, inverse(self.lightness).times(-GRAVITY).plus(fixed(GRAVITY))

    def away(self, i, model):
        """A coordinate's deviation from the equilibrium."""
        return model.plus(-self.middle[i])

    def wind_away(self, i):
        return self.wind[i].plus(-self.held[i])

    def balance(self, i):
        """How the acceleration along the axis i follows from deviations: (coordinate, factor), and the mean wind's factor."""
        d, gust = self.drag_rate, self.COUNT - 3 + i
        return ([(i, F(1)), (3 + i, -d), (gust, d)] if d else [(gust, F(1))]), d

    def named_error(self, model):
        """The same, with what is not linear as a symbol."""
        self.named_symbols.append(self.of.count)
        return self.of.named(model)

    def named_bounds(self, k):
        return [self.of.bounds[k][i] for i in self.named_symbols]

    def by_coordinates(self, model):
        """The slopes by the coordinates, with the gust in place of the acceleration, by what is held, by each millisecond's gust and by named errors."""
        slopes = [*model.l, *[0] * (self.of.count - len(model.l))]
        out = [*slopes[:self.gusts], *(slopes[i] for i in (*self.gust_symbols, *self.named_symbols))]
        for i in range(3):
            a, (parts, wind) = out[self.COUNT - 3 + i], self.balance(i)
            out[self.COUNT - 3 + i] = 0
            for k, factor in [*parts, (self.COUNT + i, wind)]:
                out[k] += a * factor.numerator // factor.denominator
        return out

    def spun(self, w, agility):
        """J^-1 (w x J w), with the believed inertia over the agility."""
        turn = cross(w, [x.times(j) if agility is None else (x * inverse(g)).times(j) for x, j, g in zip(w, self.inertia, agility or [None] * 3)])
        turn = [t.times(1 / j) for t, j in zip(turn, self.inertia)]
        return turn if agility is None else [t * g for t, g in zip(turn, agility)]

    def drag(self, body, air):
        """Over the believed mass."""
        d, out = self.drag_gains, times(self.drag_gains[0] / self.mass, air)
        for more, axis in ((d[1] - d[0], body.y), (d[2] - d[0], body.z)):
            if more:
                there = self.wanted.outside(axis)
                out = add(out, times(more / self.mass, scale(dot(there, air), there)))
        return scale(self.drag_share, out)

    def slope(self, parts, wind):
        """Of the list: moved (3), velocity (3), the controller's own coordinates, heading, rates (3), spin (3), change of the rates (3)."""
        v, own, heading, w, spin = parts[3:6], parts[6:-10], parts[-10], parts[-9:-6], parts[-6:-3]
        body = self.body(own, heading)
        lag, own_slope = self.own_slope(own, body, w)
        drag = self.drag(body, subtract(v, wind))
        force = scale(self.lightness, subtract(subtract(self.lift, self.wanted.outside(lag)), drag))
        force[2] = force[2].plus(-fixed(GRAVITY))
        x, turn = body.x, [w[2] * b - w[1] * c for b, c in zip(body.y[:2], body.z[:2])]  # how x turns
        heading = (x[0] * turn[1] - x[1] * turn[0]) * inverse(x[0] * x[0] + x[1] * x[1])
        faster = subtract([s * g for s, g in zip(spin, self.agility)], self.spun(w, self.agility))
        return [*v, *force, *own_slope, heading, *faster, *(self.lag * (a - s) for a, s in zip(self.asked, spin)), *faster]

    def move(self, parts):
        """A millisecond of Runge and Kutta's method, and the gust after it."""
        wind = add(self.wind, self.gust)
        go = lambda slope, h: [a + b.times(h) for a, b in zip(parts, slope)]
        k1 = self.slope(parts, wind)
        k2 = self.slope(go(k1, STEP / 2), wind)
        k3 = self.slope(go(k2, STEP / 2), wind)
        k4 = self.slope(go(k3, STEP), wind)
        out = go([a + (b + c).times(F(2)) + d for a, b, c, d in zip(k1, k2, k3, k4)], STEP / 6)
        share, fault = F(self.kept, ONE), 4 * self.gust_most // ONE + 4
        new = [self.of.add([self.gust_most] * len(self.of.bounds)) for _ in range(3)]
        self.gust_symbols += new
        self.gust = [g.times(share) + self.of.symbol(i).times(1 - share).wider(fault) for g, i in zip(self.gust, new)]
        self.moved.append(out[:3])
        self.axes.append(self.wanted.outside(self.body(out[6:-10], out[-10]).z))
        return out

    def motors(self, thrust):
        """What they are told, of a thrust over mass and the spin that is asked for."""
        arms = (self.arm[1], self.arm[0], self.reach)
        x, y, z = (a.times(j / (4 * arm)) for a, j, arm in zip(self.asked, self.inertia, arms))
        mean = thrust.times(self.mass / 4)
        self.commands.append([mean - x - y - z, mean + x + y - z, mean + x - y + z, mean - x + y + z])

    def motor_limits(self):
        """What must be above 0: (words, models, room by their least and by their most)."""
        least, most = (fixed(F(m)) for m in (self.claim.motor_least, self.claim.motor_most))
        room = lambda low, high: min(most - high[0], low[0] - least)
        return [(f"motor {i + 1} may leave its range", [m], room) for command in self.commands for i, m in enumerate(command)]

    def steady_lift(self):
        """The lift that holds the middle's weight in its wind. Drag depends on how the vehicle leans into the wind, so this is a fixed point; it need not be
        exact."""
        of = Symbols([[0]])
        self.drag_share, wind = of.constant(self.held[4]), [of.constant(-w) for w in self.held[:3]]
        weight = ONE * fixed(GRAVITY) // self.held[3]
        lift = [0, 0, weight]
        for _ in range(60):
            self.wanted = Wanted([of.constant(a) for a in lift], of.constant(self.sin), of.constant(self.cos))
            level = Axes([of.constant(0), of.constant(0), of.constant(ONE)], of.constant(0), of.constant(ONE))
            lift = [d.c for d in self.drag(level, wind)]
            lift[2] += weight
        return lift


class Geometric(Loop):
    """Coordinates: lift (3), velocity (3), lag (3), heading, rates (3), spin (3), low-passed angular acceleration (3),
    change of the rates since they were last seen (3), acceleration (3)."""

    COUNT = 25
    SPINS = range(13, 22)
    PHASES = (0, 1, 2, 3, 4, 5, 6, 7, 8, 10, 12, 14, 17, 20, 25, 30, 40, 60, 100, 180, 340, 700)  # periods from which on other bounds of the coordinates hold

    @staticmethod
    def milliseconds(claim):
        return claim.period

    def equilibrium(self):
        self.velocity_gains, self.rate_gains, self.lead = ([F(v) for v in gains] for gains in (self.claim.velocity, self.claim.rates, self.claim.lead))
        return [*self.steady_lift(), *[0] * 22]

    def place_rows(self):
        """The place as a linear form of the deviations."""
        for i in range(3):
            row = [F(0)] * self.COUNT
            row[i], row[3 + i] = -1 / self.position[i], -self.velocity_gains[i] / self.position[i]
            yield row

    def place(self):
        """The equilibrium's, from the reference."""
        return [-F(a, ONE) / k for a, k in zip([*self.middle[:2], self.middle[2] - fixed(GRAVITY)], self.position)]

    def body(self, own, heading):
        thrust = [-own[0], -own[1], self.wanted.size - own[2]]
        self.force = root(dot(thrust, thrust))
        return Axes(scale(inverse(self.force), thrust), sine(heading), cosine(heading))

    def own_slope(self, own, body, w):
        """The lag, and slopes of the lag and of what the thrust lacks."""
        lacks = self.lag * own[3]
        turn = [w[1] * a - w[0] * b for a, b in zip(body.x, body.y)]
        return own[:3], [*(-(lacks * z + self.force * t) for z, t in zip(body.z, turn)), -lacks]

    def command(self, parts, filtered):
        """What thrust and torque the motors are told. Second-order terms of the torque become symbols. Returns what the thrust lacks."""
        lag, w = parts[6:9], parts[-9:-6]
        body = self.body(parts[6:-10], parts[-10])
        dx, dz = [-a for a in body.x], [-a for a in body.z]
        dx[0], dz[2] = dx[0].plus(ONE), dz[2].plus(ONE)
        second, shrink = cross(dz, dx), inverse(self.wanted.size)
        half = F(1, 2)
        error = [shrink * dot(body.y, lag) - dot(body.z, second).times(half), -(shrink * dot(body.x, lag)) - dot(dz, dx).times(half),
                 dot(body.x, second).times(half) - body.y[0]]
        spin = subtract(self.spun(w, None), add(add(times(self.attitude, error), times(self.rate_gains, w)), times(self.lead, filtered)))
        self.asked = [self.named_error(s) for s in spin]
        self.motors(self.wanted.size * body.z[2])
        return dot(lag, body.z)

    def run(self, bounds):
        """Returns the state after a period."""
        self.start_period(bounds)
        self.wanted = Wanted(self.lift, *self.heading)
        filtered, seen, zero = self.state[16:19], self.state[19:22], self.of.constant(0)
        parts = [zero, zero, zero, *self.velocity, *self.state[6:9], zero, *self.state[9:16], zero, zero, zero]
        for _ in range(self.span):
            filtered = add(times(1 - FILTER_SHARE, filtered), times(FILTER_SHARE / STEP, seen))
            parts[9] = self.command(parts, filtered)
            parts = self.move(parts)
            seen, parts[-3:] = parts[-3:], [zero] * 3
        change = [-(parts[i].times(self.position[i]) + (parts[3 + i] - self.velocity[i]).times(self.velocity_gains[i])) for i in range(3)]
        return self.changed(change, parts, filtered, seen)

    def changed(self, change, parts, filtered, seen):
        """The state when the lift has changed."""
        e, _, d = self.wanted.turned(change)
        lag = add(parts[6:9], e)
        lag = add(lag, [dot(axis, lag) for axis in d])
        heading = turned_heading(parts[-10], self.body(parts[6:-10], parts[-10]).x, d)
        lift = add(self.lift, change)
        return [*lift, *parts[3:6], *lag, heading, *parts[-9:-3], *filtered, *seen, *self.gust]

    def limits(self):
        return self.motor_limits()

    def away_in_period(self):
        """How far the vehicle may be from where it was when the period began."""
        return self.moved

    def start(self, off, speed):
        """The state when the controller first runs. The symbols of the lift stand for how far the vehicle is off, those of the velocity for how it moves."""
        place, speed, lacks = self.level(off, speed)
        zero = self.of.constant(0)
        parts = [zero, zero, zero, *speed, zero, zero, lacks, *[zero] * 10]
        change = [-(p.times(k) + v.times(g)) for p, v, k, g in zip(place, speed, self.position, self.velocity_gains)]
        return self.changed(change, parts, [zero] * 3, [zero] * 3)


class Cascade(Loop):
    """Coordinates: lift (3), velocity (3), tilt (2), what the thrust lacks, heading, rates (3), spin (3), low-passed angular acceleration (3), integral of
    the rate loop (3), the velocity's error when the position loop last ran (3), its low-passed derivative (3), how the lift would change if that loop ran
    now (3), acceleration (3)."""

    COUNT = 34
    SPINS = range(13, 22)
    PHASES = (0, 1, 2, 4, 8, 16, 25, 40, 60, 100, 140, 200, 300, 500)
    IS_SLOW = True

    def __init__(self, claim, cell, yaw):
        f = lambda values: [F(v) for v in values]
        k, self.again = claim.velocity, STEP * claim.position_period
        share = self.again / (self.again + VELOCITY_FILTER)
        self.share, self.push = share, f(k.p)
        self.of_missed = [self.again * i for i in f(k.i)]  # what the errors add to the lift when the position loop runs
        self.of_slope = [share * d for d in f(k.d)]
        self.of_drift = [p + m + s / self.again for p, m, s in zip(self.push, self.of_missed, self.of_slope)]
        self.rate_gains = [f(gains) for gains in (claim.rates.p, claim.rates.i, claim.rates.d)]
        super().__init__(claim, cell, yaw)

    @staticmethod
    def milliseconds(claim):
        return math.lcm(claim.position_period, claim.period)

    def equilibrium(self):
        return [*self.steady_lift(), *[0] * 31]

    def place_rows(self):
        for i in range(3):
            row = [F(0)] * self.COUNT
            row[3 + i], row[22 + i] = F(1), 1 - self.of_missed[i] / self.of_drift[i]
            row[25 + i], row[28 + i] = self.of_slope[i] / self.of_drift[i], 1 / self.of_drift[i]
            yield [-a / self.position[i] for a in row]

    def place(self):
        return [F(0)] * 3

    def body(self, own, heading):
        x, y, _ = own
        return Axes([x, y, root((-(x * x + y * y)).plus(ONE))], sine(heading), cosine(heading))

    def own_slope(self, own, body, w):
        """The lag, and slopes of tilt and of what the thrust lacks."""
        x, y, lacks = own
        thrust = self.wanted.size - lacks
        sunk = (x * x + y * y) * inverse(body.z[2].plus(ONE))
        tilt = [w[1] * a - w[0] * b for a, b in zip(body.x[:2], body.y[:2])]
        return [-(thrust * x), -(thrust * y), lacks + thrust * sunk], [*tilt, -(self.lag * lacks)]

    def drift(self, due, missed, rises):
        """By how much the velocity's error has changed since the position loop ran."""
        return times([1 / k for k in self.of_drift], add(subtract(due, times(self.of_missed, missed)), times(self.of_slope, rises)))

    def follow(self, parts):
        """The loops of position and velocity run."""
        v = parts[3:6]
        due = subtract(self.lead, times(self.of_drift, v))
        drift = self.drift(due, self.missed, self.rises)
        _, growth, d = self.wanted.turned(due)
        body = self.body(parts[6:9], parts[9])
        tilt = [a + dot(axis, body.z) for a, axis in zip(parts[6:8], d)]
        parts = [*parts[:6], *tilt, parts[8] + growth, turned_heading(parts[9], body.x, d), *parts[10:]]
        self.lift, self.missed = add(self.lift, due), add(self.missed, drift)
        self.rises = add(times(1 - self.share, self.rises), times(self.share / self.again, drift))
        pushed = times(self.of_missed, self.missed)
        self.lead = add(subtract(pushed, times(self.of_slope, self.rises)), times(self.of_drift, v))
        self.wanted = Wanted(self.lift, *self.heading)
        acceleration = [*self.lift[:2], self.lift[2].plus(-fixed(GRAVITY))]
        self.runs.append((add(self.missed, v), [*subtract(acceleration, pushed), *acceleration], self.lift))
        return parts

    def orient(self, parts):
        """The attitude loop runs: the rates that are wanted."""
        body = self.body(parts[6:9], parts[9])
        x, y, z = body.x[2], body.y[2], body.z[2]  # the wanted z axis in the body's frame
        above = z.plus(ONE)
        half = root(above.times(F(1, 2)))
        off = x * body.z[1] * inverse(above) - body.x[1]  # the sine of the angle that is left about z
        rest = arcus_sine(off).times(YAW_WEIGHT / 2)
        c, s, grow = cosine(rest), sine(rest), inverse(half)
        error = [grow * (x * s - y * c), grow * (x * c + y * s), (half * s).times(F(2))]
        self.rates = [self.named_error(e) for e in times(self.attitude, error)]
        self.turns.append(self.rates)

    def command(self, parts, filtered):
        """What the motors are told. What is not linear in the torque becomes symbols."""
        p, i, d = self.rate_gains
        error = subtract(self.rates, parts[-9:-6])
        rest = subtract(times(p, error), times(d, filtered))
        before = add(rest, self.integral)
        self.integral = add(self.integral, times([STEP * k for k in i], error))
        spin = add(rest, self.integral)
        self.spins += [*before, *spin]
        self.asked = [self.named_error(s) for s in add(spin, self.spun(parts[-9:-6], None))]
        self.motors(self.wanted.size)

    def run(self, bounds):
        self.start_period(bounds)
        self.wanted = Wanted(self.lift, *self.heading)
        filtered, self.integral, self.missed, self.rises, due = (self.state[k:k + 3] for k in (16, 19, 22, 25, 28))
        self.lead = add(due, times(self.of_drift, self.velocity))  # what is due without the velocity: no force acts on it
        self.runs, self.turns, self.spins = [], [], []
        zero = self.of.constant(0)
        parts = [zero, zero, zero, *self.state[3:16], zero, zero, zero]
        for millisecond in range(self.span):
            if millisecond % self.claim.position_period == 0:
                parts = self.follow(parts)
            if millisecond % self.claim.period == 0:
                self.orient(parts)
            self.command(parts, filtered)
            before, parts = parts[:3], self.move(parts)
            filtered = add(times(1 - FILTER_SHARE, filtered), times(FILTER_SHARE / STEP, parts[-3:]))
            parts[-3:] = [zero] * 3
            lost = times(self.position, subtract(parts[:3], before))
            self.lead = subtract(self.lead, times(self.of_drift, lost))
        velocity = [self.named_error(v) for v in parts[3:6]]
        due = subtract(self.lead, times(self.of_drift, velocity))
        return [*self.lift, *velocity, *parts[6:16], *filtered, *self.integral, *self.missed, *self.rises, *due, *self.gust]

    def away_in_period(self):
        """How far the vehicle may be from the straight way from where it was when the period began to where it is when the period ends."""
        whole = self.moved[-1]
        return [[a - b.times(F(k + 1, self.span)) for a, b in zip(moved, whole)] for k, moved in enumerate(self.moved)]

    def limits(self):
        """Nothing is clipped. The sizes of what two loops ask for are limited axis by axis."""
        claim = self.claim

        def within(words, most, models):
            """Each of these models."""
            if most == math.inf:
                return []
            most = fixed(F(most))
            return [(words, [m], lambda low, high: most - max(high[0], -low[0])) for m in models]

        out = self.motor_limits()
        for i, most in enumerate(claim.body_rate_max):
            out += within("the rates may be clipped", most, [rates[i] for rates in self.turns])
        out += within("the angular acceleration may be clipped", claim.clips.rates, self.spins)
        for speed, accelerations, lift in self.runs:
            out += within("the velocity may be clipped", claim.clips.position, speed)
            out += within("the acceleration may be clipped", claim.clips.velocity, accelerations)
            out += [("the lift may be clipped", lift, self.lift_room), ("the tilt may be clipped", lift, self.tilt_room)]
        return out

    def lift_room(self, low, high):
        most = fixed(4 * F(self.claim.motor_most) / self.mass)
        least = min(fixed(LEAST_LIFT) + 1, most)
        if high[2] >= most:
            return most - high[2]
        return min(low[2] - least, isqrt(most * most - high[2] * high[2]) - across(low, high))

    def tilt_room(self, low, high):
        angle = fixed(F(self.claim.tilt_max))
        return (low[2] * (sin_of(angle) - FAULT) - across(low, high) * (cos_of(angle) + FAULT)) >> BITS

    def start(self, off, speed):
        """The state when the controller first runs, as if it had seen the velocity's error before: so it has no slope yet, and its integral is due."""
        place, speed, lacks = self.level(off, speed)
        zero = self.of.constant(0)
        missed = [-(p.times(k) + v) for p, v, k in zip(place, speed, self.position)]
        change = times(self.push, missed)
        _, growth, d = self.wanted.turned(change)
        body = self.body([zero, zero, zero], zero)
        tilt = [dot(axis, body.z) for axis in d[:2]]
        heading = turned_heading(zero, body.x, d)
        return [*add(self.lift, change), *speed, *tilt, lacks + growth, heading, *[zero] * 12, *missed, *[zero] * 3, *times(self.of_missed, missed), *self.gust]


def across(low, high):
    """The most of the horizontal part of a lift."""
    return isqrt(sum(max(b, -a) ** 2 for a, b in zip(low[:2], high))) + 1
