"""ground_agreement.py TOOLS POINTS SEED: random points over a height model, held in exact numbers against the boxes that
skyway-map --agl made. Exit 1 when a point that is free in the map is too low or too high over the ground, whether a cell
has its height all over or its middle alone, with straight slopes between, and wherever the ground is within the model's error."""

import pathlib
import random
import subprocess
import sys
import tempfile
from fractions import Fraction

import numpy
from osgeo import gdal

gdal.UseExceptions()
CELLS, SIDE, ERROR, LOW, HIGH = 60, 7.5, Fraction(3, 4), 30, 120


def write_model(path, seed):
    """In the map's own metres, so that no projection rounds. Heights are float32: exact."""
    rnd = numpy.random.default_rng(seed)
    y, x = numpy.mgrid[0:CELLS, 0:CELLS]
    heights = 300 + 25 * numpy.sin(x / 6) + 20 * numpy.cos(y / 9) + rnd.uniform(-3, 3, (CELLS, CELLS))
    heights[40:, 40:] += 60  # a cliff
    heights = heights.astype("float32")
    out = gdal.GetDriverByName("GTiff").Create(str(path), CELLS, CELLS, 1, gdal.GDT_Float32)
    out.SetGeoTransform([0, SIDE, 0, CELLS * SIDE, 0, -SIDE])
    out.GetRasterBand(1).WriteArray(heights)
    out = None
    return heights


def grounds(heights, x, y):
    """Both readings, as fractions."""
    u = Fraction(x) / Fraction(SIDE)
    v = CELLS - Fraction(y) / Fraction(SIDE)
    cell = lambda i, j: Fraction(float(heights[min(max(j, 0), CELLS - 1), min(max(i, 0), CELLS - 1)]))
    yield cell(min(int(u), CELLS - 1), min(int(v), CELLS - 1))
    u, v = u - Fraction(1, 2), v - Fraction(1, 2)
    i, j = u.__floor__(), v.__floor__()
    a, b = u - i, v - j
    yield ((1 - a) * (1 - b) * cell(i, j) + a * (1 - b) * cell(i + 1, j) + (1 - a) * b * cell(i, j + 1) +
           a * b * cell(i + 1, j + 1))


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
        heights = write_model(folder / "ground.tif", seed)
        top = CELLS * SIDE
        (folder / "one.csv").write_text("min_x_m,min_y_m,min_z_m,max_x_m,max_y_m,max_z_m,label\n1,1,0,2,2,400,\n")

        def run(*words):
            subprocess.run([str(w) for w in words], check=True)
        run(tools / "skyway-import", folder / "one.csv", f"--bounds=0,0,0,{top},{top},600", "-q", "-o", folder / "base.boxmap")
        run(tools / "skyway-footprints", folder / "ground.tif", "--ground-of", folder / "base.boxmap", "--cell", 5,
            "--vertical-error", float(ERROR), "-q", "-o", folder / "base.ground")
        # The model ends where the map does, so the cells around it are holes; none is within the bounds.
        run(tools / "skyway-map", "patch", folder / "base.boxmap", "--ground-model", folder / "base.ground", "--agl",
            f"{LOW},{HIGH}", "--step", 1, "-q", "-o", folder / "agl.boxmap")
        boxes = numpy.load(folder / "agl.boxmap")["boxes"]
        rnd = random.Random(seed)
        points = numpy.array([[rnd.uniform(0, top), rnd.uniform(0, top), 0] for _ in range(count)])
        column = numpy.minimum((points[:, 0] / SIDE).astype(int), CELLS - 1)
        row = numpy.minimum((CELLS - points[:, 1] / SIDE).astype(int), CELLS - 1)
        # Near the limits, where it is hard.
        points[:, 2] = heights[row, column] + numpy.array([rnd.choice((LOW, HIGH)) + rnd.gauss(0, 8) for _ in range(count)])
        within = free(boxes, points)
        wrong = closed = 0
        for (x, y, z), is_free in zip(points.tolist(), within.tolist()):
            fits = all(LOW + ERROR < Fraction(z) - g < HIGH - ERROR for g in grounds(heights, x, y))
            wrong += is_free and not fits
            closed += fits and not is_free
        print(f"points {count} free {int(within.sum())} wrongly_free {wrong} closed_within {closed} boxes {len(boxes)}")
        return 0 if wrong == 0 and within.sum() > count / 20 else 1


if __name__ == "__main__":
    sys.exit(main())
