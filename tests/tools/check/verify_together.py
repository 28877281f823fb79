"""verify_together.py RECORDS CERTIFICATES: follows in exact fractions why flights keep apart from one another.

RECORDS are trajectories and CERTIFICATES what `skyway-check --together --certificate` wrote of them (JSON Lines).
That each flight is clear of its map is verify_certificate.py's affair. Nothing is taken on trust: joints, stretches
and zones are worked out of the records, each piece is looked at, and each pair without a proof is shown to be apart
by boxes in space and time. Exit 0 when all pairs are shown to be apart; 1 when not, with the reason; 2 for wrong
usage; 3 when a file cannot be read as what it should be. docs/certificates.md says what is checked.
"""

import array
import bisect
import itertools
from fractions import Fraction as F

from verify_certificate import (LONGEST, SHORTEST, Refused, an_object, bounding_box, entries, halves, number,
                                numbers, on_all_cores, pieces, require, run_main, same_epoch, strict_json, text)

MOST_HALVINGS = 12
MOST_LOOKS = 20000
SLACK = 1e-6  # m, and s: of numbers in floats that pass by quickly what is clearly far away
FLOATS_REACH = 1e6, 1e9  # m, s: up to there, floats are much better than that
CELL = (10.0, 250.0, 250.0)  # s, m, m: in which flights are looked for that may come near each other
MANY_CELLS = 20000  # of a part; then its flight is compared with all others
SHARES = 64  # of the pairs, for several processes


class Flight:
    """A trajectory with its joints, exact. Control points are doubles, and become fractions where they are asked for."""

    def __init__(self, record):
        self.id = record["id"]
        self.lengths, self.points = [], array.array("d")  # x, y and z of eight points for each segment
        for i, segment in enumerate(entries(record.get("segments"), "segments")):
            segment = an_object(segment, f"segments[{i}]")
            axes = [numbers(segment.get(axis), 8, f"segments[{i}].{axis}") for axis in "xyz"]
            self.lengths.append(F(number(segment.get("duration"), "a duration", SHORTEST, LONGEST)))
            self.points.extend(itertools.chain(*zip(*axes)))
        require(self.lengths, "a trajectory has no segments")
        said = [record[key] for key in ("start", "earliest") if record.get(key) is not None]
        first = said[0] if said else 0
        self.joints = [F(number(first, "start", -LONGEST, LONGEST))]
        for length in self.lengths:
            self.joints.append(self.joints[-1] + length)
        ends = zip(self.points[21::24], self.points[22::24], self.points[23::24])
        begins = zip(self.points[24::24], self.points[25::24], self.points[26::24])
        self.gap = max((abs(F(a) - F(b)) for p, q in zip(ends, begins) for a, b in zip(p, q) if a != b), default=F(0))
        far = max(map(abs, self.points)), max(abs(self.joints[0]), abs(self.joints[-1]))
        self.fits_floats = far[0] <= FLOATS_REACH[0] and far[1] <= FLOATS_REACH[1]

    def floats(self, i):
        """The control points of a segment."""
        some = self.points[24 * i:24 * i + 24]
        return list(zip(some[::3], some[1::3], some[2::3]))

    def exact(self, i):
        return [[F(c) for c in p] for p in self.floats(i)]

    def segment_at(self, begin):
        return bisect.bisect_right(self.joints, begin) - 1

    def over(self, begin, end):
        """Control points from one time to another, between which there is no joint; at rest where it is parked."""
        if end <= self.joints[0]:
            return [self.exact(0)[0]] * 8
        if begin >= self.joints[-1]:
            return [self.exact(len(self.lengths) - 1)[-1]] * 8
        i = self.segment_at(begin)
        points = cut(self.exact(i), (end - self.joints[i]) / self.lengths[i])[0]
        return cut(points, (begin - self.joints[i]) / (end - self.joints[i]))[1]

    def roughly_over(self, begin, end):
        """The same in floats."""
        if end <= self.joints[0]:
            return [self.floats(0)[0]] * 8
        if begin >= self.joints[-1]:
            return [self.floats(len(self.lengths) - 1)[-1]] * 8
        i = self.segment_at(begin)
        points, start, stop = self.floats(i), self.joints[i], self.joints[i + 1]
        if end != stop:
            points = cut(points, float((end - start) / self.lengths[i]))[0]
        return cut(points, float((begin - start) / (end - start)))[1] if begin != start else points

    def part(self, i, parked):
        """A segment or, on pads, a rest: before all segments, and behind them."""
        i -= parked == "pad"
        if i < 0:
            return Part(None, self.joints[0], [self.exact(0)[0]])
        if i == len(self.lengths):
            return Part(self.joints[-1], None, [self.exact(i - 1)[-1]])
        return Part(self.joints[i], self.joints[i + 1], self.exact(i))

    def rough_parts(self, parked):
        """Of each part the times and the box, in floats: (begin, end, low, high). In the order of time."""
        first, last, times = list(self.points[:3]), list(self.points[-3:]), [float(t) for t in self.joints]
        out = [(-2 * LONGEST, times[0], first, first)] if parked == "pad" else []
        for i, span in enumerate(zip(times, times[1:])):
            some = self.points[24 * i:24 * i + 24]
            axes = some[::3], some[1::3], some[2::3]
            out.append((*span, [min(c) for c in axes], [max(c) for c in axes]))
        return out + ([(times[-1], 2 * LONGEST, last, last)] if parked == "pad" else [])


