#include "tube/error_set.h"

#include <algorithm>

namespace traj {
namespace {

constexpr int kJoined = 25;          // periods, 0.1 s
constexpr int kGusts = 5;            // periods whose gusts are added up, 20 ms
constexpr std::size_t kBatches = 5;  // 0.5 s
constexpr std::size_t kOldest = 6;   // 3 s: older terms become a box
constexpr double kUp = 1 + 1e-12;    // above the rounding of sums of thousands of terms
constexpr int kColumns = kNamedErrors + kMovingStates;  // intervals that a period adds
constexpr int kKinds = 3 + kMovingStates;  // of them: torques about an axis, coordinates

ErrorVector sums(const ErrorColumns& intervals) {
  if (intervals.cols() == 0) return ErrorVector::Zero();
  return intervals.cwiseAbs().rowwise().sum();
}

ErrorVector ball_sums(const ErrorColumns& balls) {
  ErrorVector out = ErrorVector::Zero();
  for (Eigen::Index k = 0; k + 2 < balls.cols(); k += 3) {
    out += balls.middleCols<3>(k).rowwise().norm();
  }
  return out;
}

void append(ErrorColumns& to, const ErrorColumns& more) {
  const Eigen::Index before = to.cols();
  to.conservativeResize(Eigen::NoChange, before + more.cols());
  to.rightCols(more.cols()) = more;
}

ErrorColumns box_columns(const ErrorVector& box) {  // one for each row that is not 0
  ErrorColumns out = ErrorColumns::Zero(kErrorRows, (box.array() > 0).count());
  Eigen::Index at = 0;
  for (int i = 0; i < kErrorRows; ++i) {
    if (box[i] > 0) out(i, at++) = box[i];
  }
  return out;
}

// Lift, velocity and heading are slow; what is fast soon follows them.
constexpr std::array<int, 7> kSlow = {0, 1, 2, 3, 4, 5, 9};
using SlowRows = Eigen::Matrix<double, kSlow.size(), Eigen::Dynamic>;

// The slow coordinates of the columns, each divided by its bound.
SlowRows slow_rows(const ErrorColumns& columns, const ErrorVector& box) {
  SlowRows out(kSlow.size(), columns.cols());
  for (std::size_t i = 0; i < kSlow.size(); ++i) {
    out.row(i) = columns.row(kSlow[i]) / std::max(box[kSlow[i]], 1e-300);
  }
  return out;
}

// How the fast coordinates follow the slow ones: least squares over the columns.
ErrorColumns ties(const ErrorColumns& columns, const SlowRows& slow) {
  Eigen::Matrix<double, kSlow.size(), kSlow.size()> gram = slow * slow.transpose();
  gram.diagonal().array() += 1e-9 * gram.trace() + 1e-300;
  ErrorColumns out = gram.ldlt().solve(slow * columns.transpose()).transpose();
  for (const int row : kSlow) out.row(row).setZero();
  return out;
}

// Few intervals around many: a box over the slow coordinates, to which the fast ones are tied (any
// tie is sound), and a box for what is left of those.
ErrorColumns around(const ErrorColumns& columns) {
  const ErrorVector box = sums(columns);
  const SlowRows slow = slow_rows(columns, box);
  ErrorColumns out = ties(columns, slow);
  if (!out.allFinite()) return box_columns(kUp * box);
  ErrorVector rest = sums(columns - out * slow);
  for (std::size_t i = 0; i < kSlow.size(); ++i) {
    out(kSlow[i], i) = box[kSlow[i]];
    rest[kSlow[i]] = 0;
  }
  out *= kUp;
  append(out, box_columns(kUp * rest + 1e-12 * box));
  return out;
}

// One ball for neighbouring ones, their sum, and a box for how they differ from their mean.
void add_up(const ErrorColumns& balls, ErrorTerms& to, ErrorColumns& rest) {
  const Eigen::Index count = balls.cols() / 3;
  ErrorColumns sum = ErrorColumns::Zero(kErrorRows, 3);
  for (Eigen::Index k = 0; k < count; ++k) sum += balls.middleCols<3>(3 * k);
  ErrorColumns differ = balls;
  for (Eigen::Index k = 0; k < count; ++k) {
    differ.middleCols<3>(3 * k) -= sum / static_cast<double>(count);
  }
  append(to.balls, sum);
  append(rest, box_columns(kUp * ball_sums(differ)));
}

// The same for intervals: those of a kind are added up. `columns` are of whole periods.
ErrorColumns add_up_kinds(ErrorColumns& columns) {
  const auto kind = [](Eigen::Index column) {
    const Eigen::Index k = column % kColumns;
    return k < kNamedErrors ? k % 3 : 3 + k - kNamedErrors;
  };
  ErrorColumns sum = ErrorColumns::Zero(kErrorRows, kKinds);
  Eigen::VectorXd count = Eigen::VectorXd::Zero(kKinds);
  for (Eigen::Index k = 0; k < columns.cols(); ++k)
    sum.col(kind(k)) += columns.col(k), ++count[kind(k)];
  for (Eigen::Index k = 0; k < columns.cols(); ++k)
    columns.col(k) -= sum.col(kind(k)) / count[kind(k)];
  return sum;
}

// An upper bound on the largest stretch of a 3 x 3 matrix: Gershgorin's for k^T k.
double stretch(const Eigen::Matrix3d& k) {
  const Eigen::Matrix3d square = k.transpose() * k;
  return std::sqrt(square.cwiseAbs().rowwise().sum().maxCoeff());
}

}  // namespace

ErrorSet::ErrorSet(ErrorTerms held, const ErrorVector& box) : held_(std::move(held)) {
  oldest_.push_back({ErrorColumns(kErrorRows, 0), box_columns(box)});
}

void ErrorSet::advance(const ErrorMatrix& map, const PeriodErrors& added) {
  const auto move = [&](ErrorTerms& terms) {
    terms.balls = (map * terms.balls).eval();
    terms.intervals = (map * terms.intervals).eval();
  };
  move(held_);
  for (auto* level : {&periods_, &joined_, &old_, &oldest_}) {
    for (ErrorTerms& terms : *level) move(terms);
  }
  ErrorTerms terms{added.gust, ErrorColumns::Zero(kErrorRows, kColumns)};
  terms.intervals.leftCols<kNamedErrors>() = added.named;
  for (int i = 0; i < kMovingStates; ++i) terms.intervals(i, kNamedErrors + i) = added.box[i];
  periods_.push_back(std::move(terms));
  if (periods_.size() >= 2 * kJoined) join_periods();
  if (joined_.size() >= 2 * kBatches) join_batches();
  if (old_.size() >= 2 * kOldest) box_old();
}

void ErrorSet::join_periods() {
  ErrorTerms joined;
  ErrorColumns columns(kErrorRows, 0);
  ErrorColumns rest(kErrorRows, 0);
  for (int from = 0; from < kJoined; from += kGusts) {
    ErrorColumns balls(kErrorRows, 0);
    for (int k = 0; k < kGusts; ++k) {
      append(balls, periods_.front().balls);
      append(columns, periods_.front().intervals);
      periods_.pop_front();
    }
    add_up(balls, joined, rest);
  }
  joined.intervals = add_up_kinds(columns);
  append(columns, rest);
  append(joined.intervals, around(columns));
  joined_.push_back(std::move(joined));
}

void ErrorSet::join_batches() {
  ErrorTerms old;
  ErrorColumns columns(kErrorRows, 0);
  for (std::size_t k = 0; k < kBatches; ++k) {
    append(old.balls, joined_.front().balls);
    append(columns, joined_.front().intervals);
    joined_.pop_front();
  }
  old.intervals = around(columns);
  old_.push_back(std::move(old));
}

// A box for the oldest. The sum of balls is within that of their columns as intervals.
void ErrorSet::box_old() {
  ErrorColumns columns(kErrorRows, 0);
  for (std::size_t k = 0; k < kOldest; ++k) {
    append(columns, old_.front().intervals);
    append(columns, old_.front().balls);
    old_.pop_front();
  }
  oldest_.push_back({ErrorColumns(kErrorRows, 0), around(columns)});
  if (oldest_.size() <= 2) return;
  ErrorColumns both = oldest_[0].intervals;
  append(both, oldest_[1].intervals);
  oldest_.pop_front();
  oldest_.front().intervals = around(both);
}

ErrorVector ErrorSet::bounds() const {
  ErrorVector out = ErrorVector::Zero();
  each([&](const ErrorTerms& t) { out += sums(t.intervals) + ball_sums(t.balls); });
  return kUp * out;
}

double ErrorSet::bound(const ErrorVector& form) const {
  double out = 0;
  each([&](const ErrorTerms& t) {
    if (t.intervals.cols() > 0) out += (form.transpose() * t.intervals).cwiseAbs().sum();
    const Eigen::RowVectorXd image = form.transpose() * t.balls;
    for (Eigen::Index k = 0; k + 2 < image.size(); k += 3) out += image.segment<3>(k).norm();
  });
  return kUp * out;
}

double ErrorSet::reach(const Eigen::Matrix<double, 3, kErrorRows>& map) const {
  geom::Vec3 intervals = geom::Vec3::Zero();
  double balls = 0;
  each([&](const ErrorTerms& t) {
    if (t.intervals.cols() > 0) intervals += (map * t.intervals).cwiseAbs().rowwise().sum();
    for (Eigen::Index k = 0; k + 2 < t.balls.cols(); k += 3) {
      balls += stretch(map * t.balls.middleCols<3>(k));
    }
  });
  return kUp * (intervals.norm() + balls);
}

}  // namespace traj
