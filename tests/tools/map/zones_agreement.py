"""zones_agreement.py TOOLS POINTS SEED: zones of airspace read anew, and random points of space and time held
against the boxes that skyway-map made of them: of files with every trap, and of the public ones in SKYWAY_REALDATA. Exit 1
when a point that this script finds in a zone is free in the map.

It shares no code with Skyway: positions go through PROJ, distances through T. Vincenty's formula, the sun through J.
Meeus's (Astronomical Algorithms, chapter 25), times through Python's calendar, and the ground through GDAL."""

import datetime
import json
import math
import os
import pathlib
import random
import subprocess
import sys
import tempfile

import numpy
from osgeo import gdal, osr

gdal.UseExceptions()
UTC = datetime.timezone.utc
FOOT = 0.3048
DAYS = ["MON", "TUE", "WED", "THU", "FRI", "SAT", "SUN"]


def vincenty(lat1, lon1, lat2, lon2):
    """Metres along the ellipsoid (Survey Review 23(176), 1975)."""
    a, f = 6378137.0, 1 / 298.257223563
    b = a * (1 - f)
    u1, u2 = (math.atan((1 - f) * math.tan(math.radians(p))) for p in (lat1, lat2))
    span = math.radians((lon2 - lon1 + 180) % 360 - 180)
    lam = span
    for _ in range(200):
        s = math.hypot(math.cos(u2) * math.sin(lam),
                       math.cos(u1) * math.sin(u2) - math.sin(u1) * math.cos(u2) * math.cos(lam))
        if s == 0:
            return 0.0
        c = math.sin(u1) * math.sin(u2) + math.cos(u1) * math.cos(u2) * math.cos(lam)
        sigma = math.atan2(s, c)
        alpha = math.cos(u1) * math.cos(u2) * math.sin(lam) / s
        k = 1 - alpha * alpha
        m = c - 2 * math.sin(u1) * math.sin(u2) / k if k else 0
        w = f / 16 * k * (4 + f * (4 - 3 * k))
        last, lam = lam, span + (1 - w) * f * alpha * (sigma + w * s * (m + w * c * (-1 + 2 * m * m)))
        if abs(lam - last) < 1e-13:
            break
    v = k * (a * a - b * b) / (b * b)
    big = 1 + v / 16384 * (4096 + v * (-768 + v * (320 - 175 * v)))
    small = v / 1024 * (256 + v * (-128 + v * (74 - 47 * v)))
    d = small * s * (m + small / 4 * (c * (-1 + 2 * m * m) - small / 6 * m * (-3 + 4 * s * s) * (-3 + 4 * m * m)))
    return b * big * (sigma - d)


def sun_height(at, lat, lon):
    """Degrees, without refraction."""
    t = (at.timestamp() - 946728000) / 86400 / 36525
    l0 = 280.46646 + t * (36000.76983 + t * 0.0003032)
    m = math.radians(357.52911 + t * (35999.05029 - t * 0.0001537))
    c = ((1.914602 - t * 0.004817) * math.sin(m) + 0.019993 * math.sin(2 * m) + 0.000289 * math.sin(3 * m))
    true = math.radians(l0 + c - 0.00569 - 0.00478 * math.sin(math.radians(125.04 - 1934.136 * t)))
    tilt = math.radians(23.439291 - t * 0.0130042 + 0.00256 * math.cos(math.radians(125.04 - 1934.136 * t)))
    ra = math.atan2(math.cos(tilt) * math.sin(true), math.cos(true))
    dec = math.asin(math.sin(tilt) * math.sin(true))
    turn = math.radians(280.46061837 + 360.98564736629 * t * 36525 + lon) - ra
    phi = math.radians(lat)
    return math.degrees(math.asin(math.sin(phi) * math.sin(dec) + math.cos(phi) * math.cos(dec) * math.cos(turn)))


def event_of(kind, day, lat, lon):
    """The instant on the sun's day at the place, by bisection; none where there is none."""
    noon = datetime.datetime(day.year, day.month, day.day, 12, tzinfo=UTC) - datetime.timedelta(hours=lon / 15)
    level = -0.833 if kind in ("SR", "SS") else -6
    sign = -1 if kind in ("SR", "BMCT") else 1
    low, high = 0.0, 12.0
    at = lambda hours: noon + datetime.timedelta(hours=sign * hours)
    if sun_height(at(low), lat, lon) < level or sun_height(at(high), lat, lon) > level:
        return None
    for _ in range(50):
        middle = (low + high) / 2
        low, high = (middle, high) if sun_height(at(middle), lat, lon) > level else (low, middle)
    return at(low)


