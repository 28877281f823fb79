"""surface_test.py PYTHON_DIR SOURCE_DIR BIN_DIR: what a user of the module sees: help, types, arguments, messages, constructors, pictures."""

import inspect
import itertools
import json
import pathlib
import pickle
import pydoc
import re
import subprocess
import shutil
import sys
import tempfile
import typing
import xml.etree.ElementTree

import numpy

python_dir, source_dir = map(pathlib.Path, sys.argv[1:3])
sys.path.insert(0, str(python_dir.resolve()))
import skyway  # noqa: E402
from skyway import _skyway, arguments  # noqa: E402

SAMPLES = source_dir / "data/samples"
PUBLIC = {name: getattr(skyway, name) for name in skyway.__all__ if name != "__version__"}
CLASSES = {name: one for name, one in PUBLIC.items() if inspect.isclass(one)}
FUNCTIONS = {name: one for name, one in PUBLIC.items() if not inspect.isclass(one)}
ROOM = skyway.BoxMap([[4, 4, 0, 6, 6, 8]], bounds=[[0, 0, 0], [10, 10, 10]])
SCENE = skyway.CollisionScene(ROOM, "box:0.2,0.2,0.2", 0.1)
PATH = skyway.Path([[1, 1, 1], [1, 9, 1], [9, 9, 1]])
TRAJECTORY = skyway.Trajectory.through([[1, 1, 1], [1, 5, 1], [1, 9, 1], [5, 9, 1], [9, 9, 1]], [0, 2, 4, 6, 8],
                                       limits={"vmax": 9, "amax": 30})


def raised(function, *arguments, **named):
    try:
        function(*arguments, **named)
    except Exception as error:
        return error
    raise AssertionError(f"{function} {arguments} {named} raised nothing")


def members(kind):
    """The public properties and methods of a class, by name."""
    found = {name: inspect.getattr_static(kind, name) for name in dir(kind) if not name.startswith("_")}
    return {name: one for name, one in found.items() if isinstance(one, (property, classmethod)) or inspect.isfunction(one)}


def function_of(member):
    return member.fget if isinstance(member, property) else getattr(member, "__func__", member)


def test_everything_has_help():
    assert len(CLASSES) == 13 and len(FUNCTIONS) > 20
    for name, one in PUBLIC.items():
        assert one.__doc__ and one.__doc__.strip()[-1] in ".:", name
        text = pydoc.plain(pydoc.render_doc(one))
        assert one.__doc__.split("\n")[0].strip() in text and f"skyway.{name}" in repr(one) or name in text, name
    for name, kind in CLASSES.items():
        for member, one in members(kind).items():
            if kind.__mro__[1] is not ValueError and member not in dir(BaseException):
                assert function_of(one).__doc__, (name, member)


def test_everything_is_typed():
    def typed(function, name):
        hints = typing.get_type_hints(function)
        named = [p for p in inspect.signature(function).parameters if p not in ("self", "cls")]
        assert set(named) | {"return"} <= set(hints), (name, hints)

    for name, function in FUNCTIONS.items():
        typed(inspect.unwrap(function), name)
    for name, kind in CLASSES.items():
        for member, one in members(kind).items():
            if not issubclass(kind, Exception):
                typed(function_of(one), (name, member))


def fits(value, hint):
    origin, inner = typing.get_origin(hint), typing.get_args(hint)
    if hint is typing.Any or isinstance(hint, typing.TypeVar):
        return True
    if origin is typing.Union:
        return any(fits(value, one) for one in inner)
    if origin is numpy.ndarray:
        kinds = typing.get_args(inner[1])
        return isinstance(value, numpy.ndarray) and (kinds[0] is typing.Any or value.dtype.type is kinds[0])
    if origin is list:
        return isinstance(value, list) and all(fits(one, inner[0]) for one in value)
    if origin is tuple:
        return isinstance(value, tuple) and len(value) == len(inner) and all(map(fits, value, inner))
    if origin is dict:
        return isinstance(value, dict) and all(fits(k, inner[0]) and fits(v, inner[1]) for k, v in value.items())
    return isinstance(value, hint) and not (hint is not bool and isinstance(value, bool))