def cut(points, share):
    """Both parts of a curve, by de Casteljau."""
    left, right, row = [points[0]], [points[-1]], points
    while len(row) > 1:
        row = [[a + share * (b - a) for a, b in zip(p, q)] for p, q in zip(row, row[1:])]
        left.append(row[0])
        right.append(row[-1])
    return left, right[::-1]


def stretches(a, b, parked):
    """The times between which neither has a joint, in order; of a rest of both an instant."""
    pad = parked == "pad"
    first = (min if pad else max)(a.joints[0], b.joints[0])
    last = (max if pad else min)(a.joints[-1], b.joints[-1])
    if first > last:
        return []
    times = sorted({t for t in a.joints + b.joints if first < t < last} | {first, last})
    out = list(zip(times, times[1:])) or [(first, first)]
    return [(first, first)] + out + [(last, last)] if pad else out


def beyond(zone, gap, side, point):
    """Whether the point, moved by `gap` along each axis, is strictly beyond the plane across the side that touches the zone."""
    shape, reach = zone
    way = sum(n * c for n, c in zip(side, point)) - gap * sum(map(abs, side))
    if shape == "cylinder" and side[2] == 0:
        return way > 0 and way * way > reach[0] ** 2 * (side[0] ** 2 + side[1] ** 2)
    return way > sum(abs(n) * r for n, r in zip(side, reach))


def side_of(value):
    require(type(value) is list and len(value) == 3, f"a side must be [x, y, z], found {value}")
    for c in value:
        require(type(c) is int and abs(c) < 2**31, f"a side must be whole numbers, found {value}")
    require(any(value), "a side points nowhere")
    require(value[2] == 0 or value[:2] == [0, 0], f"a side must be level or upright, found {value}")
    return value


def verify_cover(points, zone, gap, cover):
    cover = an_object(cover, "a cover")
    sides = entries(cover.get("sides"), "sides")
    count = 0
    for piece in pieces(points, cover.get("pieces")):
        require(count < len(sides), "a piece has no side")
        side = side_of(sides[count])
        require(all(beyond(zone, gap, side, p) for p in piece), "a piece is not shown to be outside of the zone")
        count += 1
    require(count == len(sides), "there are more sides than pieces")


