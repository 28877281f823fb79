"""metropolis_paths.py INTENTIONS.csv [COUNT [HOURS]]: the flights of Metropolis-2 (time, id, vehicle, departure, origin and
destination in degrees, priority) as paths in metres around Vienna: straight up from 2 m, level at one of eight
heights by direction (40 to 110 m), straight down; so many hours after one another, each the same. For timing alone: no buildings, and a plane for the Earth."""

import csv
import json
import math
import re
import sys

LATITUDE, LONGITUDE = 48.2, 16.37
NORTH = 111200.0
EAST = 111320.0 * math.cos(math.radians(LATITUDE))


def metres(text):
    longitude, latitude = map(float, re.findall(r"-?[0-9.]+", text))
    return [(longitude - LONGITUDE) * EAST, (latitude - LATITUDE) * NORTH]


def main():
    most = int(sys.argv[2]) if len(sys.argv) > 2 else None
    with open(sys.argv[1], encoding="utf-8", newline="") as file:
        rows = list(csv.reader(file))[:most]
    for later in range(int(sys.argv[3]) if len(sys.argv) > 3 else 1):
        for _, name, _, departure, origin, destination, *_ in rows:
            hours, minutes, seconds = map(int, departure.split(":"))
            a, b = metres(origin), metres(destination)
            direction = math.atan2(b[1] - a[1], b[0] - a[0]) / (2 * math.pi) + 0.5
            height = 40 + 10 * (round(8 * direction) % 8)
            print(json.dumps({"type": "path", "id": f"{name}+{later}" if later else name, "status": "found",
                              "start": 3600 * (hours + later) + 60 * minutes + seconds,
                              "points": [a + [2], a + [height], b + [height], b + [2]]}))


if __name__ == "__main__":
    main()
