"""python_test.py PYTHON_DIR BIN_DIR SOURCE_DIR: the module against the tools, its examples and its pages."""

import ctypes
import json
import os
import pathlib
import pickle
import re
import shutil
import subprocess
import sys
import tempfile
import time
import warnings

import numpy

python_dir, bin_dir, source_dir = map(pathlib.Path, sys.argv[1:4])
sys.path.insert(0, str(python_dir))
import skyway  # noqa: E402
from skyway import _skyway  # noqa: E402

in_python = _skyway.in_python  # what a tool says of its options, said of keyword arguments

VEHICLE = "box:0.5,0.5,0.32"


def tool(name, *arguments, code=0, text=None):
    done = subprocess.run([bin_dir / name, *map(str, arguments)], capture_output=True, text=True, input=text)
    assert done.returncode in (code if isinstance(code, tuple) else (code,)), (name, arguments, done)
    return done


def lines(text):
    return [json.loads(line) for line in text.splitlines()]


def error_of(function, *arguments, kind=skyway.InputError, **named):
    try:
        function(*arguments, **named)
    except kind as error:
        return error
    raise AssertionError(f"{function} raised nothing")


def raises(kind, function, *arguments, **named):
    return str(error_of(function, *arguments, kind=kind, **named))


def test_a_map_that_was_written_to_gives_no_answer(out):
    walls = [[[0, low, 0, 30, low + 2, 10]] for low in (0, 20)]
    one, other = (skyway.BoxMap(wall, bounds=[[-10, -10, 0], [50, 40, 20]]) for wall in walls)
    path = f"{out}/in_use.boxmap"
    skyway.write_box_map(path, one)
    city = skyway.read_box_map(path)
    scene = skyway.CollisionScene(city, VEHICLE)
    planner = skyway.Planner(scene)
    way = planner.plan([-5, 30, 5], [40, 30, 5])
    flight = skyway.solve(scene, way, limits={"vmax": 3, "amax": 2})
    assert skyway.check(scene, flight)["ok"] and not scene.hits([[5, 21, 5]])[0]
    skyway.write_box_map(path, other)  # a new file: the old one stays while it is in use
    assert not scene.hits([[5, 21, 5]])[0]
    city = skyway.read_box_map(path)
    scene = skyway.CollisionScene(city, VEHICLE)
    planner = skyway.Planner(scene)
    time.sleep(0.05)  # clocks of files tick in some milliseconds
    skyway.write_box_map(f"{out}/one.boxmap", one)
    shutil.copyfile(f"{out}/one.boxmap", path)  # as cp does: into the file that is there
    point, both = [[5, 1, 5]], [[-5, 30, 5, 40, 30, 5]]
    for ask in (lambda: scene.hits(point), lambda: scene.free(point), lambda: scene.sweep_hits(both, [1, 1, 1]),
                lambda: scene.nearest(point), lambda: scene.boxes_meeting([0, 0, 0], [1, 1, 1]),
                lambda: planner.plan([-5, 30, 5], [40, 30, 5]), lambda: planner.plan_batch(both),
                lambda: skyway.solve(scene, [[-5, 30, 5], [40, 30, 5]], limits={"vmax": 3, "amax": 2}),
                lambda: skyway.check(scene, [[-5, 30, 5], [40, 30, 5]]),
                lambda: skyway.check_return(scene, [[-5, 30, 5], [40, 30, 5]], limits={"vmax": 3, "amax": 2}, return_height=15),
                lambda: skyway.export_mission(scene, skyway.Path([[-5, 30, 5], [40, 30, 5]]), "geojson"),
                lambda: skyway.plot_plan(city), lambda: skyway.plot_clearance(scene, [skyway.Path([[-5, 30, 5], [40, 30, 5]])]), lambda: skyway.page(city),
                lambda: skyway.write_box_map(f"{out}/copy.boxmap", city)):
        try:
            ask()
        except (RuntimeError, skyway.InputError) as error:  # where all of the map is verified, that fails first
            assert "in_use.boxmap" in str(error), error
            continue
        raise AssertionError("an answer of a map that was written to")
    assert not pathlib.Path(f"{out}/copy.boxmap").exists()


