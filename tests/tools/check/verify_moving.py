"""verify_moving.py RECORDS MAP.boxmap MOVING CERTIFICATES: follows in exact fractions why flights keep clear of obstacles that move.

RECORDS are trajectories, MOVING the obstacles, and CERTIFICATES what `skyway-check --moving MOVING --certificate` wrote of
them (JSON Lines). That each flight is clear of its map is verify_certificate.py's affair; the map is read for its hash and
frame, which records and obstacles may name. Nothing is taken on trust: each obstacle is held against each flight for all
the time in which both are there, which is worked out of the two files. Exit 0 when all are shown to be clear; 1 when not,
with the reason; 2 for wrong usage; 3 when a file cannot be read as what it should be. docs/certificates.md says what is
checked.
"""

from fractions import Fraction as F

from verify_certificate import (LONGEST, SHORTEST, BoxMap, Refused, an_epoch, an_object, entries, number, numbers,
                                pieces, require, run_main, same_epoch, text)
from verify_together import Flight, read_records

FASTEST = 1e4  # m/s, of an obstacle and of its growth: what the tools read
KEYS = {"type", "id", "epoch", "frame", "map", "from", "until", "min", "max", "velocity", "growth"}
SIDES = ("+x", "-x", "+y", "-y", "+z", "-z")  # of the obstacle, on which the flight is


def a_time(value, what):
    """Seconds after the epoch: 0, or not so near to it that a tool would read it as 0."""
    time = number(value, what, -LONGEST, LONGEST)
    require(time == 0 or abs(time) >= SHORTEST, f"{what} must be 0 or {SHORTEST} or more, found {time}")
    return F(time)


def fractions(values):
    return [F(v) for v in values]


class Obstacle:
    """A closed box that goes straight on, and may grow, from one instant until another."""

    def __init__(self, record):
        self.id = text(record, "id", "an obstacle")
        require(record.get("type") == "moving", f"{self.id} is no obstacle that moves")
        require(set(record) <= KEYS, f"{self.id} has keys that are not known: {sorted(set(record) - KEYS)}")
        self.start, self.end = a_time(record.get("from"), "from"), a_time(record.get("until"), "until")
        require(self.start < self.end, f"{self.id} is there from {self.start} until {self.end}")
        self.low, self.high = (fractions(numbers(record.get(key), 3, key)) for key in ("min", "max"))
        require(all(l <= h for l, h in zip(self.low, self.high)), f"{self.id} has a min above its max")
        velocity = fractions(numbers(record.get("velocity"), 3, "velocity", -FASTEST))
        growth = fractions(numbers(record.get("growth"), 3, "growth", 0))
        require(all(abs(v) <= FASTEST for v in velocity + growth), f"{self.id} is faster than {FASTEST} m/s")
        self.low_speed = [v - g for v, g in zip(velocity, growth)]
        self.high_speed = [v + g for v, g in zip(velocity, growth)]
        self.epoch, self.frame, self.map = (record.get(key) for key in ("epoch", "frame", "map"))

    def corners(self, time):
        later = time - self.start
        return ([c + v * later for c, v in zip(self.low, self.low_speed)], [c + v * later for c, v in zip(self.high, self.high_speed)])


def stretches(flight, obstacle, parked):
    """All time in which both are there, cut where the flight passes a joint; an instant where that is all."""
    begin, end = obstacle.start, obstacle.end
    if parked == "gone":
        begin, end = max(begin, flight.joints[0]), min(end, flight.joints[-1])
    if begin > end:
        return []
    times = sorted({t for t in flight.joints if begin < t < end} | {begin, end})
    return list(zip(times, times[1:])) or [(begin, begin)]


def beyond(flight, obstacle, room, begin, end):
    """Control points of how far the flight is beyond each face, as SIDES names them."""
    reach = [r + flight.gap for r in room]
    points = []
    for i, place in enumerate(flight.over(begin, end)):
        low, high = obstacle.corners(begin + (end - begin) * i / 7)
        points.append([c for l, h, p, r in zip(low, high, place, reach) for c in (p - h - r, l - p - r)])
    return points


def verify_stretch(points, cover):
    require(set(an_object(cover, "a cover")) == {"pieces", "sides"}, "a cover must have pieces and sides")
    sides, count = entries(cover["sides"], "sides"), 0
    for piece in pieces(points, cover["pieces"]):
        require(count < len(sides), "a piece has no side")
        side = sides[count]
        require(type(side) is str and side in SIDES, f"a side must be one of {SIDES}, found {side}")
        require(all(p[SIDES.index(side)] > 0 for p in piece), "a piece is not shown to be beyond the obstacle's face")
        count += 1
    require(count == len(sides), "there are more sides than pieces")


