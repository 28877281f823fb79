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
from hover_period import GRAVITY, HELD, Geometric
from tube_claim import Claim, cells_of, segments_of, verify_files
from verify_certificate import Refused, require, run_main


def fixed_up(x):
    return fixed(F(x)) + 1


LAWS = {"geometric": Geometric}
SLACK, SPIN_SLACK = fixed_up(F(1, 10**9)), fixed_up(F(1, 10**7))  # in each coordinate and period, and in angular accelerations (docs/tube.md)
PHASES = (0, 1, 2, 3, 4, 5, 6, 7, 8, 10, 12, 14, 17, 20, 25, 30, 40, 60, 100, 180, 340, 700)  # periods from which on other bounds of the coordinates hold
DIED = 200  # a power has died away when it makes at most this part of each sum
ACTED = 100  # periods, in which all disturbances have begun to act
LONGEST = 6000  # periods, until which it must have
LARGEST = ONE << 20  # of sums
ROUNDS = 30  # of larger bounds, then there are none


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


def reach(rows):
    """How far the image of a ball reaches, of the three rows of a matrix k: Gershgorin's bound of k^T k."""
    columns = list(zip(*rows))
    return isqrt(max(sum(abs(sum(map(mul, a, b))) for b in columns) for a in columns)) + 1


# ---- A cell.

class Sums:
    """What all disturbances so far do to some linear forms, from period to period. The coordinates' deviations follow x <- L x + C s + G n + N e + r:
    symbols s are held, gusts n and named errors e are new in each period. A form is a row for x and a row for s."""

    def __init__(self, loop, after, start, forms):
        count = loop.COUNT
        slopes = [loop.by_coordinates(m) for m in after]
        columns = list(zip(*slopes))
        self.map, self.rows, self.fresh = columns[:count], [row[:count] for row in slopes], columns[loop.gusts:]
        self.gusts = loop.named - loop.gusts
        self.forms, self.powers = [row for row, _ in forms], [row for row, _ in forms]
        self.direct = [held + [0] * 7 for _, held in forms]
        # Columns: what each held symbol, each symbol of the start, and the middle's start have done so far.
        begun = [[m.l[i] for m in start] for i in (*range(count, count + HELD), *range(6))]
        self.responses = [*begun, [m.c - c for m, c in zip(start, loop.middle)]]
        self.added = [*columns[count:loop.gusts], *[[0] * count] * 7]
        self.gust_sums, self.box_sums = [0] * len(forms), [[0] * (count + len(self.fresh) - self.gusts) for _ in forms]
        self.gust_reach = self.count = 0
        self.place = slice(count, count + 3)

    def responses_of_forms(self):
        return [list(map(add, a, b)) for a, b in zip(product(self.forms, self.responses), self.direct)]

    def advance(self):
        new = product(self.powers, self.fresh)
        for i, (row, power) in enumerate(zip(new, self.powers)):
            self.gust_sums[i] += sum(map(size, threes(row[:self.gusts])))
            self.box_sums[i] = [a + abs(b) for a, b in zip(self.box_sums[i], (*power, *row[self.gusts:]))]
        self.gust_reach += sum(reach([row[k:k + 3] for row in new[self.place]]) for k in range(0, self.gusts, 3))
        self.powers = product(self.powers, self.map)
        self.responses = [list(map(add, a, b)) for a, b in zip(product(self.responses, self.rows), self.added)]
        self.count += 1