def test_arrays_are_those_of_the_files(out):
    city, raw = skyway.read_box_map(f"{out}/city.boxmap"), numpy.load(f"{out}/city.boxmap")
    for name in ("boxes", "ids", "label"):
        ours = getattr(city, name)
        assert ours.dtype == raw[name].dtype and numpy.array_equal(ours, raw[name]), name
        assert not ours.flags.writeable
    assert city.boxes.ctypes.data == city.boxes.ctypes.data  # a view, not a copy
    boxes = city.boxes
    del city
    assert boxes.sum() == raw["boxes"].sum()  # the array keeps the file mapped
    lattice, raw = skyway.read_lattice(f"{out}/city.lattice"), numpy.load(f"{out}/city.lattice")
    assert numpy.array_equal(lattice.block_record, raw["block_record"])
    assert numpy.array_equal(lattice.records, raw["records"])
    masks = lattice.masks()
    assert (masks >> 31).sum() == lattice.nodes
    assert sum(int((masks >> d & 1).sum()) for d in range(13)) == lattice.edges
    roadmap, raw = skyway.read_roadmap(f"{out}/city.roadmap"), numpy.load(f"{out}/city.roadmap")
    for name in ("tile_index", "tile_extent", "tile_first", "tile_edges", "bend_position", "bend_axis", "bend_outward",
                 "edge_first", "edge_split", "edge_to"):
        ours = getattr(roadmap, name)
        assert ours.dtype == raw[name].dtype and numpy.array_equal(ours, raw[name]), name


def segments_in(scene, count):
    low, high = map(numpy.array, scene.free_bounds)
    random = numpy.random.default_rng(5)
    points = random.uniform(low, high, (count, 3))
    return numpy.hstack([points, numpy.clip(points + random.normal(0, 20, points.shape), low, high)])


def test_answers_are_those_of_the_query_tool(out, scene):
    segments = segments_in(scene, 3000)
    asked = "".join(json.dumps({"segment": [s[:3].tolist(), s[3:].tolist()]}) + "\n" for s in segments)
    asked += "".join(json.dumps({"point": s[:3].tolist()}) + "\n" for s in segments)
    answers = lines(tool("skyway-query", f"{out}/city.boxmap", "--vehicle", VEHICLE, text=asked).stdout)
    hits = scene.hits(segments)
    assert 0.05 < hits.mean() < 0.95  # both answers come
    assert hits.tolist() == [a["hit"] for a in answers[:3000]]
    points = numpy.ascontiguousarray(segments[:, :3])
    assert scene.hits(points).tolist() == [a["hit"] for a in answers[3000:]]
    distance, box = scene.nearest(points)
    assert distance.tolist() == [a["clearance"] for a in answers[3000:]]
    assert scene.map.ids[box].tolist() == [a["nearest"] for a in answers[3000:]]
    assert numpy.array_equal(scene.free(segments), ~hits)  # they all are inside the bounds
    for threads in (1, 2, 7):
        assert numpy.array_equal(scene.hits(segments, threads=threads), hits)
    assert scene.sweep_hits(segments[:100], (0, 0, 0)).sum() <= hits[:100].sum()
    assert scene.nearest(points[:1], radius=0)[1][0] == (-1 if distance[0] > 0 else box[0])
    assert scene.hits(numpy.zeros((0, 6))).shape == (0,)


def test_answers_do_not_depend_on_the_programs_arithmetic(out, scene):
    """Another rounding, as fesetround sets it: what is asked, read and proved is the same."""
    libm = ctypes.CDLL("libm.so.6")
    segments = segments_in(scene, 500)

    def answers():
        trajectory = skyway.read_trajectories(f"{out}/trajectory.jsonl")[0]
        return (skyway.Vehicle("quad2kg"), scene.free(segments).tobytes(), trajectory.points.tobytes(), scene.nearest(segments[:, :3])[0].tobytes(),
                skyway.check(scene, trajectory), skyway.check(scene, trajectory, exact=True))

    usual = answers()
    for rounding in (0x400, 0x800, 0xC00):  # down, up, to zero
        libm.fesetround(rounding)
        try:
            other = answers()
            assert libm.fegetround() == rounding
        finally:
            libm.fesetround(0)
        assert other == usual, rounding


def test_wrong_batches_are_refused(scene):
    segments = segments_in(scene, 4)
    assert "masked" in raises(ValueError, scene.hits, numpy.ma.masked_equal(segments, segments[1, 1]))
    row = numpy.ma.masked_equal([1, 2, 3.0], 3)
    assert "masked" in raises(ValueError, scene.hits, [row, row])
    assert "masked" in raises(ValueError, skyway.BoxMap, [[0, 0, 0, 1, 1, 1.0]], ids=numpy.ma.masked_equal([3], 3))
    segments[2, 3] = numpy.nan
    assert "segments[2]: coordinates must be finite" in raises(skyway.InputError, scene.hits, segments)
    raises(ValueError, scene.nearest, segments)


