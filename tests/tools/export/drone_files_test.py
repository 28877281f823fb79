"""drone_files_test.py BIN_DIR [COUNT [SEED]]: no drone file is accepted of which a part was not looked at.

Named files, each with what must become of it, and COUNT (100) random files of several lines or many points
of which only a later one goes through the tower; every verdict by skyway-check and
skyway-import-trajectory as processes.
"""

import json
import random
import struct
import sys

from one_tower import OneTower

count = int(sys.argv[2]) if len(sys.argv) > 2 else 100
rng = random.Random(int(sys.argv[3]) if len(sys.argv) > 3 else 15)
LAT, LON = 47.0, 8.0
PLACE = ("--origin", f"{LAT},{LON},0")
VEHICLE = ("--vehicle", "box:0.3,0.3,0.2")
DEGREE = 1 / 111180.0  # about a metre north
EAST = 1 / 76050.0     # and east, at 47 degrees
failures = []

TOWER = (20, -5, 0, 30, 5, 60)
site = OneTower(sys.argv[1], TOWER, "-100,-100,0,200,100,100")
run, folder = site.run, site.folder
HIT = [(0, 0, 20), (50, 0, 20)]
FREE = [(0, 20, 20), (50, 20, 20)]


def lonlat(p):
    return LON + p[0] * EAST, LAT + p[1] * DEGREE, p[2]


def kml_points(line):
    return " ".join("%.9f,%.9f,%.3f" % lonlat(p) for p in line)


def kml_line(line, mode="<altitudeMode>absolute</altitudeMode>", points=None):
    return f"<LineString>{mode}<coordinates>{points or kml_points(line)}</coordinates></LineString>"


def placemark(inner):
    return f"<Placemark><name>a</name>{inner}</Placemark>"


def kml(*inner, tail=""):
    return ('<?xml version="1.0" encoding="UTF-8"?>\n<kml xmlns="http://www.opengis.net/kml/2.2" '
            'xmlns:gx="http://www.google.com/kml/ext/2.2"><Document>' + "".join(inner) + "</Document></kml>\n" + tail)


def coordinates(line):
    return [list(lonlat(p)) for p in line]


def geometry(line):
    return {"type": "LineString", "coordinates": coordinates(line)}


def feature(g, **more):
    return {"type": "Feature", "properties": {}, "geometry": g, **more}


def collection(*features, **more):
    return json.dumps({"type": "FeatureCollection", "features": list(features), **more})


def glb(lines, change=None):
    """A node, mesh and primitive a line."""
    data = b""
    accessors, views, meshes, nodes = [], [], [], []
    for i, line in enumerate(lines):
        x, y, z = line[0]
        part = b"".join(struct.pack("<3f", p[0] - x, p[2] - z, -(p[1] - y)) for p in line)
        views.append({"buffer": 0, "byteOffset": len(data), "byteLength": len(part)})
        accessors.append({"bufferView": i, "componentType": 5126, "count": len(line), "type": "VEC3"})
        meshes.append({"primitives": [{"attributes": {"POSITION": i}, "mode": 3}]})
        nodes.append({"mesh": i, "translation": [x, z, -y]})
        data += part
    gltf = {"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": list(range(len(lines)))}], "nodes": nodes,
            "meshes": meshes, "accessors": accessors, "bufferViews": views, "buffers": [{"byteLength": len(data)}]}
    if change:
        change(gltf)
    text = json.dumps(gltf).encode()
    text += b" " * (-len(text) % 4)
    body = struct.pack("<I4s", len(text), b"JSON") + text + struct.pack("<I4s", len(data), b"BIN\0") + data
    return struct.pack("<4sII", b"glTF", 2, 12 + len(body)) + body


def wpl(*items, home=True):
    rows = [[0, 1, 0, 16, 0, 0, 0, 0, LAT, LON, 0, 1]] if home else []
    rows += [[0, 0, *item, 1] for item in items]
    for index, row in enumerate(rows):
        row[0] = index
    return "QGC WPL 110\n" + "".join("\t".join(str(v) for v in row) + "\n" for row in rows)


def item(command, point=(0, 0, 0), params=(1, 0, 0, 0), frame=3):
    lon, lat, z = lonlat(point)
    return [frame, command, *params, round(lat, 7), round(lon, 7), z]


