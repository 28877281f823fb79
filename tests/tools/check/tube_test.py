"""tube_test.py BIN_DIR [MUTANTS [SEED]]: proofs of tubes hold for the independent verifier, and not once tampered with.

Of so many changed certificates (40 without a number) each is refused, or what it claims is still true: the claim is the same or
weaker, or `skyway-fly` proves it of the changed vehicle, trajectory and disturbances. A few that it does not prove are flown.
"""

import collections
import json
import math
import os
import pathlib
import random
import subprocess
import sys
import tempfile

import numpy as np

from tool_runs import read, tool, write
from tube_claim import STEP, Cell, Claim
from tube_deviations import rows_of
from tube_flight import fly as flown
from tube_flight import track_of, with_gains_off
from tube_mutants import Mutants
from verify_certificate import Refused, strict_json
from verify_tube import verify

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "support"))
import schemas  # noqa: E402

MUTANTS = int(sys.argv[2]) if len(sys.argv) > 2 else 40
SEED = int(sys.argv[3]) if len(sys.argv) > 3 else 1
ALONG = (0, 0, 0, 0, 1, 1, 1, 1)
CHECKERS_ROOM = 1.015 * (1 - 1e-9)  # docs/tube.md
NOISE = ("place_noise", "velocity_noise", "attitude_noise", "rate_noise")
RANGES = ("wind_spread", "gust_most", "gust_lag", "mass_error", "start_error", "start_speed", "drag_error", "motor_lag_error", "inertia_error", "gain_error",
          "settle")


def trajectory(name, places, seconds, yaw=None, frame="enu"):
    """From place to place, at rest at each."""
    segments = []
    for a, b in zip(places, places[1:]):
        segment = {"duration": seconds, **{axis: [a[i] + u * (b[i] - a[i]) for u in ALONG] for i, axis in enumerate("xyz")}}
        if yaw is not None:
            segment["yaw"] = [yaw * u for u in ALONG]
        segments.append(segment)
    return {"type": "trajectory", "id": name, "status": "solved", "frame": frame, "segments": segments}


def fly(record, controller, *options, codes=(0,)):
    write("t.jsonl", [record])
    for name in ("c.jsonl", "r.jsonl"):
        if os.path.exists(name):
            os.remove(name)
    tool("skyway-fly", "t.jsonl", "--controller", controller, "--proved-tube", "--threads", "1", "-o", "f.csv", "-q",
         "--report-file", "r.jsonl", *options, codes=codes)


def certified(record, *options, controller="geometric"):
    fly(record, controller, "--certificate", "c.jsonl", "--hover-time", "0.1", "--settle", "0.05", *options)
    [certificate], [report] = read("c.jsonl"), read("r.jsonl")
    assert report["proved_tube"]["radius"] == certificate["radius"] and report["proved_tube"]["tilt"] == certificate["tilt"], report
    return record, certificate


def proved_again(record, certificate):
    """Whether skyway-fly proves what a changed certificate claims."""
    v, gains = certificate["vehicle"], dict(certificate["gains"])
    if certificate["controller"] == "geometric":
        gains = {"geometric": gains}
    else:
        gains["tilt_max_deg"] = math.degrees(gains.pop("tilt_max"))
    profile = {"name": "changed", "body": [0.1, 0.1, 0.1], "mass_kg": v["mass"], "inertia_kg_m2": v["inertia"],
               "motor_time_constant_s": v["motor_time_constant"], "thrust_n": [4 * v["motor_least"], 4 * v["motor_most"]],
               "motor_arm_m": v["arm"], "torque_per_thrust_m": v["torque_per_thrust"], "drag_kg_s": v["drag"], "gains": gains}
    if "body_rate_max" in v:
        profile["body_rate_max_rad_s"] = v["body_rate_max"]
    with open("changed.json", "w", encoding="utf-8") as file:
        json.dump(profile, file)
    c = certificate
    loops = ("--loop-period", repr(c["attitude_period_ms"] / 1000)) if c.get("position_period_ms") != 10 else ()
    options = ("--vehicle", "changed.json", "--wind", ",".join(map(repr, c["wind"])), "--hover-time", repr(c["hover"]), *loops)
    options += tuple(word for name in RANGES for word in ("--" + name.replace("_", "-"), repr(c[name])))
    if any(c[name] for name in NOISE):
        place, velocity, attitude, rates = (c[name] for name in NOISE)
        options += ("--noise-most", ",".join(map(repr, (place, velocity, math.degrees(attitude), math.degrees(rates)))))
    # For a certificate there may be more cells, and so a narrower tube: what is proved, with CHECKERS_ROOM more.
    for more, room in (((), 1), (("--certificate", "d.jsonl"), CHECKERS_ROOM)):
        fly(record, c["controller"], *options, *more, codes=(0, 1))
        [report] = read("r.jsonl")
        tube = report["proved_tube"]
        if tube["ok"] and len(tube["radius"]) == len(c["radius"]) and tube["tilt"] <= room * c["tilt"] and \
                all(found <= room * claimed for found, claimed in zip(tube["radius"], c["radius"])):
            return True
    return False


