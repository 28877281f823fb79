"""limits_test.py BIN_DIR SOURCE_DIR: no limit of a vehicle's profile is lost between two tools.

Every chain runs as processes through pipes; each check's verdict and limits are compared with the
strictest of what profile, record and options say, worked out here.
"""

import json
import math
import os
import pathlib
import random
import subprocess
import sys
import tempfile

BIN, SOURCE = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve()
QUAD = SOURCE / "data/vehicles/quad2kg.json"
TILT = math.radians(35)
# What data/vehicles/quad2kg.json says: its own limits, and thrust over mass and the rates of its motors.
QUAD_LIMITS = {"vmax": 12, "vmax_v": 4, "tilt": TILT, "thrust": 34.19432 / 2, "body_rate": 3.839724354387525,
               "yaw_rate": 3.4906585039886591}
failures = []


def expect(holds, what, *more):
    if not holds:
        failures.append(what)
        print(f"FAILED: {what}", *(str(m)[:600] for m in more), sep="\n  ")


def run(command, text="", exits=(0,)):
    """A shell pipe of tools; what it writes. Every tool of it is of BIN_DIR."""
    env = dict(os.environ, PATH=f"{BIN}:{os.environ['PATH']}", QUAD=str(QUAD), LC_ALL="C")
    done = subprocess.run(["bash", "-o", "pipefail", "-c", command], input=text, text=True, capture_output=True, env=env)
    expect(done.returncode in exits, f"exit {done.returncode} instead of {exits}: {command}", done.stderr, done.stdout)
    return done


def records(text):
    return [json.loads(line) for line in text.splitlines()]


def same_limits(found, expected):
    return set(found) == set(expected) and all(math.isclose(found[k], v, rel_tol=1e-12) for k, v in expected.items())


def leg(start, end, duration):
    """Rest to rest along a line: the fastest it is, how fast upwards and across, and its peak acceleration."""
    points = [start] * 4 + [end] * 4
    segment = {"duration": duration, **{axis: [p[i] for p in points] for i, axis in enumerate("xyz")}}
    step = [b - a for a, b in zip(start, end)]
    peak = 35 / 16 / duration
    acceleration = 84 * math.sqrt(5) / 25 / duration**2
    return segment, {"vmax": peak * math.hypot(*step), "vmax_h": peak * math.hypot(*step[:2]), "vmax_v": peak * abs(step[2]),
                     "amax": acceleration * math.hypot(*step)}


def record_of(segment, **more):
    return json.dumps({"type": "trajectory", "id": "t", "status": "solved", "segments": [segment], **more}) + "\n"


# ---- Chains.

def the_chain_keeps_the_limits():
    """From skyway-plan on, each record says what the vehicle may do."""
    run("skyway-plan city --vehicle $QUAD --margin 0.5 --from 5,5,10 --to 150,90,30 -o path")
    run("skyway-replan city path -o replanned")
    run("skyway-traj city replanned -o trajectory")  # needs no --vmax
    run("skyway-check city trajectory --certificate certificate -o report")
    run("skyway-traj city path --shard 1/2 -o one; skyway-traj city path --shard 2/2 -o two; skyway-join two one -o joined")
    run("skyway-fly city trajectory --vehicle $QUAD -o log --report-file flight", exits=(0, 1))
    run("skyway-traj city path --solver ipopt --corridor-file corridor -o optimised", exits=(0, 1))
    for name in ("path", "replanned", "trajectory", "report", "certificate", "joined", "flight", "corridor"):
        record = records(pathlib.Path(name).read_text())[0]
        expect(same_limits(record["vehicle"].get("limits", {}), QUAD_LIMITS), f"{name} keeps the vehicle's limits", record["vehicle"])
    report = records(pathlib.Path("report").read_text())[0]
    expect(same_limits(report["limits"], QUAD_LIMITS), "the check holds all of them", report.get("limits"))
    expect(report["tilt"] <= TILT and report["speed"] <= 12 and report["vertical_speed"] <= 4, "and they hold", report)