class Claim:
    """What all pairs must keep, of the certificate's last line and of the records."""

    def __init__(self, line, flights, records):
        self.parked = line.get("parked")
        require(self.parked in ("pad", "gone"), "parked must be pad or gone")
        ids = entries(line.get("flights"), "flights")
        require(ids == [f.id for f in flights], "the flights of the certificate are not those of the records, in order")
        require(same_epoch([record.get("epoch") for record in records], line.get("epoch"), "a record"), "the epochs differ")
        for key in ("map", "frame"):
            require(len({record[key] for record in records if record.get(key) is not None}) <= 1,
                    f"the records say different values of {key}")
        self.zone = None if line.get("separation") == "vehicles" else self.read(line.get("separation"))
        self.downwash = self.read(line["downwash"]) if "downwash" in line else None
        self.rooms = None
        if self.zone is None:
            rooms = entries(line.get("rooms"), "rooms")
            require(len(rooms) == len(flights), "each flight must have a room")
            self.rooms = {f.id: [F(c) for c in numbers(room, 3, "a room", 0)] for f, room in zip(flights, rooms)}
            require(all(c > 0 for room in self.rooms.values() for c in room), "a room has no size")
            for record in records:
                self.require_room(record)

    @staticmethod
    def read(zone):
        zone = an_object(zone, "a zone")
        require(zone.get("shape") in ("cylinder", "box"), "a zone must be a cylinder or a box")
        reach = [F(number(c, "a reach", 5e-324)) for c in numbers(zone.get("reach"), 3, "a reach", 0)]
        require(zone["shape"] == "box" or reach[0] == reach[1], "a cylinder must be round")
        return zone["shape"], reach

    def require_room(self, record):
        """No less than the record's own half sizes and margin."""
        if "vehicle" not in record:
            return
        half = numbers(an_object(record["vehicle"], "vehicle").get("half"), 3, "half", 0)
        margin = F(number(record.get("margin", 0), "margin", 0))
        require(all(r >= F(h) + margin for r, h in zip(self.rooms[record["id"]], half)),
                f"the room of {record['id']} is less than its vehicle and margin")

    def widest(self):
        """How far the zones of any pair reach along each axis, at least: in floats."""
        rooms = [2 * max(room[i] for room in self.rooms.values()) for i in range(3)] if self.rooms else self.zone[1]
        downwash = self.downwash[1] if self.downwash else [0, 0, 0]
        return [float(max(pair)) * (1 + 1e-12) for pair in zip(rooms, downwash)]

    def zones(self, a, b):
        """The boxes of two vehicles as exact sums: those of the tool are rounded up."""
        first = self.zone or ("box", [p + q for p, q in zip(self.rooms[a.id], self.rooms[b.id])])
        return [first] + ([self.downwash] if self.downwash else [])


class Part:
    """A segment or a rest, and what holds it: begin and end (None: for ever), control points and the box around them."""

    def __init__(self, begin, end, points):
        self.begin, self.end, self.points = begin, end, points
        self.low, self.high = bounding_box(points)
        self.rough = [float(c) for c in self.low], [float(c) for c in self.high]
        self.size = max(h - l for l, h in zip(*self.rough))

    def halves(self):
        """Nothing of what has no begin or end: a rest."""
        if self.begin is None or self.end is None:
            return None
        middle = (self.begin + self.end) / 2
        left, right = halves(self.points)
        return Part(self.begin, middle, left), Part(middle, self.end, right)

    def is_over_before(self, other):
        return self.end is not None and other.begin is not None and self.end < other.begin

    def away_from(self, other, reach, rough_reach):
        """Whether the boxes, grown together by `reach`, miss each other."""
        (low, high), (lower, higher) = self.rough, other.rough
        if any(h + r < l or u + r < k for h, l, u, k, r in zip(high, lower, higher, low, rough_reach)):
            return True
        return any(h + r < l or u + r < k for h, l, u, k, r in zip(self.high, other.low, other.high, self.low, reach))


def boxes_apart(a, b, claim, near):
    """Whether no part of one comes near a part of the other at the same time, by boxes and halving alone. `near` are the numbers of
    parts that may: all others are far from each other."""
    reach = [max(r) + a.gap + b.gap for r in zip(*(reach for _, reach in claim.zones(a, b)))]
    rough = [float(r) + SLACK for r in reach]
    looks = MOST_LOOKS

    def apart(p, q, depths):
        nonlocal looks
        if p.is_over_before(q) or q.is_over_before(p) or p.away_from(q, reach, rough):
            return True
        looks -= 1
        require(looks > 0, "boxes alone do not keep them apart, and there is no proof")
        for choice in ((0, 1) if p.size >= q.size else (1, 0)):
            parts = (p, q)[choice].halves() if depths[choice] < MOST_HALVINGS else None
            if parts:
                deeper = tuple(d + (i == choice) for i, d in enumerate(depths))
                return all(apart(part, q, deeper) if choice == 0 else apart(p, part, deeper) for part in parts)
        return False

    return all(apart(a.part(i, claim.parked), b.part(k, claim.parked), (0, 0)) for i, k in near)


def clearly_beyond(zone, gap, side, points):
    """The same as beyond() of all points, in floats: true only where it is true by SLACK."""
    shape, reach = zone
    x, y, z = side
    size = (x * x + y * y + z * z) ** 0.5
    if shape == "cylinder" and z == 0:
        most = float(reach[0])
    else:
        most = sum(abs(n) * float(r) for n, r in zip(side, reach)) / size
    most += float(gap) * (abs(x) + abs(y) + abs(z)) / size + SLACK
    return all((x * p + y * q + z * r) / size > most for p, q, r in points)