def instant(text):
    return datetime.datetime.fromisoformat(text.replace("Z", "+00:00"))


def time_of(text, day):
    clock = datetime.time.fromisoformat(text.replace("Z", "+00:00")[:8 if text.count(":") > 1 else 5])
    return datetime.datetime.combine(day, clock, UTC)


def daily_is_on(period, at, lat, lon):
    days = period.get("day") or ["ANY"]
    for back in (0, 1, 2):
        day = (at - datetime.timedelta(days=back)).date()
        if "ANY" not in days and DAYS[day.weekday()] not in days:
            continue
        ends = []
        for which in ("start", "end"):
            if period.get(which + "Time"):
                ends.append(time_of(period[which + "Time"], day))
            elif period.get(which + "Event"):
                ends.append(event_of(period[which + "Event"], day, lat, lon))
            else:
                midnight = datetime.datetime.combine(day, datetime.time(), UTC)
                ends.append(midnight if which == "start" else midnight + datetime.timedelta(days=1))
        if None in ends:
            return False
        start, end = ends
        if end <= start:
            end += datetime.timedelta(days=1)
        if start <= at <= end:
            return True
    return False


def is_on(periods, at, lat, lon):
    if not periods:
        return True
    for period in periods:
        if period.get("permanent") == "YES":
            return True
        if period.get("startDateTime") and at < instant(period["startDateTime"]):
            continue
        if period.get("endDateTime") and at > instant(period["endDateTime"]):
            continue
        daily = period.get("schedule") or []
        if not daily or any(daily_is_on(d, at, lat, lon) for d in daily):
            return True
    return False


def in_ring(ring, lon, lat):
    odd = False
    for (x1, y1), (x2, y2) in zip(ring, ring[1:] + ring[:1]):
        if (y1 > lat) != (y2 > lat) and (lon < x1 + (lat - y1) / (y2 - y1) * (x2 - x1)):
            odd = not odd
    return odd


def near(lon, about):
    return about + (lon - about + 180) % 360 - 180


class Volume:
    def __init__(self, shape, lower, upper):
        self.lower, self.upper = lower, upper
        self.circle = self.rings = None
        if "radius" in shape:
            self.circle = shape["center"], float(shape["radius"])
        else:
            self.rings = shape["rings"]

    def box(self):
        if self.circle:
            (lon, lat), radius = self.circle
            dy, dx = radius / 111000, radius / 111000 / math.cos(math.radians(lat))
            return lon - dx, lat - dy, lon + dx, lat + dy
        xs, ys = ([near(p[0], self.rings[0][0][0]) for p in self.rings[0]], [p[1] for p in self.rings[0]])
        return min(xs), min(ys), max(xs), max(ys)

    def holds(self, lon, lat):
        if self.circle:
            (x, y), radius = self.circle
            return vincenty(lat, lon, y, x) <= radius
        about = self.rings[0][0][0]
        rings = [[(near(p[0], about), p[1]) for p in ring] for ring in self.rings]
        return in_ring(rings[0], near(lon, about), lat) and not any(
            in_ring(ring, near(lon, about), lat) for ring in rings[1:])


def limit(value, reference, unit):
    if value is None or float(value) >= 99999:
        return None
    return float(value) * (FOOT if unit.upper() == "FT" else 1), reference


def shapes(geometry):
    if geometry["type"] == "Polygon":
        return [{"rings": geometry["coordinates"]}]
    return [{"rings": rings} for rings in geometry["coordinates"]]


