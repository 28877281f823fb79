#include "tube/error_set.h"

#include <algorithm>

#include "tube/cascade_state.h"

namespace traj {
namespace {

constexpr int kJoined = 25;          // periods, 0.1 s
constexpr int kGusts = 5;            // periods whose gusts are added up, 20 ms
constexpr std::size_t kBatches = 5;  // 0.5 s
constexpr double kUp = 1 + 1e-12;    // above the rounding of sums of thousands of terms

// How terms grow fewer.
template <class Rows>
struct Joining {
  using ErrorVector = ErrorVectorOf<Rows>;
  using ErrorColumns = ErrorColumnsOf<Rows>;
  using ErrorTerms = ErrorTermsOf<Rows>;
  static constexpr int kErrorRows = Rows::kPadded;
  static constexpr auto& kSlow = Rows::kSlow;
  static constexpr int kColumns = Rows::kNamed + Rows::kWind;     // intervals that a period adds
  static constexpr int kKinds = Rows::kNamedKinds + Rows::kWind;  // of them

  static ErrorVector sums(const ErrorColumns& intervals) {
    if (intervals.cols() == 0) return ErrorVector::Zero();
    return intervals.cwiseAbs().rowwise().sum();
  }

  static ErrorVector ball_sums(const ErrorColumns& balls) {
    ErrorVector out = ErrorVector::Zero();
    for (Eigen::Index k = 0; k + 2 < balls.cols(); k += 3) {
      out += balls.template middleCols<3>(k).rowwise().norm();
    }
    return out;
  }

  static void append(ErrorColumns& to, const ErrorColumns& more) {
    const Eigen::Index before = to.cols();
    to.conservativeResize(Eigen::NoChange, before + more.cols());
    to.rightCols(more.cols()) = more;
  }

  static ErrorColumns box_columns(const ErrorVector& box) {  // one for each row that is not 0
    ErrorColumns out = ErrorColumns::Zero(kErrorRows, (box.array() > 0).count());
    Eigen::Index at = 0;
    for (int i = 0; i < kErrorRows; ++i) {
      if (box[i] > 0) out(i, at++) = box[i];
    }
    return out;
  }

  using SlowRows = Eigen::Matrix<double, kSlow.size(), Eigen::Dynamic>;

  // The slow coordinates of the columns, each divided by its bound.
  static SlowRows slow_rows(const ErrorColumns& columns, const ErrorVector& box) {
    SlowRows out(kSlow.size(), columns.cols());
    for (std::size_t i = 0; i < kSlow.size(); ++i) {
      out.row(i) = columns.row(kSlow[i]) / std::max(box[kSlow[i]], 1e-300);
    }
    return out;
  }

  // How the fast coordinates follow the slow ones: least squares over the columns.
  static ErrorColumns ties(const ErrorColumns& columns, const SlowRows& slow) {
    Eigen::Matrix<double, kSlow.size(), kSlow.size()> gram = slow * slow.transpose();
    gram.diagonal().array() += 1e-9 * gram.trace() + 1e-300;
    ErrorColumns out = gram.ldlt().solve(slow * columns.transpose()).transpose();
    for (const int row : kSlow) out.row(row).setZero();
    return out;
  }

