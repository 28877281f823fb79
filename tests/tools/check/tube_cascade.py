"""The cascade of position, velocity, attitude and body rates, as in PX4: its state, a flight's commands, and a period of its loop in Taylor models."""

import copy
import math

import numpy as np

from tube_flight import FILTER_SHARE, GRAVITY, STEP, Rows, attitude_along, body_axes, motors_for, rates_along
from tube_models import ROUNDING, arcus_sine, cosine, cross, dot, inverse, minus, plus, root, scaled, sine, times
from tube_period import Body, Frame, FrameChange, Plant, motor_limits

ROWS = Rows(lift=3, velocity=3, tilt=2, missing=1, heading=1, rates=3, spin=3, filtered=3, integral=3, missed=3, slope=3, due=3)
SPINS = slice(ROWS.spin, ROWS.missed)  # angular accelerations
WHOLE = 1.2  # s of which all is kept, before it grows old
VELOCITY_FILTER = 1 / (2 * 3.141592653589793 * 5)  # s, of the velocity loop's derivative
YAW_WEIGHT = 0.4  # of the error about the vertical axis
LEAST_LIFT = 0.3 * GRAVITY
SLOWEST = 12.0  # 1/s: modes that die away more slowly are slow
UP = 1 + 1e-14


def named(claim):
    """Errors that a period names, in groups of three kinds each: of the wanted rates, the torques, and the velocity. With noise, each run of the position
    loop has an error of what it reads."""
    return [3, 3 * claim.period, 3, *[3 * -(-claim.period // claim.position_period)] * claim.is_noisy]


def order(claim):
    """The number of periods after which the loops run in the same way again."""
    return claim.position_period // math.gcd(claim.position_period, claim.period)


class LiftGains:
    """How the velocity's error makes the lift change when the position loop runs: drift of_drift + missed of_missed - slope of_slope, where the error
    has changed by `drift` since the loop last ran."""

    def __init__(self, claim):
        k = claim.velocity
        self.period = claim.position_period * STEP
        self.share = self.period / (self.period + VELOCITY_FILTER)
        self.of_missed = [self.period * i for i in k.i]
        self.of_slope = [self.share * d for d in k.d]
        self.of_drift = [p + m + s / self.period for p, m, s in zip(k.p, self.of_missed, self.of_slope)]


def place_forms(claim):
    """The place in linear forms of the state, all as deviations: the velocity's error of now is kp (p_r - p) + what is asked - v."""
    k, forms = LiftGains(claim), np.zeros((3, ROWS.states))
    for i in range(3):
        forms[i, ROWS.velocity + i] = 1.0
        forms[i, ROWS.missed + i] = 1 - k.of_missed[i] / k.of_drift[i]
        forms[i, ROWS.slope + i] = k.of_slope[i] / k.of_drift[i]
        forms[i, ROWS.due + i] = 1 / k.of_drift[i]
        forms[i] /= -claim.position[i]
    return forms


def stretch(claim):
    """The place may be so many times as far away as those forms say: the position's gain is at least 1 - gain_error times what it should be."""
    return UP / (1 - claim.gain_error)


# ---- What is slow.

def axes():
    """What concerns a movement along x, along y, up, and about the vertical, for the heading 0."""
    r = ROWS
    flat = [[row + i for row in (r.lift, r.velocity, r.tilt, r.missed, r.slope, r.due)]
            + [row + 1 - i for row in (r.rates, r.spin, r.filtered, r.integral)] for i in (0, 1)]
    up = [row + 2 for row in (r.lift, r.velocity, r.missed, r.slope, r.due)] + [r.missing]
    return [*flat, up, [r.heading, *(row + 2 for row in (r.rates, r.spin, r.filtered, r.integral))]]


def levelled(yaw):
    """What is seen from the body or its wanted frame, in the axes of the map."""
    turn = np.eye(ROWS.states)
    for row in (ROWS.tilt, ROWS.rates, ROWS.spin, ROWS.filtered, ROWS.integral):
        turn[row:row + 2, row:row + 2] = [[math.cos(yaw), -math.sin(yaw)], [math.sin(yaw), math.cos(yaw)]]
    return turn


def slow_forms(claim, maps, yaw):
    """Linear forms that the loop hardly mixes in hover: left eigenvectors of its slow modes, axis by axis. `maps` are of its first periods. Any forms
    are right."""
    through = np.eye(ROWS.states)
    for m in maps[:order(claim)]:
        through = m @ through
    turn = levelled(yaw)
    seen, seconds, forms = turn @ through @ turn.T, order(claim) * claim.period * STEP, []
    for rows in axes():
        values, vectors = np.linalg.eig(seen[np.ix_(rows, rows)].T)
        for value, vector in zip(values, vectors.T):
            if value.imag < 0 or -math.log(max(abs(value), 1e-300)) / seconds >= SLOWEST:
                continue
            for part in (vector.real, vector.imag) if value.imag > 0 else (vector.real,):
                form = np.zeros(ROWS.states)
                form[rows] = part
                forms.append(form @ turn)
    return np.array(forms).reshape(-1, ROWS.states)


# ---- A flight.

class Controller:
    """What of it stays from one step to the next."""

    def __init__(self, claim, flown=None):
        """`flown` has its gains, if they differ from those of the claim."""
        self.claim, self.flown, self.gains = claim, flown or claim, LiftGains(claim)
        self.lift, self.sum, self.slope, self.missed = [0.0, 0.0, GRAVITY], [0.0] * 3, [0.0] * 3, None
        self.integral, self.filtered, self.last_rates = [0.0] * 3, [0.0] * 3, [0.0] * 3

    def velocity_error(self, s, reference):
        p, v = reference[:2]
        return [self.flown.position[i] * (p[i] - s[i]) + self.claim.forward.velocity * v[i] - s[3 + i] for i in range(3)]

    def follow(self, s, reference):
        """The loops of position and velocity run."""
        k, period, error = self.flown.velocity, self.gains.period, self.velocity_error(s, reference)
        for i in range(3):
            rises = 0.0 if self.missed is None else (error[i] - self.missed[i]) / period
            self.slope[i] += self.gains.share * (rises - self.slope[i])
            self.sum[i] += k.i[i] * error[i] * period
            asked = k.p[i] * error[i] + self.sum[i] + k.d[i] * self.slope[i] + self.claim.forward.acceleration * reference[2][i]
            self.lift[i] = asked + (GRAVITY if i == 2 else 0.0)
        self.missed = error

    def orient(self, s, reference):
        """The attitude loop runs: first the shortest turn that brings the body's z axis along the lift, then some of the turn about it."""
        wanted, (x, y, z) = attitude_along(self.lift, reference[4]), body_axes(s[6:10])
        goal = [dot(axis, wanted[2]) for axis in (x, y, z)]  # in the body's axes
        half = math.sqrt(0.5 * (1 + goal[2]))
        about = cross(z, wanted[2])
        turned = []
        for axis in (x, y):  # after that turn
            first = cross(about, axis)
            second = cross(about, first)
            turned.append([axis[i] + first[i] + second[i] / (1 + goal[2]) for i in range(3)])
        rest = YAW_WEIGHT * math.atan2(dot(turned[1], wanted[0]), dot(turned[0], wanted[0]))
        c, sine_ = math.cos(rest / 2), math.sin(rest / 2)
        ahead, left = goal[0] / half, -goal[1] / half  # about y and about x
        error = (left * c + ahead * sine_, ahead * c - left * sine_, 2 * half * sine_)
        follow = rates_along(wanted, math.sqrt(dot(self.lift, self.lift)), *reference[3:])
        self.rates = [self.flown.attitude[i] * error[i] + self.claim.forward.body_rates * follow[i] for i in range(3)]

    def low_passed(self, w):
        return [f + FILTER_SHARE * ((a - b) / STEP - f) for f, a, b in zip(self.filtered, w, self.last_rates)]

    def command(self, n, s, reference):
        """The motors' commands in a step, nothing clipped."""
        claim, w = self.claim, s[10:13]
        if n % claim.position_period == 0:
            self.follow(s, reference)
        if n % claim.period == 0:
            self.orient(s, reference)
        k, inertia = self.flown.rates, claim.inertia
        error = minus(self.rates, w)
        self.filtered, self.last_rates = self.low_passed(w), list(w)
        self.integral = [a + k.i[i] * error[i] * STEP for i, a in enumerate(self.integral)]
        turn = cross(w, scaled(inertia, w))
        torque = [inertia[i] * (k.p[i] * error[i] + self.integral[i] - k.d[i] * self.filtered[i]) + turn[i] for i in range(3)]
        return motors_for(claim, claim.mass * math.sqrt(dot(self.lift, self.lift)), torque)

    def lift_of_exact_gains(self):
        """What the velocity loop would have asked for with the gains of the claim."""
        k, flown, missed = self.claim.velocity, self.flown.velocity, self.missed or [0.0] * 3
        sums = [(1 - k.i[i] / flown.i[i]) * a if flown.i[i] else 0.0 for i, a in enumerate(self.sum)]
        return [a - (flown.p[i] - k.p[i]) * missed[i] - sums[i] - (flown.d[i] - k.d[i]) * self.slope[i] for i, a in enumerate(self.lift)]

    def coordinates(self, s, quadrotor, reference):
        """The state as docs/tube.md describes it, up to the gust, before the controller runs."""
        claim, k = self.claim, self.gains
        lift = self.lift_of_exact_gains()
        wanted, body = attitude_along(lift, reference[4]), body_axes(s[6:10])
        x, z = ([dot(axis, b) for axis in wanted] for b in (body[0], body[2]))
        missing = math.sqrt(dot(lift, lift)) - sum(s[13:17]) / claim.mass
        torque, missed = quadrotor.torque(s[13:17]), self.missed or [0.0] * 3
        drift = minus(self.velocity_error(s, reference), missed)
        due = [k.of_drift[i] * drift[i] + k.of_missed[i] * missed[i] - k.of_slope[i] * self.slope[i] for i in range(3)]
        return [*lift, *s[3:6], z[0], z[1], missing, math.atan2(x[1], x[0]), *s[10:13], *(torque[i] / claim.inertia[i] for i in range(3)),
                *self.low_passed(s[10:13]), *self.integral, *missed, *self.slope, *due]


# ---- A period.

class Period(Plant):
    def start(self):
        super().start()
        self.gains = LiftGains(self.claim)
        none = [self.zero() for _ in range(3)]
        self.body = Body(**self.body_parts(), tilt=[self.symbol(ROWS.tilt), self.symbol(ROWS.tilt + 1)], missing=self.symbol(ROWS.missing), turned=none)
        self.integral, self.missed, self.rises, due = (self.three(row) for row in (ROWS.integral, ROWS.missed, ROWS.slope, ROWS.due))
        # What is due without the velocity: no force acts on it.
        self.lead = plus(due, scaled(self.gains.of_drift, self.velocity))
        before = (self.starts[0] - 1) // self.claim.position_period * self.claim.position_period - self.starts[0]
        # The reference rests before the controller first runs.
        self.asked_last = np.where(self.starts[:, None] > 0, self.references[2][np.maximum(self.starts + before, 0)], 0.0)
        self.runs, self.turns, self.beyond = [], [], None

    def want(self, yaw):
        self.wanted = Frame.along(self.lift, np.sin(yaw), np.cos(yaw))

    def frame(self, body):
        """The body's, seen from the wanted one."""
        x, y = body.tilt
        return Frame([x, y, root(1.0 - x * x - y * y)], sine(body.heading), cosine(body.heading))

    def slope(self, body, wind):
        frame = self.frame(body)
        x, y = body.tilt
        thrust = self.wanted.size - body.missing
        sunk = (x * x + y * y) * inverse(1.0 + frame.z[2])
        parts, z = self.motion(body, frame, [-(thrust * x), -(thrust * y), body.missing + thrust * sunk], wind)
        missing = body.missing + self.beyond if self.beyond else body.missing
        return Body(**parts, tilt=z[:2], missing=-(self.lag * missing))

    def turn_wanted_frame(self, change, yaw, next_yaw):
        body, frame = self.body, self.frame(self.body)
        turn = FrameChange(self.wanted, change, yaw, next_yaw)
        body.heading = turn.heading(body.heading, frame.x)
        body.tilt = [body.tilt[0] + dot(turn.x, frame.z), body.tilt[1] + dot(turn.y, frame.z)]
        body.missing = body.missing + turn.growth

    def follow(self, millisecond, yaw):
        """The loops of position and velocity run."""
        k, forward, asked = self.gains, self.claim.forward.acceleration, self.reference(millisecond)[2]
        v = self.body.velocity
        due = minus(self.lead, scaled(k.of_drift, v))
        drift = [(1 / k.of_drift[i]) * (due[i] - k.of_missed[i] * self.missed[i] + k.of_slope[i] * self.rises[i]) for i in range(3)]
        change = [due[i] + forward * (asked - self.asked_last)[:, i] for i in range(3)]
        noise = self.misread() if self.claim.is_noisy else None
        # As if the error had changed by the noise, too; but in its first run the loop has no derivative.
        slopes = np.where(self.starts + millisecond > 0, k.share / k.period, 0.0)
        if noise:
            change = [c + (k.of_drift[i] - self.claim.velocity.d[i] * (k.share / k.period - slopes)) * noise[i] for i, c in enumerate(change)]
        self.turn_wanted_frame(change, yaw, yaw)
        self.asked_last = asked
        self.lift, self.missed = plus(self.lift, change), plus(self.missed, drift)
        self.rises = [(1 - k.share) * a + (k.share / k.period) * x for a, x in zip(self.rises, drift)]
        if noise:
            self.missed = plus(self.missed, noise)
            self.rises = [a + slopes * x for a, x in zip(self.rises, noise)]
        self.lead = [k.of_missed[i] * self.missed[i] - k.of_slope[i] * self.rises[i] + k.of_drift[i] * v[i] for i in range(3)]
        if noise:
            self.lead = minus(self.lead, scaled(k.of_drift, noise))
            v = plus(v, self.any_three(self.claim.velocity_noise))  # as it is read
        self.want(yaw)
        lift = plus(self.lift, self.more_lift()) if self.claim.gain_error else self.lift
        acceleration = [lift[0], lift[1], lift[2] - GRAVITY]
        before = minus(acceleration, [self.by_gain(*each) for each in zip(k.of_missed, self.missed)])  # with the integral before this run
        self.runs.append([*plus(self.missed, v), *before, *acceleration, *lift])

    def more_lift(self):
        """By how much more lift gains that are off may ask for than exact ones, along each axis: of the error, its derivative, and the integral."""
        k, forward, out = self.claim.velocity, self.claim.forward.acceleration, []
        for i in range(3):
            pushed, damped = k.p[i] * self.missed[i], k.d[i] * self.rises[i]
            rest = self.lift[i] - forward * self.asked_last[:, i] - (GRAVITY if i == 2 else 0.0) - pushed - damped
            out.append(self.within(self.claim.gain_error * (pushed.size() + damped.size() + rest.size()) * (1 + ROUNDING)))
        return out

    def misread(self):
        """The noise of the velocity's error in a run of the position loop."""
        claim = self.claim
        first = 6 + 3 * claim.period + 3 * len(self.runs)
        sizes = [claim.position[i] * (1 + claim.gain_error) * claim.place_noise + claim.velocity_noise for i in range(3)]
        return [self.named(self.within(size * (1 + ROUNDING)), first + i) for i, size in enumerate(sizes)]

    def look(self, jerk, yaw, yaw_rate):
        """The attitude loop runs, by the lift that is asked for."""
        if not self.claim.gain_error:
            return self.orient(jerk, yaw_rate)
        kept, more = (self.body, self.lift, self.wanted), self.more_lift()
        self.body = copy.copy(self.body)
        self.turn_wanted_frame(more, yaw, yaw)
        self.lift = plus(self.lift, more)
        self.want(yaw)
        self.orient(jerk, yaw_rate)
        self.body, self.lift, self.wanted = kept

    def orient(self, jerk, yaw_rate):
        """The rates that are wanted."""
        frame, w, forward = self.frame(self.body), self.wanted, self.claim.forward.body_rates
        if self.claim.is_noisy:
            frame, _ = self.read(frame)
        x, y, z = frame.x[2], frame.y[2], frame.z[2]  # the wanted z axis in the body's frame
        half = root(0.5 * (1.0 + z))
        off = -(frame.x[1] - x * frame.z[1] * inverse(1.0 + z))  # the sine of the angle that is left about z
        rest = (0.5 * YAW_WEIGHT) * arcus_sine(off)
        c, s, grow = cosine(rest), sine(rest), inverse(half)
        error = [grow * (x * s - y * c), grow * (x * c + y * s), 2.0 * (half * s)]
        shrink, jerk = inverse(w.size), [jerk[:, i] for i in range(3)]
        ahead_x = w.cos * w.x[0] + w.sin * w.x[1]
        leant = shrink * dot(w.left(jerk), w.y)
        follow = [-(shrink * dot(jerk, w.y)), shrink * dot(jerk, w.x), inverse(w.across) * (yaw_rate * ahead_x + leant)]
        self.wanted_rates = [self.named(self.by_gain(self.claim.attitude[i], error[i]) + forward * follow[i], i) for i in range(3)]

    def command(self, millisecond):
        """What the motors are told; the second-order terms of the torque become symbols."""
        k, rates, filtered = self.claim.rates, self.body.rates, self.filtered
        if self.claim.is_noisy:
            noise = self.any_three(self.claim.rate_noise)
            rates, filtered = plus(rates, noise), plus(filtered, times(FILTER_SHARE / STEP, noise))
        error = minus(self.wanted_rates, rates)
        rest = [self.by_gain(k.p[i], error[i]) - self.by_gain(k.d[i], filtered[i]) for i in range(3)]
        before = plus(rest, self.integral)
        after = [a + self.by_gain(STEP * k.i[i], error[i]) for i, a in enumerate(self.integral)]
        spin = plus(rest, after)
        self.turns.append([*before, *spin])
        self.asked = [self.named(a + b, 3 + 3 * millisecond + i) for i, (a, b) in enumerate(zip(spin, self.gyroscopic(rates)))]
        if self.claim.is_noisy:
            after = self.take_noise(noise, millisecond)
        self.integral = after
        thrust = self.wanted.size
        if self.claim.gain_error:
            still = np.zeros(self.count)
            self.beyond = FrameChange(self.wanted, self.more_lift(), still, still).growth
            thrust = thrust + self.beyond
        self.commands.append(self.motors(thrust))

    def take_noise(self, noise, millisecond):
        """What the noise of the rates does to what follows. It is written by the torque's error, and the next reading takes a share of it out of the low
        pass. Returns the integral."""
        k, symbol, out = self.claim.rates, 3 + 3 * millisecond, []
        for i in range(3):
            gain = k.p[i] + STEP * k.i[i] + FILTER_SHARE / STEP * k.d[i]
            known = self.by_error(noise[i], self.asked[i], gain, symbol + i)
            out.append(self.integral[i] + self.by_gain(STEP * k.i[i], self.wanted_rates[i] - self.body.rates[i] - known))
            self.body.turned[i] = self.body.turned[i] - FILTER_SHARE * known
        return out

    def advance(self, millisecond):
        """A millisecond of the vehicle, and what the controller will know of it."""
        moved = self.body.moved
        self.move(millisecond)
        body = self.body
        self.filtered = [(1 - FILTER_SHARE) * f + (FILTER_SHARE / STEP) * t for f, t in zip(self.filtered, body.turned)]
        body.turned = [self.zero() for _ in range(3)]
        now, then = self.reference(millisecond), self.reference(millisecond + 1)
        kp, forward = self.claim.position, self.claim.forward.velocity
        for i in range(3):
            lost = self.by_gain(kp[i], (then[0] - now[0])[:, i] - (body.moved[i] - moved[i]))
            self.lead[i] = self.lead[i] + self.gains.of_drift[i] * (lost + forward * (then[1] - now[1])[:, i])

    def run(self):
        claim = self.claim
        _, _, _, jerk, yaw, yaw_rate = self.reference(0)
        next_yaw = self.reference(claim.period)[4]
        self.want(yaw)
        for millisecond in range(claim.period):
            if (self.starts[0] + millisecond) % claim.position_period == 0:
                self.follow(millisecond, yaw)
            if millisecond == 0:
                self.look(jerk, yaw, yaw_rate)
            self.command(millisecond)
            self.advance(millisecond)
        if np.any(yaw != next_yaw):
            self.turn_wanted_frame([self.zero() for _ in range(3)], yaw, next_yaw)
        body = self.body
        velocity = [self.named(v, 3 + 3 * claim.period + i) for i, v in enumerate(body.velocity)]
        due = minus(self.lead, scaled(self.gains.of_drift, velocity))
        self.after = [*self.lift, *velocity, *body.tilt, body.missing, body.heading, *body.rates, *body.spin, *self.filtered, *self.integral,
                      *self.missed, *self.rises, *due, *self.gust_after()]

    def limits(self):
        """As motor_limits(), of all that the controller may clip."""
        claim = self.claim
        commands, motor_rooms = motor_limits(claim, self.commands)
        turns = [m for turn in self.turns for m in turn] if claim.clips.rates < math.inf else []
        models = [*commands, *self.wanted_rates, *turns, *(m for run in self.runs for m in run)]
        most = 4 * claim.motor_most / claim.mass

        def rooms(middles, halves):
            yield from motor_rooms(middles[:len(commands)], halves[:len(commands)])
            sizes, at = np.abs(middles) + halves, len(commands)
            for i in range(3):
                yield "the rates may be clipped", claim.body_rate_max[i] - sizes[at + i]
            at += 3
            for size in sizes[at:at + len(turns)]:
                yield "the angular acceleration may be clipped", claim.clips.rates - size
            at += len(turns)
            for run in range(at, len(models), 12):
                for size in sizes[run:run + 3]:
                    yield "the velocity may be clipped", claim.clips.position - size
                for size in sizes[run + 3:run + 9]:
                    yield "the acceleration may be clipped", claim.clips.velocity - size
                least, highest = (middles[run + 11] + sign * halves[run + 11] for sign in (-1, 1))
                yield "the lift may be clipped", np.minimum(most - highest, least - min(LEAST_LIFT, most))
                across = np.hypot(sizes[run + 9], sizes[run + 10])
                yield "the lift may be clipped", np.sqrt(most * most - highest * highest) - across
                yield "the tilt may be clipped", least * math.tan(claim.tilt_max) - across
        return models, rooms


class Start(Period):
    """The state when the controller first runs, as if it had seen the velocity's error before: so it has no slope yet, and its integral is due. The
    symbols of lift and velocity stand for how far the vehicle is off, and how fast it moves."""

    def run(self):
        claim, body, yaw = self.claim, self.body, self.reference(0)[4]
        off = self.level()
        body.missing = self.missing()
        self.want(yaw)
        missed = [-self.by_gain(claim.position[i], off[i]) - self.velocity[i] for i in range(3)]
        change, due = scaled(claim.velocity.p, missed), scaled(self.gains.of_missed, missed)
        self.turn_wanted_frame(change, yaw, yaw)
        self.after = [*plus(self.lift, change), *self.velocity, *body.tilt, body.missing, body.heading, *body.rates, *body.spin, *self.filtered,
                      *self.integral, *missed, *self.rises, *due]
