"""view_test.py BIN_DIR SOURCE_DIR [PICTURES]: skyway-view's page in headless Chromium, driven as a user would.

Pictures of what was seen are left in the folder PICTURES; with SKYWAY_TIME_FRAMES=1 frames are timed. Any message of the browser's console fails.
"""

import base64
import itertools
import json
import math
import os
import pathlib
import subprocess
import sys
import tempfile
import zlib

import colour_vision
from viewer import Viewer
from webdriver import Browser

bin_dir, source = (pathlib.Path(a).resolve() for a in sys.argv[1:3])
Viewer.pictures = pathlib.Path(sys.argv[3]).resolve() if len(sys.argv) > 3 else None


def run(*args, text=None, yes=True):
    done = subprocess.run([str(bin_dir / args[0]), *map(str, args[1:])], text=True, input=text,
                          capture_output=True)
    assert done.returncode in ((0,) if yes else (0, 1)), (args, done.stderr)
    return done.stdout


def flight_of(setpoints):
    """A flight log from setpoints: as asked, but 0.2 m to the east."""
    rows = ["id,t_s,east_m,north_m,up_m,v_east_mps,v_north_mps,v_up_mps,qw,qx,qy,qz,p_radps,q_radps,r_radps,setpoint_east_m,"
            "setpoint_north_m,setpoint_up_m,setpoint_v_east_mps,setpoint_v_north_mps,setpoint_v_up_mps,setpoint_yaw_rad,"
            "motor1,motor2,motor3,motor4,saturated,map"]
    for line in setpoints.splitlines()[1:]:
        t, x, y, z, vx, vy, vz, *_ = line.split(",")
        rows.append(f"q1,{t},{float(x) + 0.2},{y},{z},{vx},{vy},{vz},1,0,0,0,0,0,0,{x},{y},{z},{vx},{vy},{vz},0,"
                    "0.5,0.5,0.5,0.5,0,")
    return "\n".join(rows) + "\n"


def make_chain(table, folder, ends, traj=("--vmax", "8", "--amax", "6")):
    """Map, lattice, path, tree, trajectory, report and a flight log in the folder."""
    vehicle = ["--vehicle", "box:0.5,0.5,0.3"]
    run("skyway-import", "-q", table, "-o", folder / "map")
    run("skyway-lattice", "-q", folder / "map", "--spacing", "10", "--connect", "26", *vehicle, "-o", folder / "lattice")
    run("skyway-plan", "-q", folder / "map", *vehicle, *ends, "--snap-ends", "5", "-o", folder / "path")
    run("skyway-plan", "-q", folder / "map", *vehicle, *ends, "--snap-ends", "5", "--method", "rrt-star",
        "--iterations", "2000", "--tree", folder / "tree", "-o", folder / "sampled", yes=False)
    run("skyway-traj", "-q", folder / "map", folder / "path", *traj, "-o", folder / "trajectory")
    run("skyway-check", "-q", folder / "map", folder / "trajectory", "-o", folder / "report")
    run("skyway-export", "-q", folder / "map", folder / "trajectory", "--format", "setpoints", "-o", folder / "setpoints")
    (folder / "flight.csv").write_text(flight_of((folder / "setpoints").read_text()))


def setpoints(folder):
    rows = [list(map(float, line.split(",")[:7]))
            for line in (folder / "setpoints").read_text().splitlines()[1:]]
    return lambda t: min(rows, key=lambda row: abs(row[0] - t))


def plays_and_scrubs(viewer, folder):
    browser, at = viewer.browser, setpoints(folder)
    duration = json.loads((folder / "trajectory").read_text())["duration"]
    assert abs(viewer.get("duration") - duration) < 0.11
    assert viewer.get("time") == 0 and not viewer.get("playing")
    browser.click("#play")
    viewer.until("skyway.playing && skyway.time > 0.3")
    browser.click("#play")
    assert not viewer.get("playing")
    paused, frames = viewer.get("time"), viewer.get("frames")
    assert viewer.get("time") == paused and viewer.get("frames") <= frames + 2  # nothing moves: nothing is drawn
    browser.run("document.activeElement.blur()")
    browser.key(" ")
    viewer.until(f"skyway.playing && skyway.time > {paused}")
    browser.key(" ")
    assert not viewer.get("playing")
    x, y = browser.centre("#scrub", 0.5)
    browser.pointer(("move", x, y), ("down",), ("up",))
    time = viewer.get("time")
    assert abs(time - duration / 2) < duration * 0.03, time
    row = at(time)
    assert all(abs(a - b) < 0.6 for a, b in zip(viewer.get("position"), row[1:4])), (viewer.get("position"), row)
    speed = sum(v * v for v in row[4:7]) ** 0.5
    assert abs(viewer.get("values")["velocity"]["norm"] - speed) < 0.1


def reads_plots(viewer, folder):
    browser, at = viewer.browser, setpoints(folder)
    before, duration = viewer.get("time"), viewer.get("duration")
    browser.pointer(("move", *browser.centre("[data-plot=velocity] canvas", 0.8)))
    hover = viewer.get("hover")
    assert hover["plot"] == "velocity" and abs(hover["time"] - 0.8 * duration) < 0.06 * duration, hover
    assert viewer.get("time") == before
    row = at(hover["time"])
    values = viewer.get("values")["velocity"]
    for name, asked in zip(("east", "north", "up"), row[4:7]):
        assert abs(values[name] - asked) < 0.1, (values, row)
    shown = browser.run("return document.querySelector('[data-plot=velocity] .values').textContent")
    assert f"{values['norm']:.2f}" in shown, (shown, values)
    browser.pointer(("move", *browser.centre("#title")))
    assert viewer.get("hover") is None
    browser.click("[data-plot=clearance] canvas")
    clicked = viewer.get("time")
    assert abs(clicked - duration / 2) < 0.07 * duration
    browser.key("\ue014")  # right arrow, on the plot that was clicked
    assert clicked < viewer.get("time") < clicked + 0.01 * duration
    assert viewer.get("values")["velocity"]["norm"] <= 8.001


def looks_around(viewer):
    browser = viewer.browser
    heading, distance = viewer.get("heading"), viewer.get("distance")
    x, y = browser.centre("#view", 0.6)
    browser.pointer(("move", x, y), ("down",), ("move", x + 80, y), ("up",))
    assert viewer.get("heading") != heading
    browser.run("document.getElementById('view').focus()")
    browser.key("+")
    assert viewer.get("distance") < distance
    browser.click("#view")
    assert viewer.get("picked") is not None
    browser.key("\ue00c")  # escape
    assert viewer.get("picked") is None
    for key, mode in (("2", "top"), ("3", "follow"), ("4", "ride")):
        browser.key(key)
        assert viewer.get("camera") == mode
    viewer.until("Math.hypot(...skyway.target.map((x, i) => x - skyway.position[i])) < 1e-3")
    viewer.picture("demo-ride")
    follows_after_top(viewer)
    browser.key("h")
    assert viewer.get("camera") == "free"
    viewer.until(f"Math.abs(skyway.distance - {distance}) < 1e-6")