TAKEOFF = item(22, (0, 20, 20), (0, 0, 0, 0))
POINT = item(16, (50, 20, 20))
LAND = item(21, (50, 20, 0), (0, 0, 0, 0))
BAD = item(16, (50, -20, 20))  # beyond the tower, from (0, 20): through it


def plan(items=(TAKEOFF, POINT, LAND), change=None, **more):
    made = {"fileType": "Plan", "version": 1, "groundStation": "test",
            "geoFence": {"circles": [], "polygons": [], "version": 2}, "rallyPoints": {"points": [], "version": 2},
            "mission": {"version": 2, "vehicleType": 2, "plannedHomePosition": [LAT, LON, 0],
                        "items": [{"type": "SimpleItem", "frame": i[0], "command": i[1], "params": i[2:9],
                                   "autoContinue": True} for i in items]}, **more}
    if change:
        change(made)
    return json.dumps(made)


def setpoints(rows, header="t_s,east_m,north_m,up_m,v_east_m_s,v_north_m_s,v_up_m_s,a_east_m_s2,a_north_m_s2,a_up_m_s2,yaw_rad,yaw_rate_rad_s"):
    return header + "\n" + "".join(",".join(map(str, r)) + "\n" for r in rows)


def still(t, x, y=20, z=20, v=(0, 0, 0), a=(0, 0, 0), yaw=(0, 0)):
    return [t, x, y, z, *v, *a, *yaw]


def crazyflie(rows):
    names = ",".join(["duration"] + [f"{a}^{k}" for a in ("x", "y", "z", "yaw") for k in range(8)])
    return names + "\n" + "".join(",".join(map(str, r)) + "\n" for r in rows)


def straight(a, b, duration=10):
    row = [duration]
    for i in range(3):
        row += [a[i], (b[i] - a[i]) / duration, 0, 0, 0, 0, 0, 0]
    return row + [0] * 8


def tello(*legs, end="land\n"):
    return "command\ntakeoff\n" + "".join("go %d %d %d 100\n" % leg for leg in legs) + end


FREE_LEGS = [(500, 0, 0)] * 3  # 15 m north of (25, -80)
HIT_LEGS = [(500, 0, 0)] * 16


def drone(form, text, *options):
    path = folder / "file"
    path.write_bytes(text if isinstance(text, bytes) else text.encode())
    start = ("--takeoff-place", "25,-80,0", "--heading", "0") if form == "tello" else ()
    place = ("--origin", f"{LAT},{LON},0") if form in ("kml", "geojson", "wpl", "qgc-plan") else ()
    checked = run("skyway-check", folder / "map", path, "--file-format", form, *VEHICLE, *start, *place, *options)
    kinds = {form, "auto"}
    imported = None
    if form != "setpoints" and not options:
        imported = run("skyway-import-trajectory", path, "--format", form, *start, *place)
    return checked, imported


def expect(name, wanted, form, text, *options, records=None):
    """wanted: exit of skyway-check: 0, 1, 3, or the three together as "never ok"."""
    checked, imported = drone(form, text, *options)
    wrong = checked.returncode not in ((1, 3) if wanted == "never ok" else (wanted,))
    if imported is not None and wanted == 3 and imported.returncode != 3:
        wrong = True
    if records is not None and checked.stdout.count(b"\n") != records:
        wrong = True
    if wanted == 3 and (not checked.stderr or len(checked.stderr) > 1000 or b"terminate" in checked.stderr):
        wrong = True
    if wrong:
        failures.append(name)
        print(f"{name}: expected {wanted}, found {checked.returncode} (import {imported and imported.returncode})",
              checked.stderr.decode(errors="replace")[:300], checked.stdout.decode()[:200])


