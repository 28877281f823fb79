"""verify_together.py RECORDS CERTIFICATES: follows in exact fractions why flights keep apart from one another.

RECORDS are trajectories and CERTIFICATES what `skyway-check --together --certificate` wrote of them (JSON Lines).
That each flight is clear of its map is verify_certificate.py's affair. Nothing is taken on trust: joints, stretches
and zones are worked out of the records, each piece is looked at, and each pair without a proof is shown to be apart
by boxes in space and time. Exit 0 when all pairs are shown to be apart; 1 when not, with the reason; 2 for wrong
usage; 3 when a file cannot be read as what it should be. docs/certificates.md says what is checked.
"""

from fractions import Fraction as F

from verify_certificate import (LONGEST, SHORTEST, Refused, an_object, bounding_box, entries, halves, number,
                                numbers, pieces, require, run_main, same_epoch, strict_json, text)

MOST_HALVINGS = 12
MOST_LOOKS = 20000
SLACK = 1e-6  # m: of the boxes in floats that pass by quickly what is clearly far away


class Flight:
    """A trajectory with its joints, exact."""

    def __init__(self, record):
        self.id = record["id"]
        self.segments = []
        for i, segment in enumerate(entries(record.get("segments"), "segments")):
            segment = an_object(segment, f"segments[{i}]")
            axes = [numbers(segment.get(axis), 8, f"segments[{i}].{axis}") for axis in "xyz"]
            length = number(segment.get("duration"), "a duration", SHORTEST, LONGEST)
            self.segments.append((F(length), [[F(c) for c in p] for p in zip(*axes)]))
        require(self.segments, "a trajectory has no segments")
        said = [record[key] for key in ("start", "earliest") if record.get(key) is not None]
        first = said[0] if said else 0
        self.joints = [F(number(first, "start", -LONGEST, LONGEST))]
        for length, _ in self.segments:
            self.joints.append(self.joints[-1] + length)
        steps = [abs(a - b) for (_, p), (_, q) in zip(self.segments, self.segments[1:]) for a, b in zip(p[-1], q[0])]
        self.gap = max(steps, default=F(0))
        self.made = {}

    def over(self, begin, end):
        """Control points from one time to another, between which there is no joint; at rest where it is parked."""
        if end <= self.joints[0]:
            return [self.segments[0][1][0]] * 8
        if begin >= self.joints[-1]:
            return [self.segments[-1][1][-1]] * 8
        i = next(i for i, t in enumerate(self.joints[1:]) if t > begin)
        (length, points), start = self.segments[i], self.joints[i]
        points = cut(points, (end - start) / length)[0]
        return cut(points, (begin - start) / (end - start))[1]

    def parts(self, parked):
        """Each segment and, on pads, each rest."""
        if parked not in self.made:
            out = [Part(t, t + length, points) for t, (length, points) in zip(self.joints, self.segments)]
            if parked == "pad":
                out.append(Part(None, self.joints[0], [self.segments[0][1][0]]))
                out.append(Part(self.joints[-1], None, [self.segments[-1][1][-1]]))
            self.made[parked] = out
        return self.made[parked]


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


def boxes_apart(a, b, claim):
    """Whether no part of one comes near a part of the other at the same time, by boxes and halving alone."""
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

    return all(apart(p, q, (0, 0)) for p in a.parts(claim.parked) for q in b.parts(claim.parked))


def verify_pair(a, b, claim, proofs):
    proof = entries(proofs, "stretches")
    times = stretches(a, b, claim.parked)
    require(len(proof) == len(times), f"there are {len(times)} stretches, and proofs of {len(proof)}")
    zones = claim.zones(a, b)
    for (begin, end), covers in zip(times, proof):
        require(type(covers) is list and len(covers) == len(zones), "each zone must have a cover")
        points = [[p - q for p, q in zip(u, v)] for u, v in zip(a.over(begin, end), b.over(begin, end))]
        for zone, cover in zip(zones, covers):
            verify_cover(points, zone, a.gap + b.gap, cover)


def read_records(path):
    out = []
    with open(path, encoding="utf-8", newline="\n") as file:
        for row, line in enumerate(file, 1):
            if not line.strip(" \t\r\n"):
                continue
            try:
                out.append(an_object(strict_json(line), "a line"))
            except (Refused, RecursionError, ValueError) as reason:
                raise Refused(f"{path}:{row}: {reason}") from None
    require(out, f"{path}: there is no record")
    return out


def read_certificate(path, flights):
    """Proofs by pair, and the line of the claim."""
    order, proofs, claims = {f.id: i for i, f in enumerate(flights)}, {}, []
    for line in read_records(path):
        if line.get("type") == "together":
            claims.append(line)
        if line.get("type") != "apart":
            continue
        ids = entries(line.get("ids"), "ids")
        require(len(ids) == 2 and all(type(i) is str and i in order for i in ids), f"no such flights: {ids}")
        at = order[ids[0]], order[ids[1]]
        require(at[0] < at[1] and at not in proofs, f"a pair stands twice, or the wrong way round: {ids}")
        proofs[at] = line.get("stretches")
    require(len(claims) == 1, "the certificate must have one line that says what is claimed")
    return proofs, claims[0]


def verify(records_path, certificate_path):
    records = read_records(records_path)
    for record in records:
        text(record, "id", "a record")
        require(record.get("type") == "trajectory" and record.get("status") == "solved",
                f"{record['id']} is no solved trajectory")
    require(len({record["id"] for record in records}) == len(records), "an id stands twice")
    flights = [Flight(record) for record in records]
    proofs, line = read_certificate(certificate_path, flights)
    claim = Claim(line, flights, records)
    for i, a in enumerate(flights):
        for k in range(i + 1, len(flights)):
            b = flights[k]
            try:
                if (i, k) in proofs:
                    verify_pair(a, b, claim, proofs[i, k])
                else:
                    require(boxes_apart(a, b, claim), "they come near each other, and no proof says how near")
            except Refused as reason:
                raise Refused(f"{a.id} and {b.id}: {reason}") from None
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