def a_looser_option_is_refused():
    for asked, said in (("--vmax 30 --amax 5", ("30 m/s", "12 m/s")), ("--amax 5 --tilt 60", ("60 degrees", "35 degrees")),
                        ("--amax 5 --vmax-v 11", ("11 m/s", "4 m/s"))):
        for vehicle in ("", "--vehicle $QUAD"):
            done = run(f"skyway-traj city path {vehicle} --margin 0.5 {asked}", exits=(2, 3))
            expect(all(number in done.stderr for number in said), f"both numbers are named: {asked}", done.stderr)


def another_vehicle_is_refused():
    """Elsewhere than in the check, a difference in limits is exit 3."""
    slow = json.loads(QUAD.read_text())
    slow["limits"] = {"vmax": 11, "vmax_v": 4}
    pathlib.Path("slow.json").write_text(json.dumps(slow))
    pathlib.Path("fast.json").write_text(json.dumps({**slow, "limits": {"vmax": 13, "vmax_v": 4}}))
    for other in ("slow.json", "fast.json"):
        for command in (f"skyway-traj city path --vehicle {other} --margin 0.5",
                        f"skyway-export city trajectory --vehicle {other} --margin 0.5 --format crazyflie",
                        f"skyway-export --unchecked trajectory --vehicle {other} --format crazyflie",
                        f"skyway-fly trajectory --vehicle {other} -o log",
                        f"skyway-fly city trajectory --vehicle {other} -o log"):
            done = run(command, exits=(3,))
            expect("12 m/s" in done.stderr, f"the difference is named: {command}", done.stderr)
    replanned = records(run("skyway-replan city path --vehicle fast.json --margin 0.5").stdout)[0]
    expect(replanned["vehicle"]["limits"]["vmax"] == 12, "replanning does not loosen", replanned["vehicle"])
    replanned = records(run("skyway-replan city path --vehicle slow.json --margin 0.5").stdout)[0]
    expect(replanned["vehicle"]["limits"]["vmax"] == 11, "replanning may tighten", replanned["vehicle"])


def a_profile_in_the_check_applies_whole():
    segment, _ = leg((5, 5, 10), (105, 5, 40), 8)  # 28.5 m/s, 8.2 m/s up
    report = records(run("skyway-check city --vehicle $QUAD", record_of(segment), exits=(1,)).stdout)[0]
    expect(not report["ok"] and same_limits(report["limits"], QUAD_LIMITS), "all of the profile's limits", report)
    report = records(run("skyway-check city --exact --vehicle $QUAD --vmax 40 --amax 40", record_of(segment), exits=(1,)).stdout)[0]
    expect(report["limits"]["vmax"] == 12 and report["limits"]["amax"] == 40, "options only tighten", report)
    done = run("skyway-check city --vehicle $QUAD --vmax 40 --vmax-v 40 --thrust 100 --body-rate 10000 --override",
               record_of(leg((5, 5, 10), (105, 5, 40), 12)[0]))
    report = records(done.stdout)[0]
    expect(report["limits"]["vmax"] == 40 and math.isclose(report["limits"]["tilt"], TILT), "--override loosens what it names", report)
    expect(report.get("overridden") == ["vmax", "vmax_v", "thrust", "body_rate"], "and the report remembers", report)


def a_box_is_not_used_beyond_its_tilt():
    segment, _ = leg((5, 5, 10), (105, 5, 10), 5)
    for vehicle in ({}, {"vehicle": {"name": "q", "half": [1, 1, 1], "limits": {"tilt": TILT}}}):
        option = "" if vehicle else "--vehicle $QUAD"
        done = run(f"skyway-check city {option} --tilt 70 --override", record_of(segment, **vehicle), exits=(2, 3))
        expect("35 degrees" in done.stderr and "70 degrees" in done.stderr, "both tilts are named", done.stderr)
        run(f"skyway-check city {option} --tilt 70", record_of(segment, **vehicle), exits=(1,))
    pathlib.Path("open.json").write_text('{"name": "open", "body": [0.3, 0.4, 0.12]}')
    report = records(run("skyway-check city --vehicle open.json", record_of(segment)).stdout)[0]
    expect(min(report["vehicle"]["half"]) >= math.hypot(0.3, 0.4, 0.12), "without a tilt the box holds every attitude", report["vehicle"])