def follows_after_top(viewer):
    """From above to behind the vehicle: a slanted view in which no box hides it, wherever it is."""
    browser = viewer.browser
    for share in (0.2, 0.5, 0.8):
        browser.pointer(("move", *browser.centre("#scrub", share)), ("down",), ("up",))
        browser.run("document.activeElement.blur()")
        browser.key("2")
        assert viewer.get("elevation") > 1.5
        frames = viewer.get("frames")
        browser.key("3")
        viewer.until(f"skyway.frames > {frames}")
        assert viewer.get("camera") == "follow" and 0.3 < viewer.get("elevation") < 1.2, viewer.get("elevation")
        assert viewer.get("seen")
    viewer.picture("follow-after-top")


def lists_keys(viewer):
    browser = viewer.browser
    is_open = "return document.getElementById('help').open"
    browser.run("document.activeElement.blur()")
    browser.key("?")
    assert browser.run(is_open)
    words = browser.run("return document.getElementById('help').textContent")
    for key in ("Space", "1", "2", "3", "4", "H", "?", "Esc", "+", "wheel", "drag"):
        assert key in words, (key, words)
    viewer.picture("keys")
    browser.key("\ue00c")  # escape
    assert not browser.run(is_open)
    browser.click("#keys")
    assert browser.run(is_open)
    browser.click("#help button")
    assert not browser.run(is_open)


def grows_tree(viewer):
    nodes = viewer.get("trees")[0]["nodes"]
    assert viewer.get("trees")[0]["shown"] == nodes > 10
    viewer.browser.click(".grow")
    viewer.until(f"skyway.trees[0].shown < {nodes}")
    shown = viewer.get("trees")[0]["shown"]
    viewer.until(f"skyway.trees[0].shown > {shown}")
    viewer.until(f"skyway.trees[0].shown === {nodes}", 400)  # at least 32 frames, however slow


def shows_demo(browser, folder, page):
    files = [folder / f for f in ("map", "lattice", "path", "tree", "trajectory", "report", "flight.csv")]
    run("skyway-view", *files, "--title", "Downtown", "-o", page)
    assert page.stat().st_size <= 3e6, page.stat().st_size
    print(f"demo page: {page.stat().st_size} bytes")
    viewer = Viewer(browser, page)
    assert viewer.get("boxes") == 4894 and viewer.get("checks") == [{"id": "q1", "ok": True, "reason": None}]
    viewer.picture("demo-light")
    plays_and_scrubs(viewer, folder)
    reads_plots(viewer, folder)
    looks_around(viewer)
    lists_keys(viewer)
    grows_tree(viewer)
    calls = viewer.get("drawCalls")
    browser.run("[...document.querySelectorAll('#layers .head')].find(l => l.textContent.startsWith('Lattice')).click()")
    viewer.until(f"skyway.drawCalls > {calls}")
    browser.click(".kinds [data-value='1']")
    assert viewer.get("motion") == "q1 (flown)"
    assert abs(viewer.get("values")["error"]["from the setpoint"] - 0.2) < 1e-3
    browser.click("#theme")
    assert viewer.get("theme") == "dark"
    viewer.picture("demo-dark")
    fits_a_phone(browser, page)
    narrow = Viewer(browser, page, "dark", (390, 844))
    narrow.picture("demo-narrow")
    distance = narrow.get("distance")
    browser.pinch(*browser.centre("#view"), 80, 240)
    assert narrow.get("distance") < 0.6 * distance, (narrow.get("distance"), distance)
    narrow.quiet()


def unlike(viewer, picture):
    """Mean difference, in levels of 256, between the frame that is shown and a PNG file."""
    data = base64.b64encode(picture.read_bytes()).decode()
    return viewer.browser.run("""
      return (async () => {
        const other = new Image();
        other.src = "data:image/png;base64,%s";
        const levels = async image => {
          await image.decode();
          const canvas = document.createElement("canvas"), c = canvas.getContext("2d");
          canvas.width = image.naturalWidth;
          canvas.height = image.naturalHeight;
          c.drawImage(image, 0, 0);
          return c.getImageData(0, 0, canvas.width, canvas.height).data;
        };
        const a = await levels(document.querySelector(".frame img")), b = await levels(other);
        return a.length === b.length ? a.reduce((sum, v, i) => sum + Math.abs(v - b[i]), 0) / a.length : 256;
      })()""" % data)


def shows_frames(browser, folder, page):
    (folder / "camera").write_text('{"width":320,"height":240,"fx":190}')
    (folder / "frames").mkdir()
    names = folder / "frames" / "f-%05d.png"
    run("skyway-render", "-q", folder / "map", folder / "trajectory", "--camera", folder / "camera", "--rate", "2",
        "-o", names, "--poses", folder / "poses")
    # The flight stands first; the poses say that it is the trajectory which the camera went along.
    files = [folder / f for f in ("map", "flight.csv", "trajectory")]
    run("skyway-view", *files, "--frames", names, "--poses", folder / "poses", "--title", "Frames", "-o", page)
    assert page.stat().st_size < 4e6, page.stat().st_size
    viewer = Viewer(browser, page)
    assert viewer.get("motion") == "q1 (planned)" and viewer.get("frame") == 0
    for share in (0.3, 0.8, 0.1):
        browser.pointer(("move", *browser.centre("#scrub", share)), ("down",), ("up",))
        frame = int(2 * viewer.get("time"))
        assert frame > 0 and viewer.get("frame") == frame, (frame, viewer.get("frame"), viewer.get("time"))
        near, far = (unlike(viewer, pathlib.Path(str(names) % k)) for k in (frame, frame + 20))
        assert near < 4 < far, (near, far)
        assert f"{frame / 2:.2f}" in browser.run("return document.querySelector('.frame figcaption').textContent")
    before = viewer.get("frame")
    browser.click("#play")
    viewer.until(f"skyway.frame > {before}")
    browser.click("#play")
    assert viewer.get("frame") == int(2 * viewer.get("time"))
    image, plot = (browser.run(f"return document.querySelector('{where}').getBoundingClientRect().toJSON()")
                   for where in (".frame img", "[data-plot=height]"))
    assert image["bottom"] <= plot["top"] and image["height"] > 100, (image, plot)
    browser.pointer(("move", *browser.centre("#scrub", 0.4)), ("down",), ("up",))
    assert unlike(viewer, pathlib.Path(str(names) % viewer.get("frame"))) < 4
    viewer.picture("frames")
    browser.click(".kinds [data-value='1']")
    assert viewer.get("motion") == "q1 (flown)" and viewer.get("frame") is None
    assert browser.run("return document.querySelector('.frame').getBoundingClientRect().height") == 0
    viewer.quiet()


