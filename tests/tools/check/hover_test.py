"""hover_test.py BIN_DIR LAW [MUTANTS [SEED]]: verify_hover.py confirms certificates of hovers, and refuses those that claim too little. LAW is the controller,
geometric or cascade.

It changes certificates, too, 2 if no number is given. A changed one is refused, or flights in gusts that run from one end to the other stay within it.
"""

import collections
import json
import math
import os
import random
import re
import subprocess
import sys
import tempfile
from operator import add, sub

import numpy as np

from hover_models import BITS, ONE, fixed
from hover_period import F
from tool_runs import read, tool, write
import tube_cascade
from tube_claim import STEP, Cell, Claim, cells_of, segments_of
from tube_flight import GRAVITY, body_axes, fly, track_of, with_gains_off
from tube_flown import flown
from tube_mutants import Mutants
from verify_certificate import Refused, strict_json
from verify_hover import LAWS, Hover, Sums, product, resting_yaw, swing, verify

LAW = sys.argv[2]
MUTANTS = int(sys.argv[3]) if len(sys.argv) > 3 else 2
SEED = int(sys.argv[4]) if len(sys.argv) > 4 else 1


def hover(name, yaw=None, seconds=0.4, frame="enu"):
    segment = {"duration": seconds / 2, **{axis: [v] * 8 for axis, v in zip("xyz", (3, -2, 5))}}
    if yaw is not None:
        segment["yaw"] = [yaw] * 8
    return {"type": "trajectory", "id": name, "status": "solved", "frame": frame, "segments": [segment, dict(segment)]}


def certified(record, *options, before="2.5"):
    write("t.jsonl", [record])
    tool("skyway-fly", "t.jsonl", "--controller", LAW, "--proved-tube", "--certificate", "c.jsonl", "--threads", "1", "-o", "f.csv", "-q",
         "--report-file", "r.jsonl", "--gust-lag", "0.1", "--hover-time", before, "--settle", "0.05", *options)
    return record, read("c.jsonl")[0]


def reason(record, certificate):
    """Why it is refused, or "". What is no JSON is refused, as in a file."""
    try:
        verify(strict_json(json.dumps(record)), strict_json(json.dumps(certificate)))
        return ""
    except Refused as why:
        return str(why)


def changed(certificate, **changes):
    """A copy; `vehicle` and `gains` name numbers in them."""
    copy = json.loads(json.dumps(certificate))
    for key, value in changes.items():
        if key in ("vehicle", "gains"):
            copy[key].update(value)
        else:
            copy[key] = value
    return copy


def require_refused(record, certificate):
    c, vehicle, gains = certificate, certificate["vehicle"], certificate["gains"]
    radius = max(c["radius"])
    held = verify(record, c)["for_ever"]
    assert 0.7 * radius < held <= radius, (held, radius)
    for words, other in (
            ("m off some time", changed(c, radius=[min(r, 0.999 * held) for r in c["radius"]])),
            ("it may tilt by", changed(c, tilt=0.2 * c["tilt"])),
            ("m off some time|it may tilt|no bounds|motor", changed(c, gust_most=1.5 * c["gust_most"])),
            ("m off some time|it may tilt|no bounds|motor", changed(c, mass_error=2 * c["mass_error"])),
            ("m off some time|it may tilt|no bounds|motor", changed(c, start_error=1.2 * radius)),
            ("may leave its range", changed(c, vehicle={"motor_most": vehicle["mass"] * 9.80665 / 4 * 1.01})),
            ("its weight is beyond its motors", changed(c, vehicle={"motor_most": vehicle["mass"] * 9.80665 / 4})),
            ("no bounds|hardly damps|motor", changed(c, gains={"rates": [0.5 * g for g in gains["rates"]], "lead": [0, 0, 0]})),
            ("knows no noise", changed(c, place_noise=1e-9)),
            ("knows no noise", changed(c, rate_noise=1e-9)),
            ("no gains that are off", changed(c, gain_error=1e-9)),
            ("radii for", changed(c, radius=c["radius"][1:])),
            ("it is no certificate of this record", changed(c, id="other")),
            ("no cell", changed(c, cells=[changed(c["cells"][0], part=[3])]))):
        found = reason(record, other)
        assert re.search(words, found), (words, found)
        print(f"refused as it should be: {found}", flush=True)
    moved = json.loads(json.dumps(record))
    moved["segments"][1]["z"][7] += 1e-9
    turned = json.loads(json.dumps(record))
    turned["segments"][0]["yaw"] = [0.1] * 8
    for other in (moved, turned):
        assert reason(other, certificate) == "the trajectory does not rest"


