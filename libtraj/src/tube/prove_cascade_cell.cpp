#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <complex>
#include <numeric>

#include "geom/vehicle/limits.h"
#include "traj/flight/monte_carlo.h"
#include "tube/cascade_clips.h"
#include "tube/cascade_step.h"
#include "tube/period_symbols.h"
#include "tube/prove_cell.h"
#include "tube/slow_modes.h"

namespace traj {
namespace {

using Rows = CascadeRows;
using Model = Rows::Model;
using Symbols = PeriodSymbolsOf<Rows>;
using Vector = ErrorVectorOf<Rows>;
using Columns = ErrorColumnsOf<Rows>;

constexpr double kPi = 3.141592653589793;
constexpr double kAgreement = 1e-9;  // m, of the middle's flight with the simulator's

class CascadeProof {
 public:
  CascadeProof(const ReferenceTrack& track, const FlightOptions& options, const Disturbances& d,
               const TubeCell& cell)
      : track_(track),
        options_(options),
        cell_(cell),
        loop_{options.quadrotor, options.gains, options.periods, {d.gust_lag, d.gust_most}},
        period_(options.periods.attitude),
        before_(std::lround(options.hover / kStep)),
        steps_(std::lround((track.duration() + options.settle) / kStep)),
        errors_(start(cell, d)) {
    out_.radius.assign(tube_periods(track.duration()), 0);
    place_.setZero();
    const LiftGains k(loop_);
    for (int i = 0; i < 3; ++i) {
      const double shrink = -1 / loop_.gains.position.p[i];
      place_(i, Rows::kVelocity + i) = shrink;
      place_(i, Rows::kDue + i) = shrink / k.of_drift[i];
      place_(i, Rows::kMissed + i) = shrink * (1 - k.of_missed[i] / k.of_drift[i]);
      place_(i, Rows::kSlope + i) = shrink * k.of_slope[i] / k.of_drift[i];
      gust_(Rows::kGust + i, i) = (1 - gust_kept(d.gust_lag, period_)) * d.gust_most;
    }
  }

  CellTube prove() {
    look_at_weight();
    for (long n = -before_; n <= steps_ && !out_.trouble; n += period_) advance(n);
    if (!out_.trouble) compare_with_simulator();
    return std::move(out_);
  }

 private:
  // At rest on the first reference, in the middle of the cell; also notes that state.
  ErrorSetOf<Rows> start(const TubeCell& cell, const Disturbances& d) {
    CascadeState<Model> state =
        cascade_at_rest(Model::inverse_of(cell.mass_least, cell.mass_most, Rows::kLightness));
    state.drag = Model::symbol(1, Rows::kDrag, d.drag_error);
    state.quickness =
        Model::inverse_of(1 - d.motor_lag_error, 1 + d.motor_lag_error, Rows::kQuickness);
    const auto agility = [&](int axis) {
      return Model::inverse_of(1 - d.inertia_error, 1 + d.inertia_error, Rows::kAgility + axis);
    };
    state.agility = {agility(0), agility(1), agility(2)};
    constexpr int kHeld = Rows::kStates - Rows::kLightness;
    ErrorTermsOf<Rows> held;
    held.intervals = Columns::Zero(Rows::kPadded, kHeld);
    Vector box = Vector::Zero();
    middle_.setZero();
    for_each(state, [&](int i, const Model& m) {
      middle_[i] = m.c;
      held.intervals.row(i) =
          m.l.segment<kHeld>(Rows::kLightness).matrix().transpose() * (1 + 1e-14);
      box[i] = m.r;
    });
    Columns wind = Columns::Zero(Rows::kPadded, 3);
    for (int i = 0; i < 3; ++i) {
      middle_[Rows::kWind + i] = cell.wind[i];
      wind(Rows::kWind + i, i) = cell.wind_radius > 0 ? cell.wind_radius : cell.wind_half[i];
    }
    if (cell.wind_radius > 0) {
      held.balls = wind;
    } else {
      held.intervals.conservativeResize(Eigen::NoChange, kHeld + 3);
      held.intervals.rightCols<3>() = wind;
    }
    return ErrorSetOf<Rows>(std::move(held), box);
  }

