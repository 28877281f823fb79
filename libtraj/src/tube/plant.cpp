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

// What both kinds of body have.
template <class B>
void advance_motion(const B& d, double h, B& out) {
  out.moved = out.moved + h * d.moved;
  out.velocity = out.velocity + h * d.velocity;
  out.missing = out.missing + h * d.missing;
  out.heading = out.heading + h * d.heading;
  out.rates = out.rates + h * d.rates;
  out.spin = out.spin + h * d.spin;
  out.turned = out.turned + h * d.turned;
}

template <class S>
Body<S> advanced(const Body<S>& b, const Body<S>& d, double h) {
  Body<S> out = b;
  advance_motion(d, h, out);
  out.lag = b.lag + h * d.lag;
  return out;
}

template <class S>
TiltedBody<S> advanced(const TiltedBody<S>& b, const TiltedBody<S>& d, double h) {
  TiltedBody<S> out = b;
  advance_motion(d, h, out);
  out.tilt_x = b.tilt_x + h * d.tilt_x;
  out.tilt_y = b.tilt_y + h * d.tilt_y;
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

// J^-1 (w x J w) of the true inertia J.
template <class S>
Triple<S> turning(const Vec3& believed, const Triple<S>& agility, const Triple<S>& w) {
  const Triple<S> momentum = {believed.x() * (w.x * inverse(agility.x)),
                              believed.y() * (w.y * inverse(agility.y)),
                              believed.z() * (w.z * inverse(agility.z))};
  return scaled(agility, scaled(triple(believed.cwiseInverse()), cross(w, momentum)));
}

// What does not depend on how the thrust is written, but for its lag behind the lift.
template <class B, class S>
B motion_slope(const Quadrotor& q, const Wanted<S>& wanted, const Frame<S>& f, const B& b,
               const Triple<S>& thrust_lag, const Held<S>& held) {
  const S lag = (1 / q.motor_time_constant) * held.quickness;
  B d;
  d.moved = b.velocity;
  const Triple<S> drag = drag_force(q.drag, f, wanted.frame, b.velocity - held.wind);
  d.velocity = held.lightness * (wanted.lift - in_world(wanted.frame, thrust_lag) -
                                 ((1 / q.mass) * held.drag) * drag);
  d.velocity.z = d.velocity.z - kGravity;
  d.missing = -(lag * b.missing);
  d.rates = scaled(held.agility, b.spin) - turning(q.inertia, held.agility, b.rates);
  d.turned = d.rates;
  d.spin = lag * (held.spin - b.spin);
  return d;
}

// How the body's z axis turns.
template <class B, class S>
Triple<S> axis_slope(const Frame<S>& f, const B& b) {
  return b.rates.y * f.x - b.rates.x * f.y;
}

template <class B, class S>
S heading_slope(const Frame<S>& f, const B& b, const Triple<S>& axis_slope) {
  const Triple<S> across = cross(f.left, axis_slope);
  return (b.rates.z * f.across_size - dot(across, f.y)) * inverse(-dot(cross(f.ahead, f.z), f.y));
}

template <class S>
Body<S> slope(const Quadrotor& q, const Wanted<S>& wanted, const Body<S>& b, const Held<S>& held) {
  const Frame<S> f = frame_of(b, wanted);
  Body<S> d = motion_slope(q, wanted, f, b, b.lag, held);
  const Triple<S> z = axis_slope(f, b);
  d.lag = d.missing * f.z - f.size * z;
  d.heading = heading_slope(f, b, z);
  return d;
}

template <class S>
TiltedBody<S> slope(const Quadrotor& q, const Wanted<S>& wanted, const TiltedBody<S>& b,
                    const Held<S>& held) {
  const Frame<S> f = frame_of(b, wanted);
  const S thrust = wanted.frame.size - b.missing;
  const S sunk = (b.tilt_x * b.tilt_x + b.tilt_y * b.tilt_y) * inverse(1.0 + f.z.z);  // 1 - f.z.z
  const Triple<S> lag = {-(thrust * b.tilt_x), -(thrust * b.tilt_y), b.missing + thrust * sunk};
  TiltedBody<S> d = motion_slope(q, wanted, f, b, lag, held);
  if (held.beyond) {
    d.missing = d.missing - (1 / q.motor_time_constant) * (held.quickness * *held.beyond);
  }
  const Triple<S> z = axis_slope(f, b);
  d.tilt_x = z.x;
  d.tilt_y = z.y;
  d.heading = heading_slope(f, b, z);
  return d;
}

}  // namespace

