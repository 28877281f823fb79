#include "proof/least_clearance.h"

#include <gtest/gtest.h>

#include "geom/shape/separation.h"
#include "support/random_city.h"
#include "support/reading.h"
#include "traj/scenes.h"

namespace traj {
namespace {

// More boxes at about one distance than the search halves a way for.
TEST(LeastClearance, StaysExactWhereHalvingEnds) {
  constexpr int kBoxes = 500'000;
  std::vector<geom::Aabb> boxes;
  for (int i = 0; i < kBoxes; ++i) {
    const double top = i == 123'457 ? 9.001 : 9;
    boxes.push_back({Vec3(i, 0, 0), Vec3(i + 0.5, 1, top)});
  }
  const auto scene = testing::scene_of(boxes, {Vec3(-10, -10, 0), Vec3(kBoxes + 10, 10, 100)});
  const Leg leg{Vec3(0, 0.5, 20), Vec3(kBoxes, 0.5, 20), 0, 1};
  const auto least = least_clearance(scene, std::vector<Leg>{leg});
  ASSERT_TRUE(least);
  EXPECT_NEAR(least->value, 20 - 9.001, 1e-9);
}

// A flight over low roofs that passes one tower: the trees of roofs further than that are not
// built.
TEST(LeastClearance, BuildsNoTreesOfWhatIsFurther) {
  std::vector<geom::Aabb> boxes;
  for (int x = 0; x < 300; ++x) {
    for (int y = 0; y < 100; ++y) {
      const double top = x == 2 && y == 50 ? 29 : 5;
      boxes.push_back({Vec3(30 * x, 30 * y, 0), Vec3(30 * x + 20, 30 * y + 20, top)});
    }
  }
  const auto scene = testing::scene_of(boxes, {Vec3(-10, -10, 0), Vec3(9100, 3100, 100)});
  Trajectory trajectory;
  for (double x = 0; x < 9000; x += 180) {
    trajectory.segments.push_back(hermite({Vec3(x, 1510, 30)}, {Vec3(x + 180, 1510, 30)}, 20));
  }
  const auto least = least_clearance(scene, BoxTimes(), pieces_of(trajectory));
  ASSERT_TRUE(least);
  EXPECT_NEAR(least->value, 1, 1e-3);
  EXPECT_GT(scene.counts().groups, 40u);
  EXPECT_LT(scene.counts().built, 5u);
}

TEST(LeastClearance, IsNothingOnAMapWithoutObstacles) {
  const auto scene = testing::scene_of({});
  EXPECT_FALSE(least_clearance(scene, std::vector<Leg>{{Vec3(0, 0, 10), Vec3(5, 0, 10), 0, 1}}));
}

// Boxes that are always there, come, go, or come for a while, around a flight of some segments.
class TimedScene {
 public:
  TimedScene(support::Random& random, int count, double share_always) {
    std::vector<geom::Aabb> boxes;
    for (int i = 0; i < count; ++i) {
      const Vec3 at(random.uniform(-60, 60), random.uniform(-60, 60), random.uniform(-20, 20));
      boxes.push_back({at, at + Vec3(random.uniform(0, 9), random.uniform(0, 9), 3)});
    }
    table_ = support::table_of(boxes);
    for (int i = 0; i < count; ++i) {
      if (random.uniform(0, 1) < share_always) continue;
      const double from = random.uniform(-20, 60);
      const geom::TimeSpan time{random.below(3) ? from : -kInfinity,
                                random.below(3) ? from + random.uniform(2, 20) : kInfinity};
      if (!time.always()) table_.set_time(static_cast<std::size_t>(i), time);
    }
    Vec3 from(random.uniform(-50, 50), random.uniform(-50, 50), random.uniform(-15, 15));
    for (int left = 1 + random.below(4); left > 0; --left) {
      const Vec3 to(random.uniform(-50, 50), random.uniform(-50, 50), random.uniform(-15, 15));
      flight_.segments.push_back(hermite({from}, {to}, random.uniform(5, 15)));
      from = to;
    }
  }