def test_properties_are_of_their_types(objects):
    seen = set()
    for one in objects:
        for name, member in members(type(one)).items():
            if isinstance(member, property):
                hint = typing.get_type_hints(member.fget)["return"]
                assert fits(getattr(one, name), hint), (one, name, hint, getattr(one, name))
                seen.add(type(one).__name__)
    assert seen == set(CLASSES) - {"InputError", "UsageError", "Planner", "Page", "Picture"}, seen


def native_signature(function):
    """Names and defaults of a compiled function, as pybind11 writes them into its text."""
    inside = re.match(r"\w+\((.*)\) -> ", function.__doc__)[1]
    inside = re.sub(r"<[^>]*>", "", inside)
    return {name: default for name, default in re.findall(r"(\w+): [\w.\[\], ]+?(?: = ([^,]+))?(?=, \w+:|, \*|$)", inside)
            if name != "self"}


def test_signatures_are_those_of_the_compiled_part():
    pairs = [(skyway.solve, _skyway.solve), (skyway.check, _skyway.check), (skyway.check_return, _skyway.check_return),
             (skyway.ways_home, _skyway.ways_home), (skyway.check_ways_home, _skyway.check_ways_home), (skyway.Planner.plan, _skyway.Planner.plan),
             (skyway.Planner.plan_batch, _skyway.Planner.plan_batch),
             *((getattr(skyway.CollisionScene, name), getattr(_skyway.CollisionScene, name))
               for name in ("hits", "free", "sweep_hits", "nearest", "boxes_meeting"))]
    for ours, native in pairs:
        wanted = native_signature(native)
        there = {n: p.default for n, p in inspect.signature(ours).parameters.items() if n != "self"}
        assert list(there) == list(wanted), (native.__doc__, there)
        for name, default in wanted.items():
            if default:
                assert str(there[name]).strip("'") == default.strip("'"), (native, name, there[name], default)
    for name in ("BoxMap", "Lattice", "Roadmap", "Path", "Trajectory", "FlightLog", "Vehicle", "CollisionScene", "Planner"):
        inner = {m for m in vars(getattr(_skyway, name)) if not m.startswith("_")}
        assert inner <= set(members(CLASSES[name])), (name, inner - set(members(CLASSES[name])))


def calls():
    """A right call of everything that takes arguments: (callable, arguments by name)."""
    points, segments = [[1.0, 1, 1]], [[1.0, 1, 1, 2, 1, 1]]
    yield skyway.BoxMap, dict(boxes=[[0, 0, 0, 1, 1, 1]], bounds=[[0, 0, 0], [9, 9, 9]], frame="enu", ids=[7], labels=["a"],
                              origin=(47, 8, 400), seal=0.0, inflate=0.0, tile=100.0)
    yield skyway.BoxMap, dict(boxes=[[0, 0, 0, 1, 1, 1]], floor=0.0, ceiling=9.0, pad=1.0)
    yield skyway.Path, dict(points=points, id="a", hold=[1.0], velocity=[[0.0, 0, 0]])
    yield skyway.Path.from_json, dict(line=PATH.to_json())
    yield skyway.Trajectory, dict(durations=[1.0], points=numpy.zeros((1, 8, 3)), yaw=numpy.zeros((1, 8)), id="a",
                                  limits={"vmax": 1})
    yield skyway.Trajectory.from_coefficients, dict(durations=[1.0], coefficients=numpy.zeros((1, 4, 3)), id="a", limits={})
    yield skyway.Trajectory.through, dict(points=[[0, 0, 0], [1, 0, 0]], times=[0, 1], id="a", limits={})
    yield skyway.Trajectory.from_json, dict(line=TRAJECTORY.to_json())
    yield TRAJECTORY.sample, dict(times=[0.0])
    yield skyway.Vehicle, dict(name="tello")
    yield skyway.CollisionScene, dict(map=ROOM, vehicle="tello", margin=0.1)
    for ask in (SCENE.hits, SCENE.free):
        yield ask, dict(queries=segments, threads=1)
    yield SCENE.sweep_hits, dict(segments=segments, half=[0, 0, 0], threads=1)
    yield SCENE.nearest, dict(points=points, radius=9.0, threads=1)
    yield SCENE.boxes_meeting, dict(min=[0, 0, 0], max=[9, 9, 9])
    yield skyway.Planner, dict(scene=SCENE)
    words = dict(method="auto", quality="fast", resample=0.0, snap_ends=0.0, seed=0)
    yield skyway.Planner(SCENE).plan, dict(start=[1, 1, 1], goal=[9, 9, 1], id="a", **words)
    yield skyway.Planner(SCENE).plan_batch, dict(queries=segments, ids=["a"], threads=1, **words)
    yield skyway.solve, dict(scene=SCENE, path=PATH, limits={"vmax": 2, "amax": 2}, solver="closed", times="stops",
                             corridor="planes", rho=1e-3, yaw="along")
    yield skyway.check, dict(scene=SCENE, what=PATH, limits={"vmax": 2})
    yield skyway.check_return, dict(scene=SCENE, what=PATH, action="hold", return_height=5.0, home_place=[1, 1, 0], limits={"vmax": 2},
                                    autopilot="px4", navigation=[0.0, 0.0])
    yield skyway.export_mission, dict(scene=SCENE, what=PATH, format="wpl", origin=(47, 8, 400), ground=0.0, speed=2.0,
                                      autopilot="px4", navigation=(0.0, 0.0), spare=0.0)
    yield skyway.plot_plan, dict(map=ROOM, records=[PATH])
    yield skyway.plot_profile, dict(trajectory=TRAJECTORY)
    yield skyway.plot_clearance, dict(scene=SCENE, records=[PATH])
    yield skyway.page, dict(map=ROOM, records=[PATH], title="a", threads=1)
    yield skyway.import_boxes, dict(path=source_dir / "tests/golden/data/village.csv", pad=1.0, tile=100.0, seal=0.0,
                                    inflate=0.0, units="m", unknown="free", frame="enu", slack=0.1)
    yield skyway.read_queries, dict(path=SAMPLES / "queries.jsonl", scene=SCENE)
    for read, file in ((skyway.read_paths, "paths.jsonl"), (skyway.read_trajectories, "trajectories.jsonl")):
        yield read, dict(path=SAMPLES / file)


