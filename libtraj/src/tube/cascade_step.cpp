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
  Triple<S> missed, slope;
  Vec3 asked;  // m/s2: the reference's acceleration when it last ran
};

// Position and velocity loops at once. Since they last ran, the velocity's error has changed by
// `drift`. Returns how the lift changes.
template <class S>
Triple<S> follow(const CascadeLoop& loop, Outer<S>& outer, const Triple<S>& drift,
                 const Vec3& asked) {
  const PidGains& k = loop.gains.velocity;
  const double period = kMillisecond * loop.periods.position;
  const double share = period / (period + kVelocityFilter);
  const Triple<S> steeper = (share / period) * drift - share * outer.slope;
  outer.missed = outer.missed + drift;
  outer.slope = outer.slope + steeper;
  const Vec3 forward = loop.gains.feed_forward.acceleration * (asked - outer.asked);
  outer.asked = asked;
  return triple(forward) + scaled(triple(k.p), drift) +
         scaled(triple(Vec3(period * k.i)), outer.missed) + scaled(triple(k.d), steeper);
}

template <class S>
PositionRun<S> run_of(const CascadeLoop& loop, const Outer<S>& outer, const Triple<S>& lift,
                      const Triple<S>& velocity) {
  PositionRun<S> run;
  run.velocity = outer.missed + velocity;
  run.lift = lift;
  run.acceleration = lift;
  run.acceleration.z = lift.z - kGravity;
  const Vec3 integrated = kMillisecond * loop.periods.position * loop.gains.velocity.i;
  run.before = run.acceleration - scaled(triple(integrated), outer.missed);
  return run;
}

// Brescianini, Hehn and D'Andrea 2013, section IV, for a body whose axes in the wanted frame are
// those of `is`: the wanted z axis lies at (x, y, z) in the body's frame, and x and y are those of
// the lag over the lift.
template <class S>
Triple<S> tilt_first(const Frame<S>& is, const Triple<S>& lag, const S& lift_size) {
  const S shrink = inverse(lift_size);
  const S x = shrink * dot(is.x, lag);
  const S y = shrink * dot(is.y, lag);
  const S half_tilt = sqrt(0.5 * (1.0 + is.z.z));  // its cosine
  // How the body's x axis points after the shortest turn that brings its z axis there.
  const S across = is.x.y - is.x.z * is.z.y * inverse(1.0 + is.z.z);
  const S half = (-0.5 * kYawWeight) * asin(across);
  const S c = cos(half);
  const S s = sin(half);
  const S grow = inverse(half_tilt);
  return {grow * (x * s - y * c), grow * (x * c + y * s), 2.0 * (half_tilt * s)};
}

// The rates that are wanted.
template <class S>
Triple<S> orient(const CascadeLoop& loop, const Wanted<S>& wanted, const Body<S>& body,
                 const Reference& reference) {
  const Frame<S> is = frame_of(body, wanted);
  const Triple<S> error = tilt_first(is, body.lag, wanted.frame.size);
  const double forward = loop.gains.feed_forward.body_rates;
  const Triple<S> rates = scaled(triple(loop.gains.attitude), error);
  if (forward == 0) return rates;
  return rates + forward * wanted_at(wanted.lift, reference).rates;
}

// The commands of this millisecond. The thrust that is missing changes with them.
template <class S>
Held<S> turn(const CascadeLoop& loop, const Wanted<S>& wanted, const Triple<S>& rates,
             Triple<S>& integral, Body<S>& body) {
  const PidGains& k = loop.gains.rates;
  const Triple<S> error = rates - body.rates;
  integral = integral + scaled(triple(Vec3(kMillisecond * k.i)), error);
  Held<S> held;
  held.thrust = wanted.frame.size;
  const S size = frame_of(body, wanted).size;
  const S shrink = inverse(wanted.frame.size + size);
  const S missing = wanted.frame.size - size;
  // The same, of which all is small with the lag.
  body.missing = body.lag.z - shrink * (dot(body.lag, body.lag) - body.lag.z * missing);
  held.spin = scaled(triple(k.p), error) + integral - scaled(triple(k.d), body.filtered) +
              gyroscopic(loop.model.inertia, body.rates);
  return held;
}

}  // namespace

