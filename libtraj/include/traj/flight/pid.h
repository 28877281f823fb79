#pragma once

// A controller with proportional, integral and derivative action on three axes at once.
//
// Example:
//   traj::Pid loop({.p = {2, 2, 2}}, 0.01, 0);
//   const geom::Vec3 zero = geom::Vec3::Zero();
//   assert(loop.update(geom::Vec3(1, 0, 0), zero, zero) == geom::Vec3(2, 0, 0));

#include <algorithm>

#include "traj/flight/gains.h"

namespace traj {

// Called at a fixed period. The derivative is low-passed (first order). Each output is clipped, and
// the integral of an axis stops while its clipped output falls short in the direction
// of the error (clamping: no windup).
class Pid {
 public:
  // `period` and `filter` (the low pass's time constant) in seconds, > 0 and >= 0.
  Pid(const PidGains& gains, double period, double filter)
      : gains_(gains), period_(period), share_(period / (period + filter)) {}

  // p e + i integral(e) + d `slope`, low-passed, + `added`; `slope` is the derivative of the error.
  // `lost` is what limits behind this one took from the output before last, 0 where nothing.
  Vec3 update(const Vec3& error, const Vec3& slope, const Vec3& added, const Vec3& lost) {
    slope_ += share_ * (slope - slope_);
    Vec3 output;
    for (int k = 0; k < 3; ++k) {
      const double rest = gains_.p[k] * error[k] + gains_.d[k] * slope_[k] + added[k];
      const double before = rest + integral_[k];
      const double short_of = before - std::clamp(before, -gains_.clip, gains_.clip) + lost[k];
      if (short_of * error[k] <= 0) integral_[k] += gains_.i[k] * error[k] * period_;
      output[k] = std::clamp(rest + integral_[k], -gains_.clip, gains_.clip);
      clipped_[k] = output[k] != rest + integral_[k];
    }
    return output;
  }

  // The same with the error's own difference as its derivative; 0 at the first call.
  Vec3 update(const Vec3& error, const Vec3& added, const Vec3& lost) {
    const Vec3 slope = started_ ? Vec3((error - last_) / period_) : Vec3::Zero();
    last_ = error;
    started_ = true;
    return update(error, slope, added, lost);
  }

  bool clipped() const { return clipped_[0] || clipped_[1] || clipped_[2]; }
  const Vec3& integral() const { return integral_; }

 private:
  PidGains gains_;
  double period_;
  double share_;
  Vec3 integral_ = Vec3::Zero();
  Vec3 slope_ = Vec3::Zero();
  Vec3 last_ = Vec3::Zero();
  bool started_ = false;
  bool clipped_[3] = {false, false, false};
};

}  // namespace traj
