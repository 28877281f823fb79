#pragma once

// The recursion of a tube's proof over a flight, the same for both controllers.
//
// A Law is the class that derives from this one. It has the controller's part:
//   void load(long n)                              takes note of the references of a period,
//   auto step(const State<Model>&)                 the period that begins then, as a Taylor model,
//   std::optional<TubeTrouble> limit_met(step, bound_of)  the first limit that may be reached, the
//                                                  times counted from the period's start; a model's
//                                                  own radius is a larger bound, and cheaper,
//   Vec3 offset() const                            position minus reference in the middle,
//   double stretch() const                         times which offset and deviations may be larger,
//   void look_at_hover(long n, const Matrix& map)  whether the loop settles,
//   auto memory() const, void recall(memory)       what it keeps from period to period, to come
//                                                  back to.

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <complex>

#include "geom/vehicle/limits.h"
#include "traj/flight/monte_carlo.h"
#include "tube/period_symbols.h"
#include "tube/plant.h"
#include "tube/prove_cell.h"
#include "tube/span_claims.h"

namespace traj {

template <class Law, class Rows>
class CellProof {
 public:
  CellTube prove() {
    look_at_weight();
    for (long n = -before_; n <= steps_ && !out_.trouble;) n = pass(n);
    if (!out_.trouble) tell();
    if (!out_.trouble) compare_with_simulator();
    return std::move(out_);
  }

 protected:
  using Model = typename Rows::Model;
  using Vector = ErrorVectorOf<Rows>;
  using Matrix = ErrorMatrixOf<Rows>;
  using Columns = ErrorColumnsOf<Rows>;

  // `begin`: the state at the start, in which the mass and `start_off` alone have their ranges.
  // `order`: after so many periods the loops run alike again.
  CellProof(const ReferenceTrack& track, const FlightOptions& options, const Disturbances& d,
            const TubeCell& cell, typename Rows::template State<Model> begin, int order)
      : track_(track),
        options_(options),
        cell_(cell),
        period_(options.periods.attitude),
        before_(std::lround(options.hover / kStep)),
        steps_(std::lround((track.duration() + options.settle) / kStep)),
        claims_(least_room(), static_cast<std::size_t>(order)),
        errors_(start(d, std::move(begin))) {
    if (d.has_noise()) errors_.take_noise();
    out_.radius.assign(tube_periods(track.duration()), 0);
    for (int i = 0; i < 3; ++i) {
      gust_(Rows::kGust + i, i) = (1 - gust_kept(d.gust_lag, period_)) * d.gust_most;
    }
  }

  // By how much more a checker may find of what has a limit.
  double checkers_room() const { return cell_.by_spans ? kLimitRoom : 1; }

  static Model lightness_of(const TubeCell& cell) {
    return Model::inverse_of(cell.mass_least, cell.mass_most, Rows::kLightness);
  }

  static bool may_start_off(const Disturbances& d) {
    return d.start_error > 0 || d.start_speed > 0;
  }

  // The columns of lift and velocity stand for the errors of place and velocity here.
  static Off<Model> start_off(const Disturbances& d) {
    const auto symbols = [](int row, double size) {
      return Triple<Model>{Model::symbol(0, row, size), Model::symbol(0, row + 1, size),
                           Model::symbol(0, row + 2, size)};
    };
    return {symbols(0, d.start_error), symbols(Rows::kVelocity, d.start_speed)};
  }

  static Reference first_reference(const ReferenceTrack& track, const FlightOptions& options) {
    std::size_t cursor = 0;
    return track.at(-options.hover, cursor);
  }

  // Loads the references from step n of the flight to the end of the period.
  void load_references(long n) {
    at_.clear();
    for (int j = 0; j <= period_; ++j) {
      at_.push_back(track_.at(static_cast<double>(n + j) * kStep, cursor_));
    }
  }

  // Whether the modes of a map die away; notes the least damping.
  bool settles(const Matrix& map) {
    const Eigen::MatrixXd loop = map.template topLeftCorner<Rows::kGust, Rows::kGust>();
    const Eigen::VectorXcd modes = loop.eigenvalues();
    for (Eigen::Index k = 0; k < modes.size(); ++k) {
      if (!(std::abs(modes[k]) < 1)) return false;
      if (std::abs(modes[k]) < 1e-6) continue;
      const std::complex<double> rate = std::log(modes[k]);
      out_.damping = std::min(out_.damping, -rate.real() / std::abs(rate));
    }
    return true;
  }

  void note(TubeTrouble::Kind kind, long n, int motor = 0, double room = 0) {
    out_.trouble = TubeTrouble{kind, motor, static_cast<double>(n) * kStep, room};
  }