template <class S>
CascadeStep<S> cascade_step(const CascadeLoop& loop, const CascadeState<S>& s,
                            const CascadeReferences& references) {
  const Gains& gains = loop.gains;
  const std::vector<Reference>& at = references.at;
  const int period = static_cast<int>(at.size()) - 1;
  Body<S> body;
  body.velocity = s.velocity;
  body.lag = s.lag;
  body.heading = s.heading;
  body.rates = s.rates;
  body.spin = s.spin;
  body.filtered = s.filtered;
  Outer<S> outer{s.missed, s.slope, references.last_asked};
  Triple<S> integral = s.integral;
  Triple<S> drift = s.drift;
  Triple<S> moved{};  // at the start of the drift
  Triple<S> velocity = s.velocity;
  int since = 0;
  const auto drifted = [&](int j) {
    const Vec3 led = gains.position.p.cwiseProduct(at[j].position - at[since].position) +
                     gains.feed_forward.velocity * (at[j].velocity - at[since].velocity);
    return drift + triple(led) - scaled(triple(gains.position.p), body.moved - moved) -
           (body.velocity - velocity);
  };
  Wanted<S> wanted = wanted_for(s.lift, at[0]);
  CascadeStep<S> step;
  for (int j = 0; j < period; ++j) {
    if ((references.step + j) % loop.periods.position == 0) {
      const Triple<S> change =
          follow(loop, outer, j > 0 ? drifted(j) : s.drift, at[j].acceleration);
      turn_to(wanted, change_of(wanted, change, at[0].yaw, at[0].yaw), body);
      wanted = wanted_for(wanted.lift + change, at[0]);
      step.runs.push_back(run_of(loop, outer, wanted.lift, body.velocity));
      step.runs.back().millisecond = j;
      drift = Triple<S>{};
      moved = body.moved;
      velocity = body.velocity;
      since = j;
    }
    if (j == 0) step.rates = orient(loop, wanted, body, at[0]);
    Held<S> held = turn(loop, wanted, step.rates, integral, body);
    name_errors(held.spin, CascadeRows::kStates + 3 * j);
    step.commands.push_back(motors(loop.model, held));
    held.wind = wind_in(s.wind, s.gust, loop.gusts, j);
    held.lightness = s.lightness;
    body = runge_kutta(loop.model, wanted, body, held);
    body.filtered =
        (1 - kFilterShare) * body.filtered + (kFilterShare / kMillisecond) * body.turned;
    body.turned = Triple<S>{};
    step.moved.push_back(body.moved);
    step.upright.push_back(in_world(wanted.frame, frame_of(body, wanted).z).z);
  }
  if (at[period].yaw != at[0].yaw) {
    turn_to(wanted, change_of(wanted, Triple<S>{}, at[0].yaw, at[period].yaw), body);
  }
  CascadeState<S>& out = step.state;
  out.lift = wanted.lift;
  out.velocity = body.velocity;
  out.lag = body.lag;
  out.heading = body.heading;
  out.rates = body.rates;
  out.spin = body.spin;
  out.filtered = body.filtered;
  out.integral = integral;
  out.missed = outer.missed;
  out.drift = drifted(period);
  out.slope = outer.slope;
  out.gust = gust_kept(loop.gusts.lag, period) * s.gust;
  out.wind = s.wind;
  out.lightness = s.lightness;
  return step;
}

using Model = CascadeRows::Model;

template CascadeStep<double> cascade_step(const CascadeLoop&, const CascadeState<double>&,
                                          const CascadeReferences&);
template CascadeStep<Model> cascade_step(const CascadeLoop&, const CascadeState<Model>&,
                                         const CascadeReferences&);

CascadeState<Model> cascade_at_rest(const Model& lightness) {
  CascadeState<Model> s;
  s.lift.z = kGravity;
  s.lag.z = kGravity - kGravity * inverse(lightness);
  s.lightness = lightness;
  return s;
}

}  // namespace traj
