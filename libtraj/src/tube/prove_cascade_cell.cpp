#include <numeric>

#include "tube/cascade_clips.h"
#include "tube/cascade_step.h"
#include "tube/cell_proof.h"
#include "tube/slow_modes.h"

namespace traj {
namespace {

using Rows = CascadeRows;

class CascadeProof : public CellProof<CascadeProof, Rows> {
 public:
  CascadeProof(const ReferenceTrack& track, const FlightOptions& options, const Disturbances& d,
               const TubeCell& cell)
      : CellProof(track, options, d, cell, begin(track, options, d, cell), order(options.periods)),
        loop_(loop_of(options, d)),
        readings_(readings_within<Model>(d)),
        gains_(gain_errors_within<Model>(d)),
        gain_error_(d.gain_error) {
    const LiftGains k(loop_);
    for (int i = 0; i < 3; ++i) {
      const double shrink = -1 / loop_.gains.position.p[i];
      place_(i, Rows::kVelocity + i) = shrink;
      place_(i, Rows::kDue + i) = shrink / k.of_drift[i];
      place_(i, Rows::kMissed + i) = shrink * (1 - k.of_missed[i] / k.of_drift[i]);
      place_(i, Rows::kSlope + i) = shrink * k.of_slope[i] / k.of_drift[i];
    }
  }

  void load(long n) {
    load_references(n);
    references_ = {at_, last_asked_, n + before_};
    for (int j = 0; j < period_; ++j) {
      if ((references_.step + j) % loop_.periods.position == 0) {
        last_asked_ = at_[static_cast<std::size_t>(j)].acceleration;
      }
    }
  }

  CascadeStep<Model> step(const CascadeState<Model>& state) {
    return cascade_step(loop_, state, references_, readings_, gains_);
  }

  std::optional<TubeTrouble> limit_met(const CascadeStep<Model>& step,
                                       const std::function<double(const Model&)>& bound_of) const {
    const double room = checkers_room();
    const auto roughly = [&](const Model& m) { return room * m.radius() + kSlack; };
    if (!first_clip(loop_, step, roughly)) return {};
    return first_clip(loop_, step, [&](const Model& m) { return room * bound_of(m); });
  }

  // The velocity's error is that of the true gain of the position loop. It is 1 + an error times
  // the believed one, which turns the velocity's error into a place.
  double stretch() const { return 1 / (1 - gain_error_) * (1 + 1e-14); }

  // The velocity's error = kp (p_r - p) + f v_r - v.
  Vec3 offset() const {
    const double forward = loop_.gains.feed_forward.velocity;
    return place_ * middle_ +
           (forward * at_.front().velocity).cwiseQuotient(loop_.gains.position.p);
  }

  // Whether the loop in hover dies away until the loops run in the same order again.
  void look_at_hover(long n, const Matrix& map) {
    const int last = order(loop_.periods);
    const long done = (n + before_) / period_;
    if (done >= last) return;
    modes_ = done == 0 ? map : Matrix(map * modes_);
    if (done + 1 < last) return;
    errors_.box_along(slow_modes(modes_, at_.front().yaw, static_cast<double>(last * period_)));
    if (!settles(modes_)) note(TubeTrouble::Kind::unstable, n);
  }

  struct Memory {
    Vec3 last_asked;
    Matrix modes;
  };
  Memory memory() const { return {last_asked_, modes_}; }
  void recall(const Memory& then) {
    last_asked_ = then.last_asked;
    modes_ = then.modes;
  }

 private:
  static int order(const LoopPeriods& periods) {
    return periods.position / std::gcd(periods.position, periods.attitude);
  }

  static CascadeLoop loop_of(const FlightOptions& options, const Disturbances& d) {
    return {options.quadrotor, options.gains, options.periods, {d.gust_lag, d.gust_most}};
  }

  static CascadeState<Model> begin(const ReferenceTrack& track, const FlightOptions& options,
                                   const Disturbances& d, const TubeCell& cell) {
    const Model lightness = lightness_of(cell);
    if (!may_start_off(d)) return cascade_at_rest(lightness);
    return cascade_starting(loop_of(options, d), lightness, first_reference(track, options),
                            start_off(d), gain_errors_within<Model>(d));
  }

  CascadeLoop loop_;
  CascadeReferences references_;
  Readings<Model> readings_;
  GainErrors<Model> gains_;
  double gain_error_;
  Vec3 last_asked_ = Vec3::Zero();
  Matrix modes_ = Matrix::Identity();
};

}  // namespace

CellTube prove_cascade_cell(const ReferenceTrack& track, const FlightOptions& options,
                            const Disturbances& disturbances, const TubeCell& cell) {
  return CascadeProof(track, options, disturbances, cell).prove();
}

}  // namespace traj