def shows_failure(browser, folder, page):
    run("skyway-check", "-q", folder / "map", folder / "trajectory", "--vehicle", "box:2,2,2", "-o",
        folder / "failed", yes=False)
    report = json.loads((folder / "failed").read_text())
    assert not report["ok"] and report["frame"] == "neu"
    run("skyway-view", *[folder / f for f in ("map", "path", "trajectory", "failed")], "--title", "Failed", "-o", page)
    viewer = Viewer(browser, page)
    assert viewer.get("checks") == [{"id": "q1", "ok": False, "reason": report["reason"]}]
    place = [report["place"][k] for k in (1, 0, 2)]
    assert all(abs(a - b) < 1e-3 for a, b in zip(viewer.get("target"), place)) and viewer.get("distance") <= 60  # it opens there
    browser.key("h")
    browser.click(".check.failed button")
    assert all(abs(a - b) < 1e-3 for a, b in zip(viewer.get("target"), place)), viewer.get("target")
    assert abs(viewer.get("time") - report["time"]) < 1e-6
    assert viewer.get("picked") is not None
    words = browser.run("return document.querySelector('.check.failed').textContent")
    assert "collides with an obstacle" in words and str(report["box"]) in words, words
    viewer.picture("failed")


def shows_home(browser, folder, page):
    """The autopilot's return and planned ways: from the vehicle, on the bar of the time, in colours and in words."""
    run("skyway-check", "-q", folder / "map", folder / "trajectory", "--return", "-o", folder / "returns", yes=False)
    report = json.loads((folder / "returns").read_text())
    returned, enu = report["return"], lambda p: [p[1], p[0], p[2]]
    assert report["reason"] == "return" and returned["gaps"] and report["frame"] == "neu"
    end, gaps = returned["duration"], returned["gaps"]
    home = returned["home"]
    made_for = {key: report[key] for key in ("map", "frame", "vehicle", "margin")}
    way = {"type": "contingency", "id": "q1", **made_for, "site": "pad <1>", "length": 120, "duration": 40,
           "points": [[home[0], home[1], 90], [home[0] + 30, home[1], 90], [home[0] + 30, home[1], 0]]}
    ways = [{**way, "from": 0, "until": 0.3 * end, "latest_departure": 0.3 * end},
            {**way, "from": 0.3 * end, "until": 0.6 * end, "latest_departure": 0.5 * end},
            {"type": "contingency", "id": "q1", **made_for, "status": "unreachable", "from": 0.6 * end, "until": end, "message": "nowhere"}]
    (folder / "ways").write_text("".join(json.dumps(w) + "\n" for w in ways))
    run("skyway-view", *[folder / f for f in ("map", "trajectory", "returns", "ways")], "--title", "Ways home", "-o", page)
    viewer = Viewer(browser, page)
    tab = "return document.querySelector('[role=tab][aria-selected=true]').textContent"
    assert browser.run(tab) == "Ways home"
    parts = viewer.get("homes")[0]["parts"]
    assert parts[0]["from"] == 0 and abs(parts[-1]["until"] - end) < 1e-6
    assert all(a["until"] == b["from"] and a["kind"] != b["kind"] for a, b in zip(parts, parts[1:]))
    in_gap = lambda t: any(g["from"] <= t <= g["until"] for g in gaps)
    for part in parts:
        middle = (part["from"] + part["until"]) / 2
        kind = "proved" if not in_gap(middle) else "planned" if middle <= 0.5 * end else "none"
        assert part["kind"] == kind, (part, kind)
    draws_ways_home(viewer, returned, way, enu)
    marks = browser.run("return [...document.querySelectorAll('.home-marks span')].map(s => [s.className, s.getBoundingClientRect().left])")
    assert [kind for kind, _ in marks] == [p["kind"] for p in parts] and marks == sorted(marks, key=lambda m: m[1])
    jumps_to_gaps(viewer, gaps)
    colours_ways_home(viewer)
    browser.key("h")
    for scheme in ("light", "dark"):
        viewer.picture(f"home-{scheme}")
        browser.click("#theme")
    viewer.quiet()


def shows_home_of_mission(browser, folder, page):
    """A mission's file has no times: its way is coloured by the timeline of the report, and followed along it."""
    mission, town = source / "data/samples/town.waypoints", folder / "town"
    run("skyway-footprints", source / "data/samples/town.geojson", "--allow-skipped", "--ceiling", "120", "--pad", "60", "-q", "-o", town)
    flown = ["--vehicle", "quad2kg", "--margin", "1"]
    height = ["--ground", "0", "--return-height", "20"]
    run("skyway-check", town, mission, *flown, *height, "--return", "-q", "-o", folder / "town-returns", yes=False)
    returned = json.loads((folder / "town-returns").read_text())["return"]
    assert returned["gaps"] and len(returned["timeline"]) > 4
    run("skyway-view", town, mission, folder / "town-returns", *height, "-o", page)
    viewer = Viewer(browser, page)
    parts = viewer.get("homes")[0]["parts"]
    assert [p["kind"] for p in parts] == ["proved", "none", "proved"] and parts[-1]["until"] == returned["duration"]
    assert (parts[1]["from"], parts[1]["until"]) == (returned["gaps"][0]["from"], returned["gaps"][-1]["until"])
    assert viewer.get("motion").endswith("(estimated)")
    for one in returned["timeline"][1:-1]:
        share = one["time"] / returned["duration"]
        browser.pointer(("move", *browser.centre("#scrub", share)), ("down",), ("up",))
        time, position = viewer.get("time"), viewer.get("position")
        near = min(math.dist(position, [a + (b - a) * k / 100 for a, b in zip(s["at"], e["at"])])
                   for s, e in itertools.pairwise(returned["timeline"]) if s["time"] <= time <= e["time"] for k in range(101))
        assert near < 2, (time, position)
    viewer.picture("home-mission")
    viewer.quiet()


def draws_ways_home(viewer, returned, way, enu):
    """What is drawn begins at the vehicle, and ends on the ground at home or on the site."""
    browser, seen = viewer.browser, set()
    for share in (0.02, 0.2, 0.4, 0.55, 0.9):
        browser.pointer(("move", *browser.centre("#scrub", share)), ("down",), ("up",))
        viewer.until("skyway.home.drawn === skyway.time")
        now, time = viewer.get("home"), viewer.get("time")
        gap = next((g for g in returned["gaps"] if g["from"] <= time <= g["until"]), None)
        line = now["none"] if gap else now["proved"]
        assert bool(now["none"]) == bool(gap) and abs(now["time"] - time) < 1e-9
        position, home = viewer.get("position"), enu(returned["home"])
        top = max(position[2], home[2] + returned["height"])
        expected = [*position, *position[:2], top, *home[:2], top, *home]
        assert all(abs(a - b) < 1e-2 for a, b in zip(line, expected, strict=True)), (line, expected)
        planned = time <= 0.5 * returned["duration"]
        assert bool(now["planned"]) == planned, now
        if planned:
            expected = [*position, *(v for p in way["points"] for v in enu(p))]
            assert all(abs(a - b) < 1e-2 for a, b in zip(now["planned"], expected, strict=True))
            assert abs(now["left"] - (0.5 * returned["duration"] - time)) < 1e-6
        said = browser.run("return document.querySelector('.home-now').textContent")
        assert said == now["words"] and ("No return is proved" in said) == bool(gap), said
        assert ("pad <1>" in said) == planned and ("No planned way home" in said) != planned, said
        seen.add((bool(gap), planned))
    assert len(seen) >= 2, seen


