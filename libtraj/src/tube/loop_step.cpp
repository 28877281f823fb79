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
// stay at right angles turns this into products of the lag and terms of the second order.
template <class S>
Triple<S> attitude_error(const Frame<S>& is, const Triple<S>& lag, const S& lift_size) {
  const Triple<S> dz = {-is.z.x, -is.z.y, 1.0 - is.z.z};
  const Triple<S> dx = {1.0 - is.x.x, -is.x.y, -is.x.z};
  const S shrink = inverse(lift_size);
  const Triple<S> second = cross(dz, dx);
  return {shrink * dot(is.y, lag) - 0.5 * dot(is.z, second),
          -(shrink * dot(is.x, lag)) - 0.5 * dot(dz, dx), -is.y.x + 0.5 * dot(is.x, second)};
}

// The commands of this millisecond. The thrust that is missing changes with them.
template <class S>
Held<S> commanded(const Loop& loop, const Wanted<S>& wanted, Body<S>& body) {
  const GeometricGains& k = loop.gains;
  const Frame<S> is = frame_of(body, wanted);
  const Triple<S> error = attitude_error(is, body.lag, wanted.frame.size);
  const Triple<S>& wr = wanted.rates;
  const Triple<S> towards = {dot(is.x, wr), dot(is.y, wr), dot(is.z, wr)};
  const Triple<S>& w = body.rates;
  body.filtered = (1 - kFilterShare) * body.filtered + (kFilterShare / kMillisecond) * body.turned;
  body.turned = Triple<S>{};
  Held<S> held;
  held.thrust = wanted.frame.size * is.z.z;
  body.missing = dot(body.lag, is.z);
  held.spin = Triple<S>{} - scaled(triple(k.attitude), error) -
              scaled(triple(k.rates), w - towards) - scaled(triple(k.lead), body.filtered) +
              gyroscopic(loop.model.inertia, w) - cross(w, towards);
  return held;
}

}  // namespace

double gust_kept(const Loop& loop, int milliseconds) {
  return gust_kept(loop.gust_lag, milliseconds);
}

template <class S>
LoopStep<S> loop_step(const Loop& loop, const LoopState<S>& s, const LoopReferences& references) {
  const Wanted<S> wanted = wanted_at(s.lift, references.now);
  Body<S> body;
  body.velocity = s.velocity;
  body.lag = s.lag;
  body.heading = s.heading;
  body.rates = s.rates;
  body.spin = s.spin;
  body.turned = s.turned;
  body.filtered = s.filtered;
  LoopStep<S> step;
  for (int j = 0; j < loop.period; ++j) {
    Held<S> held = commanded(loop, wanted, body);
    name_errors(held.spin, kLoopStates + 3 * j);
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
  turn_to(wanted, change_of(wanted, change, now.yaw, next.yaw), body);
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

template LoopStep<double> loop_step(const Loop&, const LoopState<double>&, const LoopReferences&);
template LoopStep<TaylorModel> loop_step(const Loop&, const LoopState<TaylorModel>&,
                                         const LoopReferences&);

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