def verify_stretch(a, b, times, zones, covers):
    gap = a.gap + b.gap
    if a.fits_floats and b.fits_floats:
        points = [[p - q for p, q in zip(u, v)] for u, v in zip(a.roughly_over(*times), b.roughly_over(*times))]
        if all(is_clear(points, zone, gap, cover) for zone, cover in zip(zones, covers)):
            return
    points = [[p - q for p, q in zip(u, v)] for u, v in zip(a.over(*times), b.over(*times))]
    for zone, cover in zip(zones, covers):
        verify_cover(points, zone, gap, cover)


def is_clear(points, zone, gap, cover):
    """Whether floats show a cover of one piece: most stretches have one, far beyond its side."""
    if type(cover) is not dict or cover.get("pieces") != [0] or type(cover["pieces"][0]) is not int:
        return False
    sides = cover.get("sides")
    return type(sides) is list and len(sides) == 1 and clearly_beyond(zone, gap, side_of(sides[0]), points)


def verify_pair(a, b, claim, proofs):
    proof = entries(proofs, "stretches")
    times = stretches(a, b, claim.parked)
    require(len(proof) == len(times), f"there are {len(times)} stretches, and proofs of {len(proof)}")
    zones = claim.zones(a, b)
    for stretch, covers in zip(times, proof):
        require(type(covers) is list and len(covers) == len(zones), "each zone must have a cover")
        verify_stretch(a, b, stretch, zones, covers)


