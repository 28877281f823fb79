"""tube_period_test.py: periods of verify_tube.py hold what a quadrotor does by its own equations, from anywhere within their bounds.

Random states off the nominal flight are flown for one period with a quaternion (tube_flight.py), in random gusts. What they come to, what the motors
are told on the way, how far they move and how they tilt must be within the Taylor models of that period (tube_period.py). Nearly all of
each remainder may be used up, so some must come near.
"""

import math
import types

import numpy as np

from tube_flight import (FILTERED, GRAVITY, HEADING, LAG, LIFT, LIGHTNESS, RATES, SPIN, STATES, STEP, TURNED, VELOCITY, WIND, Controller, Quadrotor,
                         Track, attitude_along, body_axes, coordinates, cross, dot, fly)
from tube_period import Period

PERIODS = 60
CLAIM = types.SimpleNamespace(
    mass=2.0, inertia=[0.021, 0.023, 0.04], arm=[0.17, 0.18], torque_per_thrust=0.016, motor_time_constant=0.0125, drag=[0.24, 0.2, 0.3], drag_rate=0.12,
    position=[5.0, 5.5, 6.0], velocity=[4.0, 4.2, 4.5], attitude=[150.0, 140.0, 30.0], rates=[25.0, 24.0, 10.0], lead=[0.3, 0.3, 0.2], period=4, before=20,
    drag_error=0.1, motor_lag_error=0.05, inertia_error=0.05, gust_most=0.4, gust_lag=0.7, gust_kept=lambda ms: math.exp(-ms * STEP / 0.7))
SIZES = np.array([0.3] * 3 + [0.1] * 3 + [0.1] * 3 + [0.02] + [0.2, 0.2, 0.05] + [2, 2, 0.2] + [2, 2, 0.2] + [0.003] * 3 + [0.05] * 3 + [0.1] * 3 + [0.01]
                 + [0.1] + [0.05] + [0.05] * 3)


def quaternion(axes):
    """Of a rotation that is far from half a turn; `axes` are its columns."""
    x, y, z = axes
    w = math.sqrt(1 + x[0] + y[1] + z[2]) / 2
    return [w, (y[2] - z[1]) / (4 * w), (z[0] - x[2]) / (4 * w), (x[1] - y[0]) / (4 * w)]


def own_state(e, reference):
    """Quadrotor and controller in the state with these coordinates."""
    p, v, a, _, yaw, _ = reference
    lift, lag = list(e[LIFT:LIFT + 3]), e[LAG:LAG + 3]
    place = [p[i] - (lift[i] - a[i] - (GRAVITY if i == 2 else 0) - CLAIM.velocity[i] * (v[i] - e[VELOCITY + i])) / CLAIM.position[i] for i in range(3)]
    wanted = attitude_along(lift, yaw)
    force = [-lag[0], -lag[1], math.sqrt(dot(lift, lift)) - lag[2]]
    seen = attitude_along(force, e[HEADING])
    body = [[sum(axis[k] * wanted[k][i] for k in range(3)) for i in range(3)] for axis in seen]
    mean = CLAIM.mass * math.sqrt(dot(force, force)) / 4
    torque = [j * s for j, s in zip(CLAIM.inertia, e[SPIN:SPIN + 3])]
    x, y, z = torque[0] / (4 * CLAIM.arm[1]), torque[1] / (4 * CLAIM.arm[0]), torque[2] / (4 * CLAIM.torque_per_thrust)
    thrusts = [mean - x - y - z, mean + x + y - z, mean + x - y + z, mean - x + y + z]
    quadrotor, controller = Quadrotor(CLAIM, e[LIGHTNESS:], list(e[WIND:WIND + 3])), Controller(CLAIM)
    controller.filtered = list(e[FILTERED:FILTERED + 3])
    controller.last_rates = [e[RATES + i] - e[TURNED + i] for i in range(3)]
    return [*place, *e[VELOCITY:VELOCITY + 3], *quaternion(body), *e[RATES:RATES + 3], *thrusts], quadrotor, controller


def flown(chance, e, gust, references, k):
    """The state a period later, and on the way: commands, places moved and cosines of tilt."""
    reference = lambda j: [r[4 * j].tolist() if r.ndim == 2 else float(r[4 * j]) for r in references]
    s, quadrotor, controller = own_state(e, reference(k))
    controller.look(s, reference(k))
    start, wind, towards = s[:3], list(quadrotor.wind), chance.normal(size=3)
    towards *= CLAIM.gust_most / np.linalg.norm(towards)
    commands, moved, upright = [], [], []
    for j in range(CLAIM.period):
        kept = CLAIM.gust_kept(j)
        quadrotor.wind = [wind[i] + kept * gust[i] + (1 - kept) * towards[i] for i in range(3)]
        commands.append(controller.command(s))
        s = quadrotor.stepped(s, commands[-1])
        moved.append([a - b for a, b in zip(s[:3], start)])
        upright.append(body_axes(s[6:10])[2][2])
    quadrotor.wind = wind
    controller.look(s, reference(k + 1))
    return coordinates(s, controller, quadrotor), commands, moved, upright


def main():
    chance = np.random.default_rng(3)
    along = lambda a, b, shape=(0, 0, 0, 0.25, 0.75, 1, 1, 1): [a + u * (b - a) for u in shape]
    track = Track([(1.2, list(zip(along(0, 0.9), along(0, -0.6), along(5, 5.4))), along(0.3, 0.8))])
    states, _ = fly(CLAIM, track, [1.0, -0.5, 0.2], [1.01, 1.0, 1.002, 1.001, 1.0, 0.999], PERIODS)
    references = track.at(-CLAIM.before, PERIODS * CLAIM.period - CLAIM.before)
    scales = np.tile(SIZES, (PERIODS, 1))
    period = Period(CLAIM, states, scales, [r[::CLAIM.period] for r in references])
    used = np.zeros(25)

    def within(model, value, k, symbols, what):
        off = abs(value - model.c[k] - model.l[:STATES, k] @ symbols)
        room = np.abs(model.l[STATES:, k]).sum() + model.r[k]
        assert off <= room + 1e-9, (what, k, off, room)
        return off / (room + 1e-9)

    for _ in range(8):
        for k in range(PERIODS):
            symbols = chance.choice([-1, 1], STATES) * chance.choice([1, 1, 0.5, 0], STATES)
            e = states[k] + symbols * SIZES
            # In place of the gust stands the acceleration that lift and drag give.
            gust = [symbols[22 + i] * SIZES[22 + i] / CLAIM.drag_rate - (e - states[k])[LIFT + i] / CLAIM.drag_rate
                    + (e - states[k])[VELOCITY + i] - (e - states[k])[WIND + i] for i in range(3)]
            after, commands, moved, upright = flown(chance, e, gust, references, k)
            for i in range(22):
                used[i] = max(used[i], within(period.after[i], after[i], k, symbols, f"row {i}"))
            for j in range(CLAIM.period):
                for m in range(4):
                    within(period.commands[j][m], commands[j][m], k, symbols, f"motor {m + 1}")
                for i in range(3):
                    within(period.moved[j][i], moved[j][i], k, symbols, f"moved {i}")
                within(period.upright[j], upright[j], k, symbols, "tilt")
    assert used[:22].max() > 0.3, used
    print(f"{8 * PERIODS} periods from anywhere within their bounds: at most {used.max():.2f} of a remainder was used; by row", np.round(used[:22], 2))


main()