def named_kml():
    free, hit = kml_line(FREE), kml_line(HIT)
    expect("kml: one line", 0, "kml", kml(placemark(free)), records=1)
    expect("kml: two lines", 1, "kml", kml(placemark(free), placemark(hit)), records=2)
    expect("kml: MultiGeometry", 1, "kml", kml(placemark(f"<MultiGeometry>{free}{hit}</MultiGeometry>")))
    expect("kml: in a later folder", 1, "kml", kml(placemark(free), f"<Folder>{placemark(hit)}</Folder>"))
    expect("kml: a line in a comment is none", 1, "kml", kml(f"<!-- {placemark(free)} -->", placemark(hit)))
    expect("kml: with a prefix", 1, "kml",
           kml(placemark(free), placemark(hit).replace("<", "<k:").replace("<k:/", "</k:")))
    expect("kml: CDATA", 1, "kml",
           kml(placemark(kml_line(HIT, points=f"<![CDATA[{kml_points(HIT)}]]>"))))
    for mode in ("clampToGround", "relativeToGround", "clampToSeaFloor", ""):
        expect(f"kml: altitudeMode {mode}", 3, "kml",
               kml(placemark(kml_line(FREE, f"<altitudeMode>{mode}</altitudeMode>"))))
    for mode in ("clampToSeaFloor", "relativeToSeaFloor"):
        expect(f"kml: gx:altitudeMode {mode}", 3, "kml",
               kml(placemark(kml_line(FREE, f"<gx:altitudeMode>{mode}</gx:altitudeMode>"))))
    expect("kml: no altitudeMode", 3, "kml", kml(placemark(kml_line(FREE, ""))))
    expect("kml: two altitudeModes", 3, "kml",
           kml(placemark(kml_line(FREE, "<altitudeMode>absolute</altitudeMode>"
                                  "<altitudeMode>relativeToGround</altitudeMode>"))))
    for other in ("<Point><coordinates>8,47,20</coordinates></Point>",
                  "<Polygon><outerBoundaryIs/></Polygon>", "<LinearRing/>", "<Model/>",
                  "<gx:Track><gx:coord>8 47 20</gx:coord></gx:Track>", "<gx:MultiTrack/>", "<unknown/>"):
        expect(f"kml: beside {other[:12]}", 3, "kml", kml(placemark(free), placemark(other)))
    for other in ("<NetworkLink><Link><href>b.kml</href></Link></NetworkLink>", "<GroundOverlay/>", "<gx:Tour/>"):
        expect(f"kml: {other[:12]}", 3, "kml", kml(placemark(free), other))
    expect("kml: two coordinates", 3, "kml",
           kml(placemark(free.replace("</LineString>", f"<coordinates>{kml_points(HIT)}</coordinates></LineString>"))))
    expect("kml: places of two numbers", 3, "kml", kml(placemark(kml_line(FREE, points="8,47 8,47.0001"))))
    expect("kml: a place far away", 3, "kml", kml(placemark(kml_line(FREE, points="100,-40,20 100,-40,21"))))
    expect("kml: another root after it", 3, "kml", kml(placemark(free), tail=kml(placemark(hit))))
    expect("kml: garbage after it", 3, "kml", kml(placemark(free), tail="garbage"))
    expect("kml: a NUL", 3, "kml", kml(placemark(free), "\0"))
    expect("kml: cut", 3, "kml", kml(placemark(free), placemark(hit))[:-60])
    expect("kml: a document type", 3, "kml",
           kml(placemark(free)).replace("<kml", '<!DOCTYPE kml [<!ENTITY a "b">]><kml', 1))
    expect("kml: a byte order mark and CRLF", 0, "kml",
           "\ufeff" + kml(placemark(free)).replace("\n", "\r\n").replace(" ", " "))
    expect("kml: deep", 3, "kml", kml("<Folder>" * 100000))