def jumps_to_gaps(viewer, gaps):
    """By the key to times without any way home; by the list to each gap, and to what is met there."""
    browser = viewer.browser
    begins = [p["from"] for p in viewer.get("homes")[0]["parts"] if p["kind"] == "none"]
    browser.run("document.activeElement.blur()")
    browser.pointer(("move", *browser.centre("#scrub", 0)), ("down",), ("up",))
    browser.run("document.activeElement.blur()")
    for begin in [*begins, begins[0]]:
        browser.key("g")
        assert abs(viewer.get("time") - begin) < 1e-9, (viewer.get("time"), begin)
    rows = browser.run("return document.querySelectorAll('.home-details table')[0].querySelectorAll('tbody tr').length")
    assert rows == len(gaps)
    browser.click(".home-details tbody button")
    assert abs(viewer.get("time") - gaps[0]["from"]) < 1e-9
    chosen = browser.run("return [...document.querySelectorAll('.home-details tr.chosen')].map(r => r.textContent)")
    assert any("obstacle" in words for words in chosen), chosen
    assert gaps[0].get("box") is None or viewer.get("picked") is not None
    place = [gaps[0]["at"][k] for k in (1, 0, 2)]
    assert all(abs(a - b) < 1e-3 for a, b in zip(viewer.get("target"), place))
    viewer.picture("home-gap")


def colours_ways_home(viewer):
    """By ways home, by the time that is left, and plainly."""
    for value, keys in (("left", ["none proved"]), ("velocity", []), ("home", ["return proved", "only a planned way", "none proved"])):
        viewer.browser.run("const s = [...document.querySelectorAll('#layers select')].find(e => [...e.options].some(o => "
                           f"o.value === 'home')); s.value = '{value}'; s.dispatchEvent(new Event('change'))")
        words = viewer.browser.run("return [...[...document.querySelectorAll('.layer')].find(l => l.textContent.startsWith('Motion'))"
                                   ".querySelectorAll('.keys li')].map(l => l.textContent)")
        assert words == keys, (value, words)
        viewer.picture(f"home-{value}")


def shows_large_city(browser, folder, page):
    table = run("skyway-synth", "--size", "4200", "--seed", "3")
    run("skyway-import", "-q", "-", "-o", folder / "large", text=table)
    run("skyway-view", folder / "large", "--title", "A large city", "-o", page)
    viewer = Viewer(browser, page, "dark")
    unpacks(viewer)
    assert viewer.get("boxes") >= 100000 and viewer.get("triangles") <= 2 * 6 * viewer.get("boxes") + 100
    assert viewer.get("drawCalls") <= 6  # boxes and blocks twice: first for their outlines
    viewer.figures("large city")
    viewer.picture("large-dark")
    shows_detail_near(viewer)


def shows_detail_near(viewer):
    """From afar blocks are drawn, one a building at most here; near the camera the boxes themselves, which can be picked."""
    near, far = viewer.get("drawn")
    assert near == 0 and 0 < far <= viewer.get("boxes"), (near, far)
    browser = viewer.browser
    frames = viewer.get("frames")
    browser.run("document.getElementById('view').focus()")
    for _ in range(20):
        browser.key("+")
    viewer.until(f"skyway.frames > {frames} && skyway.drawn[0] > 0")
    browser.click("#view")
    assert viewer.get("picked") is not None
    assert "Id in the source" in browser.run("return document.getElementById('picked').textContent")
    viewer.picture("large-near")
    corners = viewer.get("pickedCorners")
    assert all(low < high for low, high in zip(corners[:3], corners[3:])), corners


def unpacks(viewer):
    """Raw deflate data of every kind of block, as zlib wrote them."""
    plain = bytes(i * i % 251 for i in range(9000)) + bytes(40000) + os.urandom(3000)
    for level, kind in ((0, zlib.Z_DEFAULT_STRATEGY), (1, zlib.Z_DEFAULT_STRATEGY), (9, zlib.Z_DEFAULT_STRATEGY), (9, zlib.Z_FIXED)):
        packer = zlib.compressobj(level, zlib.DEFLATED, -15, 9, kind)
        data = base64.b64encode(packer.compress(plain) + packer.flush()).decode()
        found = viewer.browser.run("const d = Uint8Array.from(atob(arguments[0]), c => c.charCodeAt(0));"
                                   "return btoa(Array.from(skyway.unpack(d, arguments[1]), v => String.fromCharCode(v)).join(''))", data, len(plain))
        assert base64.b64decode(found) == plain, (level, kind)


def shows_labels(browser, folder, page):
    """Labels, ids and titles that would break a page if they were pasted into it."""
    (folder / "labels.csv").write_text("min_x_m,min_y_m,min_z_m,max_x_m,max_y_m,max_z_m,label\n"
                                       "0,0,0,5,5,9,</script><b>house\n10,0,0,15,5,4,shed\n")
    run("skyway-import", "-q", folder / "labels.csv", "-o", folder / "labels")
    run("skyway-view", folder / "labels", "--title", "<i>T & {{script}}", "-o", page)
    viewer = Viewer(browser, page)
    assert browser.run("return document.title") == "<i>T & {{script}}"
    browser.run("const s = document.querySelector('#layers select'); s.value = 'label'; s.dispatchEvent(new Event('change'))")
    keys = browser.run("return [...document.querySelectorAll('#layers .keys li')].map(l => l.children[1].textContent)")
    assert keys == ["</script><b>house", "shed"], keys
    assert browser.run("return document.querySelectorAll('b').length") == 0
    viewer.picture("labels")


def shows_buildings(browser, folder, page):
    """Strips that touch are one building: by label, or else by the height of their tops."""
    strips = [f"{i},0,0,{i + 1},{5 + i % 2},9," for i in range(6)]
    for name, rows in (("labelled", [r + "hall" for r in strips] + ["20,0,0,25,5,9,hall", "6,0,0,9,5,9,shed"]),
                       ("plain", strips + ["20,0,0,25,5,9,", "6,0,0,9,5,8.5,"])):
        table = folder / f"{name}.csv"
        table.write_text("\n".join(["min_x_m,min_y_m,min_z_m,max_x_m,max_y_m,max_z_m,label", *rows]) + "\n")
        run("skyway-import", "-q", table, "-o", folder / name)
        run("skyway-view", folder / name, "-o", page)
        viewer = Viewer(browser, page)
        assert viewer.get("boxes") == 8 and viewer.get("buildings") == 3, (name, viewer.get("buildings"))
        viewer.picture(f"buildings-{name}")


