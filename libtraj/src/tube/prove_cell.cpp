#include "tube/prove_cell.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <complex>

#include "geom/vehicle/limits.h"
#include "traj/flight/monte_carlo.h"
#include "tube/period_symbols.h"

namespace traj {
namespace {

constexpr double kPi = 3.141592653589793;
constexpr double kAgreement = 1e-9;  // m, of the middle's flight with the simulator's

class CellProof {
 public:
  CellProof(const ReferenceTrack& track, const FlightOptions& options, const Disturbances& d,
            const TubeCell& cell)
      : track_(track),
        options_(options),
        cell_(cell),
        loop_{options.quadrotor, options.gains.geometric, options.periods.attitude, d.gust_lag,
              d.gust_most},
        before_(std::lround(options.hover / kStep)),
        steps_(std::lround((track.duration() + options.settle) / kStep)),
        now_(reference(-before_)),
        errors_(start(cell, d)) {
    out_.radius.assign(tube_periods(track.duration()), 0);
    place_.setZero();
    for (int i = 0; i < 3; ++i) {
      place_(i, i) = -1 / loop_.gains.position[i];
      place_(i, kVelocity + i) = -loop_.gains.velocity[i] / loop_.gains.position[i];
      gust_(kGust + i, i) = (1 - gust_kept(loop_, loop_.period)) * d.gust_most;
    }
  }

  CellTube prove() {
    look_at_weight();
    for (long n = -before_; n <= steps_ && !out_.trouble; n += loop_.period) advance(n);
    if (!out_.trouble) compare_with_simulator();
    return std::move(out_);
  }

 private:
  Reference reference(long n) { return track_.at(static_cast<double>(n) * kStep, cursor_); }

