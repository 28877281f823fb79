"""Lines over parts of edges that lie below lengths of paths: a line is a pair of numbers, at the low and the high end of its part."""

import math

from bends import distance


def slope(part, line):
    length = part.length
    return (line[1] - line[0]) / length if length > 0 else 0.0


def directions(a, la, b, lb):
    """Vectors no longer than 1, one of which is the best to see that a line carried on is above another: of the ways
    between two points at which the sum is least, each an end of its part or inside."""
    for x in ((None,) if a.length > 0 else ()) + (a.low, a.high):
        for y in ((None,) if b.length > 0 else ()) + (b.low, b.high):
            u, free = [0.0] * 3, [True] * 3
            for end, part, line in ((x, a, la), (y, b, lb)):
                if end is None:
                    u[part.axis], free[part.axis] = slope(part, line), False
            left = 1 - sum(v * v for v in u)
            if left < 0:
                continue
            way = [(y or b.low)[k] - (x or a.low)[k] if free[k] else 0.0 for k in range(3)]
            size = math.sqrt(sum(v * v for v in way))
            by = math.sqrt(left) / size if size > 0 else 0.0
            u = [(w * by if f else v) * (1 - 2.0**-48) for v, w, f in zip(u, way, free)]
            if sum(v * v for v in u) < 1:
                yield u


def carried_is_above(a, la, b, lb, margin):
    """Whether la(x) + |y - x| >= lb(y) for all x in a and y in b: for any u of length 1 at most it is if
    la(x) + u . (y - x) - lb(y) is at the four pairs of ends. Rounded numbers are wrong by less than `margin`."""
    if min(la) >= max(lb) or min(la) + distance(a, b) - max(lb) >= margin:
        return True
    for u in directions(a, la, b, lb):
        if all(p + sum(v * (t - s) for v, s, t in zip(u, x, y)) - q >= margin
               for p, x in zip(la, (a.low, a.high)) for q, y in zip(lb, (b.low, b.high))):
            return True
    return False


def straight_line(place, part, margin):
    """A line below the distance from a place to the points of a part: its chord less what it sags, at most
    length^2 / 8 times its largest second derivative r^2 / d^3."""
    d = distance(place, part)
    if part.axis == 3:
        return (d - margin,) * 2
    r2 = sum((place.low[k] - part.low[k]) ** 2 for k in range(3) if k != part.axis)
    sag = part.length**2 / 8 * min(1, r2 / d**2) / d if d > 0 else math.inf
    if not sag <= d / 2:
        return (d - margin,) * 2
    return tuple(math.dist(place.low, end) - sag - margin for end in (part.low, part.high))


def plus(a, b):
    return a[0] + b[0], a[1] + b[1]
