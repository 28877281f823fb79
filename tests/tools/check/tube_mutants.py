"""What can be done to a tube's certificate and its record: changes after which it must be refused, or what it claims is still true.

`mutants` gives (what, record, certificate, expected) for ever, by chance. Expected is "refused"; or "same" where the claim stays or becomes weaker,
so that it may be accepted; or "asked" where another tube is claimed, which must be true if it is accepted.
"""

import copy
import random

NOT_NUMBERS = [None, True, "0.1", "NaN", [], {}, [1], float("nan"), float("inf"), float("-inf"), 1e400, 10**400]
RANGES = ("mass_error", "drag_error", "motor_lag_error", "inertia_error", "gain_error", "start_error", "start_speed",
          "place_noise", "velocity_noise", "attitude_noise", "rate_noise")
CLIPS = ("position", "velocity", "rates")  # loops of the cascade


def places(tree, path=()):
    """The path of every value, of long lists a few."""
    if path:
        yield path
    if isinstance(tree, dict):
        for key in tree:
            yield from places(tree[key], (*path, key))
    elif isinstance(tree, list) and tree:
        for i in sorted({0, len(tree) // 2, len(tree) - 1}):
            yield from places(tree[i], (*path, i))


def at(tree, path):
    for key in path:
        tree = tree[key]
    return tree


def factor(chance):
    """From tiny changes to large ones."""
    by = 10 ** chance.uniform(-6, 0.3)
    return 1 + by if chance.random() < 0.5 else 1 / (1 + by)


class Mutants:
    def __init__(self, seed):
        self.chance = random.Random(seed)

    def of(self, record, certificate):
        kinds = [self.type, self.key, self.list, self.bounds, self.span, self.radius, self.cell, self.vehicle, self.gain, self.disturbance,
                 self.curve, self.time, self.raised]
        while True:
            changed = copy.deepcopy(record), copy.deepcopy(certificate)
            kind = self.chance.choice(kinds)
            told = kind(*changed)
            if told and changed != (record, certificate):
                yield f"{kind.__name__}: {told[0]}", *changed, told[1]

    # What is no certificate.

    def type(self, record, certificate):
        path = self.chance.choice(list(places(certificate)))
        value = self.chance.choice(NOT_NUMBERS)
        before = at(certificate, path)
        if value == before or type(value) is type(before) and isinstance(value, (list, dict)):
            return None
        at(certificate, path[:-1])[path[-1]] = value
        return f"{path} is {value!r:.20}", "refused" if path != ("cells", 0, "part") or value else "same"

    def key(self, record, certificate):
        gains = [g for g in certificate["gains"].values() if isinstance(g, dict)]
        objects = [certificate, certificate["vehicle"], certificate["gains"], *gains, *certificate["cells"]]
        one = self.chance.choice(objects)
        key = self.chance.choice(list(one))
        if self.chance.random() < 0.5:
            del one[key]
            return f"no {key}", "refused"
        one[key + "_"] = one[key]
        return f"{key}_ more", "refused"

    def list(self, record, certificate):
        lists = [p for p in places(certificate) if isinstance(at(certificate, p), list) and at(certificate, p)]
        path = self.chance.choice([p for p in lists if p[-1] not in ("cells", "part")])
        one = at(certificate, path)
        if self.chance.random() < 0.5:
            one.pop(self.chance.randrange(len(one)))
        else:
            one.append(copy.deepcopy(one[-1]))
        return f"{path} has {len(one)}", "refused"

    # Bounds and radii that are too small.

    def bounds(self, record, certificate):
        cell = self.chance.choice(certificate["cells"])["bounds"]
        row, column = self.chance.randrange(2, len(cell)), self.chance.randrange(len(cell[0]))
        value = self.chance.choice([0, -cell[row][column], cell[row][column] * self.chance.uniform(0, 0.4)])
        cell[row][column] = value
        # A bound of nearly nothing may leave room: it is at least 1e-8.
        return f"bound {row} {column} is {value}", "refused" if value <= 0 or value > 1e-6 else "same"

    def span(self, record, certificate):
        one = self.chance.choice(certificate["cells"])
        cell, kind = one["bounds"], self.chance.randrange(4)
        if kind == 0:
            by = self.chance.uniform(0.1, 0.7)
            for row in cell:
                row[:] = [by * b for b in row]
            return f"all bounds times {by}", "refused"
        if kind == 1:
            cell.reverse()
            return "bounds backwards", "refused"
        if kind == 2:
            return self.periods(one["periods"])
        row = self.chance.choice(cell)
        row[:] = row[1:] + row[:1]
        return "a span's bounds turned", "refused"

    def periods(self, periods):
        """Other numbers of periods: for as many in all the claim is the same."""
        k, other = self.chance.randrange(len(periods)), self.chance.randrange(len(periods))
        if self.chance.random() < 0.5:
            periods[k] = self.chance.choice([0, -1, -periods[k], periods[k] + 1, periods[k] - 1, 10**6, periods[k] + 0.5])
            return f"span {k} of {periods[k]}", "refused"
        by = self.chance.randrange(1, 25)
        periods[k] += by
        periods[other] -= by
        return f"{by} periods of span {other} in {k}", "same" if min(periods) > 0 else "refused"

    def radius(self, record, certificate):
        radius = certificate["radius"]
        kind = self.chance.randrange(4)
        by = self.chance.choice([self.chance.uniform(0, 0.9), self.chance.uniform(0.9, 1), 0, -1])
        if kind == 0:
            certificate["tilt"] *= by
            return f"tilt times {by}", "refused" if by <= 0.9 else "asked"
        if kind == 1:
            certificate["radius"] = [by * r for r in radius]
            return f"all radii times {by}", "refused" if by <= 0.9 else "asked"
        k = self.chance.randrange(len(radius))
        radius[k] *= by
        return f"radius {k} times {by}", "refused" if by <= 0.75 else "asked"  # the tool's may be wider than the script's

    # Another claim.

    def cell(self, record, certificate):
        cells = certificate["cells"]
        kind = self.chance.randrange(4)
        if kind == 0:
            cells.pop(self.chance.randrange(len(cells)))
            return "a cell less", "refused"
        if kind == 1:
            cells.append(copy.deepcopy(self.chance.choice(cells)))
            return "a cell twice", "refused"
        part = self.chance.choice(cells)["part"]
        if kind == 2 and part:
            i = self.chance.randrange(len(part))
            part[i] = (part[i] + self.chance.randrange(1, 16)) % 16
            return f"a cell is {part}", "refused"
        part.append(self.chance.randrange(16))
        is_whole = part == [0] and certificate["wind_spread"] == certificate["mass_error"] == 0
        return f"a cell is {part}", "same" if is_whole else "refused"

    def vehicle(self, record, certificate):
        vehicle = certificate["vehicle"]
        name = self.chance.choice(sorted(vehicle))
        by = self.chance.choice([factor(self.chance), 0, -1])
        if isinstance(vehicle[name], list):
            i = self.chance.randrange(len(vehicle[name]))
            vehicle[name][i] *= by
        else:
            vehicle[name] *= by
        wrong = by <= 0 and name not in ("motor_least", "drag") or by < 0 and name == "drag"
        return f"{name} times {by}", "refused" if wrong else "asked"

    def gain(self, record, certificate):
        if certificate["controller"] == "cascade":
            return self.cascade_gain(certificate["gains"])
        name, i = self.chance.choice(sorted(certificate["gains"])), self.chance.randrange(3)
        by = self.chance.choice([factor(self.chance), 0, -1])
        certificate["gains"][name][i] *= by
        return f"gain {name} times {by}", "refused" if by < 0 or by == 0 and name == "position" else "asked"

    def cascade_gain(self, gains):
        lists = [p for p in places(gains) if isinstance(at(gains, p), list)]
        kind, by = self.chance.randrange(4), self.chance.choice([factor(self.chance), 0, -1])
        if kind == 0:
            name = self.chance.choice(CLIPS)
            gains[name]["clip"] = gains[name].get("clip", 1) * self.chance.choice([by, 10 ** self.chance.uniform(-3, 2)])
            return f"clip of {name} is {gains[name]['clip']}", "refused" if gains[name]["clip"] <= 0 else "asked"
        if kind == 1:
            name = self.chance.choice(sorted(gains["feed_forward"]))
            gains["feed_forward"][name] = self.chance.choice([0, by, -1, 2 * by, 1 + by])
            found = gains["feed_forward"][name]
            return f"feed_forward {name} is {found}", "asked" if 0 <= found <= 2 else "refused"
        if kind == 2:
            gains["tilt_max"] *= by
            return f"tilt_max times {by}", "refused" if by <= 0 else "asked"
        path, i = self.chance.choice(lists), self.chance.randrange(3)
        at(gains, path)[i] = at(gains, path)[i] * by if at(gains, path)[i] else self.chance.choice([-1, 1]) * abs(by)
        found = at(gains, path)[i]
        wrong = found < 0 or found == 0 and path in (("position", "p"), ("velocity", "p")) or found and path in (("position", "i"), ("position", "d"))
        return f"gain {path} {i} is {found}", "refused" if wrong else "asked"

    def disturbance(self, record, certificate):
        name = self.chance.choice([*RANGES, *RANGES, "wind_spread", "gust_most", "gust_lag", "wind", "hover", "settle", "attitude_period_ms"])
        if name == "wind":
            certificate["wind"][self.chance.randrange(3)] += self.chance.choice([-1, 1]) * 10 ** self.chance.uniform(-6, 1)
            return "wind", "asked"
        if name == "attitude_period_ms":
            period = self.chance.choice([0, 1, 2, 3, 5, 4.5, -4])
            certificate.update({key: period for key in certificate if key.endswith("_ms")})  # as --loop-period
            return f"period {period}", "asked"
        if name in RANGES and certificate[name] == 0:
            certificate[name] = self.chance.choice([-1, 1, 1]) * 10 ** self.chance.uniform(-9, -0.3)
        else:
            certificate[name] *= self.chance.choice([factor(self.chance), factor(self.chance), -1])
        return f"{name} is {certificate[name]}", "refused" if certificate[name] < 0 else "asked"

    def curve(self, record, certificate):
        segment = self.chance.choice(record["segments"])
        axis = self.chance.choice([a for a in ("x", "y", "z", "yaw") if a in segment])
        i = self.chance.randrange(8)
        segment[axis][i] += self.chance.choice([-1, 1]) * 10 ** self.chance.uniform(-8, 1)
        return f"{axis} {i}", "asked"

    def time(self, record, certificate):
        segment = self.chance.choice(record["segments"])
        segment["duration"] *= self.chance.choice([factor(self.chance), factor(self.chance), 0, -1])
        return f"duration {segment['duration']}", "refused" if segment["duration"] <= 0 else "asked"

    def raised(self, record, certificate):
        """Weaker claims, and larger bounds for the same one."""
        kind, by = self.chance.randrange(5), 1 + 10 ** self.chance.uniform(-4, 0)
        if kind == 4:
            noise = self.chance.choice([name for name in certificate if name.endswith("_noise")])
            certificate[noise] /= by
            return f"{noise} divided by {by}", "same"
        if kind == 0:
            certificate["radius"] = [by * r for r in certificate["radius"]]
        elif kind == 1:
            certificate["tilt"] = min(by * certificate["tilt"], 3.1)
        else:
            for cell in certificate["cells"]:
                for row in cell["bounds"] if kind == 2 else [self.chance.choice(cell["bounds"])]:
                    row[:] = [by * b for b in row]
        return f"{('radii', 'tilt', 'bounds', 'a span')[kind]} times {by}", "same"
