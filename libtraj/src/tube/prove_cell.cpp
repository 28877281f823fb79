#include "tube/prove_cell.h"

#include "tube/cell_proof.h"

namespace traj {
namespace {

class GeometricProof : public CellProof<GeometricProof, GeometricRows> {
 public:
  GeometricProof(const ReferenceTrack& track, const FlightOptions& options, const Disturbances& d,
                 const TubeCell& cell)
      : CellProof(track, options, d, cell, begin(track, options, d, cell), 1),
        loop_(loop_of(options, d)),
        readings_(readings_within<TaylorModel>(d)),
        gains_(gain_errors_within<TaylorModel>(d)) {
    for (int i = 0; i < 3; ++i) {
      place_(i, i) = -1 / loop_.gains.position[i];
      place_(i, kVelocity + i) = -loop_.gains.velocity[i] / loop_.gains.position[i];
    }
  }

  void load(long n) { load_references(n); }

  LoopStep<TaylorModel> step(const LoopState<TaylorModel>& state) {
    return loop_step(loop_, state, {at_.front(), at_.back()}, readings_, gains_);
  }

  // The first motor whose command may leave its range.
  template <class BoundOf>
  std::optional<TubeTrouble> limit_met(const LoopStep<TaylorModel>& step,
                                       const BoundOf& bound_of) const {
    const Quadrotor& q = loop_.model;
    for (std::size_t j = 0; j < step.commands.size(); ++j) {
      for (int i = 0; i < 4; ++i) {
        const TaylorModel& m = step.commands[j][i];
        const double half = std::min(q.motor_most - m.c, m.c - q.motor_least);
        if (half > checkers_room() * m.radius()) continue;
        const double room = half - checkers_room() * bound_of(m);
        if (room > 0) continue;
        const double time = static_cast<double>(j) * kStep;
        if (!std::isfinite(room)) return TubeTrouble{TubeTrouble::Kind::tilt, 0, time, 0};
        return TubeTrouble{TubeTrouble::Kind::motor, i + 1, time, room};
      }
    }
    return std::nullopt;
  }

  // Lift = kp (p_r - p) + kv (v_r - v) + a_r + g.
  Vec3 offset() const {
    const Reference& now = at_.front();
    const Vec3 velocity = middle_.segment<3>(kVelocity);
    const Vec3 asked = Vec3(middle_.head<3>()) - now.acceleration - geom::kGravity * Vec3::UnitZ();
    const Vec3 damped = loop_.gains.velocity.cwiseProduct(now.velocity - velocity);
    return -(asked - damped).cwiseQuotient(loop_.gains.position);
  }

  double stretch() const { return 1; }

  void look_at_hover(long n, const ErrorMatrix& map) {
    if (n == -before_ && !settles(map)) note(TubeTrouble::Kind::unstable, n);
  }

  struct Nothing {};
  Nothing memory() const { return {}; }
  void recall(Nothing) {}

 private:
  static Loop loop_of(const FlightOptions& options, const Disturbances& d) {
    return {options.quadrotor, options.gains.geometric, options.periods.attitude, d.gust_lag,
            d.gust_most};
  }

  static LoopState<TaylorModel> begin(const ReferenceTrack& track, const FlightOptions& options,
                                      const Disturbances& d, const TubeCell& cell) {
    const TaylorModel lightness = lightness_of(cell);
    if (!may_start_off(d)) return resting(lightness);
    return starting(loop_of(options, d), lightness, first_reference(track, options), start_off(d));
  }

  Loop loop_;
  Readings<TaylorModel> readings_;
  GainErrors<TaylorModel> gains_;
};

}  // namespace

CellTube prove_cell(const ReferenceTrack& track, const FlightOptions& options,
                    const Disturbances& disturbances, const TubeCell& cell) {
  return GeometricProof(track, options, disturbances, cell).prove();
}

}  // namespace traj