def zones_of(data):
    """(type, volumes, periods) of each zone, however the file has them."""
    if isinstance(data, dict) and data.get("features") and "CEILING" in (data["features"][0].get("properties") or {}):
        for feature in data["features"]:
            top = feature["properties"]["CEILING"] * FOOT, "AGL"
            for shape in shapes(feature["geometry"]):
                yield "REQ_AUTHORIZATION", [Volume(shape, None, top)], []
                yield "PROHIBITED", [Volume(shape, top, None)], []
        return
    listed = data.get("features") or data.get("UASZoneList")
    for zone in listed:
        volumes = []
        if isinstance(zone.get("geometry"), list):
            for one in zone["geometry"]:
                unit, shape = one.get("uomDimensions", "M"), one["horizontalProjection"]
                low = limit(one.get("lowerLimit"), one.get("lowerVerticalReference"), unit)
                high = limit(one.get("upperLimit"), one.get("upperVerticalReference"), unit)
                if shape["type"] == "Circle":
                    volumes.append(Volume(shape, low, high))
                else:
                    volumes += [Volume(s, low, high) for s in shapes(shape)]
            kind = zone["restriction"].replace("SATION", "ZATION")
            yield kind, volumes, zone.get("applicability") or []
            continue
        geometry = zone["geometry"]
        for one in geometry.get("geometries", [geometry]):
            layer = one.get("layer") or geometry.get("layer") or {}
            unit = layer.get("uom", "m")
            low = limit(layer.get("lower"), layer.get("lowerReference"), unit)
            high = limit(layer.get("upper"), layer.get("upperReference"), unit)
            if one["type"] == "Point":
                volumes.append(Volume({"center": one["coordinates"], "radius": one["extent"]["radius"]}, low, high))
            else:
                volumes += [Volume(s, low, high) for s in shapes(one)]
        yield zone["properties"]["type"], volumes, zone["properties"].get("limitedApplicability") or []


class Ground:
    """A raster in longitude and latitude, read between the middles of cells, or by cells."""

    def __init__(self, path, by_cell):
        source = gdal.Open(str(path))
        self.cells, self.at, self.by_cell = source.ReadAsArray().astype(float), source.GetGeoTransform(), by_cell

    def height(self, lon, lat):
        rows, columns = self.cells.shape
        x = (near(lon, self.at[0] + columns / 2 * self.at[1]) - self.at[0]) / self.at[1]
        y = (lat - self.at[3]) / self.at[5]
        if self.by_cell:
            return self.cells[min(rows - 1, int(y)), min(columns - 1, int(x))]
        x, y = min(max(x - 0.5, 0), columns - 1.0), min(max(y - 0.5, 0), rows - 1.0)
        i, j = min(int(x), columns - 2), min(int(y), rows - 2)
        u, v = x - i, y - j
        c = self.cells
        return ((1 - u) * (1 - v) * c[j, i] + u * (1 - v) * c[j, i + 1] + (1 - u) * v * c[j + 1, i] +
                u * v * c[j + 1, i + 1])


def write_hills(path, west, south, east, north):
    """A height model of 100 cells, with hills."""
    n = 100
    y, x = numpy.mgrid[0:n, 0:n]
    heights = (400 + 30 * numpy.sin(x / 9) + 40 * numpy.cos(y / 13) + 3 * ((x * 7 + y * 13) % 5)).astype("float32")
    out = gdal.GetDriverByName("GTiff").Create(str(path), n, n, 1, gdal.GDT_Float32)
    out.SetGeoTransform([west, (east - west) / n, 0, north, 0, -(north - south) / n])
    system = osr.SpatialReference()
    system.ImportFromEPSG(4326)
    out.SetProjection(system.ExportToWkt())
    out.GetRasterBand(1).WriteArray(heights)
    out = None