BOUNDS = {"geometric": [0.3] * 3 + [0.1] * 3 + [0.1] * 3 + [0.02] + [0.2, 0.2, 0.05] + [2, 2, 0.2] + [2, 2, 0.2] + [0.003] * 3 + [0.05] * 3,
          "cascade": [0.2] * 3 + [0.1] * 3 + [0.01, 0.01, 0.03, 0.01] + [0.05, 0.05, 0.02] + [0.5, 0.5, 0.1] * 2 + [0.1, 0.1, 0.03] + [0.1] * 3 + [0.2] * 3
          + [0.02] * 3 + [0.1] * 3}


def asked_of(loop, j):
    """What the cascade's loops ask for in a millisecond, with a name: models."""
    claim, out = loop.claim, {}
    speed, accelerations, lift = loop.runs[j // claim.position_period]
    out["speed"], out["before"], out["acceleration"], out["lift"] = speed, accelerations[:3], accelerations[3:], lift
    out["rates"], (out["spin before"], out["spin"]) = loop.turns[j // claim.period], (loop.spins[6 * j:6 * j + 3], loop.spins[6 * j + 3:6 * j + 6])
    return out


def asked(claim, controller, s, j, before):
    """The same of a controller. What the position loop asks for stays as it was when it last ran."""
    if j % claim.position_period == 0:
        pushed = [STEP * claim.position_period * i * e for i, e in zip(claim.velocity.i, controller.missed)]
        acceleration = [*controller.lift[:2], controller.lift[2] - GRAVITY]
        before = {"speed": [e + v for e, v in zip(controller.missed, s[3:6])], "acceleration": acceleration, "lift": list(controller.lift),
                  "before": [a - p for a, p in zip(acceleration, pushed)]}
    k, error = claim.rates, [a - b for a, b in zip(controller.rates, controller.last_rates)]
    spin = [p * e + i - d * f for p, e, i, d, f in zip(k.p, error, controller.integral, k.d, controller.filtered)]
    return {**before, "rates": list(controller.rates), "spin": spin, "spin before": [a - STEP * i * e for a, i, e in zip(spin, k.i, error)]}


def require_period(record, certificate, count, scale, leans=0, turns=0):
    """What a quadrotor does in a period, from anywhere within bounds of its coordinates times `scale`, is within the model's remainders. `leans`
    and `turns` are bounds of how far the body's z axis and its heading are off, if they are not 0."""
    claim, chance = Claim(certificate), np.random.default_rng(SEED)
    track, cell = track_of(record, certificate["frame"]), Cell(claim)
    loop = LAWS[claim.controller](claim, cell, float(track.at(0, 0)[4][0]))
    references, rows = track.at(0, loop.span), claim.law.ROWS
    bounds = scale * np.array(BOUNDS[claim.controller])
    if leans:
        bounds[6:10] = [leans, leans, bounds[8], max(turns, bounds[9])]
    after = loop.run([[fixed(F(b)) for b in bounds]])
    real = lambda values: np.array([v / ONE for v in values])
    middle, held, halves, named = real(loop.middle), real(loop.held), real(loop.halves), real(loop.named_bounds(0))
    gusts, names, at_start = np.array(loop.gust_symbols), np.array(loop.named_symbols), rows.gust + 3 + len(halves)
    used = collections.Counter()
    for _ in range(count):
        off = bounds * chance.choice([-1, 1, 0.5, 0], len(bounds))
        held_off = halves * chance.choice([-1, 1, 0], len(halves))
        gust = [(off[rows.gust + i] - off[i]) / claim.drag_rate + off[rows.velocity + i] - held_off[i] for i in range(3)]
        e = [*(middle + off), *(held + held_off)]
        seed = int(chance.integers(1 << 30))
        same = np.random.default_rng(seed)
        with_gains_off(claim, same)  # as in flown()
        towards = same.normal(size=3)
        towards *= claim.gust_most / np.linalg.norm(towards)
        seen = []
        watch = lambda j, controller, s: seen.append(asked(claim, controller, s, j, seen[-1] if seen else None))
        then, commands, moved, upright = flown(claim, np.random.default_rng(seed), e, gust, references, 0, loop.span,
                                               watch if claim.controller == "cascade" else None)
        symbols = np.zeros(loop.of.count)
        symbols[:at_start], symbols[gusts] = [*off, *held_off], np.tile(towards, loop.span)

        def require_within(model, value, what, i=0):
            slopes = np.zeros(loop.of.count)
            slopes[:len(model.l)] = real(model.l)
            room = np.abs(slopes[names]) @ named + model.r[0] / ONE
            away = abs(value - model.c / ONE - slopes @ symbols)
            assert away <= room + 1e-9, (what, i, away, room)
            used[what] = max(used[what], away / (room + 1e-9))

        for i in range(rows.gust):
            require_within(after[i], then[i], "coordinate", i)
        for j in range(loop.span):
            for m in range(4):
                require_within(loop.commands[j][m], commands[j][m], "motor", m + 1)
            for i in range(3):
                require_within(loop.moved[j][i], moved[j][i], "moved", i)
            require_within(loop.axes[j][2], upright[j], "tilt")
            for what, models in asked_of(loop, j).items() if seen else ():
                for i, m in enumerate(models):
                    require_within(m, seen[j][what][i], what, i)
    assert (0.2 if scale == 1 else 0.5) < used["coordinate"], used
    shares = ", ".join(f"{what} {share:.2f}" for what, share in used.items())
    print(f"{record['id']}: {count} periods from anywhere within bounds; at most so much of a remainder was used: {shares}", flush=True)


def require_flights_within(record, certificate, flights, seconds):
    """Of flights of any length. Returns how far one came."""
    claim, track, chance, most = Claim(certificate), track_of(record, certificate["frame"]), np.random.default_rng(SEED), 0
    periods = round(seconds / STEP) // claim.period
    for _ in range(flights):
        away, *off = (size * v / np.linalg.norm(v) for size, v in
                      zip((claim.wind_spread, claim.start_error, claim.start_speed), chance.normal(size=(3, 3))))
        _, _, middles, halves = Cell(claim).nominal()
        factors = (np.array(middles) + chance.choice([-1, 1], len(halves)) * halves).tolist()
        kept, gust, towards, gusts = claim.gust_kept(1), np.zeros(3), np.zeros(3), []
        for n in range(periods * claim.period):
            gusts.append(gust.tolist())
            if n % 100 == 0:
                towards = chance.normal(size=3)
                towards *= claim.gust_most / np.linalg.norm(towards)
            gust = kept * gust + (1 - kept) * towards
        _, places = fly(claim, track, (np.array(claim.wind) + away).tolist(), factors, periods, gusts, off)
        far = np.linalg.norm(places - track.at(0, 0)[0][0], axis=1)[-(-claim.before // claim.period):]
        assert far.max() <= max(claim.radius), (record["id"], far.max(), max(claim.radius))
        most = max(most, far.max())
    return most


class Watched(tube_cascade.Controller):
    """Notes the most that each loop has asked for in any flight."""

    most = collections.Counter()

    def command(self, n, s, reference):
        out = super().command(n, s, reference)
        found = asked(self.claim, self, s, n, getattr(self, "seen", None))
        self.seen = found
        for what in ("rates", "speed", "acceleration", "spin"):
            self.most[what] = max(self.most[what], *map(abs, found[what]))
        self.most["motor"] = max(self.most["motor"], *out)
        if n >= self.claim.before:
            self.most["lean"] = max(self.most["lean"], math.acos(body_axes(s[6:10])[2][2]))
        self.most["tilt"] = max(self.most["tilt"], math.atan2(math.hypot(*self.lift[:2]), self.lift[2]))
        return out


def require_sums(hover):
    """What was bounded by powers up to some age is at least what all powers up to four times that age say, and hardly more."""
    forms, count = hover.place_forms, 4 * hover.sums.count
    sums = Sums(hover, forms, [0])
    while sums.count < count:
        sums.advance(False)
    at_least = lambda most, found, by: all(b <= a <= by * b for a, b in zip(most, found))
    assert at_least(hover.gusts_for_ever[hover.place], sums.gusts_of(count), 1.05)
    assert at_least(hover.balls_for_ever[:1], [sums.reaches[count][0] * sums.most >> BITS], 1.1)
    assert all(a <= b for k in range(hover.last + 1) for a, b in zip(sums.gusts_of(min(k, count)), (*hover.gusts, hover.gusts_for_ever)[k][hover.place]))
    assert at_least(hover.rest[-1][hover.place], [swing(box, hover.fresh[-1]) for box in sums.box], 1.5)
    # What is held goes on as it did.
    held, columns, after = hover.held, hover.held.at[hover.held.until], []
    for k in range(3 * held.until):
        columns = [list(map(add, a, b)) for a, b in zip(product(columns, hover.rows), held.added)]
    for row, drift in zip(forms, hover.drift[hover.place]):
        [now], [then] = (product([row], c) for c in (held.at[held.until], columns))
        assert held.most([list(map(sub, now, then))])[0] <= drift + BITS
        after.append(held.most([list(map(sub, now, then))])[0] / drift)
    print(f"sums of old deviations are as they should be; of the bounds of what is held up to {max(after):.2f} was used", flush=True)


def require_clips(record, certificate):
    """What loops ask for in flights must not be clipped. So limits below that are refused, each with its reason, and so is a tilt that flights reach."""
    claim = Claim(certificate)
    hover = Hover(claim, cells_of(claim, certificate["cells"])[0], resting_yaw(segments_of(record, certificate["frame"])))
    radius = hover.follow() / ONE
    require_sums(hover)
    plain, tube_cascade.Controller, Watched.most = tube_cascade.Controller, Watched, collections.Counter()
    try:
        far = require_flights_within(record, certificate, 4, 4)
    finally:
        tube_cascade.Controller = plain
    most, gains = Watched.most, certificate["gains"]
    limited = lambda name, clip: {name: {**gains[name], "clip": clip}}

    def found(**changes):
        hover.claim = hover.loop.claim = Claim(changed(certificate, **changes))
        try:
            hover.require_limits()
            hover.require_tilt()
            return ""
        except Refused as why:
            return str(why)

    cases = [("the rates may be clipped", lambda by: {"vehicle": {"body_rate_max": [by * most["rates"]] * 3}}),
             ("the velocity may be clipped", lambda by: {"gains": limited("position", by * most["speed"])}),
             ("the acceleration may be clipped", lambda by: {"gains": limited("velocity", by * most["acceleration"])}),
             ("the angular acceleration may be clipped", lambda by: {"gains": limited("rates", by * most["spin"])}),
             ("the tilt may be clipped", lambda by: {"gains": {"tilt_max": by * most["tilt"]}}),
             ("may leave its range", lambda by: {"vehicle": {"motor_most": by * most["motor"]}})]
    loose = {"vehicle": {}, "gains": {}}
    for words, change in cases:
        why = found(**change(0.999))
        assert words in why, (words, why)
        print(f"refused as it should be: {why}", flush=True)
        for of, limits in change(12).items():
            loose[of].update(limits)
    assert found(**loose) == ""
    assert "it may tilt by" in found(tilt=0.999 * most["lean"]), most["lean"]
    loop, up = hover.loop, [fixed(F(v)) for v in (0.1, 0.1, 9.8)]
    most_lift = fixed(4 * F(claim.motor_most) / F(claim.mass))
    for lift, is_clipped in ((up, False), ([*up[:2], most_lift + 1], True), ([*up[:2], fixed(F(2.9))], True), ([most_lift, 0, up[2]], True)):
        assert (loop.lift_room(lift, lift) <= 0) == is_clipped, lift
    return radius, far


def require_cascade_refused(record, certificate):
    c = certificate
    for words, other in (
            ("m off some time|it may tilt|no bounds", changed(c, gust_most=1.5 * c["gust_most"])),
            ("knows no noise", changed(c, place_noise=1e-9)),
            ("no gains that are off", changed(c, gain_error=1e-9)),
            ("milliseconds", changed(c, position_period_ms=99))):
        found = reason(record, other)
        assert re.search(words, found), (words, found)
        print(f"refused as it should be: {found}", flush=True)


def script(*arguments):
    """Exit code and words of the script as a program."""
    name = os.path.join(os.path.dirname(os.path.abspath(__file__)), "verify_hover.py")
    done = subprocess.run([sys.executable, "-B", name, *arguments], capture_output=True, text=True)
    return done.returncode, done.stdout + done.stderr


def require_exit_codes(record, certificate):
    write("record.jsonl", [record])
    code, words = script("record.jsonl", write("good.jsonl", [certificate]))
    assert code == 0 and "the tube holds" in words, words
    code, words = script("record.jsonl", write("other.jsonl", [{**certificate, "id": "other"}]))
    assert code == 1 and "there is no record of this certificate" in words and "there is no certificate" in words, words
    assert script("record.jsonl")[0] == 2
    with open("cut.jsonl", "w", encoding="utf-8") as file:
        file.write(json.dumps(certificate)[:100])
    assert script("record.jsonl", "cut.jsonl")[0] == 3


def require_alone(*cases):
    """One disturbance alone: flights come near the radius, so none can have been forgotten."""
    for case in cases:
        said, far = verify(*case), require_flights_within(*case, 8, 3)
        print(f"{case[0]['id']} alone: proved for ever {said['for_ever']:.5g} m, flights came {far:.5g} m far", flush=True)
        assert 0.7 * said["for_ever"] < far <= said["for_ever"]


def require_geometric(*cases):
    for case in cases:
        said = verify(*case)
        far = require_flights_within(*case, 3, 4)
        print(f"{case[0]['id']}: claimed {said['largest']:.5g} m, proved for ever {said['for_ever']:.5g} m, flights came {far:.5g} m far", flush=True)
        assert 0.15 * said["for_ever"] < far <= said["for_ever"]
    require_refused(*cases[0])
    require_exit_codes(*cases[0])


def require_cascade(*cases):
    held, far = require_clips(*cases[0])
    print(f"cascade: claimed {max(cases[0][1]['radius']):.5g} m, proved for ever {held:.5g} m, flights came {far:.5g} m far", flush=True)
    assert 0.15 * held < far <= held
    require_cascade_refused(*cases[1])


os.chdir(tempfile.mkdtemp())
if LAW == "geometric":
    cases = [certified(hover("quad", yaw=0.7), "--vehicle", "quad2kg", "--wind", "1,0.5,0", "--wind-spread", "0.1", "--gust-most", "0.3", "--mass-error", "0.004"),
             certified(hover("ranges", frame="neu", yaw=-0.4), "--vehicle", "quad2kg", "--wind-spread", "0.05", "--gust-most", "0.1", "--mass-error", "0.001",
                  "--drag-error", "0.05", "--motor-lag-error", "0.01", "--inertia-error", "0.005", "--start-error", "0.0002", "--start-speed", "0.0002"),
             certified(hover("crazyflie"), "--vehicle", "crazyflie", "--wind-spread", "0.2", "--gust-most", "0.2", "--mass-error", "0.004")]
else:
    cases = [certified(hover("cascade", yaw=0.7), "--vehicle", "quad2kg", "--wind", "1,0.5,0", "--gust-most", "0.2", "--start-error", "0.001",
                  "--start-speed", "0.001", "--inertia-error", "0.001"),
             certified(hover("small cascade", frame="neu", yaw=-0.4), "--vehicle", "crazyflie", "--wind-spread", "0.1", "--gust-most", "0.2",
                  "--mass-error", "0.002")]
for case in cases:
    for bounds in ((1,), (0.01,), (0.001, 0.1), (0.001, 0.1, 0.1)):
        require_period(*case, 40, *bounds)
(require_geometric if LAW == "geometric" else require_cascade)(*cases)
require_alone(certified(hover("wind"), "--vehicle", "quad2kg", "--wind-spread", "0.2"),
              certified(hover("start"), "--vehicle", "quad2kg", "--start-error", "0.0001", "--start-speed", "0.0001", before="0.001"),
              certified(hover("mass"), "--vehicle", "quad2kg", "--mass-error", "0.002"))

tried, chance = collections.Counter(), random.Random(SEED)
streams = [Mutants(SEED * 10 + i).of(*case) for i, case in enumerate(cases)]
for _ in range(MUTANTS):
    what, record, certificate, expected = next(chance.choice(streams))
    kind, found = what.split(":")[0], reason(record, certificate)
    tried[kind, "refused" if found else "accepted"] += 1
    if not found:
        # The script has bounds of its own, and looks at the largest radius alone.
        assert expected != "refused" or kind in ("bounds", "span", "radius"), (record["id"], what)
        require_flights_within(record, certificate, 2, 2 + certificate["hover"])
for kind in sorted(tried):
    print(*kind, tried[kind])
