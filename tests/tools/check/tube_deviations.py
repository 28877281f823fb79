"""What disturbances so far may have done to a flight, as sums that linear maps carry on from period to period.

verify_tube.py compares them with what a certificate claims.
"""

import math

import numpy as np

from tube_flight import STEP
from tube_models import ROUNDING

SLACK = 1e-9  # by so much the simulator may differ from the equations in each coordinate and period,
SPIN_SLACK = 1e-7  # but in angular accelerations by so much, which are larger numbers
BLOCK = 0.1  # s, about: the length of a block, whose disturbances are joined at one time
JOINED = 5  # periods whose gusts are added up
AGED = 10  # blocks, then what they did is joined
OLD = 4  # of those, then it becomes a box
PIECE = 3000  # columns whose images fit a cache
KEPT = 100  # columns of those that grow old,
NOISE_KEPT = 400  # and of a block, with noise
RIDGES = (1e-4, 1e-3, 1e-2, 1e-1)  # shares of the squares that keep ties small
AHEAD = (1, 2, 4, 8, 16)  # so many blocks later columns around others are compared
UP = 1 + 1e-12  # above the rounding of sums of thousands of terms of one sign


def slacks(law):
    """Of each row that changes."""
    out = np.full(law.ROWS.wind, SLACK)
    out[law.SPINS] = SPIN_SLACK
    return out


def rows_of(claim):
    """Linear forms whose bounds are asked for: the rows of the certificate, and the place."""
    rows = claim.law.ROWS
    forms = np.vstack([np.eye(rows.wind, rows.states), claim.law.place_forms(claim)])
    drag = claim.drag_rate
    for i in range(3):
        if drag:
            forms[rows.gust + i, [rows.lift + i, rows.velocity + i, rows.gust + i, rows.wind + i]] = 1, -drag, drag, drag
    return forms


def block_of(claim):
    """The number of periods in a block. A block has whole rounds of the loops, so each block is like the next."""
    unit = math.lcm(JOINED, claim.law.order(claim))
    return max(1, round(BLOCK / (claim.period * STEP) / unit)) * unit


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


def in_pieces(bound, columns):
    """The sum of what a bound gives for some columns at a time."""
    return sum(bound(columns[:, k:k + PIECE]) for k in range(0, max(columns.shape[1], 1), PIECE))


class Terms:
    """Deviations as a sum: columns times numbers in [-1, 1], and threes of columns times vectors of length at most 1. Columns may leave out the last
    rows of the state, which are then 0."""

    def __init__(self, intervals, balls):
        self.intervals, self.balls = intervals, balls

    @staticmethod
    def all(terms):
        return Terms(np.hstack([t.intervals for t in terms]), np.hstack([t.balls for t in terms]))

    def moved(self, matrix):
        rows = len(self.intervals)
        return Terms(matrix[:rows, :rows] @ self.intervals, matrix[:rows, :rows] @ self.balls)

    def sizes(self):
        """Of each row, at most: the sum of all columns."""
        return np.abs(self.intervals).sum(1) + np.abs(self.balls).sum(1)

    def bounds(self, forms):
        """Of linear forms (..., states)."""
        shape, forms = forms.shape[:-1], np.ascontiguousarray(forms.reshape(-1, forms.shape[-1])[:, :len(self.intervals)])
        rounding = ROUNDING * (np.abs(forms) @ self.sizes())
        out = in_pieces(lambda columns: np.abs(forms @ columns).sum(-1), self.intervals) + in_pieces(lambda columns: ball_norms(forms @ columns), self.balls)
        return (out * UP + rounding).reshape(shape)

    def reach(self, forms):
        """Of forms (..., 3, states): what intervals do along each axis, and how far balls reach."""
        forms = forms[..., :len(self.intervals)]
        rounding = ROUNDING * (np.abs(forms) @ self.sizes())
        along = in_pieces(lambda columns: np.abs(forms @ columns).sum(-1), self.intervals)
        return along * UP + rounding, in_pieces(lambda columns: ball_reach(forms @ columns), self.balls) * UP


