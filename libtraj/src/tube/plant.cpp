#include "tube/plant.h"

#include "geom/vehicle/limits.h"

namespace traj {

using geom::kGravity;
using std::asin;
using std::sqrt;

namespace {

// Anything within a radius; for numbers its middle, 0.
template <class S>
S loose(double radius) {
  if constexpr (std::is_same_v<S, double>) {
    return 0;
  } else {
    return S::within(0, radius);
  }
}

template <class S>
Body<S> advanced(const Body<S>& b, const Body<S>& d, double h) {
  Body<S> out = b;
  out.moved = b.moved + h * d.moved;
  out.velocity = b.velocity + h * d.velocity;
  out.lag = b.lag + h * d.lag;
  out.missing = b.missing + h * d.missing;
  out.heading = b.heading + h * d.heading;
  out.rates = b.rates + h * d.rates;
  out.spin = b.spin + h * d.spin;
  out.turned = b.turned + h * d.turned;
  return out;
}

// `f`: the body's frame in the wanted one.
template <class S>
Triple<S> drag_force(const Vec3& drag, const Frame<S>& f, const Frame<S>& wanted,
                     const Triple<S>& air) {
  Triple<S> out = drag.x() * air;
  const auto along = [&](double more, const Triple<S>& axis) {
    if (more == 0) return;
    const Triple<S> there = in_world(wanted, axis);
    out = out + (more * dot(there, air)) * there;
  };
  along(drag.y() - drag.x(), f.y);
  along(drag.z() - drag.x(), f.z);
  return out;
}

template <class S>
Body<S> slope(const Quadrotor& q, const Wanted<S>& wanted, const Body<S>& b, const Held<S>& held) {
  const Frame<S> f = frame_of(b, wanted);
  const double lag = 1 / q.motor_time_constant;
  Body<S> d;
  d.moved = b.velocity;
  const Triple<S> drag = drag_force(q.drag, f, wanted.frame, b.velocity - held.wind);
  d.velocity = held.lightness * (wanted.lift - in_world(wanted.frame, b.lag) - (1 / q.mass) * drag);
  d.velocity.z = d.velocity.z - kGravity;
  const Triple<S> z = b.rates.y * f.x - b.rates.x * f.y;  // how the z axis turns
  d.lag = Triple<S>{} - (lag * b.missing) * f.z - f.size * z;
  d.missing = -lag * b.missing;
  const Triple<S> across = cross(f.left, z);
  d.heading =
      (b.rates.z * f.across_size - dot(across, f.y)) * inverse(-dot(cross(f.ahead, f.z), f.y));
  d.rates = b.spin - gyroscopic(q.inertia, b.rates);
  d.turned = d.rates;
  d.spin = lag * (held.spin - b.spin);
  return d;
}

}  // namespace

template <class S>
Body<S> runge_kutta(const Quadrotor& q, const Wanted<S>& wanted, const Body<S>& b,
                    const Held<S>& held) {
  const double h = kMillisecond;
  const Body<S> k1 = slope(q, wanted, b, held);
  const Body<S> k2 = slope(q, wanted, advanced(b, k1, h / 2), held);
  const Body<S> k3 = slope(q, wanted, advanced(b, k2, h / 2), held);
  const Body<S> k4 = slope(q, wanted, advanced(b, k3, h), held);
  Body<S> sum = advanced(k1, k2, 2);
  sum = advanced(sum, k3, 2);
  sum = advanced(sum, k4, 1);
  return advanced(b, sum, h / 6);
}

template <class S>
std::array<S, 4> motors(const Quadrotor& q, const Held<S>& held) {
  const Triple<S> torque = scaled(triple(q.inertia), held.spin);
  const S x = (1 / (4 * q.arm.y())) * torque.x;
  const S y = (1 / (4 * q.arm.x())) * torque.y;
  const S z = (1 / (4 * q.torque_per_thrust)) * torque.z;
  const S mean = (q.mass / 4) * held.thrust;
  return {mean - x - y - z, mean + x + y - z, mean + x - y + z, mean - x + y + z};
}

double gust_kept(double gust_lag, int milliseconds) {
  return std::exp(-kMillisecond * milliseconds / gust_lag);
}

template <class S>
Triple<S> wind_in(const Triple<S>& wind, const Triple<S>& gust, const LaggedGusts& gusts, int j) {
  const double kept = gust_kept(gusts.lag, j);
  const S more = loose<S>((1 - kept) * gusts.most);
  return wind + kept * gust + Triple<S>{more, more, more};
}

template <class S>
void turn_to(const Wanted<S>& wanted, const FrameChange<S>& d, Body<S>& body) {
  const Triple<S> x = frame_of(body, wanted).x;
  const S dx = dot(d.x, x);
  const S dy = dot(d.y, x);
  const S before = sqrt(x.x * x.x + x.y * x.y);
  const S next_x = x.x + dx;
  const S next_y = x.y + dy;
  const S after = sqrt(next_x * next_x + next_y * next_y);
  body.heading = body.heading + asin((x.x * dy - x.y * dx) * inverse(before * after));
  const Triple<S> lag = body.lag + d.lift;
  body.lag = lag + Triple<S>{dot(d.x, lag), dot(d.y, lag), dot(d.z, lag)};
}

template Body<double> runge_kutta(const Quadrotor&, const Wanted<double>&, const Body<double>&,
                                  const Held<double>&);
template Body<TaylorModel> runge_kutta(const Quadrotor&, const Wanted<TaylorModel>&,
                                       const Body<TaylorModel>&, const Held<TaylorModel>&);
template Body<TaylorModelOf<50>> runge_kutta(const Quadrotor&, const Wanted<TaylorModelOf<50>>&,
                                             const Body<TaylorModelOf<50>>&,
                                             const Held<TaylorModelOf<50>>&);
template std::array<double, 4> motors(const Quadrotor&, const Held<double>&);
template std::array<TaylorModel, 4> motors(const Quadrotor&, const Held<TaylorModel>&);
template std::array<TaylorModelOf<50>, 4> motors(const Quadrotor&, const Held<TaylorModelOf<50>>&);
template Triple<double> wind_in(const Triple<double>&, const Triple<double>&, const LaggedGusts&,
                                int);
template Triple<TaylorModel> wind_in(const Triple<TaylorModel>&, const Triple<TaylorModel>&,
                                     const LaggedGusts&, int);
template Triple<TaylorModelOf<50>> wind_in(const Triple<TaylorModelOf<50>>&,
                                           const Triple<TaylorModelOf<50>>&, const LaggedGusts&,
                                           int);
template void turn_to(const Wanted<double>&, const FrameChange<double>&, Body<double>&);
template void turn_to(const Wanted<TaylorModel>&, const FrameChange<TaylorModel>&,
                      Body<TaylorModel>&);
template void turn_to(const Wanted<TaylorModelOf<50>>&, const FrameChange<TaylorModelOf<50>>&,
                      Body<TaylorModelOf<50>>&);

}  // namespace traj