  // At rest the motors hold the true weight, or as much of it as they can.
  void look_at_weight() {
    const Quadrotor& q = loop_.model;
    const double share = q.mass * geom::kGravity / 4;
    const double room =
        std::min(q.motor_most - cell_.mass_most * share, cell_.mass_least * share - q.motor_least);
    if (room > 0) return;
    out_.trouble =
        TubeTrouble{TubeTrouble::Kind::motor, 1, static_cast<double>(-before_) * kStep, room};
  }

  CascadeReferences references(long n) {
    CascadeReferences out;
    out.step = n + before_;
    out.last_asked = last_asked_;
    for (int j = 0; j <= period_; ++j) {
      out.at.push_back(track_.at(static_cast<double>(n + j) * kStep, cursor_));
      if (j < period_ && (out.step + j) % loop_.periods.position == 0) {
        last_asked_ = out.at.back().acceleration;
      }
    }
    return out;
  }

  static double named(const Model& m) {
    return m.l.tail<Model::kSymbols - Rows::kStates>().abs().sum();
  }

  void look_for_clips(long n, const Symbols& symbols, const CascadeStep<Model>& step) {
    if (!first_clip(loop_, step, [](const Model& m) { return m.radius() + kSlack; })) return;
    out_.trouble = first_clip(loop_, step, [&](const Model& m) {
      return errors_.bound(symbols.slopes(m)) + named(m) + m.r + kSlack;
    });
    if (out_.trouble) out_.trouble->time += static_cast<double>(n) * kStep;
  }

  // Position minus reference in the middle: the velocity's error = kp (p_r - p) + f v_r - v.
  Vec3 offset(const Reference& now) const {
    const double forward = loop_.gains.feed_forward.velocity;
    return place_ * middle_ + (forward * now.velocity).cwiseQuotient(loop_.gains.position.p);
  }

  // From the start of this period to that of the next.
  double radius(const CascadeReferences& references, const CascadeStep<Model>& step) {
    const double here = offset(references.at.front()).norm() + errors_.reach(place_);
    double further = 0;
    for (std::size_t j = 0; j < step.moved.size(); ++j) {
      const Vec3 wanted = references.at[j + 1].position - references.at.front().position;
      const Triple<Model>& m = step.moved[j];
      const Vec3 moved(std::abs(m.x.c - wanted.x()) + m.x.radius(),
                       std::abs(m.y.c - wanted.y()) + m.y.radius(),
                       std::abs(m.z.c - wanted.z()) + m.z.radius());
      further = std::max(further, moved.norm());
    }
    return here + further + kSlack;
  }

  void note_radius(long n, double radius) {
    const auto period = [&](long step) {
      const double at = static_cast<double>(std::max(step, 0L)) * kStep;
      return std::min(static_cast<std::size_t>(at / kTubePeriod), out_.radius.size() - 1);
    };
    for (std::size_t k = period(n); k <= period(n + period_); ++k) {
      out_.radius[k] = std::max(out_.radius[k], radius);
    }
  }

  void note_tilt(const CascadeStep<Model>& step) {
    for (const Model& upright : step.upright) {
      const double least = upright.least() - kSlack;
      out_.tilt = std::max(out_.tilt, least >= -1 ? std::acos(std::min(least, 1.0)) : kPi);
    }
  }

  void advance(long n) {
    const Symbols symbols(loop_.model, symbol_sizes(loop_.model, errors_));
    const CascadeReferences now = references(n);
    const CascadeStep<Model> step = cascade_step(loop_, symbols.state(middle_), now);
    look_for_clips(n, symbols, step);
    if (out_.trouble) return;
    if (n + period_ > 0) {
      note_radius(n, radius(now, step));
      note_tilt(step);
    }
    if (n >= 0 && n % kStepsPerSample == 0)
      distances_.emplace_back(n / kStepsPerSample, offset(now.at.front()).norm());
    PeriodMapOf<Rows> period = symbols.map(step.state);
    period.added.gust = gust_;
    if (!period.finite()) {
      out_.trouble = TubeTrouble{TubeTrouble::Kind::tilt, 0, static_cast<double>(n) * kStep, 0};
      return;
    }
    for (int i = 0; i < Rows::kWind; ++i) {
      middle_[i] = period.middle[i];
      period.added.box[i] += i >= Rows::kSpin && i < Rows::kMissed ? kSpinSlack : kSlack;
    }
    look_at_modes(n, now.at.front().yaw, period.map);
    errors_.advance(period.map, period.added);
  }