class Deviations:
    """All that disturbances so far may have done, from block to block."""

    def __init__(self, claim, cell, state, start):
        """`start`: the state when the controller first runs, as models for one period (law.Start); `state`: the nominal one."""
        self.claim, self.law, self.rows = claim, claim.law, claim.law.ROWS
        self.block = block_of(claim)  # periods
        self.whole = math.ceil(self.law.WHOLE / (self.block * claim.period * STEP))  # blocks
        rows = self.rows
        self.states, self.changing = rows.states, rows.wind
        _, radius, _, halves = cell.nominal()
        held = np.zeros((self.states, 3))
        held[rows.wind:rows.wind + 3] = np.diag(radius)
        vehicle = np.zeros((self.states, self.states - rows.lightness))  # masses first
        vehicle[rows.lightness:] = np.diag(halves)
        off, box = np.zeros((self.states, 6)), slacks(self.law)  # off: balls of the place and of the velocity
        for i, model in enumerate(start):
            vehicle[i] = model.l[rows.lightness:self.states, 0]
            off[i, :3], off[i, 3:] = (model.l[row:row + 3, 0] for row in (rows.lift, rows.velocity))
            box[i] += (abs(model.c[0] - state[i]) + model.r[0] + ROUNDING * model.size()[0]) * UP
        self.held = Terms(vehicle, np.hstack([held, off])) if cell.is_ball else Terms(np.hstack([held, vehicle]), off)
        self.none = np.zeros((self.changing, 0))
        self.tail = Terms(np.diag(box), self.none)
        self.recent, self.aged, self.old = [], [], []
        self.gust = np.zeros((self.changing, 3))
        self.gust[rows.gust:rows.gust + 3] = np.eye(3) * (1 - claim.gust_kept(claim.period)) * claim.gust_most * UP
        self.forms = rows_of(claim)
        self.around = Around(np.zeros((0, self.changing)))

    def box_along(self, forms):
        """What is slow, which what is fast soon follows: linear forms that boxes are taken along from now on."""
        self.around = Around(forms[:, :self.changing])

    def parts(self):
        return self.held, self.now

    def begin(self, maps, named, box):
        """A block of periods: their maps (n, states, states), columns of named errors, and boxes."""
        self.now = Terms.all([self.tail, *self.old, *self.aged, *self.recent])
        sizes = self.sizes = sum(part.bounds(np.eye(self.states)) for part in self.parts())
        self.products, self.lost = [np.eye(self.states)], [np.zeros(self.states)]  # lost: by the rounding of the products
        for m in maps:
            self.lost.append(np.abs(m) @ (self.lost[-1] + ROUNDING * (np.abs(self.products[-1]) @ sizes)))
            self.products.append(m @ self.products[-1])
        self.own = [Terms(self.none, self.none)]  # of this block, at the start of each period and at the end
        for j, m in enumerate(maps):
            now, size = self.own[-1], self.changing
            fresh = np.hstack([named[j], np.diag(box[j] + ROUNDING * (np.abs(m[:size, :size]) @ now.sizes()))])
            moved = now.moved(m)
            self.own.append(Terms(np.hstack([moved.intervals, fresh]), np.hstack([moved.balls, self.gust])))

    def bounds(self):
        """At the start of each period: of the forms of rows_of(), and of the length of what the last three give."""
        count = len(self.products) - 1
        products = np.array(self.products[:-1])
        forms = self.forms @ products
        bounds = np.array(self.lost[:-1]) @ np.abs(self.forms).T * UP
        bounds = bounds + ROUNDING * ((np.abs(self.forms) @ np.abs(products)) @ self.sizes)
        across, reach = bounds[:, self.changing:], np.zeros(count)
        for part in self.parts():
            bounds = bounds + part.bounds(forms)
            along, balls = part.reach(forms[:, self.changing:])
            across, reach = across + along, reach + balls
        own_bounds, own_across, own_reach = self.own_bounds()
        self.reached = (bounds + own_bounds)[-1, :self.changing]
        return bounds + own_bounds, np.sqrt(((across + own_across) ** 2).sum(-1)) * UP + reach + own_reach

    def own_bounds(self):
        """Of what this block has added, at the start of each period: of the forms, of the place along each axis, and its reach."""
        bounds, across, reach = np.zeros((len(self.own) - 1, len(self.forms))), np.zeros((len(self.own) - 1, 3)), np.zeros(len(self.own) - 1)
        if len(self.own) > 2:
            some = self.own[1:-1]  # nothing has been added at the start of the block
            whole, forms = Terms.all(some), self.forms[:, :self.changing]
            at, ball_at = (np.cumsum([0, *widths[:-1]]) for widths in zip(*((t.intervals.shape[1], t.balls.shape[1] // 3) for t in some)))
            sums = np.add.reduceat(np.abs(forms @ whole.intervals), at, axis=1).T * UP
            balls = forms @ whole.balls
            rounding = ROUNDING * (np.array([t.sizes() for t in some]) @ np.abs(forms).T)
            bounds[1:] = sums + np.add.reduceat(lengths(balls), ball_at, axis=1).T * UP + rounding
            across[1:] = sums[:, self.changing:] + rounding[:, self.changing:]
            reach[1:] = np.add.reduceat(stretches(balls[self.changing:]), ball_at) * UP
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

    def end(self, claimed):
        """To the start of the next block, where rows are claimed to deviate by at most so much."""
        through = self.products[-1]
        sizes = self.held.sizes()
        sizes[:self.changing] += self.now.sizes()
        lost = self.lost[-1] + ROUNDING * (np.abs(through) @ sizes)
        self.held, self.tail = (part.moved(through) for part in (self.held, self.tail))
        self.old, self.aged, self.recent = ([part.moved(through) for part in parts] for parts in (self.old, self.aged, self.recent))
        self.own[-1].intervals[:, -self.changing:] += np.diag(lost[:self.changing])
        self.recent.append(self.own[-1])
        if len(self.recent) > self.whole:
            self.around.look_ahead(through[:self.changing, :self.changing], self.reached, claimed)
            self.age(self.recent.pop(0))

    def age(self, old):
        """Adds up errors of a kind over the periods of a block. Few columns hold how they differ from their mean. What noise does differs from period
        to period: with noise, errors are added up in each period by itself, and the largest sums stay."""
        balls, rest = added_up(old.balls, JOINED)
        noisy, more = self.claim.is_noisy, ROUNDING * old.sizes()
        *groups, boxes = np.split(old.intervals.reshape(self.changing, self.block, -1), np.cumsum(self.law.named(self.claim)), axis=2)
        apart = (self.changing, self.block if noisy else 1, -1)
        kinds = [*(group.reshape(*apart, 3) for group in groups), boxes.reshape(*apart, self.changing)]
        means = [kind.mean(2, keepdims=True) for kind in kinds]
        rest = [rest, *((kind - middle).reshape(self.changing, -1) for kind, middle in zip(kinds, means))]
        sums = [(middle * kind.shape[2]).reshape(self.changing, -1) for kind, middle in zip(kinds, means)]
        if noisy:
            columns = self.around.fewer(np.hstack([*sums, *rest]), more, NOISE_KEPT)
        else:
            columns = np.hstack([*sums, self.around.columns(np.hstack(rest), more)])
        self.aged.append(Terms(columns, balls))
        if len(self.aged) == 2 * AGED:
            terms = Terms.all(self.aged[:AGED])
            self.old.append(Terms(self.around.fewer(terms.intervals, ROUNDING * terms.sizes()), terms.balls))
            del self.aged[:AGED]
        if len(self.old) == 2 * OLD:
            oldest = Terms.all([self.tail, *self.old[:OLD]])
            columns = np.hstack([oldest.intervals, oldest.balls])
            self.tail = Terms(self.around.fewer(columns, np.zeros(self.changing)), self.none)
            del self.old[:OLD]


def added_up(balls, count):
    """One ball in place of so many neighbouring ones, their sum, and a box for how they differ from their mean."""
    states = len(balls)
    balls = balls.reshape(states, -1, count, 3)
    mean = balls.mean(2, keepdims=True)
    return (mean * count).reshape(states, -1), np.diag(ball_norms((balls - mean).reshape(states, -1)))


class Around:
    """Few columns around many: of what is slow, linear forms, a box to which all is tied, and a box for what that leaves. Any tie is right. The best ties
    by least squares may be large numbers that nearly cancel, and make a wide box; a ridge makes them smaller. Of some ridges the one is taken that leaves
    the bounds furthest below the claims, if some blocks more like the last one follow."""

    def __init__(self, forms):
        self.forms = forms

    def look_ahead(self, through, reached, claimed):
        """Of the last block its map; of each row what it may have reached, and what is claimed."""
        powers = [through]
        for _ in AHEAD[1:]:
            powers.append(powers[-1] @ powers[-1])
        claimed = np.maximum(np.tile(claimed, len(powers) + 1), 1e-300)
        self.reached = np.tile(reached, len(powers) + 1) / claimed
        self.ahead = np.vstack([np.eye(len(through)), *powers]) / claimed[:, None]

    def columns(self, columns, more):
        box = np.abs(columns).sum(1)
        scaled = self.forms @ columns
        scaled = scaled / np.maximum(np.abs(scaled).sum(1), 1e-300)[:, None]
        gram, sizes, before = scaled @ scaled.T, np.abs(scaled).sum(1), np.abs(self.ahead @ columns).sum(1)
        found = []
        for ridge in RIDGES:
            ties = np.linalg.solve(gram + np.eye(len(scaled)) * (ridge * np.trace(gram) + 1e-300), scaled @ columns.T).T
            rest = np.abs(columns - ties @ scaled).sum(1) + ROUNDING * (box + np.abs(ties) @ sizes) + more
            around = np.hstack([ties, np.diag(rest)]) * UP
            found.append((np.max(self.reached + np.abs(self.ahead @ around).sum(1) - before), len(found), around))
        return min(found)[2]

    def fewer(self, columns, more, kept=KEPT):
        """The columns that do most to what is slow, and few around the others."""
        slow = np.abs(self.forms @ columns)
        order = np.argsort((slow / np.maximum(slow.sum(1), 1e-300)[:, None]).sum(0))
        return np.hstack([columns[:, order[-kept:]], self.columns(columns[:, order[:-kept]], more)])
