"""verify_tube.py RECORDS CERTIFICATES: follows the proofs of tubes.

RECORDS are trajectories and CERTIFICATES what `skyway-fly --proved-tube --certificate` wrote of them (JSON Lines). The script flies
the middle of each cell with a quadrotor's own equations, works out for each period of the attitude loop how deviations go on,
with a bound of what is not linear, and adds up what winds, gusts and masses can do. Exit 0 when there is a record, and every one
has a certificate that holds; 1 when one is refused, with the reason; 2 for wrong usage; 3 when a file cannot be read as what it
should be, or NumPy is not there. docs/certificates.md says what is checked, and what is trusted.
"""

import functools
import math
import multiprocessing
import os
import sys

try:
    import numpy as np
except ImportError:
    print("verify_tube.py needs NumPy (Debian: python3-numpy); every other script of these needs only Python", file=sys.stderr)
    sys.exit(3)

from tube_claim import STEP, Claim, cells_of, verify_files
from tube_deviations import SLACK, UP, Deviations, slacks
from tube_flight import GRAVITY, fly, track_of
from tube_models import ROUNDING, SidewaysError
from tube_period import groups
from verify_certificate import Refused, require, run_main

LEAST_SCALE = 1e-9  # of a symbol: slopes are needed of coordinates that do not vary, too
CHUNK = 500  # periods, about, whose maps are worked out together


# ---- A cell.