def shows_room(browser, folder, page):
    """A block's colour is its own, and the room has walls; those of a city that only end with its boxes are not drawn."""
    (folder / "room.txt").write_text("boundary 0 0 0 6 8 3\nblock 1 2 0 2 3 3 255 0 0\nblock 3 5 0 4 6 2 0 0 255\n")
    run("skyway-import", "-q", folder / "room.txt", "-o", folder / "room")
    run("skyway-view", folder / "room", "--title", "A room", "-o", page)
    viewer = Viewer(browser, page)
    layers = "return document.getElementById('layers').textContent"
    assert "6.0 × 8.0 × 3.0" in browser.run(layers)
    colours = browser.run("return [...document.querySelectorAll('#layers .keys .swatch')].map("
                          "s => getComputedStyle(s).backgroundColor)")
    assert colours == ["rgb(255, 0, 0)", "rgb(0, 0, 255)"], colours
    viewer.picture("room")
    closes_with_stubs(browser, folder, page)
    (folder / "west.csv").write_text("lat0 37.79248, lon0 -122.39745\nposX,posY,posZ,halfSizeX,halfSizeY,halfSizeZ\n0,0,5,5,5,5\n")
    run("skyway-import", "-q", folder / "west.csv", "-o", folder / "west")
    run("skyway-view", folder / "west", "-o", page)
    viewer = Viewer(browser, page)
    assert "Bounds" not in browser.run(layers)
    contents = browser.run("return document.getElementById('side').textContent")
    assert "37.79248° N, 122.39745° W" in contents, contents
    viewer.quiet()


def closes_with_stubs(browser, folder, page):
    """Walls between the camera and the room are cut down; dark pillars are seen in the dark."""
    (folder / "lab.txt").write_text("boundary 0 0 0 8 6 3\nblock 0 0 0 0.1 6 3 200 200 200\nblock 7.9 0 0 8 6 3 200 200 200\n"
                                    "block 0 0 0 8 0.1 3 200 200 200\nblock 0 0 2.9 8 6 3 90 90 90\nblock 3 3 0 3.3 3.3 3 16 16 20\n")
    run("skyway-import", "-q", folder / "lab.txt", "-o", folder / "lab")
    run("skyway-view", folder / "lab", "--title", "A lab", "-o", page)
    for scheme in ("light", "dark"):
        viewer = Viewer(browser, page, scheme)
        assert sorted(t >> 4 for t in viewer.get("boxTraits")) == [0, 1, 2, 3, 5]
        viewer.picture(f"lab-{scheme}")
    seen = browser.run("return skyway.seenContrast('#101014')")
    assert seen >= 3, seen


def make_missions(folder, count):
    """Side by side over a few houses, each with path and trajectory."""
    rows = [f"{x},{y},0,{x + 12},{y + 20},{8 + x % 9},house" for x in range(10, 190, 30) for y in range(20, 180, 40)]
    (folder / "houses.csv").write_text("\n".join(["min_x_m,min_y_m,min_z_m,max_x_m,max_y_m,max_z_m,label", *rows]) + "\n")
    queries = ["id,from_x,from_y,from_z,to_x,to_y,to_z"]
    queries += [f"m{i},{10 + 180 * i / (count - 1)},10,30,{10 + 180 * i / (count - 1)},190,30" for i in range(count)]
    (folder / "queries.csv").write_text("\n".join(queries) + "\n")
    run("skyway-import", "-q", folder / "houses.csv", "--bounds", "0,0,0,200,200,60", "-o", folder / "houses")
    run("skyway-plan", "-q", folder / "houses", "--vehicle", "box:0.5,0.5,0.3", "--queries", folder / "queries.csv",
        "-o", folder / "paths")
    run("skyway-traj", "-q", folder / "houses", folder / "paths", "--vmax", "8", "--amax", "6", "--solver", "closed",
        "-o", folder / "trajectories")


def told_apart(missions):
    """Any two have different patterns, or colours that are far apart to every eye."""
    for one, other in itertools.combinations(missions, 2):
        if one["pattern"] != other["pattern"]:
            continue
        for eye in colour_vision.EYES:
            apart = colour_vision.distance(one["colour"], other["colour"], eye)
            assert apart > 15, (eye, one, other, apart)


def shows_missions(browser, folder, page):
    make_missions(folder, 10)
    run("skyway-view", folder / "houses", folder / "paths", folder / "trajectories", "--title", "Ten missions", "-o", page)
    chosen = "return [...document.querySelectorAll('.mission[aria-pressed=true]')].map(b => b.dataset.mission)"
    for scheme in ("light", "dark"):
        viewer = Viewer(browser, page, scheme)
        missions = viewer.get("missions")
        assert [m["id"] for m in missions] == [f"m{i}" for i in range(10)]
        assert sum(m["label"] for m in missions) >= 8 and missions[0]["label"], missions
        told_apart(missions)
        viewer.picture(f"missions-{scheme}")
    assert browser.run("return document.querySelectorAll('#side select').length") == 0
    for i in (7, 3):  # its line
        browser.pointer(("move", *missions[i]["at"]), ("down",), ("up",))
        assert viewer.get("mission") == f"m{i}" and viewer.get("motion") == f"m{i} (planned)", viewer.get("mission")
        assert browser.run(chosen) == [f"m{i}"] and viewer.get("picked") is None
    browser.click("[data-mission=m9]")  # its entry in the list
    assert viewer.get("mission") == "m9" and browser.run(chosen) == ["m9"]
    browser.key("n")
    assert viewer.get("mission") == "m0"
    browser.key("p")
    assert viewer.get("mission") == "m9"
    label = browser.run("const l = [...document.querySelectorAll('.mission-label')].find(e => e.textContent === 'm5')"
                        ".getBoundingClientRect(); return [l.left + l.width / 2, l.top + l.height / 2]")
    browser.pointer(("move", *label), ("down",), ("up",))  # its name
    assert viewer.get("mission") == "m5"
    viewer.quiet()
    run("skyway-view", folder / "houses", folder / "paths", "-o", page)  # paths alone
    viewer = Viewer(browser, page)
    browser.click("[data-mission=m4]")
    assert viewer.get("mission") == "m4" and viewer.get("motion") is None
    viewer.picture("missions-paths")


def make_fleet(folder, count):
    """Flights over the houses, one each two seconds, in two directions that cross; some begin late."""
    make_missions(folder, 2)
    lines = []
    for i in range(count):
        across, along = 5 + 190 * i / (count - 1), (10, 190) if i % 2 else (190, 10)
        ends = [(across, along[0], 40), (across, along[1], 40)] if i % 3 else [(along[0], across, 40), (along[1], across, 40)]
        query = {"id": f"f{i:03}", "from": ends[0], "to": ends[1], "epoch": "2026-05-04T06:30:00Z", "start": 60 + 2 * i,
                 "earliest": 60 + 2 * i - i % 5}
        lines.append(json.dumps(query))
    (folder / "fleet.queries").write_text("\n".join(lines) + "\n")
    run("skyway-plan", "-q", folder / "houses", "--vehicle", "box:0.5,0.5,0.3", "--queries", folder / "fleet.queries", "-o", folder / "fleet.paths")
    run("skyway-traj", "-q", folder / "houses", folder / "fleet.paths", "--vmax", "8", "--amax", "6", "--solver", "closed", "-o",
        folder / "fleet.flights")
    run("skyway-check", "-q", folder / "houses", folder / "fleet.flights", "--together", "--separation", "10,5", "--parked", "gone",
        "-o", folder / "fleet.report", yes=False)


