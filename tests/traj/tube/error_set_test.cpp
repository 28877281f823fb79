#include "tube/error_set.h"

#include <gtest/gtest.h>

#include "support/random_city.h"

namespace traj {
namespace {

using support::Random;

double sign(Random& random) { return random.uniform(0, 1) < 0.5 ? -1 : 1; }

// A map that shrinks slowly and turns, different in each period.
ErrorMatrix random_map(Random& random) {
  ErrorMatrix out = ErrorMatrix::Zero();
  for (int i = 0; i < 25; ++i) {
    out(i, i) = random.uniform(0.5, 0.99);
    out(i, (i + 1) % 25) = random.uniform(-0.1, 0.1);
    out(i, 25 + i % 4) = random.uniform(-0.02, 0.02);
  }
  for (int i = 25; i < 29; ++i) out(i, i) = 1;
  return out;
}

PeriodErrors random_errors(Random& random) {
  PeriodErrors out;
  for (int i = 0; i < 25; ++i) {
    for (int k = 0; k < 3; ++k) out.gust(i, k) = random.uniform(-0.1, 0.1);
    for (int k = 0; k < GeometricRows::kNamed; ++k) out.named(i, k) = random.uniform(-0.01, 0.01);
    out.box[i] = random.uniform(0, 0.01);
  }
  return out;
}

geom::Vec3 in_ball(Random& random, const geom::Vec3& towards) {
  geom::Vec3 v =
      random.uniform(0, 1) < 0.7 ? towards : geom::Vec3(sign(random), sign(random), sign(random));
  return v / std::max(v.norm(), 1e-12);
}

// Errors that are chosen to grow as far as they can in the next step, or by chance.
TEST(ErrorSet, HoldsWhatDisturbancesMayDo) {
  for (std::uint64_t seed = 0; seed < 6; ++seed) {
    Random random(seed);
    ErrorTerms held;
    held.balls = ErrorColumns::Zero(kErrorRows, 3);
    for (int i = 0; i < 3; ++i) held.balls(25 + i, i) = 0.4;
    held.intervals = ErrorColumns::Zero(kErrorRows, 1);
    held.intervals(28, 0) = 0.1;
    const ErrorVector box = ErrorVector::Constant(0.01).cwiseProduct(
        (ErrorVector() << ErrorVector::Ones().head<25>(), ErrorVector::Zero().tail<9>())
            .finished());
    ErrorSet set(held, box);
    if (seed >= 3) set.take_noise();
    if (seed % 2) set.box_along(ErrorSet::Forms::Random(7, kErrorRows));
    std::vector<ErrorVector> errors(12);
    for (ErrorVector& e : errors) {
      e.setZero();
      for (int i = 0; i < 25; ++i) e[i] = sign(random) * 0.01;
      e.segment<3>(25) = 0.4 * in_ball(random, geom::Vec3(1, 0, 0));
      e[28] = sign(random) * 0.1;
    }
    for (int step = 0; step < 1200; ++step) {
      const ErrorMatrix map = random_map(random);
      const PeriodErrors added = random_errors(random);
      set.advance(map, added);
      for (std::size_t k = 0; k < errors.size(); ++k) {
        ErrorVector& e = errors[k];
        const int row = static_cast<int>(k) * 2;  // the coordinate that this error makes large
        const bool greedy = k % 3 != 0;
        e = (map * e).eval();
        const double way = e[row] < 0 ? -1 : 1;
        e += added.gust * in_ball(random, way * added.gust.row(row).transpose());
        for (int i = 0; i < GeometricRows::kNamed; ++i) {
          const double s = added.named(row, i) * way < 0 ? -1 : 1;
          e += added.named.col(i) * (greedy ? s : random.uniform(-1, 1));
        }
        for (int i = 0; i < 25; ++i) {
          e[i] += added.box[i] * (greedy && i == row ? way : random.uniform(-1, 1));
        }
      }
      if (step % 37 != 0) continue;
      const ErrorVector bounds = set.bounds();
      const ErrorVector form = ErrorVector::Random();
      const Eigen::Matrix<double, 3, kErrorRows> place =
          Eigen::Matrix<double, 3, kErrorRows>::Random();
      for (const ErrorVector& e : errors) {
        EXPECT_TRUE((e.cwiseAbs().array() <= bounds.array() + 1e-14).all()) << seed << " " << step;
        EXPECT_LE(std::abs(form.dot(e)), set.bound(form));
        EXPECT_LE((place * e).norm(), set.reach(place));
      }
      EXPECT_LT(bounds.maxCoeff(), 100) << "a bound that grows without end says nothing";
    }
  }
}

// Terms whose signs alternate: their mean is nothing, and all of them may still add up.
TEST(ErrorSet, LosesNothingOfTermsThatItJoins) {
  const int periods = 2500;
  for (const int row : {0, 9, 14, 20}) {
    ErrorSet set({}, ErrorVector::Zero());
    if (row >= 14) set.take_noise();
    double all = 0;
    for (int step = 0; step < periods; ++step) {
      const double sign = step % 2 ? 1 : -1;
      PeriodErrors added;
      added.gust(row, step % 3) = 0.5 * sign;
      added.gust(3, 1) = 1;  // another row that goes on evenly
      added.named(row, 2) = 0.25 * sign;
      if (step % 3 == 0) added.named(row, 13) = 0.25;  // as what the position loop reads
      added.box[row] = 0.125;
      set.advance(ErrorMatrix::Identity(), added);
      all += step % 3 == 0 ? 1.125 : 0.875;
      ASSERT_GE(set.bounds()[row], all * (1 - 1e-9)) << row << " " << step;
      ASSERT_GE(set.bounds()[3], (step + 1) * (1 - 1e-9)) << row << " " << step;
    }
    EXPECT_LE(set.bounds()[row], 4 * all) << row;
  }
}

TEST(ErrorSet, IsExactForOneTerm) {
  ErrorTerms held;
  ErrorSet set(held, ErrorVector::Zero());
  PeriodErrors added;
  added.gust(0, 0) = 3;
  added.gust(1, 1) = 4;
  set.advance(ErrorMatrix::Identity(), added);
  EXPECT_NEAR(set.bounds()[0], 3, 1e-9);
  ErrorVector form = ErrorVector::Zero();
  form[0] = 1, form[1] = 1;
  EXPECT_NEAR(set.bound(form), 5, 1e-9);
  EXPECT_EQ(set.bounds()[2], 0);
}

}  // namespace
}  // namespace traj