def test_queries_are_of_the_scene_that_they_name(out, scene):
    file = pathlib.Path(f"{out}/asked.jsonl")
    file.write_text('{"id":"a","from":[1,2,3],"to":[4,5,6],"margin":%r}\n' % scene.margin)
    assert skyway.read_queries(file, scene)[0] == ["a"]
    assert "asked of the margin" in raises(skyway.InputError, skyway.read_queries, file)
    file.write_text('{"id":"a","from":[1,2,3],"to":[4,5,6],"margin":30}\n')
    assert "another margin, 30 m" in raises(skyway.InputError, skyway.read_queries, file, scene)


def test_records_are_those_of_the_tools(out, scene):
    city, paths = f"{out}/city.boxmap", skyway.read_paths(f"{out}/paths.jsonl")
    ids, ends = skyway.read_queries(f"{out}/queries.jsonl")
    planner = skyway.Planner(scene, lattice=skyway.read_lattice(f"{out}/city.lattice"))
    planned = planner.plan_batch(ends, ids=ids, snap_ends=30)
    text = pathlib.Path(f"{out}/paths.jsonl").read_text()
    assert "".join(p.to_json() for p in planned) == text
    assert planner.plan(ends[0, :3], ends[0, 3:], id=ids[0], snap_ends=30).to_json() == text.splitlines(True)[0]
    written = lines(text)
    assert [p.points.tolist() for p in paths] == [r.get("points", []) for r in written]
    assert [p.length for p in paths if p.points.size] == [r["length"] for r in written if "length" in r]
    skyway.write_paths(f"{out}/again.jsonl", paths)
    assert [p.points.tolist() for p in skyway.read_paths(f"{out}/again.jsonl")] == [p.points.tolist() for p in paths]

    limits = {"vmax": 8, "amax": 6}
    solved = [skyway.solve(scene, p, limits=limits, solver="stop-and-go", yaw="along") for p in paths]
    file = pathlib.Path(f"{out}/trajectories.jsonl")
    assert "".join(t.to_json() for t in solved) == file.read_text()
    for ours, record in zip(skyway.read_trajectories(str(file)), lines(file.read_text())):
        segments = record["segments"]
        assert ours.status == record["status"]
        if not segments:
            assert ours.status == "no_path" and ours.points.shape == (0, 8, 3) and ours.yaw is None
            continue
        assert ours.points.shape == (len(segments), 8, 3)
        assert ours.points[:, :, 1].tolist() == [s["y"] for s in segments]
        assert ours.yaw.tolist() == [s["yaw"] for s in segments]
        assert ours.durations.tolist() == [s["duration"] for s in segments]
        assert ours.limits == record["limits"]
        copy = pickle.loads(pickle.dumps(ours))
        assert copy.id == ours.id and numpy.array_equal(copy.points, ours.points)
        position, velocity, _, _ = ours.sample(numpy.array([0.0, ours.duration]))
        assert numpy.array_equal(position[0], ours.points[0, 0]) and abs(velocity).max() < 1e-6

    reports = lines(tool("skyway-check", city, file, code=(0, 1)).stdout)
    assert [skyway.check(scene, t) for t in solved] == reports
    one = next(t for t in solved if t.status == "solved")
    assert skyway.check(scene, one, exact=True)["exact"]["ok"]
    strict = skyway.check(scene, one, limits={"vmax": 1})
    assert not strict["ok"] and strict["reason"] == "speed" and strict["limits"]["amax"] == 6
    blocked = skyway.check(scene, numpy.array([[-425, -320.5, 7], [357, 204, 5.0]]))
    assert blocked["reason"] == "collision" and blocked["box"] in scene.map.ids
    (pathlib.Path(out) / "reports.jsonl").write_text("".join(json.dumps(r) + "\n" for r in [*reports, blocked]))
    table = skyway.read_reports(f"{out}/reports.jsonl")
    assert table["id"].tolist() == [r["id"] for r in [*reports, blocked]]
    clearances = [r.get("clearance", numpy.nan) for r in reports]
    assert numpy.array_equal(table["clearance"][:-1], clearances, equal_nan=True)
    assert not table["ok"][-1] and table["reason"][-1] == "collision" and table["box"][-1] == blocked["box"]
    assert numpy.isnan(table["speed"][-1])


