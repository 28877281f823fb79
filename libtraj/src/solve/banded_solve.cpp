#include "banded_solve.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <utility>

#include "block_tridiagonal.h"
#include "duration_pivot.h"
#include "log_sum.h"
#include "step_filter.h"

namespace traj {
namespace {

using Vector = std::vector<double>;

constexpr int kJoint = Nlp::kJoint;
constexpr int kTime = Nlp::kTime;
constexpr int kPiece = Nlp::kPiece;

// A larger one drives some curves away from their start, to another optimum that is slower.
constexpr double kFirstBarrier = 0.05;
constexpr double kLeastBarrier = 1e-5;
constexpr double kBarrierShare = 0.2;  // of one weight the next has at most
// Loose steps from one weight to the next: short durations keep the dual error large long after the
// point has settled.
constexpr double kBarrierTolerance = 1e4;
constexpr double kFirstSlack = 0.02;       // at least
constexpr double kToTheWall = 0.99;        // of the way to a slack of 0 that one step may go
constexpr double kTolerance = 1e-4;        // of optimality and feasibility
constexpr double kSettled = 3e-5;          // relative change of the objective ...
constexpr std::size_t kRecent = 7;         // ... over so many iterations
constexpr int kPatience = 100;             // iterations: a point that still gains then ...
constexpr double kNearlySettled = 3e-4;    // ... has settled with a change of so much
constexpr double kLowBarrier = 2e-3;       // from which on it may settle
constexpr int kHalvings = 25;              // of a step
constexpr double kLeastShare = 1e-3;       // of the curvature of constraints that is added
constexpr double kShareStep = 4;           // by which that share falls after long steps, and rises
constexpr double kMultiplierReach = 1e10;  // of barrier / slack, either way
constexpr double kUnbounded = 1e19;

// A finite bound of a variable: inside * (x - value) > 0.
struct Bound {
  std::size_t variable;
  double inside;  // 1 or -1
  double value;

  double distance(const Vector& x) const { return inside * (x[variable] - value); }
};

struct Point {
  Vector x, slack;
  Vector value;  // of the constraints at x
  double objective = 0;
};

struct Multipliers {
  Vector row, bound;
};

// A direction, and how far along it slacks, distances and multipliers stay positive.
struct Direction {
  Vector x, slack;
  Multipliers multiplier;
  double slope = 0;  // of the objective with its barriers
  double most = 1;
  double most_multiplier = 1;
};

class InteriorPoint {
 public:
  InteriorPoint(const Nlp& nlp, int max_iterations)
      : nlp_(nlp), max_iterations_(max_iterations), matrix_(nlp.pieces()) {
    for (std::size_t i = 0; i < nlp_.start().size(); ++i) {
      if (nlp_.lower()[i] > -kUnbounded) bounds_.push_back({i, 1, nlp_.lower()[i]});
      if (nlp_.upper()[i] < kUnbounded) bounds_.push_back({i, -1, nlp_.upper()[i]});
    }
  }

  BandedOutcome run() {
    begin();
    StepFilter filter(progress(at_).violation);
    BandedOutcome out;
    for (;; ++out.iterations) {
      gradient_ = nlp_.gradient(at_.x);
      points_ = nlp_.points(at_.x, std::move(points_));
      if (ended(out)) break;
      if (lower_barrier()) filter.forget();
      if (!factored()) {
        out.status = "not positive definite";
        break;
      }
      if (!advanced(direction(), filter)) {
        out.status = "step too small";
        break;
      }
    }
    out.x = at_.x;
    return out;
  }

 private:
  void begin() {
    at_.x = nlp_.start();
    at_.value = nlp_.constraint_values(at_.x);
    at_.objective = nlp_.objective(at_.x);
    for (std::size_t i = 0; i < at_.value.size(); ++i) {
      at_.slack.push_back(std::max(nlp_.bound()[i] - at_.value[i], kFirstSlack));
      multiplier_.row.push_back(barrier_ / at_.slack.back());
    }
    for (const Bound& bound : bounds_) {
      multiplier_.bound.push_back(barrier_ / bound.distance(at_.x));
    }
  }

  bool ended(BandedOutcome& out) {
    const double violation = most_violated(at_);
    const bool flat = objective_is_flat(out.iterations < kPatience ? kSettled : kNearlySettled);
    // Full weight on the durations brings a point that has settled to the constraints.
    landing_ = flat;
    error_ = error(violation);
    if (barrier_ <= kLeastBarrier && error_ <= kTolerance) {
      out.status = "solved";
      out.settled = true;
    } else if (flat && violation <= kTolerance) {
      out.status = "settled";
      out.settled = true;
    } else if (out.iterations >= max_iterations_) {
      out.status = "iteration limit";
    }
    return out.status != BandedOutcome().status;
  }