class Hover:
    """The proof for a cell."""

    def __init__(self, claim, cell, yaw):
        self.claim, self.is_ball = claim, cell.is_ball
        self.loop = loop = LAWS[claim.controller](claim, cell, yaw)
        self.off = [fixed_up(claim.start_error), fixed_up(claim.start_speed)]
        self.start = loop.start(*self.off)
        self.count, self.halves = loop.COUNT, loop.halves
        self.place = slice(self.count, self.count + 3)
        self.after = loop.run([[0] * self.count])
        self.commands = [m for command in loop.commands for m in command]
        self.forms = [*self.coordinates(), *(([fixed(x) for x in row], [0] * HELD) for row in loop.place_rows())]
        slopes = [loop.by_coordinates(m) for m in self.commands]
        self.forms += [(row[:self.count], row[self.count:loop.gusts]) for row in slopes]
        # What gusts of the period do to commands, and slopes by its named errors.
        self.in_period = [(sum(map(size, threes(row[loop.gusts:loop.named]))), row[loop.named:]) for row in slopes]

    def coordinates(self):
        """Those that have bounds: the acceleration in place of the gust."""
        for i in range(self.count):
            row, held = [0] * self.count, [0] * HELD
            if i < self.count - 3:
                row[i] = ONE
            else:
                parts, wind = self.loop.balance(i - self.count + 3)
                held[i - self.count + 3] = fixed(wind)
                for k, factor in parts:
                    row[k] = fixed(factor)
            yield row, held

    # What is linear.

    def sum_up(self):
        sums = Sums(self.loop, self.after, self.start, self.forms)
        self.begins, self.linear, self.places, self.boxes = [], [], [], {}
        while True:
            k = sums.count
            if k <= PHASES[-1] or group_begins(k):
                self.boxes[k] = sums.box_sums[:]
            if group_begins(k):
                self.begins.append(k)
                self.linear.append([0] * len(self.forms))
            self.take(sums)
            if k >= ACTED and group_begins(k) and self.has_died_away(sums.powers):
                break  # the last group is for all periods from here on
            require(k < LONGEST and max(self.linear[-1]) < LARGEST, "its loop hardly damps, or its gusts last too long")
            sums.advance()
        self.powers = sums.powers
        begins = [p for p in PHASES if p <= k]
        self.phases, self.summed = list(zip(begins, [*begins[1:], None])), sorted(self.boxes)

    def take(self, sums):
        """Notes what the held symbols, the start and gusts do to each form and to the place. Of the place it notes a distance, of the middle and all
        balls, and what intervals do along each axis."""
        most, halves, from_axis = self.loop.gust_most, self.halves, 3 if self.is_ball else 0
        bounds, responses = self.linear[-1], sums.responses_of_forms()
        for i, (r, gusts) in enumerate(zip(responses, sums.gust_sums)):
            held = swing(r[from_axis:HELD], halves[from_axis:]) + (size(r[:3]) * halves[0] >> BITS if self.is_ball else 0)
            off = swing(map(size, threes(r[HELD:-1])), self.off)
            bounds[i] = max(bounds[i], abs(r[-1]) + held + off + (gusts * most >> BITS) + 2)
        rows = responses[self.place]
        middle = size([fixed(p) + r[-1] for p, r in zip(self.loop.place(), rows)])
        balls = sums.gust_reach * most + sum(reach([r[k:k + 3] for r in rows]) * b for k, b in zip((HELD, HELD + 3), self.off))
        if self.is_ball:
            balls += reach([r[:3] for r in rows]) * halves[0]
        self.places.append((middle + (balls >> BITS) + 2, [swing(r[from_axis:HELD], halves[from_axis:]) for r in rows]))

    def has_died_away(self, powers):
        most = self.left([max(column) for column in zip(*self.linear)])
        return all(DIED * swing(row, most) <= max(now, ONE >> 60) for row, now in zip(powers[:self.place.stop], self.linear[-1]))

    def left(self, bounds):
        """Bounds of what came before the sums: a deviation less what is held. Both are within the coordinate's bound, so it is at most twice that."""
        return [*(2 * b for b in bounds[:self.count - 3]), *[self.loop.gust_most] * 3]

    # What is not.

    def remainders(self, fresh, bounds, forms):
        """Of each group what remainders do to the first forms; `fresh` has those of a period in each phase."""
        most = self.left([max(column) for column in zip(*bounds)])
        at_start = [m.r[0] for m in self.start] + [0] * (len(fresh[0]) - self.count)
        for begin, end in zip(self.begins, [*self.begins[1:], None]):
            terms = [*self.ages(begin, end, fresh), *([(end, begin, at_start)] if end else [])]
            rows = [self.lost] * forms
            for oldest, newest, box in terms:
                rows = [x + swing(one, box) for x, one in zip(rows, self.box_sum(oldest, newest))]
            yield rows if end else [x + swing(row, most) for x, row in zip(rows, self.powers)]

    def ages(self, begin, end, fresh):
        """For a group: how many periods ago remainders may have been new (`newest` or more, fewer than `oldest`), and the largest there were then."""
        cuts = {begin - first for first, _ in self.phases} | {end - 1 - first for first, _ in self.phases if end}
        cuts = sorted(c for c in cuts | {0} if 0 <= c <= (end - 1 if end else begin))
        for newest, oldest in zip(cuts, cuts[1:]):
            boxes = [box for (first, last), box in zip(self.phases, fresh)
                     if (end is None or first <= end - 2 - newest) and (last is None or last > begin - oldest)]
            yield oldest, newest, [max(column) for column in zip(*boxes)]

    def box_sum(self, oldest, newest):
        above, below = bisect.bisect_left(self.summed, oldest), bisect.bisect_right(self.summed, newest) - 1
        return [map(sub, a, b) for a, b in zip(self.boxes[self.summed[above]], self.boxes[self.summed[below]])]

    def by_phase(self, groups):
        at = [self.begins.index(first) for first, _ in self.phases]
        return [groups[a:b] for a, b in zip(at, [*at[1:], None])]

    def round(self, bounds, forms):
        """Of each phase what the first forms come to, if the coordinates are within these bounds in all periods before."""
        loop = self.loop
        after = loop.run(bounds)
        self.lost = 4 * (len(self.places) + 4) * max(loop.of.slack)  # by rounding sums, powers and forms
        fresh = []
        for k, named in enumerate(loop.of.bounds):
            rounding = 4 * loop.of.slack[k] + (3 * sum(self.off) >> BITS) + 8
            slack = [SPIN_SLACK if i in loop.SPINS else SLACK for i in range(self.count)]
            fresh.append([m.r[k] + abs(m.c - c) + s + rounding for m, c, s in zip(after, loop.middle, slack)] + named[loop.named:])
        self.rest = list(self.remainders(fresh, bounds, forms))
        return [[max(column) for column in zip(*rows)] for rows in self.by_phase([list(map(add, a, b)) for a, b in zip(self.linear, self.rest)])]

    def find_bounds(self):
        """Bounds of the coordinates in each phase that hold in a period if they hold in all before."""
        before = found = [[max(column) for column in zip(*rows)][:self.count] for rows in self.by_phase(self.linear)]
        for _ in range(ROUNDS):
            bounds = [[b + b // 50 + max(b - a, 0) // 2 for a, b in zip(*rows)] for rows in zip(before, found)]
            before, found = bounds, self.round(bounds, self.count)
            if self.hold(found, bounds):
                break
        else:
            raise Refused("no bounds of its deviations hold")
        while any(100 * f < 99 * b for rows in zip(found, bounds) for f, b in zip(*rows)):
            bounds, found = found, self.round(found, self.count)
        return found

    def hold(self, found, bounds):
        return all(f <= b for rows in zip(found, bounds) for f, b in zip(*rows))

    # What must hold.

    def follow(self):
        self.sum_up()
        try:
            bounds = self.find_bounds()
            found = self.round(bounds, len(self.forms))
        except SidewaysError:
            raise Refused("no bounds of its deviations hold: a thrust or lift may point sideways") from None
        require(self.hold(found, bounds), "bounds of its deviations are lost by rounding")
        self.require_motors(found)
        self.require_tilt()
        return max(self.radii())

    def require_motors(self, found):
        """Of each phase and command."""
        least, most = (fixed(F(m)) for m in (self.claim.motor_least, self.claim.motor_most))
        commands = [m for command in self.loop.commands for m in command]
        for k, ((begin, _), rows) in enumerate(zip(self.phases, found)):
            errors = self.loop.of.bounds[k][self.loop.named:]
            for i, (m, row, (gusts, named)) in enumerate(zip(commands, rows[self.place.stop:], self.in_period)):
                half = row + (gusts * self.loop.gust_most >> BITS) + swing(named, errors) + m.r[k] + SLACK + self.lost
                room = min(most - m.c, m.c - least) - half
                require(room > 0, f"motor {i % 4 + 1} may leave its range after {self.seconds(begin):.3f} s, by {-room / ONE:.4g}")

    def seconds(self, period):
        return (period * self.claim.period - self.claim.before) / 1000

    def flies(self, end):
        """Whether the trajectory has begun when this period (none: for ever) begins."""
        return end is None or self.seconds(end) > 0

    def require_tilt(self):
        claimed = cos_of(fixed(F(self.claim.tilt))) + FAULT
        for k, (begin, end) in enumerate(self.phases):
            least = min(m.least()[k] for m in self.loop.upright) - SLACK
            if self.flies(end):
                require(least > claimed, f"after {self.seconds(begin):.3f} s it may tilt by {math.acos(max(least, 0) / ONE):.6g}, claimed {self.claim.tilt:.6g}")

    def radii(self):
        """Of each period in which the trajectory has begun, and of all that follow."""
        group, phase = -1, -1
        for k, (distance, along) in enumerate(self.places):
            group += k in self.begins
            phase += k == self.phases[phase][1] if k else 1
            if self.flies(k + 1 if k + 1 < len(self.places) else None):
                further = size([max(abs(m[i].c) + m[i].radius[phase] for m in self.loop.moved) for i in range(3)])
                yield distance + size(map(add, along, self.rest[group][self.place])) + further + SLACK + self.lost


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