def pushed(chance, claim, steps):
    """Gusts that run from one end to the other of what is allowed, at random times."""
    gust, towards, out = np.zeros(3), np.zeros(3), []
    for _ in range(steps):
        out.append(gust.tolist())
        if chance.random() < 0.005:
            towards = chance.normal(size=3)
            towards *= claim.gust_most / np.linalg.norm(towards)
        gust = claim.gust_kept(1) * gust + (1 - claim.gust_kept(1)) * towards
    return out


def misread(chance, claim, steps):
    """Noise of the readings in each step: its bounds, with signs that change at random times, or numbers by chance."""
    mosts = (claim.place_noise, claim.velocity_noise, claim.attitude_noise, claim.rate_noise)
    signs = np.cumprod(chance.choice([-1, 1], (steps, 12), p=[0.05, 0.95]), axis=0).reshape(steps, 4, 3)
    signs = np.where(chance.random((steps, 1, 1)) < 0.9, signs, chance.uniform(-1, 1, (steps, 4, 3)))
    return (signs * np.array(mosts)[:, None]).tolist()


def require_flights_within(record, certificate, flights):
    """Of some flights the deviations are within the bounds of their cell, and the places within the radii."""
    claim, track, chance = Claim(certificate), track_of(record, certificate["frame"]), np.random.default_rng(SEED)
    cells = certificate["cells"]
    most = 0
    for one in chance.choice(len(cells), flights):
        cell = Cell(claim, cells[one]["part"])
        wind, radius, factors, halves = cell.nominal()
        periods = (claim.before + round((track.duration + claim.settle) / STEP)) // claim.period
        nominal, _ = flown(claim, track, wind, factors, periods)
        away = chance.normal(size=3)
        away = away / np.linalg.norm(away) * radius[0] if cell.is_ball else np.sign(away) * radius
        other = (np.array(factors) + chance.choice([-1, 1], len(halves)) * halves).tolist()
        off = [size * v / np.linalg.norm(v) for size, v in zip((claim.start_error, claim.start_speed), chance.normal(size=(2, 3)))]
        noise = misread(chance, claim, periods * claim.period) if claim.is_noisy else None
        states, places = flown(claim, track, (np.array(wind) + away).tolist(), other, periods, pushed(chance, claim, periods * claim.period), off, noise,
                               with_gains_off(claim, chance))
        states[0] = nominal[0] if claim.start_error or claim.start_speed else states[0]  # under the cascade seen only once it has run
        bounds = np.repeat(cells[one]["bounds"], cells[one]["periods"], axis=0)[:periods + 1]
        rows = claim.law.ROWS.gust
        deviations = np.abs((states - nominal) @ rows_of(claim)[:rows].T) / bounds[:, :rows]
        assert deviations.max() <= 1, (record["id"], deviations.max(0))
        most = max(most, deviations.max())
        steps = np.arange(periods + 1) * claim.period - claim.before
        off = np.linalg.norm(places - track.at(-claim.before, periods * claim.period - claim.before)[0][::claim.period], axis=1)
        radii = np.array(claim.radius)[np.clip(steps // 100, 0, len(claim.radius) - 1)]
        assert np.all((off <= radii)[steps >= 0]), (record["id"], (off / radii).max())
    return most


def outcome(record, certificate):
    """As a file would be read: what is no JSON is refused."""
    try:
        verify(strict_json(json.dumps(record)), strict_json(json.dumps(certificate)))
        return "accepted"
    except Refused:
        return "refused"


def script(*arguments, **environment):
    """Exit code and words of the script as a program."""
    name = os.path.join(os.path.dirname(os.path.abspath(__file__)), "verify_tube.py")
    done = subprocess.run([sys.executable, "-B", name, *arguments], capture_output=True, text=True, env={**os.environ, **environment})
    return done.returncode, done.stdout + done.stderr


def require_exit_codes(record, certificate):
    write("record.jsonl", [record])
    assert script("record.jsonl", write("good.jsonl", [certificate]))[0] == 0
    code, words = script("record.jsonl", write("bad.jsonl", [{**certificate, "tilt": 0.5 * certificate["tilt"]}]))
    assert code == 1 and "refused: at" in words, words
    code, words = script("record.jsonl", write("other.jsonl", [{**certificate, "id": "other"}]))
    assert code == 1 and "there is no record of this certificate" in words and "there is no certificate" in words, words
    assert script("record.jsonl")[0] == 2
    text = json.dumps(certificate)
    for name, broken in (("cut.jsonl", text[:len(text) // 2]), ("none.jsonl", ""), ("twice.jsonl", text + "\n" + text + "\n")):
        with open(name, "w", encoding="utf-8") as file:
            file.write(broken)
        assert script("record.jsonl", name)[0] == 3, name
    os.mkdir("without")
    with open("without/numpy.py", "w", encoding="utf-8") as file:
        file.write("raise ImportError\n")
    code, words = script("record.jsonl", "good.jsonl", PYTHONPATH="without")
    assert code == 3 and "needs NumPy" in words, words


os.chdir(tempfile.mkdtemp())
QUAD = ("--vehicle", "quad2kg", "--wind", "1,0.5,0", "--wind-spread", "0.1", "--gust-most", "0.3", "--mass-error", "0.004")
cases = [certified(trajectory("along", [[0, 0, 5], [0.06, -0.03, 5.02]], 0.8), *QUAD),
         certified(trajectory("turned", [[3, 0, 5], [3.03, 0.02, 5]], 0.7, yaw=0.1, frame="neu"), "--vehicle", "crazyflie", "--wind", "0.5,0,0",
                   "--wind-spread", "0.05", "--gust-most", "0.1"),
         certified(trajectory("cells", [[0, 0, 5], [0, 0, 5]], 0.2), *QUAD[:4], "--wind-spread", "1.2", "--mass-error", "0.03"),
         certified(trajectory("ranges", [[0, 0, 5], [0.04, -0.02, 5]], 0.6), *QUAD, "--drag-error", "0.05", "--motor-lag-error", "0.03",
                   "--inertia-error", "0.01"),
         certified(trajectory("cascade", [[0, 0, 5], [0.06, -0.03, 5.02]], 0.8, yaw=0.1), *QUAD, "--inertia-error", "0.01", controller="cascade"),
         certified(trajectory("start", [[0, 0, 5], [0.05, -0.02, 5]], 0.6), *QUAD, "--start-error", "0.0004", "--start-speed", "0.0006"),
         certified(trajectory("cascade start", [[0, 0, 5], [0.06, -0.03, 5.02]], 0.6), *QUAD, "--start-error", "0.02", "--start-speed", "0.02",
                   controller="cascade"),
         certified(trajectory("noise", [[0, 0, 5], [0.05, -0.02, 5]], 0.6, yaw=0.1), "--vehicle", "crazyflie", "--gust-most", "0.1", "--noise-most",
                   "0.0002,0.001,0.01,0.05"),
         certified(trajectory("cascade noise", [[0, 0, 5], [0.06, -0.03, 5.02]], 0.6), "--vehicle", "crazyflie", "--gust-most", "0.1",
                   "--start-error", "0.003", "--noise-most", "0.0004,0.002,0.02,0.1", controller="cascade"),
         certified(trajectory("gains", [[0, 0, 5], [0.05, -0.02, 5]], 0.6), "--vehicle", "crazyflie", "--gust-most", "0.1", "--gain-error", "0.03"),
         certified(trajectory("cascade gains", [[0, 0, 5], [0.06, -0.03, 5.02]], 0.6), *QUAD, "--gain-error", "0.01", controller="cascade"),
         # Long enough for old columns to become boxes, in which the fast coordinates must not grow.
         certified(trajectory("old", [[0, 0, 5], [0.3, 0.2, 5.1]], 4), "--vehicle", "crazyflie", "--mass-error", "0.002", "--drag-error", "0.1")]
schema = schemas.validators(pathlib.Path(__file__).resolve().parents[3])["tube_certificate"]
for record, certificate in cases:
    verify(record, certificate)
    most = require_flights_within(record, certificate, 4)
    assert most > 0.3, f"bounds of {record['id']} that are far too wide: at most {most} is used"
    print(f"{record['id']}: cells {len(certificate['cells'])}, bytes {len(json.dumps(certificate))}, used by flights {most:.2f}", flush=True)
    schema.validate(certificate)
assert len(cases[2][1]["cells"]) > 1, "no case has several cells"

# Gains that are further off, a wider start or more noise than was proved.
for record, certificate in cases:
    for name in ("gain_error", "start_error", "start_speed", *NOISE):
        if certificate[name]:
            assert outcome(record, {**certificate, name: 1.5 * certificate[name]}) == "refused", (record["id"], name)

require_exit_codes(*cases[0])
tried, wrong, asked = collections.Counter(), [], collections.Counter()
streams = [Mutants(SEED * 10 + i).of(*case) for i, case in enumerate(cases[:11])]
chance = random.Random(SEED)
for _ in range(MUTANTS):
    what, record, certificate, expected = next(chance.choices(streams, (5, 3, 1, 4, 8, 4, 4, 4, 6, 4, 6))[0])
    found = outcome(record, certificate)
    tried[what.split(":")[0], found] += 1
    if found == "accepted" and expected == "refused":
        wrong.append((record["id"], what))
    if found == "accepted" and expected == "asked":
        asked["accepted"] += 1
        # The tool's bounds may be wider than the script's, of noise and gains above all. Then flights show whether the claim holds.
        if not proved_again(record, certificate):
            asked["flown"] += 1
            require_flights_within(record, certificate, 12)
for kind in sorted(tried):
    print(*kind, tried[kind])
assert not wrong, wrong
assert asked["flown"] <= 1 + 0.2 * asked["accepted"], asked
print(f"{sum(tried.values())} changes: {sum(n for (_, found), n in tried.items() if found == 'refused')} refused, "
      f"{asked['accepted']} claim another tube ({asked['flown']} of these are flown, the others proved), the others the same one")