def shows_fleet(browser, folder, page):
    """A hundred flights and twenty at once: one clock, one draw call, the nearest pair, a list that is still of use."""
    make_fleet(folder, 120)
    flights = [json.loads(line) for line in (folder / "fleet.flights").read_text().splitlines()]
    run("skyway-view", *[folder / f for f in ("houses", "fleet.paths", "fleet.flights", "fleet.report")], "--title", "Fleet", "-o", page)
    print(f"fleet page: {page.stat().st_size} bytes")
    viewer = Viewer(browser, page)
    last = max(f["start"] + f["duration"] for f in flights)
    assert abs(viewer.get("duration") - (last - 60)) < 1e-3 and viewer.get("fleet")["flights"] == 120
    assert viewer.get("drawCalls") < 25, viewer.get("drawCalls")
    viewer.figures("120 flights")
    opens_when_busiest(viewer, flights)
    for share in (0.3, 0.6):
        browser.pointer(("move", *browser.centre("#scrub", share)), ("down",), ("up",))
        time = viewer.get("time") + 60
        viewer.until(f"skyway.fleet.airborne === {sum(f['start'] <= time <= f['start'] + f['duration'] for f in flights)}")
    viewer.picture("fleet")
    browser.run("[...document.querySelectorAll('[role=tab]')].find(t => t.textContent === 'Motion').click()")
    finds_flights(viewer)
    colours_flights(viewer)
    jumps_to_pairs(viewer, [json.loads(line) for line in (folder / "fleet.report").read_text().splitlines()])
    browser.click("#theme")
    browser.key("h")
    viewer.picture("fleet-dark")


def airborne_at(flights, time):
    return sum(f["start"] <= time <= f["start"] + f["duration"] for f in flights)


def opens_when_busiest(viewer, flights):
    """When the most flights are in the air, with a summary in front."""
    most = max(airborne_at(flights, f["start"]) for f in flights)
    viewer.until(f"skyway.fleet.airborne === {most}")
    assert airborne_at(flights, viewer.get("time") + 60) == most
    tab = "return document.querySelector('[role=tab][aria-selected=true]').textContent"
    assert viewer.browser.run(tab) == "Summary"
    viewer.picture("fleet-summary")
    viewer.browser.click("#densest")
    assert airborne_at(flights, viewer.get("time") + 60) == most


def sets_refused_apart(browser, folder, page):
    """Flights that were refused before are no failure of those that fly: a sentence in green, and they beside it."""
    flights = [json.loads(line) for line in (folder / "fleet.flights").read_text().splitlines()]
    above = [{**f, "id": f"g{i}", "start": 60 + 600 * i} for i, f in enumerate(flights[:3])]
    refused = [{"type": "trajectory", "id": f"r{i}", "status": "infeasible", "message": "no way out", "segments": [],
                "epoch": flights[0]["epoch"]} for i in range(2)]
    (folder / "calm").write_text("".join(json.dumps(r) + "\n" for r in above + refused))
    run("skyway-check", "-q", folder / "houses", folder / "calm", "--together", "--separation", "10,5", "--parked", "gone",
        "-o", folder / "calm.report", yes=False)
    together = json.loads((folder / "calm.report").read_text().splitlines()[-1])
    assert not together["ok"] and together["refused"] == 0 and together["left_out"] == 2, together
    run("skyway-view", folder / "houses", folder / "calm", folder / "calm.report", "-o", page)
    viewer = Viewer(browser, page)
    lines = browser.run("return [...document.querySelectorAll('.summary-panel .verdict-line')].map(l => [l.className, l.textContent])")
    assert lines and all("good" in kind and "bad" not in kind for kind, _ in lines), lines
    assert "All 3 pairs of 3 flights are proved apart." in lines[0][1], lines
    assert "exact numbers" not in browser.run("return document.querySelector('.summary-panel').textContent")  # nobody asked for --exact
    assert "2 flights were refused before" in browser.run("return document.querySelector('.summary-panel .aside').textContent")
    assert not browser.run("return [...document.querySelectorAll('#side .bad, .summary .bad')].some(e => e.textContent)")
    assert "failed" not in browser.run("return document.getElementById('summary').textContent")
    viewer.picture("fleet-calm")


def lists_homes_of_fleet(browser, folder, page):
    """The smallest share first; a click chooses the flight, whose way is drawn in parts; returns are no failure of the flights."""
    run("skyway-check", "-q", folder / "houses", folder / "fleet.flights", "--return", "--return-height", "8", "-o", folder / "fleet.returns", yes=False)
    reports = [json.loads(line) for line in (folder / "fleet.returns").read_text().splitlines()]
    assert any(r["return"]["gaps"] for r in reports) and not all(r["return"]["gaps"] for r in reports)
    run("skyway-view", *[folder / f for f in ("houses", "fleet.flights", "fleet.returns")], "-o", page)
    viewer = Viewer(browser, page)
    said = browser.run("return [...document.querySelectorAll('.summary-panel .verdict-line')].map(l => [l.className, l.textContent])")
    whole = sum(not r["return"]["gaps"] for r in reports)
    assert any("good" in kind and "All 120 flights passed" in words for kind, words in said), said
    assert any("bad" in kind and f"from every instant of {whole} of 120 flights" in words for kind, words in said), said
    browser.run("[...document.querySelectorAll('[role=tab]')].find(t => t.textContent === 'Ways home').click()")
    listed = browser.run("return [...document.querySelectorAll('tr[data-home]')].map(r => r.dataset.home)")
    shares = {r["id"]: r["return"]["share"] for r in reports}
    assert len(listed) == 120 and all(shares[a] <= shares[b] + 1e-9 for a, b in zip(listed, listed[1:])), listed
    browser.click(f"tr[data-home={listed[0]}] button")
    assert viewer.get("mission") == listed[0]
    browser.run("document.activeElement.blur()")
    browser.key("g")
    viewer.until("skyway.home.drawn === skyway.time")
    assert viewer.get("home")["kind"] == "none" and viewer.get("home")["none"]
    browser.run("const s = [...document.querySelectorAll('#layers select')].find(e => [...e.options].some(o => o.value === 'home'));"
                "s.value = 'home'; s.dispatchEvent(new Event('change'))")
    viewer.picture("fleet-home")