template <class B, class S>
B runge_kutta(const Quadrotor& q, const Wanted<S>& wanted, const B& b, const Held<S>& held) {
  const double h = kMillisecond;
  const B k1 = slope(q, wanted, b, held);
  const B k2 = slope(q, wanted, advanced(b, k1, h / 2), held);
  const B k3 = slope(q, wanted, advanced(b, k2, h / 2), held);
  const B k4 = slope(q, wanted, advanced(b, k3, h), held);
  B sum = advanced(k1, k2, 2);
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

namespace {

// The heading as the next wanted frame sees it; `x` is the body's x axis. Infinite where that may
// turn by a right angle or more.
template <class S>
S turned_heading(const S& heading, const Triple<S>& x, const FrameChange<S>& d) {
  const S dx = dot(d.x, x);
  const S dy = dot(d.y, x);
  const S before = sqrt(x.x * x.x + x.y * x.y);
  const S next_x = x.x + dx;
  const S next_y = x.y + dy;
  const S after = sqrt(next_x * next_x + next_y * next_y);
  if (!(least(x.x * next_x + x.y * next_y) > 0)) return std::numeric_limits<double>::infinity();
  return heading + asin((x.x * dy - x.y * dx) * inverse(before * after));
}

}  // namespace

template <class S>
void turn_to(const Wanted<S>& wanted, const FrameChange<S>& d, Body<S>& body) {
  body.heading = turned_heading(body.heading, frame_of(body, wanted).x, d);
  const Triple<S> lag = body.lag + d.lift;
  body.lag = lag + Triple<S>{dot(d.x, lag), dot(d.y, lag), dot(d.z, lag)};
}

template <class S>
void turn_to(const Wanted<S>& wanted, const FrameChange<S>& d, TiltedBody<S>& body) {
  const Frame<S> f = frame_of(body, wanted);
  body.heading = turned_heading(body.heading, f.x, d);
  body.tilt_x = body.tilt_x + dot(d.x, f.z);
  body.tilt_y = body.tilt_y + dot(d.y, f.z);
  body.missing = body.missing + d.growth;
}

template Body<double> runge_kutta(const Quadrotor&, const Wanted<double>&, const Body<double>&,
                                  const Held<double>&);
template Body<TaylorModel> runge_kutta(const Quadrotor&, const Wanted<TaylorModel>&,
                                       const Body<TaylorModel>&, const Held<TaylorModel>&);
template TiltedBody<double> runge_kutta(const Quadrotor&, const Wanted<double>&,
                                        const TiltedBody<double>&, const Held<double>&);
template TiltedBody<CascadeModel> runge_kutta(const Quadrotor&, const Wanted<CascadeModel>&,
                                              const TiltedBody<CascadeModel>&,
                                              const Held<CascadeModel>&);
template std::array<double, 4> motors(const Quadrotor&, const Held<double>&);
template std::array<TaylorModel, 4> motors(const Quadrotor&, const Held<TaylorModel>&);
template std::array<CascadeModel, 4> motors(const Quadrotor&, const Held<CascadeModel>&);
template Triple<double> wind_in(const Triple<double>&, const Triple<double>&, const LaggedGusts&,
                                int);
template Triple<TaylorModel> wind_in(const Triple<TaylorModel>&, const Triple<TaylorModel>&,
                                     const LaggedGusts&, int);
template Triple<CascadeModel> wind_in(const Triple<CascadeModel>&, const Triple<CascadeModel>&,
                                      const LaggedGusts&, int);
template void turn_to(const Wanted<double>&, const FrameChange<double>&, Body<double>&);
template void turn_to(const Wanted<TaylorModel>&, const FrameChange<TaylorModel>&,
                      Body<TaylorModel>&);
template void turn_to(const Wanted<double>&, const FrameChange<double>&, TiltedBody<double>&);
template void turn_to(const Wanted<CascadeModel>&, const FrameChange<CascadeModel>&,
                      TiltedBody<CascadeModel>&);

}  // namespace traj
