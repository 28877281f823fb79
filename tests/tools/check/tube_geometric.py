"""The geometric controller (Lee, Leok and McClamroch 2010): its state, a flight's commands, and a period of its loop in Taylor models."""

import math

import numpy as np

from tube_flight import FILTER_SHARE, GRAVITY, STEP, Rows, attitude_along, body_axes, motors_for, rates_along
from tube_models import ROUNDING, cosine, cross, dot, inverse, minus, plus, scaled, sine, times
from tube_period import Body, Frame, FrameChange, Plant, motor_limits

ROWS = Rows(lift=3, velocity=3, lag=3, heading=1, rates=3, spin=3, filtered=3, turned=3)
SPINS = slice(ROWS.spin, ROWS.turned)  # angular accelerations
WHOLE = 0.2  # s of which all is kept, before it grows old


def named(claim):
    """Errors that a period names, in groups of three kinds each: those of the torques. Noise and gains that are off make an error of the lift, too."""
    return [3 * claim.period, *[3] * (claim.is_noisy or claim.gain_error > 0)]


def order(claim):
    """The number of periods after which the loop runs in the same way again."""
    return 1


def place_forms(claim):
    """The place in linear forms of the state, all as deviations."""
    forms = np.zeros((3, ROWS.states))
    for i in range(3):
        forms[i, [ROWS.lift + i, ROWS.velocity + i]] = -1 / claim.position[i], -claim.velocity[i] / claim.position[i]
    return forms


def stretch(claim):
    """The place may be so many times as far away as those forms say."""
    return 1.0


def slow_forms(claim, maps, yaw):
    """What is slow: lift, velocity and heading."""
    return np.eye(ROWS.states)[[0, 1, 2, 3, 4, 5, ROWS.heading]]


class Controller:
    """What of it stays from one step to the next."""

    def __init__(self, claim, flown=None):
        """`flown` has its gains, if they differ from those of the claim."""
        self.claim, self.flown = claim, flown or claim
        self.filtered, self.last_rates = [0.0] * 3, [0.0] * 3
        self.misread = [0.0] * 3  # noise of the last rates

    def look(self, s, reference, gains):
        """The attitude loop runs."""
        p, v, a, jerk, yaw, yaw_rate = reference
        kp, kv = gains.position, gains.velocity
        self.lift = [kp[i] * (p[i] - s[i]) + kv[i] * (v[i] - s[3 + i]) + a[i] + (GRAVITY if i == 2 else 0.0) for i in range(3)]
        self.wanted = attitude_along(self.lift, yaw)
        self.rates = rates_along(self.wanted, math.sqrt(dot(self.lift, self.lift)), jerk, yaw, yaw_rate)

    def command(self, n, s, reference):
        """The motors' commands in a step, not clipped."""
        claim, gains, w = self.claim, self.flown, s[10:13]
        if n % claim.period == 0:
            self.look(s, reference, gains)
        body = body_axes(s[6:10])
        towards = [[dot(b, a) for a in self.wanted] for b in body]  # body . wanted
        error = [0.5 * (dot(self.wanted[j], body[k]) - dot(self.wanted[k], body[j])) for j, k in ((2, 1), (0, 2), (1, 0))]
        follow = [dot(row, self.rates) for row in towards]
        for i in range(3):
            self.filtered[i] += FILTER_SHARE * ((w[i] - self.last_rates[i]) / STEP - self.filtered[i])
        self.last_rates = list(w)
        spin = [-gains.attitude[i] * error[i] - gains.rates[i] * (w[i] - follow[i]) - gains.lead[i] * self.filtered[i] for i in range(3)]
        inertia = claim.inertia
        turn, carried = cross(w, scaled(inertia, w)), cross(w, follow)
        torque = [inertia[i] * (spin[i] - carried[i]) + turn[i] for i in range(3)]
        return motors_for(claim, claim.mass * dot(self.lift, body[2]), torque)

    def coordinates(self, s, quadrotor, reference):
        """The state as docs/tube.md describes it, up to the gust, when the attitude loop has run."""
        claim = self.claim
        self.look(s, reference, claim)
        body = body_axes(s[6:10])
        force = sum(s[13:17]) / claim.mass
        seen = [[dot(axis, b) for axis in self.wanted] for b in body]  # each axis of the body in the wanted frame
        size = math.sqrt(dot(self.lift, self.lift))
        lag = [-force * seen[2][0], -force * seen[2][1], size - force * seen[2][2]]
        torque = quadrotor.torque(s[13:17])
        last_rates = minus(self.last_rates, self.misread)
        filtered = [f - FILTER_SHARE / (1 - FILTER_SHARE) / STEP * n for f, n in zip(self.filtered, self.misread)]
        return [*self.lift, *s[3:6], *lag, math.atan2(seen[0][1], seen[0][0]), *s[10:13],
                *(torque[i] / claim.inertia[i] for i in range(3)), *filtered, *(s[10 + i] - last_rates[i] for i in range(3))]