def says_of_how_many(browser, folder, page):
    """A flight without a report did not pass, and what a yes rests on stands beside it: looser margins, a simulation."""
    flights = (folder / "fleet.flights").read_text().splitlines()[:3]
    (folder / "three").write_text("\n".join(flights) + "\n")
    (folder / "first").write_text(flights[0] + "\n")
    margin = 0.5 * json.loads(flights[0]).get("margin", 0) if json.loads(flights[0]).get("margin") else None
    looser = ["--override", "--vehicle", "box:0.01,0.01,0.01"] if margin is None else ["--override", "--margin", margin]
    run("skyway-check", "-q", folder / "houses", folder / "three", *looser, "-o", folder / "loose.report")
    run("skyway-check", "-q", folder / "houses", folder / "first", "-o", folder / "first.report")
    run("skyway-view", folder / "houses", folder / "three", folder / "first.report", "-o", page)
    said = "return [...document.querySelectorAll('.summary-panel .verdict-line')].map(l => [l.className, l.textContent])"
    title = "return [...document.querySelectorAll('.mission .good, .mission .bad')].map(l => l.title)"
    viewer = Viewer(browser, page)
    kind, words = browser.run(said)[1]
    assert "soft" in kind and words == "1 of 3 flights passed the check against the map. Of the others there is no report.", (kind, words)
    assert browser.run(title) == ["The trajectory passed the check against the map"]
    run("skyway-view", folder / "houses", folder / "three", folder / "loose.report", "-o", page)
    viewer = Viewer(browser, page)
    kind, words = browser.run(said)[1]
    assert "good" in kind and words.startswith("✓All 3 flights passed") and "less strict than the records say" in words, (kind, words)
    assert "less strict" in browser.run("return document.getElementById('summary').textContent")
    browser.run("[...document.querySelectorAll('[role=tab]')].find(t => t.textContent === 'Checks').click()")
    rests = browser.run("return [...document.querySelectorAll('.check .rests')].map(l => l.textContent)")
    assert len(rests) == 3 and all("ooser than its record says (--override or --spare): vehicle" in words for words in rests), rests
    viewer.picture("less-strict")


def finds_flights(viewer):
    browser, listed = viewer.browser, "return [...document.querySelectorAll('.mission')].map(b => b.dataset.mission)"
    assert len(browser.run(listed)) == 120
    browser.run("const f = document.getElementById('find'); f.value = '07'; f.dispatchEvent(new Event('input'))")
    assert browser.run(listed) == ["f007", *(f"f{i:03}" for i in range(70, 80)), "f107"]
    browser.click("[data-mission=f071]")
    assert viewer.get("mission") == "f071" and viewer.get("motion") == "f071 (planned)"
    browser.run("const f = document.getElementById('find'); f.value = ''; f.dispatchEvent(new Event('input'))")
    browser.run("const s = document.querySelector('.tools select'); s.value = 'delay'; s.dispatchEvent(new Event('change'))")
    assert browser.run(listed)[0] == "f004"  # 4 s late, as every fifth: the first of these
    begin = viewer.get("time")
    browser.click("[data-plot=velocity] canvas")  # its own time, from its departure on
    flown = viewer.get("time")
    assert flown != begin and viewer.get("values")["velocity"]["norm"] > 1
    viewer.until("skyway.frames > 0")


def colours_flights(viewer):
    for value in ("delay", "nearest", ""):
        viewer.browser.run("const s = [...document.querySelectorAll('#layers select')].find(e => [...e.options].some(o => "
                           f"o.value === 'nearest')); s.value = '{value}'; s.dispatchEvent(new Event('change'))")
        shown = viewer.browser.run("return document.querySelectorAll('#layers .ramp').length")
        assert shown == (2 if value else 1), (value, shown)
        viewer.picture(f"fleet-{value or 'plain'}")


def jumps_to_pairs(viewer, report):
    """To the nearest that the check refused, by the key and by the list."""
    browser = viewer.browser
    refused = sorted((r for r in report if r["type"] == "pair"), key=lambda r: r["share"])
    said = browser.run("return document.querySelector('#side').textContent").replace("\u202f", " ")
    assert refused and f"{len(refused)} of 7,140 pairs are not proved apart." in said, said
    first = "{} m across, {} m up; 10 or 5 needed".format(*(f"{refused[0][k]:.2f}".rstrip("0").rstrip(".") for k in ("across", "up")))
    assert first in said, (first, said)
    browser.run("document.activeElement.blur()")
    browser.key("j")
    pair = viewer.get("pair")
    assert pair["ids"] == refused[0]["ids"] and viewer.get("camera") == "pair"
    assert abs(viewer.get("time") - (refused[0]["time"] - 60)) < 1e-6
    viewer.until("skyway.pair.now !== null")
    apart = (refused[0]["across"] ** 2 + refused[0]["up"] ** 2) ** 0.5
    assert abs(viewer.get("pair")["now"] - apart) < 1e-2, (viewer.get("pair"), apart)
    browser.run("[...document.querySelectorAll('[role=tab]')].find(t => t.textContent === 'Pairs').click()")
    browser.run("document.querySelectorAll('button.pair')[1].click()")
    assert viewer.get("pair")["ids"] == refused[1]["ids"]
    browser.click("#nearest")
    assert viewer.get("pair")["ids"] == refused[0]["ids"]
    viewer.picture("fleet-pair")
    browser.run("[...document.querySelectorAll('[role=tab]')].find(t => t.textContent === 'Motion').click()")
    browser.run("document.activeElement.blur()")
    browser.key("n")
    assert viewer.get("pair") is None


def fits_a_phone(browser, page):
    """The time axis lies below the plots, and nothing shines between the parts."""
    narrow = Viewer(browser, page, "light", (390, 844))
    boxes = browser.run("""
      const of = s => document.querySelector(s).getBoundingClientRect();
      const plots = [...document.querySelectorAll('.plot')].map(p => p.getBoundingClientRect().bottom);
      return {axis: of('.time-axis').top, plots: Math.max(...plots), side: of('#side').bottom + scrollY,
              page: document.documentElement.scrollHeight, wide: document.documentElement.scrollWidth}""")
    assert boxes["axis"] >= boxes["plots"] - 1, boxes
    assert boxes["side"] >= boxes["page"] - 1 and boxes["wide"] <= 390, boxes
    narrow.picture("phone")


