"""Ground from a small text file, and what an autopilot's terrain makes of it: whole metres at posts of a grid.

The file is an ESRI ASCII grid (.asc) whose corners count in metres east and north of home, and whose heights are metres
above the sea; between its points the ground is bilinear, and beyond its edges it goes on level. GDAL reads such files, too.
"""

import math
import pathlib
import random

METRES = 0.011131884502145034  # ArduPilot's metres to 1e-7 degrees of latitude
AXIS, FLATTENING = 6378137.0, 1 / 298.257223563  # WGS 84
SIDE = 4  # posts of one message along each side
ROW = 8  # such messages in a row of a block of 28 by 32 posts

# How the posts are off the ground: not at all, up or down by chance, in turns, or all of them against those near home.
ERRORS = ("none", "chance", "turns", "up", "down")


def metres_of_degrees(latitude):
    """Metres of a degree north, and of one east, on WGS 84."""
    squared = FLATTENING * (2 - FLATTENING)
    bent = 1 - squared * math.sin(math.radians(latitude)) ** 2
    north = AXIS * (1 - squared) / bent**1.5
    return math.radians(north), math.radians(AXIS / math.sqrt(bent) * math.cos(math.radians(latitude)))


class Ground:
    """Heights at the points of a grid; row 0 is the southern one."""

    def __init__(self, west, south, cell, rows):
        self.west, self.south, self.cell, self.rows = west, south, cell, rows

    def height(self, east, north):
        def at(value, begin, count):
            number = min(max((value - begin) / self.cell, 0.0), count - 1)
            low = min(int(number), count - 2)
            return low, number - low

        (i, x), (j, y) = at(east, self.west, len(self.rows[0])), at(north, self.south, len(self.rows))
        low, high = self.rows[j], self.rows[j + 1]
        return (1 - y) * ((1 - x) * low[i] + x * low[i + 1]) + y * ((1 - x) * high[i] + x * high[i + 1])

    def write(self, path):
        head = (f"ncols {len(self.rows[0])}\nnrows {len(self.rows)}\nxllcenter {self.west:g}\nyllcenter {self.south:g}\n"
                f"cellsize {self.cell:g}\n")
        pathlib.Path(path).write_text(head + "".join(" ".join(f"{z:g}" for z in row) + "\n" for row in reversed(self.rows)))


def read(path):
    words = pathlib.Path(path).read_text(encoding="ascii").split()
    names = ("ncols", "nrows", "xllcenter", "yllcenter", "cellsize")
    if tuple(words[0:10:2]) != names:
        raise ValueError(f"{path}: expected {', '.join(names)} at its beginning.")
    columns, count, west, south, cell = int(words[1]), int(words[3]), *(float(w) for w in words[5:10:2])
    heights = [float(word) for word in words[10:]]
    if len(heights) != columns * count or columns < 2 or count < 2:
        raise ValueError(f"{path}: expected {count} rows of {columns} heights.")
    return Ground(west, south, cell, [heights[k : k + columns] for k in range(0, len(heights), columns)][::-1])


class Posts:
    """The autopilot's terrain: each post is within `error` metres of the ground, and then cut to a whole metre."""

    def __init__(self, ground, home, error=0.0, how="none", seed=0):
        self.ground, self.home, self.error, self.how, self.seed = ground, home, error, how, seed
        self.north, self.east = metres_of_degrees(home[0])

    def place(self, latitude, longitude):
        """East and north of home, of a place in 1e-7 degrees."""
        return (longitude * 1e-7 - self.home[1]) * self.east, (latitude * 1e-7 - self.home[0]) * self.north

    def height(self, latitude, longitude, spacing):
        east, north = self.place(latitude, longitude)
        height = self.ground.height(east, north)
        if self.how == "none":
            return round(height)
        column, row = round(east / spacing), round(north / spacing)
        if self.how == "chance":
            up = random.Random(f"{self.seed} {latitude} {longitude}").random() < 0.5
        elif self.how == "turns":
            up = (column + row + self.seed) % 2 == 0
        else:  # the four posts around home are off the other way
            up = (max(abs(east), abs(north)) > 1.05 * spacing) == (self.how == "up")
        return math.ceil(height + self.error) if up else math.floor(height - self.error)

    def answers(self, request):
        """The fields of each TERRAIN_DATA that a TERRAIN_REQUEST asks for."""
        spacing, scale = request.grid_spacing, max(math.cos(math.radians(request.lat * 1e-7)), 0.01)
        for bit in range(7 * ROW):
            if not request.mask >> bit & 1:
                continue
            data = []
            for x in range(SIDE):
                for y in range(SIDE):
                    north, east = (SIDE * (bit // ROW) + x) * spacing, (SIDE * (bit % ROW) + y) * spacing
                    data.append(self.height(request.lat + round(north / METRES), request.lon + round(east / METRES / scale), spacing))
            yield dict(lat=request.lat, lon=request.lon, grid_spacing=spacing, gridbit=bit, data=data)
