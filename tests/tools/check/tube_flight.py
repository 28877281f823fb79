"""A trajectory as the reference of a flight, and one flight along it: a quadrotor's own equations with a quaternion.

verify_tube.py flies the middle of each cell with this. docs/tube.md names the equations; tube_geometric.py and tube_cascade.py have the controllers.
"""

import copy
import math

import numpy as np

from tube_claim import STEP, segments_of
from tube_models import cross, dot

GRAVITY = 9.80665
FILTER_SHARE = STEP / (STEP + 1 / (2 * 3.141592653589793 * 30))  # of the low pass on angular acceleration


class Rows:
    """Where the coordinates of docs/tube.md stand in the state: those of a controller, and what all have. What stands before `wind` changes."""

    def __init__(self, **own):
        self.states = 0
        for name, count in {**own, "gust": 3, "wind": 3, "lightness": 1, "drag": 1, "quickness": 1, "agility": 3}.items():
            setattr(self, name, self.states)
            self.states += count


# ---- The reference.

def derivative(points, duration):
    """Of a Bernstein form with points along the first axis."""
    return (points[1:] - points[:-1]) * (len(points) - 1) / duration


def value(points, u):
    """De Casteljau: points (n, k, ...) and u (k,)."""
    points = points.copy()
    u = u.reshape(u.shape + (1,) * (points.ndim - 2))
    while len(points) > 1:
        points = points[:-1] + u * (points[1:] - points[:-1])
    return points[0]


class Track:
    """What the controller is told at each step. Before the start and after the end: the ends, at rest."""

    def __init__(self, segments):
        """Segments as (duration, 8 x 3 control points in ENU axes, 8 yaws)."""
        self.begins, at = [], 0.0
        for duration, _, _ in segments:
            self.begins.append(at)
            at += duration
        self.duration = at
        self.durations = np.array([s[0] for s in segments])
        curves = [np.array([s[1] for s in segments]).transpose(1, 0, 2)]  # control point, segment, axis
        for _ in range(3):
            curves.append(derivative(curves[-1], self.durations[:, None]))
        self.curves = curves
        self.yaw = np.array([s[2] for s in segments]).T
        self.yaw_rate = derivative(self.yaw, self.durations)

    def at(self, first, last):
        """At the steps first, ..., last: (position, velocity, acceleration, jerk, yaw, yaw rate), a row for each step."""
        t = np.arange(first, last + 1).astype(float) * STEP
        piece = np.clip(np.searchsorted(self.begins, t, side="right") - 1, 0, len(self.begins) - 1)
        u = np.clip((t - np.array(self.begins)[piece]) / self.durations[piece], 0.0, 1.0)
        moves = ~((t < 0) | (t > self.duration))
        out = [value(curve[:, piece], u) for curve in self.curves]
        out += [value(self.yaw[:, piece], u), value(self.yaw_rate[:, piece], u)]
        for k in (1, 2, 3, 5):
            out[k] = out[k] * (moves[:, None] if out[k].ndim == 2 else moves)
        return out


def track_of(record, frame):
    """The trajectory of the record."""
    return Track(segments_of(record, frame))


# ---- A flight.

def unit(a):
    size = math.sqrt(dot(a, a))
    return (a[0] / size, a[1] / size, a[2] / size)


def attitude_along(force, yaw):
    """The axes x, y, z whose z is along the force and whose x has the heading."""
    z = unit(force)
    x = unit(cross((-math.sin(yaw), math.cos(yaw), 0.0), z))
    return x, cross(z, x), z


def rates_along(wanted, size, jerk, yaw, yaw_rate):
    """The body rates of a frame that stays along a lift of this size (attitude_along) while the lift changes by the jerk."""
    x, y, z = wanted
    along = dot(z, jerk)
    dz = [(jerk[i] - along * z[i]) / size for i in range(3)]
    left = (-math.sin(yaw), math.cos(yaw), 0.0)
    turned = cross([-yaw_rate * math.cos(yaw), -yaw_rate * math.sin(yaw), 0.0], z)
    leant = cross(left, dz)
    across = [turned[i] + leant[i] for i in range(3)]
    flat = cross(left, z)
    return (-dot(dz, y), dot(dz, x), dot(across, y) / math.sqrt(dot(flat, flat)))


def motors_for(claim, thrust, torque):
    """The commands that give this thrust and torque, not clipped."""
    mean = thrust / 4
    x, y, z = torque[0] / (4 * claim.arm[1]), torque[1] / (4 * claim.arm[0]), torque[2] / (4 * claim.torque_per_thrust)
    return (mean - x - y - z, mean + x + y - z, mean + x - y + z, mean - x + y + z)


def body_axes(q):
    w, x, y, z = q
    return ((1 - 2 * (y * y + z * z), 2 * (x * y + w * z), 2 * (x * z - w * y)),
            (2 * (x * y - w * z), 1 - 2 * (x * x + z * z), 2 * (y * z + w * x)),
            (2 * (x * z + w * y), 2 * (y * z - w * x), 1 - 2 * (x * x + y * y)))


