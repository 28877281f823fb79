#include "tube/cascade_step.h"

#include "geom/vehicle/limits.h"

namespace traj {
namespace {

using geom::kGravity;
using std::asin;
using std::cos;
using std::sin;
using std::sqrt;

constexpr double kVelocityFilter = 1 / (2 * 3.141592653589793 * 5);  // s, as the controller's
constexpr double kRateFilter = 1 / (2 * 3.141592653589793 * 30);     // s, as the controller's
constexpr double kFilterShare = kMillisecond / (kMillisecond + kRateFilter);
constexpr double kYawWeight = 0.4;  // as the controller's

template <class S>
Wanted<S> wanted_for(const Triple<S>& lift, const Reference& reference) {
  return {lift, frame_along(lift, S(reference.yaw)), {}};
}

// What the position loop keeps from run to run.
template <class S>
struct Outer {
  Triple<S> lift, missed, slope;
  Triple<S> lead;  // m/s2: due + of_drift * velocity, which knows no force
  Vec3 asked;      // m/s2: the reference's acceleration when it last ran
};

template <class S>
Triple<S> due_of(const LiftGains& k, const Outer<S>& outer, const Triple<S>& velocity) {
  return outer.lead - scaled(triple(k.of_drift), velocity);
}

// How the velocity's error has changed since the position loop last ran.
template <class S>
Triple<S> drift_of(const LiftGains& k, const Outer<S>& outer, const Triple<S>& due) {
  const Triple<S> changed =
      due - scaled(triple(k.of_missed), outer.missed) + scaled(triple(k.of_slope), outer.slope);
  return scaled(triple(Vec3(k.of_drift.cwiseInverse())), changed);
}

template <class S>
Triple<S> due_without_drift(const LiftGains& k, const Outer<S>& outer) {
  return scaled(triple(k.of_missed), outer.missed) - scaled(triple(k.of_slope), outer.slope);
}

// The noise of the velocity's error, when the position loop runs.
template <class S>
struct Misread {
  Triple<S> error;     // m/s
  bool first = false;  // in the first run the velocity loop has no derivative
};

// Position and velocity loops at once. Returns how the lift changes.
template <class S>
Triple<S> follow(const CascadeLoop& loop, const Vec3& asked, const Triple<S>& velocity,
                 const Misread<S>* misread, Outer<S>& outer) {
  const LiftGains k(loop);
  const Triple<S> due = due_of(k, outer, velocity);
  const Triple<S> drift = drift_of(k, outer, due);
  const Vec3 forward = loop.gains.feed_forward.acceleration * (asked - outer.asked);
  Triple<S> change = triple(forward) + due;
  outer.missed = outer.missed + drift;
  outer.slope = (1 - k.share) * outer.slope + (k.share / k.period) * drift;
  if (misread) {
    const double slope = misread->first ? 0 : k.share / k.period;
    const Vec3 of_error = misread->first ? Vec3(k.of_drift - k.of_slope / k.period) : k.of_drift;
    change = change + scaled(triple(of_error), misread->error);
    outer.missed = outer.missed + misread->error;
    outer.slope = outer.slope + slope * misread->error;
  }
  outer.lift = outer.lift + change;
  outer.lead = due_without_drift(k, outer) + scaled(triple(k.of_drift), velocity);
  if (misread) outer.lead = outer.lead - scaled(triple(k.of_drift), misread->error);
  outer.asked = asked;
  return change;
}

// How much more lift the velocity loop asks for than with exact gains.
template <class S>
Triple<S> more_lift(const CascadeLoop& loop, const Outer<S>& outer, const GainErrors<S>& gains) {
  const PidGains& k = loop.gains.velocity;
  const Vec3 forward =
      loop.gains.feed_forward.acceleration * outer.asked + kGravity * Vec3::UnitZ();
  const Triple<S> pushed = scaled(triple(k.p), outer.missed);
  const Triple<S> damped = scaled(triple(k.d), outer.slope);
  const Triple<S> sum = outer.lift - triple(forward) - pushed - damped;
  return scaled(gains.velocity, pushed) + scaled(gains.velocity_i, sum) +
         scaled(gains.velocity_d, damped);
}

// `velocity` as it is read.
template <class S>
PositionRun<S> run_of(const CascadeLoop& loop, const Outer<S>& outer, const Triple<S>& velocity,
                      const GainErrors<S>& gains) {
  PositionRun<S> run;
  run.velocity = outer.missed + velocity;
  run.lift = gains.none ? outer.lift : outer.lift + more_lift(loop, outer, gains);
  run.acceleration = run.lift;
  run.acceleration.z = run.lift.z - kGravity;
  run.before =
      run.acceleration - by_gain(LiftGains(loop).of_missed, gains, gains.velocity_i, outer.missed);
  return run;
}

// Brescianini, Hehn and D'Andrea 2013, section IV, for a body whose axes in the wanted frame are
// those of `is`. The wanted z axis is (x, y, z) in the body's frame.
template <class S>
Triple<S> tilt_first(const Frame<S>& is) {
  const S x = is.x.z;
  const S y = is.y.z;
  const S half_tilt = sqrt(0.5 * (1.0 + is.z.z));  // its cosine
  // The body's x axis after the shortest turn that brings its z axis there; half the angle to the
  // wanted one is right up to half a turn.
  const S share = is.x.z * inverse(1.0 + is.z.z);
  const S ahead = is.x.x - share * is.z.x;
  const S across = is.x.y - share * is.z.y;
  const S half = (-kYawWeight) * asin(across * inverse(sqrt(2.0 * (1.0 + ahead))));
  const S c = cos(half);
  const S s = sin(half);
  const S grow = inverse(half_tilt);
  return {grow * (x * s - y * c), grow * (x * c + y * s), 2.0 * (half_tilt * s)};
}

// The rates that are wanted.
template <class S>
Triple<S> orient(const CascadeLoop& loop, const Wanted<S>& wanted, const TiltedBody<S>& body,
                 const Reference& reference, const Readings<S>& readings,
                 const GainErrors<S>& gains) {
  Frame<S> is = frame_of(body, wanted);
  if (!readings.exact) {
    const Frame<S> off = misread(is, readings.turn[0]);
    is.x = is.x + off.x, is.y = is.y + off.y, is.z = is.z + off.z;
  }
  const Triple<S> error = tilt_first(is);
  const double forward = loop.gains.feed_forward.body_rates;
  const Triple<S> rates = by_gain(loop.gains.attitude, gains, gains.attitude, error);
  if (forward == 0) return rates;
  return rates + forward * rates_along(wanted.frame, reference);
}

// The integral of the rate loop, a millisecond later.
template <class S>
Triple<S> grown(const PidGains& k, const GainErrors<S>& gains, const Triple<S>& integral,
                const Triple<S>& error) {
  return integral + by_gain(Vec3(kMillisecond * k.i), gains, gains.rates_i, error);
}

// The rate loop in this millisecond, by the body's rates and their low-passed slope as it sees
// them.
template <class S>
RateRun<S> turn(const PidGains& k, const GainErrors<S>& gains, const Triple<S>& rates,
                const Triple<S>& integral, const Triple<S>& body_rates, const Triple<S>& filtered) {
  const Triple<S> error = rates - body_rates;
  const Triple<S> pushed = by_gain(k.p, gains, gains.rates, error);
  const Triple<S> damped = by_gain(k.d, gains, gains.rates_d, filtered);
  RateRun<S> run;
  run.before = pushed + integral - damped;
  run.spin = pushed + grown(k, gains, integral, error) - damped;
  return run;
}

// A period while it runs.
template <class S>
class Period {
 public:
  Period(const CascadeLoop& loop, const CascadeState<S>& s, const CascadeReferences& references,
         const Readings<S>& readings, const GainErrors<S>& off_by)
      : loop_(loop),
        start_(s),
        references_(references),
        readings_(readings),
        off_by_(off_by),
        gains_(loop),
        outer_{s.lift, s.missed, s.slope, s.due + scaled(triple(gains_.of_drift), s.velocity),
               references.last_asked},
        wanted_(wanted_for(s.lift, references.at[0])),
        integral_(s.integral) {
    body_.velocity = s.velocity;
    body_.tilt_x = s.tilt_x;
    body_.tilt_y = s.tilt_y;
    body_.missing = s.missing;
    body_.heading = s.heading;
    body_.rates = s.rates;
    body_.spin = s.spin;
    body_.filtered = s.filtered;
  }