  std::optional<Extreme> found() const {
    const geom::CollisionScene scene(
        geom::BoxMap({.bounds = {Vec3::Constant(-100), Vec3::Constant(100)},
                      .epoch = "2026-05-04T06:30:00Z"},
                     table_),
        {"box", kHalf}, 0);
    const std::vector<Piece> pieces = pieces_of(flight_);
    return least_clearance(scene, BoxTimes(scene.map(), 0.0, pieces.size(), duration(flight_)),
                           pieces);
  }

  // By looking at `count` instants.
  double sampled(int count) const {
    double least = kInfinity;
    for (int k = 0; k <= count; ++k) {
      const double t = duration(flight_) * k / count;
      const Vec3 p = evaluate(flight_, t).position;
      for (std::size_t i = 0; i < table_.boxes.size(); ++i) {
        const geom::TimeSpan time = table_.time(i);
        if (time.from > t || time.until < t) continue;
        least = std::min(least, geom::distance(p, geom::grow(table_.boxes[i], kHalf)));
      }
    }
    return least;
  }

  double longest_step(int count) const {
    double most = 0;
    for (const Piece& piece : pieces_of(flight_)) {
      for (std::size_t i = 1; i < piece.q.size(); ++i) {
        const double speed = 7 * (piece.q[i] - piece.q[i - 1]).norm() / (piece.end - piece.begin);
        most = std::max(most, speed * duration(flight_) / count);
      }
    }
    return most;
  }

 private:
  static inline const Vec3 kHalf{0.5, 0.4, 0.3};
  geom::BoxTable table_;
  Trajectory flight_;
};

TEST(LeastClearanceProperty, CountsBoxesAtTheirTimesAlone) {
  support::Random random(2025);
  int none = 0;
  int touching = 0;
  for (int i = 0; i < 1500; ++i) {
    const TimedScene one(random, 1 + random.below(40), random.below(2) ? 0 : 0.1);
    constexpr int kInstants = 2000;
    const double sampled = one.sampled(kInstants);
    const auto found = one.found();
    if (sampled == kInfinity) {
      ++none;
      ASSERT_FALSE(found) << i;
      continue;
    }
    ASSERT_TRUE(found) << i;
    touching += found->value == 0;
    ASSERT_LE(found->value, sampled + 1.1e-3) << i;
    ASSERT_GE(found->value, sampled - one.longest_step(kInstants) - 1e-6) << i;
  }
  EXPECT_GT(none, 20);
  EXPECT_GT(touching, 20);
}

// The first to come does so while the flight is under way.
TEST(LeastClearance, IsOfBoxesThatComeLaterEvenWhereThereAreMany) {
  std::vector<geom::Aabb> boxes;
  for (int i = 0; i < 3000; ++i) boxes.push_back({Vec3(i, 5, 0), Vec3(i + 0.5, 6, 20)});
  geom::BoxTable table = support::table_of(boxes);
  for (std::size_t i = 0; i < boxes.size(); ++i) table.set_time(i, {50, kInfinity});
  const geom::CollisionScene scene(geom::BoxMap({.bounds = {Vec3(-10, -10, 0), Vec3(3010, 10, 30)},
                                                 .epoch = "2026-05-04T06:30:00Z"},
                                                table),
                                   {"box", Vec3::Constant(0.5)}, 0);
  Trajectory flight;
  for (int i = 0; i < 300; ++i) {
    flight.segments.push_back(hermite({Vec3(10 * i, 0, 10)}, {Vec3(10 * i + 10, 0, 10)}, 1));
  }
  const std::vector<Piece> pieces = pieces_of(flight);
  const auto least = least_clearance(scene, BoxTimes(scene.map(), 0.0, pieces.size(), 300), pieces);
  ASSERT_TRUE(least);
  EXPECT_NEAR(least->value, 4.5, 1e-3);
  EXPECT_GE(least->time, 50 - 1e-3);
}

}  // namespace
}  // namespace traj
