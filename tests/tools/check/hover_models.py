"""Taylor models of order 1 in whole numbers, for several sets of bounds at once.

A number x stands as the whole number x * ONE. A model says of a quantity that it is c + l . s + e for all symbols s within their bounds and some e
with |e| <= r. Each set of bounds has its own r; c and l are the same for all. Whatever is rounded or of second order goes to r.
"""

from math import isqrt
from operator import add, mul, neg, sub

BITS = 96
ONE = 1 << BITS
FAULT = 64  # units of the last place, by which values and slopes of functions may be off
GUARD = 64  # bits more for sums of series


class SidewaysError(Exception):
    """What must be positive may be 0 or below."""


def fixed(x):
    """A fraction as a whole number, rounded down."""
    return (x.numerator << BITS) // x.denominator


class Symbols:
    """The symbols and, for each set, their bounds (whole numbers). Symbols may be added at any time."""

    def __init__(self, bounds):
        self.bounds = [[] for _ in bounds]
        self.slack = [3] * len(bounds)  # units: c and every slope are rounded by at most one
        self.lanes = []  # bounds of each symbol as one number
        for each in zip(*bounds):
            self.add(each)

    @property
    def count(self):
        return len(self.lanes)

    def add(self, bounds):
        """A symbol with these bounds, one in each set."""
        if self.count == MOST_SYMBOLS:
            raise ArithmeticError("too many symbols")
        for k, b in enumerate(bounds):
            self.bounds[k].append(b)
            self.slack[k] += (b >> BITS) + 1
        self.lanes.append(lanes_of(bounds))
        return len(self.lanes) - 1

    def constant(self, c, fault=0):
        return Model(self, c, [], [fault] * len(self.bounds))

    def symbol(self, i, c=0):
        return Model(self, c, [0] * i + [ONE], [0] * len(self.bounds))

    def named(self, model):
        """The same with its remainder as a symbol of its own."""
        i = self.add(model.r)
        return Model(self, model.c, [*model.l, *[0] * (i - len(model.l)), ONE], [0] * len(model.r))


# Bounds of all sets stand side by side in one number, so one sum of products is for all.
LANE = 192  # bits of each
LOWEST = (1 << LANE) - 1
COARSE = 48  # bits that bounds have less here
SLOPES, BOUNDS, MOST_SYMBOLS = 1 << BITS + 20, 1 << BITS + 16, 1 << 11  # a lane has room for products of these


def lanes_of(bounds):
    if max(bounds) >= BOUNDS:
        raise ArithmeticError("a bound is too large")
    return sum(-(-b >> COARSE) << LANE * k for k, b in enumerate(bounds))