class Quadrotor:
    """Position, velocity, quaternion (w first), body rates and motor thrusts as one list of 17 numbers."""

    def __init__(self, claim, factors, wind):
        """`factors`: how it differs from what is believed, the coordinates from `lightness` on."""
        lightness, drag, quickness, *agility = factors
        self.claim, self.factors, self.wind = claim, list(factors), wind
        self.mass, self.lag = claim.mass / lightness, claim.motor_time_constant / quickness
        self.drag, self.inertia = [d * drag for d in claim.drag], [j / a for j, a in zip(claim.inertia, agility)]

    def torque(self, thrusts):
        a, b, c, d = thrusts
        return ((b + c - a - d) * self.claim.arm[1], (b + d - a - c) * self.claim.arm[0],
                (c + d - a - b) * self.claim.torque_per_thrust)

    def slope(self, s, command):
        q, w, thrusts = s[6:10], s[10:13], s[13:17]
        axes, inertia, drag = body_axes(q), self.inertia, self.drag
        air = (s[3] - self.wind[0], s[4] - self.wind[1], s[5] - self.wind[2])
        force = [-drag[i] * dot(axes[i], air) for i in range(3)]
        force[2] += sum(thrusts)
        acceleration = [sum(force[i] * axes[i][k] for i in range(3)) / self.mass for k in range(3)]
        acceleration[2] -= GRAVITY
        turn = cross(w, [j * x for j, x in zip(inertia, w)])
        torque = self.torque(thrusts)
        v = q[1:]
        more = cross(v, w)
        return [*s[3:6], *acceleration, -0.5 * dot(v, w), *(0.5 * (q[0] * w[i] + more[i]) for i in range(3)),
                *((torque[i] - turn[i]) / inertia[i] for i in range(3)), *((command[i] - thrusts[i]) / self.lag for i in range(4))]

    def stepped(self, s, command):
        """Runge and Kutta's method of order 4."""
        h = STEP
        k1 = self.slope(s, command)
        k2 = self.slope([x + h / 2 * d for x, d in zip(s, k1)], command)
        k3 = self.slope([x + h / 2 * d for x, d in zip(s, k2)], command)
        k4 = self.slope([x + h * d for x, d in zip(s, k3)], command)
        out = [x + h / 6 * (a + 2 * b + 2 * c + d) for x, a, b, c, d in zip(s, k1, k2, k3, k4)]
        size = math.sqrt(sum(c * c for c in out[6:10]))
        out[6:10] = [c / size for c in out[6:10]]
        return out


def read(s, noise):
    """The state as sensors have it. Noise of place, velocity, attitude and rates: the true attitude is turned by the quaternion (1, attitude / 2)."""
    place, velocity, turn, rates = noise
    (w, x, y, z), (a, b, c) = s[6:10], [t / 2 for t in turn]
    q = [w - x * a - y * b - z * c, x + w * a + y * c - z * b, y + w * b + z * a - x * c, z + w * c + x * b - y * a]
    size = math.sqrt(sum(v * v for v in q))
    return [*(a + b for a, b in zip(s[:6], [*place, *velocity])), *(v / size for v in q), *(a + b for a, b in zip(s[10:13], rates)), *s[13:]]


def command(controller, n, s, reference, noise=None):
    """The motors' commands in a step, of readings with noise."""
    if noise is None:
        return controller.command(n, s, reference)
    controller.misread = list(noise[3])
    return controller.command(n, read(s, noise), reference)


def with_gains_off(claim, chance):
    """The claim with gains as far off as it allows, by chance."""
    def off(gains):
        if isinstance(gains, list):
            return [k * (1 + claim.gain_error * chance.choice([-1, 1])) for k in gains]
        out = copy.copy(gains)
        out.p, out.i, out.d = off(gains.p), off(gains.i), off(gains.d)
        return out

    out = copy.copy(claim)
    for name in ("position", "velocity", "attitude", "rates", "lead"):
        if hasattr(claim, name):
            setattr(out, name, off(getattr(claim, name)))
    return out


def fly(claim, track, wind, factors, periods, gusts=None, off=((0, 0, 0), (0, 0, 0)), noise=None, gains=None):
    """The states at the starts of so many periods and one more, and the positions then, of a flight. `gusts` and `noise` have those of each step.

    It starts level on the first reference, claim.before steps before the trajectory; `off`: how far from there, and at what velocity. `gains`, if they
    differ from those of the claim.
    """
    references = [r.tolist() for r in track.at(-claim.before, -claim.before + periods * claim.period)]
    first = track.at(-1, -1)
    yaw = float(first[4][0])
    quadrotor, controller = Quadrotor(claim, factors, wind), claim.law.Controller(claim, gains)
    s = [*(first[0][0] + off[0]).tolist(), *map(float, off[1]), math.cos(yaw / 2), 0.0, 0.0, math.sin(yaw / 2), 0.0, 0.0, 0.0, *[quadrotor.mass * GRAVITY / 4] * 4]
    states, places = [], []
    for n in range(periods * claim.period + 1):
        reference = [r[n] for r in references]
        if n % claim.period == 0:
            states.append([*controller.coordinates(s, quadrotor, reference), 0.0, 0.0, 0.0, *wind, *factors])
            places.append(s[:3])
        if n == periods * claim.period:
            return np.array(states), np.array(places)
        if gusts is not None:
            quadrotor.wind = [w + g for w, g in zip(wind, gusts[n])]
        s = quadrotor.stepped(s, command(controller, n, s, reference, noise and noise[n]))
