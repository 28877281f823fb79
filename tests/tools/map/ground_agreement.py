"""ground_agreement.py TOOLS POINTS SEED [MODEL]: random points over a height model, held in exact numbers against the boxes that
skyway-map --agl made. Exit 1 when a point that is free in the map is too low or too high over the ground, whether a cell
has its height all over or its middle alone, with straight slopes between, and wherever the ground is within the model's error.
MODEL is a GeoTIFF in metres with square cells and a projection; without it one is made up. Where it has a hole no point is free."""

import pathlib
import random
import subprocess
import sys
import tempfile
from fractions import Fraction

import numpy
from osgeo import gdal, osr

gdal.UseExceptions()
osr.UseExceptions()
CELLS, SIDE, ERROR, LOW, HIGH = 60, 7.5, Fraction(3, 4), 30, 120


class MadeUp:
    """In the map's own metres, so that no projection rounds. Heights are float32: exact."""

    def __init__(self, folder, seed):
        rnd = numpy.random.default_rng(seed)
        y, x = numpy.mgrid[0:CELLS, 0:CELLS]
        heights = 300 + 25 * numpy.sin(x / 6) + 20 * numpy.cos(y / 9) + rnd.uniform(-3, 3, (CELLS, CELLS))
        heights[40:, 40:] += 60  # a cliff
        self.heights = heights.astype("float32")
        self.path, top = folder / "ground.tif", CELLS * SIDE
        out = gdal.GetDriverByName("GTiff").Create(str(self.path), CELLS, CELLS, 1, gdal.GDT_Float32)
        out.SetGeoTransform([0, SIDE, 0, top, 0, -SIDE])
        out.GetRasterBand(1).WriteArray(self.heights)
        out = None
        self.bounds, self.cell = (0, 0, top, top), 5

    def map(self, tools, folder):
        """What makes a map, but for its bounds."""
        (folder / "one.csv").write_text("min_x_m,min_y_m,min_z_m,max_x_m,max_y_m,max_z_m,label\n1,1,251,2,2,400,\n")
        return tools / "skyway-import", folder / "one.csv"

    def cells_at(self, points):
        """Columns and rows of places, counted from the upper left corner of the model."""
        return [(Fraction(x) / Fraction(SIDE), CELLS - Fraction(y) / Fraction(SIDE)) for x, y in points]


class Given:
    """Of a file: the map's origin is its middle, and the map ends before it does."""

    def __init__(self, path):
        data = gdal.Open(str(path))
        band, (self.left, self.side, skew, self.top, _, down) = data.GetRasterBand(1), data.GetGeoTransform()
        assert skew == 0 and down == -self.side, "the cells are not square"
        self.path, heights = path, band.ReadAsArray().astype(float)
        if band.GetNoDataValue() is not None:
            heights[heights == band.GetNoDataValue()] = numpy.nan
        self.heights = heights
        of_file = data.GetSpatialRef()
        of_file.SetAxisMappingStrategy(osr.OAMS_TRADITIONAL_GIS_ORDER)
        rows, columns = heights.shape
        middle = self.left + columns * self.side / 2, self.top - rows * self.side / 2
        degrees = osr.SpatialReference()
        degrees.ImportFromEPSG(4326)
        degrees.SetAxisMappingStrategy(osr.OAMS_TRADITIONAL_GIS_ORDER)
        longitude, latitude, _ = osr.CoordinateTransformation(of_file, degrees).TransformPoint(*middle)
        latitude, longitude = round(latitude, 7), round(longitude, 7)
        of_map = osr.SpatialReference()
        of_map.ImportFromProj4(f"+proj=tmerc +lat_0={latitude} +lon_0={longitude} +k=1 +x_0=0 +y_0=0 +datum=WGS84 +units=m +no_defs")
        self.to_file = osr.CoordinateTransformation(of_map, of_file)
        east, north = (n * self.side / 2 - 10 for n in (columns, rows))  # grid north may be another
        self.bounds, self.origin, self.cell = (-east, -north, east, north), f"{latitude},{longitude}", 1

    def map(self, tools, folder):
        """Of the same heights, each as a box."""
        return tools / "skyway-footprints", self.path, "--origin", self.origin

    def cells_at(self, points):
        places = self.to_file.TransformPoints([(x, y) for x, y in points])
        side = Fraction(self.side)
        return [((Fraction(x) - Fraction(self.left)) / side, (Fraction(self.top) - Fraction(y)) / side) for x, y, _ in places]


