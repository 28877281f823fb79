#include "traj/home/check_contingencies.h"

#include <gtest/gtest.h>

#include "support/random_city.h"
#include "traj/home/home_case.h"
#include "traj/home/home_flight.h"

namespace traj {
namespace {

using testing::path_of;
using testing::small_vehicle;
using testing::task_of;

// A flight past a block whose ways home go over it, and what skyway-plan writes of it.
struct Case : testing::FlightPastABlock {
  ContingencyRules rules{.models = task.models};

  Case() {
    task.energy = rules.energy = Energy{.capacity = 1e6, .power = 100, .wind = 1};
    records = contingency_records("q1", ways_home(scene, stages, task), task, {});
  }
  CheckResult check() const {
    return check_contingencies(scene, "q1", stages, records, rules).result;
  }

  std::vector<ContingencyRecord> records;
};

TEST(CheckContingencies, AcceptWhatWasPlanned) {
  Case c;
  ASSERT_GT(c.records.size(), 1u);
  EXPECT_TRUE(c.check().ok);
  EXPECT_EQ(c.check().reason, Reason::none);
  std::reverse(c.records.begin(), c.records.end());
  EXPECT_TRUE(c.check().ok) << "in any order";
}

TEST(CheckContingencies, WantAWayFromEveryInstant) {
  Case c;
  c.records.erase(c.records.begin());
  EXPECT_EQ(c.check().reason, Reason::return_home);
  EXPECT_EQ(c.check().time, 0);
  Case late;
  late.records.back().until -= 0.5;
  late.records.back().latest_departure = late.records.back().until;
  EXPECT_EQ(late.check().reason, Reason::return_home);
  EXPECT_EQ(late.check().time, late.records.back().until);
  EXPECT_NEAR(late.check().worst, 0.5, 1e-9) << "seconds without a way";
  late.records.clear();
  EXPECT_EQ(late.check().reason, Reason::return_home);
}

TEST(CheckContingencies, RefuseAWayThatTouches) {
  Case through;
  through.records.front().points = {{30, 50, 10}, {90, 50, 10}, {90, 50, 5}, {90, 50, 0}};
  EXPECT_EQ(through.check().reason, Reason::collision);
  Case joined;  // the way is clear, but the straight way to it is not
  for (ContingencyRecord& record : joined.records) {
    record.points = {{60, 50, 10}, {90, 50, 5}, {90, 50, 0}};
  }
  EXPECT_EQ(joined.check().reason, Reason::collision);
  EXPECT_EQ(joined.check().time, 0);
}

TEST(CheckContingencies, RefuseATimeThatIsTooLong) {
  Case c;
  ASSERT_NE(c.records[0].points, c.records[1].points);
  c.records.resize(1);
  c.records[0].until = c.stages.back().until;
  c.records[0].latest_departure = c.records[0].until;
  // The first way is joined from the left of the block, the end of the flight is to its right.
  const CheckResult result = c.check();
  EXPECT_FALSE(result.ok);
}

TEST(CheckContingencies, RefuseALandingThatIsNone) {
  for (const Vec3& ground : {Vec3(90, 50, 1), Vec3(90, 51, 0), Vec3(90, 50, -1)}) {
    Case c;
    for (ContingencyRecord& record : c.records) record.points.back() = ground;
    EXPECT_EQ(c.check().reason, Reason::landing) << ground.transpose();
  }
}

TEST(CheckContingencies, HoldTheEnergyToo) {
  Case weak;
  weak.rules.energy->capacity = 1000;
  EXPECT_EQ(weak.check().reason, Reason::endurance);
  Case windy;
  windy.rules.energy->wind = 7.9;
  windy.rules.energy->capacity = 100 * 100;
  EXPECT_EQ(windy.check().reason, Reason::endurance);
  Case silent;
  for (ContingencyRecord& record : silent.records) {
    record.latest_departure.reset();
    record.bounds_energy = false;
  }
  EXPECT_EQ(silent.check().reason, Reason::endurance) << "a record that claims none";
  silent.rules.energy.reset();
  for (ContingencyRecord& record : silent.records) record.bounds_energy = false;
  EXPECT_TRUE(silent.check().ok);
}

// A record that says itself that the battery is not enough is no way home, whoever asks.
TEST(CheckContingencies, BelieveThatTheBatteryIsNotEnough) {
  Case c;
  c.rules.energy.reset();
  EXPECT_TRUE(c.check().ok);
  const auto said = check_contingencies(c.scene, "q1", c.stages, c.records, c.rules).detail;
  EXPECT_NE(said.find("not checked"), std::string::npos);
  c.records.front().latest_departure.reset();
  EXPECT_EQ(c.check().reason, Reason::endurance);
  Case early;
  early.rules.energy.reset();
  early.records.front().latest_departure = early.records.front().until - 0.5;
  EXPECT_EQ(early.check().reason, Reason::endurance);
}

TEST(CheckContingencies, AcceptEveryRandomPlanAndRefuseItsMutants) {
  int mutants = 0;
  int refused = 0;
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    support::Random random(seed + 50);
    const auto scene = small_vehicle(support::random_city(seed, 60, 150));
    WaysTask task = task_of(scene, {{-130, -130}, {130, 130}});
    const auto somewhere = [&] {
      return Vec3(random.uniform(-70, 70), random.uniform(-70, 70), random.uniform(20, 80));
    };
    const auto stages = stages_of(path_of({somewhere(), somewhere(), somewhere()}), 5);
    const WaysHome home = ways_home(scene, stages, task);
    auto records = contingency_records("q", home, task, {});
    const ContingencyRules rules{.models = task.models};
    const auto reason = [&] {
      return check_contingencies(scene, "q", stages, records, rules).result.reason;
    };
    ASSERT_EQ(reason(), home.gaps.empty() ? Reason::none : Reason::return_home) << "seed " << seed;
    // A way through the middle of a box, or to the inside of one.
    for (ContingencyRecord& record : records) {
      if (!record.found()) continue;
      const auto box = scene.map().box(static_cast<std::size_t>(random.below(60)));
      const ContingencyRecord before = record;
      record.points.front() = 0.5 * (box.min + box.max);
      ++mutants;
      refused += reason() == Reason::collision || reason() == Reason::landing;
      record = before;
    }
  }
  EXPECT_GT(mutants, 100);
  EXPECT_EQ(refused, mutants);
}

}  // namespace
}  // namespace traj