def test_wrong_and_missing_arguments_are_named():
    """Of every argument: of a wrong type, left out where it is required, an array of a wrong shape."""
    shapes = 0
    for function, right in calls():
        assert function(**right) is not None
        for name, parameter in inspect.signature(function).parameters.items():
            if parameter.default is parameter.empty:
                error = raised(function, **{key: value for key, value in right.items() if key != name})
                assert isinstance(error, TypeError) and f"'{name}'" in str(error), (function, name, error)
            if name not in right:
                continue
            asked = "vehicle" if function is skyway.Vehicle else name
            error = raised(function, **{**right, name: object()})
            assert isinstance(error, (TypeError, skyway.UsageError)) and str(error).startswith(asked), (function, name, error)
            speaks_python(error)
            if "ArrayLike" in str(parameter.annotation) and name not in ("path", "what", "ids"):
                error = raised(function, **{**right, name: numpy.zeros((2, 7))})
                assert type(error) is ValueError and str(error).startswith(name + ": expected"), (function, name, error)
                assert "found (2, 7)" in str(error), error
                assert isinstance(raised(function, **{**right, name: "abc"}), TypeError)
                shapes += 1
        assert isinstance(raised(function, **right, no_such_argument=1), TypeError)
    assert shapes > 15
    ragged = raised(SCENE.hits, [[1, 2, 3], [1, 2]])
    assert str(ragged) == "queries: expected shape (n, 6) or (n, 3), found rows of different lengths", ragged


def speaks_python(error):
    text = str(error)
    assert not re.search(r"(?<![\w`])--[a-z]", text), text
    assert "pybind" not in text and "_skyway" not in text and "Unable to cast" not in text, text


