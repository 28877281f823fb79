"""tube_deviations_test.py: bounds of tube_deviations.py are never below the worst that disturbances can do, and near it.

The worst for a linear form at an instant is known exactly: the form is carried back through the maps, and every disturbance of a period does its worst
for what it has become. Over 10 s all that is added up, joined and boxed comes to bear.
"""

import math
import types

import numpy as np

import tube_cascade
import tube_geometric
from tube_claim import Cell
from tube_deviations import Around, Deviations, block_of, rows_of
from tube_models import Model

BLOCK = 25
PERIODS = 100 * BLOCK
SLOW = [0, 1, 2, 3, 4, 5, 9]  # of the rates of maps_of()
KNOWN = dict(wind=[1.0, 0.0, 0.0], wind_spread=0.2, mass_error=0.01, drag_error=0.05, motor_lag_error=0.02, inertia_error=0.03, period=4, gust_most=0.5,
             drag_rate=0.12, position=[4.0, 5.0, 6.0], is_noisy=False, gain_error=0.0,
             gust_kept=lambda ms: math.exp(-ms * 1e-3))
CLAIMS = [types.SimpleNamespace(law=tube_geometric, velocity=[3.0, 4.0, 5.0], **KNOWN),
          types.SimpleNamespace(law=tube_cascade, position_period=10, velocity=types.SimpleNamespace(p=[3.0, 4.0, 5.0], i=[1.0, 1.0, 1.0], d=[0.1, 0.1, 0.1]),
                                **KNOWN)]


def maps_of(claim, chance):
    """Of a loop that dies away, turns, and changes as time goes on."""
    rows = claim.law.ROWS
    size, states = rows.gust, rows.states
    turn, other = chance.normal(size=(size, size)) * 2, np.random.default_rng(6)
    rates = np.diag(-np.geomspace(1.5, 120, size))
    out = np.zeros((PERIODS, states, states))
    for k in range(PERIODS):
        moves = 0.004 * (rates + (turn - turn.T) * math.sin(k / 200))
        out[k, :size, :size] = np.eye(size) + moves + moves @ moves / 2
        if k % 50 == 0:
            out[k, :size, size:] = 0.004 * np.hstack([chance.normal(size=(size, 7)), other.normal(size=(size, states - size - 7))])
        else:
            out[k, :size, size:] = out[k - 1, :size, size:]
        out[k, size:size + 3, size:size + 3] = np.eye(3) * claim.gust_kept(4)
        out[k, size + 3:, size + 3:] = np.eye(states - size - 3)
    return out


def worst(forms, period, maps, named, box, begun):
    """Of each form at the start of the period."""
    total, width = np.zeros(len(forms)), box.shape[1]
    for k in range(period - 1, -1, -1):
        some = forms[:, :width]
        total += np.linalg.norm(some @ begun["gust"], axis=1) + np.abs(some @ named[k]).sum(1) + np.abs(some) @ box[k]
        forms = forms @ maps[k]
    held = begun["held"]
    balls = np.linalg.norm((forms @ held.balls).reshape(len(forms), -1, 3), axis=2).sum(1)
    return total + np.abs(forms @ held.intervals).sum(1) + balls + np.abs(forms[:, :width] @ begun["tail"].intervals).sum(1)


def start_of(claim, chance):
    """Of some rows of the state, how they depend on place, velocity and lightness, and what is not known."""
    rows, out = claim.law.ROWS, []
    for _ in range(rows.lag if claim.law is tube_geometric else rows.tilt):
        slopes = np.zeros((rows.states, 1))
        for row in (*range(rows.lift, rows.lift + 3), *range(rows.velocity, rows.velocity + 3), rows.lightness):
            slopes[row] = 1e-3 * chance.normal()
        out.append(Model(1e-6 * chance.normal(size=1), slopes, np.full(1, 1e-5)))
    return out