class Model:
    """Symbols from len(l) on have no slope."""

    __slots__ = ("of", "c", "l", "r", "_radius")

    def __init__(self, of, c, l, r):
        self.of, self.c, self.l, self.r, self._radius = of, c, l, r, None

    @property
    def radius(self):
        """Of each set: how far it may be from c."""
        if self._radius is None:
            sizes = list(map(abs, self.l))
            if sizes and max(sizes) >= SLOPES:
                raise ArithmeticError("a slope is too large")
            total, self._radius = sum(map(mul, sizes, self.of.lanes)), []
            for r in self.r:
                self._radius.append(((total & LOWEST) >> BITS - COARSE) + 1 + r)
                total >>= LANE
        return self._radius

    def least(self):
        return [self.c - radius for radius in self.radius]

    def __neg__(self):
        return Model(self.of, -self.c, [-x for x in self.l], self.r)

    def __add__(self, other):
        a, b = self.l, other.l
        return Model(self.of, self.c + other.c, [*map(add, a, b), *a[len(b):], *b[len(a):]], [*map(add, self.r, other.r)])

    def __sub__(self, other):
        a, b = self.l, other.l
        return Model(self.of, self.c - other.c, [*map(sub, a, b), *a[len(b):], *map(neg, b[len(a):])], [*map(add, self.r, other.r)])

    def plus(self, c):
        return Model(self.of, self.c + c, self.l, self.r)

    def wider(self, units):
        return Model(self.of, self.c, self.l, [r + units for r in self.r])

    def times(self, k):
        """k: a fraction."""
        up, down = k.numerator, k.denominator
        return Model(self.of, self.c * up // down, [x * up // down for x in self.l],
                     [r * abs(up) // down + 1 + s for r, s in zip(self.r, self.of.slack)])

    def __mul__(self, other):
        a, b = self.c, other.c
        r = [((abs(a) * rb + abs(b) * ra + da * db) >> BITS) + 1 + s
             for ra, rb, da, db, s in zip(self.r, other.r, self.radius, other.radius, self.of.slack)]
        l = [(a * y + b * x) >> BITS for x, y in zip(self.l, other.l)]
        l += [b * x >> BITS for x in self.l[len(l):]] + [a * y >> BITS for y in other.l[len(l):]]
        return Model(self.of, a * b >> BITS, l, r)

    def through(self, value, slope, bends):
        """g(self), of g and its slope at c, both off by at most FAULT, and for each set a bound of its second derivative."""
        r = [(abs(slope) * r >> BITS) + (bend * d * d >> 2 * BITS + 1) + FAULT * (2 + (d >> BITS)) + 2 + s
             for r, d, bend, s in zip(self.r, self.radius, bends, self.of.slack)]
        return Model(self.of, value, [slope * x >> BITS for x in self.l], r)

    def positive(self):
        least = self.least()
        if min(least) <= 0:
            raise SidewaysError
        return least


def inverse(a):
    least = a.positive()
    value = ONE * ONE // a.c
    if value > 16 * ONE:  # or its faults may be larger
        raise SidewaysError
    return a.through(value, -(value * value >> BITS), [2 * ONE**4 // b**3 + 1 for b in least])


def root(a):
    least = a.positive()
    if 16 * a.c < ONE:
        raise SidewaysError
    value = isqrt(a.c << BITS)
    return a.through(value, ONE * ONE // (2 * value), [ONE**3 // (4 * b * isqrt(b << BITS)) + 1 for b in least])


def sine(a):
    return a.through(sin_of(a.c), cos_of(a.c), [ONE] * len(a.r))


def cosine(a):
    return a.through(cos_of(a.c), -sin_of(a.c), [ONE] * len(a.r))


def arcus_sine(a):
    if abs(a.c) > ONE // 2 or abs(a.c) + max(a.radius) >= ONE:
        raise SidewaysError
    bends = []
    for radius in a.radius:
        most = abs(a.c) + radius
        room = ONE - (most * most >> BITS) - 1
        bends.append(most * ONE**2 // (room * isqrt(room << BITS)) + 1)
    value = series(a.c, a.c, lambda k: ((2 * k + 1)**2, (2 * k + 2) * (2 * k + 3)))
    return a.through(value, ONE * ONE // isqrt((ONE << BITS) - a.c * a.c), bends)


# ---- Series.

def series(x, first, ratio):
    """The sum of 90 terms, each of which is the one before times x^2 and a fraction. That is enough up to |x| = 16 for sine and cosine, and up to 1/2 for
    the arcus sine."""
    term, total = first << GUARD, 0
    for k in range(90):
        total += term
        up, down = ratio(k)
        term = term * x * x * up // (down << 2 * BITS)
    return total >> GUARD


def sin_of(x):
    return series(x, x, lambda k: (-1, (2 * k + 2) * (2 * k + 3)))


def cos_of(x):
    return series(x, ONE, lambda k: (-1, (2 * k + 1) * (2 * k + 2)))


def exp_of(x):
    """Of x <= 0, |x| <= 1."""
    term = total = ONE << GUARD
    for k in range(1, 60):
        term = term * x // (k << BITS)
        total += term
    return total >> GUARD