def test_values_out_of_range_speak_python(out):
    bad = pathlib.Path(out) / "bad.jsonl"
    bad.write_text('{"type":"path","id":"a","status":"found","points":7}\n')
    wrong = [
        (skyway.Vehicle, ("bird",), {}), (skyway.Vehicle, ("box:1,2",), {}), (skyway.Vehicle, ("sphere:x",), {}),
        (skyway.Vehicle, (bad.parent / "none.json",), {}), (skyway.CollisionScene, (ROOM, "tello", -1), {}),
        (skyway.solve, (SCENE, PATH), {}), (skyway.solve, (SCENE, PATH), {"limits": {"vmax": 1}}),
        (skyway.solve, (SCENE, PATH), {"limits": {"speed": 1}}), (skyway.solve, (SCENE, PATH), {"limits": {"vmax": -1}}),
        (skyway.solve, (SCENE, PATH), {"limits": {"vmax": 1, "amax": 1}, "solver": "best"}),
        (skyway.solve, (SCENE, PATH), {"limits": {"vmax": 1, "amax": 1}, "times": "now"}),
        (skyway.solve, (SCENE, PATH), {"limits": {"vmax": 1, "amax": 1}, "times": "optimised", "solver": "closed"}),
        (skyway.solve, (skyway.CollisionScene(ROOM, "tello"), PATH), {"limits": {"vmax": 100}}),
        (skyway.Planner(SCENE).plan, ((1, 1, 1), (2, 2, 2)), {"method": "magic"}),
        (skyway.Planner(SCENE).plan, ((1, 1, 1), (2, 2, 2)), {"quality": "good"}),
        (skyway.Planner(SCENE).plan, ((1, 1, 1), (2, 2, 2)), {"seed": -1}),
        (skyway.Planner(SCENE).plan, ((1, 1, numpy.nan), (2, 2, 2)), {}),
        (skyway.export_mission, (SCENE, PATH, "wpl"), {}), (skyway.export_mission, (SCENE, PATH, "tello"), {"aircraft": "m3e"}),
        (skyway.export_mission, (SCENE, PATH, "kml"), {}), (skyway.export_mission, (SCENE, PATH, "doc"), {}),
        (skyway.export_mission, (SCENE, PATH, "wpl"), {"spare": 3}), (skyway.export_mission, (SCENE, PATH, "wpl"), {"speed": 1e9}),
        (skyway.BoxMap, ([],), {}), (skyway.BoxMap, ([[1, 1, 1, 0, 0, 0]],), {}), (skyway.BoxMap, ([[0, 0, 0, 1, 1, 0]],), {}),
        (skyway.BoxMap, ([[0, 0, 0, 1, 1, 1]],), {"bounds": [[1, 1, 1], [0, 0, 0]]}),
        (skyway.BoxMap, ([[0, 0, 0, 1, 1, 1]],), {"bounds": [[0, 0, 0], [9, 9, 9]], "pad": 1}),
        (skyway.BoxMap, ([[0, 0, 0, 1, 1, 1]],), {"frame": "ned"}), (skyway.BoxMap, ([[0, 0, 0, 1, 1, 1]],), {"origin": (95, 0)}),
        (skyway.BoxMap, ([[0, 0, 0, numpy.inf, 1, 1]],), {}), (skyway.BoxMap, ([[0, 0, 0, 1, 1, 1]],), {"labels": []}),
        (skyway.Path, ([],), {}), (skyway.Path, ([[0, 0, numpy.nan]],), {}), (skyway.Trajectory, ([], []), {}),
        (skyway.Trajectory, ([0], numpy.zeros((1, 8, 3))), {}), (skyway.Trajectory, ([1], numpy.full((1, 8, 3), 1e9)), {}),
        (skyway.Trajectory.through, ([[0, 0, 0], [1, 1, 1]], [1, 0]), {}),
        (skyway.Trajectory.from_coefficients, ([1], numpy.zeros((1, 9, 3))), {}),
        (TRAJECTORY.sample, ([numpy.nan],), {}), (skyway.plot_clearance, (SCENE, []), {}), (skyway.page, (), {}),
        (skyway.read_paths, (bad,), {}), (skyway.read_trajectories, (bad,), {}), (skyway.read_reports, (bad,), {}),
        (skyway.read_box_map, (bad,), {}), (skyway.read_paths, (bad.parent / "none.jsonl",), {}),
        (skyway.read_lattice, (bad,), {}), (skyway.read_roadmap, (bad,), {}), (skyway.read_flight_logs, (bad,), {}),
        (skyway.import_boxes, (source_dir / "tests/golden/data/pocket.txt",), {"pad": 3}),
        (skyway.import_boxes, (source_dir / "tests/golden/data/flat.csv",), {"format": "csv"}),
        (skyway.Lattice, (), {}), (skyway.Roadmap, (), {}), (skyway.FlightLog, (), {}),
    ]
    for function, given, named in wrong:
        error = raised(function, *given, **named)
        assert isinstance(error, (TypeError, ValueError, OSError)), (function, error)
        speaks_python(error)


