#include "geom/text/instant.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace geom {
namespace {

constexpr const char* kEpoch = "2026-05-04T06:30:00Z";

TEST(Epoch, IsOneTextForOneInstant) {
  EXPECT_EQ(epoch_from("2026-05-04T06:30:00Z"), "2026-05-04T06:30:00Z");
  EXPECT_EQ(epoch_from("2026-05-04T06:30:00+00:00"), "2026-05-04T06:30:00Z");
  EXPECT_EQ(epoch_from("2026-05-04T06:30:00.000Z"), "2026-05-04T06:30:00Z");
  EXPECT_EQ(epoch_from("2026-05-04T06:30:00.2500Z"), "2026-05-04T06:30:00.25Z");
  EXPECT_EQ(epoch_from("2024-02-29T00:00:00Z"), "2024-02-29T00:00:00Z");
}

TEST(Epoch, IsNoOtherText) {
  for (const char* text : {"",
                           "2026-05-04",
                           "2026-05-04T06:30:00",
                           "2026-05-04 06:30:00Z",
                           "2026-05-04T06:30:00+02:00",
                           "2026-02-29T00:00:00Z",
                           "1900-02-29T00:00:00Z",
                           "2026-13-01T00:00:00Z",
                           "2026-00-01T00:00:00Z",
                           "2026-04-31T00:00:00Z",
                           "2026-05-04T24:00:00Z",
                           "2026-05-04T23:60:00Z",
                           "2026-12-31T23:59:60Z",
                           "2026-05-04T06:30:00.Z",
                           "2026-05-04T06:30:00.5",
                           "2026-05-04T06:30:00Zz",
                           "20260504T063000Z",
                           "tomorrow morning at 6",
                           "2026-5-04T06:30:00Z0",
                           "-026-05-04T06:30:00Z"}) {
    EXPECT_FALSE(epoch_from(text)) << text;
  }
}

TEST(SecondsBetween, AreExactWhereTheyAreADouble) {
  const auto exactly = [](const char* epoch, const char* instant, double seconds) {
    const SecondsBetween between = seconds_between(epoch, instant);
    EXPECT_EQ(between.least, seconds) << instant;
    EXPECT_EQ(between.most, seconds) << instant;
  };
  exactly(kEpoch, kEpoch, 0);
  exactly(kEpoch, "2026-05-04T06:30:01Z", 1);
  exactly(kEpoch, "2026-05-04T06:29:59.75Z", -0.25);
  exactly(kEpoch, "2026-05-05T06:30:00Z", 86400);
  exactly("2024-02-28T00:00:00Z", "2024-03-01T00:00:00Z", 2 * 86400.0);
  exactly("2100-02-28T00:00:00Z", "2100-03-01T00:00:00Z", 86400);
  exactly("1970-01-01T00:00:00Z", "2000-01-01T00:00:00Z", 946684800);
  exactly("0000-01-01T00:00:00Z", "9999-12-31T23:59:59Z", 315569519999.0);
  exactly("2026-05-04T06:30:00.1Z", "2026-05-04T06:30:01.1Z", 1);
  exactly("2026-05-04T06:30:00.0000000000000000000000001Z",
          "2026-05-04T06:30:00.0000000000000000000000001Z", 0);
}

TEST(SecondsBetween, LieOnBothSidesElse) {
  const SecondsBetween tenth = seconds_between(kEpoch, "2026-05-04T06:30:00.1Z");
  EXPECT_LT(tenth.least, 0.1);  // the double of 0.1 is above a tenth
  EXPECT_GE(tenth.most, 0.1);
  EXPECT_LT(tenth.most - tenth.least, 1e-16);
  const SecondsBetween hair =
      seconds_between(kEpoch, "2026-05-04T06:30:00.00000000000000000000001Z");
  EXPECT_LE(hair.least, 0);
  EXPECT_GT(hair.most, 0);
  EXPECT_LT(hair.most, 1e-17);
  const SecondsBetween back =
      seconds_between("2026-05-04T06:30:00.00000000000000000000001Z", kEpoch);
  EXPECT_LT(back.least, 0);
  EXPECT_GE(back.most, 0);
}

TEST(Instant, IsTheNextMillisecond) {
  EXPECT_EQ(instant_not_after(kEpoch, 0.25), "2026-05-04T06:30:00.25Z");
  EXPECT_EQ(instant_not_before(kEpoch, 0.25), "2026-05-04T06:30:00.25Z");
  EXPECT_EQ(instant_not_after(kEpoch, -0.0001), "2026-05-04T06:29:59.999Z");
  EXPECT_EQ(instant_not_before(kEpoch, -0.0001), kEpoch);
  EXPECT_EQ(instant_not_after(kEpoch, 1e-20), kEpoch);
  EXPECT_EQ(instant_not_before(kEpoch, 1e-15), "2026-05-04T06:30:00.001Z");
  EXPECT_EQ(instant_not_after("2024-02-28T23:59:59.9995Z", 1), "2024-02-29T00:00:00.999Z");
  EXPECT_EQ(instant_not_before("2024-02-28T23:59:59.9995Z", 86400), "2024-03-01T00:00:00Z");
  EXPECT_EQ(instant_not_before("9999-12-31T23:59:59Z", 1), std::nullopt);
  EXPECT_EQ(instant_not_after("0000-01-01T00:00:00Z", -1e-3), std::nullopt);
}

TEST(Instant, StaysOnItsSide) {
  std::mt19937_64 random(20260504);
  for (int i = 0; i < 200000; ++i) {
    const std::string epoch =
        i % 2 ? kEpoch : "1969-12-31T23:59:59." + std::to_string(1 + random() % 999999) + "Z";
    const double seconds = std::ldexp(std::uniform_real_distribution<>(-1, 1)(random),
                                      static_cast<int>(random() % 60) - 30);
    const auto before = instant_not_after(*epoch_from(epoch), seconds);
    const auto after = instant_not_before(*epoch_from(epoch), seconds);
    const SecondsBetween low = seconds_between(*epoch_from(epoch), *before);
    const SecondsBetween high = seconds_between(*epoch_from(epoch), *after);
    ASSERT_LE(low.least, seconds) << epoch << ' ' << seconds;
    ASSERT_GE(high.most, seconds) << epoch << ' ' << seconds;
    ASSERT_LE(high.least - low.most, 0.0011) << epoch << ' ' << seconds;
  }
}

TEST(Instant, IsNeverInDoubtOfItsOwnMillisecond) {
  std::mt19937_64 random(34);
  for (int i = 0; i < 20000; ++i) {
    const double seconds = static_cast<double>(random() % 4'000'000) / 1000;
    const std::string before = *instant_not_after(kEpoch, seconds);
    const std::string after = *instant_not_before(kEpoch, seconds);
    ASSERT_TRUE(is_not_after(before, kEpoch, seconds)) << seconds;
    ASSERT_TRUE(is_not_before(after, kEpoch, seconds)) << seconds;
    ASSERT_FALSE(is_not_before(before, kEpoch, seconds + 1e-6)) << seconds;
    ASSERT_FALSE(is_not_after(after, kEpoch, seconds - 1e-6)) << seconds;
  }
}

}  // namespace
}  // namespace geom