def exports_hold_the_limits():
    """Those of the vehicle too, whatever the record's own."""
    segment, _ = leg((5, 5, 10), (105, 5, 40), 30)
    vehicle = {"name": "q", "half": [0.5, 0.5, 0.5], "limits": {"vmax": 3, "vmax_v": 1}}
    pathlib.Path("fast").write_text(record_of(segment, vehicle=vehicle))
    for what in ("crazyflie", "setpoints"):
        done = run(f"skyway-export city fast --format {what} -o fast.{what}", exits=(1,))
        expect("speed" in done.stderr, f"{what} is held to the vehicle's limits", done.stderr)
    slow = {"name": "q", "half": [0.5, 0.5, 0.5], "limits": {"vmax": 0.5, "vmax_v": 0.2}}
    pathlib.Path("slow").write_text(record_of(segment, vehicle=slow))
    for what, record in (("wpl --origin 60,24,0 --speed 5", "fast"), ("qgc-plan --origin 60,24,0 --speed 5", "fast"), ("tello --speed 1", "slow")):
        run(f"skyway-export city {record} --format {what} -o fast.legs", exits=(1,))
        run(f"skyway-export --unchecked {record} --format {what} -o fast.legs", exits=(2,))
    run("skyway-export city fast --format wpl --origin 60,24,0 -o slow.wpl")
    speeds = [line.split("\t")[5] for line in pathlib.Path("slow.wpl").read_text().splitlines() if line.split("\t")[3:4] == ["178"]]
    expect([float(s) for s in speeds] == [1], "a mission flies no faster than the vehicle may in any direction", speeds)


def imports_carry_the_vehicle():
    run("skyway-export city trajectory --format crazyflie -o mission.csv")
    imported = run("skyway-import-trajectory mission.csv --map city --vehicle $QUAD --margin 0.5 -q").stdout
    record = records(imported)[0]
    expect(same_limits(record["vehicle"]["limits"], QUAD_LIMITS) and record["margin"] == 0.5, "an imported record", record["vehicle"])
    run("skyway-check city", imported.replace('"vmax":12', '"vmax":0.1'), exits=(1,))
    done = run("skyway-import-trajectory slow.wpl --map city --origin 60,24,0")
    expect("1 m/s" in done.stderr, "a mission's speed is not left out without a word", done.stderr)


def what_is_not_measured_is_not_said_to_be():
    report = records(run("skyway-check city path").stdout)[0]
    expect("limits" not in report, "a path is held to no limits", report)
    segment, _ = leg((5, 5, 10), (105, 5, 10), 5)
    report = records(run("skyway-check city --vehicle box:1,1,1", record_of(segment)).stdout)[0]
    expect("limits" not in report, "nor a trajectory that nobody limits", report)


def holds_and_velocities_survive_replanning():
    xs = range(5, 196, 10)
    way = {"type": "path", "id": "h", "status": "found", "vehicle": {"name": "b", "half": [1, 1, 1]},
           "points": [[x, 5, 10] for x in xs], "hold": [{15: 7, 75: 2, 195: 3}.get(x, 0) for x in xs],
           "velocity": [[2, 0, 0] if x == 185 else None for x in xs]}
    kept = records(run("skyway-replan city", json.dumps(way) + "\n").stdout)[0]
    expect(kept.get("hold") == way["hold"] and kept.get("velocity") == way["velocity"], "of a path that is kept", kept)
    run("printf 'min_x_m,min_y_m,min_z_m,max_x_m,max_y_m,max_z_m,label\\n70,4,0,80,6,12,crane\\n' > crane.csv;"
        "skyway-map patch city --add crane.csv -o crane.map")
    done = run("skyway-replan crane.map", json.dumps(way) + "\n")
    mended = records(done.stdout)[0]
    holds = {tuple(p): h for p, h in zip(mended["points"], mended.get("hold", []))}
    expect(holds.get((15, 5, 10)) == 7 and holds.get((195, 5, 10)) == 3 and sum(holds.values()) == 10, "of the points that are left", mended)
    expect([2, 0, 0] in mended.get("velocity", []), "and velocities", mended)
    expect("lost" in done.stderr and "lost" in mended.get("message", ""), "what is lost is said", done.stderr)


