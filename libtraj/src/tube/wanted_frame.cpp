#include "tube/wanted_frame.h"

namespace traj {

using std::cos;
using std::sin;
using std::sqrt;

namespace {

template <class S>
S norm(const Triple<S>& a) {
  return sqrt(dot(a, a));
}

// All but the size.
template <class S>
void turn_about_z(const S& heading, Frame<S>& f) {
  const S s = sin(heading);
  const S c = cos(heading);
  f.left = {-s, c, S(0.0)};
  f.ahead = {c, s, S(0.0)};
  f.across = {c * f.z.z, s * f.z.z, -(s * f.z.y) - c * f.z.x};
  f.across_size = norm(f.across);
  f.x = inverse(f.across_size) * f.across;
  f.y = cross(f.z, f.x);
}

}  // namespace

template <class S>
Frame<S> frame_along(const Triple<S>& force, const S& heading) {
  Frame<S> f;
  f.size = norm(force);
  f.z = inverse(f.size) * force;
  turn_about_z(heading, f);
  return f;
}

template <class S>
Frame<S> frame_along_unit(const Triple<S>& z, const S& heading) {
  Frame<S> f;
  f.size = 1.0;
  f.z = z;
  turn_about_z(heading, f);
  return f;
}

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

template <class S>
Triple<S> rates_along(const Frame<S>& f, const Reference& r) {
  const Triple<double> jerk = triple(r.jerk);
  const S shrink = inverse(f.size);
  const S along_y = shrink * dot(jerk, f.y);
  const S along_x = shrink * dot(jerk, f.x);
  // (left x jerk) . y; left and across are in the plane of y and z, and across is along x.
  const S about = r.yaw_rate * dot(f.ahead, f.x) + shrink * dot(cross(f.left, jerk), f.y);
  return {-along_y, along_x, inverse(f.across_size) * about};
}

// `left` is the heading's, which lies in the plane of y and z there.
template <class S>
FrameChange<S> change_of(const Wanted<S>& wanted, const Triple<S>& change, double yaw,
                         double next_yaw) {
  const Frame<S>& f = wanted.frame;
  FrameChange<S> d;
  d.lift = {dot(f.x, change), dot(f.y, change), dot(f.z, change)};
  const Triple<S>& e = d.lift;
  const S longer = 2.0 * f.size * e.z + dot(e, e);  // of the squares
  const S size = sqrt(f.size * f.size + longer);
  d.growth = longer * inverse(size + f.size);
  const S shrink = inverse(size);
  d.z = {shrink * e.x, shrink * e.y, shrink * (e.z - d.growth)};
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

template Frame<double> frame_along(const Triple<double>&, const double&);
template Frame<TaylorModel> frame_along(const Triple<TaylorModel>&, const TaylorModel&);
template Frame<CascadeModel> frame_along(const Triple<CascadeModel>&, const CascadeModel&);
template Frame<double> frame_along_unit(const Triple<double>&, const double&);
template Frame<CascadeModel> frame_along_unit(const Triple<CascadeModel>&, const CascadeModel&);
template Wanted<double> wanted_at(const Triple<double>&, const Reference&);
template Wanted<TaylorModel> wanted_at(const Triple<TaylorModel>&, const Reference&);
template Wanted<CascadeModel> wanted_at(const Triple<CascadeModel>&, const Reference&);
template Triple<double> rates_along(const Frame<double>&, const Reference&);
template Triple<CascadeModel> rates_along(const Frame<CascadeModel>&, const Reference&);
template FrameChange<double> change_of(const Wanted<double>&, const Triple<double>&, double,
                                       double);
template FrameChange<TaylorModel> change_of(const Wanted<TaylorModel>&, const Triple<TaylorModel>&,
                                            double, double);
template FrameChange<CascadeModel> change_of(const Wanted<CascadeModel>&,
                                             const Triple<CascadeModel>&, double, double);

}  // namespace traj