class Claim:
    """What is claimed of all, of the certificate's line, the records and the obstacles."""

    def __init__(self, line, records, flights, obstacles, box_map):
        known = {"type", "flights", "obstacles", "rooms", "parked", "map", "epoch"}
        require(set(line) <= known, f"the claim has keys that are not known: {sorted(set(line) - known)}")
        self.parked = line.get("parked")
        require(self.parked in ("pad", "gone"), "parked must be pad or gone")
        require(entries(line.get("flights"), "flights") == [f.id for f in flights],
                "the flights of the certificate are not those of the records, in order")
        require(entries(line.get("obstacles"), "obstacles") == [o.id for o in obstacles],
                "the obstacles of the certificate are not those of the file, in order")
        require(line.get("map") == box_map.hash, "the certificate is of another map")
        self.require_one_epoch(line, records, obstacles, box_map)
        said = [(r.get("map"), r.get("frame"), r["id"]) for r in records] + [(o.map, o.frame, o.id) for o in obstacles]
        for its_map, frame, name in said:
            require(its_map in (None, box_map.hash, box_map.always_there), f"{name} is of another map")
            require(frame in (None, box_map.frame), f"{name} is in another frame")
        rooms = entries(line.get("rooms"), "rooms")
        require(len(rooms) == len(flights), "each flight must have a room")
        self.rooms = [fractions(numbers(room, 3, "a room", 0)) for room in rooms]
        for room, record in zip(self.rooms, records):
            self.require_room(room, record)

    @staticmethod
    def require_one_epoch(line, records, obstacles, box_map):
        epoch = line.get("epoch")
        require(same_epoch([r.get("epoch") for r in records], epoch, "a record"), "the epoch of a record is another")
        require(same_epoch([o.epoch for o in obstacles], epoch, "an obstacle"), "the epoch of an obstacle is another")
        require(None in (epoch, box_map.epoch) or an_epoch(epoch, "the claim") == box_map.epoch, "the epoch of the map is another")

    @staticmethod
    def require_room(room, record):
        """No less than the record's own half sizes and margin."""
        if "vehicle" not in record:
            return
        half = numbers(an_object(record["vehicle"], "vehicle").get("half"), 3, "half", 0)
        margin = F(number(record.get("margin", 0), "margin", 0))
        require(all(r >= F(h) + margin for r, h in zip(room, half)), f"the room of {record['id']} is less than its vehicle and margin")


def proofs_of(lines, flights, obstacles):
    """Proofs by flight and obstacle, and the line of the claim."""
    flown, moving, proofs, claims = {f.id for f in flights}, {o.id for o in obstacles}, {}, []
    for line in lines:
        if line.get("type") == "clear_of_moving":
            claims.append(line)
        if line.get("type") != "clear_of":
            continue
        require(set(line) == {"type", "ids", "stretches"}, "a proof must have ids and stretches")
        ids = entries(line["ids"], "ids")
        require(len(ids) == 2 and all(type(i) is str for i in ids) and ids[0] in flown and ids[1] in moving,
                f"no such flight and obstacle: {ids}")
        require(tuple(ids) not in proofs, f"a proof stands twice: {ids}")
        proofs[tuple(ids)] = entries(line["stretches"], "stretches")
    require(len(claims) == 1, "the certificate must have one line that says what is claimed")
    return proofs, claims[0]


def read_obstacles(path):
    obstacles = [Obstacle(record) for record in read_records(path)]
    require(len({o.id for o in obstacles}) == len(obstacles), "the id of an obstacle stands twice")
    return obstacles


def read_flights(path):
    records = read_records(path)
    for record in records:
        text(record, "id", "a record")
        require(record.get("type") == "trajectory" and record.get("status") == "solved", f"{record['id']} is no solved trajectory")
        require(record.get("start") is not None, f"{record['id']} does not say when it begins")
    require(len({record["id"] for record in records}) == len(records), "the id of a record stands twice")
    return records, [Flight(record) for record in records]


def verify_one(flight, obstacle, room, parked, proof):
    times = stretches(flight, obstacle, parked)
    require(len(proof) == len(times), f"there are {len(times)} stretches, and proofs of {len(proof)}")
    for (begin, end), cover in zip(times, proof):
        verify_stretch(beyond(flight, obstacle, room, begin, end), cover)


def read(records_path, map_path, moving_path, certificate_path):
    """What the four files say; raises Refused where one is not what it should be."""
    return read_flights(records_path), read_obstacles(moving_path), read_records(certificate_path), BoxMap(map_path)


def follow(records_and_flights, obstacles, lines, box_map):
    """Raises Refused where a flight is not shown to be clear of an obstacle."""
    records, flights = records_and_flights
    proofs, line = proofs_of(lines, flights, obstacles)
    claim = Claim(line, records, flights, obstacles, box_map)
    for flight, room in zip(flights, claim.rooms):
        for obstacle in obstacles:
            require((flight.id, obstacle.id) in proofs, f"there is no proof of {flight.id} and {obstacle.id}")
            try:
                verify_one(flight, obstacle, room, claim.parked, proofs[flight.id, obstacle.id])
            except Refused as reason:
                raise Refused(f"{flight.id} and {obstacle.id}: {reason}") from None
    return len(flights), len(obstacles), line


def verify(*paths):
    return follow(*read(*paths))


def verify_files(*paths):
    """Prints what came of it, and says how many were refused."""
    found = read(*paths)
    try:
        flights, obstacles, line = follow(*found)
    except Refused as reason:
        print(f"refused: {reason}")
        return 1
    print(f"{flights} flights keep clear of {obstacles} obstacles that move, at every instant: parked {line['parked']}, "
          f"rooms {line['rooms']}")
    return 0


if __name__ == "__main__":
    run_main(__doc__, 4, verify_files)
