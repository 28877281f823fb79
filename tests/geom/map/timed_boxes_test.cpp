#include "map/timed_boxes.h"

#include <gtest/gtest.h>

#include <vector>

namespace geom {
namespace {

const std::optional<std::string> kEpoch = "2026-05-04T06:30:00Z";

TEST(TimedBoxes, KnowsWhichBoxesHaveTimes) {
  const std::vector<std::uint64_t> box{1, 4};
  const std::vector<TimeSpan> time{{0, 5}, {7, 9}};
  const TimedBoxes timed{box, time};
  EXPECT_FALSE(timed_fault(timed, 5, kEpoch));
  EXPECT_EQ(timed.of(1), (TimeSpan{0, 5}));
  EXPECT_EQ(timed.of(4), (TimeSpan{7, 9}));
  EXPECT_TRUE(timed.of(0).always() && timed.of(3).always() && timed.of(5).always());
  EXPECT_TRUE(TimedBoxes().of(0).always());
}

TEST(TimedBoxes, RefusesWhatCannotBe) {
  const std::vector<TimeSpan> time{{0, 5}, {7, 9}};
  const auto fault = [&](const std::vector<std::uint64_t>& box, std::vector<TimeSpan> times,
                         const std::optional<std::string>& epoch = kEpoch) {
    const auto fault = timed_fault({box, times}, 5, epoch);
    return fault ? sentence(*fault) : "none";
  };
  EXPECT_EQ(fault({1, 4}, time), "none");
  EXPECT_NE(fault({4, 1}, time).find("above the one before, found 1"), std::string::npos);
  EXPECT_NE(fault({1, 1}, time).find("found 1"), std::string::npos);
  EXPECT_NE(fault({1, 5}, time).find("below 5"), std::string::npos);
  EXPECT_NE(fault({1}, time).find("have 1 and 2"), std::string::npos);
  EXPECT_NE(fault({1}, {{2, 1}}).find("box 1: from must be at most until"), std::string::npos);
  EXPECT_NE(fault({1}, {{}}).find("always there"), std::string::npos);
  EXPECT_NE(fault({1, 4}, time, std::nullopt).find("expected the epoch"), std::string::npos);
  EXPECT_NE(fault({1, 4}, time, "1620000000").find("found \"1620000000\""), std::string::npos);
  EXPECT_NE(fault({}, {}, "yesterday").find("instant"), std::string::npos);
}

}  // namespace
}  // namespace geom
