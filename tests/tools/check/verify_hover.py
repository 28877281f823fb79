"""verify_hover.py RECORDS CERTIFICATES: proves the tubes of hovering vehicles in exact numbers, for flights of any length.

RECORDS are trajectories that rest and CERTIFICATES what `skyway-fly --proved-tube --certificate` wrote of them (JSON Lines). About its equilibrium a
hovering vehicle does the same in every period, so deviations are sums of powers of one matrix. The script works out this matrix with a bound of what is not
linear, adds up what winds, gusts and masses can do until a power has nearly died away, and bounds what is left by that power. All numbers are whole.
Exit 0 when there is a record, and every one has a certificate whose largest radius and tilt hold for ever; 1 when one is refused, with the reason; 2 for wrong
usage; 3 when a file cannot be read as what it should be. docs/certificates.md says what is checked, and what is trusted.
"""

import bisect
import functools
import math
import multiprocessing
import os
from fractions import Fraction as F
from math import isqrt
from operator import add, mul, sub

from hover_models import BITS, FAULT, ONE, SidewaysError, cos_of, fixed
from hover_period import GRAVITY, HELD, Cascade, Geometric
from tube_claim import Claim, cells_of, segments_of, verify_files
from verify_certificate import Refused, require, run_main


def fixed_up(x):
    return fixed(F(x)) + 1


LAWS = {"geometric": Geometric, "cascade": Cascade}
SLACK, SPIN_SLACK = F(1, 10**9), F(1, 10**7)  # in each coordinate and run of the attitude loop, and in angular accelerations (docs/tube.md)
DIED = 200  # what has died away makes at most this part of each sum
ACTED = 100  # periods, in which all disturbances have begun to act
LOOK = 50  # periods, after which the script looks again whether what is held has settled
LONGEST = 6000  # periods, until which all must have
LONGEST_PERIOD = 100  # ms
LARGEST = ONE << 20  # of sums
ROUNDS = 30  # of larger bounds, then there are none
SOME = 8  # limits that are summed up together: the first of them that does not hold refuses
LAPS = 400  # until a bound of all that is old is found
HALVINGS = 13  # at most so often the time doubles, in which only what is slow is left
ONLY_SLOW = 50  # then the place keeps at most this part


def group_begins(k):
    """Remainders are bounded for some periods at one time: few at first, when much changes from period to period."""
    return k < 30 or k < 100 and k % 5 == 0 or k % 20 == 0


# ---- Whole numbers.

def size(v):
    return isqrt(sum(x * x for x in v)) + 1


def threes(values):
    return [values[i:i + 3] for i in range(0, len(values), 3)]


def product(rows, columns):
    """The matrix of rows and columns, rounded down."""
    return [[sum(map(mul, row, column)) >> BITS for column in columns] for row in rows]


def swing(slopes, bounds):
    """What symbols within these bounds do at most."""
    return (sum(map(mul, map(abs, slopes), bounds)) >> BITS) + 1


def swings(rows, bounds):
    return [swing(row, bounds) for row in rows]


def largest(rows):
    return [max(column) for column in zip(*rows)]


def reach(rows):
    """How far the image of a ball reaches, of the rows of a matrix k: Gershgorin's bound of k^T k."""
    columns = list(zip(*rows))
    return isqrt(max(sum(abs(sum(map(mul, a, b))) for b in columns) for a in columns)) + 1


def reaches(rows):
    """The sum of what balls reach, whose columns stand side by side."""
    return sum(reach([row[k:k + 3] for row in rows]) for k in range(0, len(rows[0]), 3))


# ---- What is held.