def named_geojson():
    free, hit = geometry(FREE), geometry(HIT)
    many = {"type": "MultiLineString", "coordinates": [free["coordinates"], hit["coordinates"]]}
    both = {"type": "GeometryCollection", "geometries": [free, hit]}
    expect("geojson: one line", 0, "geojson", collection(feature(free)), records=1)
    expect("geojson: two features", 1, "geojson", collection(feature(free), feature(hit)), records=2)
    expect("geojson: MultiLineString", 1, "geojson", collection(feature(many)))
    expect("geojson: MultiLineString second", 1, "geojson", collection(feature(free), feature(many)))
    expect("geojson: GeometryCollection", 1, "geojson", collection(feature(free), feature(both)))
    expect("geojson: a feature alone", 1, "geojson", json.dumps(feature(hit)))
    expect("geojson: a geometry alone", 1, "geojson", json.dumps(hit))
    for kind in ("Point", "MultiPoint", "Polygon", "MultiPolygon", "Curve"):
        other = {"type": kind, "coordinates": [[list(lonlat(p)) for p in HIT]]}
        expect(f"geojson: beside a {kind}", 3, "geojson", collection(feature(free), feature(other)))
    expect("geojson: a null geometry", 3, "geojson", collection(feature(free), feature(None)))
    for name in ("EPSG:2056", "urn:ogc:def:crs:EPSG::4326"):
        crs = {"type": "name", "properties": {"name": name}}
        expect(f"geojson: crs {name}", 3, "geojson", collection(feature(free), crs=crs))
    expect("geojson: crs null", 3, "geojson", collection(feature(free), crs=None))
    expect("geojson: crs CRS84", 0, "geojson",
           collection(feature(free), crs={"type": "name", "properties": {"name": "urn:ogc:def:crs:OGC:1.3:CRS84"}}))
    expect("geojson: altitudeMode left by a converter", 3, "geojson",
           collection(feature(free, properties={"altitudeMode": "relativeToGround"})))
    expect("geojson: places of two numbers", 3, "geojson",
           collection(feature({"type": "LineString", "coordinates": [[8, 47], [8, 47.001]]})))
    expect("geojson: places of four numbers", 3, "geojson",
           collection(feature({"type": "LineString", "coordinates": [[8, 47, 20, 1], [8, 47.0001, 20, 1]]})))
    expect("geojson: a latitude beyond 90", 3, "geojson",
           collection(feature({"type": "LineString", "coordinates": [[8, 97, 20], [8, 97, 20]]})))
    expect("geojson: a place far away", 3, "geojson",
           collection(feature({"type": "LineString", "coordinates": [[100, -40, 20], [100, -40, 21]]})))
    expect("geojson: two documents", 3, "geojson", collection(feature(free)) + collection(feature(hit)))
    twice = collection(feature(hit))[:-1] + ',"features":' + json.dumps([feature(free)]) + "}"
    expect("geojson: a key twice", 3, "geojson", twice)
    expect("geojson: a NUL", 3, "geojson", collection(feature(free)).replace("{", "{\0", 1))
    expect("geojson: cut", 3, "geojson", collection(feature(free), feature(hit))[:-30])


def named_gltf():
    def change(f):
        return glb([FREE], f)
    expect("gltf: one line", 0, "gltf", glb([FREE]), records=1)
    expect("gltf: two meshes", 1, "gltf", glb([FREE, HIT]), records=2)

    def two_primitives(g):
        g["meshes"] = [{"primitives": [m["primitives"][0] for m in g["meshes"]]}]
        g["nodes"] = [{"mesh": 0, "translation": [0, 20, -20]}]
        g["scenes"] = [{"nodes": [0]}]
    expect("gltf: two primitives", 1, "gltf", glb([[(0, 20, 20), (50, 20, 20)], [(0, 20, 20), (50, -20, 20)]], two_primitives))
    expect("gltf: a mesh that another node moves", 1, "gltf",
           glb([FREE], lambda g: (g["nodes"].append({"mesh": 0, "translation": [0, 20, 0]}), g["scenes"][0]["nodes"].append(1))))
    for key, value in (("rotation", [0, 0.7, 0, 0.7]), ("scale", [1, 2, 1]), ("children", [0]), ("skin", 0),
                       ("matrix", [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1])):
        expect(f"gltf: a node with {key}", 3, "gltf", change(lambda g: g["nodes"][0].update({key: value})))
    for key in ("animations", "skins", "extensionsRequired", "cameras"):
        expect(f"gltf: {key}", 3, "gltf", change(lambda g: g.update({key: [{}]})))
    expect("gltf: triangles", 3, "gltf", change(lambda g: g["meshes"][0]["primitives"][0].update(mode=4)))
    expect("gltf: indices", 3, "gltf", change(lambda g: g["meshes"][0]["primitives"][0].update(indices=0)))
    expect("gltf: sparse", 3, "gltf", change(lambda g: g["accessors"][0].update(sparse={})))
    expect("gltf: VEC2", 3, "gltf", change(lambda g: g["accessors"][0].update(type="VEC2")))
    expect("gltf: an offset is obeyed", 1, "gltf",
           glb([[(0, 20, 20), (50, 20, 20), (50, -20, 20), (0, -20, 20), (50, 20, 20)]],
               lambda g: g["accessors"][0].update(byteOffset=12, count=4)))
    expect("gltf: a stride", 3, "gltf", change(lambda g: g["bufferViews"][0].update(byteStride=24)))
    expect("gltf: a buffer beside it", 3, "gltf", change(lambda g: g["buffers"][0].update(uri="a.bin")))
    expect("gltf: two scenes", 3, "gltf", change(lambda g: g["scenes"].append({"nodes": []})))
    expect("gltf: a node in no scene", 3, "gltf",
           glb([FREE, HIT], lambda g: g["scenes"][0]["nodes"].pop()))
    expect("gltf: bytes after it", 3, "gltf", glb([FREE]) + b"more")


