#include "geom/zone/zone_times.h"

#include <gtest/gtest.h>

#include <cmath>

namespace geom {
namespace {

constexpr SunArea kZurich{47.3, 47.4, 8.5, 8.6};
constexpr double kDay = 86400;
const ZoneClock kClock{.epoch = "2026-05-04T00:00:00Z", .days = 3};  // a Monday

DayTime at(double seconds) { return {.event = {}, .least = seconds, .most = seconds + 60}; }

ZonePeriod daily(std::uint8_t days, double begin, double end) {
  return {.start = {}, .end = {}, .schedule = {{.days = days, .begin = at(begin), .end = at(end)}}};
}

bool is_on(const std::vector<TimeSpan>& spans, double t) {
  for (const TimeSpan& span : spans) {
    if (span.from <= t && t <= span.until) return true;
  }
  return false;
}

std::vector<TimeSpan> times(std::vector<ZonePeriod> periods, const ZoneClock& clock = kClock) {
  return zone_times(periods, clock, kZurich);
}

TEST(ZoneTimes, AreAlwaysWithoutPeriodsOrEpoch) {
  EXPECT_EQ(times({}), std::vector<TimeSpan>{TimeSpan{}});
  EXPECT_EQ(times({daily(kEveryDay, 0, 3600)}, {}), std::vector<TimeSpan>{TimeSpan{}});
}

TEST(ZoneTimes, HoldADailyPeriodToTheEndOfItsMinute) {
  const auto spans = times({daily(kEveryDay, 8 * 3600, 17 * 3600)});
  EXPECT_FALSE(is_on(spans, 8 * 3600 - 1));
  EXPECT_TRUE(is_on(spans, 8 * 3600));
  EXPECT_TRUE(is_on(spans, 17 * 3600 + 60));
  EXPECT_FALSE(is_on(spans, 17 * 3600 + 61));
  EXPECT_TRUE(is_on(spans, kDay + 12 * 3600));
}

TEST(ZoneTimes, CrossMidnightFromTheDayThatIsNamed) {
  const auto spans = times({daily(1, 22 * 3600, 5 * 3600)});  // Monday
  EXPECT_FALSE(is_on(spans, 3 * 3600));
  EXPECT_TRUE(is_on(spans, 23 * 3600));
  EXPECT_TRUE(is_on(spans, kDay + 3 * 3600));
  EXPECT_FALSE(is_on(spans, kDay + 23 * 3600));
}

// 00:30 to 01:30 of a Monday two hours ahead of UTC.
TEST(ZoneTimes, InAnotherOffsetAreOfItsDaysAndOfThoseOfUtc) {
  DailyPeriod night{.days = 1, .begin = at(-5400), .end = at(-1800)};
  night.begin->offset = night.end->offset = 7200;
  const auto spans = times({{.start = {}, .end = {}, .schedule = {night}}});
  EXPECT_TRUE(is_on(spans, -3600)) << "Monday there";
  EXPECT_TRUE(is_on(spans, kDay - 3600)) << "Monday by UTC";
  EXPECT_FALSE(is_on(spans, 0));
  EXPECT_FALSE(is_on(spans, 2 * kDay - 3600));
  night.begin.reset();
  night.end = at(6 * 3600 - 7200);
  night.end->offset = 7200;
  const auto morning = times({{.start = {}, .end = {}, .schedule = {night}}});
  EXPECT_TRUE(is_on(morning, -3600)) << "the day begins two hours before";
  EXPECT_TRUE(is_on(morning, 3600));
  EXPECT_FALSE(is_on(morning, -7300));
  EXPECT_FALSE(is_on(morning, 5 * 3600));
}

TEST(ZoneTimes, OfAWholeDayToItsLastMinuteLeaveNoGap) {
  const auto spans = times({daily(kEveryDay, 0, 23 * 3600 + 59 * 60)});
  EXPECT_TRUE(is_on(spans, kDay - 0.5));
  EXPECT_EQ(spans.size(), 1U);
}

TEST(ZoneTimes, OfAScheduleAreAlwaysBeyondTheDaysThatItIsWorkedOutFor) {
  const auto spans = times({daily(kEveryDay, 8 * 3600, 9 * 3600)});
  EXPECT_TRUE(std::isinf(spans.front().from));
  EXPECT_TRUE(std::isinf(spans.back().until));
  EXPECT_FALSE(is_on(spans, 2.5 * kDay));
  EXPECT_TRUE(is_on(spans, 4.5 * kDay));
  EXPECT_TRUE(is_on(spans, -4.5 * kDay));
}

TEST(ZoneTimes, AreCutByStartAndEnd) {
  ZonePeriod period = daily(kEveryDay, 8 * 3600, 9 * 3600);
  period.start = "2026-05-05T08:30:00Z";
  period.end = "2026-05-06T08:30:00Z";
  const auto spans = times({period});
  ASSERT_EQ(spans.size(), 2U);
  EXPECT_EQ(spans[0], (TimeSpan{kDay + 8.5 * 3600, kDay + 9 * 3600 + 60}));
  EXPECT_EQ(spans[1], (TimeSpan{2 * kDay + 8 * 3600, 2 * kDay + 8.5 * 3600}));
}

TEST(ZoneTimes, OfAZoneThatEndedAreOver) {
  const std::vector<ZonePeriod> past = {
      {.start = "2019-01-01T00:00:00Z", .end = "2020-01-01T00:00:00Z", .schedule = {}}};
  const auto spans = times(past);
  ASSERT_EQ(spans.size(), 1U);
  EXPECT_LT(spans[0].until, -1e8);
}

TEST(ZoneTimes, TooFarAwayForAMapAreOpenOutward) {
  const std::vector<ZonePeriod> long_ago = {
      {.start = "1970-01-01T00:00:00Z", .end = "9999-01-01T00:00:00Z", .schedule = {}}};
  EXPECT_EQ(times(long_ago), std::vector<TimeSpan>{TimeSpan{}});
}

TEST(ZoneTimes, FollowTheSunOnTheSafeSide) {
  const ZonePeriod day = {.start = {},
                          .end = {},
                          .schedule = {{.days = kEveryDay,
                                        .begin = DayTime{.event = DayEvent::sunrise},
                                        .end = DayTime{.event = DayEvent::sunset}}}};
  const auto spans = times({day});
  // Sunrise 03:59, sunset 18:46 UTC.
  EXPECT_TRUE(is_on(spans, kDay + 3 * 3600 + 58 * 60));
  EXPECT_FALSE(is_on(spans, kDay + 3 * 3600 + 30 * 60));
  EXPECT_TRUE(is_on(spans, kDay + 18 * 3600 + 47 * 60));
  EXPECT_FALSE(is_on(spans, kDay + 19 * 3600 + 15 * 60));
}

TEST(ZoneTimes, AreAllDayWhereTheSunMayNotSet) {
  const std::vector<ZonePeriod> night = {
      {.start = {},
       .end = {},
       .schedule = {{.days = kEveryDay,
                     .begin = DayTime{.event = DayEvent::sunset},
                     .end = DayTime{.event = DayEvent::sunrise}}}}};
  const ZoneClock june{.epoch = "2026-06-21T00:00:00Z", .days = 2};
  EXPECT_EQ(zone_times(night, june, {69, 69.1, 20, 21}), std::vector<TimeSpan>{TimeSpan{}});
}

}  // namespace
}  // namespace geom