  CascadeStep<S> run() {
    const int period = static_cast<int>(references_.at.size()) - 1;
    for (int j = 0; j < period; ++j) {
      if ((references_.step + j) % loop_.periods.position == 0) run_position(j);
      if (j == 0) {
        step_.rates = wanted_rates();
        name_errors(step_.rates, CascadeRows::kStates);
      }
      advance(j);
    }
    const double yaw = references_.at[0].yaw;
    const double next_yaw = references_.at[period].yaw;
    if (next_yaw != yaw) turn_to(wanted_, change_of(wanted_, Triple<S>{}, yaw, next_yaw), body_);
    name_errors(body_.velocity, CascadeRows::kStates + 3 + 3 * kLongestPeriod);
    step_.state = state();
    return std::move(step_);
  }

 private:
  void run_position(int j) {
    const Reference& frame = references_.at[0];
    Misread<S> misread;
    Triple<S> velocity = body_.velocity;  // that is read
    if (!readings_.exact) {
      misread = {misread_error(), references_.step + j == 0};
      velocity = velocity + readings_.velocity;
    }
    const Triple<S> change = follow(loop_, references_.at[j].acceleration, body_.velocity,
                                    readings_.exact ? nullptr : &misread, outer_);
    turn_to(wanted_, change_of(wanted_, change, frame.yaw, frame.yaw), body_);
    wanted_ = wanted_for(outer_.lift, frame);
    step_.runs.push_back(run_of(loop_, outer_, velocity, off_by_));
    step_.runs.back().millisecond = j;
  }

