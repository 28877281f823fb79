"""used_options_test.py BIN_DIR SOURCE_DIR: an option that a format does not use is wrong usage. Each tool is run on a file of
each format, once without and once with each of its options: the run with it is refused (exit 2), or something else comes out."""

import hashlib
import os
import pathlib
import re
import struct
import subprocess
import sys
import tempfile

bin_dir, source_dir = (pathlib.Path(word).resolve() for word in sys.argv[1:3])
data = source_dir / "tests/golden/data"
wrong = []

# Of no format: what a run tells and how it runs; and what allows or insists, which changes nothing where nothing is asked for.
ANY = {"--help", "--help-all", "--title", "--drop-refused", "--version", "--threads", "--progress", "--stats", "--quiet", "--output", "--format", "--file-format",
       "--paths-csv", "--shard", "--memory", "--allow-skipped", "--override", "--map", "--id", "--unchecked", "--vehicle",
       "--crs", "--plan", "--tube", "--certificate", "--profile", "--profile-step", "--junit", "--moving", "--contingencies", "--show", "--metres"}

# A value that is not the default and suits the samples; None: a flag.
VALUES = {
    "--mode": "objects", "--cell": "0.7", "--step": "0.7", "--gap": "0.7", "--classes": "ground", "--noise-points": "drop", "--ground-points": "drop",
    "--outliers": "4,1", "--voxel": "0.3", "--resolution": "0.5", "--ground": "5", "--ground-by": "shape", "--ground-cell": "3",
    "--ground-slope": "0.3", "--ground-height": "0.7", "--ground-step": "2", "--ground-widest": "90", "--tolerance": "0.4",
    "--min-points": "2", "--unknown": "blocked", "--units": "ft", "--vertical-units": "ft", "--origin": "37.79,-122.39,5",
    "--seal": "3", "--floor": "-7", "--ceiling": "200", "--pad": "3", "--scale": "2", "--bloat-percent": "5", "--inflate": "0.3",
    "--bounds": "-500,-500,-9,900,900,300", "--tile": "30", "--up": "y", "--slack": "0.3", "--frame": "neu", "--solid": None,
    "--collisions-only": None, "--model-path": ".", "--without": "box", "--height-attribute": "levels", "--storey": "4",
    "--default-height": "17", "--where": "1 = 0", "--height-step": "3", "--height-units": "ft", "--axes": "north-east",
     "--margin": "0.25", "--spare": "0.05", "--takeoff-place": "5,30,0", "--geoid": "57",
    "--takeoff-height": "2", "--heading": "40", "--acceptance": "5", "--braking": "1", "--return-height": "50",
    "--terrain-height": "3", "--terrain": data / "surface.tif", "--autopilot": "px4", "--params": "p.params", "--drag": "0.3", "--navigation": "0.2,0.2",
    "--tracking": "0.2,0.2", "--departure": "12", "--epoch": "2026-05-04T06:30:00Z", "--vmax": "7", "--amax": "4", "--jmax": "5",
    "--vmax-h": "6", "--vmax-v": "3", "--tilt": "20", "--thrust": "12", "--body-rate": "90", "--yaw-rate": "50",
    "--report": "text", "--exact": None, "--no-clearance": None, "--together": None, "--separation": "9,4", "--separation-box": "3,3,3",
    "--downwash": "1,2", "--parked": "gone", "--rate": "20", "--speed": "0.7", "--hover": None, "--wpml-version": "1.0.2",
    "--aircraft": "m30", "--lost-link": "continue", "--gimbal": "-45", "--label-by": "object", "--turns": "3", "--volumes": "3", "--buffer": "2", "--python": "x.py", "--table": "x.csv",
    "--return": "rtl", "--rally": "30,5,10", "--rally-out": "x.rally", "--fence": "auto", "--fence-budget": "20", "--fence-out": "x.fence", "--params-out": "x.params",
    "--procedure": "x.txt", "--ground-model": "1", "--terrain-error": "3", "--surface-band": "20,30", "--geoid-grid": "g.gtx",
    "--home-place": "5,30,5", "--no-least-height": None, "--require-clearance": "0.5", "--sampled": None, "--ground-of": "m.boxmap",
    "--types": "house", "--vertical-error": "2", "--frames": "f-%05d.png", "--poses": "poses.jsonl",
}
# Where the same word means another thing.
OF_TOOL = {"skyway-check": {"--vmax": "1", "--amax": "2"}, "skyway-cloud": {"--origin": "37.79,-122.39"},
           "skyway-footprints": {"--origin": "37.79,-122.39"},
           "skyway-import-trajectory": {"--gap": "0.01"}, "skyway-export": {"--axes": "ned", "--tolerance": "0.05",
                             "--navigation": "50,50", "--tracking": "50,50", "--takeoff-place": "6,30,0"}}