  bool objective_is_flat(double change) {
    recent_.push_back(at_.objective);
    if (recent_.size() > kRecent) recent_.pop_front();
    if (recent_.size() < kRecent || barrier_ > kLowBarrier) return false;
    const auto [least, most] = std::minmax_element(recent_.begin(), recent_.end());
    return *most - *least < change * std::max(1.0, std::abs(at_.objective));
  }

  double residual(const Point& p, std::size_t row) const {
    return p.value[row] + p.slack[row] - nlp_.bound()[row];
  }

  double most_violated(const Point& p) const {
    double most = 0;
    for (std::size_t i = 0; i < p.value.size(); ++i) {
      most = std::max(most, std::abs(residual(p, i)));
    }
    return most;
  }

  // The largest violation of the optimality conditions, scaled as by Wächter and Biegler (5).
  double error(double violation) const {
    Vector dual = nlp_.transposed_jacobian_times(points_, multiplier_.row);
    for (std::size_t i = 0; i < dual.size(); ++i) dual[i] += gradient_[i];
    double sum = 0;
    double product = 0;
    for (std::size_t i = 0; i < bounds_.size(); ++i) {
      const double z = multiplier_.bound[i];
      dual[bounds_[i].variable] -= bounds_[i].inside * z;
      product = std::max(product, std::abs(bounds_[i].distance(at_.x) * z - barrier_));
    }
    for (std::size_t i = 0; i < at_.slack.size(); ++i) {
      sum += multiplier_.row[i];
      product = std::max(product, std::abs(at_.slack[i] * multiplier_.row[i] - barrier_));
    }
    const double rows = static_cast<double>(at_.slack.size()) + 1;
    const double scale = std::max(100.0, sum / rows) / 100;
    double most = product / scale;
    for (const double d : dual) most = std::max(most, std::abs(d) / scale);
    return std::max(most, violation);
  }

  bool lower_barrier() {
    if (barrier_ <= kLeastBarrier || error_ > kBarrierTolerance * barrier_) return false;
    const double next = std::min(kBarrierShare * barrier_, barrier_ * std::sqrt(barrier_));
    barrier_ = std::max(kLeastBarrier, next);
    return true;
  }

  Progress progress(const Point& p) const {
    Progress out;
    LogSum logs;
    for (std::size_t i = 0; i < p.slack.size(); ++i) {
      out.violation += std::abs(residual(p, i));
      logs.add(p.slack[i]);
    }
    for (const Bound& bound : bounds_) logs.add(bound.distance(p.x));
    out.barrier = p.objective - barrier_ * logs.value();
    return out;
  }

  // The Newton matrix with as little added to the durations as makes it positive definite, starting
  // from a share that last did.
  bool factored() {
    ratio_.resize(at_.slack.size());
    for (std::size_t i = 0; i < ratio_.size(); ++i) ratio_[i] = multiplier_.row[i] / at_.slack[i];
    blocks_.resize(nlp_.pieces(), Nlp::Block::Zero());
    lift_.clear();
    for (std::size_t k = 0; k < nlp_.pieces(); ++k) {
      nlp_.condense(k, at_.x, points_, 1, multiplier_.row, ratio_, blocks_[k]);
      lift_.push_back(std::max(0.0, -2 * duration_pivot(blocks_[k])));
    }
    if (landing_) {
      share_ = 1;
    } else if (length_ >= 0.5) {
      share_ = std::max(share_ / kShareStep, kLeastShare);
    } else if (length_ <= 0.2) {
      share_ = std::min(1.0, share_ * kShareStep);
    }
    for (; share_ < 1; share_ = std::min(1.0, share_ * kShareStep)) {
      if (factored_with(share_, 0)) return true;
    }
    for (double shift = 0; shift < 1e10; shift = std::max(1e-6, 8 * shift)) {
      if (factored_with(1, shift)) return true;
    }
    return false;
  }

  bool factored_with(double share, double shift) {
    const std::size_t n = nlp_.pieces();
    for (std::size_t k = 0; k < n; ++k) {
      const Nlp::Block& h = blocks_[k];
      matrix_.diagonal(k) = h.topLeftCorner<kPiece, kPiece>();
      matrix_.diagonal(k)(kTime, kTime) += share * lift_[k];
      if (k > 0) {
        matrix_.diagonal(k).topLeftCorner<kJoint, kJoint>() +=
            blocks_[k - 1].bottomRightCorner<kJoint, kJoint>();
      }
      if (k + 1 == n) break;
      matrix_.below(k).topRows<kJoint>() = h.block<kJoint, kPiece>(kPiece, 0);
      matrix_.below(k).bottomRows<1>().setZero();
    }
    for (std::size_t k = 0; k < n; ++k) matrix_.diagonal(k).diagonal().array() += shift;
    // The rest at the start is no variable.
    matrix_.diagonal(0).topLeftCorner<kJoint, kJoint>().setIdentity();
    for (std::size_t i = 0; i < bounds_.size(); ++i) {
      const std::size_t v = bounds_[i].variable + kJoint;
      const int d = static_cast<int>(v % kPiece);
      matrix_.diagonal(v / kPiece)(d, d) += multiplier_.bound[i] / bounds_[i].distance(at_.x);
    }
    return matrix_.factor();
  }