def test_limits_of_vehicles_hold(city):
    """Those of a profile travel, hold and are loosened by nobody."""
    tello = skyway.CollisionScene(city, "tello")
    assert tello.limits == tello.vehicle.limits and tello.limits["vmax"] == 8
    path = skyway.Planner(tello).plan((-425, -320.5, 7), (-380, -290, 12), snap_ends=5)
    assert path.status == "found" and path.vehicle.limits == tello.limits
    said = raises(skyway.UsageError, skyway.solve, tello, path, limits={"vmax": 30})
    assert "30 m/s" in said and "8 m/s" in said
    trajectory = skyway.solve(tello, path)  # needs no limits
    assert trajectory.status == "solved" and trajectory.limits == tello.limits
    report = skyway.check(tello, trajectory, limits={"vmax": 30, "amax": 30})
    assert report["ok"] and report["limits"] == {**tello.limits, "amax": 30}
    assert skyway.check(tello, trajectory, limits={"vmax": 1})["limits"]["vmax"] == 1
    report = skyway.check(tello, path, limits={"vmax": 1})  # a path has no speed
    assert not report["ok"] and report["reason"] == "speed_not_measured"
    again = skyway.CollisionScene(city, path.vehicle)
    assert again.vehicle == tello.vehicle and skyway.solve(again, path).to_json() == trajectory.to_json()
    for small in ("box:0.01,0.01,0.01", "crazyflie"):
        assert "found tello" in raises(skyway.InputError, skyway.check, skyway.CollisionScene(city, small), trajectory)
    large = skyway.CollisionScene(city, "tello", 0.1)
    assert "with margin 0.1" in raises(skyway.InputError, skyway.solve, large, path)
    assert skyway.check(large, trajectory)["margin"] == 0.1
    assert "finite" in raises(skyway.InputError, skyway.solve, tello, path, limits={"vmax": float("inf")})


def test_degrees_are_no_metres(out):
    tool("skyway-import", "-q", source_dir / "tests/golden/data/village.csv", "-o", f"{out}/village.boxmap")
    village = skyway.CollisionScene(skyway.read_box_map(f"{out}/village.boxmap"), VEHICLE)
    ends = numpy.array([[37.7925, -122.3973, 5.], [37.7926, -122.3972, 5.]])
    for function, what in ((skyway.Planner(village).plan, ends), (skyway.check, (village, ends)),
                           (skyway.Planner(village).plan_batch, (ends.reshape(1, 6),)),
                           (village.hits, (ends.reshape(1, 6),)), (village.free, (ends,)),
                           (village.sweep_hits, (ends.reshape(1, 6), [1, 1, 1])), (village.nearest, (ends,)),
                           (village.boxes_meeting, ends), (skyway.solve, (village, ends))):
        assert "look like degrees" in raises(skyway.InputError, function, *what), function


def test_errors_carry_the_tools_messages(out, scene):
    torn = pathlib.Path(out) / "torn.boxmap"
    torn.write_bytes(pathlib.Path(f"{out}/city.boxmap").read_bytes()[:-100])
    said = tool("skyway-map", "info", torn, code=3).stderr
    assert said.removeprefix("skyway-map: ").strip() == raises(skyway.InputError, skyway.read_box_map, str(torn))
    bad = pathlib.Path(out) / "bad.jsonl"
    bad.write_text('{"type":"path","id":"a","status":"found","points":[[0,0,"x"]]}\n')
    said = tool("skyway-check", f"{out}/city.boxmap", bad, "--vehicle", VEHICLE, code=3).stderr
    assert said.removeprefix("skyway-check: ").strip() == raises(skyway.InputError, skyway.read_paths, str(bad))
    assert raises(skyway.InputError, skyway.read_reports, bad).startswith(f"{bad}:1: expected a record of type")
    bad.write_text('{"type":"report","id":"a","ok":1}\n')
    assert raises(skyway.InputError, skyway.read_reports, bad) == f"{bad}:1: ok must be true or false, found 1"
    fields = error_of(skyway.read_reports, bad)
    assert (fields.source, fields.line, fields.key, fields.expected, fields.found, fields.advice) == (
        str(bad), 1, "ok", "true or false", "1", "")
    bad.write_text('{"type":"path","id":"a","status":"found","points":7}\n')
    fields = error_of(skyway.read_paths, str(bad))
    assert (fields.source, fields.line, fields.key, fields.expected, fields.found) == (
        str(bad), 1, "points", "a list", "7")
    assert error_of(skyway.read_box_map, str(torn)).line is None
    bad.write_bytes(b'{"type":"path","id":"a","status":"found","points":[["\xff",0,0]]}\n')
    assert isinstance(error_of(skyway.read_paths, str(bad)), skyway.InputError)
    said = tool("skyway-query", f"{out}/city.boxmap", "--vehicle", "bird", code=2, text="{}").stderr
    message = raises(skyway.UsageError, skyway.CollisionScene, scene.map, "bird")
    assert in_python(said).startswith(f"skyway-query: {message}\n")
    assert issubclass(skyway.InputError, ValueError) and issubclass(skyway.UsageError, ValueError)
    raises(FileNotFoundError, skyway.read_lattice, f"{out}/none.lattice")
    other = skyway.CollisionScene(scene.map, "box:1,1,1")
    assert "made for another vehicle" in raises(skyway.InputError, skyway.Planner, other,
                                                skyway.read_lattice(f"{out}/city.lattice"))
    assert "no limits on speed" in raises(skyway.UsageError, skyway.solve, scene, numpy.zeros((2, 3)))
    assert "there is no limit" in raises(skyway.InputError, skyway.solve, scene, numpy.zeros((2, 3)),
                                         limits={"speed": 1})


