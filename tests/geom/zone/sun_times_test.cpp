#include "geom/zone/sun_times.h"

#include <gtest/gtest.h>

namespace geom {
namespace {

constexpr double kHour = 3600;

// Days after 1970-01-01, and times from almanacs (UTC).
TEST(SunTime, HoldsTheTimesOfAlmanacs) {
  const SunArea greenwich{51.48, 51.48, 0, 0};
  const std::int64_t june = 20625;  // 2026-06-21
  const double midnight = static_cast<double>(june) * 86400;
  const auto rise = sun_time(DayEvent::sunrise, june, greenwich);
  const auto set = sun_time(DayEvent::sunset, june, greenwich);
  ASSERT_TRUE(rise && set);
  EXPECT_LT(rise->least, midnight + 3 * kHour + 43 * 60);
  EXPECT_GT(rise->most, midnight + 3 * kHour + 43 * 60);
  EXPECT_LT(set->least, midnight + 20 * kHour + 21 * 60);
  EXPECT_GT(set->most, midnight + 20 * kHour + 21 * 60);
  EXPECT_LT(rise->most - rise->least, 20 * 60);
}

TEST(SunTime, OrdersTwilightAndSun) {
  const SunArea area{47, 47.1, 8, 8.1};
  for (std::int64_t day = 20454; day < 20454 + 365; day += 13) {
    const auto dawn = sun_time(DayEvent::twilight_begins, day, area);
    const auto rise = sun_time(DayEvent::sunrise, day, area);
    const auto set = sun_time(DayEvent::sunset, day, area);
    const auto dusk = sun_time(DayEvent::twilight_ends, day, area);
    ASSERT_TRUE(dawn && rise && set && dusk);
    EXPECT_LT(dawn->most, rise->least);
    EXPECT_LT(rise->most, set->least);
    EXPECT_LT(set->most, dusk->least);
  }
}

TEST(SunTime, IsWiderForALargerArea) {
  const auto point = sun_time(DayEvent::sunrise, 20576, {47, 47, 8, 8});
  const auto country = sun_time(DayEvent::sunrise, 20576, {46, 48, 6, 10});
  ASSERT_TRUE(point && country);
  EXPECT_LT(country->least, point->least - 400);
  EXPECT_GT(country->most, point->most + 400);
}

TEST(SunTime, IsNothingWhereTheSunStaysUp) {
  EXPECT_FALSE(sun_time(DayEvent::sunset, 20625, {68, 70, 20, 25}));
  EXPECT_FALSE(sun_time(DayEvent::sunrise, 20442, {68, 70, 20, 25}));
  EXPECT_TRUE(sun_time(DayEvent::sunrise, 20530, {68, 70, 20, 25}));
}

TEST(SunTime, FollowsTheSunsDayInTheFarEast) {
  const auto rise = sun_time(DayEvent::sunrise, 20576, {-34, -33.8, 151, 151.3});
  ASSERT_TRUE(rise);
  EXPECT_LT(rise->most, 20576 * 86400.0) << "the evening before in UTC";
}

}  // namespace
}  // namespace geom