def named_missions():
    good = (TAKEOFF, POINT, LAND)
    expect("wpl: a mission", 0, "wpl", wpl(*good), records=1)
    expect("plan: a mission", 0, "qgc-plan", plan(), records=1)
    for name, command, params in (("a spline", 82, (0, 0, 0, 0)), ("turns", 18, (3, 0, 20, 0)),
                                  ("loitering on a circle", 19, (5, 0, 30, 0)), ("a climb", 31, (0, 0, 0, 0))):
        other = item(command, (50, -20, 20), params)
        rest = item(16, (0, 20, 20), (1, 0.2, 0, 0))
        expect(f"wpl: {name} through the tower", 1, "wpl", wpl(TAKEOFF, rest, other, POINT, LAND))
        expect(f"plan: {name} through the tower", 1, "qgc-plan", plan((TAKEOFF, rest, other, POINT, LAND)))
    for name, command, params in (("a jump back to the take-off", 177, (1, 5, 0, 0)),
                                  ("turns on no circle", 18, (3, 0, 0, 0)), ("half a turn", 18, (0.5, 0, 20, 0)),
                                  ("a change of height", 113, (1, 0, 0, 50)), ("a new home", 179, (1, 0, 0, 0)),
                                  ("a mode", 176, (1, 4, 0, 0)), ("a new place", 192, (-1, 1, 0, 0)),
                                  ("a parachute", 208, (2, 0, 0, 0)), ("an orbit", 34, (10, 1, 0, 0)),
                                  ("a user's waypoint", 31000, (0, 0, 0, 0)), ("termination", 185, (1, 0, 0, 0)),
                                  ("a VTOL take-off", 84, (0, 0, 0, 0)), ("an unknown command", 4711, (0, 0, 0, 0))):
        other = item(command, (50, -20, 20), params)
        expect(f"wpl: {name}", 3, "wpl", wpl(TAKEOFF, other, POINT, LAND))
        expect(f"plan: {name}", 3, "qgc-plan", plan((TAKEOFF, other, POINT, LAND)))
    forever = item(177, (50, -20, 20), (2, -1, 0, 0))
    expect("wpl: a jump for ever", 0, "wpl", wpl(TAKEOFF, forever, POINT, LAND))
    expect("plan: a jump for ever", 0, "qgc-plan", plan((TAKEOFF, forever, POINT, LAND)))
    camera = item(2000, (0, 0, 0), (0, 1, 0, 0), frame=2)
    expect("wpl: a camera", 0, "wpl", wpl(TAKEOFF, camera, POINT, LAND))
    home = item(20, frame=2)
    for name, after in (("a landing", LAND), ("a return", home), ("loitering", item(17, (50, 20, 20), (0, 0, 0, 0)))):
        expect(f"wpl: after {name}", 3, "wpl", wpl(TAKEOFF, POINT, after, BAD))
        expect(f"plan: after {name}", 3, "qgc-plan", plan((TAKEOFF, POINT, after, BAD)))
    expect("wpl: a second take-off", 3, "wpl", wpl(TAKEOFF, POINT, item(22, (50, -20, 20)), LAND))
    expect("wpl: a return is not checked", 1, "wpl", wpl(TAKEOFF, POINT, home))
    expect("plan: a return is not checked", 1, "qgc-plan", plan((TAKEOFF, POINT, home)))
    expect("wpl: from home to a take-off elsewhere", 1, "wpl",
           wpl(item(22, (50, 0, 20), (0, 0, 0, 0)), item(16, (60, 0, 20)), item(21, (60, 0, 0))))
    begun = wpl(TAKEOFF, POINT, LAND).splitlines()
    begun[3] = begun[3].replace("2\t0\t", "2\t1\t", 1)
    expect("wpl: begins at a later item", 3, "wpl", "\n".join(begun) + "\n")
    expect("wpl: a NUL", 3, "wpl", wpl(*good).replace("\t", "\0", 1))
    for key, value in (("circles", [{"circle": {"center": [47, 8], "radius": 10}, "inclusion": True}]),
                       ("polygons", [{"inclusion": True, "polygon": [[47, 8], [47, 9], [48, 9]]}])):
        expect(f"plan: a fence of {key}", 1, "qgc-plan", plan(change=lambda p: p["geoFence"].update({key: value})))
    wide = [{"circle": {"center": [LAT, LON], "radius": 500}, "inclusion": True}]
    expect("plan: a fence that is kept", 0, "qgc-plan", plan(change=lambda p: p["geoFence"].update(circles=wide)))
    crossed = [{"inclusion": True, "polygon": [[46.9, 7.9], [47.1, 8.1], [47.1, 7.9], [46.9, 8.1]]}]
    expect("plan: a fence whose edges cross", 3, "qgc-plan", plan(change=lambda p: p["geoFence"].update(polygons=crossed)))
    expect("plan: a plane", 3, "qgc-plan", plan(change=lambda p: p["mission"].update(vehicleType=1)))
    expect("plan: a survey", 3, "qgc-plan",
           plan(change=lambda p: p["mission"]["items"].insert(1, {"type": "ComplexItem", "complexItemType": "survey"})))
    expect("plan: two heights", 3, "qgc-plan",
           plan(change=lambda p: p["mission"]["items"][1].update(Altitude=90, AltitudeMode=1)))
    for mode in (2, 3, 4):
        expect(f"plan: AltitudeMode {mode}", 3, "qgc-plan",
               plan(change=lambda p: p["mission"]["items"][1].update(Altitude=20, AltitudeMode=mode)))
    expect("plan: two documents", 3, "qgc-plan", plan() + plan())
    twice = plan((TAKEOFF, BAD, LAND))[:-1] + ',"mission":' + json.dumps(json.loads(plan())["mission"]) + "}"
    expect("plan: a key twice", 3, "qgc-plan", twice)