class CellProof:
    def __init__(self, claim, track, cell):
        self.claim, self.cell = claim, cell
        steps = round((track.duration + claim.settle) / STEP)
        self.count = (claim.before + steps) // claim.period + 1
        self.track = track
        self.wind, radius, self.factors, halves = cell.nominal()
        require(sum(cell.periods) == self.count, f"a cell must have bounds of {self.count} periods, found {sum(cell.periods)}")
        self.rows = rows = claim.law.ROWS
        self.scales = np.empty((self.count, rows.states))
        self.scales[:, :rows.wind] = np.maximum(np.repeat(np.array(cell.bounds).reshape(-1, rows.wind), cell.periods, axis=0), LEAST_SCALE)
        self.scales[:, rows.wind:rows.wind + 3] = np.maximum(radius, LEAST_SCALE)
        self.scales[:, rows.lightness:] = np.maximum(halves, LEAST_SCALE)
        self.require_start()

    def instant(self, period):
        return (period * self.claim.period - self.claim.before) * STEP

    def require_start(self):
        claim = self.claim
        for mass in self.cell.masses:
            weight = claim.mass * float(mass) * GRAVITY / 4
            require(claim.motor_least * (1 + 1e-12) <= weight <= claim.motor_most * (1 - 1e-12), "its weight is beyond its motors")

    def follow(self):
        claim = self.claim
        self.states, self.places = fly(claim, self.track, self.wind, self.factors, self.count)
        self.references = self.track.at(-claim.before, (self.count + 1) * claim.period - claim.before)
        deviations = Deviations(claim, self.cell, self.states[0], self.start())
        chunk = max(1, CHUNK // deviations.block) * deviations.block
        for first in range(0, self.count, chunk):
            self.follow_chunk(first, min(first + chunk, self.count), deviations)

    def start(self):
        """The state when the controller first runs, for all starts and masses."""
        claim, rows, scales = self.claim, self.rows, np.zeros((1, self.rows.states))
        scales[:, rows.lift:rows.lift + 3], scales[:, rows.velocity:rows.velocity + 3] = claim.start_error, claim.start_speed
        scales[:, rows.lightness:] = self.scales[0, rows.lightness:]
        try:
            return claim.law.Start(claim, self.states[:1], scales, self.references, np.array([0])).after
        except SidewaysError:
            raise Refused("a thrust or lift may point sideways at the start") from None

    def follow_chunk(self, first, last, deviations):
        chunk = Chunk(self, first, last)
        if first == 0:
            deviations.box_along(self.claim.law.slow_forms(self.claim, chunk.maps, float(self.references[4][0])))
        for begin in range(first, last, deviations.block):
            periods = np.arange(begin, min(begin + deviations.block, last))
            deviations.begin(*(each[periods - first] for each in (chunk.maps, chunk.named, chunk.box)))
            bounds, reach = deviations.bounds()
            self.require_bounds(begin, bounds)
            self.require_radius(begin, reach, chunk.further[periods - first])
            chunk.require_limits(periods, deviations)
            deviations.end(self.scales[periods[-1], :self.rows.wind])
        self.require_tilt(first, chunk.least)

    def by_coordinates(self, slopes, scales):
        """Slopes by symbols as slopes by coordinates of the state, and what rounding loses over all deviations."""
        drag, rows = self.claim.drag_rate, self.rows
        out = slopes.T / scales
        lost = ROUNDING * (np.abs(out) * scales).sum(1)
        if drag:
            for i in range(3):
                a = out[:, rows.gust + i].copy()
                balance = ((rows.lift + i, 1.0), (rows.velocity + i, -drag), (rows.gust + i, drag), (rows.wind + i, drag))
                for row, factor in balance:
                    size = self.claim.gust_most if row == rows.gust + i else scales[:, row]
                    lost = lost + ROUNDING * np.abs(a * factor) * size
                    out[:, row] = (0.0 if row == rows.gust + i else out[:, row]) + factor * a
        return out, lost

    # What must hold.

    def require_bounds(self, first, bounds):
        claimed = self.scales[first:first + len(bounds), :self.rows.wind]
        if not np.all(bounds[:, :self.rows.wind] <= claimed):
            j, row = np.unravel_index(np.argmax(bounds[:, :self.rows.wind] / claimed), claimed.shape)
            raise Refused(f"at {self.instant(first + j):.3f} s row {row} may reach {bounds[j, row]:.6g}, claimed {claimed[j, row]:.6g}")

    def require_radius(self, first, reach, further):
        claim = self.claim
        for j in range(len(reach)):
            step = (first + j) * claim.period - claim.before
            if step + claim.period <= 0:
                continue
            place = self.references[0][(first + j) * claim.period]
            radius = claim.law.stretch(claim) * (math.dist(self.places[first + j], place) + reach[j]) + further[j] + SLACK
            for k in range(max(step, 0) // 100, (step + claim.period - 1) // 100 + 1):
                claimed = claim.radius[min(k, len(claim.radius) - 1)]
                require(radius <= claimed, f"at {step * STEP:.3f} s it may be {radius:.6g} m off, claimed {claimed:.6g} m")

    def require_tilt(self, first, least):
        for j, cosine in enumerate(least):
            if self.instant(first + j + 1) > 0:
                require(cosine > math.cos(self.claim.tilt) + 1e-15, f"at {self.instant(first + j):.3f} s it may tilt by "
                        f"{math.acos(max(min(cosine, 1), -1)):.6g}, claimed {self.claim.tilt:.6g}")


class Chunk:
    """Some periods of a cell: how deviations go on in them, and what may reach a limit."""

    def __init__(self, proof, first, last):
        self.proof, self.claim, self.rows, self.first = proof, proof.claim, proof.rows, first
        count, rows, claim = last - first, self.rows, self.claim
        self.maps = np.zeros((count, rows.states, rows.states))
        self.maps[:, rows.wind:, rows.wind:] = np.eye(rows.states - rows.wind)
        self.named = np.empty((count, rows.wind, sum(claim.law.named(claim))))
        self.box = np.empty((count, rows.wind))
        self.further, self.least = np.zeros(count), np.full(count, np.inf)
        self.limits = []
        for periods in groups(claim, np.arange(first, last)):
            try:
                found = claim.law.Period(claim, proof.states[periods], proof.scales[periods], proof.references, periods * claim.period)
            except SidewaysError as reason:
                raise Refused(f"a thrust or lift may point sideways at {proof.instant(periods[reason.period]):.3f} s") from None
            self.take_maps(periods, found)
            self.take_moves(periods, found)
            self.limits.append((periods, Limits(found, self.proof, periods)))

    def take_maps(self, periods, found):
        """Of the deviations at a period's start those at its end: a matrix, columns of named errors, and a box around the next
        nominal state."""
        proof, at = self.proof, periods - self.first
        allowed = slacks(self.claim.law)
        for i, model in enumerate(found.after):
            self.maps[at, i], lost = proof.by_coordinates(model.l[:self.rows.states], proof.scales[periods])
            self.named[at, i] = model.l[self.rows.states:].T
            off = np.abs(model.c - proof.states[periods + 1, i])
            worst = int(np.argmax(off))
            require(off[worst] <= allowed[i], f"the equations differ from a quadrotor's own by {off[worst]:.2g} at {proof.instant(periods[worst]):.3f} s")
            self.box[at, i] = (model.r + ROUNDING * model.size() + lost + off) * UP + allowed[i]

    def take_moves(self, periods, found):
        """How far the vehicle moves from the reference during each period, and the least cosine of its tilt."""
        at, places, starts = periods - self.first, self.proof.references[0], periods * self.claim.period
        for j, (moved, upright) in enumerate(zip(found.moved, found.upright), 1):
            wanted = places[starts + j] - places[starts]
            away = [np.abs(m.c - wanted[:, i]) + m.radius() for i, m in enumerate(moved)]
            self.further[at] = np.maximum(self.further[at], np.sqrt(sum(a * a for a in away)) * UP)
            self.least[at] = np.minimum(self.least[at], upright.least() - SLACK)

    def require_limits(self, some, deviations):
        for periods, limits in self.limits:
            at = np.flatnonzero((periods >= some[0]) & (periods <= some[-1]) & ~limits.hold)
            if len(at):
                limits.require(at, periods[at] - some[0], deviations)


class Limits:
    """What a controller and motors may be told in some periods, and whether the bounds alone keep it within its limits (`hold`)."""

    def __init__(self, found, proof, periods):
        self.proof, self.periods = proof, periods
        self.models, self.rooms = found.limits()
        self.middles = np.array([m.c for m in self.models])
        halves = np.array([m.radius() + ROUNDING * m.size() + SLACK for m in self.models])
        self.hold = np.all([room > 0 for _, room in self.rooms(self.middles, halves)], axis=0)

    def require(self, at, in_block, deviations):
        """The same of the periods `at`, by what disturbances so far may do."""
        proof, states, count = self.proof, self.proof.rows.states, len(self.models)
        slopes = np.concatenate([m.l[:states, at] for m in self.models], axis=1)
        scales = np.tile(proof.scales[self.periods[at]], (count, 1))
        forms, lost = proof.by_coordinates(slopes, scales)
        bounds = (deviations.bounds_at(np.tile(in_block, count), forms) + lost).reshape(count, -1)
        rest = [np.abs(m.l[states:, at]).sum(0) * UP + m.r[at] + ROUNDING * m.size()[at] + SLACK for m in self.models]
        for what, room in self.rooms(self.middles[:, at], bounds + np.array(rest)):
            worst = int(np.argmin(room))
            require(np.all(room > 0), f"{what} at {proof.instant(self.periods[at[worst]]):.3f} s, by {-room[worst]:.4g}")


def follow(claim, track, cell):
    with np.errstate(all="ignore"):  # what is not finite is within no bound
        CellProof(claim, track, cell).follow()


def follow_all(claim, track, cells):
    """On all cores, if there are several cells."""
    if len(cells) == 1:
        return follow(claim, track, cells[0])
    with multiprocessing.get_context("fork").Pool(min(len(cells), os.cpu_count() or 1)) as pool:
        return pool.starmap(follow, [(claim, track, cell) for cell in cells], chunksize=1)


def verify(record, certificate):
    """Raises Refused; else says what has been shown."""
    require(certificate.get("type") == "tube_certificate" and certificate.get("id") == record.get("id"), "it is no certificate of this record")
    claim = Claim(certificate)
    track = track_of(record, certificate["frame"])
    require(len(claim.radius) == math.ceil(track.duration / 0.1), f"{len(claim.radius)} radii for {track.duration} s")
    cells = cells_of(claim, certificate["cells"])
    try:
        follow_all(claim, track, cells)
    except (ArithmeticError, ValueError, np.linalg.LinAlgError) as reason:
        raise Refused(f"its numbers are out of range: {reason}") from None
    said = {key: value for key, value in certificate.items() if key not in ("type", "id", "period", "radius", "cells")}
    return {"largest": max(claim.radius), **said}


if __name__ == "__main__":
    run_main(__doc__, 2, functools.partial(verify_files, verify, "the tube holds for"))