def test_no_message_of_the_libraries_names_an_option():
    """Every text of the libraries and of the options of the tools, as the module would say it."""
    texts = 0
    for folder in ("libgeom", "libplan", "libtraj", "tools/cli/option"):
        for file in itertools.chain(*((source_dir / folder).rglob(f"*.{ending}") for ending in ("cpp", "h"))):
            code = re.sub(r"(?m)^\s*//.*$", "", file.read_text())
            for text in re.findall(r'"((?:[^"\\\n]|\\.)*)"', code):
                if re.search(r"(^|[ (])--[a-z]", text) and "`" not in text and "xmllint" not in text:
                    assert "--" not in _skyway.in_python(text), (file, text, _skyway.in_python(text))
                    texts += 1
    assert texts > 50
    for told, said in (("give --default-height METRES", "give default_height METRES"), ("--vmax (or --vmax-h)", 'limits["vmax"] (or limits["vmax_h"])'),
                       ("more room (skyway-plan --margin)", "more room (margin)"), ('found "--x"', 'found "--x"'),
                       ("run `ogr2ogr --config X`, or give --up y", "run `ogr2ogr --config X`, or give up y"),
                       ("for example with xmllint --noent --dropdtd", "for example with xmllint --noent --dropdtd")):
        assert _skyway.in_python(told) == said, _skyway.in_python(told)


def test_lists_and_arrays_give_the_same():
    random = numpy.random.default_rng(4)
    segments = random.integers(0, 10, (300, 6)).astype(float)
    wanted = SCENE.hits(segments)
    assert 0.05 < wanted.mean() < 0.95
    wide = numpy.zeros((300, 12))
    wide[:, ::2] = segments
    for same in (segments.tolist(), tuple(map(tuple, segments)), segments.astype(numpy.int32), segments.astype("f4"),
                 numpy.asfortranarray(segments), wide[:, ::2], list(segments)):
        assert numpy.array_equal(SCENE.hits(same), wanted), type(same)
    assert numpy.shares_memory(arguments.array("a", segments, (None, 6)), segments)  # in place, where that is possible
    assert SCENE.hits([]).shape == (0,) and SCENE.nearest([])[0].shape == (0,)
    points = segments[:, :3].tolist()
    assert numpy.array_equal(SCENE.nearest(points)[0], SCENE.nearest(numpy.array(points))[0])
    planner = skyway.Planner(SCENE)
    assert planner.plan([1, 1, 1], numpy.array([9, 9, 1])).to_json() == planner.plan((1.0, 1, 1), (9, 9, 1)).to_json()
    assert planner.plan_batch([[1, 1, 1, 9, 9, 1]])[0].to_json() == planner.plan((1, 1, 1), (9, 9, 1)).to_json()
    assert skyway.check(SCENE, [[1, 1, 1], [1, 9, 1]]) == skyway.check(SCENE, numpy.array([[1.0, 1, 1], [1, 9, 1]]))


def test_files_may_be_paths(out):
    folder = pathlib.Path(out)
    skyway.write_box_map(folder / "room.boxmap", ROOM)
    skyway.write_paths(folder / "p.jsonl", [PATH])
    skyway.write_trajectories(folder / "t.jsonl", (one for one in [TRAJECTORY]))
    assert skyway.read_box_map(folder / "room.boxmap").hash == skyway.read_box_map(f"{out}/room.boxmap").hash == ROOM.hash
    assert skyway.read_paths(folder / "p.jsonl")[0].to_json() == PATH.to_json()
    assert skyway.read_trajectories(folder / "t.jsonl")[0].to_json() == TRAJECTORY.to_json()
    profile = source_dir / "data/vehicles/quad2kg.json"
    assert skyway.Vehicle(profile) == skyway.Vehicle(str(profile)) == skyway.CollisionScene(ROOM, profile).vehicle


