"""A period of the closed loop in Taylor models of order 1, for many periods at once: what both controllers have.

docs/tube.md derives the equations; verify_tube.py uses what comes out.
"""

import types

import numpy as np

from tube_flight import GRAVITY, STEP
from tube_models import ROUNDING, Model, arcus_sine, cross, dot, inverse, minus, plus, root, scaled, times


def groups(claim, periods):
    """The periods in groups: the loops run in the same way in all periods of a group."""
    count = claim.law.order(claim)
    return [found for k in range(count) if len(found := periods[periods % count == k])]


class Frame:
    """Axes with this z and a heading of x: across that and what is to its left."""

    def __init__(self, z, sin, cos, size=1.0):
        self.z, self.sin, self.cos, self.size = z, sin, cos, size
        across = self.left(z)
        self.across = root(dot(across, across))
        self.x = times(inverse(self.across), across)
        self.y = cross(self.z, self.x)

    @staticmethod
    def along(force, sin, cos):
        size = root(dot(force, force))
        return Frame(times(inverse(size), force), sin, cos, size)

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


class Body:
    """What moves between two milliseconds."""

    def __init__(self, **parts):
        self.__dict__.update(parts)

    def moved_by(self, slope, h):
        step = lambda a, d: [x + h * y for x, y in zip(a, d)] if isinstance(a, list) else a + h * d
        return Body(**{name: step(getattr(self, name), part) for name, part in vars(slope).items()})


class FrameChange:
    """How the wanted frame turns, seen from it: e is the change of the lift, and x, y, z of the axes. All are small with that of the lift."""

    def __init__(self, wanted, change, yaw, next_yaw):
        w = wanted
        self.lift = e = w.seen(change)
        longer = 2.0 * w.size * e[2] + dot(e, e)  # of the squares
        size = root(w.size * w.size + longer)
        self.growth, shrink = longer * inverse(size + w.size), inverse(size)
        self.z = dz = [shrink * e[0], shrink * e[1], shrink * (e[2] - self.growth)]
        half, mean = 2 * np.sin((next_yaw - yaw) / 2), (next_yaw + yaw) / 2
        turn = w.seen([-half * np.cos(mean), -half * np.sin(mean), np.zeros(len(yaw))])  # of what is to the left
        left = [0.0, w.across, w.cos * w.z[1] - w.sin * w.z[0]]
        z = [dz[0], dz[1], 1.0 + dz[2]]
        across = plus([left[1] * dz[2] - left[2] * dz[1], left[2] * dz[0], -(left[1] * dz[0])], cross(turn, z))
        wider = 2.0 * w.across * across[0] + dot(across, across)
        across_size = root(w.across * w.across + wider)
        across[0] = across[0] - wider * inverse(across_size + w.across)
        self.x = dx = times(inverse(across_size), across)
        self.y = plus(plus([-dx[1], dx[0], 0.0], [0.0, dz[2], -dz[1]]), cross(dz, dx))

    def heading(self, before, x):
        """The body's in the next wanted frame; `x` is its x axis in this one."""
        to_x, to_y = dot(self.x, x), dot(self.y, x)
        size = root(x[0] * x[0] + x[1] * x[1])
        next_x, next_y = x[0] + to_x, x[1] + to_y
        next_size = root(next_x * next_x + next_y * next_y)
        return before + arcus_sine((x[0] * to_y - x[1] * to_x) * inverse(size * next_size))