def look_at(claim):
    chance = np.random.default_rng(5)
    maps, changing = maps_of(claim, chance), claim.law.ROWS.wind
    # What disturbs changes slowly, and by a little at random.
    slowly = lambda shape: chance.normal(size=shape) * (1 + 0.3 * np.sin(np.arange(PERIODS) / 50).reshape(-1, *[1] * len(shape)))
    a_little = lambda shape: 1 + 0.02 * chance.normal(size=(PERIODS, *shape))
    by_chance = lambda shape: chance.normal(size=(PERIODS, *shape))  # what noise does, but alike within a period
    kinds = [np.tile((by_chance if claim.is_noisy else slowly)((changing, 3)), width // 3) for width in claim.law.named(claim)]
    named = np.concatenate(kinds, axis=2) * a_little((changing, sum(claim.law.named(claim)))) * 1e-4
    box = np.abs(slowly((changing,)) * a_little((changing,))) * 1e-4
    whole = PERIODS if claim.law is tube_geometric else 40 * BLOCK
    for part, periods in (((), whole), ((3,), 10 * BLOCK)):
        deviations = Deviations(claim, Cell(claim, part), np.zeros(len(maps[0])), start_of(claim, chance))
        assert deviations.block == block_of(claim) == BLOCK
        deviations.box_along(np.eye(len(maps[0]))[SLOW])
        begun = {"gust": deviations.gust.copy(), "held": deviations.held, "tail": deviations.tail}
        forms, ratios = rows_of(claim), []
        for begin in range(0, periods, BLOCK):
            block = slice(begin, begin + BLOCK)
            deviations.begin(maps[block], named[block], box[block])
            bounds, reach = deviations.bounds()
            if begin // BLOCK in (0, 1, 9, 25, 60, 99):
                for j in (0, 7):
                    exact = worst(forms, begin + j, maps, named, box, begun)
                    assert np.all(bounds[j] >= exact), (begin + j, bounds[j] / exact)
                    at = deviations.bounds_at(np.full(len(forms), j), forms)
                    assert np.all(at >= exact) and np.allclose(at, bounds[j], rtol=1e-9), at / bounds[j]
                    # Along any direction the place is at most so far off.
                    directions = chance.normal(size=(8, 3))
                    along = directions / np.linalg.norm(directions, axis=1)[:, None] @ forms[changing:]
                    assert np.all(reach[j] >= worst(along, begin + j, maps, named, box, begun))
                    ratios.append((bounds[j] / np.maximum(exact, 1e-9)).max())
            deviations.end(bounds[-1, :changing])
        assert max(ratios) < 1.1, ratios
        print(f"{claim.law.__name__}{', noise' if claim.is_noisy else ''}, cell {part}: bounds are at most {max(ratios):.3f} times the worst there is")


def few_columns_hold_many():
    """A few columns reach at least as far, in every direction, as the many columns that they replace. The fast rows follow the slow ones exactly, nearly, or not at all."""
    chance = np.random.default_rng(9)
    slow, fast, many = 5, 15, 80
    forms = np.eye(slow, slow + fast)
    for follow, noise in ((1, 0), (1, 0.01), (1, 1), (0, 1)):
        leading = chance.normal(size=(slow, many))
        columns = np.vstack([leading if follow else 0 * leading, follow * chance.normal(size=(fast, slow)) @ leading + noise * chance.normal(size=(fast, many))])
        more = np.abs(chance.normal(size=slow + fast)) * 1e-3
        around = Around(forms)
        around.look_ahead(np.diag(chance.uniform(0, 1, slow + fast)), np.ones(slow + fast), np.full(slow + fast, 100.0))
        few = around.columns(columns, more)
        assert few.shape[1] < many
        directions = np.vstack([np.eye(slow + fast), chance.normal(size=(300, slow + fast))])
        assert np.all(np.abs(directions @ few).sum(1) >= np.abs(directions @ columns).sum(1) + np.abs(directions) @ more), (follow, noise)


few_columns_hold_many()
for one in CLAIMS:
    look_at(one)
    look_at(types.SimpleNamespace(**{**vars(one), "is_noisy": True}))
