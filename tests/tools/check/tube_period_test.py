"""tube_period_test.py: periods of verify_tube.py hold what a quadrotor does by its own equations, from anywhere within their bounds.

Random states off the nominal flight are flown for one period with a quaternion (tube_flight.py), in random gusts, with exact readings and gains, and
with noise and gains by chance. What they come to, what the motors are told on the way, how far they move and how they tilt must be within the Taylor
models of that period (tube_geometric.py, tube_cascade.py). Nearly all of each remainder may be used up, so some must come near.
"""

import math
import types

import numpy as np

import tube_cascade
import tube_geometric
from tube_flight import STEP, Track, fly
from tube_flown import flown
from tube_period import groups

PERIODS = 60
PLANT = dict(
    mass=2.0, inertia=[0.021, 0.023, 0.04], arm=[0.17, 0.18], torque_per_thrust=0.016, motor_time_constant=0.0125, drag=[0.24, 0.2, 0.3], drag_rate=0.12,
    motor_least=0.0, motor_most=9.0, period=4, before=20, drag_error=0.1, motor_lag_error=0.05, inertia_error=0.05, gust_most=0.4, gust_lag=0.7,
    gust_kept=lambda ms: math.exp(-ms * STEP / 0.7))
Pid = lambda p, i, d: types.SimpleNamespace(p=p, i=i, d=d)
CLAIMS = {
    "geometric": types.SimpleNamespace(
        law=tube_geometric, position=[5.0, 5.5, 6.0], velocity=[4.0, 4.2, 4.5], attitude=[150.0, 140.0, 30.0], rates=[25.0, 24.0, 10.0],
        lead=[0.3, 0.3, 0.2], **PLANT),
    "cascade": types.SimpleNamespace(
        law=tube_cascade, position=[1.0, 1.1, 1.5], velocity=Pid([3.0, 3.2, 4.0], [0.5, 0.6, 1.0], [0.2, 0.25, 0.1]), attitude=[6.5, 6.0, 2.8],
        rates=Pid([25.0, 24.0, 10.0], [20.0, 21.0, 5.0], [0.3, 0.35, 0.1]), position_period=10, tilt_max=0.6, body_rate_max=[4.0, 4.0, 3.0],
        forward=types.SimpleNamespace(velocity=0.9, acceleration=0.8, body_rates=0.7), clips=types.SimpleNamespace(position=9.0, velocity=15.0, rates=80.0),
        **PLANT)}
def noise(share):
    return dict(is_noisy=share > 0, place_noise=0.02 * share, velocity_noise=0.05 * share, attitude_noise=0.02 * share, rate_noise=0.1 * share)


LATER = [0.05] * 3 + [0.1] * 3 + [0.01] + [0.1] + [0.05] + [0.05] * 3  # gust, wind, and how the true vehicle differs
SIZES = {
    "geometric": [0.3] * 3 + [0.1] * 3 + [0.1] * 3 + [0.02] + [0.2, 0.2, 0.05] + [2, 2, 0.2] + [2, 2, 0.2] + [0.003] * 3 + LATER,
    "cascade": [0.3] * 3 + [0.1] * 3 + [0.02] * 2 + [0.1] + [0.02] + [0.2, 0.2, 0.05] + [2, 2, 0.2] + [2, 2, 0.2] + [1, 1, 0.1] + [0.1] * 3
    + [0.2] * 3 + [0.2] * 3 + LATER}


def within(model, value, k, symbols, what):
    """How much of what is not linear is used."""
    states = len(symbols)
    off = abs(value - model.c[k] - model.l[:states, k] @ symbols)
    room = np.abs(model.l[states:, k]).sum() + model.r[k]
    assert off <= room + 1e-9, (what, k, off, room)
    return off / (room + 1e-9)


def look_at(name, readings, position_period=10, gain_error=0.0):
    claim = types.SimpleNamespace(**{**vars(CLAIMS[name]), **readings, "position_period": position_period, "gain_error": gain_error})
    sizes, chance = np.array(SIZES[name]), np.random.default_rng(3)
    rows = claim.law.ROWS
    along = lambda a, b, shape=(0, 0, 0, 0.25, 0.75, 1, 1, 1): [a + u * (b - a) for u in shape]
    track = Track([(1.2, list(zip(along(0, 0.9), along(0, -0.6), along(5, 5.4))), along(0.3, 0.8))])
    states, _ = fly(claim, track, [1.0, -0.5, 0.2], [1.01, 1.0, 1.002, 1.001, 1.0, 0.999], PERIODS)
    references = track.at(-claim.before, PERIODS * claim.period - claim.before)
    scales, used = np.tile(sizes, (PERIODS, 1)), np.zeros(rows.gust)
    for periods in groups(claim, np.arange(PERIODS)):
        period = claim.law.Period(claim, states[periods], scales[periods], references, periods * claim.period)
        models, _ = period.limits()
        assert all(m.c.shape == (len(periods),) for m in models)
        for n in np.tile(np.arange(len(periods)), 8):
            if claim.is_noisy and periods[n] == 0:
                continue  # the controller here has run before, and knows how to take a derivative
            symbols = chance.choice([-1, 1], rows.states) * chance.choice([1, 1, 0.5, 0], rows.states)
            e = states[periods[n]] + symbols * sizes
            off = e - states[periods[n]]
            # In place of the gust stands the acceleration that lift and drag give.
            gust = [(symbols[rows.gust + i] * sizes[rows.gust + i] - off[rows.lift + i]) / claim.drag_rate
                    + off[rows.velocity + i] - off[rows.wind + i] for i in range(3)]
            after, commands, moved, upright = flown(claim, chance, e, gust, references, periods[n])
            for i in range(rows.gust):
                used[i] = max(used[i], within(period.after[i], after[i], n, symbols, f"row {i}"))
            for j in range(claim.period):
                for m in range(4):
                    within(period.commands[j][m], commands[j][m], n, symbols, f"motor {m + 1}")
                for i in range(3):
                    within(period.moved[j][i], moved[j][i], n, symbols, f"moved {i}")
                within(period.upright[j], upright[j], n, symbols, "tilt")
            off = np.abs(np.array([period.after[i].c[n] for i in range(rows.gust)]) - states[periods[n] + 1, :rows.gust]) if periods[n] < PERIODS else 0
            assert np.all(off <= 1e-7), (periods[n], off)
    assert used.max() > 0.3, used
    told = ("noise" if claim.is_noisy else "exact readings") + f", gains {100 * gain_error} % off"
    print(f"{name}, {told}, {position_period} ms: {8 * PERIODS} periods from anywhere within their bounds: at most {used.max():.2f} of a remainder was used; by row", np.round(used, 2))


for name in CLAIMS:
    look_at(name, noise(0))
    look_at(name, noise(0), gain_error=0.03)
    look_at(name, noise(0.1), gain_error=0.1)
look_at("geometric", noise(0.2))
look_at("cascade", noise(0.3))
look_at("cascade", noise(0.1), 3)  # some periods have two runs of the position loop