def named_tello():
    expect("tello: a script", 0, "tello", tello(*FREE_LEGS))
    expect("tello: a later leg", 1, "tello", tello(*HIT_LEGS))
    for command in ("up 100", "down 20", "left 100", "right 100", "forward 100", "back 100", "cw 90", "ccw 90",
                    "flip l", "curve 20 20 20 60 40 0 30", "rc 0 50 0 0", "stop", "emergency", "speed 50", "takeoff",
                    "go 100 0 0 50 m1", "jump 100 0 0 50 0 m1 m2", "command"):
        expect(f"tello: {command}", 3, "tello", tello(*FREE_LEGS, end=command + "\nland\n"))
    expect("tello: after the landing", 3, "tello", tello(*FREE_LEGS, end="land\ngo 500 0 0 100\n"))
    expect("tello: cut in a number", 3, "tello", tello(*FREE_LEGS, end="go 500 0 0 10"))


def named_tables():
    rows = [still(0, 0), still(1, 1), still(2, 2)]
    expect("setpoints: a table", 0, "setpoints", setpoints(rows))
    expect("setpoints: a later row", 1, "setpoints", setpoints(rows + [still(30, 25, 0)]))
    expect("setpoints: out of order", 3, "setpoints", setpoints([rows[0], rows[2], rows[1]]))
    expect("setpoints: in feet", 3, "setpoints",
           setpoints(rows, "t_s,x_ft,y_ft,z_ft,vx_m_s,vy_m_s,vz_m_s,ax_m_s2,ay_m_s2,az_m_s2,yaw_rad,yaw_rate_rad_s"))
    expect("setpoints: cut in a number", 3, "setpoints", setpoints(rows)[:-1])
    jerky = [still(0, 0), still(0.1, 0, a=(3, 0, 0)), still(0.2, 0, a=(-3, 0, 0))]
    expect("setpoints: a jerk of 60", 1, "setpoints", setpoints(jerky), "--jmax", "50")
    expect("setpoints: a jerk within 70", 0, "setpoints", setpoints(jerky), "--jmax", "70")
    expect("setpoints: thrust that turns", 1, "setpoints", setpoints(jerky), "--body-rate", "300")
    expect("setpoints: slowly", 0, "setpoints", setpoints(jerky), "--body-rate", "400")
    quick = [still(0, 0), still(0.1, 10), still(0.2, 20)]
    expect("setpoints: places that speak of 100 m/s, speeds of 0", 1, "setpoints", setpoints(quick), "--vmax", "5")
    rush = [still(0, 0), still(0.1, 0, v=(9, 0, 0)), still(0.2, 0)]
    expect("setpoints: speeds that change, accelerations of 0", 1, "setpoints", setpoints(rush), "--amax", "5")
    expect("setpoints: speeds that change, no tilt", 1, "setpoints", setpoints(rush), "--tilt", "30")
    turn = [still(0, 0), still(0.1, 0, yaw=(3, 0)), still(0.2, 0)]
    expect("setpoints: a yaw that turns, a rate of 0", 1, "setpoints", setpoints(turn), "--yaw-rate", "90")
    good, bad = straight((0, 20, 20), (50, 20, 20)), straight((50, 20, 20), (0, -20, 20))
    expect("crazyflie: a table", 0, "crazyflie", crazyflie([good]))
    expect("crazyflie: a later row", "never ok", "crazyflie", crazyflie([good, bad]))
    expect("crazyflie: after a blank line", "never ok", "crazyflie", crazyflie([good]) + "\n" + crazyflie([bad]).split("\n")[1] + "\n")
    expect("crazyflie: other columns", 3, "crazyflie", crazyflie([good]).replace("x^0", "y^9", 1))
    expect("crazyflie: x and y swapped", 3, "crazyflie",
           crazyflie([good]).replace("x^", "w^").replace("y^", "x^").replace("w^", "y^"))
    expect("crazyflie: 1e15 s", 3, "crazyflie", crazyflie([straight((0, 20, 20), (0, 20, 20), 1e15)]))
    expect("crazyflie: cut in a number", 3, "crazyflie", crazyflie([good])[:-1])
    # 80 m towards the wall, to rest beside it: what the drone's own arithmetic adds is over 0.2 mm.
    for beside, wanted in ((2e-4, 1), (5e-3, 0)):
        swing = [20]
        for a, b in ((25, 25), (85, 5.3 + beside), (20, 20)):
            swing += [a, 0, 0, 0] + [(b - a) * c / 20 ** k for k, c in zip((4, 5, 6, 7), (35, -84, 70, -20))]
        expect(f"crazyflie: {beside} m from the wall", wanted, "crazyflie", crazyflie([swing + [0] * 8]))
    expect("table: two paths", 1, "paths-csv", "id,x,y,z\na,0,20,20\na,50,20,20\nb,0,0,20\nb,50,0,20\n")
    expect("table: cut in a number", 3, "paths-csv", "0,20,20\n50,20,2")
    for limit in (("--amax", "5"), ("--jmax", "5"), ("--tilt", "20"), ("--vmax", "3"), ("--body-rate", "90"),
                  ("--thrust", "12"), ("--yaw-rate", "90"), ("--vmax-v", "3")):
        expect(f"table: {limit[0]} is not measured", 1, "paths-csv", "0,20,20\n50,20,20\n", *limit)
    expect("wpl: --amax is not measured", 1, "wpl", wpl(TAKEOFF, POINT, LAND), "--amax", "5")
    expect("wpl: a speed that is not said", 1, "wpl", wpl(TAKEOFF, POINT, LAND), "--vmax", "5")
    said = item(178, (0, 0, 0), (1, 4, -1, 0), frame=2)
    expect("wpl: a speed that is said", 0, "wpl", wpl(said, TAKEOFF, POINT, LAND), "--vmax", "5")
    expect("wpl: a speed that is said late", 1, "wpl", wpl(TAKEOFF, POINT, said, LAND), "--vmax", "5")
    expect("tello: --tilt is not measured", 1, "tello", tello(*FREE_LEGS), "--tilt", "20")