def misspelt_limits_are_refused():
    segment, _ = leg((5, 5, 10), (6, 5, 10), 5)
    for profile in ({"limit": {"vmax": 3}}, {"limits": {"vmx": 3}}, {"limits": {"vmax": 0}}, {"vmax": 3}, {"limits": {"tilt": 2}},
                    {"tilt_max": 30}, {"limits": 3}, {"limits": {"climb": 3}}):
        pathlib.Path("odd.json").write_text(json.dumps({"name": "odd", "body": [0.2, 0.2, 0.1], **profile}))
        run("skyway-check city --vehicle odd.json", record_of(segment), exits=(3,))
    for limits in ({"vmx": 3}, {"vmax": "3"}, {"vmax": -1}, 3, {"tilt": 1.6}, {"thrust": 5}):
        run("skyway-check city --vehicle box:1,1,1", record_of(segment, limits=limits), exits=(3,))
        vehicle = {"name": "v", "half": [1, 1, 1], "limits": limits}
        run("skyway-check city", record_of(segment, vehicle=vehicle), exits=(3,))


# ---- Who says what, at random.

def strictest(sources):
    return {name: min(s[name] for s in sources if name in s) for name in set().union(*sources)}


def checks_hold_the_strictest(count, seed):
    """A check through a pipe, of limits from four places: the verdict is the oracle's."""
    chance = random.Random(seed)
    names = ("vmax", "vmax_h", "vmax_v", "amax")
    refused = wrong = 0

    def some():
        return {name: chance.choice((2, 4, 6, 8)) for name in names if chance.random() < 0.4}

    for case in range(count):
        height, across = chance.uniform(0, 20), chance.uniform(1, 60)
        segment, peaks = leg((5, 5, 10), (5 + across, 5, 10 + height), chance.uniform(5, 40))
        record, of_vehicle, profile, options = some(), some(), some(), some()
        overridden = chance.random() < 0.3
        command = ["skyway-check city"]
        sources = [record, of_vehicle, options]
        if chance.random() < 0.6:
            pathlib.Path("v.json").write_text(json.dumps({"name": "v", "body": [0.5, 0.5, 0.5], "limits": profile}))
            command.append("--vehicle v.json")
            sources = [record, options, profile] if overridden else sources + [profile]
        command += [f"--{name.replace('_', '-')} {value}" for name, value in options.items()]
        held = strictest(sources)
        if overridden:
            command.append("--override")
            held.update(options)
        vehicle = {"name": "w", "half": [0.1, 0.1, 0.1], "limits": of_vehicle}
        ok = all(peaks[name] <= most for name, most in held.items())
        where = f"seed {seed}, case {case}: {' '.join(command)}"
        done = run(" ".join(command), record_of(segment, vehicle=vehicle, limits=record), exits=(0 if ok else 1,))
        for report in records(done.stdout):
            expect(report["ok"] == ok and report.get("limits", {}) == held, where, held, peaks, report)
            wrong += report["ok"] and not ok
            refused += not ok
    print(f"{count} checks of limits from four places, {refused} to be refused, {wrong} of these said ok")


def main():
    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        pathlib.Path("city.csv").write_text("posX,posY,posZ,halfSizeX,halfSizeY,halfSizeZ\n100,60,15,10,10,15\n")
        run("skyway-import -q city.csv --bounds 0,0,0,200,120,80 -o city")
        for test in (the_chain_keeps_the_limits, a_looser_option_is_refused, another_vehicle_is_refused,
                     a_profile_in_the_check_applies_whole, a_box_is_not_used_beyond_its_tilt, exports_hold_the_limits, imports_carry_the_vehicle,
                     what_is_not_measured_is_not_said_to_be, holds_and_velocities_survive_replanning,
                     misspelt_limits_are_refused):
            try:
                test()
            except (LookupError, OSError, ValueError) as error:
                expect(False, f"{test.__name__}: {error!r}")
        checks_hold_the_strictest(100, 15)
    print(f"{len(failures)} failures")
    sys.exit(len(failures) > 0)


main()
