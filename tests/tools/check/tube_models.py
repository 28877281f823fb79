"""Taylor models of order 1, for many periods at once, and vectors of three of them.

Each model says of a quantity, for each period, that it is c + l . s + e for all symbols s in [-1, 1] and some e with |e| <= r. Second-order terms and
rounding go to r.
"""

import numpy as np

UNIT = 2.0**-53
ROUNDING = 400 * UNIT  # of the parts of an operation, each a sum of at most 64 products, with room
LIBM = 4e-15  # of sine, cosine, arcus sine


class SidewaysError(Exception):
    """A thrust or a lift may point sideways in this period (counted from 0)."""

    def __init__(self, bad):
        super().__init__()
        self.period = int(np.argmax(bad))


class Model:
    """c, r: a number for each period; l: a row for each symbol."""

    __slots__ = ("c", "l", "r", "_swing")
    __array_ufunc__ = None  # arrays leave operations with a model to the model

    def __init__(self, c, l, r):
        self.c, self.l, self.r, self._swing = c, l, r, None

    @property
    def swing(self):
        if self._swing is None:
            self._swing = np.abs(self.l).sum(axis=0)
        return self._swing

    def size(self):
        """Of all its parts: what the rounding of an operation is a share of."""
        return np.abs(self.c) + self.swing + self.r

    def radius(self):
        return (self.swing + self.r) * (1 + ROUNDING)

    def least(self):
        return self.c - self.radius() - ROUNDING * np.abs(self.c)

    def most(self):
        return self.c + self.radius() + ROUNDING * np.abs(self.c)

    def __neg__(self):
        return Model(-self.c, -self.l, self.r)

    def __add__(self, other):
        if isinstance(other, Model):
            return Model(self.c + other.c, self.l + other.l, self.r + other.r + ROUNDING * (self.size() + other.size()))
        return Model(self.c + other, self.l, self.r + ROUNDING * (self.size() + abs(other)))

    __radd__ = __add__

    def __sub__(self, other):
        return self + -other

    def __rsub__(self, other):
        return -self + other

    def __mul__(self, other):
        if not isinstance(other, Model):
            factor = abs(other)
            return Model(self.c * other, self.l * other, self.r * factor + ROUNDING * factor * self.size())
        a, b = self, other
        r = np.abs(a.c) * b.r + np.abs(b.c) * a.r + (a.swing + a.r) * (b.swing + b.r) + ROUNDING * a.size() * b.size()
        return Model(a.c * b.c, a.c * b.l + b.c * a.l, r)

    __rmul__ = __mul__

    def through(self, value, slope, bend):
        """g(self), of g and its slope at c and a bound of its second derivative over all values."""
        radius = self.radius()
        size = np.abs(value) + np.abs(slope) * self.size()
        r = np.abs(slope) * self.r + 0.5 * bend * radius * radius * (1 + ROUNDING) + (ROUNDING + LIBM) * size
        return Model(value, slope * self.l, r)


def require_all(holds):
    if not np.all(holds):
        raise SidewaysError(~holds)


def inverse(a):
    least = a.least()
    require_all(least > 0)
    return a.through(1 / a.c, -1 / (a.c * a.c), 2 / (least * least * least))


def root(a):
    least = a.least()
    require_all(least > 0)
    value = np.sqrt(a.c)
    return a.through(value, 0.5 / value, 0.25 / (least * np.sqrt(least)))


def sine(a):
    return a.through(np.sin(a.c), np.cos(a.c), 1.0)


def cosine(a):
    return a.through(np.cos(a.c), -np.sin(a.c), 1.0)


def arcus_sine(a):
    most = np.maximum(a.most(), -a.least())
    require_all(most < 1)
    room = 1 - most * most
    return a.through(np.arcsin(a.c), 1 / np.sqrt(1 - a.c * a.c), most / (room * np.sqrt(room)))


# ---- Vectors of three models or numbers.

def dot(a, b):
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def plus(a, b):
    return [x + y for x, y in zip(a, b)]


def minus(a, b):
    return [x - y for x, y in zip(a, b)]


def times(k, a):
    return [k * x for x in a]


def scaled(a, b):
    return [x * y for x, y in zip(a, b)]