  // The slack was measured on vehicles whose motors are not much faster than a step. This finds
  // others.
  void compare_with_simulator() {
    FlightOptions flown = options_;
    flown.wind = {.mean = cell_.wind};
    flown.mass_error = 1 / middle_[Rows::kLightness] - 1;
    flown.drag_error = middle_[Rows::kDrag] - 1;
    flown.motor_lag_error = 1 / middle_[Rows::kQuickness] - 1;
    flown.inertia_error = middle_.segment<3>(Rows::kAgility).cwiseInverse() - Vec3::Ones();
    const Flight flight = simulate(track_, flown, {});
    for (const auto& [sample, distance] : distances_) {
      const auto k = static_cast<std::size_t>(sample);
      if (k < flight.error.size() && std::abs(flight.error[k] - distance) <= kAgreement) continue;
      out_.trouble = TubeTrouble{TubeTrouble::Kind::steps, 0,
                                 static_cast<double>(sample * kStepsPerSample) * kStep, 0};
      return;
    }
  }

  // The loops run in the same order again after some periods: whether the loop in hover dies away
  // over these; notes its damping.
  void look_at_modes(long n, double yaw, const ErrorMatrixOf<Rows>& map) {
    const int position = loop_.periods.position;
    const long order = position / std::gcd(position, period_);
    const long done = (n + before_) / period_;
    if (done >= order) return;
    modes_ = done == 0 ? map : ErrorMatrixOf<Rows>(map * modes_);
    if (done + 1 < order) return;
    errors_.box_along(slow_modes(modes_, yaw, static_cast<double>(order * period_)));
    if (settles()) return;
    out_.trouble = TubeTrouble{TubeTrouble::Kind::unstable, 0, static_cast<double>(n) * kStep, 0};
  }

  bool settles() {
    const Eigen::MatrixXd loop = modes_.topLeftCorner<Rows::kGust, Rows::kGust>();
    const Eigen::VectorXcd modes = loop.eigenvalues();
    for (Eigen::Index k = 0; k < modes.size(); ++k) {
      if (!(std::abs(modes[k]) < 1)) return false;
      if (std::abs(modes[k]) < 1e-6) continue;
      const std::complex<double> rate = std::log(modes[k]);
      out_.damping = std::min(out_.damping, -rate.real() / std::abs(rate));
    }
    return true;
  }

  const ReferenceTrack& track_;
  const FlightOptions& options_;
  const TubeCell& cell_;
  CascadeLoop loop_;
  int period_;   // ms
  long before_;  // steps before the start,
  long steps_;   // and from there to the very end
  std::size_t cursor_ = 0;
  Vec3 last_asked_ = Vec3::Zero();
  Vector middle_;
  ErrorSetOf<Rows> errors_;
  ErrorMatrixOf<Rows> modes_ = ErrorMatrixOf<Rows>::Identity();
  Eigen::Matrix<double, Rows::kPadded, 3> gust_ = Eigen::Matrix<double, Rows::kPadded, 3>::Zero();
  Eigen::Matrix<double, 3, Rows::kPadded> place_;
  std::vector<std::pair<long, double>> distances_;  // m of the middle, at the simulator's samples
  CellTube out_;
};

}  // namespace

CellTube prove_cascade_cell(const ReferenceTrack& track, const FlightOptions& options,
                            const Disturbances& disturbances, const TubeCell& cell) {
  return CascadeProof(track, options, disturbances, cell).prove();
}

}  // namespace traj
