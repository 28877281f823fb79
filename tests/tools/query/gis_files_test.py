"""gis_files_test.py TOOLS SOURCE_DIR: GeoTIFFs and GeoPackages as GDAL's own Python reads them.

Needs a Python with osgeo (Debian: python3-gdal), which may be another one than this; without one the test is skipped (77).
Heights and distances are held against answers of skyway-query at random places of each cell, places on Earth against
skyway-export's GeoJSON.
"""

import json
import pathlib
import random
import subprocess
import sys
import tempfile

READER = """
import json, sys
from osgeo import gdal, ogr, osr
gdal.UseExceptions()
kind, path = sys.argv[1:3]
if kind == "tif":
    d = gdal.Open(path)
    s = osr.SpatialReference(wkt=d.GetProjection())
    s.SetAxisMappingStrategy(osr.OAMS_TRADITIONAL_GIS_ORDER)
    e = osr.SpatialReference(); e.ImportFromEPSG(4326); e.SetAxisMappingStrategy(osr.OAMS_TRADITIONAL_GIS_ORDER)
    t = osr.CoordinateTransformation(s, e)
    bands = {}
    for i in range(1, d.RasterCount + 1):
        b = d.GetRasterBand(i)
        bands[b.GetDescription()] = [[None if v != v else v for v in row] for row in b.ReadAsArray().tolist()]
    g = d.GetGeoTransform()
    print(json.dumps({"transform": g, "bands": bands, "corner": t.TransformPoint(g[0], g[3])[:2]}))
else:
    d = ogr.Open(path)
    out = {}
    for layer in d:
        out[layer.GetName()] = [json.loads(f.ExportToJson()) for f in layer]
    print(json.dumps(out))
"""

tools = pathlib.Path(sys.argv[1])
source = pathlib.Path(sys.argv[2])


def reader():
    for python in (sys.executable, "/usr/bin/python3"):
        if subprocess.run([python, "-c", "import osgeo.gdal, numpy"], capture_output=True, check=False).returncode == 0:
            return python
    print("no Python with osgeo")
    sys.exit(77)


def tool(name, *arguments, text=None):
    done = subprocess.run([tools / f"skyway-{name}", *map(str, arguments)], input=text, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    return done.stdout


def read(python, kind, path):
    return json.loads(subprocess.run([python, "-c", READER, kind, path], check=True, capture_output=True, text=True).stdout)


def asked(city, places):
    text = "".join(json.dumps({"point": p}) + "\n" for p in places)
    return [json.loads(line) for line in tool("query", city, "--vehicle", "tello", text=text).splitlines()]


def check_grid(python, where, city, neu):
    cell, z = 20.0, 15.0
    tool("query", city, "--grid", "heights", "--cell", cell, "--vehicle", "tello", "-o", where / "h.tif")
    tool("query", city, "--grid", "distance", "--at-height", z, "--cell", cell, "--vehicle", "tello", "-o", where / "d.tif")
    heights, distances = read(python, "tif", where / "h.tif"), read(python, "tif", where / "d.tif")
    west, _, _, north, _, _ = distances["transform"]
    places, least, free = [], [], []
    grid = distances["bands"]["distance"]
    for row, numbers in enumerate(grid):
        for column, distance in enumerate(numbers):
            east, up = west + cell * (column + random.random()), north - cell * (row + random.random())
            at = [up, east] if neu else [east, up]
            if distance is not None:
                places.append([*at, z])
                least.append(distance)
                free.append(None)
            low, high = heights["bands"]["lowest"][row][column], heights["bands"]["highest"][row][column]
            if high is not None:
                places.append([*at, random.choice((low, high, random.uniform(low, high)))])
                least.append(None)
                free.append(True)
    assert len(places) > 500, len(places)
    for place, distance, is_free, answer in zip(places, least, free, asked(city, places)):
        if distance is not None:
            assert answer["clearance"] >= distance, (place, distance, answer)
        if is_free:
            assert answer["inside_bounds"] and not answer["hit"], (place, answer)
    return heights


def check_package(python, where, city, flights):
    common = ("--origin", "37,-122,30")
    tool("export", city, flights, "--format", "gpkg", *common, "-q", "-o", where / "f.gpkg")
    tables = read(python, "gpkg", where / "f.gpkg")
    assert set(tables) == {"trajectories", "volumes"}, set(tables)
    for row in tables["trajectories"]:
        text = tool("export", city, flights, "--id", row["properties"]["flight"], "--format", "geojson", *common, "-q")
        feature = json.loads(text)["features"][0]
        assert row["geometry"]["coordinates"] == feature["geometry"]["coordinates"]
    for row in tables["volumes"]:
        assert row["properties"]["lower_m"] < row["properties"]["upper_m"]
        assert all(p[2] == row["properties"]["lower_m"] for p in row["geometry"]["coordinates"][0])
    assert len({row["properties"]["flight"] for row in tables["volumes"]}) == len(tables["trajectories"])
    again = (where / "f.gpkg").read_bytes()
    tool("export", city, flights, "--format", "gpkg", *common, "-q", "-o", where / "f.gpkg")
    assert (where / "f.gpkg").read_bytes() == again, "other bytes in another run"


def main():
    random.seed(5)
    python = reader()
    with tempfile.TemporaryDirectory() as name:
        where = pathlib.Path(name)
        tool("import", source / "data/downtown.csv", "-q", "-o", where / "neu.boxmap")
        tool("footprints", source / "data/samples/town.geojson", "--allow-skipped", "--ceiling", "60", "-q", "-o", where / "enu.boxmap")
        check_grid(python, where, where / "neu.boxmap", True)
        check_grid(python, where, where / "enu.boxmap", False)
        flights = where / "flights.jsonl"
        lines = (source / "data/samples/trajectories.jsonl").read_text(encoding="utf-8").splitlines()
        flights.write_text("".join(line.replace('"status"', f'"epoch":"2026-05-04T06:30:00Z","start":{90 * i},"status"', 1) + "\n"
                                   for i, line in enumerate(lines)), encoding="utf-8")
        check_package(python, where, where / "neu.boxmap", flights)
    print("grids and tables are as they were written")


main()
