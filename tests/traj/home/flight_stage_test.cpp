#include "traj/home/flight_stage.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "geom/shape/hull.h"
#include "support/cases.h"
#include "support/random_city.h"
#include "traj/mission/formats/wpl.h"
#include "traj/mission/mavlink/mission_flight.h"
#include "traj/scenes.h"

namespace traj {
namespace {

using support::Random;

constexpr double kHair = 1e-7;  // m, m/s: for the rounding of the oracles

bool holds(const std::vector<Vec3>& hull, const Vec3& p) {
  const Vec3 hair = Vec3::Constant(kHair);
  return geom::hull_meets(hull, {p - hair, p + hair}).has_value();
}

bool may_move(const FlightStage& stage, const Vec3& velocity) {
  std::vector<Vec3> hull{Vec3::Zero()};
  for (const Velocity& one : stage.velocity) hull.push_back(one.value);
  return holds(hull, velocity);
}

bool is_in_time(const FlightStage& stage, double time) {
  return stage.from <= time + kHair && time - kHair <= stage.until;
}

// A random point of the hull: any weights, some of them 0.
Vec3 inside(Random& random, const std::vector<Vec3>& hull) {
  Vec3 at = Vec3::Zero();
  double sum = 0;
  for (const Vec3& p : hull) {
    const double weight = std::pow(random.uniform(0, 1), 4);
    at += weight * p;
    sum += weight;
  }
  return at / sum;
}

// When the point of the legs is passed that is nearest to the place. Of equals, any.
std::vector<double> times_passed(const std::vector<TimedLeg>& legs, const Vec3& p) {
  double least = std::numeric_limits<double>::infinity();
  std::vector<std::pair<double, double>> passed;  // distance and time
  for (const TimedLeg& leg : legs) {
    const Vec3 way = leg.b - leg.a;
    const double length = way.squaredNorm();
    const double share = length > 0 ? std::clamp((p - leg.a).dot(way) / length, 0.0, 1.0) : 0;
    const double away = (leg.a + share * way - p).norm();
    passed.emplace_back(away, leg.from + share * (leg.until - leg.from));
    least = std::min(least, away);
  }
  std::vector<double> out;
  for (const auto& [away, time] : passed) {
    if (away <= least) out.push_back(time);
  }
  return out;
}

FlownMission mission_of_text(Random& random) {
  const auto place = [&] {
    return fmt::format("{:.7f}\t{:.7f}\t{:.3f}\t1\n", 47 + random.uniform(-1e-3, 1e-3),
                       8 + random.uniform(-1e-3, 1e-3), random.uniform(20, 60));
  };
  std::string text = "QGC WPL 110\n0\t1\t0\t16\t0\t0\t0\t0\t47\t8\t400\t1\n";
  text += "1\t0\t3\t22\t0\t0\t0\t0\t47\t8\t30\t1\n";
  int line = 2;
  for (int i = 2 + random.below(4); i > 0; --i) {
    text += fmt::format("{}\t0\t3\t16\t{}\t{}\t0\t0\t", line++, random.below(3) * 2,
                        random.below(2) * 4) +
            place();
  }
  text += random.below(2) ? fmt::format("{}\t0\t3\t20\t0\t0\t0\t0\t0\t0\t0\t1\n", line)
                          : fmt::format("{}\t0\t3\t21\t0\t0\t0\t0\t", line) + place();
  std::istringstream in(text);
  MissionRules rules;
  rules.return_height = 50;
  return flown_mission(read_wpl(in, "mission"), {{47, 8, 400}, 0}, rules, "mission");
}

TEST(StagesOfTrajectory, HoldPositionAndVelocityOfEachInstant) {
  for (unsigned seed = 0; seed < 20; ++seed) {
    const Trajectory trajectory = testing::random_trajectory(seed);
    const auto stages = stages_of(trajectory);
    ASSERT_EQ(stages.size(), trajectory.segments.size());
    EXPECT_EQ(stages.front().from, 0);
    EXPECT_EQ(stages.back().until, duration(trajectory));
    for (std::size_t i = 0; i < stages.size(); ++i) {
      if (i > 0) {
        EXPECT_EQ(stages[i].from, stages[i - 1].until);
      }
      for (int k = 0; k <= 20; ++k) {
        const double t = trajectory.segments[i].duration * k / 20;
        const State state = evaluate(trajectory.segments[i], t);
        EXPECT_TRUE(holds(stages[i].where, state.position));
        EXPECT_TRUE(may_move(stages[i], state.velocity));
      }
    }
  }
}

// Of a curve, halved again and again: the part whose time has an instant holds what it flies then.
TEST(HalvesOfCurve, HoldPositionAndVelocityAtTheirTimes) {
  Random random(1);
  for (int i = 0; i < support::cases(200); ++i) {
    const Trajectory trajectory = testing::random_trajectory(static_cast<unsigned>(i), 1);
    FlightStage stage = stages_of(trajectory).front();
    for (int depth = 0; depth < 8; ++depth) {
      const auto parts = halves(stage);
      ASSERT_TRUE(parts);
      EXPECT_EQ(parts->first.from, stage.from);
      EXPECT_EQ(parts->first.until, parts->second.from);
      EXPECT_EQ(parts->second.until, stage.until);
      for (const FlightStage& part : {parts->first, parts->second}) {
        const double t = random.uniform(part.from, part.until);
        const State state = evaluate(trajectory, t);
        EXPECT_TRUE(holds(part.where, state.position)) << "case " << i << " depth " << depth;
        EXPECT_TRUE(may_move(part, state.velocity));
      }
      stage = random.below(2) ? parts->first : parts->second;
    }
    EXPECT_LT(extent(stage), extent(stages_of(trajectory).front()) / 8);
  }
}

// Of a mission's regions: each place is in one of the parts, at the time when it is passed.
TEST(HalvesOfRegion, HoldAllPlacesWithTheirTimes) {
  Random random(2);
  for (int i = 0; i < support::cases(40); ++i) {
    const FlownMission mission = mission_of_text(random);
    for (const Drift& drift : mission.drift) {
      for (const FlightStage& whole : stages_of(drift)) {
        FlightStage stage = whole;
        for (int depth = 0; depth < 5; ++depth) {
          const auto parts = halves(stage);
          if (!parts) break;
          for (int k = 0; k < 5; ++k) {
            const Vec3 p = inside(random, stage.where);
            const auto times = times_passed(stage.legs, p);
            const bool early = holds(parts->first.where, p);
            const bool late = holds(parts->second.where, p);
            ASSERT_TRUE(early || late) << "case " << i;
            bool timed = false;
            for (const double t : times) {
              timed = timed || (early && is_in_time(parts->first, t)) ||
                      (late && is_in_time(parts->second, t));
            }
            ASSERT_TRUE(timed) << "case " << i;
          }
          for (const FlightStage& part : {parts->first, parts->second}) {
            EXPECT_LE(extent(part), extent(stage) * (1 + 1e-12));
            EXPECT_EQ(part.velocity.size(), stage.velocity.size());
            EXPECT_EQ(part.stands_on, stage.stands_on);
            EXPECT_EQ(part.part, stage.part);
          }
          stage = random.below(2) ? parts->first : parts->second;
        }
      }
    }
  }
}

TEST(HalvesOfRegion, AreSmallAtLast) {
  Random random(3);
  const FlownMission mission = mission_of_text(random);
  for (const FlightStage& whole : stages_of(mission.drift.front())) {
    FlightStage stage = whole;
    for (int depth = 0; depth < 60; ++depth) {
      const auto parts = halves(stage);
      if (!parts) break;
      stage = random.below(2) ? parts->first : parts->second;
    }
    EXPECT_LT(extent(stage), 0.1);
  }
}

TEST(Halves, OfOnePlaceAreNone) {
  FlightStage stage;
  stage.where = {{1, 2, 3}};
  EXPECT_FALSE(halves(stage));
  EXPECT_FALSE(ends_of(stage));
  EXPECT_EQ(extent(stage), 0);
}

TEST(EndsOfStage, ArePlacesOfIt) {
  Random random(4);
  const FlownMission mission = mission_of_text(random);
  auto stages = stages_of(mission.drift.front());
  const auto curves = stages_of(testing::random_trajectory(1));
  stages.insert(stages.end(), curves.begin(), curves.end());
  for (const FlightStage& stage : stages) {
    const auto ends = ends_of(stage);
    if (!ends) continue;
    for (const FlightStage& end : {ends->first, ends->second}) {
      EXPECT_GE(end.from, stage.from);
      EXPECT_LE(end.until, stage.until);
      for (const Vec3& p : end.where) EXPECT_TRUE(holds(stage.where, p));
    }
  }
}

TEST(StagesOfDrift, HoldEachPlaceOfItsRegionsAndLegs) {
  Random random(5);
  for (int i = 0; i < support::cases(20); ++i) {
    const FlownMission mission = mission_of_text(random);
    ASSERT_EQ(mission.drift.size(), 2u);
    for (const Drift& drift : mission.drift) {
      const auto stages = stages_of(drift);
      const auto found = [&](const Vec3& p, double time) {
        return std::any_of(stages.begin(), stages.end(), [&](const FlightStage& stage) {
          return is_in_time(stage, time) && holds(stage.where, p);
        });
      };
      for (const Sweep& sweep : drift.sweeps) {
        if (sweep.part.manoeuvre == Manoeuvre::return_home) continue;
        const Vec3 p = inside(random, sweep.hull);
        EXPECT_TRUE(std::any_of(stages.begin(), stages.end(),
                                [&](const FlightStage& stage) { return holds(stage.where, p); }));
      }
      for (std::size_t k = 0; k < drift.legs.size(); ++k) {
        const TimedLeg& leg = drift.legs[k];
        if (leg.part.manoeuvre == Manoeuvre::return_home) continue;
        const double share = random.uniform(0, 1);
        EXPECT_TRUE(
            found(leg.a + share * (leg.b - leg.a), leg.from + share * (leg.until - leg.from)));
        if (k + 1 == drift.legs.size() || drift.legs[k + 1].from <= leg.until) continue;
        EXPECT_TRUE(found(leg.b, 0.5 * (leg.until + drift.legs[k + 1].from)));  // it waits
      }
    }
  }
}

TEST(StagesOfDrift, LeaveTheReturnOut) {
  Random random(6);
  for (int i = 0; i < 20; ++i) {
    for (const Drift& drift : mission_of_text(random).drift) {
      for (const FlightStage& stage : stages_of(drift)) {
        EXPECT_NE(stage.part.manoeuvre, Manoeuvre::return_home);
      }
    }
  }
}

// Where it waits beside a point, it may be beyond the point for as long as the wait lasts.
TEST(StagesOfDrift, BesideAHoldLastAsLongAsTheHold) {
  Drift drift;
  drift.legs = {{{0, 0, 30}, {100, 0, 30}, 0, 10, {1, Manoeuvre::leg}},
                {{100, 0, 30}, {100, 100, 30}, 25, 35, {2, Manoeuvre::leg}}};
  const Sweep beyond{
      {{100, 0, 30}, {104, 0, 30}, {100, 9, 30}}, {1, Manoeuvre::overshoot}, {}, Motion{0, 1, {}}};
  drift.sweeps = {beyond};
  const FlightStage stage = stages_of(drift).front();
  EXPECT_LE(stage.from, 10);
  EXPECT_GE(stage.until, 25);
  FlightStage corner = stage;
  for (int depth = 0; depth < 6; ++depth) {  // the part around the furthest place beyond the point
    const auto parts = halves(corner);
    ASSERT_TRUE(parts);
    corner = holds(parts->first.where, {104, 0, 30}) ? parts->first : parts->second;
  }
  EXPECT_LE(corner.from, 10 + kHair);
  EXPECT_GE(corner.until, 25 - kHair);
}

TEST(StagesOfLegs, FlyTheLegsAtTheirSpeedAndWait) {
  FlownMission mission;
  mission.path = {{0, 0, 20}, {40, 0, 20}, {40, 0, 40}};
  mission.hold = {1, 2, 0};
  mission.climb = 2;
  mission.ends.takeoff_from = 0.0;
  const auto stages = stages_of(mission, 4);
  const auto at = [&](double time, const Vec3& p, const Vec3& velocity) {
    return std::any_of(stages.begin(), stages.end(), [&](const FlightStage& stage) {
      return is_in_time(stage, time) && holds(stage.where, p) && may_move(stage, velocity);
    });
  };
  EXPECT_TRUE(at(5, {0, 0, 10}, {0, 0, 2}));     // up, 10 s
  EXPECT_TRUE(at(10.5, {0, 0, 20}, {0, 0, 0}));  // 1 s
  EXPECT_TRUE(at(16, {20, 0, 20}, {4, 0, 0}));   // 10 s
  EXPECT_TRUE(at(22, {40, 0, 20}, {0, 0, 0}));   // 2 s
  EXPECT_TRUE(at(28, {40, 0, 30}, {0, 0, 2}));   // 10 s
  EXPECT_EQ(stages.front().stands_on, 0.0);
  double until = 0;
  for (const FlightStage& stage : stages) until = std::max(until, stage.until);
  EXPECT_DOUBLE_EQ(until, 33);

  const std::vector<TimedPlace> timeline = timeline_of(mission, 4);
  EXPECT_EQ(timeline.front().time, 0);
  EXPECT_EQ(timeline.front().place, Vec3(0, 0, 0));
  EXPECT_DOUBLE_EQ(timeline.back().time, until);
  for (const TimedPlace& one : timeline) EXPECT_TRUE(at(one.time, one.place, {0, 0, 0}));
  const auto between = [&](std::size_t i) {
    return at((timeline[i].time + timeline[i + 1].time) / 2,
              (timeline[i].place + timeline[i + 1].place) / 2, {0, 0, 0});
  };
  for (std::size_t i = 0; i + 1 < timeline.size(); ++i) EXPECT_TRUE(between(i)) << i;
}

TEST(Timeline, LeavesTheWayBackHomeOut) {
  Drift drift;
  drift.legs = {{{0, 0, 0}, {0, 0, 20}, 0, 10, {0, Manoeuvre::climb}},
                {{0, 0, 20}, {80, 0, 20}, 12, 32, {1, Manoeuvre::leg}},
                {{80, 0, 20}, {0, 0, 20}, 32, 52, {2, Manoeuvre::return_home}}};
  const std::vector<TimedPlace> timeline = timeline_of(drift);
  ASSERT_EQ(timeline.size(), 4u);
  EXPECT_EQ(timeline[1].time, 10);
  EXPECT_EQ(timeline[2].time, 12);
  EXPECT_EQ(timeline[2].place, Vec3(0, 0, 20));
  EXPECT_EQ(timeline.back().time, 32);
}

}  // namespace
}  // namespace traj
