#include "tube/loop_step.h"

#include "geom/vehicle/limits.h"
#include "tube/plant.h"

namespace traj {
namespace {

using geom::kGravity;

constexpr double kRateFilter = 1 / (2 * 3.141592653589793 * 30);  // s, as the controller's
constexpr double kFilterShare = kMillisecond / (kMillisecond + kRateFilter);

// Lee 2010, eq. 10, for a body whose axes in the wanted frame are those of `is`. With d = wanted -
// is for each axis it is half of (y . dz - z . dy, z . dx - x . dz, x . dy - y . dx); that axes
// stay at right angles turns this into the heights of x and y, which are known well, and terms of
// the second order.
template <class S>
Triple<S> attitude_error(const Frame<S>& is, const S& height_of_x, const S& height_of_y) {
  const Triple<S> dz = {-is.z.x, -is.z.y, 1.0 - is.z.z};
  const Triple<S> dx = {1.0 - is.x.x, -is.x.y, -is.x.z};
  const Triple<S> second = cross(dz, dx);
  return {height_of_y - 0.5 * dot(is.z, second), -height_of_x - 0.5 * dot(dz, dx),
          -is.y.x + 0.5 * dot(is.x, second)};
}

// The commands of this millisecond. The thrust that is missing changes with them.
template <class S>
Held<S> commanded(const Loop& loop, const Wanted<S>& wanted, const Readings<S>& readings,
                  const GainErrors<S>& off_by, int j, Body<S>& body) {
  const GeometricGains& k = loop.gains;
  const Frame<S> is = frame_of(body, wanted);
  const S shrink = inverse(wanted.frame.size);
  S height_of_x = shrink * dot(is.x, body.lag);
  S height_of_y = shrink * dot(is.y, body.lag);
  body.filtered = (1 - kFilterShare) * body.filtered + (kFilterShare / kMillisecond) * body.turned;
  body.turned = Triple<S>{};
  body.missing = dot(body.lag, is.z);
  Frame<S> seen = is;
  Triple<S> w = body.rates;
  Triple<S> filtered = body.filtered;
  if (!readings.exact) {
    const Frame<S> off = misread(is, readings.turn[j]);
    seen.x = is.x + off.x, seen.y = is.y + off.y, seen.z = is.z + off.z;
    height_of_x = height_of_x + off.x.z;
    height_of_y = height_of_y + off.y.z;
    body.missing = body.missing + wanted.frame.size * off.z.z;
    w = w + readings.rates[j];
    filtered = filtered + (kFilterShare / kMillisecond) * readings.rates[j];
  }
  const Triple<S> error = attitude_error(seen, height_of_x, height_of_y);
  const Triple<S>& wr = wanted.rates;
  const Triple<S> towards = {dot(seen.x, wr), dot(seen.y, wr), dot(seen.z, wr)};
  Held<S> held;
  held.thrust = wanted.frame.size * seen.z.z;
  held.spin = Triple<S>{} - by_gain(k.attitude, off_by, off_by.attitude, error) -
              by_gain(k.rates, off_by, off_by.rates, w - towards) -
              by_gain(k.lead, off_by, off_by.rates_d, filtered) +
              gyroscopic(loop.model.inertia, w) - cross(w, towards);
  return held;
}

// The next reading takes a share of this reading's noise out of the low pass again. It is taken out
// here already. `asked`: the angular acceleration that was asked for.
template <class S>
void take_back(const GeometricGains& k, const Triple<S>& misread, const Triple<S>& asked, int j,
               Body<S>& body) {
  constexpr double kKept = kFilterShare * kFilterShare / (1 - kFilterShare);
  const Vec3 gain = k.rates + (kFilterShare / kMillisecond) * k.lead;
  const Triple<S> rates = retold(misread, asked, gain, kLoopStates + 3 * j);
  body.filtered = body.filtered - (kKept / kMillisecond) * rates;
}

// How much more lift the controller asks for than with exact readings and gains.
template <class S>
Triple<S> more_lift(const GeometricGains& k, const LoopState<S>& s, const Reference& reference,
                    const Readings<S>& readings, const GainErrors<S>& gains) {
  const Triple<S> misplaced = scaled(triple(k.position), readings.place);
  const Triple<S> mistimed = scaled(triple(k.velocity), readings.velocity);
  Triple<S> out = Triple<S>{} - misplaced - mistimed;
  if (!gains.none) {
    // lift = kp (p_r - p) + kv (v_r - v) + a_r + g
    const Triple<S> damped = scaled(triple(k.velocity), triple(reference.velocity) - s.velocity);
    const Vec3 forward = reference.acceleration + kGravity * Vec3::UnitZ();
    const Triple<S> pulled = s.lift - triple(forward) - damped;
    out = out + scaled(gains.position, pulled - misplaced) +
          scaled(gains.velocity, damped - mistimed);
  }
  name_errors(out, kLoopStates + 3 * kLongestPeriod);
  return out;
}

}  // namespace

double gust_kept(const Loop& loop, int milliseconds) {
  return gust_kept(loop.gust_lag, milliseconds);
}

template <class S>
LoopStep<S> loop_step(const Loop& loop, const LoopState<S>& s, const LoopReferences& references,
                      const Readings<S>& readings, const GainErrors<S>& gains) {
  Wanted<S> wanted = wanted_at(s.lift, references.now);
  Body<S> body;
  body.velocity = s.velocity;
  body.lag = s.lag;
  body.heading = s.heading;
  body.rates = s.rates;
  body.spin = s.spin;
  body.turned = s.turned;
  body.filtered = s.filtered;
  LoopStep<S> step;
  const bool exact = readings.exact && gains.none;
  Triple<S> more;  // than with exact readings and gains
  if (!exact) {
    more = more_lift(loop.gains, s, references.now, readings, gains);
    const double yaw = references.now.yaw;
    turn_to(wanted, change_of(wanted, more, yaw, yaw), body);
    wanted = wanted_at(s.lift + more, references.now);
  }
  for (int j = 0; j < loop.period; ++j) {
    Held<S> held = commanded(loop, wanted, readings, gains, j, body);
    name_errors(held.spin, kLoopStates + 3 * j);
    if (!readings.exact) take_back(loop.gains, readings.rates[j], held.spin, j, body);
    step.commands.push_back(motors(loop.model, held));
    held.wind = wind_in(s.wind, s.gust, {loop.gust_lag, loop.gust_most}, j);
    held.set_factors(s);
    body = runge_kutta(loop.model, wanted, body, held);
    step.moved.push_back(body.moved);
    step.upright.push_back(in_world(wanted.frame, frame_of(body, wanted).z).z);
  }
  // lift' - lift = kp (p_r' - p_r - moved) + kv (v_r' - v_r - (v' - v)) + a_r' - a_r
  const GeometricGains& k = loop.gains;
  const Reference& now = references.now;
  const Reference& next = references.next;
  const Vec3 feed = k.position.cwiseProduct(next.position - now.position) +
                    k.velocity.cwiseProduct(next.velocity - now.velocity) + next.acceleration -
                    now.acceleration;
  const Triple<S> change = triple(feed) - scaled(triple(k.position), body.moved) -
                           scaled(triple(k.velocity), body.velocity - s.velocity);
  const Triple<S> turned = exact ? change : change - more;
  turn_to(wanted, change_of(wanted, turned, now.yaw, next.yaw), body);
  LoopState<S>& out = step.state;
  out.lift = s.lift + change;
  out.velocity = body.velocity;
  out.lag = body.lag;
  out.heading = body.heading;
  out.rates = body.rates;
  out.spin = body.spin;
  out.filtered = body.filtered;
  out.turned = body.turned;
  out.gust = gust_kept(loop, loop.period) * s.gust;
  out.wind = s.wind;
  out.set_factors(s);
  return step;
}

template LoopStep<double> loop_step(const Loop&, const LoopState<double>&, const LoopReferences&,
                                    const Readings<double>&, const GainErrors<double>&);
template LoopStep<TaylorModel> loop_step(const Loop&, const LoopState<TaylorModel>&,
                                         const LoopReferences&, const Readings<TaylorModel>&,
                                         const GainErrors<TaylorModel>&);

LoopState<TaylorModel> resting(const TaylorModel& lightness) {
  LoopState<TaylorModel> s;
  s.lift.z = kGravity;
  s.lag.z = kGravity - kGravity * inverse(lightness);
  s.lightness = lightness;
  s.drag = s.quickness = 1.0;
  s.agility = {1.0, 1.0, 1.0};
  return s;
}

LoopState<TaylorModel> starting(const Loop& loop, const TaylorModel& lightness,
                                const Reference& first, const Off<TaylorModel>& off) {
  using S = TaylorModel;
  LoopState<S> s = resting(lightness);
  const Wanted<S> wanted = wanted_at(s.lift, first);
  const GeometricGains& k = loop.gains;
  const Triple<S> change = Triple<S>{} - scaled(triple(k.position), off.place) -
                           scaled(triple(k.velocity), off.velocity);
  Body<S> body;
  body.lag = s.lag;
  turn_to(wanted, change_of(wanted, change, first.yaw, first.yaw), body);
  s.lift = s.lift + change;
  s.velocity = off.velocity;
  s.lag = body.lag;
  s.heading = body.heading;
  return s;
}

}  // namespace traj