def test_maps_are_made():
    village = skyway.import_boxes(source_dir / "tests/golden/data/village.csv")
    names = [village.labels[i] for i in village.label]
    again = skyway.BoxMap(village.boxes, ids=village.ids, labels=names, bounds=village.bounds, frame=village.frame,
                          origin=village.origin)
    assert again.hash == village.hash and numpy.array_equal(again.ids, village.ids) and again.origin == village.origin
    loose = skyway.BoxMap([[0, 0, 1, 2, 2, 3]], floor=0, ceiling=9, pad=5, seal=2, labels=["shed"])
    assert loose.bounds == ((-5, -5, 0), (7, 7, 9)) and loose.boxes.tolist() == [[0, 0, 0, 2, 2, 3]]  # let down to the floor
    assert [loose.labels[i] for i in loose.label] == ["shed"] and loose.ids.tolist() == [0]
    empty = skyway.BoxMap([], bounds=[[0, 0, 0], [1, 1, 1]])
    assert len(empty) == 0 and skyway.CollisionScene(empty, "sphere:0.1").free([[0.5, 0.5, 0.5]]).all()
    degrees = raised(skyway.BoxMap, [[47.3712, 8.5423, 0, 47.3713, 8.5424, 9]], origin=(47.37, 8.54, 400))
    assert isinstance(degrees, skyway.InputError) and "look like degrees" in str(degrees), degrees
    town = skyway.BoxMap([[0, 0, 0, 5, 5, 5]], origin=(47.37, 8.54, 400), pad=9, ceiling=20)
    path = skyway.Path([[47.3712, 8.5423, 9], [47.3714, 8.5425, 9]])
    for function, given in ((skyway.plot_plan, (town, path)), (skyway.page, (town, path)),
                            (skyway.check, (skyway.CollisionScene(town, "tello"), path))):
        assert "look like degrees" in str(raised(function, *given)), function


def test_trajectories_are_made():
    random = numpy.random.default_rng(8)
    durations, coefficients = random.uniform(0.5, 3, 4), random.normal(size=(4, 6, 3))
    made = skyway.Trajectory.from_coefficients(durations, coefficients, id="mine")
    starts = numpy.concatenate([[0], numpy.cumsum(durations)])
    for i, start in enumerate(starts[:-1]):
        t = numpy.linspace(0.01, 0.99, 7) * durations[i]
        position, velocity, _, _ = made.sample(start + t)
        for axis in range(3):
            curve = numpy.polynomial.Polynomial(coefficients[i, :, axis])
            assert numpy.allclose(position[:, axis], curve(t), atol=1e-9), (i, axis)
            assert numpy.allclose(velocity[:, axis], curve.deriv()(t), atol=1e-9), (i, axis)
    again = skyway.Trajectory(made.durations, made.points, yaw=random.normal(size=(4, 8)), limits={"vmax": 3})
    assert numpy.array_equal(again.points, made.points) and again.yaw.shape == (4, 8) and again.limits == {"vmax": 3}
    assert made.id == "mine" and made.status == "solved" and made.vehicle is None and made.yaw is None
    points, times = random.uniform(0, 9, (5, 3)), numpy.cumsum(random.uniform(1, 3, 5))
    through = skyway.Trajectory.through(points, times)
    position, velocity, _, _ = through.sample(times - times[0])
    assert numpy.allclose(position, points) and abs(velocity[[0, -1]]).max() < 1e-9
    assert skyway.check(SCENE, TRAJECTORY)["ok"] and not skyway.check(SCENE, skyway.Trajectory.through(
        [[1, 1, 1], [9, 9, 1]], [0, 9]))["ok"]  # through the block
    path = skyway.Path([[1, 1, 1], [2, 2, 2]], id="p", hold=[0, 2], velocity=[[1, 0, 0], [numpy.nan] * 3])
    assert path.hold.tolist() == [0, 2] and numpy.isnan(path.velocity[1]).all() and path.velocity[0].tolist() == [1, 0, 0]
    copy = pickle.loads(pickle.dumps(path))
    assert type(copy) is skyway.Path and copy.to_json() == path.to_json()


def test_zones_are_read():
    """The zones of the guide, and what is no file of zones."""
    read = skyway.read_zones(source_dir / "data/samples/town-zones.json")
    school, hospital, storks = read["zones"]
    assert read["format"] == "ed-318" and read["issued"] == "2026-04-01T00:00:00Z" and not read["warnings"]
    assert school["type"] == "PROHIBITED" and school["volumes"][0]["ring"][0] == (46.9796, 7.4506)
    assert school["periods"][0]["schedule"][0] == {"days": [0, 1, 2, 3, 4], "begin": (21600.0, 21601.0), "end": (54000.0, 54001.0)}
    assert hospital["volumes"][0]["radius"] == 60 and hospital["volumes"][0]["upper"] == (400 * 0.3048, "AGL")
    assert hospital["message"] == "Call before you fly" and not hospital["periods"]
    assert storks["volumes"][0]["upper"] == (700, "AMSL") and storks["periods"][0]["schedule"][0]["begin"] == "SR"
    assert isinstance(raised(skyway.read_zones, source_dir / "data/samples/blocks.geojson"), skyway.InputError)


