"""A period of the closed loop about a hovering vehicle's equilibrium, in the Taylor models of hover_models.py: what all controllers have.

docs/tube.md names the coordinates. Here the reference rests, so the wanted frame turns by changes of the lift alone. The acceleration that lift and drag
give (the lift's deviation, and the drag of gust, wind and velocity) stands for the gust.
"""

from fractions import Fraction as F

from hover_models import ONE, Model, Symbols, arcus_sine, cos_of, cosine, exp_of, fixed, inverse, root, sin_of, sine

GRAVITY = F(980665, 100000)
STEP = F(1, 1000)
FILTER_SHARE = STEP / (STEP + 1 / (2 * F(3.141592653589793) * 30))
HELD = 9  # symbols: mean wind (3), lightness, drag, quickness of the motors, agility (3)


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

    def __init__(self, claim, cell, yaw):
        self.claim = claim
        f = lambda values: [F(v) for v in values]
        self.mass, self.inertia, self.arm, self.drag_gains = F(claim.mass), f(claim.inertia), f(claim.arm), f(claim.drag)
        self.reach, self.motor_lag = F(claim.torque_per_thrust), F(claim.motor_time_constant)
        self.drag_rate = self.drag_gains[0] / self.mass
        self.position, self.attitude = f(claim.position), f(claim.attitude)
        self.sin, self.cos = sin_of(fixed(F(yaw))), cos_of(fixed(F(yaw)))
        self.kept = exp_of(fixed(-STEP / F(claim.gust_lag)))  # of a gust after a millisecond
        self.gust_most = fixed(F(claim.gust_most)) + 1
        wind, radius, factors, halves = cell.nominal()
        self.held = [fixed(F(m)) for m in (*wind, *factors)]
        self.halves = [fixed(F(h)) + 2 for h in (*radius, *halves)]  # each middle is rounded, too
        self.gusts = self.COUNT + HELD  # where symbols of gusts begin, and of named errors
        self.named = self.gusts + 3 * claim.period
        self.symbols = self.named + self.NAMED(claim.period)
        self.middle = self.equilibrium()

    def start_period(self, bounds):
        """With these bounds of the coordinates, a list for each set."""
        count = self.symbols - self.named
        of = self.of = Symbols([[*b, *self.halves, *[self.gust_most] * (3 * self.claim.period), *[0] * count] for b in bounds])
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
        self.commands, self.moved, self.upright = [], [], []

    def away(self, i, model):
        """A coordinate's deviation from the equilibrium."""
        return model.plus(-self.middle[i])

    def wind_away(self, i):
        return self.wind[i].plus(-self.held[i])

    def balance(self, i):
        """How the acceleration along the axis i follows from deviations: (coordinate, factor), and the mean wind's factor."""
        d, gust = self.drag_rate, self.COUNT - 3 + i
        return ([(i, F(1)), (3 + i, -d), (gust, d)] if d else [(gust, F(1))]), d

    def by_coordinates(self, model):
        """The slopes by the coordinates, with the gust in place of the acceleration, and by all that comes after."""
        out = list(model.l)
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

    def move(self, parts, millisecond):
        """A millisecond of Runge and Kutta's method, and the gust after it."""
        wind = add(self.wind, self.gust)
        go = lambda slope, h: [a + b.times(h) for a, b in zip(parts, slope)]
        k1 = self.slope(parts, wind)
        k2 = self.slope(go(k1, STEP / 2), wind)
        k3 = self.slope(go(k2, STEP / 2), wind)
        k4 = self.slope(go(k3, STEP), wind)
        out = go([a + (b + c).times(F(2)) + d for a, b, c, d in zip(k1, k2, k3, k4)], STEP / 6)
        share, fault = F(self.kept, ONE), 4 * self.gust_most // ONE + 4
        first = self.gusts + 3 * millisecond
        self.gust = [g.times(share) + self.of.symbol(first + i).times(1 - share).wider(fault) for i, g in enumerate(self.gust)]
        self.moved.append(out[:3])
        self.upright.append(self.wanted.outside(self.body(out[6:-10], out[-10]).z)[2])
        return out

    def motors(self, thrust):
        """What they are told, of a thrust over mass and the spin that is asked for."""
        arms = (self.arm[1], self.arm[0], self.reach)
        x, y, z = (a.times(j / (4 * arm)) for a, j, arm in zip(self.asked, self.inertia, arms))
        mean = thrust.times(self.mass / 4)
        self.commands.append([mean - x - y - z, mean + x + y - z, mean + x - y + z, mean - x + y + z])

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

    @staticmethod
    def NAMED(period):
        return 3 * period

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

    def command(self, parts, filtered, millisecond):
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
        self.asked = [self.of.named(s, self.named + 3 * millisecond + i) for i, s in enumerate(spin)]
        self.motors(self.wanted.size * body.z[2])
        return dot(lag, body.z)

    def run(self, bounds):
        """Returns the state after a period."""
        self.start_period(bounds)
        self.wanted = Wanted(self.lift, *self.heading)
        filtered, seen, zero = self.state[16:19], self.state[19:22], self.of.constant(0)
        parts = [zero, zero, zero, *self.velocity, *self.state[6:9], zero, *self.state[9:16], zero, zero, zero]
        for millisecond in range(self.claim.period):
            filtered = add(times(1 - FILTER_SHARE, filtered), times(FILTER_SHARE / STEP, seen))
            parts[9] = self.command(parts, filtered, millisecond)
            parts = self.move(parts, millisecond)
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

    def start(self, off, speed):
        """The state when the controller first runs. The symbols of the lift stand for how far the vehicle is off, those of the velocity for how it moves."""
        self.start_period([[off] * 3 + [speed] * 3 + [0] * (self.COUNT - 6)])
        zero = self.of.constant(0)
        place, speed = ([self.of.symbol(k + i) for i in range(3)] for k in (0, 3))
        self.lift = [zero, zero, zero.plus(fixed(GRAVITY))]
        self.gust = [zero] * 3
        self.wanted = Wanted(self.lift, *self.heading)
        lacks = inverse(self.lightness).times(-GRAVITY).plus(fixed(GRAVITY))
        parts = [zero, zero, zero, *speed, zero, zero, lacks, *[zero] * 10]
        change = [-(p.times(k) + v.times(g)) for p, v, k, g in zip(place, speed, self.position, self.velocity_gains)]
        return self.changed(change, parts, [zero] * 3, [zero] * 3)
