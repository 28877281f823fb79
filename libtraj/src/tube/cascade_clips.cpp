#include "tube/cascade_clips.h"

#include <algorithm>
#include <cmath>

#include "geom/vehicle/limits.h"

namespace traj {
namespace {

using Model = CascadeRows::Model;
using Kind = TubeTrouble::Kind;

constexpr double kLeastLift = 0.3 * geom::kGravity;  // m/s2, as the controller's

class Clips {
 public:
  Clips(const CascadeLoop& loop, const std::function<double(const Model&)>& radius)
      : loop_(loop), radius_(radius) {}

  std::optional<TubeTrouble> first(const CascadeStep<Model>& step) {
    for (std::size_t j = 0; j < step.commands.size() && !found_; ++j) {
      millisecond_ = static_cast<int>(j);
      for (const PositionRun<Model>& run : step.runs) {
        if (run.millisecond == millisecond_) look_at(run);
      }
      if (j == 0) look_at_rates(step.rates);
      look_at_size(Kind::turn, step.turns[j].before, loop_.gains.rates.clip);
      look_at_size(Kind::turn, step.turns[j].spin, loop_.gains.rates.clip);
      for (int i = 0; i < 4; ++i) {
        const Interval m = values(step.commands[j][i]);
        const Quadrotor& q = loop_.model;
        note(Kind::motor, std::min(q.motor_most - m.most, m.least - q.motor_least), i + 1);
      }
    }
    return found_;
  }

 private:
  struct Interval {
    double least = 0, most = 0;
    double size() const { return std::max(most, -least); }
  };

  Interval values(const Model& m) const {
    const double radius = radius_(m);
    return {m.c - radius, m.c + radius};
  }

  // Written so that what is not finite is noted too.
  void note(Kind kind, double room, int motor = 0) {
    if (room > 0 || found_) return;
    const bool upright = std::isfinite(room);
    found_ = TubeTrouble{upright ? kind : Kind::tilt, upright ? motor : 0, 1e-3 * millisecond_,
                         upright ? room : 0};
  }

  void look_at_size(Kind kind, const Triple<Model>& t, double most) {
    if (std::isinf(most)) return;
    for (const Model* m : {&t.x, &t.y, &t.z}) note(kind, most - values(*m).size());
  }

  void look_at(const PositionRun<Model>& run) {
    look_at_size(Kind::velocity, run.velocity, loop_.gains.position.clip);
    look_at_size(Kind::acceleration, run.before, loop_.gains.velocity.clip);
    look_at_size(Kind::acceleration, run.acceleration, loop_.gains.velocity.clip);
    const double most = 4 * loop_.model.motor_most / loop_.model.mass;
    const Interval z = values(run.lift.z);
    note(Kind::lift, std::min(most - z.most, z.least - std::min(kLeastLift, most)));
    if (found_) return;
    const double across = std::hypot(values(run.lift.x).size(), values(run.lift.y).size());
    note(Kind::lift, std::sqrt(most * most - z.most * z.most) - across);
    note(Kind::lean, z.least * std::tan(loop_.gains.tilt_max) - across);
  }

  void look_at_rates(const Triple<Model>& rates) {
    const Vec3& most = loop_.model.body_rate_max;
    note(Kind::rates, most.x() - values(rates.x).size());
    note(Kind::rates, most.y() - values(rates.y).size());
    note(Kind::rates, most.z() - values(rates.z).size());
  }

  const CascadeLoop& loop_;
  const std::function<double(const Model&)>& radius_;
  int millisecond_ = 0;
  std::optional<TubeTrouble> found_;
};

}  // namespace

std::optional<TubeTrouble> first_clip(const CascadeLoop& loop, const CascadeStep<Model>& step,
                                      const std::function<double(const Model&)>& radius) {
  return Clips(loop, radius).first(step);
}

}  // namespace traj