class Held:
    """What the symbols that are held, those of the start and the middle have done to the coordinates at the begin of each period, and linearly: a column of
    each. They act in all periods, so what they do settles. The last column is that of the middle."""

    def __init__(self, hover):
        loop, count = hover.loop, hover.count
        slopes = [[*m.l, *[0] * (count + HELD - len(m.l))] for m in hover.start]
        begun, added = list(zip(*slopes)), hover.columns[count:loop.gusts]
        self.columns, self.added, self.symbols, self.balls, self.singles = [], [], [], [], []
        none = [0] * count

        def take(bound, symbols, starts, adds, is_ball):
            if bound:
                (self.balls if is_ball else self.singles).append((len(self.columns), bound))
                self.columns += starts
                self.added += adds
                self.symbols += symbols

        winds = [(0, 3)] if hover.is_ball else [(i, i + 1) for i in range(3)]
        for first, last in (*winds, *((i, i + 1) for i in range(3, HELD))):
            take(max(hover.halves[first:last]), range(first, last), begun[count + first:count + last], added[first:last], last > first + 1)
        for k, off in enumerate(hover.off):
            take(off, [None] * 3, begun[3 * k:3 * k + 3], [none] * 3, True)
        self.columns.append([m.c - c for m, c in zip(hover.start, loop.middle)])
        self.added.append(none)
        self.settle(hover.rows)

    def settle(self, rows):
        """Carries the columns on until they hardly change. How long that takes is no claim."""
        self.at, most, steps, before = [self.columns], [0] * len(rows), [0] * len(rows), None
        while True:
            last = self.at[-1]
            self.at.append([list(map(add, a, b)) for a, b in zip(product(last, rows), self.added)])
            steps = list(map(max, steps, self.most(zip(*(map(sub, a, b) for a, b in zip(self.at[-1], last))))))
            if (len(self.at) - 1) % LOOK:
                continue
            most = list(map(max, most, self.most(zip(*last))))
            if len(self.at) > ACTED and before and all(map(self.has_settled, most, steps, before)):
                return
            require(len(self.at) < LONGEST and max(most) < LARGEST, "its loop hardly damps, or its gusts last too long")
            before, steps = steps, [0] * len(rows)

    @staticmethod
    def has_settled(most, now, then):
        """As if steps became smaller at the same rate for ever."""
        return now < ONE >> 60 or DIED * LOOK * now * then < most * (then - now)

    def most(self, rows):
        """What the symbols and the middle do at most, of each row."""
        return [abs(r[-1]) + 2 + (sum(size(r[k:k + 3]) * b for k, b in self.balls) + sum(abs(r[k]) * b for k, b in self.singles) >> BITS)
                for r in map(list, rows)]

    @property
    def until(self):
        return len(self.at) - 2

    def last_step(self):
        """What each symbol still changes in the period `until`, and the symbols' bounds."""
        bounds = {k + i: b for k, b in self.balls for i in range(3)} | dict(self.singles) | {len(self.columns) - 1: ONE}
        return [list(map(sub, a, b)) for a, b in zip(self.at[-1], self.at[-2])], [bounds[k] for k in range(len(self.columns))]


# ---- What is not.

class Sums:
    """What gusts, remainders and named errors so far do to some linear forms, from period to period. The coordinates' deviations follow
    x <- L x + G n + N e + r. Gusts n, named errors e and remainders r are new in each period. Powers of L are
    followed until what they leave is slow. Then bounds of known forms so many periods ago bound what is older."""

    def __init__(self, hover, rows, triples=()):
        """Of each triple of forms the reach of gusts is added up, too."""
        self.columns, self.map, self.gust_columns = hover.fresh_columns, hover.columns[:hover.count], 3 * hover.loop.span
        self.steady, self.most, self.triples = len(hover.held.columns), hover.loop.gust_most, triples
        self.powers, self.count = rows, 0
        self.gusts, self.reaches, self.settled = [[0] * len(rows)], [[0] * len(triples)], [[0] * self.steady for _ in rows]
        self.box, self.boxes = [[0] * (hover.count + len(self.columns) - self.gust_columns - self.steady) for _ in rows], {}

    def advance(self, noted):
        if noted:
            self.boxes[self.count] = self.box[:]
        new, gusts, named = product(self.powers, self.columns), self.gust_columns, -self.steady
        self.box = [list(map(add, box, map(abs, (*power, *row[gusts:named])))) for box, power, row in zip(self.box, self.powers, new)]
        self.settled = [list(map(add, a, map(abs, row[named:]))) for a, row in zip(self.settled, new)]
        self.gusts.append([a + sum(map(size, threes(row[:gusts]))) for a, row in zip(self.gusts[-1], new)])
        self.reaches.append([a + reaches([row[:gusts] for row in new[k:k + 3]]) for a, k in zip(self.reaches[-1], self.triples)])
        self.powers, self.count = product(self.powers, self.map), self.count + 1

    def end(self, slow):
        """No power is followed any further. `tails` are by the coordinates, gusts among them, and by the slow forms."""
        self.boxes[self.count] = self.box
        self.noted = sorted(self.boxes)
        self.tails = [slow.divided(row) for row in self.powers]

    def between(self, newest, oldest):
        """By remainders and named errors that are `newest` or more periods old, and less than `oldest`, or some more."""
        above, below = bisect.bisect_left(self.noted, oldest), bisect.bisect_right(self.noted, newest) - 1
        return [map(sub, a, b) for a, b in zip(self.boxes[self.noted[above]], self.boxes[self.noted[below]])]

    def gusts_of(self, age):
        """What gusts of the last periods do."""
        return [(g * self.most >> BITS) + 2 for g in self.gusts[age]]