class Period(Plant):
    def start(self):
        super().start()
        self.body = Body(**self.body_parts(), lag=self.three(ROWS.lag), missing=self.zero(), turned=self.three(ROWS.turned))

    def want(self):
        """The wanted frame and body rates."""
        _, _, _, jerk, yaw, yaw_rate = self.reference(0)
        jerk = [jerk[:, i] for i in range(3)]
        self.wanted = w = Frame.along(self.lift, np.sin(yaw), np.cos(yaw))
        along = dot(w.z, jerk)
        dz = times(inverse(w.size), [jerk[i] - along * w.z[i] for i in range(3)])
        across = plus(times(-yaw_rate, w.ahead(w.z)), w.left(dz))
        self.wanted_rates = [-dot(dz, w.y), dot(dz, w.x), dot(across, w.y) * inverse(w.across)]

    def frame(self, body):
        """The body's, seen from the wanted one."""
        return Frame.along([-body.lag[0], -body.lag[1], self.wanted.size - body.lag[2]], sine(body.heading), cosine(body.heading))

    def slope(self, body, wind):
        frame = self.frame(body)
        parts, z = self.motion(body, frame, body.lag, wind)
        lacks = self.lag * body.missing
        return Body(**parts, lag=[-(lacks * frame.z[i]) - frame.size * z[i] for i in range(3)], missing=-lacks)

    def attitude_error(self, seen, high_x, high_y):
        """Of the axes that are seen, and how high x and y are in the wanted frame."""
        dx = [1.0 - seen.x[0], -seen.x[1], -seen.x[2]]
        dz = [-seen.z[0], -seen.z[1], 1.0 - seen.z[2]]
        second = cross(dz, dx)
        return [high_y - 0.5 * dot(seen.z, second), -high_x - 0.5 * dot(dz, dx), 0.5 * dot(seen.x, second) - seen.y[0]]

    def command(self, millisecond):
        """What thrust and torque the motors are told; the second-order terms of the torque become symbols."""
        claim, body = self.claim, self.body
        seen = frame = self.frame(body)
        shrink = inverse(self.wanted.size)
        high_x, high_y = shrink * dot(frame.x, body.lag), shrink * dot(frame.y, body.lag)
        self.filtered = [(1 - FILTER_SHARE) * f + (FILTER_SHARE / STEP) * t for f, t in zip(self.filtered, body.turned)]
        body.turned = [self.zero() for _ in range(3)]
        body.missing = dot(body.lag, frame.z)
        rates, filtered = body.rates, self.filtered
        if claim.is_noisy:
            noise = self.any_three(claim.rate_noise)
            rates, filtered = plus(rates, noise), plus(filtered, times(FILTER_SHARE / STEP, noise))
            seen, off = self.read(frame)
            high_x, high_y = high_x + off[0][2], high_y + off[1][2]
            body.missing = body.missing + self.wanted.size * off[2][2]
        error = self.attitude_error(seen, high_x, high_y)
        follow = [dot(axis, self.wanted_rates) for axis in (seen.x, seen.y, seen.z)]
        turn, carried = self.gyroscopic(rates), cross(rates, follow)
        self.asked = []
        for i in range(3):
            pulled, damped = self.by_gain(claim.attitude[i], error[i]), self.by_gain(claim.rates[i], rates[i] - follow[i])
            spin = turn[i] - pulled - damped - self.by_gain(claim.lead[i], filtered[i])
            self.asked.append(self.named(spin - carried[i], 3 * millisecond + i))
        if claim.is_noisy:
            self.take_back(noise, millisecond)
        self.commands.append(self.motors(self.wanted.size * seen.z[2]))

    def take_back(self, noise, millisecond):
        """A reading puts noise into the low pass, and the next one takes a share of it out again. Here that share is taken out beforehand."""
        claim, more = self.claim, FILTER_SHARE * FILTER_SHARE / (1 - FILTER_SHARE) / STEP
        for i in range(3):
            gain = claim.rates[i] + FILTER_SHARE / STEP * claim.lead[i]
            known = self.by_error(noise[i], self.asked[i], gain, 3 * millisecond + i)
            self.filtered[i] = self.filtered[i] - more * known

    def misread(self):
        """The lift that is asked for is another one: of a place and a velocity with noise, by gains that are off. Returns by how much."""
        claim, (_, v, a, _, yaw, _), more = self.claim, self.reference(0), []
        for i in range(3):
            misplaced, mistimed = claim.position[i] * claim.place_noise, claim.velocity[i] * claim.velocity_noise
            damped = claim.velocity[i] * (v[:, i] - self.velocity[i])
            pulled = self.lift[i] - a[:, i] - (GRAVITY if i == 2 else 0.0) - damped  # kp (p_r - p)
            size = misplaced + mistimed + claim.gain_error * (pulled.size() + misplaced + damped.size() + mistimed)
            more.append(self.named(self.within(size * (1 + ROUNDING)), 3 * claim.period + i))
        self.turn_wanted_frame(more, yaw, yaw)
        self.want()
        return more

    def run(self):
        claim = self.claim
        self.want()
        more = self.misread() if claim.is_noisy or claim.gain_error else None
        for millisecond in range(claim.period):
            self.command(millisecond)
            self.move(millisecond)
        now, then = self.reference(0), self.reference(claim.period)
        p, v, a = (then[k] - now[k] for k in range(3))
        faster = minus(self.body.velocity, self.velocity)
        change = [claim.position[i] * p[:, i] + claim.velocity[i] * v[:, i] + a[:, i]
                  - (claim.position[i] * self.body.moved[i] + claim.velocity[i] * faster[i]) for i in range(3)]
        self.turn_wanted_frame(minus(change, more) if more else change, now[4], then[4])
        self.after = [*self.changed(), *self.gust_after()]

    def turn_wanted_frame(self, change, yaw, next_yaw):
        """The lift changes, and so the wanted frame turns."""
        body, turn = self.body, FrameChange(self.wanted, change, yaw, next_yaw)
        lag = plus(body.lag, turn.lift)
        body.heading = turn.heading(body.heading, self.frame(body).x)
        body.lag = plus(lag, [dot(d, lag) for d in (turn.x, turn.y, turn.z)])
        self.lift = plus(self.lift, change)

    def changed(self):
        """The state up to the gust."""
        body = self.body
        return [*self.lift, *body.velocity, *body.lag, body.heading, *body.rates, *body.spin, *self.filtered, *body.turned]

    def limits(self):
        return motor_limits(self.claim, self.commands)


class Start(Period):
    """The state when the controller first runs. The symbols of lift and velocity stand for how far the vehicle is off, and how fast it moves."""

    def run(self):
        claim, yaw = self.claim, self.reference(0)[4]
        off = self.level()
        self.body.lag = [self.zero(), self.zero(), self.missing()]
        self.wanted = Frame.along(self.lift, np.sin(yaw), np.cos(yaw))
        change = [-(claim.position[i] * off[i]) - claim.velocity[i] * self.velocity[i] for i in range(3)]
        self.turn_wanted_frame(change, yaw, yaw)
        self.after = self.changed()
