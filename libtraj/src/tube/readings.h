#pragma once

// The noise of what the controller reads.

#include <algorithm>
#include <array>

#include "traj/tube/prove_tube.h"
#include "tube/wanted_frame.h"

namespace traj {

inline constexpr int kLongestPeriod = 4;  // ms, of the attitude loop

// Of one period: what is read minus what is true.
template <class S>
struct Readings {
  bool exact = true;   // all is 0
  Triple<S> place;     // m, when the position loop runs
  Triple<S> velocity;  // m/s, then
  // rad, in each millisecond, about the body's axes: twice the vector part over the scalar part of
  // the quaternion that turns the true attitude into the measured one.
  std::array<Triple<S>, kLongestPeriod> turn;
  std::array<Triple<S>, kLongestPeriod> rates;  // rad/s, in each millisecond
};

// Any readings that the noise allows.
template <class S>
Readings<S> readings_within(const Disturbances& d) {
  const auto any = [](double most) {
    const S model = S::within(0, most);
    return Triple<S>{model, model, model};
  };
  Readings<S> out{!d.has_noise(), any(d.place_noise), any(d.velocity_noise), {}, {}};
  out.turn.fill(any(d.attitude_noise));
  out.rates.fill(any(d.rate_noise));
  return out;
}

// The axes x, y and z of a frame as they are read, minus the true ones; the other members stay 0.
// In the true frame, axis e is off by 2 (h x e + h x (h x e)) / (1 + h . h), where h is half the
// turn (Rodrigues).
template <class S>
Frame<S> misread(const Frame<S>& is, const Triple<S>& turn) {
  const Triple<S> h = 0.5 * turn;
  const S square = dot(h, h);
  const S grow = 2.0 * inverse(1.0 + square);
  const Triple<S> along = h.x * is.x + h.y * is.y + h.z * is.z;
  Frame<S> off{};
  off.x = grow * (h.z * is.y - h.y * is.z + h.x * along - square * is.x);
  off.y = grow * (h.x * is.z - h.z * is.x + h.y * along - square * is.y);
  off.z = grow * (h.y * is.x - h.x * is.y + h.z * along - square * is.z);
  return off;
}

// Noise that took `gain` times itself off an angular acceleration, whose error is symbol k and the
// next two by now (name_errors()). Models of the noise then have these symbols, so that what
// follows from both is known to have one cause. Numbers stay as they are.
inline Triple<double> retold(const Triple<double>& noise, const Triple<double>&, const geom::Vec3&,
                             int) {
  return noise;
}
template <int N>
Triple<TaylorModelOf<N>> retold(const Triple<TaylorModelOf<N>>& noise,
                                const Triple<TaylorModelOf<N>>& asked, const geom::Vec3& gain,
                                int k) {
  using Model = TaylorModelOf<N>;
  const auto one = [](const Model& of, const Model& error, double by, int symbol) {
    // error = rest - by * noise, where each is at most its size.
    const double all = error.l[symbol];
    const double rest = std::max(0.0, all - by * of.r) + 1e-12 * all;
    if (!(rest < 0.25 * by * of.r)) return of;
    Model out = Model::symbol(0, symbol, -all / by);
    out.r = rest / by * (1 + 1e-12);
    return out;
  };
  return {one(noise.x, asked.x, gain.x(), k), one(noise.y, asked.y, gain.y(), k + 1),
          one(noise.z, asked.z, gain.z(), k + 2)};
}

}  // namespace traj