class Case:
    """A map around a zone, with the zones of a file closed in it."""

    SEA = 0.0  # the map's z counts from the sea

    def __init__(self, tools, folder, path, place, seed):
        self.random = random.Random(seed)
        (lon, lat), half, first = place
        self.half = half
        self.epoch = first + datetime.timedelta(days=self.random.randrange(300), seconds=self.random.randrange(86400))
        (folder / "one.csv").write_text(f"lat0 {lat!r}, lon0 {lon!r}\nposX,posY,posZ,halfSizeX,halfSizeY,halfSizeZ\n"
                                        "0,0,600,1,1,1\n")  # stands above the hills
        def run(*words):
            subprocess.run([str(w) for w in words], check=True)
        bounds = f"--bounds=-{half},-{half},300,{half},{half},900"
        run(tools / "skyway-import", folder / "one.csv", "--seal", 0, bounds, "-q", "-o", folder / "base.boxmap")
        dy, dx = 1.5 * half / 110500, 1.5 * half / 110500 / math.cos(math.radians(lat))
        write_hills(folder / "hills.tif", lon - dx, lat - dy, lon + dx, lat + dy)
        run(tools / "skyway-footprints", folder / "hills.tif", "--ground-of", folder / "base.boxmap", "--cell", 20,
            "--vertical-error", 0.5, "-q", "-o", folder / "hills.ground")
        run(tools / "skyway-map", "patch", folder / "base.boxmap", "--zones", path, "--ground-model", folder / "hills.ground",
            "--zero-sea", 0, "--slack", 5, "--epoch", self.epoch.strftime("%Y-%m-%dT%H:%M:%SZ"), "-q", "-o",
            folder / "zones.boxmap")
        self.grounds = [Ground(folder / "hills.tif", by_cell) for by_cell in (False, True)]
        made = numpy.load(folder / "zones.boxmap")
        self.boxes = made["boxes"]
        self.times = numpy.full((len(self.boxes), 2), [-math.inf, math.inf])
        if "timed" in made:
            self.times[made["timed"]] = made["times"]
        here = osr.SpatialReference()
        here.ImportFromProj4(f"+proj=tmerc +lat_0={lat!r} +lon_0={lon!r} +k=1 +ellps=WGS84 +units=m")
        there = osr.SpatialReference()
        there.ImportFromEPSG(4326)
        there.SetAxisMappingStrategy(osr.OAMS_TRADITIONAL_GIS_ORDER)
        self.to_degrees = osr.CoordinateTransformation(here, there)
        self.axes = json.loads(made.zip.read("meta.json"))["frame"]

    def point(self):
        x, y = (self.random.uniform(-self.half, self.half) for _ in "xy")
        z = self.random.uniform(300, 900)
        t = self.random.uniform(-9 * 86400, 9 * 86400)
        east, north = (y, x) if self.axes == "neu" else (x, y)
        lon, lat, _ = self.to_degrees.TransformPoint(east, north)
        return (x, y, z, t), lon, lat

    def closed(self, p):
        x, y, z, t = p
        b = self.boxes
        inside = ((b[:, 0] <= x) & (x <= b[:, 3]) & (b[:, 1] <= y) & (y <= b[:, 4]) & (b[:, 2] <= z) & (z <= b[:, 5]) &
                  (self.times[:, 0] <= t) & (t <= self.times[:, 1]))
        return bool(inside.any())

    def in_a_zone(self, zones, p, lon, lat):
        z, at = p[2], self.epoch + datetime.timedelta(seconds=p[3])
        for kind, volumes, periods in zones:
            if kind == "NO_RESTRICTION":
                continue
            for volume in volumes:
                if not volume.holds(lon, lat) or not is_on(periods, at, lat, lon):
                    continue
                for ground in self.grounds:
                    base = {"AGL": ground.height(lon, lat), "AMSL": self.SEA}
                    low = -math.inf if volume.lower is None else volume.lower[0] + base[volume.lower[1]]
                    if volume.lower is not None and volume.lower[1] == "AGL" and volume.lower[0] <= 0:
                        low = -math.inf  # below the ground nobody flies
                    high = math.inf if volume.upper is None else volume.upper[0] + base[volume.upper[1]]
                    if low <= z <= high:
                        return True
        return False


def first_day(periods):
    starts = [p["startDateTime"] for p in periods if p.get("startDateTime") and p.get("permanent") != "YES"]
    return instant(starts[0]).astimezone(UTC) if starts else datetime.datetime(2026, 1, 4, tzinfo=UTC)