class Slow:
    """Linear forms that the loop hardly mixes with others: what is left of old deviations depends on these. Any forms are right."""

    def __init__(self, rows=(), bounds=()):
        """They must differ. `bounds` of the coordinates say which of them count."""
        self.rows, self.pivots, left = [], [], []
        for row in rows:
            rest = [F(a * b) for a, b in zip(row, bounds)]
            for p, other in zip(self.pivots, left):
                share = rest[p] / other[p]
                rest = [a - share * b for a, b in zip(rest, other)]
            pivot = max(range(len(rest)), key=lambda i: abs(rest[i]))
            require(rest[pivot], "its loop is singular")
            self.pivots.append(pivot)
            self.rows.append(row)
            left.append(rest)
        self.inverse = inverse_of([[F(row[p]) for p in self.pivots] for row in self.rows])

    @staticmethod
    def of(hover, bounds):
        """Of each axis two forms of the place: after a long time, when all but its slowest mode have died away, and after a shorter time, from which that mode
        is taken away."""
        powers, place = [hover.rows], hover.place_forms
        for _ in range(HALVINGS):
            powers.append(product(powers[-1], list(zip(*powers[-1]))))
            late = product(place, list(zip(*powers[-1])))
            if all(ONLY_SLOW * now <= then for now, then in zip(swings(late, bounds), swings(place, bounds))):
                break
        slowest = Slow(late, bounds)
        quarter = list(zip(*powers[max(len(powers) - 3, 0)]))
        shares = [slowest.shares(row) for row in product(slowest.rows, quarter)]
        soon = product(place, quarter)
        shrunk = product(shares, list(zip(*soon)))
        rest = [list(map(sub, a, b)) for a, b in zip(product(soon, quarter), shrunk)]
        return Slow(map(scaled, (*late, *rest)), bounds)

    def shares(self, row):
        known = [row[p] for p in self.pivots]
        return [fixed(sum(map(mul, known, column))) for column in zip(*self.inverse)]

    def divided(self, row):
        """The form as slopes by coordinates and by the slow forms: in them, what the slow forms cannot say."""
        if not self.rows:
            return row
        shares = self.shares(row)
        return [*(a - (sum(map(mul, shares, column)) >> BITS) for a, column in zip(row, zip(*self.rows))), *shares]