  // Few intervals around many: a box over the slow coordinates, to which the fast ones are tied
  // (any tie is sound), and a box for what is left of those.
  static ErrorColumns around(const ErrorColumns& columns) {
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

  // The same along linear forms.
  template <class Forms>
  static ErrorColumns around_along(const Forms& forms, const ErrorColumns& columns) {
    const ErrorVector box = sums(columns);
    Eigen::MatrixXd slow = forms * columns;
    const Eigen::VectorXd sizes = slow.cwiseAbs().rowwise().sum().cwiseMax(1e-300);
    slow = sizes.cwiseInverse().asDiagonal() * slow;
    Eigen::MatrixXd gram = slow * slow.transpose();
    gram.diagonal().array() += 1e-9 * gram.trace() + 1e-300;
    ErrorColumns out = gram.ldlt().solve(slow * columns.transpose()).transpose();
    if (!out.allFinite()) return box_columns(kUp * box);
    const ErrorVector rest = sums(columns - out * slow);
    out *= kUp;
    append(out, box_columns(kUp * rest + 1e-12 * box));
    return out;
  }

  // One ball for neighbouring ones, their sum, and a box for how they differ from their mean.
  static void add_up(const ErrorColumns& balls, ErrorTerms& to, ErrorColumns& rest) {
    const Eigen::Index count = balls.cols() / 3;
    ErrorColumns sum = ErrorColumns::Zero(kErrorRows, 3);
    for (Eigen::Index k = 0; k < count; ++k) sum += balls.template middleCols<3>(3 * k);
    ErrorColumns differ = balls;
    for (Eigen::Index k = 0; k < count; ++k) {
      differ.template middleCols<3>(3 * k) -= sum / static_cast<double>(count);
    }
    append(to.balls, sum);
    append(rest, box_columns(kUp * ball_sums(differ)));
  }

  // The same for intervals: those of a kind, in so many periods, are added up. `columns` are of
  // whole periods.
  static ErrorColumns add_up_kinds(ErrorColumns& columns, int periods) {
    const auto kind = [](Eigen::Index column) {
      const Eigen::Index k = column % kColumns;
      return k < Rows::kNamed ? Rows::kind_of_named(static_cast<int>(k))
                              : Rows::kNamedKinds + static_cast<int>(k) - Rows::kNamed;
    };
    const Eigen::Index together = periods * kColumns;
    ErrorColumns out(kErrorRows, 0);
    for (Eigen::Index from = 0; from < columns.cols(); from += together) {
      auto part = columns.middleCols(from, together);
      ErrorColumns sum = ErrorColumns::Zero(kErrorRows, kKinds);
      Eigen::VectorXd count = Eigen::VectorXd::Zero(kKinds);
      const auto each = [&](const auto& f) {
        for (Eigen::Index k = 0; k < together; ++k) {
          if (!part.col(k).isZero(0)) f(k, kind(k));
        }
      };
      each([&](Eigen::Index k, Eigen::Index of) { sum.col(of) += part.col(k), ++count[of]; });
      each([&](Eigen::Index k, Eigen::Index of) { part.col(k) -= sum.col(of) / count[of]; });
      append(out, sum);
    }
    return out;
  }
};

// An upper bound on the largest stretch of a 3 x 3 matrix: Gershgorin's for k^T k.
double stretch(const Eigen::Matrix3d& k) {
  const Eigen::Matrix3d square = k.transpose() * k;
  return std::sqrt(square.cwiseAbs().rowwise().sum().maxCoeff());
}

}  // namespace

template <class Rows>
ErrorSetOf<Rows>::ErrorSetOf(Terms held, const Vector& box) : held_(std::move(held)) {
  Vector changing = box;
  changing.tail(Rows::kPadded - Rows::kWind).setZero();
  Joining<Rows>::append(held_.intervals, Joining<Rows>::box_columns(box - changing));
  oldest_.push_back({ErrorColumnsOf<Rows>(Rows::kPadded, 0), Joining<Rows>::box_columns(changing)});
}

template <class Rows>
ErrorColumnsOf<Rows> ErrorSetOf<Rows>::around(const ErrorColumnsOf<Rows>& columns) const {
  return forms_.rows() > 0 ? Joining<Rows>::around_along(forms_, columns)
                           : Joining<Rows>::around(columns);
}

template <class Rows>
void ErrorSetOf<Rows>::advance(const Matrix& map, const PeriodErrorsOf<Rows>& added) {
  held_.balls = (map * held_.balls).eval();
  held_.intervals = (map * held_.intervals).eval();
  // No other term has a share of what does not change.
  using Changing = Eigen::Matrix<double, Rows::kWind, Rows::kWind>;
  const Changing changing = map.template topLeftCorner<Rows::kWind, Rows::kWind>();
  const auto move = [&](ErrorColumnsOf<Rows>& columns) {
    auto rows = columns.template topRows<Rows::kWind>();
    rows = (changing * rows).eval();
  };
  for (auto* level : {&periods_, &joined_, &old_, &oldest_}) {
    for (Terms& terms : *level) move(terms.balls), move(terms.intervals);
  }
  Terms terms{added.gust, ErrorColumnsOf<Rows>::Zero(Rows::kPadded, Joining<Rows>::kColumns)};
  terms.intervals.template leftCols<Rows::kNamed>() = added.named;
  for (int i = 0; i < Rows::kWind; ++i) terms.intervals(i, Rows::kNamed + i) = added.box[i];
  periods_.push_back(std::move(terms));
  if (periods_.size() >= 2 * kJoined) join_periods();
  if (joined_.size() >= 2 * kBatches) join_batches();
  if (old_.size() >= 2 * Rows::kOldest) box_old();
}

template <class Rows>
void ErrorSetOf<Rows>::join_periods() {
  Terms joined;
  ErrorColumnsOf<Rows> columns(Rows::kPadded, 0);
  ErrorColumnsOf<Rows> rest(Rows::kPadded, 0);
  for (int from = 0; from < kJoined; from += kGusts) {
    ErrorColumnsOf<Rows> balls(Rows::kPadded, 0);
    for (int k = 0; k < kGusts; ++k) {
      Joining<Rows>::append(balls, periods_.front().balls);
      Joining<Rows>::append(columns, periods_.front().intervals);
      periods_.pop_front();
    }
    Joining<Rows>::add_up(balls, joined, rest);
  }
  joined.intervals = Joining<Rows>::add_up_kinds(columns, noisy_ ? 1 : kJoined);
  Joining<Rows>::append(columns, rest);
  Joining<Rows>::append(joined.intervals, around(columns));
  joined_.push_back(std::move(joined));
}

template <class Rows>
void ErrorSetOf<Rows>::join_batches() {
  Terms old;
  ErrorColumnsOf<Rows> columns(Rows::kPadded, 0);
  for (std::size_t k = 0; k < kBatches; ++k) {
    Joining<Rows>::append(old.balls, joined_.front().balls);
    Joining<Rows>::append(columns, joined_.front().intervals);
    joined_.pop_front();
  }
  old.intervals = around(columns);
  old_.push_back(std::move(old));
}

// A box for the oldest. The sum of balls is within that of their columns as intervals.
template <class Rows>
void ErrorSetOf<Rows>::box_old() {
  ErrorColumnsOf<Rows> columns(Rows::kPadded, 0);
  for (std::size_t k = 0; k < Rows::kOldest; ++k) {
    Joining<Rows>::append(columns, old_.front().intervals);
    Joining<Rows>::append(columns, old_.front().balls);
    old_.pop_front();
  }
  oldest_.push_back({ErrorColumnsOf<Rows>(Rows::kPadded, 0), around(columns)});
  if (oldest_.size() <= 2) return;
  ErrorColumnsOf<Rows> both = oldest_[0].intervals;
  Joining<Rows>::append(both, oldest_[1].intervals);
  oldest_.pop_front();
  oldest_.front().intervals = around(both);
}

template <class Rows>
ErrorVectorOf<Rows> ErrorSetOf<Rows>::bounds() const {
  Vector out = Vector::Zero();
  each([&](const Terms& t) {
    out += Joining<Rows>::sums(t.intervals) + Joining<Rows>::ball_sums(t.balls);
  });
  return kUp * out;
}

template <class Rows>
double ErrorSetOf<Rows>::bound(const Vector& form) const {
  double out = 0;
  each([&](const Terms& t) {
    if (t.intervals.cols() > 0) out += (form.transpose() * t.intervals).cwiseAbs().sum();
    const Eigen::RowVectorXd image = form.transpose() * t.balls;
    for (Eigen::Index k = 0; k + 2 < image.size(); k += 3)
      out += image.template segment<3>(k).norm();
  });
  return kUp * out;
}

template <class Rows>
double ErrorSetOf<Rows>::reach(const Eigen::Matrix<double, 3, Rows::kPadded>& map) const {
  geom::Vec3 intervals = geom::Vec3::Zero();
  double balls = 0;
  each([&](const Terms& t) {
    if (t.intervals.cols() > 0) intervals += (map * t.intervals).cwiseAbs().rowwise().sum();
    for (Eigen::Index k = 0; k + 2 < t.balls.cols(); k += 3) {
      balls += stretch(map * t.balls.template middleCols<3>(k));
    }
  });
  return kUp * (intervals.norm() + balls);
}

template class ErrorSetOf<GeometricRows>;
template class ErrorSetOf<CascadeRows>;

}  // namespace traj