  // At rest on the first reference, in the middle of the cell; also notes that state.
  ErrorSet start(const TubeCell& cell, const Disturbances& d) {
    const TaylorModel lightness =
        TaylorModel::inverse_of(cell.mass_least, cell.mass_most, kLightness);
    LoopState<TaylorModel> state = resting(lightness);
    state.drag = TaylorModel::symbol(1, kDrag, d.drag_error);
    state.quickness =
        TaylorModel::inverse_of(1 - d.motor_lag_error, 1 + d.motor_lag_error, kQuickness);
    const auto agility = [&](int axis) {
      return TaylorModel::inverse_of(1 - d.inertia_error, 1 + d.inertia_error, kAgility + axis);
    };
    state.agility = {agility(0), agility(1), agility(2)};
    ErrorTerms held;
    held.intervals = ErrorColumns::Zero(kErrorRows, kErrorRows - kLightness);
    ErrorVector box = ErrorVector::Zero();
    for_each(state, [&](int i, const TaylorModel& m) {
      middle_[i] = m.c;
      held.intervals.row(i) =
          m.l.segment<kErrorRows - kLightness>(kLightness).matrix().transpose() * (1 + 1e-14);
      box[i] = m.r;
    });
    ErrorColumns wind = ErrorColumns::Zero(kErrorRows, 3);
    for (int i = 0; i < 3; ++i) {
      middle_[kWind + i] = cell.wind[i];
      wind(kWind + i, i) = cell.wind_radius > 0 ? cell.wind_radius : cell.wind_half[i];
    }
    if (cell.wind_radius > 0) {
      held.balls = wind;
    } else {
      held.intervals.conservativeResize(Eigen::NoChange, held.intervals.cols() + 3);
      held.intervals.rightCols<3>() = wind;
    }
    return ErrorSet(std::move(held), box);
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

  static double named(const TaylorModel& m) {
    return m.l.tail<TaylorModel::kSymbols - kLoopStates>().abs().sum();
  }

  // Notes the first motor whose command may leave its range.
  void look_for_saturation(long n, const PeriodSymbols& symbols,
                           const LoopStep<TaylorModel>& step) {
    const Quadrotor& q = loop_.model;
    for (std::size_t j = 0; j < step.commands.size() && !out_.trouble; ++j) {
      for (int i = 0; i < 4; ++i) {
        const TaylorModel& m = step.commands[j][i];
        const auto room = [&](double radius) {
          return std::min(q.motor_most - m.c, m.c - q.motor_least) - radius;
        };
        if (room(m.radius()) > 0) continue;
        const double left = room(errors_.bound(symbols.slopes(m)) + named(m) + m.r + kSlack);
        if (left > 0) continue;
        const bool upright = std::isfinite(left);
        out_.trouble = TubeTrouble{
            upright ? TubeTrouble::Kind::motor : TubeTrouble::Kind::tilt, upright ? i + 1 : 0,
            static_cast<double>(n + static_cast<long>(j)) * kStep, upright ? left : 0};
        return;
      }
    }
  }

  // Position minus reference in the middle: lift = kp (p_r - p) + kv (v_r - v) + a_r + g.
  Vec3 offset() const {
    const Vec3 velocity = middle_.segment<3>(kVelocity);
    const Vec3 asked = Vec3(middle_.head<3>()) - now_.acceleration - geom::kGravity * Vec3::UnitZ();
    const Vec3 damped = loop_.gains.velocity.cwiseProduct(now_.velocity - velocity);
    return -(asked - damped).cwiseQuotient(loop_.gains.position);
  }

  // From the start of this period to that of the next.
  double radius(long n, const LoopStep<TaylorModel>& step) {
    const double here = offset().norm() + errors_.reach(place_);
    double further = 0;
    for (std::size_t j = 0; j < step.moved.size(); ++j) {
      const Vec3 wanted = reference(n + static_cast<long>(j) + 1).position - now_.position;
      const Triple<TaylorModel>& m = step.moved[j];
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
      const auto k = static_cast<std::size_t>(at / kTubePeriod);
      return std::min(k, out_.radius.size() - 1);
    };
    for (std::size_t k = period(n); k <= period(n + loop_.period); ++k) {
      out_.radius[k] = std::max(out_.radius[k], radius);
    }
  }

  void note_tilt(const LoopStep<TaylorModel>& step) {
    for (const TaylorModel& upright : step.upright) {
      const double least = upright.least() - kSlack;
      out_.tilt = std::max(out_.tilt, least >= -1 ? std::acos(std::min(least, 1.0)) : kPi);
    }
  }

  // Notes the bounds of this period, and gives those that count.
  ErrorVector sizes(long n) {
    ErrorVector out = symbol_sizes(loop_.model, errors_);
    const auto span = static_cast<std::size_t>((n + before_) / loop_.period / kSpanPeriods);
    if (out_.bounds.size() <= span) out_.bounds.resize(span + 1, SpanBounds{});
    Eigen::Map<Eigen::Matrix<double, kSpanBounds, 1>> bounds(out_.bounds[span].data());
    bounds = bounds.cwiseMax(out.head<kSpanBounds>());
    if (!cell_.bounds.empty()) {
      out.head<kSpanBounds>() =
          Eigen::Map<const Eigen::Matrix<double, kSpanBounds, 1>>(cell_.bounds[span].data());
    }
    return out;
  }

  void advance(long n) {
    const PeriodSymbols symbols(loop_.model, sizes(n));
    const Reference next = reference(n + loop_.period);
    const LoopStep<TaylorModel> step = loop_step(loop_, symbols.state(middle_), {now_, next});
    look_for_saturation(n, symbols, step);
    if (out_.trouble) return;
    if (n + loop_.period > 0) {
      note_radius(n, radius(n, step));
      note_tilt(step);
    }
    if (n >= 0 && n % kStepsPerSample == 0)
      distances_.emplace_back(n / kStepsPerSample, offset().norm());
    PeriodMap period = symbols.map(step.state);
    period.added.gust = gust_;
    if (!period.finite()) {
      out_.trouble = TubeTrouble{TubeTrouble::Kind::tilt, 0, static_cast<double>(n) * kStep, 0};
      return;
    }
    for (int i = 0; i < kWind; ++i) {
      middle_[i] = period.middle[i];
      period.added.box[i] += i >= kSpin && i < kTurned ? kSpinSlack : kSlack;
    }
    if (n == -before_ && !settles(period.map)) {
      out_.trouble = TubeTrouble{TubeTrouble::Kind::unstable, 0, static_cast<double>(n) * kStep, 0};
    }
    errors_.advance(period.map, period.added);
    now_ = next;
  }

  // The slack was measured on vehicles whose motors are not much faster than a step. This finds
  // others.
  void compare_with_simulator() {
    FlightOptions flown = options_;
    flown.wind = {.mean = cell_.wind};
    flown.mass_error = 1 / middle_[kLightness] - 1;
    flown.drag_error = middle_[kDrag] - 1;
    flown.motor_lag_error = 1 / middle_[kQuickness] - 1;
    flown.inertia_error = middle_.segment<3>(kAgility).cwiseInverse() - Vec3::Ones();
    const Flight flight = simulate(track_, flown, {});
    for (const auto& [sample, distance] : distances_) {
      const auto k = static_cast<std::size_t>(sample);
      if (k < flight.error.size() && std::abs(flight.error[k] - distance) <= kAgreement) continue;
      out_.trouble = TubeTrouble{TubeTrouble::Kind::steps, 0,
                                 static_cast<double>(sample * kStepsPerSample) * kStep, 0};
      return;
    }
  }

  // Whether the loop in hover dies away; notes its damping.
  bool settles(const ErrorMatrix& map) {
    const Eigen::MatrixXd loop = map.topLeftCorner<kGust, kGust>();
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
  Loop loop_;
  long before_;  // steps before the start,
  long steps_;   // and from there to the very end
  std::size_t cursor_ = 0;
  Reference now_;
  ErrorVector middle_;
  ErrorSet errors_;
  Eigen::Matrix<double, kErrorRows, 3> gust_ = Eigen::Matrix<double, kErrorRows, 3>::Zero();
  Eigen::Matrix<double, 3, kErrorRows> place_;
  std::vector<std::pair<long, double>> distances_;  // m of the middle, at the simulator's samples
  CellTube out_;
};

}  // namespace

CellTube prove_cell(const ReferenceTrack& track, const FlightOptions& options,
                    const Disturbances& disturbances, const TubeCell& cell) {
  return CellProof(track, options, disturbances, cell).prove();
}

}  // namespace traj