  const ReferenceTrack& track_;
  const FlightOptions& options_;
  const TubeCell& cell_;
  int period_;   // ms
  long before_;  // steps before the start,
  long steps_;   // and from there to the very end
  SpanClaims claims_;
  std::size_t cursor_ = 0;
  std::vector<Reference> at_;  // after 0, 1, ... ms of the period
  Vector middle_ = Vector::Zero();
  ErrorSetOf<Rows> errors_;
  Eigen::Matrix<double, 3, Rows::kPadded> place_ =
      Eigen::Matrix<double, 3, Rows::kPadded>::Zero();  // position minus reference, of deviations
  CellTube out_;

 private:
  Law& law() { return static_cast<Law&>(*this); }

  static constexpr double slack(int row) {
    return row >= Rows::kSpin && row < Rows::kPastSpins ? kSpinSlack : kSlack;
  }

  // Beside the share: a checker flies its own middle, which is off by up to the simulator's slack.
  static SpanClaims::Bounds least_room() {
    SpanClaims::Bounds out;
    for (int row = 0; row < Rows::kWind; ++row)
      out.push_back(slack(row) == kSlack ? 10 * kSlack : 2 * slack(row));
    return out;
  }

  // Through a span, if there are spans, else through a period, from step n on. Returns the step
  // that is next.
  long pass(long n) {
    if (!cell_.by_spans) {
      advance(n);
      return n + period_;
    }
    const Moment begin{cursor_, middle_, errors_, notes_.size()};
    const auto memory = law().memory();
    while (true) {
      long next = n;
      for (int k = 0; k < claims_.periods() && next <= steps_ && !out_.trouble; ++k) {
        advance(next);
        next += period_;
      }
      if (out_.trouble ? !claims_.shorten() : claims_.settle()) {
        out_.spans = claims_.spans();
        return next;
      }
      return_to(begin);
      law().recall(memory);
    }
  }

  // What is known at the start of a period, to come back to.
  struct Moment {
    std::size_t cursor;
    Vector middle;
    ErrorSetOf<Rows> errors;
    std::size_t notes;
  };

  void return_to(const Moment& then) {
    cursor_ = then.cursor;
    middle_ = then.middle;
    errors_ = then.errors;
    notes_.resize(then.notes);
    out_.trouble.reset();
  }

  // What the coordinates of the symbols are at most; for a certificate, what it claims.
  Vector sizes() {
    Vector out = symbol_sizes(options_.quadrotor, errors_);
    if (!cell_.by_spans) return out;
    auto bounded = out.template head<Rows::kWind>();
    const SpanClaims::Bounds& claimed = claims_.taken_for({bounded.begin(), bounded.end()});
    std::copy(claimed.begin(), claimed.end(), bounded.begin());
    return out;
  }

  // On the first reference, in the middle of the cell; also notes that state.
  ErrorSetOf<Rows> start(const Disturbances& d, typename Rows::template State<Model> state) {
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
    for_each(state, [&](int i, const Model& m) {
      middle_[i] = m.c;
      held.intervals.row(i) =
          m.l.template segment<kHeld>(Rows::kLightness).matrix().transpose() * (1 + 1e-14);
      box[i] = m.r;
      if (cell_.by_spans && i < Rows::kWind) box[i] += slack(i);  // a checker starts from there
    });
    if (may_start_off(d)) {
      held.balls = Columns::Zero(Rows::kPadded, 6);
      for_each(state, [&](int i, const Model& m) {
        held.balls.row(i).template head<3>() = m.l.template head<3>().matrix().transpose();
        held.balls.row(i).template tail<3>() =
            m.l.template segment<3>(Rows::kVelocity).matrix().transpose();
      });
      held.balls *= 1 + 1e-14;
    }
    Columns wind = Columns::Zero(Rows::kPadded, 3);
    for (int i = 0; i < 3; ++i) {
      middle_[Rows::kWind + i] = cell_.wind[i];
      wind(Rows::kWind + i, i) = cell_.wind_radius > 0 ? cell_.wind_radius : cell_.wind_half[i];
    }
    if (cell_.wind_radius > 0) {
      held.balls.conservativeResize(Eigen::NoChange, held.balls.cols() + 3);
      held.balls.template rightCols<3>() = wind;
    } else {
      held.intervals.conservativeResize(Eigen::NoChange, kHeld + 3);
      held.intervals.template rightCols<3>() = wind;
    }
    return ErrorSetOf<Rows>(std::move(held), box);
  }