def test_exports_are_those_of_the_tool(out, scene):
    trajectories = skyway.read_trajectories(f"{out}/trajectory.jsonl")
    for form, options in (("crazyflie", {}), ("setpoints", {"rate": 20.0, "axes": "ned"}), ("gltf", {"tolerance": 0.1}),
                          ("wpl", {"origin": (47, 8, 400), "ground": -20.0, "speed": 3.0, "hover": True}),
                          ("qgc-plan", {"origin": (47, 8, 400), "ground": -20.0}),
                          ("dji-wpml", {"origin": (47, 8, 400), "ground": -20.0, "aircraft": "m3t", "turns": 2.0}),
                          ("kml", {"origin": (47, 8, 400)}),
                          ("geojson", {"origin": (47, 8, 400)})):
        words = [f"--{key}" if value is True else f"--{key}={','.join(map(str, value)) if key == 'origin' else value}"
                 for key, value in options.items()]
        file = f"{out}/export.{form}"
        pathlib.Path(file).unlink(missing_ok=True)
        done = tool("skyway-export", f"{out}/city.boxmap", f"{out}/trajectory.jsonl", "--format", form, *words, "-o", file,
                    code=(0, 1))
        ours = skyway.export_mission(scene, trajectories[0], form, **options)
        assert ours["ok"] == (done.returncode == 0), (form, ours, done.stderr)
        if ours["ok"]:
            assert ours["bytes"] == pathlib.Path(file).read_bytes(), form
            assert all(warning in in_python(done.stderr) for warning in ours["warnings"]), (form, ours["warnings"])
        else:
            assert ours["message"] in in_python(done.stderr) and ours["reason"] and len(ours["place"]) == 3, (form, ours)
    assert skyway.export_mission(scene, trajectories[0], "crazyflie")["ok"]
    message = raises(skyway.UsageError, skyway.export_mission, scene, trajectories[0], "kml", origin=(47, 8, 0), heading=3.0)
    assert message.startswith("heading is only for tello, dji-wpml files"), message
    assert "expected one of crazyflie" in raises(skyway.UsageError, skyway.export_mission, scene, trajectories[0], "paths-csv")
    raises(TypeError, skyway.export_mission, scene, trajectories[0], "kml", colour="red")
    raises(skyway.UsageError, skyway.export_mission, scene, trajectories[0], "setpoints", rate=-1.0)
    path = skyway.read_paths(f"{out}/path.jsonl")[0]
    assert "a path has none" in skyway.export_mission(scene, path, "crazyflie")["message"]
    higher = numpy.array([[0.0, 0.0, -50.0], [9.0, 0.0, -50.0]])
    refused = skyway.export_mission(scene, higher, "gltf")
    assert not refused["ok"] and refused["reason"] == "bounds" and refused["place"][2] <= -49, refused


def option(name, value):
    """A keyword argument as the option of a tool."""
    if value is True:
        return [f"--{name.replace('_', '-')}"]
    words = list(value) if isinstance(value, (list, tuple)) else [value]
    if name == "bounds":
        words = [x for corner in value for x in corner]
    if isinstance(value, (list, tuple)):
        words = [",".join(map(str, words))]
    return [f"--{name.replace('_', '-')}={word}" for word in words]


OBJ = "o house\n" + "".join(f"v {x} {y} {z}\n" for x in (0, 8) for y in (0, 6) for z in (0, 3)) + \
    "f 1 2 4 3\nf 5 7 8 6\nf 1 5 6 2\nf 3 4 8 7\nf 1 3 7 5\nf 2 6 8 4\n"
WORLD = """<sdf version="1.9"><world name="w"><include><uri>model://hut</uri></include></world></sdf>"""
HUT = """<sdf version="1.9"><model name="hut"><static>true</static><pose>3 4 1 0 0 0.3</pose><link name="l">
  <collision name="c"><geometry><box><size>2 3 2</size></box></geometry></collision></link></model></sdf>"""
SHIPPED = source_dir / "tests/golden/data"


