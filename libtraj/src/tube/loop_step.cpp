#include "tube/loop_step.h"

#include "geom/vehicle/limits.h"

namespace traj {
namespace {

using geom::kGravity;
using std::asin;
using std::cos;
using std::sin;
using std::sqrt;

constexpr double kMillisecond = 1e-3;
constexpr double kRateFilter = 1 / (2 * 3.141592653589793 * 30);  // s, as the controller's
constexpr double kFilterShare = kMillisecond / (kMillisecond + kRateFilter);

template <class S>
S norm(const Triple<S>& a) {
  return sqrt(dot(a, a));
}

// A frame whose z axis is along a force and whose x axis has a heading.
template <class S>
struct Frame {
  S size{};  // of the force
  Triple<S> x, y, z;
  Triple<S> left, ahead;  // of the heading, horizontal
  Triple<S> across;       // left x z
  S across_size{};
};

template <class S>
Frame<S> frame_along(const Triple<S>& force, const S& heading) {
  Frame<S> f;
  f.size = norm(force);
  f.z = inverse(f.size) * force;
  const S s = sin(heading);
  const S c = cos(heading);
  f.left = {-s, c, S(0.0)};
  f.ahead = {c, s, S(0.0)};
  f.across = {c * f.z.z, s * f.z.z, -(s * f.z.y) - c * f.z.x};
  f.across_size = norm(f.across);
  f.x = inverse(f.across_size) * f.across;
  f.y = cross(f.z, f.x);
  return f;
}

template <class S>
Triple<S> in_world(const Frame<S>& f, const Triple<S>& v) {
  return v.x * f.x + v.y * f.y + v.z * f.z;
}

// The lift, its frame, and the body rates that flatness gives for it.
template <class S>
struct Wanted {
  Triple<S> lift;
  Frame<S> frame;
  Triple<S> rates;
};

template <class S>
Wanted<S> wanted_at(const Triple<S>& lift, const Reference& r) {
  Wanted<S> w{lift, frame_along(lift, S(r.yaw)), {}};
  const Frame<S>& f = w.frame;
  const Triple<double> jerk = triple(r.jerk);
  const Triple<S> dz = inverse(f.size) * (jerk - dot(f.z, jerk) * f.z);
  const Triple<S> across = (-r.yaw_rate) * cross(f.ahead, f.z) + cross(f.left, dz);
  w.rates = {-dot(dz, f.y), dot(dz, f.x), dot(across, f.y) * inverse(f.across_size)};
  return w;
}

// What moves, between two steps of a millisecond. Lag and heading are those of the wanted frame.
template <class S>
struct Body {
  Triple<S> moved;  // m since the start of the period
  Triple<S> velocity, lag;
  S missing{};  // m/s2: what the motors' thrust lacks of what they are told
  S heading{};
  Triple<S> rates, spin;
  Triple<S> turned;    // rad/s since the controller last ran
  Triple<S> filtered;  // rad/s2: what it makes of that
};

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

// The body's frame, seen from the wanted one, in which the lift is (0, 0, its size).
template <class S>
Frame<S> frame_of(const Body<S>& body, const Wanted<S>& wanted) {
  return frame_along<S>({-body.lag.x, -body.lag.y, wanted.frame.size - body.lag.z}, body.heading);
}

// What holds during a millisecond.
template <class S>
struct Held {
  S thrust{};      // m/s2 that is asked for
  Triple<S> spin;  // rad/s2 that are asked for
  Triple<S> wind;
  S lightness{};
};

template <class S>
Triple<S> gyroscopic(const Vec3& inertia, const Triple<S>& w) {  // J^-1 (w x J w)
  const Triple<S> product = cross(w, scaled(triple(inertia), w));
  return scaled(triple(inertia.cwiseInverse()), product);
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

template <class S>
std::array<S, 4> motors(const Quadrotor& q, const Held<S>& held) {
  const Triple<S> torque = scaled(triple(q.inertia), held.spin);
  const S x = (1 / (4 * q.arm.y())) * torque.x;
  const S y = (1 / (4 * q.arm.x())) * torque.y;
  const S z = (1 / (4 * q.torque_per_thrust)) * torque.z;
  const S mean = (q.mass / 4) * held.thrust;
  return {mean - x - y - z, mean + x + y - z, mean + x - y + z, mean - x + y + z};
}

// Makes remainders symbols, k and the next two, so that what follows from them is known to be
// linear.
void name_errors(Triple<double>&, int) {}
void name_errors(Triple<TaylorModel>& t, int k) {
  t = {t.x.named(k), t.y.named(k + 1), t.z.named(k + 2)};
}

// Anything within a radius; for numbers its middle, 0.
template <class S>
S loose(double radius);
template <>
double loose<double>(double) {
  return 0;
}
template <>
TaylorModel loose<TaylorModel>(double radius) {
  return TaylorModel::within(0, radius);
}

// The axes of the wanted frame of lift + change, seen from the wanted frame of lift, minus (1, 0,
// 0), (0, 1, 0) and (0, 0, 1).
template <class S>
struct FrameChange {
  Triple<S> x, y, z;
  Triple<S> lift;  // the change of the lift, seen from there
};

// All terms are small with `change`. `left` is the heading's, which lies in the plane of y and z
// there.
template <class S>
FrameChange<S> change_of(const Wanted<S>& wanted, const Triple<S>& change, double yaw,
                         double next_yaw) {
  const Frame<S>& f = wanted.frame;
  FrameChange<S> d;
  d.lift = {dot(f.x, change), dot(f.y, change), dot(f.z, change)};
  const Triple<S>& e = d.lift;
  const S longer = 2.0 * f.size * e.z + dot(e, e);  // of the squares
  const S size = sqrt(f.size * f.size + longer);
  const S growth = longer * inverse(size + f.size);
  const S shrink = inverse(size);
  d.z = {shrink * e.x, shrink * e.y, shrink * (e.z - growth)};
  const double half = 2 * std::sin((next_yaw - yaw) / 2);
  const double mean = (next_yaw + yaw) / 2;
  const Triple<double> turn = {-half * std::cos(mean), -half * std::sin(mean), 0};
  const Triple<S> left = {S(0.0), f.across_size, dot(f.left, f.z)};
  const Triple<S> more = {dot(f.x, turn), dot(f.y, turn), dot(f.z, turn)};
  const Triple<S> z = {d.z.x, d.z.y, 1.0 + d.z.z};
  Triple<S> across = cross(left, d.z) + cross(more, z);  // minus left x (0, 0, 1)
  const S wider = 2.0 * f.across_size * across.x + dot(across, across);
  const S across_size = sqrt(f.across_size * f.across_size + wider);
  across.x = across.x - wider * inverse(across_size + f.across_size);
  d.x = inverse(across_size) * across;
  const Triple<S> along_z = {S(0.0), S(0.0), S(1.0)};
  const Triple<S> along_x = {S(1.0), S(0.0), S(0.0)};
  d.y = cross(along_z, d.x) + cross(d.z, along_x) + cross(d.z, d.x);
  return d;
}

// Lag and heading as the next wanted frame sees them.
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

}  // namespace

double gust_kept(const Loop& loop, int milliseconds) {
  return std::exp(-kMillisecond * milliseconds / loop.gust_lag);
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
    const double kept = gust_kept(loop, j);
    const S more = loose<S>((1 - kept) * loop.gust_most);
    held.wind = s.wind + kept * s.gust + Triple<S>{more, more, more};
    held.lightness = s.lightness;
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
  out.lightness = s.lightness;
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
  return s;
}

}  // namespace traj
