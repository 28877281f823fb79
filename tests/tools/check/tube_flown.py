"""A flight of one period from any state, by a quadrotor's own equations (tube_flight.py): what models of a period must hold."""

import math

import numpy as np

import tube_cascade
import tube_geometric
from tube_flight import FILTER_SHARE, GRAVITY, Quadrotor, attitude_along, body_axes, command, with_gains_off
from tube_models import dot


def quaternion(axes):
    """Of a rotation that is far from half a turn; `axes` are its columns."""
    x, y, z = axes
    w = math.sqrt(1 + x[0] + y[1] + z[2]) / 2
    return [w, (y[2] - z[1]) / (4 * w), (z[0] - x[2]) / (4 * w), (x[1] - y[0]) / (4 * w)]


def geometric(claim, gains, e, reference, asked):
    """A controller in the state with these coordinates, the place, and the thrust over mass as the wanted frame sees it."""
    p, v, a, *_ = reference
    lift, lag = list(e[:3]), e[6:9]
    place = [p[i] - (lift[i] - a[i] - (GRAVITY if i == 2 else 0) - claim.velocity[i] * (v[i] - e[3 + i])) / claim.position[i] for i in range(3)]
    controller = tube_geometric.Controller(claim, gains)
    controller.filtered = list(e[16:19])
    controller.last_rates = [e[10 + i] - e[19 + i] for i in range(3)]
    return controller, lift, place, [-lag[0], -lag[1], math.sqrt(dot(lift, lift)) - lag[2]]


def cascade(claim, gains, e, reference, asked):
    rows, k = tube_cascade.ROWS, tube_cascade.LiftGains(claim)
    p, v, *_ = reference
    lift, velocity, missed, slope, due = (list(e[row:row + 3]) for row in (rows.lift, rows.velocity, rows.missed, rows.slope, rows.due))
    place = []
    for i in range(3):
        error = missed[i] + (due[i] - k.of_missed[i] * missed[i] + k.of_slope[i] * slope[i]) / k.of_drift[i]
        place.append(p[i] - (error + velocity[i] - claim.forward.velocity * v[i]) / gains.position[i])
    controller = tube_cascade.Controller(claim, gains)
    controller.missed, controller.slope = missed, slope
    forward = [claim.forward.acceleration * asked[i] + (GRAVITY if i == 2 else 0) for i in range(3)]
    of_errors = lambda k: [k.p[i] * missed[i] + k.d[i] * slope[i] for i in range(3)]
    sums = [lift[i] - forward[i] - asks for i, asks in enumerate(of_errors(claim.velocity))]
    controller.sum = [sums[i] * gains.velocity.i[i] / claim.velocity.i[i] for i in range(3)]
    controller.lift = [forward[i] + asks + controller.sum[i] for i, asks in enumerate(of_errors(gains.velocity))]
    controller.integral = list(e[rows.integral:rows.integral + 3])
    controller.last_rates = list(e[rows.rates:rows.rates + 3])
    controller.filtered = [f / (1 - FILTER_SHARE) for f in e[rows.filtered:rows.filtered + 3]]
    x, y = e[rows.tilt:rows.tilt + 2]
    thrust = math.sqrt(dot(lift, lift)) - e[rows.missing]
    return controller, lift, place, [thrust * x, thrust * y, thrust * math.sqrt(1 - x * x - y * y)]


def own_state(claim, gains, e, reference, asked):
    """Quadrotor and controller in the state with these coordinates."""
    rows = claim.law.ROWS
    controller, lift, place, force = (geometric if claim.law is tube_geometric else cascade)(claim, gains, e, reference, asked)
    wanted = attitude_along(lift, reference[4])
    seen = attitude_along(force, e[rows.heading])
    body = [[sum(axis[k] * wanted[k][i] for k in range(3)) for i in range(3)] for axis in seen]
    mean = claim.mass * math.sqrt(dot(force, force)) / 4
    torque = [j * s for j, s in zip(claim.inertia, e[rows.spin:rows.spin + 3])]
    x, y, z = torque[0] / (4 * claim.arm[1]), torque[1] / (4 * claim.arm[0]), torque[2] / (4 * claim.torque_per_thrust)
    thrusts = [mean - x - y - z, mean + x + y - z, mean + x - y + z, mean - x + y + z]
    quadrotor = Quadrotor(claim, e[rows.lightness:], list(e[rows.wind:rows.wind + 3]))
    return [*place, *e[3:6], *quaternion(body), *e[rows.rates:rows.rates + 3], *thrusts], quadrotor, controller


def flown(claim, chance, e, gust, references, k, count=None, watch=None):
    """The state a period later, or so many milliseconds, and on the way: commands, places moved and cosines of tilt. `watch` is told of the controller."""
    count = count or claim.period
    first = k * claim.period
    reference = lambda n: [r[n].tolist() if r.ndim == 2 else float(r[n]) for r in references]
    every = claim.position_period if claim.law is tube_cascade else claim.period
    asked = reference((first - 1) // every * every)[2] if first else [0.0] * 3
    s, quadrotor, controller = own_state(claim, with_gains_off(claim, chance), e, reference(first), asked)
    start, wind, towards = s[:3], list(quadrotor.wind), chance.normal(size=3)
    towards *= claim.gust_most / np.linalg.norm(towards)
    any_three = lambda most: (most * chance.choice([-1, 1], 3) * chance.choice([1, 1, 0.3], 3)).tolist()
    commands, moved, upright = [], [], []
    for j in range(count):
        off = [any_three(most) for most in (claim.place_noise, claim.velocity_noise, claim.attitude_noise, claim.rate_noise)] if claim.is_noisy else None
        kept = claim.gust_kept(j)
        quadrotor.wind = [wind[i] + kept * gust[i] + (1 - kept) * towards[i] for i in range(3)]
        commands.append(command(controller, first + j, s, reference(first + j), off))
        if watch:
            watch(j, controller, s)
        s = quadrotor.stepped(s, commands[-1])
        moved.append([a - b for a, b in zip(s[:3], start)])
        upright.append(body_axes(s[6:10])[2][2])
    return controller.coordinates(s, quadrotor, reference(first + count)), commands, moved, upright