def test_maps_are_those_of_the_tools(out):
    """The same boxes and history, and so the same hash, of every kind of source, whatever the options."""
    (pathlib.Path(out) / "house.obj").write_text(OBJ)
    (pathlib.Path(out) / "hut.world").write_text(WORLD)
    (pathlib.Path(out) / "models/hut").mkdir(parents=True)
    (pathlib.Path(out) / "models/hut/model.sdf").write_text(HUT)
    box = ((0, 0, 0), (60, 60, 30))
    cases = [
        ("import", skyway.import_boxes, "village.csv", {}),
        ("import", skyway.import_boxes, "village.csv", {"frame": "enu", "seal": 0, "ceiling": 90, "inflate": 0.5}),
        ("import", skyway.import_boxes, "boxes.csv", {"format": "box-csv", "units": "ft", "pad": 3, "tile": 50}),
        ("import", skyway.import_boxes, "corner.bt", {"unknown": "blocked"}),
        ("import", skyway.import_boxes, "voxels.3dmap", {"scale": 0.5, "bloat_percent": 10}),
        ("import", skyway.import_boxes, "pocket.txt", {}),
        ("import", skyway.import_boxes, f"{out}/hut.world", {"model_path": [f"{out}/models"], "slack": 0.05,
                                                             "ceiling": 20}),
        ("footprints", skyway.import_footprints, "blocks.geojson", {"allow_skipped": True, "default_height": 12}),
        ("footprints", skyway.import_footprints, "blocks.geojson", {"slack": 0.25, "floor": -1, "threads": 2,
                                                                    "allow_skipped": True, "default_height": 9}),
        ("footprints", skyway.import_footprints, "block.osm", {"origin": (60.17, 24.94)}),
        ("footprints", skyway.import_footprints, "house.city.json", {}),
        ("footprints", skyway.import_footprints, "house.city.json", {"types": ["Building"], "label_by": "object", "pad": 0}),
        ("footprints", skyway.import_footprints, "house.gml", {"storey": 2.8}),
        ("footprints", skyway.import_footprints, "surface.tif", {"height_step": 1.0}),
        ("cloud", skyway.import_cloud, "scan.laz", {}),
        ("cloud", skyway.import_cloud, "scan.las", {"ground_points": "drop", "ground_by": "shape", "ground_cell": 4.0}),
        ("cloud", skyway.import_cloud, "scan.copc.laz", {"bounds": box, "cell": 2.0}),
        ("cloud", skyway.import_cloud, "scan.pcd", {"mode": "objects", "tolerance": 2.0}),
        ("cloud", skyway.import_cloud, "scan.ply", {"voxel": 0.5, "outliers": (8, 1.5)}),
        ("cloud", skyway.import_cloud, "scan.xyz", {"units": "ft", "unknown": "blocked"}),
        ("mesh", skyway.import_model, f"{out}/house.obj", {"solid": True, "up": "z", "units": "m"}),
    ]
    for name, function, file, options in cases:
        path = SHIPPED / file
        words = [word for key, value in options.items() for word in option(key, value)]
        said = tool(f"skyway-{name}", path, "-o", f"{out}/theirs.boxmap", *words).stderr
        with warnings.catch_warnings(record=True) as warned:
            warnings.simplefilter("always")
            ours = function(path, **options)
        theirs = skyway.read_box_map(f"{out}/theirs.boxmap")
        assert ours.hash == theirs.hash and len(ours) > 0, (file, options)
        assert ours.history == theirs.history, (file, ours.history, theirs.history)
        assert [str(w.message) for w in warned] == re.findall(r"warning: (.*)", in_python(said)), (file, said)
    skyway.write_box_map(f"{out}/ours.boxmap", ours)
    tool("skyway-map", "diff", f"{out}/ours.boxmap", f"{out}/theirs.boxmap")