def grounds(heights, u, v):
    """Both readings of a place, as fractions; None where nothing is known. Next to a hole there is no slope to read."""
    rows, columns = heights.shape

    def cell(i, j):
        height = float(heights[min(max(j, 0), rows - 1), min(max(i, 0), columns - 1)])
        return Fraction(height) if height == height else None
    here = cell(min(int(u), columns - 1), min(int(v), rows - 1))
    yield here
    u, v = u - Fraction(1, 2), v - Fraction(1, 2)
    i, j = u.__floor__(), v.__floor__()
    a, b = u - i, v - j
    around = [cell(i, j), cell(i + 1, j), cell(i, j + 1), cell(i + 1, j + 1)]
    shares = [(1 - a) * (1 - b), a * (1 - b), (1 - a) * b, a * b]
    yield here if None in around else sum(share * one for share, one in zip(shares, around))


def free(boxes, points):
    """Whether each point is in no closed box, by strips of x."""
    out = numpy.ones(len(points), bool)
    order = numpy.argsort(points[:, 0])
    sorted_x = points[order, 0]
    for box in boxes:
        some = order[numpy.searchsorted(sorted_x, box[0]):numpy.searchsorted(sorted_x, box[3], "right")]
        p = points[some]
        out[some[(p[:, 1] >= box[1]) & (p[:, 1] <= box[4]) & (p[:, 2] >= box[2]) & (p[:, 2] <= box[5])]] = False
    return out


def main():
    tools, count, seed = pathlib.Path(sys.argv[1]), int(sys.argv[2]), int(sys.argv[3])
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        model = Given(pathlib.Path(sys.argv[4])) if len(sys.argv) > 4 else MadeUp(folder, seed)
        heights, (west, south, east, north) = model.heights, model.bounds
        on_ground = float(numpy.nanmean(heights))
        floor, ceiling = float(numpy.nanmin(heights)) - 50, float(numpy.nanmax(heights)) + 200

        def run(*words):
            subprocess.run([str(w) for w in words], check=True)
        run(*model.map(tools, folder), f"--bounds={west},{south},{floor},{east},{north},{ceiling}", "-q", "-o", folder / "base.boxmap")
        run(tools / "skyway-footprints", model.path, "--ground-of", folder / "base.boxmap", "--cell", model.cell,
            "--vertical-error", float(ERROR), "-q", "-o", folder / "base.ground")
        # A made-up model ends where the map does, so the cells around it are holes; none is within the bounds.
        run(tools / "skyway-map", "patch", folder / "base.boxmap", "--ground-model", folder / "base.ground", "--agl",
            f"{LOW},{HIGH}", "--step", 1, *["--close-unknown"] * bool(numpy.isnan(heights).any()), "-q", "-o", folder / "agl.boxmap")
        boxes = numpy.load(folder / "agl.boxmap")["boxes"]
        rnd = random.Random(seed)
        points = numpy.array([[rnd.uniform(west, east), rnd.uniform(south, north), 0] for _ in range(count)])
        cells = model.cells_at(points[:, :2].tolist())
        at = [(min(int(v), heights.shape[0] - 1), min(int(u), heights.shape[1] - 1)) for u, v in cells]
        below = numpy.nan_to_num(heights[tuple(numpy.array(at).T)], nan=on_ground)
        # Near the limits, where it is hard.
        points[:, 2] = below + numpy.array([rnd.choice((LOW, HIGH)) + rnd.gauss(0, 8) for _ in range(count)])
        within = free(boxes, points)
        wrong = closed = unknown = 0
        for (_, _, z), cell, is_free in zip(points.tolist(), cells, within.tolist()):
            readings = list(grounds(heights, *cell))
            unknown += None in readings
            fits = all(g is not None and LOW + ERROR < Fraction(z) - g < HIGH - ERROR for g in readings)
            wrong += is_free and not fits
            closed += fits and not is_free
        print(f"points {count} free {int(within.sum())} wrongly_free {wrong} closed_within {closed} over_holes {unknown} boxes {len(boxes)}")
        return 0 if wrong == 0 and within.sum() > count / 20 else 1


if __name__ == "__main__":
    sys.exit(main())