# Used, and no other value comes out of these small samples.
MISSIONS = {"wpl", "qgc-plan"}
ALIKE = {("skyway-import", "--frame"): {"fcnd"}, ("skyway-export", "--tolerance"): {"kml", "geojson", "gltf"},
         ("skyway-export", "--spare"): {"setpoints", "kml", "geojson", "gltf", "crazyflie"},
         ("skyway-export", "--autopilot"): MISSIONS, ("skyway-export", "--params"): MISSIONS, ("skyway-export", "--drag"): MISSIONS,
         ("skyway-import-trajectory", "--gap"): {"crazyflie"}, ("skyway-check", "--acceptance"): MISSIONS, ("skyway-view", "--acceptance"): MISSIONS,
         ("skyway-view", "--margin"): {"crazyflie"},  # without a vehicle
         **{(tool, option): MISSIONS for tool in ("skyway-import-trajectory", "skyway-view") for option in ("--autopilot", "--params")}}


def run(*command):
    done = subprocess.run([str(c) for c in command], capture_output=True)
    return done.returncode, done.stdout, done.stderr.decode(errors="replace")


def options_of(tool):
    """The long names that --help-all lists."""
    names = set()
    for line in run(bin_dir / tool, "--help-all")[1].decode().splitlines():
        named = re.match(r"  (-\S+)", line)
        names.update(n for n in re.split("[,:]", named[1].replace("{false}", "")) if n.startswith("--")) if named else None
    return names - ANY


def outcome(tool, arguments, extra=()):
    for old in pathlib.Path(".").glob("x.*"):
        old.unlink()
    code, out, said = run(bin_dir / tool, *arguments, *extra)
    files = [hashlib.sha256(path.read_bytes()).hexdigest() for path in sorted(pathlib.Path(".").glob("x.*"))]
    return code, out, said, files


def look_at(tool, format, arguments):
    base = outcome(tool, arguments)
    if base[0] not in (0, 1):
        wrong.append(f"{tool} {format}: exit {base[0]}: {base[2]}")
        return
    for option in sorted(options_of(tool)):
        if option in arguments:
            continue
        if option not in VALUES:
            wrong.append(f"{tool}: no value for {option}")
            continue
        value = OF_TOOL.get(tool, {}).get(option, VALUES[option])
        changed = outcome(tool, arguments, [option] if value is None else [option, value])
        if changed == base and format not in ALIKE.get((tool, option), ()):
            wrong.append(f"{tool} {option} on {format} changes nothing and is not refused")


def maps():
    """(tool, format, file and more) of what becomes a map."""
    for format, name in (("pcd", "scan.pcd"), ("ply", "scan.ply"), ("xyz", "scan.xyz"), ("las", "scan.las"), ("laz", "scan.laz")):
        yield "skyway-cloud", format, [data / name]
    for format, name in (("box-csv", "boxes.csv"), ("fcnd", "village.csv"), ("block-text", "pocket.txt"),
                         ("world-json", "pillars.json"), ("3dmap", "voxels.3dmap"), ("octomap", "corner.bt")):
        yield "skyway-import", format, [data / name]
    run(bin_dir / "skyway-map", "to-gltf", "m.boxmap", "-o", "m.glb")
    pathlib.Path("m.obj").write_text("v 0 0 0\nv 3 0 0\nv 0 3 0\nv 0 0 3\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n")
    yield "skyway-mesh", "obj", ["m.obj"]
    yield "skyway-mesh", "gltf", ["m.glb"]
    ring = "[[24.94,60.17],[24.941,60.17],[24.941,60.171],[24.94,60.17]]"
    pathlib.Path("v.geojson").write_text('{"type":"FeatureCollection","features":[{"type":"Feature","properties":{"height":8,"levels":3},'
                                         f'"geometry":{{"type":"Polygon","coordinates":[{ring}]}}}}]}}')
    for format, name in (("vector", pathlib.Path("v.geojson").resolve()), ("osm", "block.osm"), ("cityjson", "house.city.json"),
                         ("citygml", "house.gml"), ("raster", "surface.tif")):
        yield "skyway-footprints", format, [data / name, "--allow-skipped"]