  Direction direction() const {
    const std::size_t rows = at_.slack.size();
    Vector pull(rows);
    for (std::size_t i = 0; i < rows; ++i) {
      pull[i] = barrier_ / at_.slack[i] + ratio_[i] * residual(at_, i);
    }
    Vector right = nlp_.transposed_jacobian_times(points_, pull);
    for (std::size_t i = 0; i < right.size(); ++i) right[i] = -gradient_[i] - right[i];
    for (const Bound& bound : bounds_) {
      right[bound.variable] += bound.inside * barrier_ / bound.distance(at_.x);
    }
    right.insert(right.begin(), kJoint, 0.0);
    matrix_.solve(right);
    Direction d;
    d.x.assign(right.begin() + kJoint, right.end());
    for (std::size_t i = 0; i < d.x.size(); ++i) d.slope += gradient_[i] * d.x[i];
    add_slacks(d);
    add_bounds(d);
    return d;
  }

  // How far `value` > 0 can go along `step` and keep a share of itself.
  double room(double value, double step) const {
    const double share = std::max(kToTheWall, 1 - barrier_);
    return step < -share * value ? -share * value / step : 1;
  }

  void add_slacks(Direction& d) const {
    d.slack = nlp_.jacobian_times(points_, d.x);
    for (std::size_t i = 0; i < d.slack.size(); ++i) {
      const double s = at_.slack[i];
      const double y = multiplier_.row[i];
      d.slack[i] = -residual(at_, i) - d.slack[i];
      d.multiplier.row.push_back(barrier_ / s - y - ratio_[i] * d.slack[i]);
      d.slope -= barrier_ / s * d.slack[i];
      d.most = std::min(d.most, room(s, d.slack[i]));
      d.most_multiplier = std::min(d.most_multiplier, room(y, d.multiplier.row[i]));
    }
  }

  void add_bounds(Direction& d) const {
    for (std::size_t i = 0; i < bounds_.size(); ++i) {
      const double s = bounds_[i].distance(at_.x);
      const double z = multiplier_.bound[i];
      const double step = bounds_[i].inside * d.x[bounds_[i].variable];
      d.multiplier.bound.push_back(barrier_ / s - z - z / s * step);
      d.slope -= barrier_ / s * step;
      d.most = std::min(d.most, room(s, step));
      d.most_multiplier = std::min(d.most_multiplier, room(z, d.multiplier.bound[i]));
    }
  }

  // Slacks may jump to what is left of their constraint: that lowers violation and barrier both.
  Point moved(const Direction& d, double length) const {
    Point p;
    p.x = at_.x;
    for (std::size_t i = 0; i < p.x.size(); ++i) p.x[i] += length * d.x[i];
    p.value = nlp_.constraint_values(p.x);
    p.objective = nlp_.objective(p.x);
    p.slack = at_.slack;
    for (std::size_t i = 0; i < p.slack.size(); ++i) {
      p.slack[i] = std::max(p.slack[i] + length * d.slack[i], nlp_.bound()[i] - p.value[i]);
    }
    return p;
  }

  bool advanced(const Direction& d, StepFilter& filter) {
    const Progress from = progress(at_);
    length_ = d.most;
    for (int i = 0; i < kHalvings; ++i, length_ /= 2) {
      Point next = moved(d, length_);
      if (!filter.accepts(from, progress(next), d.slope, length_)) continue;
      at_ = std::move(next);
      follow(d);
      return true;
    }
    return false;
  }

  void follow(const Direction& d) {
    for (std::size_t i = 0; i < multiplier_.row.size(); ++i) {
      const double middle = barrier_ / at_.slack[i];
      multiplier_.row[i] = std::clamp(multiplier_.row[i] + d.most_multiplier * d.multiplier.row[i],
                                      middle / kMultiplierReach, middle * kMultiplierReach);
    }
    for (std::size_t i = 0; i < multiplier_.bound.size(); ++i) {
      multiplier_.bound[i] += d.most_multiplier * d.multiplier.bound[i];
    }
  }

  const Nlp& nlp_;
  int max_iterations_;
  std::vector<Bound> bounds_;
  double barrier_ = kFirstBarrier;
  Point at_;
  Multipliers multiplier_;
  Vector gradient_;
  std::vector<Nlp::Point> points_;
  Vector ratio_;  // multiplier / slack
  double error_ = 0;
  std::deque<double> recent_;  // objectives
  std::vector<Nlp::Block> blocks_;
  Vector lift_;        // what makes each block positive semidefinite, on its duration
  double share_ = 1;   // of it that is added
  double length_ = 1;  // of the last step
  bool landing_ = false;
  BlockTridiagonal matrix_;
};

}  // namespace

BandedOutcome banded_solve(const Nlp& nlp, int max_iterations) {
  return InteriorPoint(nlp, max_iterations).run();
}

}  // namespace traj