def scaled(row):
    most = max(map(abs, row))
    require(most, "its loop is singular")
    return [(a << BITS) // most for a in row]


def inverse_of(matrix):
    """Of fractions. Its leading minors are not 0."""
    count = len(matrix)
    rows = [[*row, *(F(i == k) for k in range(count))] for i, row in enumerate(matrix)]
    for i, row in enumerate(rows):
        rows[i] = [a / row[i] for a in row]
        for k, other in enumerate(rows):
            if k != i:
                rows[k] = [a - other[i] * b for a, b in zip(other, rows[i])]
    return [row[count:] for row in rows]


# ---- A cell.

class Hover:
    """The proof for a cell. Forms stand in this order: the coordinates of the state, slow forms, the acceleration, the place."""

    def __init__(self, claim, cell, yaw):
        self.claim, self.is_ball = claim, cell.is_ball
        self.loop = loop = LAWS[claim.controller](claim, cell, yaw)
        require(loop.span <= LONGEST_PERIOD, f"its loops run in the same way again only after {loop.span} milliseconds")
        self.off = [fixed_up(v) if v else 0 for v in (claim.start_error, claim.start_speed)]
        self.start = loop.start(*self.off)
        self.count, self.halves = loop.COUNT, loop.halves
        self.after = loop.run([[0] * self.count])
        slopes = [loop.by_coordinates(m) for m in self.after]
        self.columns, self.rows = list(zip(*slopes)), [row[:self.count] for row in slopes]
        self.place_forms = [[fixed(x) for x in row] for row in loop.place_rows()]

    def accelerations(self):
        """As forms of the state and of what is held."""
        for i in range(3):
            row, held = [0] * self.count, [0] * HELD
            parts, wind = self.loop.balance(i)
            held[i] = fixed(wind)
            for k, factor in parts:
                row[k] = fixed(factor)
            yield row, held

    def bounded(self, forms):
        """Of what forms come to the coordinates that have bounds: the acceleration in place of the gust."""
        return [*forms[:self.count - 3], *forms[self.known:self.known + 3]]

    # What is linear.

    def sum_up(self):
        self.held = Held(self)
        steady, self.steady_bounds = self.held.last_step()
        self.fresh_columns = [*self.columns[self.loop.gusts:], *steady]
        slow = self.slow = Slow.of(self, [m.radius[0] + 1 for m in self.after]) if self.loop.IS_SLOW else Slow()
        self.known, none = self.count + len(slow.rows), [0] * HELD
        self.place = slice(self.known + 3, self.known + 6)
        states = [[ONE if i == k else 0 for i in range(self.count)] for k in range(self.count)]
        forms = [*((row, none) for row in (*states, *slow.rows)), *self.accelerations(), *((row, none) for row in self.place_forms)]
        self.sums = sums = Sums(self, [row for row, _ in forms], [self.place.start, *range(self.count, self.known, 3)])
        self.most_held = largest([self.held.most(self.held_at(k, forms)) for k in range(0, self.held.until, 5)])
        while not self.has_died_away():
            require(sums.count < LONGEST and max(sums.gusts[-1]) < LARGEST, "its loop hardly damps, or its gusts last too long")
            sums.advance(sums.count <= self.loop.PHASES[-1] or group_begins(sums.count))
        sums.end(slow)
        self.last = -(-max(sums.count, self.held.until) // 20) * 20  # the last group is for all periods from here on
        self.begins = [k for k in range(self.last + 1) if group_begins(k)]
        begins = [p for p in self.loop.PHASES if p <= self.last]
        self.phases = list(zip(begins, [*begins[1:], None]))
        self.take_gusts()
        self.drift = self.drifts(sums)
        self.linear = self.in_groups(sums, forms)
        self.take_places()

    def has_died_away(self):
        """Whether a power has, but for what is slow: it makes little of what gusts do, and of what remainders do. How much is no claim."""
        sums = self.sums
        if sums.count < ACTED or not group_begins(sums.count):
            return False
        linear = list(map(add, sums.gusts_of(sums.count), self.most_held))
        if sums.count == ACTED:
            self.usual = self.new_in_period([self.bounded(linear)])[0]
        rest = [self.slow.divided(row)[:self.count] for row in sums.powers]
        others = [swing(box, self.usual) for box in sums.box]
        checks = [(others, [max(a >> 4, b) for a, b in zip(linear, others)])]
        if self.claim.gust_most:
            checks.append((linear, linear))
        for bounds, sums_of in checks:
            if any(DIED * swing(row, bounds) > max(now, ONE >> 60) for row, now in zip(rest, sums_of)):
                return False
        return True

    def for_ever(self, now, least):
        """Bounds of the known forms, at least these, that hold in each period if they hold in those before: what is new there adds `now`."""
        found = list(map(max, now, least))
        for _ in range(LAPS):
            then = list(map(max, least, map(add, now, swings(self.sums.tails[:self.known], found))))
            if all(a <= b for a, b in zip(then, found)):
                return found
            found = [a + (a >> 20) + 4 for a in then]
        raise Refused("its loop hardly damps, or its gusts last too long")

    def take_gusts(self):
        """What gusts do to each form at most, in each period and for ever; of the triples of forms how far they reach."""
        sums, age, known = self.sums, self.sums.count, self.known
        new = sums.gusts_of(age)
        self.gusts = [sums.gusts_of(k) for k in range(age + 1)]
        for k in range(age + 1, self.last + 1):
            self.gusts.append(list(map(add, new, swings(sums.tails, self.gusts[k - age][:known]))))
        self.ever = self.for_ever(new[:known], [0] * known)
        self.gusts_for_ever = list(map(add, new, swings(sums.tails, self.ever)))
        at_most = lambda k: [(r * sums.most >> BITS) + 2 for r in sums.reaches[k]]
        self.balls = [at_most(k) for k in range(age + 1)]
        for k in range(age + 1, self.last + 1):
            self.balls.append(self.older_balls(at_most(age), self.balls[k - age], self.gusts[k - age]))
        floor = last = largest(self.balls)
        for _ in range(LAPS):
            then = list(map(max, floor, self.older_balls(at_most(age), last, self.ever)))
            if all(a <= b for a, b in zip(then, last)):
                break
            last = [a + (a >> 20) + 4 for a in then]
        else:
            raise Refused("its loop hardly damps, or its gusts last too long")
        self.balls_for_ever = last

    def older_balls(self, new, balls, bounds):
        """With how far the slow forms reached, and bounds of the coordinates, before what is new."""
        out = []
        for k, reached in zip(self.sums.triples, new):
            rows = [self.sums.tails[k + i] for i in range(3)]
            slow = sum(reach([row[i:i + 3] for row in rows]) * ball for i, ball in zip(range(self.count, self.known, 3), balls[1:]))
            out.append(reached + (slow >> BITS) + size(swings([row[:self.count] for row in rows], bounds)) + 2)
        return out

    def drifts(self, sums):
        """How far what is held still carries each form after Held.until."""
        now = [swing(row, self.steady_bounds) for row in sums.settled]
        if sums is self.sums:
            self.drift_for_ever = self.for_ever(now[:self.known], [0] * self.known)
        return list(map(add, now, swings(sums.tails, self.drift_for_ever)))

    def held_at(self, k, forms):
        """What each symbol that is held does to forms: a row of each."""
        direct = [[*(held[i] if i is not None else 0 for i in self.held.symbols), 0] for _, held in forms]
        columns = self.held.at[min(k, self.held.until)]
        return [list(map(add, a, b)) for a, b in zip(product([row for row, _ in forms], columns), direct)]

    def in_groups(self, sums, forms):
        """What is linear comes to, in each group at most."""
        is_own, out, age = sums is self.sums, [], sums.count
        new, drift = sums.gusts_of(age), self.drifts(sums)
        held = None
        for k in range(self.last + 1):
            if k <= self.held.until:
                held = self.held.most(self.held_at(k, forms))
            elif k == self.held.until + 1:
                held = list(map(add, held, drift))
            if is_own:
                gusts = self.gusts[k] if k < self.last else self.gusts_for_ever
            elif k <= age:
                gusts = sums.gusts_of(k)
            else:
                gusts = list(map(add, new, swings(sums.tails, self.gusts[k - age][:self.known] if k < self.last else self.ever)))
            bounds = list(map(add, held, gusts))
            if group_begins(k):
                out.append(bounds)
            else:
                out[-1] = list(map(max, out[-1], bounds))
        if self.last <= self.held.until:
            out[-1] = list(map(add, out[-1], drift))
        return out

    def take_places(self):
        """Of the place in each period a distance, of the middle and all balls, and what intervals do along each axis."""
        forms, self.places = [(row, [0] * HELD) for row in self.place_forms], []
        for k in range(self.last + 1):
            if k <= self.held.until:
                rows = self.held_at(k, forms)
                middle = size([fixed(p) + r[-1] for p, r in zip(self.loop.place(), rows)])
                balls = sum(reach([r[i:i + 3] for r in rows]) * b for i, b in self.held.balls)
                along = [(sum(abs(r[i]) * b for i, b in self.held.singles) >> BITS) + 2 for r in rows]
            if k == min(self.last, self.held.until + 1):
                along = list(map(add, along, self.drift[self.place]))
            gusts = self.balls[k] if k < self.last else self.balls_for_ever
            self.places.append((middle + (balls >> BITS) + gusts[0] + 4, along))

    # What is not.

    def remainders(self, sums, fresh, count):
        """Of each group what remainders do to the first forms; `fresh` has those of a period in each phase."""
        at_start = [m.r[0] for m in self.start] + [0] * (len(fresh[0]) - self.count)
        age, known = sums.count, []
        for begin, end in zip(self.begins, [*self.begins[1:], None]):
            terms = [*self.ages(begin, end, fresh), *([(end, begin, at_start)] if begin < age else [])]
            rows = [self.lost] * count
            for oldest, newest, box in terms:
                rows = [x + swing(one, box) for x, one in zip(rows, sums.between(newest, oldest))]
            if begin >= age:
                if sums is self.sums:
                    older = largest([known[g] for g in self.groups_between(begin - age, end and end - 1 - age) if g < len(known)])
                    if end is None:
                        older = self.for_ever(rows[:self.known], older)
                else:
                    older = largest([self.rest[g][:self.known] for g in self.groups_between(begin - age, end and end - 1 - age)])
                rows = [x + swing(tail, older) for x, tail in zip(rows, sums.tails)]
            known.append(rows[:self.known])
            yield rows

    def groups_between(self, first, last):
        """Those that have a period from the first to the last one (none: for ever)."""
        begin = bisect.bisect_right(self.begins, first) - 1
        return range(begin, len(self.begins) if last is None else bisect.bisect_right(self.begins, last))

    def ages(self, begin, end, fresh):
        """For a group: how many periods ago remainders may have been new (`newest` or more, fewer than `oldest`), and the largest there were then."""
        top = min(self.sums.count, end - 1 if end else begin)
        cuts = {begin - first for first, _ in self.phases} | {end - 1 - first for first, _ in self.phases if end}
        cuts = sorted(c for c in cuts | {0, top} if 0 <= c <= top)
        for newest, oldest in zip(cuts, cuts[1:]):
            boxes = [box for (first, last), box in zip(self.phases, fresh)
                     if (end is None or first <= end - 2 - newest) and (last is None or last > begin - oldest)]
            yield oldest, newest, largest(boxes)

    def by_phase(self, groups):
        at = [self.begins.index(first) for first, _ in self.phases]
        return [groups[a:b] for a, b in zip(at, [*at[1:], None])]

    def totals(self, linear, rest):
        """Of each phase what forms come to."""
        return [largest(rows) for rows in self.by_phase([list(map(add, a, b)) for a, b in zip(linear, rest)])]

    def round(self, bounds, forms):
        """The same for the first forms, if the coordinates are within these bounds in all periods before."""
        self.fresh = self.new_in_period(bounds)
        self.lost = 4 * (self.last + 5) * max(self.loop.of.slack)  # by rounding sums, powers and forms
        self.rest = list(self.remainders(self.sums, self.fresh, forms))
        return self.totals(self.linear, self.rest)

    def new_in_period(self, bounds):
        """Of each set of bounds the remainders and named errors of a period."""
        loop, slack = self.loop, self.slacks()
        after, out = loop.run(bounds), []
        for k in range(len(bounds)):
            rounding = 4 * loop.of.slack[k] + (3 * sum(self.off) >> BITS) + 8
            out.append([m.r[k] + abs(m.c - c) + s + rounding for m, c, s in zip(after, loop.middle, slack)] + loop.named_bounds(k))
        return out

    def slacks(self):
        """By how much the simulator may differ from the equations in a period."""
        runs = self.loop.span // self.claim.period
        return [fixed_up(runs * (SPIN_SLACK if i in self.loop.SPINS else SLACK)) for i in range(self.count)]

    def find_bounds(self):
        """Bounds of the coordinates in each phase that hold in a period if they hold in all before."""
        forms = self.known + 3
        step = lambda bounds: list(map(self.bounded, self.round(bounds, forms)))
        before = found = list(map(self.bounded, map(largest, self.by_phase(self.linear))))
        for _ in range(ROUNDS):
            bounds = [[b + b // 50 + max(b - a, 0) // 2 for a, b in zip(*rows)] for rows in zip(before, found)]
            before, found = bounds, step(bounds)
            if self.hold(found, bounds):
                break
        else:
            raise Refused("no bounds of its deviations hold")
        while any(100 * f < 99 * b for rows in zip(found, bounds) for f, b in zip(*rows)):
            bounds, found = found, step(found)
        return found

    def hold(self, found, bounds):
        return all(f <= b for rows in zip(found, bounds) for f, b in zip(*rows))

    # What must hold.

    def follow(self):
        self.sum_up()
        try:
            bounds = self.find_bounds()
            found = self.round(bounds, self.place.stop)
        except SidewaysError:
            raise Refused("no bounds of its deviations hold: a thrust or lift may point sideways") from None
        require(self.hold(list(map(self.bounded, found)), bounds), "bounds of its deviations are lost by rounding")
        self.require_limits()
        self.require_tilt()
        return max(self.radii())

    def require_limits(self):
        """Of each phase. Bounds of the coordinates mostly suffice; where they do not, the sums say more."""
        limits = self.loop.limits()
        open_ = [limit for limit in limits if any(self.room(limit, k, self.by_bounds) <= 0 for k in range(len(self.phases)))]
        for i in range(0, len(open_), SOME):
            some = open_[i:i + SOME]
            found = self.by_sums(list({id(m): m for _, group, _ in some for m in group}.values()))
            for limit in some:
                for k, (begin, _) in enumerate(self.phases):
                    room = self.room(limit, k, lambda m, k: found[id(m)][k])
                    require(room > 0, f"{limit[0]} after {self.seconds(begin):.3f} s, by {-room / ONE:.4g}")

    def room(self, limit, k, half):
        _, models, room = limit
        more = fixed_up(self.loop.span * SPIN_SLACK) + self.lost
        halves = [half(m, k) + more for m in models]
        return room([m.c - h for m, h in zip(models, halves)], [m.c + h for m, h in zip(models, halves)])

    def by_bounds(self, model, k):
        return model.radius[k]

    def by_sums(self, models):
        """How far from its middle each may be in each phase."""
        loop, count = self.loop, self.count
        slopes = [loop.by_coordinates(m) for m in models]
        forms = [(row[:count], row[count:loop.gusts]) for row in slopes]
        sums = Sums(self, [row for row, _ in forms])
        while sums.count < self.sums.count:
            sums.advance(sums.count in self.sums.boxes)
        sums.end(self.slow)
        linear = self.in_groups(sums, forms)
        found = self.totals(linear, list(self.remainders(sums, self.fresh, len(forms))))
        out = {}
        for i, (m, row) in enumerate(zip(models, slopes)):
            gusts = sum(map(size, threes(row[loop.gusts:loop.named]))) * loop.gust_most >> BITS
            out[id(m)] = [rows[i] + gusts + swing(row[loop.named:], loop.named_bounds(k)) + m.r[k] + 1 for k, rows in enumerate(found)]
        return out

    def seconds(self, period):
        return (period * self.loop.span - self.claim.before) / 1000

    def flies(self, end):
        """Whether the trajectory has begun when this period (none: for ever) begins."""
        return end is None or self.seconds(end) > 0

    def require_tilt(self):
        """Of each phase in which the trajectory flies, by bounds of the coordinates, or where they do not suffice by the sums."""
        claimed, slack = cos_of(fixed(F(self.claim.tilt))) + FAULT, self.slacks()[0]
        phases = [k for k, (_, end) in enumerate(self.phases) if self.flies(end)]
        is_open = lambda axis, k: axis[2].least()[k] - slack <= claimed
        axes = [axis for axis in self.loop.axes if any(is_open(axis, k) for k in phases)]
        if not axes:
            return
        halves = self.by_sums([m for axis in axes for m in axis[:2]])
        for axis in axes:
            for k in phases:
                least = axis[2].least()[k] - slack
                if 0 < least <= claimed:
                    x, y = (abs(m.c) + halves[id(m)][k] + slack + self.lost for m in axis[:2])
                    least = max(least, isqrt(max(ONE * ONE - x * x - y * y, 0)))
                begin, tilt = self.seconds(self.phases[k][0]), math.acos(max(least, 0) / ONE)
                require(least > claimed, f"after {begin:.3f} s it may tilt by {tilt:.6g}, claimed {self.claim.tilt:.6g}")

    def radii(self):
        """Of each period in which the trajectory has begun, and of all that follow."""
        moves, group, phase, slack = self.loop.away_in_period(), -1, -1, self.slacks()[0]
        away = [size([max(abs(m[i].c) + m[i].radius[k] for m in moves) for i in range(3)]) for k in range(len(self.phases))]
        for k, (distance, along) in enumerate(self.places):
            group += k in self.begins
            phase += k == self.phases[phase][1] if k else 1
            if self.flies(k + 1 if k < self.last else None):
                further = max(away[max(phase - 1, 0):phase + 1])  # of the period that ends here, too
                yield distance + size(map(add, along, self.rest[group][self.place])) + further + slack + self.lost


# ---- A certificate.

def follow(claim, cell, yaw):
    """A radius that holds for ever, in whole numbers."""
    for mass in cell.masses:
        weight = F(claim.mass) * mass * GRAVITY / 4
        require(F(claim.motor_least) < weight < F(claim.motor_most), "its weight is beyond its motors")
    try:
        return Hover(claim, cell, yaw).follow()
    except SidewaysError:
        raise Refused("a thrust or lift may point sideways at the start") from None


def follow_all(claim, cells, yaw):
    """On all cores, if there are several cells."""
    if len(cells) == 1:
        return follow(claim, cells[0], yaw)
    with multiprocessing.get_context("fork").Pool(min(len(cells), os.cpu_count() or 1)) as pool:
        return max(pool.starmap(follow, [(claim, cell, yaw) for cell in cells], chunksize=1))


def resting_yaw(segments):
    """The heading of a trajectory that rests."""
    places, yaws = {p for _, points, _ in segments for p in points}, {a for _, _, yaws in segments for a in yaws}
    require(len(places) == 1 and len(yaws) == 1, "the trajectory does not rest")
    [yaw] = yaws
    require(abs(yaw) <= 10, f"its heading is {yaw}, beyond 10")
    return yaw


def verify(record, certificate):
    """Raises Refused; else says what has been shown."""
    require(certificate.get("type") == "tube_certificate" and certificate.get("id") == record.get("id"), "it is no certificate of this record")
    claim = Claim(certificate)
    require(claim.controller in LAWS, f"the script knows no controller {claim.controller}")
    require(not claim.is_noisy and claim.gain_error == 0, "the script knows no noise, and no gains that are off")
    segments = segments_of(record, certificate["frame"])
    yaw = resting_yaw(segments)
    duration = sum(duration for duration, _, _ in segments)
    require(len(claim.radius) == math.ceil(duration / 0.1), f"{len(claim.radius)} radii for {duration} s")
    try:
        radius = follow_all(claim, cells_of(claim, certificate["cells"]), yaw)
    except (ArithmeticError, ValueError) as reason:
        raise Refused(f"its numbers are out of range: {reason}") from None
    largest = max(claim.radius)
    require(radius <= fixed(F(largest)), f"it may be {radius / ONE:.6g} m off some time, claimed {largest:.6g} m")
    said = {key: value for key, value in certificate.items() if key not in ("type", "id", "period", "radius", "cells")}
    return {"largest": largest, "for_ever": math.nextafter(radius / ONE, math.inf), **said}


if __name__ == "__main__":
    run_main(__doc__, 2, functools.partial(verify_files, verify, "however long it hovers, the tube holds for"))
