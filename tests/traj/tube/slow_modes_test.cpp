#include "tube/slow_modes.h"

#include <gtest/gtest.h>

#include "traj/flight/vehicle_profile.h"
#include "tube/cascade_step.h"
#include "tube/period_symbols.h"

namespace traj {
namespace {

using Rows = CascadeRows;

// 20 ms of hover with a heading, in which every loop runs at its place.
ErrorMatrixOf<Rows> hover_of(const CascadeLoop& loop, double yaw) {
  ErrorVectorOf<Rows> middle = ErrorVectorOf<Rows>::Zero();
  middle[2] = 9.80665;
  middle.segment<Rows::kStates - Rows::kLightness>(Rows::kLightness).setOnes();
  const ErrorSetOf<Rows> errors({}, ErrorVectorOf<Rows>::Zero());
  const PeriodSymbolsOf<Rows> symbols(loop.model, symbol_sizes(loop.model, errors));
  ErrorMatrixOf<Rows> out = ErrorMatrixOf<Rows>::Identity();
  for (long n = 0; n < 20; n += 4) {
    const CascadeReferences references{std::vector<Reference>(5, Reference{.yaw = yaw}),
                                       Vec3::Zero(), n};
    out = symbols.map(cascade_step(loop, symbols.state(middle), references).state).map * out;
  }
  return out;
}

// A form after the map is a sum of the forms before it, and all of them are slow.
TEST(SlowModes, AreHardlyMixedByTheLoop) {
  for (const std::string_view vehicle : {"quad2kg", "crazyflie"}) {
    const auto profile = vehicle_named(vehicle);
    const CascadeLoop loop{*quadrotor_of(profile->airframe), *profile->airframe.gains, {}, {}};
    for (const double yaw : {0.0, 0.7}) {
      ErrorMatrixOf<Rows> map = hover_of(loop, yaw);
      const auto forms = slow_modes(map, yaw, 20);
      ASSERT_GT(forms.rows(), 8) << vehicle;
      EXPECT_LT(forms.rows(), Rows::kGust) << vehicle;
      map.rightCols<Rows::kPadded - Rows::kGust>().setZero();
      const Eigen::MatrixXd after = (forms * map).transpose();
      const Eigen::MatrixXd before = forms.transpose();
      const Eigen::MatrixXd mix = before.householderQr().solve(after);
      EXPECT_LT((before * mix - after).norm(), 1e-3 * after.norm()) << vehicle << " " << yaw;
      EXPECT_GT(mix.diagonal().cwiseAbs().minCoeff(), 0.5) << vehicle;
    }
  }
}

}  // namespace
}  // namespace traj