def test_folders_are_checked(files):
    folder = pathlib.Path(files) / "delivery"
    report = skyway.check_submission(folder, threads=1)
    assert report["ok"] and report["flights"] == 1 and not report["not_verified"], report
    (folder / "summary.html").write_text("changed")
    refused = skyway.check_submission(folder)
    assert not refused["ok"] and refused["file"] == "manifest.json" and "summary.html" in refused["reason"], refused
    assert isinstance(raised(skyway.check_submission, files), OSError)  # no manifest
    assert isinstance(raised(skyway.check_submission, 7), TypeError)


def test_ways_home_hold(out):
    field = skyway.BoxMap([[40, 40, 0, 50, 50, 20]], bounds=[[0, 0, 0], [200, 200, 80.0]])
    scene = skyway.CollisionScene(field, "box:0.2,0.2,0.2", 1.0)
    flight = skyway.Path([[60, 60, 30], [100, 60, 30]], id="f")
    sites = pathlib.Path(out) / "pads.geojson"
    sites.write_text(json.dumps({"type": "Feature", "properties": {"id": "pad"}, "geometry": {"type": "Point", "coordinates": [80, 120]}}))
    asked = {"limits": {"vmax": 4}, "autopilot": "px4:1.17"}
    ways = skyway.ways_home(scene, flight, sites, local=True, **asked)
    assert ways and all(way["site"] == "pad" for way in ways), ways
    report = skyway.check_ways_home(scene, flight, ways, **asked)
    assert report["ok"] and report["checked"] == "contingency", report
    touching = [{**ways[0], "points": [[45, 45, 10], *ways[0]["points"]]}, *ways[1:]]
    assert skyway.check_ways_home(scene, flight, touching, **asked)["reason"] == "collision"
    assert skyway.check_ways_home(scene, flight, [], **asked)["reason"] == "return"
    returned = skyway.check_return(scene, flight, return_height=30, **asked)
    assert returned["ok"] and returned["return"]["share"] == 1, returned
    assert not skyway.check_return(scene, flight, return_height=10, home_place=[45, 45, 0], **asked)["ok"]
    for call in (lambda: skyway.check_return(scene, flight), lambda: skyway.ways_home(scene, flight, sites, local=True)):
        error = raised(call)
        assert isinstance(error, skyway.UsageError) and 'limits["vmax"]' in str(error), error
    other = [{**ways[0], "id": "g"}]
    assert isinstance(raised(skyway.check_ways_home, scene, flight, other, **asked), skyway.InputError)
    narrow = skyway.CollisionScene(field, "box:0.2,0.2,0.2", 0.1)
    assert "margin" in str(raised(skyway.ways_home, narrow, flight, sites, local=True, **asked))


def test_objects_show_themselves(objects):
    for one in objects:
        text = repr(one)
        assert "\n" not in text and len(text) < 160 and text.startswith(type(one).__name__ + "("), text
    for one in (ROOM, PATH, TRAJECTORY, skyway.plot_plan(ROOM, [PATH, TRAJECTORY]), skyway.plot_profile(TRAJECTORY),
                skyway.plot_clearance(SCENE, TRAJECTORY)):
        assert xml.etree.ElementTree.fromstring(one._repr_svg_()).tag.endswith("svg"), one
    assert all('width="640"' in one._repr_svg_() for one in (ROOM, PATH, TRAJECTORY))
    neu = skyway.BoxMap([[0, 0, 0, 1, 1, 1]], bounds=[[-9, -9, 0], [99, 9, 9]], frame="neu")  # x is north
    north = skyway.Planner(skyway.CollisionScene(neu, "sphere:0.1")).plan((3, 3, 3), (90, 3, 3))
    size = re.search(r'width="([0-9]+)" height="([0-9]+)"', north._repr_svg_())
    assert int(size[2]) > int(size[1]), size  # so the picture is high
    assert "path q1" in skyway.plot_plan(ROOM, PATH).svg and "trajectory q1" in skyway.plot_plan(ROOM, [TRAJECTORY]).svg
    many = numpy.zeros((20001, 6))
    many[:, :3] = numpy.arange(20001)[:, None]
    many[:, 3:] = many[:, :3] + 0.5
    assert skyway.BoxMap(many)._repr_svg_() is None  # too much for a notebook
    assert skyway.plot_profile(TRAJECTORY).svg.count("vmax") > 0 or "limit" in skyway.plot_profile(TRAJECTORY).svg
    page = skyway.page(ROOM, [PATH, TRAJECTORY], reports=[skyway.check(SCENE, TRAJECTORY)], title="A <room>")
    assert page.html.startswith("<!") and "A &lt;room&gt;" in page.html and page.html in __import__("html").unescape(page._repr_html_())
    other = skyway.Planner(skyway.CollisionScene(skyway.BoxMap([[0, 0, 0, 1, 1, 1]], pad=9, ceiling=9), "sphere:0.1")).plan(
        (-3, -3, 3), (5, 5, 3))
    assert isinstance(raised(skyway.plot_plan, ROOM, other), skyway.InputError)  # a path of another map