def test_maps_are_refused_as_by_the_tools(out):
    torn = pathlib.Path(out) / "torn.geojson"
    torn.write_bytes((SHIPPED / "blocks.geojson").read_bytes()[:200])
    header = "posX,posY,posZ,halfSizeX,halfSizeY,halfSizeZ\n"
    empty, word = pathlib.Path(out) / "header_only.csv", pathlib.Path(out) / "word.csv"
    empty.write_text(header)
    word.write_text(header + "1,2,three,1,1,1\n")
    cases = [
        ("import", skyway.import_boxes, word, {}, 3),
        ("import", skyway.import_boxes, empty, {}, 3),
        ("import", skyway.import_boxes, "window.txt", {}, 3),  # a possible obstacle that cannot be built
        ("import", skyway.import_boxes, "pocket.txt", {"pad": 3}, 2),
        ("footprints", skyway.import_footprints, "torn.osm", {}, 3),
        ("footprints", skyway.import_footprints, torn, {}, 3),
        ("footprints", skyway.import_footprints, "blocks.geojson", {}, 3),
        ("footprints", skyway.import_footprints, "blocks.geojson", {"metres": True}, 2),
        ("cloud", skyway.import_cloud, "scan.laz", {"resolution": 2.0}, 3),
        ("cloud", skyway.import_cloud, "scan.laz", {"resolution": 2.0, "voxel": 1.0}, 2),
        ("cloud", skyway.import_cloud, "empty.csv", {}, 3),
        ("mesh", skyway.import_model, "scan.ply", {}, 3),
    ]
    for name, function, file, options, code in cases:
        path = SHIPPED / file
        words = [word for key, value in options.items() for word in option(key, value)]
        said = tool(f"skyway-{name}", path, "-o", f"{out}/none.boxmap", *words, code=code).stderr
        kind = skyway.UsageError if code == 2 else skyway.InputError
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            assert f"skyway-{name}: {raises(kind, function, path, **options)}\n" in in_python(said), (file, options, said)
    raises(FileNotFoundError, skyway.import_cloud, f"{out}/none.laz")
    village = SHIPPED / "village.csv"
    for wrong, kind in (({"pad": -1}, skyway.UsageError), ({"pad": "x"}, TypeError), ({"units": "yd"}, skyway.UsageError),
                        ({"bounds": ((0, 0, 0), (1, 1))}, ValueError), ({"frame": "ned"}, skyway.UsageError),
                        ({"format": "dxf"}, skyway.UsageError), ({"height": 3}, TypeError),
                        ({"bounds": ((0, 0, 0), (9, 9, 9)), "floor": 0}, skyway.UsageError)):
        raises(kind, skyway.import_boxes, village, **wrong)
    raises(skyway.UsageError, skyway.import_cloud, SHIPPED / "scan.laz", classes=["house"])
    raises(skyway.UsageError, skyway.import_footprints, SHIPPED / "blocks.geojson", origin=(95, 0))


def test_a_missing_package_is_named(out):
    for part, package, call in (("_skyway_gis", "skyway-footprints", "import_footprints"), ("_skyway_cloud", "skyway-cloud", "import_cloud"),
                                ("_skyway_mesh", "skyway-mesh", "import_model")):
        text = f"import sys, skyway; sys.modules['{part}'] = None\ntry:\n  skyway.{call}('x')\n" \
               "except ImportError as error:\n  print(error)"
        assert package in run_python(text, out)
    text = "import sys, skyway; sys.modules['_skyway_mesh'] = None; print(len(skyway.import_boxes(sys.argv[1])))"
    assert int(run_python(text, out, str(SHIPPED / "village.csv"))) > 0  # needs no other package


def run_python(text, folder, *arguments):
    done = subprocess.run([sys.executable, "-c", text, *arguments], capture_output=True, text=True, cwd=folder,
                          env={**os.environ, "PYTHONPATH": str(python_dir.resolve())})
    assert done.returncode == 0, (text, done.stdout, done.stderr)
    return done.stdout


def test_examples_and_pages(out):
    examples = sorted((source_dir / "tools/python/examples").glob("*.py"))
    assert len(examples) == 8
    blocks = str((source_dir / "data/samples/blocks.geojson").resolve())
    for example in examples:
        lines = sum(1 for line in example.read_text().split('"""', 2)[2].splitlines() if line)
        assert lines <= (45 if example.stem in ("analyst", "lab", "researcher") else 18), (example, lines)
        assert run_python(example.read_text(), out, *([blocks] if example.stem == "analyst" else []), out)
    for picture, ending in (("comparison", "svg"), ("plan", "svg"), ("profile", "svg"), ("clearance", "svg"), ("page", "html"),
                            ("clearance", "asc"), ("cf1", "csv")):
        assert (pathlib.Path(out) / f"{picture}.{ending}").stat().st_size > 500, picture
    blocks = re.findall(r"```python\n(.*?)```", (source_dir / "docs/numpy.md").read_text(), re.S)
    assert len(blocks) >= 5
    printed = run_python("import sys; sys.modules['skyway'] = None\n" + "\n".join(blocks), out)
    assert "fastest" in printed and "tracking error" in printed
    blocks = re.findall(r"```python\n(.*?)```", (source_dir / "docs/python.md").read_text(), re.S)
    assert len(blocks) == 1
    assert "segments" in run_python(blocks[0], out)