def shows_hostile_names(browser, folder, page):
    """Ids, messages, vehicles and names of files with HTML in them are words and nothing else."""
    bad = "</script><img src=x onerror='window.hacked=1'><!--<script>\"&amp;\u2028{{meta}}"
    rows = (folder / "labels.csv").read_text().splitlines()
    rows[1] = rows[1].rsplit(",", 1)[0] + ',"' + bad.replace('"', '""') + '"'
    hostile = folder / "<img src=x onerror=window.hacked=1>.csv"
    hostile.write_text("\n".join(rows) + "\n")
    run("skyway-import", "-q", hostile, "-o", folder / "<script>map")
    segment = {"duration": 4, "x": [0] * 4 + [9] * 4, "y": [9] * 8, "z": [12] * 8}
    vehicle = {"vehicle": {"name": bad, "half": [0.5, 0.5, 0.3]}, "margin": 0, "frame": "enu"}
    records = [
        {"type": "path", "id": bad, "status": "found", "points": [[0, 9, 12], [9, 9, 12]], **vehicle},
        {"type": "path", "id": bad, "status": "unreachable", "message": bad, "points": []},
        {"type": "trajectory", "id": bad, "status": "solved", "duration": 4, "rung": "closed", "segments": [segment], **vehicle},
        {"type": "trajectory", "id": bad, "status": "infeasible", "message": bad, "segments": []},
        {"type": "report", "id": bad, "ok": False, "checked": bad, "reason": bad, "place": [1, 9, 12], "time": 1},
        {"type": "report", "id": bad, "ok": True, "checked": "path"},
        {"type": "report", "id": bad, "ok": False, "reason": "return", "return": {
            "action": bad, "autopilot": bad, "share": 0.5, "duration": 4, "gaps": [
                {"from": 0, "until": 2, "item": 1, "part": bad, "autopilot": bad, "phase": bad, "reason": bad, "at": [1, 9, 12]}]}},
        {"type": "contingency", "id": bad, "from": 0, "until": 2, "site": bad, "points": [[0, 9, 20], [0, 9, 0]], **vehicle},
        {"type": "contingency", "id": bad, "status": "unreachable", "from": 2, "until": 4, "message": bad, **vehicle},
        {"type": "tree", "id": bad, "nodes": 1},
        {"index": 0, "parent": 0, "first_parent": 0, "tree": 0, "cost": 0, "point": [0, 9, 12]},
        {"type": "corridor", "id": bad, "pieces": [{"vertices": [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]],
                                                    "faces": [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]]}]},
    ]
    (folder / "<").mkdir()
    table = folder / "<" / "script>.jsonl"
    table.write_text("".join(json.dumps(r) + "\n" for r in records))
    run("skyway-view", folder / "<script>map", table, "--title", bad, "-o", page)
    viewer = Viewer(browser, page)
    assert browser.run("return document.title") == bad
    for tab in browser.run("return [...document.querySelectorAll('[role=tab]')].map(t => t.textContent)"):
        browser.run(f"[...document.querySelectorAll('[role=tab]')].find(t => t.textContent === {json.dumps(tab)}).click()")
    browser.run("const s = document.querySelector('#layers select'); s.value = 'label'; s.dispatchEvent(new Event('change'))")
    browser.run("document.querySelector('.check.failed button').click()")
    for where in ("#layers", "#side", "h1"):
        assert "onerror" in browser.run(f"return document.querySelector('{where}').textContent"), where
    assert browser.run("return document.querySelectorAll('img').length") == 0
    assert browser.run("return document.scripts.length") == 4
    assert browser.run("return window.hacked === undefined")
    viewer.picture("hostile")


def shows_real_city(browser, folder, page):
    table = pathlib.Path(os.environ["SKYWAY_REALDATA"]) / "colliders" / "udacity_colliders.csv"
    ends = ["--from=528.78399,288.798721,28.985081", "--to=-26.24902,14.253218,24.835826"]
    make_chain(table, folder, ends)
    run("skyway-view", folder / "map", "-o", page)
    Viewer(browser, page).figures("San Francisco, map alone")
    files = [folder / f for f in ("map", "path", "tree", "trajectory", "report", "flight.csv")]
    run("skyway-view", *files, "--title", "San Francisco", "-o", page)
    viewer = Viewer(browser, page, "dark")
    assert viewer.get("boxes") == 3845
    viewer.figures("San Francisco")
    plays_and_scrubs(viewer, folder)
    viewer.picture("san-francisco")


def shows_vienna(browser, folder, page):
    """A whole city: a file of a few megabytes, and a first frame of few boxes."""
    source = pathlib.Path(os.environ["SKYWAY_REALDATA"]) / "metropolis" / "vienna_buildings.gpkg"
    if not (bin_dir / "skyway-footprints").exists():
        return
    run("skyway-footprints", "-q", source, "--height-attribute", "bldg_h_max", "--default-height", "15", "-o", folder / "vienna")
    run("skyway-view", folder / "vienna", "-o", page)
    assert page.stat().st_size < 8e6, page.stat().st_size
    viewer = Viewer(browser, page)
    assert viewer.get("boxes") > 500000 and sum(viewer.get("drawn")) < 40000, viewer.get("drawn")
    viewer.figures("Vienna")
    viewer.picture("vienna")


def shows_tube(browser, folder, page):
    """A proved tube and one of statistics, each by its own name; both can be hidden."""
    quad = source / "tests/golden/data/quad.json"
    record = {"type": "trajectory", "id": "q1", "segments": [
        {"duration": 3, "x": [0] * 4 + [3] * 4, "y": [0] * 4 + [2] * 4, "z": [30] * 8}]}
    (folder / "hop").write_text(json.dumps(record) + "\n")
    asked = ("--vehicle", quad, "--hover-time", "0.5", "--settle", "0.5", "-o", folder / "hop.csv", "--report-file", folder / "tube")
    for kind, options in (("proved", ("--controller", "geometric", "--proved-tube", "--gust-most", "0.2")), ("statistics", ("--runs", "3"))):
        run("skyway-fly", folder / "hop", *asked, *options)
        run("skyway-view", folder / "hop", folder / "tube", "-o", page)
        viewer = Viewer(browser, page)
        words = browser.run("return [...document.querySelectorAll('#layers section')].map(s => s.textContent).find(t => t.startsWith('Tube'))")
        assert words.startswith("Tube" + kind) and ("Proved for the simulated vehicle" in words) == (kind == "proved"), words
        assert ("not proved" in words) == (kind == "statistics"), words
        viewer.picture(f"tube-{kind}")
        calls = viewer.get("drawCalls")
        browser.run("[...document.querySelectorAll('#layers .head')].find(l => l.textContent.startsWith('Tube')).click()")
        viewer.until(f"skyway.drawCalls < {calls}")


def works_without_webgl(folder, page):
    run("skyway-view", *[folder / f for f in ("map", "trajectory")], "-o", page)
    with Browser(extra=["--disable-3d-apis"]) as browser:
        browser.open(page)
        browser.until("window.skyway && skyway.ready")
        problems = browser.run("return skyway.problems")
        assert len(problems) == 1 and "WebGL" in problems[0], problems
        browser.click("[data-plot=velocity] canvas")
        assert browser.run("return skyway.time") > 0


def main(folder):
    page = folder / "page.html"
    demo = folder / "demo"
    demo.mkdir()
    make_chain(source / "data" / "downtown.csv", demo, ["--from=-425,-320.5,7", "--to", "357,204,5"])
    with Browser() as browser:
        shows_demo(browser, demo, page)
        shows_frames(browser, demo, page)
        shows_failure(browser, demo, page)
        shows_home(browser, demo, page)
        shows_home_of_mission(browser, demo, page)
        shows_large_city(browser, folder, page)
        shows_missions(browser, folder, page)
        shows_fleet(browser, folder, page)
        lists_homes_of_fleet(browser, folder, page)
        says_of_how_many(browser, folder, page)
        sets_refused_apart(browser, folder, page)
        shows_buildings(browser, folder, page)
        shows_room(browser, folder, page)
        shows_labels(browser, folder, page)
        shows_hostile_names(browser, folder, page)
        shows_tube(browser, folder, page)
        if os.environ.get("SKYWAY_REALDATA"):
            real = folder / "real"
            real.mkdir()
            shows_real_city(browser, real, page)
            shows_vienna(browser, real, page)
        else:
            print("the San Francisco page was left out: SKYWAY_REALDATA is not set")
    works_without_webgl(demo, page)


with tempfile.TemporaryDirectory() as name:
    try:
        main(pathlib.Path(name))
    except FileNotFoundError as missing:
        if "chromium" not in str(missing):
            raise
        print(f"skipped: needs {missing}")
        sys.exit(77)