def test_mypy_agrees():
    if not shutil.which("mypy"):
        print("mypy is not installed: the types of the examples are not checked")
        return
    with tempfile.TemporaryDirectory() as cache:
        examples = sorted((source_dir / "tools/python/examples").glob("*.py"))
        for what in (["-p", "skyway", "--no-warn-return-any"], ["--follow-imports=silent", *examples]):
            done = subprocess.run(["mypy", "--strict", "--scripts-are-modules", "--cache-dir", cache, *map(str, what)], text=True,
                                  capture_output=True, env={"MYPYPATH": str(python_dir.resolve()), "PATH": "/usr/bin:/bin"})
            assert done.returncode == 0, done.stdout


def made_objects():
    """One of each class that has properties."""
    scene = SCENE
    yield from (ROOM, SCENE, PATH, TRAJECTORY, SCENE.vehicle)
    yield skyway.Planner(scene).plan((1, 1, 1), (9, 9, 1))
    yield skyway.solve(scene, PATH, limits={"vmax": 2, "amax": 2}, yaw="along")
    yield skyway.solve(scene, skyway.Planner(scene).plan((5, 5, 1), (9, 9, 1)), limits={"vmax": 2, "amax": 2})


def read_objects(files):
    yield skyway.read_lattice(files / "room.lattice")
    yield skyway.read_roadmap(files / "room.roadmap")
    yield from skyway.read_flight_logs(files / "flight.csv")


def prepare(folder, tools):
    skyway.write_box_map(folder / "room.boxmap", ROOM)
    skyway.write_trajectories(folder / "t.jsonl", [TRAJECTORY])
    timed = TRAJECTORY.to_json().replace('"id":"q1"', '"id":"q1","epoch":"2026-05-04T06:30:00Z","start":0')
    (folder / "timed.jsonl").write_text(timed if timed.endswith("\n") else timed + "\n")
    words = ["--vehicle", "box:0.2,0.2,0.2", "-q"]
    large = ["--vehicle", "box:0.3,0.3,0.2", "-q"]  # as the operation says
    for tool, *given in (("lattice", "room.boxmap", "--spacing", "1", *words, "-o", "room.lattice"),
                         ("roadmap", "room.boxmap", *words, "-o", "room.roadmap"),
                         ("fly", "t.jsonl", "-q", "--vehicle", source_dir.resolve() / "data/vehicles/quad2kg.json", "-o", "flight.csv"),
                         ("submit", "room.boxmap", "timed.jsonl", "--operation", SAMPLES.resolve() / "operation.json", *large, "--no-page",
                          "--origin", "47,8,400", "-o", "delivery")):
        subprocess.run([tools / f"skyway-{tool}", *given], cwd=folder, check=True)


with tempfile.TemporaryDirectory() as folder:
    prepare(pathlib.Path(folder), pathlib.Path(sys.argv[3]).resolve())
    everything = [*made_objects(), *read_objects(pathlib.Path(folder))]
    test_everything_has_help()
    test_everything_is_typed()
    test_properties_are_of_their_types(everything)
    test_signatures_are_those_of_the_compiled_part()
    test_wrong_and_missing_arguments_are_named()
    test_values_out_of_range_speak_python(folder)
    test_no_message_of_the_libraries_names_an_option()
    test_lists_and_arrays_give_the_same()
    test_files_may_be_paths(folder)
    test_maps_are_made()
    test_trajectories_are_made()
    test_ways_home_hold(folder)
    test_zones_are_read()
    test_folders_are_checked(folder)
    test_objects_show_themselves(everything)
    test_mypy_agrees()
print("the module says what it does")