  // The wanted frame is that of the lift with exact gains. Others ask for another attitude.
  Triple<S> wanted_rates() const {
    const Reference& now = references_.at[0];
    if (off_by_.none) return orient(loop_, wanted_, body_, now, readings_, off_by_);
    const Triple<S> more = more_lift(loop_, outer_, off_by_);
    TiltedBody<S> seen = body_;
    turn_to(wanted_, change_of(wanted_, more, now.yaw, now.yaw), seen);
    return orient(loop_, wanted_for(outer_.lift + more, now), seen, now, readings_, off_by_);
  }

  // The noise of the velocity's error. Its symbols can stand for one run of the position loop only.
  Triple<S> misread_error() {
    const Triple<S> place =
        by_gain(loop_.gains.position.p, off_by_, off_by_.position, readings_.place);
    Triple<S> out = Triple<S>{} - place - readings_.velocity;
    if (step_.runs.empty()) name_errors(out, CascadeRows::kStates + 6 + 3 * kLongestPeriod);
    return out;
  }

  // A millisecond of the rate loop and the vehicle.
  void advance(int j) {
    const PidGains& pid = loop_.gains.rates;
    Triple<S> rates = body_.rates;  // that are read
    Triple<S> filtered = body_.filtered;
    if (!readings_.exact) {
      rates = rates + readings_.rates[j];
      filtered = filtered + (kFilterShare / kMillisecond) * readings_.rates[j];
    }
    step_.turns.push_back(turn(pid, off_by_, step_.rates, integral_, rates, filtered));
    Held<S> held;
    held.thrust = wanted_.frame.size;
    if (!off_by_.none) {
      const Triple<S> more = more_lift(loop_, outer_, off_by_);
      held.beyond = change_of(wanted_, more, references_.at[0].yaw, references_.at[0].yaw).growth;
      held.thrust = held.thrust + *held.beyond;
    }
    held.spin = step_.turns.back().spin + gyroscopic(loop_.model.inertia, rates);
    const int symbol = CascadeRows::kStates + 3 + 3 * j;
    name_errors(held.spin, symbol);
    integral_ = grown(pid, off_by_, integral_, step_.rates - body_.rates);
    Triple<S> misread;
    if (!readings_.exact) {
      const Vec3 gain = pid.p + kMillisecond * pid.i + (kFilterShare / kMillisecond) * pid.d;
      misread = retold(readings_.rates[j], held.spin, gain, symbol);
      integral_ =
          integral_ - by_gain(Vec3(kMillisecond * pid.i), off_by_, off_by_.rates_i, misread);
    }
    step_.commands.push_back(motors(loop_.model, held));
    held.wind = wind_in(start_.wind, start_.gust, loop_.gusts, j);
    held.set_factors(start_);
    const TiltedBody<S> before = body_;
    body_ = runge_kutta(loop_.model, wanted_, before, held);
    // The next reading takes a share of this reading's noise out of the low pass again.
    if (!readings_.exact) body_.turned = body_.turned - kFilterShare * misread;
    body_.filtered =
        (1 - kFilterShare) * body_.filtered + (kFilterShare / kMillisecond) * body_.turned;
    body_.turned = Triple<S>{};
    step_.moved.push_back(body_.moved);
    step_.upright.push_back(in_world(wanted_.frame, frame_of(body_, wanted_).z).z);
    const Reference& now = references_.at[j];
    const Reference& next = references_.at[j + 1];
    const Triple<S> lost =
        triple(Vec3(next.position - now.position)) - (body_.moved - before.moved);
    const Vec3 led = loop_.gains.feed_forward.velocity * (next.velocity - now.velocity);
    const Triple<S> drift =
        by_gain(loop_.gains.position.p, off_by_, off_by_.position, lost) + triple(led);
    outer_.lead = outer_.lead + scaled(triple(gains_.of_drift), drift);
  }