def flights():
    """(tool, format, arguments) of what flies; the files are made first."""
    pathlib.Path("g.gtx").write_bytes(struct.pack(">4d2i4f", 37, -123, 1, 1, 2, 2, 57, 57, 57, 57))
    for format, name in (("crazyflie", "t.csv"), ("setpoints", "s.csv"), ("tello", "f.txt"), ("wpl", "m.waypoints"),
                         ("qgc-plan", "m.plan"), ("dji-wpml", "m.kmz"), ("kml", "m.kml"), ("geojson", "m.geojson"), ("gltf", "l.glb"),
                         ("volume4d", "v.json")):
        more = []
        if format in ("wpl", "qgc-plan", "dji-wpml", "kml", "geojson", "volume4d"):
            more = ["--origin", "37.79248,-122.39745,0"]
        if format == "tello":
            more = ["--takeoff-height", "4"]
        arguments = ["m.boxmap", "t.jsonl", "--format", format, *more]
        run(bin_dir / "skyway-export", *arguments, "-o", name)
        yield "skyway-export", format, [*arguments, "-o", "x.out"]
        if format == "volume4d":
            continue
        if format == "tello":
            more += ["--takeoff-place", "5,30,0", "--heading", "0"]
        yield "skyway-check", format, ["m.boxmap", name, "--file-format", "auto", "--vehicle", "box:1,1,1", *more]
        if format != "setpoints":
            yield "skyway-import-trajectory", format, [name, "--map", "m.boxmap", *more]
            yield "skyway-view", format, ["m.boxmap", name, *more, "-o", "x.html"]
    pathlib.Path("paths.csv").write_text("id,x,y,z\na,5,30,5\na,9,30,6\n")
    yield "skyway-check", "paths-csv", ["m.boxmap", "paths.csv", "--paths-csv", "--vehicle", "box:1,1,1"]
    yield "skyway-import-trajectory", "paths-csv", ["paths.csv", "--map", "m.boxmap"]
    yield "skyway-check", "records", ["m.boxmap", "t.jsonl"]


def main():
    run(bin_dir / "skyway-import", data / "village.csv", "-q", "--bounds", "0,0,0,80,60,60", "-o", "m.boxmap")
    run(bin_dir / "skyway-plan", "m.boxmap", "--from", "5,30,5", "--to", "70,10,5", "--vehicle", "box:0.45,0.45,0.35", "--margin", "2",
        "-o", "p.jsonl")
    run(bin_dir / "skyway-traj", "m.boxmap", "p.jsonl", "--vmax", "2", "--amax", "4", "--solver", "stop-and-go", "-o", "t.jsonl")
    record = pathlib.Path("t.jsonl").read_text()
    pathlib.Path("t.jsonl").write_text(record.replace('"id":"q1"', '"id":"q1","epoch":"2026-05-04T06:30:00Z","start":12', 1))
    pathlib.Path("p.params").write_text("# Stack: PX4 Pro\n1\t1\tMPC_XY_CRUISE\t3.0\t9\n")
    for tool, format, arguments in (*maps(), *flights()):
        if not (bin_dir / tool).exists():
            continue
        look_at(tool, format, arguments if "-o" in arguments or "skyway-check" == tool else [*arguments, "-o", "x.out"])


with tempfile.TemporaryDirectory() as folder:
    os.chdir(folder)
    main()
print("\n".join(wrong))
sys.exit(bool(wrong))
