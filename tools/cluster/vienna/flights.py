"""The flights of Metropolis-2 as queries, and what is worked out of them. Standard library alone.

flights.py queries FLIGHTS.csv FOLDER [COUNT]   the first COUNT in the order in which they were filed
flights.py bounds FOLDER                        of the blocks and all pads, 200 m wider, on stdout
flights.py loiterers FOLDER FILE ...            records of the flights that have a geofence
flights.py fences FOLDER                        geofences of these from their arrival on, no-fly volumes
flights.py merge FOLDER FILE ...                records of several files in the order of the queries; of
                                                equal ids that of the last
flights.py patient FOLDER SECONDS LONGER        trajectories.jsonl where each may wait so many seconds, those that
                                                were refused in a round so far longer
flights.py refused FOLDER ROUND                 how many were refused in it
flights.py summary FOLDER                       what came of it

A row of the table: time filed, id, vehicle, time asked for, origin and destination as (longitude,
latitude), priority from 1 to 4, and of loitering missions a geofence: for how many seconds from their
arrival on, west, east, south, north.
"""

import csv
import json
import os
import pathlib
import sys

ABOVE_GROUND = 2  # metres: where flights begin and end
AROUND = 200  # metres beyond the hull of blocks and pads
CEILING = 120  # metres
FIRST = 9  # a priority above all others
EPOCH = os.environ["EPOCH"]


def seconds(text):
    hours, minutes, rest = text.split(":")
    return 3600 * int(hours) + 60 * int(minutes) + float(rest)


def place(text):
    longitude, latitude = (float(x) for x in text.strip("()").split(","))
    return f"{latitude!r}N,{longitude!r}E,{ABOVE_GROUND}"


def rows(table, count=None):
    with open(table, newline="", encoding="utf-8") as file:
        found = sorted(csv.reader(file), key=lambda row: seconds(row[0]))  # stable
    return found[:count]


def write(path, lines):
    partial = path.with_suffix(".partial")
    partial.write_text("".join(line if line.endswith("\n") else line + "\n" for line in lines))
    partial.rename(path)


def queries(table, folder, count):
    found = rows(table, count)
    by_vehicle = {}
    pads = set()
    for filed, name, vehicle, asked, origin, destination, priority, *_ in rows(table):
        pads.update((place(origin), place(destination)))
    for filed, name, vehicle, asked, origin, destination, priority, *_ in found:
        query = {"id": name, "from": place(origin), "to": place(destination),
                 "earliest": seconds(asked), "priority": int(priority), "epoch": EPOCH}
        by_vehicle.setdefault(vehicle, []).append(json.dumps(query))
    for vehicle, lines in by_vehicle.items():
        write(folder / f"queries.{vehicle}.jsonl", lines)
    write(folder / "pads.jsonl", [json.dumps({"point": pad}) for pad in sorted(pads)])
    write(folder / "order.txt", [row[1] for row in found])
    fences = [{"id": row[1], "seconds": float(row[7]), "sides": [float(x) for x in row[8:12]]}
              for row in found if any(row[7:])]
    write(folder / "geofences.jsonl", [json.dumps(fence) for fence in fences])


def bounds(folder):
    low = [float("inf")] * 2
    high = [-float("inf")] * 2
    for line in (folder / "pads.metres").read_text().splitlines():
        point = json.loads(line)["point"]
        low = [min(a, b) for a, b in zip(low, point)]
        high = [max(a, b) for a, b in zip(high, point)]
    info = {}
    for line in (folder / "blocks.info").read_text().splitlines():
        key, _, value = line.partition(": ")
        info[key] = value
    low = [min(a, b) for a, b in zip(low, json.loads(info["bounds_min_m"]))]
    high = [max(a, b) for a, b in zip(high, json.loads(info["bounds_max_m"]))]
    corners = [low[0] - AROUND, low[1] - AROUND, 0, high[0] + AROUND, high[1] + AROUND, CEILING]
    print(",".join(f"{x:.0f}" for x in corners))


def name_of(line):
    """The id stands near the front of every record."""
    begin = line.index(b'"id":') + 5
    return json.loads(line[begin:line.index(b",", begin)])


def geofences(folder):
    return {fence["id"]: fence
            for fence in map(json.loads, (folder / "geofences.jsonl").read_text().splitlines())}


def loiterers(folder, files):
    wanted = geofences(folder)
    for file in files:
        with open(file, "rb") as stream:
            sys.stdout.buffer.writelines(line for line in stream if name_of(line) in wanted)