  CascadeState<S> state() const {
    CascadeState<S> out;
    out.lift = outer_.lift;
    out.velocity = body_.velocity;
    out.tilt_x = body_.tilt_x;
    out.tilt_y = body_.tilt_y;
    out.missing = body_.missing;
    out.heading = body_.heading;
    out.rates = body_.rates;
    out.spin = body_.spin;
    out.filtered = body_.filtered;
    out.integral = integral_;
    out.missed = outer_.missed;
    out.slope = outer_.slope;
    out.due = due_of(gains_, outer_, body_.velocity);
    const int period = static_cast<int>(references_.at.size()) - 1;
    out.gust = gust_kept(loop_.gusts.lag, period) * start_.gust;
    out.wind = start_.wind;
    out.set_factors(start_);
    return out;
  }

  const CascadeLoop& loop_;
  const CascadeState<S>& start_;
  const CascadeReferences& references_;
  const Readings<S>& readings_;
  const GainErrors<S>& off_by_;
  LiftGains gains_;
  Outer<S> outer_;
  Wanted<S> wanted_;
  TiltedBody<S> body_;
  Triple<S> integral_;
  CascadeStep<S> step_;
};

}  // namespace

LiftGains::LiftGains(const CascadeLoop& loop)
    : period(kMillisecond * loop.periods.position), share(period / (period + kVelocityFilter)) {
  const PidGains& k = loop.gains.velocity;
  of_missed = period * k.i;
  of_slope = share * k.d;
  of_drift = k.p + of_missed + of_slope / period;
}

template <class S>
CascadeStep<S> cascade_step(const CascadeLoop& loop, const CascadeState<S>& state,
                            const CascadeReferences& references, const Readings<S>& readings,
                            const GainErrors<S>& gains) {
  return Period<S>(loop, state, references, readings, gains).run();
}

using Model = CascadeRows::Model;

template CascadeStep<double> cascade_step(const CascadeLoop&, const CascadeState<double>&,
                                          const CascadeReferences&, const Readings<double>&,
                                          const GainErrors<double>&);
template CascadeStep<Model> cascade_step(const CascadeLoop&, const CascadeState<Model>&,
                                         const CascadeReferences&, const Readings<Model>&,
                                         const GainErrors<Model>&);

CascadeState<Model> cascade_at_rest(const Model& lightness) {
  CascadeState<Model> s;
  s.lift.z = kGravity;
  s.missing = kGravity - kGravity * inverse(lightness);
  s.lightness = lightness;
  s.drag = s.quickness = 1.0;
  s.agility = {1.0, 1.0, 1.0};
  return s;
}

// The velocity loop has no derivative when it first runs, as if it had seen this error before. Its
// integral is not in the lift yet, but due.
CascadeState<Model> cascade_starting(const CascadeLoop& loop, const Model& lightness,
                                     const Reference& first, const Off<Model>& off,
                                     const GainErrors<Model>& gains) {
  CascadeState<Model> s = cascade_at_rest(lightness);
  const Wanted<Model> wanted = wanted_at(s.lift, first);
  const Triple<Model> place = by_gain(loop.gains.position.p, gains, gains.position, off.place);
  s.missed = Triple<Model>{} - place - off.velocity;
  s.due = scaled(triple(LiftGains(loop).of_missed), s.missed);
  const Triple<Model> change = scaled(triple(loop.gains.velocity.p), s.missed);
  TiltedBody<Model> body;
  body.missing = s.missing;
  turn_to(wanted, change_of(wanted, change, first.yaw, first.yaw), body);
  s.lift = s.lift + change;
  s.velocity = off.velocity;
  s.tilt_x = body.tilt_x;
  s.tilt_y = body.tilt_y;
  s.missing = body.missing;
  s.heading = body.heading;
  return s;
}

}  // namespace traj
