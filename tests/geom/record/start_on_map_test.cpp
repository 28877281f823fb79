#include "geom/record/start_on_map.h"

#include <gtest/gtest.h>

#include "support/random_city.h"
#include "support/reading.h"

namespace geom {
namespace {

const std::string kEpoch = "2026-05-04T06:30:00Z";
const std::string kOther = "2026-05-04T06:31:00Z";

BoxMap map_with(bool times, std::optional<std::string> epoch) {
  BoxTable table = support::table_of({{{1, 1, 1}, {2, 2, 2}}});
  if (times) table.set_time(0, {5, 6});
  return {{.bounds = {{0, 0, 0}, {10, 10, 10}}, .epoch = std::move(epoch)}, table};
}

FlightTime flight(std::optional<std::string> epoch, std::optional<double> start) {
  FlightTime time;
  time.epoch = std::move(epoch);
  time.start = start;
  time.earliest = 3;
  return time;
}

TEST(StartOnMap, CountsOnlyWhereBothSayWhen) {
  EXPECT_EQ(start_on(map_with(true, kEpoch), flight(kEpoch, 7), "r", 1), 7);
  EXPECT_FALSE(start_on(map_with(true, kEpoch), flight(kEpoch, {}), "r", 1));
  EXPECT_FALSE(start_on(map_with(true, kEpoch), flight({}, {}), "r", 1));
  EXPECT_FALSE(start_on(map_with(false, kEpoch), flight(kEpoch, 7), "r", 1));
  EXPECT_FALSE(start_on(map_with(false, {}), flight(kEpoch, 7), "r", 1));
  EXPECT_FALSE(start_on(map_with(false, kEpoch), flight({}, 7), "r", 1));
}

TEST(StartOnMap, RefusesSecondsAfterDifferentInstants) {
  const auto refusal = [](const BoxMap& map, const FlightTime& time) {
    return support::refusal_of([&] { start_on(map, time, "r", 4); });
  };
  EXPECT_EQ(refusal(map_with(true, kEpoch), flight({}, 7)),
            "r:4: expected the epoch of the map, " + kEpoch +
                ", found none: seconds after different instants cannot be compared");
  EXPECT_TRUE(support::says(refusal(map_with(true, kEpoch), flight(kOther, 7)), kOther));
  EXPECT_TRUE(support::says(refusal(map_with(true, kEpoch), flight(kOther, {})), kOther));
  EXPECT_TRUE(support::says(refusal(map_with(false, kEpoch), flight(kOther, {})), kOther));
}

}  // namespace
}  // namespace geom