  // At rest the motors hold the true weight, or as much of it as they can.
  void look_at_weight() {
    const Quadrotor& q = options_.quadrotor;
    const double share = q.mass * geom::kGravity / 4;
    const double room =
        std::min(q.motor_most - cell_.mass_most * share, cell_.mass_least * share - q.motor_least);
    if (!(room > 0)) note(TubeTrouble::Kind::motor, -before_, 1, room);
  }

  void advance(long n) {
    law().load(n);
    const PeriodSymbolsOf<Rows> symbols(options_.quadrotor, sizes());
    const auto step = law().step(symbols.state(middle_));
    look_for_limits(n, symbols, step);
    if (out_.trouble) return;
    if (n + period_ > 0) notes_.push_back({n, radius(step), tilt(step), law().offset().norm()});
    PeriodMapOf<Rows> period = symbols.map(step.state);
    period.added.gust = gust_;
    if (!period.finite()) return note(TubeTrouble::Kind::tilt, n);
    for (int i = 0; i < Rows::kWind; ++i) {
      middle_[i] = period.middle[i];
      period.added.box[i] += slack(i);
    }
    law().look_at_hover(n, period.map);
    errors_.advance(period.map, period.added);
  }

  template <class Step>
  void look_for_limits(long n, const PeriodSymbolsOf<Rows>& symbols, const Step& step) {
    out_.trouble = law().limit_met(step, [&](const Model& m) {
      const double named = m.l.template tail<Model::kSymbols - Rows::kStates>().abs().sum();
      return errors_.bound(symbols.slopes(m)) + named + m.r + kSlack;
    });
    if (out_.trouble) out_.trouble->time += static_cast<double>(n) * kStep;
  }

  // From the start of this period to that of the next.
  template <class Step>
  double radius(const Step& step) {
    double further = 0;
    for (std::size_t j = 0; j < step.moved.size(); ++j) {
      const Vec3 wanted = at_[j + 1].position - at_.front().position;
      const Triple<Model>& m = step.moved[j];
      const Vec3 moved(std::abs(m.x.c - wanted.x()) + m.x.radius(),
                       std::abs(m.y.c - wanted.y()) + m.y.radius(),
                       std::abs(m.z.c - wanted.z()) + m.z.radius());
      further = std::max(further, moved.norm());
    }
    return law().stretch() * (law().offset().norm() + errors_.reach(place_)) + further + kSlack;
  }

  template <class Step>
  static double tilt(const Step& step) {
    constexpr double kPi = 3.141592653589793;
    double out = 0;
    for (const Model& upright : step.upright) {
      const double least = upright.least() - kSlack;
      out = std::max(out, least >= -1 ? std::acos(std::min(least, 1.0)) : kPi);
    }
    return out;
  }

  // Radii and tilt of all periods.
  void tell() {
    const auto part = [&](long step) {
      const double at = static_cast<double>(std::max(step, 0L)) * kStep;
      return std::min(static_cast<std::size_t>(at / kTubePeriod), out_.radius.size() - 1);
    };
    for (const Note& note : notes_) {
      for (std::size_t k = part(note.step); k <= part(note.step + period_); ++k) {
        out_.radius[k] = std::max(out_.radius[k], note.radius);
      }
      out_.tilt = std::max(out_.tilt, note.tilt);
    }
  }

  // The slack was measured on vehicles whose motors are not much faster than a step. This finds
  // others.
  void compare_with_simulator() {
    constexpr double kAgreement = 1e-9;  // m
    FlightOptions flown = options_;
    flown.wind = {.mean = cell_.wind};
    flown.sensors = {};
    flown.mass_error = 1 / middle_[Rows::kLightness] - 1;
    flown.drag_error = middle_[Rows::kDrag] - 1;
    flown.motor_lag_error = 1 / middle_[Rows::kQuickness] - 1;
    flown.inertia_error = middle_.template segment<3>(Rows::kAgility).cwiseInverse() - Vec3::Ones();
    const Flight flight = simulate(track_, flown, {});
    for (const Note& found : notes_) {
      if (found.step < 0 || found.step % kStepsPerSample != 0) continue;
      const auto k = static_cast<std::size_t>(found.step / kStepsPerSample);
      if (k < flight.error.size() && std::abs(flight.error[k] - found.offset) <= kAgreement)
        continue;
      return note(TubeTrouble::Kind::steps, found.step);
    }
  }

  Eigen::Matrix<double, Rows::kPadded, 3> gust_ = Eigen::Matrix<double, Rows::kPadded, 3>::Zero();

  // Of the period from a step on.
  struct Note {
    long step;
    double radius;  // m
    double tilt;    // rad
    double offset;  // m: of the middle, at its start
  };
  std::vector<Note> notes_;
};

}  // namespace traj