def path_records():
    """A path record has no times: what an option asks of them is refused."""
    (folder / "path").write_text('{"type":"path","id":"p","points":[[0,20,20],[50,20,20]]}\n')
    for options, wanted in (((), 0), (("--vmax", "3"), 1), (("--jmax", "3"), 1)):
        done = run("skyway-check", folder / "map", folder / "path", *VEHICLE, *options)
        if done.returncode != wanted:
            failures.append(f"path record {options}")
            print(f"path record {options}: expected {wanted}, found {done.returncode}", done.stdout)


def reports_say_no_zero():
    """What was not measured is absent."""
    for form, text in (("tello", tello(*FREE_LEGS)), ("wpl", wpl(TAKEOFF, POINT, LAND)), ("kml", kml(placemark(kml_line(FREE))))):
        report = json.loads(drone(form, text)[0].stdout)
        for key in ("acceleration", "jerk", "tilt", "thrust", "body_rate", "yaw_rate", "jumps"):
            if key in report:
                failures.append(f"{form}: {key} in its report")
                print(f"{form}: {key} = {report[key]} though it was not measured")


def random_line(free):
    """High above, or beside; the hit goes through the tower."""
    if not free:
        y = rng.uniform(-4, 4)
        line = [(-10, y, rng.uniform(1, 50)), (60, y, rng.uniform(1, 50))]
        return line if rng.random() < 0.5 else line[::-1]
    return [(rng.uniform(-50, 100), rng.uniform(10, 60), rng.uniform(5, 80)) for _ in range(rng.randint(2, 5))]


