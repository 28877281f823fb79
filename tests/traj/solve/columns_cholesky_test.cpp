// libtraj/src/solve/columns_cholesky.h against Eigen's Cholesky.

#include "solve/columns_cholesky.h"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>

#include "traj/scenes.h"

namespace traj {
namespace {

template <int kColumns, int kRows>
using Columns = Eigen::Matrix<double, kRows, kColumns>;

// Of a positive definite matrix, and random rows below it.
template <int kColumns, int kRows>
Columns<kColumns, kRows> random_columns(testing::Random& random) {
  using Square = Eigen::Matrix<double, kColumns, kColumns>;
  Square root;
  for (double& v : root.reshaped()) v = random.number(-1, 1);
  Columns<kColumns, kRows> out;
  for (double& v : out.reshaped()) v = random.number(-1, 1);
  out.template topRows<kColumns>() = root * root.transpose() + 0.1 * Square::Identity();
  return out;
}

template <int kColumns, int kRows>
void expect_as_eigen(testing::Random& random) {
  using Eliminated = ColumnsCholesky<kColumns, kRows>;
  const auto given = random_columns<kColumns, kRows>(random);
  auto wide = given;
  auto plain = given;
  ASSERT_TRUE(
      with_four_lanes([&]() SKYWAY_FOUR_LANES { return Eliminated::eliminate(wide.data()); }));
  ASSERT_TRUE(Eliminated::eliminate(plain.data()));
  EXPECT_TRUE(std::equal(wide.data(), wide.data() + wide.size(), plain.data()));
  const Eigen::LLT<Eigen::Matrix<double, kColumns, kColumns>> llt(
      given.template topRows<kColumns>());
  const Eigen::MatrixXd lower = llt.matrixL();
  for (int j = 0; j < kColumns; ++j) {
    for (int i = j; i < kColumns; ++i) EXPECT_NEAR(wide(i, j), lower(i, j), 1e-11);
  }
  constexpr int kBelow = kRows - kColumns;
  const Eigen::MatrixXd below = wide.template bottomRows<kBelow>() * lower.transpose();
  EXPECT_TRUE(below.isApprox(given.template bottomRows<kBelow>(), 1e-10));
}

TEST(ColumnsCholesky, IsEigensWithAndWithoutLanes) {
  testing::Random random(1);
  for (int n = 0; n < 200; ++n) {
    expect_as_eigen<2, 4>(random);
    expect_as_eigen<13, 32>(random);
    expect_as_eigen<24, 28>(random);
  }
}

TEST(ColumnsCholesky, RefusesWhatIsNotPositiveDefinite) {
  testing::Random random(2);
  for (const double pivot : {0.0, -1.0, std::nan("")}) {
    for (int j = 0; j < 13; ++j) {
      auto columns = random_columns<13, 32>(random);
      columns(j, j) = pivot;
      EXPECT_FALSE((ColumnsCholesky<13, 32>::eliminate(columns.data()))) << j;
    }
  }
}

TEST(ColumnsCholesky, DoesWhatItsExampleSays) {
  std::array<double, 8> a = {4, 2, 6, 0, 0, 5, 7, 0};
  ASSERT_TRUE((ColumnsCholesky<2, 4>::eliminate(a.data())));
  EXPECT_EQ((std::array{a[0], a[1], a[2], a[5], a[6]}), (std::array{2.0, 1.0, 3.0, 2.0, 2.0}));
}

}  // namespace
}  // namespace traj