def fences(folder):
    """Each opens for all others a second after its own flight arrived, and is then gone. That flight's
    departure stays as it is: what departs after it goes around."""
    wanted = geofences(folder)
    volumes = []
    pinned = []
    for line in (folder / "loiterers.jsonl").read_text().splitlines():
        flight = json.loads(line)
        start = flight["start"]
        begin = start + flight["duration"] + 1
        west, east, south, north = wanted[flight["id"]]["sides"]
        corners = [[west, south], [east, south], [east, north], [west, north], [west, south]]
        volumes.append({
            "type": "Feature", "geometry": {"type": "Polygon", "coordinates": [corners]},
            "properties": {"name": flight["id"], "from": begin,
                           "until": begin - 1 + wanted[flight["id"]]["seconds"]}})
        flight.update(priority=FIRST, earliest=start, latest=start)
        pinned.append(json.dumps(flight))
    write(folder / "pinned.jsonl", pinned)
    write(folder / "fences.geojson", [json.dumps({"type": "FeatureCollection", "epoch": EPOCH, "features": volumes})])


def merge(folder, files):
    order = {name: i for i, name in enumerate((folder / "order.txt").read_text().split())}
    where = {}  # of each record: its place in the order, its file, begin and length
    for file in files:
        with open(file, "rb") as stream:
            begin = 0
            for line in stream:
                name = name_of(line)
                where[name] = (order[name], file, begin, len(line))
                begin += len(line)
    streams = {file: open(file, "rb") for file in files}
    for _, file, begin, length in sorted(where.values()):
        streams[file].seek(begin)
        sys.stdout.buffer.write(streams[file].read(length))


def patient(folder, seconds, longer):
    wanted = {flight["id"] for file in folder.glob("round-*.report.json")
              for flight in json.loads(file.read_text())["refused"]}
    with open(folder / "trajectories.jsonl", "rb") as stream:
        for line in stream:
            begin = line.index(b'"earliest":')
            end = line.index(b",", begin)
            earliest = float(line[begin + 11:end])
            latest = earliest + (longer if name_of(line) in wanted else seconds)
            said = b'"latest":' in line
            sys.stdout.buffer.write(line if said else line[:end] + b',"latest":%r' % latest + line[end:])


def summary(folder):
    report = json.loads((folder / "fleet.report.json").read_text())
    together = {}
    for line in (folder / "together.jsonl").read_text().splitlines():
        record = json.loads(line)
        if record.get("type") == "together":
            together = record
    delay = report["delay"]
    print(f"flights {report['flights']}, departing {report['departing']}, "
          f"refused {len(report['refused'])}, by another way {len(report['rerouted'])}")
    print(f"delay mean {delay['mean']:.2f} s, p95 {delay['p95']:.2f} s, most {delay['max']:.2f} s")
    print(f"pairs {report['pairs']}, near in space and time {report['near']}, "
          f"with a forbidden difference {report['conflicting']}")
    print(f"everybody at the asked time: {report['as_asked']['conflicts']} pairs too near")
    print(f"proved apart: {together.get('ok')}, {together.get('near')} pairs looked at, "
          f"{together.get('pieces')} pieces")
    print("beyond the blocks no buildings are known, and none are in the map")
    if geofences(folder):
        alone = [json.loads(line) for line in (folder / "loiterers.jsonl").read_text().splitlines()]
        waited = sum(flight["start"] - flight["earliest"] for flight in alone)
        print(f"geofences, closed to all others from a second after their own flight arrived: {len(alone)}; "
              f"these depart first, and wait {waited:.2f} s in all, which is not in the delay")
    print((folder / "times.txt").read_text(), end="")


def main():
    verb, *rest = sys.argv[1:]
    if verb == "queries":
        queries(rest[0], pathlib.Path(rest[1]), int(rest[2]) if len(rest) > 2 else None)
    elif verb == "bounds":
        bounds(pathlib.Path(rest[0]))
    elif verb == "loiterers":
        loiterers(pathlib.Path(rest[0]), rest[1:])
    elif verb == "fences":
        fences(pathlib.Path(rest[0]))
    elif verb == "patient":
        patient(pathlib.Path(rest[0]), float(rest[1]), float(rest[2]))
    elif verb == "refused":
        print(len(json.loads((pathlib.Path(rest[0]) / f"round-{rest[1]}.report.json").read_text())["refused"]))
    elif verb == "merge":
        merge(pathlib.Path(rest[0]), rest[1:])
    elif verb == "summary":
        summary(pathlib.Path(rest[0]))
    else:
        sys.exit(__doc__)


main()
