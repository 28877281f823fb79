#pragma once

// How far what the controller reads is from what is true.

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

// The axes of a frame that is read wrong, minus those of the true one: all but x, y and z is left
// at 0. With h half the turn and s = 1 / (1 + h . h), axis k is off by 2 s (h x e + h x (h x e)),
// where e is 1 along k, in the axes of the frame.
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

// The misread rates once more, where they made an error by this gain that is symbol k and the next
// two by now (name_errors()): what follows from both is known to be one.
inline Triple<double> retold(const Triple<double>& misread, const Triple<double>&,
                             const geom::Vec3&, int) {
  return misread;
}
template <int N>
Triple<TaylorModelOf<N>> retold(const Triple<TaylorModelOf<N>>& misread,
                                const Triple<TaylorModelOf<N>>& error, const geom::Vec3& gain,
                                int k) {
  using Model = TaylorModelOf<N>;
  const auto one = [](const Model& noise, const Model& of, double by, int symbol) {
    // error = by * noise + rest, where both are within what they are at most.
    const double all = of.l[symbol];
    const double rest = std::max(0.0, all - by * noise.r) + 1e-12 * all;
    if (!(rest < 0.25 * by * noise.r)) return noise;
    Model out = Model::symbol(0, symbol, all / by);
    out.r = rest / by * (1 + 1e-12);
    return out;
  };
  return {one(misread.x, error.x, gain.x(), k), one(misread.y, error.y, gain.y(), k + 1),
          one(misread.z, error.z, gain.z(), k + 2)};
}

}  // namespace traj