def check(tools, path, points, seed, truth=None):
    """Of a file, or of a damaged copy of the file `truth`, whose zones it must close."""
    zones = list(zones_of(json.loads(pathlib.Path(truth or path).read_text(encoding="utf-8-sig"))))
    volumes = [(v, periods) for _, vs, periods in zones for v in vs]
    per = max(1, points // len(volumes))
    counts = {"points": 0, "in_zones": 0, "wrongly_free": 0, "closed_outside": 0}
    for k, (volume, periods) in enumerate(volumes):
        west, south, east, north = volume.box()
        rnd = random.Random(seed * 1000 + k)
        about = rnd.uniform(west, east), rnd.uniform(south, north)
        half = min(1500, max(300, (north - south) * 80000))
        with tempfile.TemporaryDirectory() as name:
            case = Case(tools, pathlib.Path(name), path, (about, half, first_day(periods)), seed * 1000 + k)
            for _ in range(per):
                p, lon, lat = case.point()
                inside, closed = case.in_a_zone(zones, p, lon, lat), case.closed(p)
                counts["points"] += 1
                counts["in_zones"] += inside
                counts["wrongly_free"] += inside and not closed
                counts["closed_outside"] += closed and not inside
                if inside and not closed:
                    print("wrongly free:", path, "volume", k, p, lon, lat, case.epoch)
    print(pathlib.Path(path).name, *(f"{k} {v}" for k, v in counts.items()), flush=True)
    # The map is not closed all over, nor open all over.
    if truth:
        return counts["wrongly_free"] == 0
    return counts["wrongly_free"] == 0 and counts["in_zones"] > 0 and counts["in_zones"] < counts["points"]


def ring(lon, lat, size, corners=((-1, -1), (1, -1), (1, 1), (-1, 1))):
    turned = [[lon + x * size, lat + y * size] for x, y in corners]
    turned = [[(x + 180) % 360 - 180, y] for x, y in turned]
    return turned + turned[:1]


def write_traps(folder):
    """Files with what public ones surprise with."""
    def volume(shape, **limits):
        return {"uomDimensions": "M", "horizontalProjection": shape, **limits}

    def polygon(*rings):
        return {"type": "Polygon", "coordinates": list(rings)}

    agl = {"lowerVerticalReference": "AGL", "upperVerticalReference": "AGL"}
    amsl = {"lowerVerticalReference": "AMSL", "upperVerticalReference": "AMSL"}
    night = [{"permanent": "NO", "startDateTime": "2026-01-01T00:00:00+01:00", "endDateTime": None,
              "schedule": [{"day": ["FRI", "SUN"], "startTime": "22:30Z", "endTime": "05:15Z"}]}]
    whole_day = [{"permanent": "NO", "schedule": [{"day": ["MON", "ANY"], "startTime": "00:00Z", "endTime": "23:59Z"}]}]
    past = [{"permanent": "NO", "startDateTime": "2019-01-01T00:00:00Z", "endDateTime": "2027-01-01T00:00:00Z"}]
    geometries = [
        (volume({"type": "Circle", "center": [7.4, 46.9], "radius": 900}, lowerLimit=0, upperLimit=150, **agl), None),
        (volume({"type": "Circle", "center": [25.1, -33.2], "radius": "1500"}, lowerLimit="450", upperLimit=520, **amsl),
         night),
        ({**volume(polygon(ring(24.9, 60.3, 0.01)), lowerLimit=200, upperLimit=1600, **agl), "uomDimensions": "FT"},
         whole_day),
        (volume(polygon(ring(179.997, -16.5, 0.01)), lowerLimit=30, upperLimit=99999, **agl), past),
        (volume(polygon(ring(8.6, 47.2, 0.012, ((-1, -1), (1, 1), (1, -1), (-1, 1)))), lowerLimit=0, upperLimit=600,
                lowerVerticalReference="AGL", upperVerticalReference="AMSL"), None),
        (volume(polygon(ring(10.5, 59.9, 0.01), ring(10.5, 59.9, 0.004)), lowerLimit=20, upperLimit=700,
                lowerVerticalReference="AGL", upperVerticalReference="AMSL"), None),
        (volume(polygon([[6.0, 46.0], [9.0, 46.003], [7.5, 46.4], [6.0, 46.0]]), lowerLimit=None, upperLimit=None), None),
    ]
    words = ["PROHIBITED", "REQ_AUTHORISATION", "CONDITIONAL", "PROHIBITED", "REQ_AUTHORISATION", "PROHIBITED",
             "CONDITIONAL"]
    listed = [{"identifier": f"T{i}", "country": "CHE", "restriction": word, "applicability": when or [{"permanent": "YES"}],
               "geometry": [geometry]} for i, (word, (geometry, when)) in enumerate(zip(words, geometries))]
    ed269 = folder / "traps-269.json"
    ed269.write_text(json.dumps({"UASZoneList": listed}), encoding="utf-8-sig")

    def feature(i, geometry, periods, kind="PROHIBITED"):
        return {"type": "Feature", "geometry": geometry,
                "properties": {"identifier": f"E{i}", "country": "FRA", "type": kind, "variant": "COMMON",
                               "zoneAuthority": [{"purpose": "INFORMATION"}], "limitedApplicability": periods}}

    layer = {"upper": 700, "upperReference": "AMSL", "lower": 60, "lowerReference": "AGL", "uom": "m"}
    feet = {"upper": 400, "upperReference": "AGL", "lower": 0, "lowerReference": "AGL", "uom": "ft"}
    sun = lambda a, b: [{"schedule": [{"day": ["ANY"], "startEvent": a, "endEvent": b}]}]
    places = [(2.6, 50.1), (151.2, -33.9), (-122.4, 37.8), (-179.9, 0.4), (21.0, 55.0)]
    schedules = [sun("SR", "SS"), sun("BMCT", "EECT"), sun("SS", "SR"),
                 [{"schedule": [{"day": ["WED", "SAT"], "startEvent": "SR", "endTime": "19:00:00Z"}]}],
                 [{"schedule": [{"day": ["ANY"], "startTime": "14:00:00Z", "endEvent": "SS"}]}]]
    features = [feature(i, {"type": "GeometryCollection", "layer": layer if i % 2 else feet, "geometries": [
        {"type": "Point", "coordinates": list(place), "extent": {"subType": "Circle", "radius": 700}},
        {"type": "MultiPolygon", "coordinates": [[ring(place[0] + 0.02, place[1], 0.005)]], "layer": layer}]}, periods,
        ("USPACE", "CONDITIONAL")[i % 2]) for i, (place, periods) in enumerate(zip(places, schedules))]
    ed318 = folder / "traps-318.json"
    ed318.write_text(json.dumps({"type": "FeatureCollection", "features": features}))
    return [ed269, ed318]


def members(value, at=()):
    """Paths to all members of a JSON value, those within rings left out."""
    for key, one in value.items() if isinstance(value, dict) else enumerate(value) if isinstance(value, list) else ():
        yield (*at, key)
        if key != "coordinates":
            yield from members(one, (*at, key))


def check_damaged(tools, path, count, seed):
    """Copies in which a member is no longer what it must be: refused, or all that the whole file closes is closed."""
    data, rnd = json.loads(path.read_text(encoding="utf-8-sig")), random.Random(seed)
    refused, ok = 0, True
    with tempfile.TemporaryDirectory() as name:
        for at in rnd.sample(list(members(data)), count):
            copy = json.loads(json.dumps(data))
            holder = copy
            for key in at[:-1]:
                holder = holder[key]
            holder[at[-1]] = {"purposely_invalid": "no such thing"}
            damaged = pathlib.Path(name) / "damaged.json"
            damaged.write_text(json.dumps(copy), encoding="utf-8")
            try:
                ok = check(tools, damaged, 200, seed, path) and ok
            except subprocess.CalledProcessError as error:
                refused += 1
                ok = error.returncode == 3 and ok
    print(f"{path.name} damaged: {refused} of {count} refused, the others close all of it: {ok}", flush=True)
    return ok


def is_refused(tools, path):
    """An example that its makers call invalid."""
    try:
        check(tools, path, 1, 0, path.with_name(path.name.removeprefix("Invalid")))
    except subprocess.CalledProcessError as error:
        return error.returncode == 3
    return False


def main():
    tools, points, seed = pathlib.Path(sys.argv[1]), int(sys.argv[2]), int(sys.argv[3])
    with tempfile.TemporaryDirectory() as name:
        files = write_traps(pathlib.Path(name))
        if data := os.environ.get("SKYWAY_REALDATA"):
            zones = pathlib.Path(data) / "zones"
            examples = sorted(zones.glob("ed318/Example*.json"))
            files += sorted(zones.glob("*.json")) + examples
            damaged = [check_damaged(tools, path, 10, seed) for path in examples]
            refused = [is_refused(tools, path) for path in sorted(zones.glob("ed318/Invalid*.json"))]
            if not all(damaged + refused):
                return 1
        return 0 if all([check(tools, path, points, seed) for path in files]) else 1


if __name__ == "__main__":
    sys.exit(main())
