"""tube_test.py BIN_DIR [MUTANTS [SEED]]: proofs of tubes hold for the independent verifier, and not once tampered with.

Of so many changed certificates (150 without a number) each is refused, or what it claims is still true: the claim is the same or
weaker, or `skyway-fly` proves it of the changed vehicle, trajectory and disturbances.
"""

import collections
import json
import math
import os
import random
import sys
import tempfile

from tool_runs import read, tool, write
from verify_certificate import Refused, strict_json
from verify_tube import verify

MUTANTS = int(sys.argv[2]) if len(sys.argv) > 2 else 150
SEED = int(sys.argv[3]) if len(sys.argv) > 3 else 1

from tube_mutants import Mutants

ALONG = (0, 0, 0, 0, 1, 1, 1, 1)


def trajectory(name, places, seconds, yaw=None, frame="enu"):
    """From place to place, at rest at each."""
    segments = []
    for a, b in zip(places, places[1:]):
        segment = {"duration": seconds, **{axis: [a[i] + u * (b[i] - a[i]) for u in ALONG] for i, axis in enumerate("xyz")}}
        if yaw is not None:
            segment["yaw"] = [yaw * u for u in ALONG]
        segments.append(segment)
    return {"type": "trajectory", "id": name, "status": "solved", "frame": frame, "segments": segments}


def fly(record, *options, codes=(0,)):
    write("t.jsonl", [record])
    for name in ("c.jsonl", "r.jsonl"):
        if os.path.exists(name):
            os.remove(name)
    tool("skyway-fly", "t.jsonl", "--controller", "geometric", "--proved-tube", "--threads", "1", "-o", "f.csv", "-q",
         "--report-file", "r.jsonl", *options, codes=codes)


def certified(record, *options):
    fly(record, "--certificate", "c.jsonl", "--hover-time", "0.1", "--settle", "0.1", *options)
    [certificate], [report] = read("c.jsonl"), read("r.jsonl")
    assert report["proved_tube"]["radius"] == certificate["radius"] and report["proved_tube"]["tilt"] == certificate["tilt"], report
    return record, certificate


def proved_again(record, certificate):
    """Whether skyway-fly proves what a changed certificate claims."""
    v, g = certificate["vehicle"], certificate["gains"]
    profile = {"name": "changed", "body": [0.1, 0.1, 0.1], "mass_kg": v["mass"], "inertia_kg_m2": v["inertia"],
               "motor_time_constant_s": v["motor_time_constant"], "thrust_n": [4 * v["motor_least"], 4 * v["motor_most"]],
               "motor_arm_m": v["arm"], "torque_per_thrust_m": v["torque_per_thrust"], "drag_kg_s": v["drag"], "gains": {"geometric": g}}
    with open("changed.json", "w", encoding="utf-8") as file:
        json.dump(profile, file)
    c = certificate
    fly(record, "--vehicle", "changed.json", "--wind", ",".join(map(repr, c["wind"])), "--wind-spread", repr(c["wind_spread"]),
        "--gust-most", repr(c["gust_most"]), "--gust-lag", repr(c["gust_lag"]), "--mass-error", repr(c["mass_error"]),
        "--hover-time", repr(c["hover"]), "--settle", repr(c["settle"]), "--loop-period", repr(c["attitude_period_ms"] / 1000), codes=(0, 1))
    [report] = read("r.jsonl")
    tube = report["proved_tube"]
    return tube["ok"] and len(tube["radius"]) == len(c["radius"]) and tube["tilt"] <= c["tilt"] and \
        all(found <= claimed for found, claimed in zip(tube["radius"], c["radius"]))


def outcome(record, certificate):
    """As a file would be read: what is no JSON is refused."""
    try:
        verify(strict_json(json.dumps(record)), strict_json(json.dumps(certificate)))
        return "accepted"
    except Refused:
        return "refused"


os.chdir(tempfile.mkdtemp())
QUAD = ("--vehicle", "quad2kg", "--wind", "1,0.5,0", "--wind-spread", "0.1", "--gust-most", "0.3", "--mass-error", "0.004")
cases = [certified(trajectory("along", [[0, 0, 5], [0.4, -0.2, 5.1]], 1.6), *QUAD),
         certified(trajectory("turned", [[3, 0, 5], [3.2, 0.1, 5]], 1.6, yaw=0.3, frame="neu"), "--vehicle", "crazyflie", "--wind", "0.5,0,0",
                   "--wind-spread", "0.05", "--gust-most", "0.1"),
         certified(trajectory("cells", [[0, 0, 5], [0, 0, 5]], 0.4), *QUAD[:4], "--wind-spread", "1.2", "--mass-error", "0.03")]
for record, certificate in cases:
    verify(record, certificate)
    print(record["id"], len(certificate["cells"]), "cells", len(json.dumps(certificate)), "bytes", flush=True)
assert len(cases[2][1]["cells"]) > 1, "no case has several cells"

tried, wrong, asked = collections.Counter(), [], collections.Counter()
streams = [Mutants(SEED * 10 + i).of(*case) for i, case in enumerate(cases)]
chance = random.Random(SEED)
for _ in range(MUTANTS):
    what, record, certificate, expected = next(chance.choices(streams, (5, 3, 1))[0])
    found = outcome(record, certificate)
    tried[what.split(":")[0], found] += 1
    if found == "accepted" and expected == "refused":
        wrong.append((record["id"], what))
    if found == "accepted" and expected == "asked":
        asked["accepted"] += 1
        if not proved_again(record, certificate):
            wrong.append((record["id"], what, "not proved"))
for kind in sorted(tried):
    print(*kind, tried[kind])
assert not wrong, wrong
print(f"{sum(tried.values())} changes: {sum(n for (_, found), n in tried.items() if found == 'refused')} refused, "
      f"{asked['accepted']} claim another tube that is proved, the others the same one")
