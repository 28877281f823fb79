#include "traj/home/contingency_proof.h"

#include <gtest/gtest.h>

#include <limits>
#include <nlohmann/json.hpp>

#include "geom/base/error.h"
#include "support/random_city.h"
#include "traj/home/home_case.h"
#include "traj/home/home_flight.h"

namespace traj {
namespace {

using testing::path_of;
using testing::small_vehicle;
using testing::task_of;

struct Case : testing::FlightPastABlock {
  ContingencyRules rules{.models = task.models};
  std::vector<ContingencyRecord> records =
      contingency_records("q1", ways_home(scene, stages, task), task, {});
  std::vector<ProvedWay> ways = proved_ways(scene, stages, records, rules);

  ExactResult exact() const {
    return check_exactly(ExactTask{scene.map(), scene.vehicle(), scene.margin()}, stages, ways);
  }
};

TEST(ProvedWays, AreThoseOfTheRecordsThatHold) {
  Case c;
  ASSERT_EQ(c.ways.size(), c.records.size());
  for (std::size_t i = 0; i < c.ways.size(); ++i) {
    EXPECT_EQ(c.ways[i].record.points, c.records[i].points);
    EXPECT_EQ(c.ways[i].joins.front().from, c.records[i].from);
    EXPECT_GE(c.ways[i].joins.back().until, c.records[i].until);
    EXPECT_EQ(c.ways[i].beyond.size() + 2, c.records[i].points.size());
  }
  c.records.front().points.front() = Vec3(42, 10, 5);  // in the block
  EXPECT_EQ(proved_ways(c.scene, c.stages, c.records, c.rules).size() + 1, c.records.size());
}

TEST(CheckContingenciesExactly, AcceptsWhatHolds) { EXPECT_TRUE(Case().exact().ok); }

TEST(CheckContingenciesExactly, RefusesWhatIsNotClear) {
  Case leg;
  ProvedWay& way = leg.ways.front();
  const Vec3 in_block(42, 10, 5);
  way.record.points.insert(way.record.points.begin(), in_block);
  way.beyond.insert(way.beyond.begin(), Prism{{in_block.head<2>()}, 5, 5});
  EXPECT_EQ(leg.exact().reason, Reason::collision);
  EXPECT_EQ(leg.exact().box, 0u);
  Case braking;
  braking.ways.front().joins.front().braking.plan = {{0, 0}, {60, 0}, {60, 60}, {0, 60}};
  EXPECT_NE(braking.exact().reason, Reason::none);
  Case high;
  high.ways.front().joins.front().braking.high = 60;
  EXPECT_EQ(high.exact().reason, Reason::bounds);
  Case beyond;
  beyond.ways.front().joins.front().beyond.low = -1;
  EXPECT_EQ(beyond.exact().reason, Reason::bounds);
}

TEST(CheckContingenciesExactly, RefusesAFlightBesideItsRegions) {
  Case c;
  c.ways.front().joins.front().braking.plan = {{11, 50}, {12, 50}};
  EXPECT_EQ(c.exact().reason, Reason::return_home);
  Case moved;
  moved.stages.front().curve->point[3].y() += 40;
  EXPECT_EQ(moved.exact().reason, Reason::return_home);
  Case elsewhere;
  elsewhere.ways.front().joins.front().beyond = {{{1, 1}}, 5, 5};
  EXPECT_EQ(elsewhere.exact().reason, Reason::return_home) << "beyond another point";
}

TEST(CheckContingenciesExactly, RefusesATimeWithoutAWay) {
  Case first;
  first.ways.erase(first.ways.begin());
  EXPECT_EQ(first.exact().reason, Reason::return_home);
  EXPECT_EQ(first.exact().time, 0);
  Case gap;
  gap.ways.back().joins.pop_back();
  EXPECT_EQ(gap.exact().reason, Reason::return_home);
  Case none;
  none.ways.clear();
  EXPECT_EQ(none.exact().reason, Reason::return_home);
}

TEST(CheckContingenciesExactly, RefusesWhatIsNoNumber) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto throws = [](const auto& change) {
    Case c;
    change(c);
    EXPECT_THROW(c.exact(), geom::InputError);
  };
  throws([&](Case& c) { c.ways.front().joins.front().from = nan; });
  throws([&](Case& c) { c.ways.front().joins.front().beyond.high = nan; });
  throws([&](Case& c) { c.ways.front().record.points.front().x() = nan; });
  throws([&](Case& c) { c.stages.front().curve->point[3].y() = nan; });
  throws([&](Case& c) { c.stages.front().until = nan; });
}

TEST(CheckContingenciesExactly, RefusesALandingThatIsNone) {
  for (const Vec3& ground : {Vec3(90, 50, 1), Vec3(90, 51, 0), Vec3(90, 50, -1)}) {
    Case c;
    for (ProvedWay& way : c.ways) way.record.points.back() = ground;
    EXPECT_EQ(c.exact().reason, Reason::landing) << ground.transpose();
  }
}

// The exact check sees a box that is a hair's breadth nearer than the vehicle needs.
TEST(CheckContingenciesExactly, AcceptsEveryRandomPlanAndNoBoxPutIntoIt) {
  int put = 0;
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    support::Random random(seed + 90);
    const auto scene = small_vehicle(support::random_city(seed, 60, 150));
    const WaysTask task = task_of(scene, {{-130, -130}, {130, 130}});
    const auto somewhere = [&] {
      return Vec3(random.uniform(-70, 70), random.uniform(-70, 70), random.uniform(60, 80));
    };
    const auto stages = stages_of(path_of({somewhere(), somewhere(), somewhere()}), 5);
    const WaysHome home = ways_home(scene, stages, task);
    if (!home.gaps.empty()) continue;
    const ContingencyRules rules{.models = task.models};
    const auto ways = proved_ways(scene, stages, contingency_records("q", home, task, {}), rules);
    const auto checked = [&](const geom::BoxMap& map) {
      return check_exactly(ExactTask{map, scene.vehicle(), scene.margin()}, stages, ways);
    };
    ASSERT_TRUE(checked(scene.map()).ok) << "seed " << seed;
    const ProvedWay& way = ways[random.below(ways.size())];
    const ProvedJoin& join = way.joins[random.below(way.joins.size())];
    const double share = random.uniform(0, 1);
    const Vec3 corner = corners(join.braking).front();
    const Vec3 place = corner + share * (way.record.points.front() - corner);
    std::vector<geom::Aabb> boxes = {{place - Vec3(0.2, 0.2, 0.2), place + Vec3(0.2, 0.2, 0.2)}};
    EXPECT_FALSE(checked(geom::BoxMap(scene.map().spec(), support::table_of(boxes))).ok) << seed;
    ++put;
  }
  EXPECT_GT(put, 10);
}

TEST(ContingencyCertificate, SaysWhatItStandsOn) {
  Case c;
  c.rules.energy = Energy{.capacity = 1e6, .power = 100};
  const HomeFlight flight{.id = "q1", .provenance = {}, .stages = c.stages, .kind = "path"};
  const auto line =
      nlohmann::json::parse(contingency_certificate_line(c.scene, flight, c.ways, c.rules));
  EXPECT_EQ(line["type"], "contingencies");
  EXPECT_EQ(line["flying_time"], 1e4);
  EXPECT_EQ(line["autopilot"], "plain");
  EXPECT_EQ(line["ways"].size(), c.ways.size());
  EXPECT_GT(line["half"][0], 0.6);
}

}  // namespace
}  // namespace traj