class Traffic:
    """Which flights may come near each other: their parts in cells of time and place, in floats."""

    def __init__(self, flights, claim):
        self.parked = claim.parked
        self.parts = [list(f.rough_parts(claim.parked)) for f in flights]
        gap = 2 * max(float(f.gap) for f in flights)
        self.reach = [r + gap + SLACK for r in claim.widest()]
        self.first = min(float(f.joints[0]) for f in flights) - 1
        self.last = max(float(f.joints[-1]) for f in flights) + 1
        self.cells, self.everywhere = {}, []
        for i, (flight, parts) in enumerate(zip(flights, self.parts)):
            if not flight.fits_floats or not self.add(i, parts):
                self.everywhere.append(i)
        self.beyond_floats = {i for i, flight in enumerate(flights) if not flight.fits_floats}

    def add(self, i, parts):
        """False if the flight is in too many cells."""
        for begin, end, low, high in parts:
            times = max(begin, self.first) - SLACK, min(end, self.last) + SLACK
            spans = [times, *((l - r / 2, h + r / 2) for l, h, r in zip(low[:2], high[:2], self.reach))]
            ranges = [range(int(a // size), int(b // size) + 1) for (a, b), size in zip(spans, CELL)]
            if len(ranges[0]) * len(ranges[1]) * len(ranges[2]) > MANY_CELLS:
                return False
            for cell in itertools.product(*ranges):
                known = self.cells.setdefault(cell, [])
                if not known or known[-1] != i:
                    known.append(i)
        return True

    def pairs(self):
        """Pairs (i, k) of flights, i < k, that have a cell in common."""
        found = {pair for known in self.cells.values() for pair in itertools.combinations(known, 2)}
        count = len(self.parts)
        found.update((min(i, k), max(i, k)) for i in self.everywhere for k in range(count) if i != k)
        return found

    def near(self, i, k):
        """The numbers of parts that may be near each other at the same time."""
        parts, others = self.parts[i], self.parts[k]
        if self.beyond_floats & {i, k}:
            return list(itertools.product(range(len(parts)), range(len(others))))
        out, first = [], 0
        for p, (begin, end, low, high) in enumerate(parts):
            while first < len(others) and others[first][1] + SLACK < begin:
                first += 1
            for q in range(first, len(others)):
                since, _, lower, higher = others[q]
                if end + SLACK < since:
                    break
                if all(h + r >= l and u + r >= m for h, l, u, m, r in zip(high, lower, higher, low, self.reach)):
                    out.append((p, q))
        return out


def records_of(path):
    """Each record of a file of JSON Lines, with its place: (row, offset, length)."""
    offset, row = 0, 0
    with open(path, "rb") as file:
        for row, line in enumerate(file, 1):
            place, offset = (row, offset, len(line)), offset + len(line)
            if line.strip(b" \t\r\n"):
                yield record_at(path, place, line), place
    require(offset, f"{path}: there is no record")


def record_at(path, place, line=None):
    if line is None:
        with open(path, "rb") as file:
            file.seek(place[1])
            line = file.read(place[2])
    try:
        return an_object(strict_json(line.decode("utf-8")), "a line")
    except (Refused, RecursionError, ValueError) as reason:
        raise Refused(f"{path}:{place[0]}: {reason}") from None


def read_records(path):
    out = [record for record, _ in records_of(path)]
    require(out, f"{path}: there is no record")
    return out


def read_flights(path):
    """The flights of a file, and the records without their segments."""
    flights, records = [], []
    for record, _ in records_of(path):
        text(record, "id", "a record")
        require(record.get("type") == "trajectory" and record.get("status") == "solved", f"{record['id']} is no solved trajectory")
        flights.append(Flight(record))
        records.append({key: value for key, value in record.items() if key != "segments"})
    require(records, f"{path}: there is no record")
    require(len({record["id"] for record in records}) == len(records), "an id stands twice")
    return flights, records


def read_certificate(path, flights):
    """Where the proof of each pair stands, and the line of the claim."""
    order, proofs, claims = {f.id: i for i, f in enumerate(flights)}, {}, []
    for line, place in records_of(path):
        if line.get("type") == "together":
            claims.append(line)
        if line.get("type") != "apart":
            continue
        ids = entries(line.get("ids"), "ids")
        require(len(ids) == 2 and all(type(i) is str and i in order for i in ids), f"no such flights: {ids}")
        at = order[ids[0]], order[ids[1]]
        require(at[0] < at[1] and at not in proofs, f"a pair stands twice, or the wrong way round: {ids}")
        proofs[at] = place
    require(len(claims) == 1, "the certificate must have one line that says what is claimed")
    return proofs, claims[0]


class Pairs:
    """All pairs that may come near each other, or have a proof."""

    def __init__(self, flights, claim, path, proofs):
        self.flights, self.claim, self.path, self.proofs = flights, claim, path, proofs
        self.traffic = Traffic(flights, claim)
        self.all = sorted(proofs.keys() | self.traffic.pairs())

    def trouble(self, pair):
        """Why one of them is refused, or nothing."""
        a, b = (self.flights[i] for i in pair)
        try:
            if pair in self.proofs:
                verify_pair(a, b, self.claim, record_at(self.path, self.proofs[pair]).get("stretches"))
                return None
            near = self.traffic.near(*pair)
            require(not near or boxes_apart(a, b, self.claim, near), "they come near each other, and no proof says how near")
        except Refused as reason:
            return f"{a.id} and {b.id}: {reason}"
        return None

    def first_trouble(self, first):
        """Of every SHARES-th pair: the place of the first that is refused, and why."""
        for i in range(first, len(self.all), SHARES):
            why = self.trouble(self.all[i])
            if why:
                return i, why
        return None

    def verify(self):
        troubles = sorted(trouble for trouble in on_all_cores(self.first_trouble, min(SHARES, len(self.all))) if trouble)
        require(not troubles, troubles and troubles[0][1])


def verify(records_path, certificate_path):
    flights, records = read_flights(records_path)
    proofs, line = read_certificate(certificate_path, flights)
    claim = Claim(line, flights, records)
    Pairs(flights, claim, certificate_path, proofs).verify()
    return len(flights), len(proofs), line


def rooms_of(line):
    """What a distance between vehicles stands on: half sizes with the margin, metres."""
    return f" of the rooms {dict(zip(line['flights'], line['rooms']))}" if line["separation"] == "vehicles" else ""


def verify_files(records_path, certificate_path):
    """Prints what came of it, and says how many were refused."""
    try:
        flights, proofs, line = verify(records_path, certificate_path)
    except Refused as reason:
        print(f"refused: {reason}")
        return 1
    ends = "each on its pad before and after, for the others" if line["parked"] == "pad" else "each gone before and after"
    print(f"{flights} flights keep apart from each other at every instant, {ends}: separation {line['separation']}{rooms_of(line)}, "
          f"downwash {line.get('downwash')}; {proofs} pairs by their own proof, the others by boxes; nothing is said of a map")
    return 0


if __name__ == "__main__":
    run_main(__doc__, 2, verify_files)