def random_kml(lines):
    nodes = [kml_line(line) for line in lines]
    parts = []
    while nodes:
        take = rng.randint(1, len(nodes))
        inner = "".join(nodes[:take])
        parts.append(placemark(inner if take == 1 else f"<MultiGeometry>{inner}</MultiGeometry>"))
        if rng.random() < 0.3:
            parts[-1] = f"<Folder>{parts[-1]}</Folder>"
        nodes = nodes[take:]
    return kml(*parts)


def random_geojson(lines):
    parts, rest = [], [geometry(line) for line in lines]
    while rest:
        take = rng.randint(1, len(rest))
        some, rest = rest[:take], rest[take:]
        kind = rng.choice(("each", "multi", "collection"))
        if kind == "each":
            parts += [feature(g) for g in some]
        elif kind == "multi":
            parts.append(feature({"type": "MultiLineString", "coordinates": [g["coordinates"] for g in some]}))
        else:
            parts.append(feature({"type": "GeometryCollection", "geometries": some}))
    return collection(*parts)


def joined(lines):
    return [p for line in lines for p in line]


def random_file(form, lines):
    if form == "kml":
        return random_kml(lines)
    if form == "geojson":
        return random_geojson(lines)
    if form == "gltf":
        return glb(lines)
    if form == "paths-csv":
        return "".join(f"p{i},{p[0]},{p[1]},{p[2]}\n" for i, line in enumerate(lines) for p in line)
    points = joined(lines)
    if form == "setpoints":
        return setpoints([still(float(10 * i), *p) for i, p in enumerate(points)])
    if form == "crazyflie":
        return crazyflie([straight(a, b) for a, b in zip(points, points[1:])])
    items = [item(22, points[0], (0, 0, 0, 0))] + [item(16, p) for p in points[1:]]
    return wpl(*items) if form == "wpl" else plan(items)


def random_cases():
    """Only a later line goes through the tower, and never the first."""
    for case in range(count):
        form = ("kml", "geojson", "gltf", "paths-csv", "setpoints", "crazyflie", "wpl", "qgc-plan")[case % 8]
        lines = [random_line(True) for _ in range(rng.randint(1, 4))]
        lines.insert(rng.randint(1, len(lines)), random_line(False))
        expect(f"random {form} {case}", "never ok", form, random_file(form, lines))


for group in (named_kml, named_geojson, named_gltf, named_missions, named_tello, named_tables, path_records,
              reports_say_no_zero, random_cases):
    group()
print(f"{len(failures)} wrong")
sys.exit(bool(failures))