def prepare(out):
    """What the demo makes, as far as the examples read it."""
    city = f"{out}/city.boxmap"
    tool("skyway-import", "-q", source_dir / "data/downtown.csv", "-o", city)
    tool("skyway-lattice", "-q", city, "--spacing", "10", "--connect", "26", "--vehicle", VEHICLE, "-o",
         f"{out}/city.lattice")
    tool("skyway-roadmap", "-q", city, "--vehicle", VEHICLE, "--region=-150,-150,0,150,150,60", "-o",
         f"{out}/city.roadmap")
    tool("skyway-plan", "-q", city, "--lattice", f"{out}/city.lattice", "--vehicle", VEHICLE, "--from=-425,-320.5,7",
         "--to=357,204,5", "--snap-ends", "5", "-o", f"{out}/path.jsonl")
    tool("skyway-traj", "-q", city, f"{out}/path.jsonl", "--vmax", "8", "--amax", "6", "-o", f"{out}/trajectory.jsonl")
    tool("skyway-check", "-q", city, f"{out}/trajectory.jsonl", "-o", f"{out}/report.jsonl")
    tool("skyway-fly", "-q", f"{out}/trajectory.jsonl", "--vehicle", source_dir / "data/vehicles/quad2kg.json", "-o",
         f"{out}/flight.csv", "--report-file", f"{out}/flown.jsonl")
    random = numpy.random.default_rng(3)
    queries = [{"id": f"q{i}", "from": [*random.uniform(-400, 400, 2), 12], "to": [*random.uniform(-400, 400, 2), 9]}
               for i in range(8)]
    (pathlib.Path(out) / "queries.jsonl").write_text("".join(json.dumps(q) + "\n" for q in queries))
    tool("skyway-plan", "-q", city, "--lattice", f"{out}/city.lattice", "--queries", f"{out}/queries.jsonl",
         "--vehicle", VEHICLE, "--snap-ends", "30", "-o", f"{out}/paths.jsonl", code=(0, 1))
    tool("skyway-traj", "-q", city, f"{out}/paths.jsonl", "--vmax", "8", "--amax", "6", "--solver", "stop-and-go",
         "--yaw", "along", "-o", f"{out}/trajectories.jsonl", code=(0, 1))


def test_flight_logs(out):
    log = skyway.read_flight_logs(f"{out}/flight.csv")[0]
    table = numpy.genfromtxt(f"{out}/flight.csv", delimiter=",", names=True, dtype=None, encoding="utf-8")
    assert len(log) == len(table) and numpy.array_equal(log.time, table["t_s"])
    for axis, name in enumerate(("east", "north", "up")):
        assert numpy.array_equal(log.position[:, axis], table[name + "_m"])
        assert numpy.array_equal(log.setpoint_velocity[:, axis], table[f"setpoint_v_{name}_mps"])
    assert numpy.array_equal(log.attitude[:, 0], table["qw"]) and numpy.array_equal(log.attitude[:, 3], table["qz"])
    assert numpy.array_equal(log.motors[:, 3], table["motor4"])
    assert numpy.array_equal(log.saturated, table["saturated"] != 0)
    assert numpy.isnan(log.battery).all() and not log.cut
    tool("skyway-import-flight", "-q", source_dir / "tests/golden/data/hop.ulg", "-o", f"{out}/hop.csv")
    log = skyway.read_flight_logs(f"{out}/hop.csv")[0]
    assert len(log) == 61 and 0.7 < log.battery[-1] < log.battery[0] <= 0.9 and not log.cut
    room = skyway.BoxMap([[-50, -50, -5, -40, -40, 9]], bounds=[[-60, -60, -5], [60, 60, 60]])
    with warnings.catch_warnings(record=True) as said:
        warnings.simplefilter("always")
        skyway.plot_plan(room, log)
        skyway.page(room, log)
        skyway.plot_clearance(skyway.CollisionScene(room, VEHICLE), log)
    assert len(said) == 3 and all("does not say its map" in str(one.message) for one in said), said
    asked = ~numpy.isnan(log.setpoint_position)
    assert not asked[:20].any() and asked[22:].all() and not numpy.isnan(log.position).any()  # from take-off on


with tempfile.TemporaryDirectory() as folder:
    prepare(folder)
    here = skyway.CollisionScene(skyway.read_box_map(f"{folder}/city.boxmap"), VEHICLE)
    test_arrays_are_those_of_the_files(folder)
    test_a_map_that_was_written_to_gives_no_answer(folder)
    test_answers_are_those_of_the_query_tool(folder, here)
    test_answers_do_not_depend_on_the_programs_arithmetic(folder, here)
    test_wrong_batches_are_refused(here)
    test_queries_are_of_the_scene_that_they_name(folder, here)
    test_records_are_those_of_the_tools(folder, here)
    test_errors_carry_the_tools_messages(folder, here)
    test_limits_of_vehicles_hold(here.map)
    test_exports_are_those_of_the_tool(folder, here)
    test_degrees_are_no_metres(folder)
    test_flight_logs(folder)
    test_maps_are_those_of_the_tools(folder)
    test_maps_are_refused_as_by_the_tools(folder)
    test_a_missing_package_is_named(folder)
    test_examples_and_pages(folder)
print("the module agrees with the tools")