class Plant:
    """All periods of a chunk that begin `starts` steps after the controller's first run: what the state is at their ends (`after`), and on the way
    what motors are told (`commands`), how far the vehicle has moved and the cosine of its tilt after each millisecond."""

    def __init__(self, claim, states, scales, references, starts):
        """`states`: the nominal ones at the starts, (periods, states). `scales`: the radius of each symbol, those of the gust of the acceleration that
        lift and drag give. `references`: as Track.at() gives them for all steps of the flight."""
        self.claim, self.count, self.rows = claim, len(states), claim.law.ROWS
        self.symbols = self.rows.states + sum(claim.law.named(claim))
        self.scales, self.middle = scales, states
        self.references, self.starts = references, starts
        self.commands, self.moved, self.upright = [], [], []
        self.start()
        self.run()

    def reference(self, millisecond):
        """Position, velocity, acceleration, jerk, yaw and yaw rate in each period."""
        return [r[self.starts + millisecond] for r in self.references]

    def zero(self):
        return Model(np.zeros(self.count), np.zeros((self.symbols, self.count)), np.zeros(self.count))

    def symbol(self, row, middle=None):
        out = self.zero()
        out.c = self.middle[:, row].copy() if middle is None else middle
        out.l[row] = self.scales[:, row]
        return out

    def three(self, row):
        return [self.symbol(row + i) for i in range(3)]

    def within(self, radius):
        out = self.zero()
        out.r = out.r + radius
        return out

    def by_gain(self, gain, error):
        """What a loop asks for. The gain may be off."""
        out = gain * error
        if not self.claim.gain_error:
            return out
        return Model(out.c, out.l, out.r + self.claim.gain_error * (1 + 2 * ROUNDING) * out.size())

    def any_three(self, most):
        """Three numbers of which nothing is known but their bound."""
        return [self.within(most * (1 + ROUNDING)) for _ in range(3)]

    def named(self, model, symbol):
        """The same with its remainder as a symbol that has not been in use."""
        l = model.l.copy()
        l[self.rows.states + symbol] = model.r
        return Model(model.c, l, np.zeros(self.count))

    def read(self, frame):
        """The axes of the body's frame as the attitude sensor has them, and how far each is off: they are turned by the quaternion (1, h), divided by
        its length, where h is half of the noise. So an axis e is off by 2 (h x e + h x (h x e)) / (1 + h . h) in the body's frame."""
        h = self.any_three(0.5 * self.claim.attitude_noise)
        share, off = 2.0 * inverse(1.0 + dot(h, h)), []
        for i in range(3):
            unit = [1.0 if i == k else 0.0 for k in range(3)]
            once = cross(h, unit)
            turned = times(share, plus(once, cross(h, once)))
            off.append([turned[0] * frame.x[k] + turned[1] * frame.y[k] + turned[2] * frame.z[k] for k in range(3)])
        seen = [plus(axis, more) for axis, more in zip((frame.x, frame.y, frame.z), off)]
        return types.SimpleNamespace(x=seen[0], y=seen[1], z=seen[2]), off

    def by_error(self, noise, error, gain, symbol):
        """Noise that took `gain` times itself from an error, which is a symbol: written by this symbol where it is most of the error. With the error
        k s = rest - gain noise, the noise is -(k / gain) s + rest / gain."""
        if not gain:
            return noise
        size = error.l[self.rows.states + symbol]
        rest = np.maximum(size - gain * noise.r, 0.0) + ROUNDING * size
        tied = rest < gain * noise.r / 4
        out = self.zero()
        out.l[self.rows.states + symbol] = np.where(tied, -size / gain, 0.0)
        out.r = np.where(tied, rest / gain * (1 + ROUNDING) + ROUNDING * size / gain, noise.r)
        return out

    def start(self):
        """What both controllers have in their states."""
        rows, three = self.rows, self.three
        self.lift, self.velocity, self.wind = three(rows.lift), three(rows.velocity), three(rows.wind)
        self.filtered = three(rows.filtered)
        self.start_factors()
        drag = self.claim.drag_rate
        if not drag:
            self.gust = three(rows.gust)
        else:  # acceleration = lift + drag (gust + wind - velocity), all as deviations
            self.gust = []
            for i in range(3):
                away = self.symbol(rows.gust + i, np.zeros(self.count)) - (self.lift[i] - self.middle[:, rows.lift + i])
                air = (self.velocity[i] - self.middle[:, rows.velocity + i]) - (self.wind[i] - self.middle[:, rows.wind + i])
                self.gust.append((1 / drag) * away + air + self.middle[:, rows.gust + i])

    def level(self):
        """Takes the symbols of the lift for places, and gives the lift of a vehicle that hovers. Returns the places."""
        off = [a - self.middle[:, self.rows.lift + i] for i, a in enumerate(self.lift)]
        self.lift = [self.zero(), self.zero(), self.zero() + GRAVITY]
        return off

    def missing(self):
        """What the thrust that holds the true weight lacks of the lift of the weight that is believed."""
        return GRAVITY - GRAVITY * inverse(self.lightness)

    def start_factors(self):
        """How the true vehicle differs from the believed one; nothing where that has no range."""
        claim, rows = self.claim, self.rows
        self.lightness = self.symbol(rows.lightness)
        self.drag_share = self.symbol(rows.drag) if claim.drag_error else None
        self.lag = 1 / claim.motor_time_constant
        if claim.motor_lag_error:
            self.lag = self.lag * self.symbol(rows.quickness)
        self.agility = self.three(rows.agility) if claim.inertia_error else None

    def body_parts(self):
        """What bodies of both controllers have, at the start of the period."""
        none, rows = [self.zero() for _ in range(3)], self.rows
        return {"moved": none, "velocity": self.velocity, "heading": self.symbol(rows.heading), "rates": self.three(rows.rates),
                "spin": self.three(rows.spin)}

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

    def motion(self, body, frame, lag, wind):
        """The slopes of what bodies of both controllers have, with the lift minus the thrust over believed mass, seen from the wanted frame; and how
        the body's z axis turns."""
        air = self.drag(frame, minus(body.velocity, wind))
        rest = minus(minus(self.lift, self.wanted.outside(lag)), times(1 / self.claim.mass, air))
        velocity = times(self.lightness, rest)
        velocity[2] = velocity[2] - GRAVITY
        w = body.rates
        z = [w[1] * frame.x[i] - w[0] * frame.y[i] for i in range(3)]
        rates = self.angular_acceleration(w, body.spin)
        heading = (w[2] * frame.across - dot(frame.left(z), frame.y)) * inverse(-dot(frame.ahead(frame.z), frame.y))
        return {"moved": body.velocity, "velocity": velocity, "heading": heading, "rates": rates, "turned": rates,
                "spin": times(self.lag, minus(self.asked, body.spin))}, z

    def motors(self, thrust):
        claim = self.claim
        x, y, z = (claim.inertia[i] / (4 * arm) * self.asked[i]
                   for i, arm in enumerate((claim.arm[1], claim.arm[0], claim.torque_per_thrust)))
        mean = (claim.mass / 4) * thrust
        return [mean - x - y - z, mean + x + y - z, mean + x - y + z, mean - x + y + z]

    def move(self, millisecond):
        """A millisecond of the vehicle."""
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

    def gust_after(self):
        return times(self.claim.gust_kept(self.claim.period), self.gust)


def motor_limits(claim, commands):
    """Of each command the models that have a limit, and the room that they leave: `halves` bound how far each may be from its middle."""
    def rooms(middles, halves):
        for motor, (c, half) in enumerate(zip(middles, halves)):
            yield f"motor {motor % 4 + 1} may leave its range", np.minimum(claim.motor_most - c, c - claim.motor_least) - half
    return [m for command in commands for m in command], rooms
