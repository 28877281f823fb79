#include "traj/home/home_flight.h"

#include <gtest/gtest.h>

#include "geom/base/usage_error.h"
#include "traj/home/home_case.h"

namespace traj {
namespace {

using testing::path_of;

TEST(StagesOfPath, LastAsLongAsItsLegsAndHolds) {
  geom::PathRecord path = path_of({{0, 0, 5}, {10, 0, 5}, {10, 0, 5}, {10, 4, 5}});
  path.hold = {1, 0, 2, 0};
  const auto stages = stages_of(path, 2);
  ASSERT_EQ(stages.size(), 4u) << "two holds, and two legs that have a length";
  double time = 0;
  for (const FlightStage& stage : stages) {
    EXPECT_EQ(stage.from, time);
    time = stage.until;
  }
  EXPECT_EQ(time, 1 + 5 + 2 + 2);
  EXPECT_TRUE(stages[0].velocity.empty());
  EXPECT_EQ(stages[1].velocity.front().value, Vec3(2, 0, 0));
  const auto parts = halves(stages[1]);
  ASSERT_TRUE(parts);
  EXPECT_EQ(parts->first.until, 3.5);
}

geom::JsonFields record(const std::string& more) {
  return {R"({"type":"path","id":"a","status":"found","points":[[0,0,5],[10,0,5]])" + more + "}",
          "p.jsonl", 1};
}

TEST(ReadHomeFlight, NeedsTheSpeedOfAPath) {
  EXPECT_EQ(read_home_flight(record(""), 4).stages.back().until, 2.5);
  const std::string vehicle = R"(,"vehicle":{"name":"v","half":[1,1,1],"limits":{"vmax_h":5}})";
  EXPECT_EQ(read_home_flight(record(vehicle), {}).stages.back().until, 2);
  EXPECT_EQ(read_home_flight(record(vehicle), 10).stages.back().until, 1);
  EXPECT_THROW(read_home_flight(record(""), {}), geom::UsageError);
}

TEST(RequireVmaxUsed, RefusesASpeedOfPathsIfThereIsNone) {
  EXPECT_THROW(require_vmax_used(5, false), geom::UsageError);
  EXPECT_NO_THROW(require_vmax_used(5, true));
  EXPECT_NO_THROW(require_vmax_used({}, false));
}

TEST(ReadHomeFlight, SaysWhyThereIsNone) {
  const geom::JsonFields none(R"({"type":"path","id":"a","status":"unreachable","points":[]})",
                              "p.jsonl", 1);
  const HomeFlight flight = read_home_flight(none, {});
  EXPECT_TRUE(flight.stages.empty());
  EXPECT_EQ(flight.without, "it has no path");
}

TEST(LeastMargin, IsWhatTheAutopilotsMayBeOff) {
  Flier flier;
  const double strays = least_margin(return_models(flier));
  EXPECT_GT(strays, 0);
  flier.navigation = Uncertainty{1, 2};
  EXPECT_NEAR(least_margin(return_models(flier)), strays + 2, 1e-9);
}

}  // namespace
}  // namespace traj
