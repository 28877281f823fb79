#include "traj/fleet/forbidden_by_moving.h"

#include <gtest/gtest.h>

#include <cmath>

#include "traj/fleet/random_flights.h"

namespace traj {
namespace {

using testing::holds;
using testing::place_at;
using testing::random_place;
using testing::steady;

constexpr double kForever = std::numeric_limits<double>::infinity();

MovingBox box_of(const geom::Aabb& box, double from, double until) {
  return {box, Vec3::Zero(), Vec3::Zero(), from, until};
}

std::vector<DepartureSpan> forbidden(const Trajectory& flight, const Vec3& room,
                                     const MovingBox& box, Parked parked) {
  return forbidden_by_moving(flight, room, {&box, 1}, parked).at(0);
}

TEST(ForbiddenByMoving, IsTheTimeOfTheBoxLessThatOfTheFlightInIt) {
  // As a box that stands: grown to -5.5 to 5.5, from 9.45 to 10.55 s after the departure.
  const auto spans = forbidden(steady(), Vec3::Constant(0.5),
                               box_of({{-5, -5, -5}, {5, 5, 5}}, 1000, 1060), Parked::gone);
  ASSERT_EQ(spans.size(), 1u);
  EXPECT_LE(spans[0].low, 1000 - 10.55);
  EXPECT_GE(spans[0].high, 1060 - 9.45);
  EXPECT_NEAR(spans[0].low, 1000 - 10.55, 0.01);
  EXPECT_NEAR(spans[0].high, 1060 - 9.45, 0.01);
}

TEST(ForbiddenByMoving, FollowsABoxOnItsWay) {
  // It crosses the line at 5 m/s between y = -1 and 1, from y = -50 at second 100 on: in the way of
  // a point from second 109.8 to 110.2, at x from -1 to 1, which is 9.9 to 10.1 s after departure.
  MovingBox box = box_of({{-1, -51, -1}, {1, -49, 1}}, 100, 200);
  box.velocity = {0, 5, 0};
  const auto spans = forbidden(steady(), Vec3::Zero(), box, Parked::gone);
  ASSERT_EQ(spans.size(), 1u);
  EXPECT_LE(spans[0].low, 109.8 - 10.1);
  EXPECT_GE(spans[0].high, 110.2 - 9.9);
  EXPECT_NEAR(spans[0].low, 109.8 - 10.1, 0.02);
  EXPECT_NEAR(spans[0].high, 110.2 - 9.9, 0.02);
  box.growth = {0, 1, 0};  // 1 + 10 m at second 109: there sooner, and gone later
  const auto grown = forbidden(steady(), Vec3::Zero(), box, Parked::gone);
  ASSERT_EQ(grown.size(), 1u);
  EXPECT_NEAR(grown[0].low, 100 + 49.0 / 6 - 10.1, 0.02);
  EXPECT_NEAR(grown[0].high, 100 + 51.0 / 4 - 9.9, 0.02);
}

TEST(ForbiddenByMoving, NothingElsewhereOrFromNoBoxes) {
  MovingBox beside = box_of({{-5, 5, -5}, {5, 9, 5}}, 0, 9);
  EXPECT_TRUE(forbidden(steady(), Vec3::Constant(0.5), beside, Parked::pad).empty());
  beside.velocity = {0, 1, 0};
  EXPECT_TRUE(forbidden(steady(), Vec3::Constant(0.5), beside, Parked::pad).empty());
  beside.velocity = {0, -1, 0};
  EXPECT_FALSE(forbidden(steady(), Vec3::Constant(0.5), beside, Parked::pad).empty());
  EXPECT_TRUE(forbidden_by_moving(steady(), Vec3::Zero(), {}, Parked::pad).empty());
}

TEST(ForbiddenByMoving, StandingOnAPadHasNoEnd) {
  // It comes by the last point, x = 100, from second 48.5 to 49.5.
  MovingBox box = box_of({{-95, -5, -5}, {-85, 5, 5}}, 30, 60);
  box.velocity = {10, 0, 0};
  const auto pad = forbidden(steady(), Vec3::Zero(), box, Parked::pad);
  ASSERT_FALSE(pad.empty());
  EXPECT_EQ(pad.front().low, -kForever);
  EXPECT_GE(pad.back().high, 49.5 - 20);
  EXPECT_NEAR(pad.back().high, 49.5 - 20, 0.01);
  const auto gone = forbidden(steady(), Vec3::Zero(), box, Parked::gone);
  EXPECT_TRUE(gone.empty() || gone.front().low > -kForever);
  // At the first point before it departs: a later departure is no way out.
  const auto first =
      forbidden(steady(), Vec3::Zero(), box_of({{-110, -5, -5}, {-90, 5, 5}}, 30, 60), Parked::pad);
  ASSERT_EQ(first.size(), 1u);
  EXPECT_EQ(first[0].high, kForever);
  EXPECT_LE(first[0].low, 30 - 1);
  EXPECT_NEAR(first[0].low, 30 - 1, 0.01);
}

MovingBox random_box(geom::SplitMix64& random) {
  const Vec3 low = random_place(random, 60, 10);
  const double from = random.uniform(-50, 150);
  MovingBox box = box_of({low, low + Vec3(random.uniform(0, 20), random.uniform(0, 20), 4)}, from,
                         from + random.uniform(1, 60));
  const int kind = random.whole(0, 3);
  if (kind > 0) box.velocity = random_place(random, 8, 2);
  if (kind > 1) box.growth = random_place(random, 1, 1).cwiseAbs();
  return box;
}

// Whether any of many instants finds the flight's box in the obstacle, each closed.
bool sampled_contact(const Trajectory& flight, double departure, const Vec3& room,
                     const MovingBox& box, Parked parked) {
  for (int i = 0; i <= 600; ++i) {
    const double time = box.from + (box.until - box.from) * i / 600;
    const double t = time - departure;
    if (parked == Parked::gone && (t < 0 || t > duration(flight))) continue;
    const Vec3 p = place_at(flight, t);
    const double age = time - box.from;
    const Vec3 low = box.box.min + (box.velocity - box.growth) * age - room;
    const Vec3 high = box.box.max + (box.velocity + box.growth) * age + room;
    if ((p.array() >= low.array()).all() && (p.array() <= high.array()).all()) return true;
  }
  return false;
}

// Whatever the check refuses is forbidden, and what is left it accepts, to the ends of the
// intervals; and samples, which share nothing with either, find no contact in what is left.
TEST(ForbiddenByMovingProperty, HoldsEveryDepartureWithAContact) {
  geom::SplitMix64 random(91);
  int refused = 0;
  int accepted = 0;
  int sampled = 0;
  for (int i = 0; i < 500; ++i) {
    const Trajectory flight = testing::random_flight(random, 60, 10);
    const MovingBox box = random_box(random);
    const Vec3 room =
        random.whole(0, 3) ? Vec3(Vec3::Constant(random.uniform(0, 2))) : Vec3(Vec3::Zero());
    const Parked parked = random.whole(0, 1) ? Parked::pad : Parked::gone;
    const auto spans = forbidden(flight, room, box, parked);
    const auto clear = [&](double departure) {
      return check_moving({&flight, departure, room}, box, parked).clear;
    };
    for (int k = 0; k < 25; ++k) {
      const double departure = random.uniform(box.from - duration(flight) - 5, box.until + 5);
      const bool is_clear = clear(departure);
      ++(is_clear ? accepted : refused);
      ASSERT_TRUE(is_clear || holds(spans, departure)) << i << ' ' << departure;
      if (!sampled_contact(flight, departure, room, box, parked)) continue;
      ++sampled;
      ASSERT_TRUE(holds(spans, departure)) << i << ' ' << departure;
    }
    for (const DepartureSpan& span : spans) {  // just beyond its ends
      ASSERT_TRUE(span.low < -1e8 || clear(std::nextafter(span.low, -kForever))) << i;
      ASSERT_TRUE(span.high > 1e8 || clear(std::nextafter(span.high, kForever))) << i;
    }
  }
  EXPECT_GT(refused, 300);
  EXPECT_GT(accepted, 300);
  EXPECT_GT(sampled, 200);
}

// Its ends are no further from the true ones than what a box larger by 2 cm forbids.
TEST(ForbiddenByMovingProperty, IsHardlyMoreThanThat) {
  geom::SplitMix64 random(92);
  int ends = 0;
  for (int i = 0; i < 200; ++i) {
    const Trajectory flight = testing::random_flight(random, 60, 10);
    const MovingBox box = random_box(random);
    const auto spans = forbidden(flight, Vec3::Constant(1), box, Parked::gone);
    for (const DepartureSpan& span : spans) {
      for (const double end : {span.low + 1e-5, span.high - 1e-5}) {
        if (!span.holds(end)) continue;
        EXPECT_FALSE(check_moving({&flight, end, Vec3::Constant(1.021)}, box, Parked::gone).clear)
            << i << ' ' << end;
        ++ends;
      }
    }
  }
  EXPECT_GT(ends, 50);
}

TEST(ForbiddenByMoving, OfTimesAndPlacesThatAreVeryLarge) {
  MovingBox box = box_of({{-5, -5, -5}, {5, 5, 5}}, -1e9, 1e9);
  auto spans = forbidden(steady(), Vec3::Constant(0.5), box, Parked::gone);
  ASSERT_EQ(spans.size(), 1u);
  EXPECT_TRUE(spans[0].holds(-1e9) && spans[0].holds(0) && spans[0].holds(1e9 - 10));
  box = box_of({{-9e7, -5, -5}, {-9e7 + 1, 5, 5}}, 0, 18000);
  box.velocity = {1e4, 0, 0};
  spans = forbidden(steady(), Vec3::Constant(0.5), box, Parked::gone);
  ASSERT_FALSE(spans.empty());
  const Trajectory flight = steady();
  int refused = 0;
  for (double departure = 8970; departure < 9010; departure += 0.0625) {
    const TimedFlight timed{&flight, departure, Vec3::Constant(0.5)};
    if (check_moving(timed, box, Parked::gone).clear) continue;
    EXPECT_TRUE(holds(spans, departure)) << departure;
    ++refused;
  }
  EXPECT_GT(refused, 100);
}

}  // namespace
}  // namespace traj
