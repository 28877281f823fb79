#include "traj/record/disturbance_record.h"

#include <gtest/gtest.h>

#include "geom/text/json_fields.h"
#include "geom/text/json_line.h"
#include "support/reading.h"

namespace traj {
namespace {

std::string written(const Disturbances& d) {
  geom::JsonLine line;
  add(line, d);
  return line.object();
}

TEST(DisturbanceRecord, ReadsWhatItWrites) {
  const Disturbances d{{1, -2, 0.5}, 0.2, 0.7, 2, 0.01};
  const Disturbances read = read_disturbances(geom::JsonFields(written(d), "tube", 1));
  EXPECT_EQ(written(read), written(d));
  EXPECT_EQ(read.wind, d.wind);
  for (const DisturbanceRange& range : kDisturbanceRanges) {
    EXPECT_EQ(read.*range.value, d.*range.value) << range.key;
  }
}

// An assumption that is not told would be a claim of more than was proved.
TEST(DisturbanceRecord, TellsEveryRangeInWords) {
  const Disturbances d{{1, -2, 0.5}, 0.2, 0.7, 2, 0.01};
  for (const DisturbanceRange& range : kDisturbanceRanges) {
    Disturbances other = d;
    other.*range.value = 0.125 + other.*range.value;
    EXPECT_NE(in_words(other), in_words(d)) << range.key;
    EXPECT_NE(written(other), written(d)) << range.key;
  }
  Disturbances other = d;
  other.wind.z() = 0.75;
  EXPECT_NE(in_words(other), in_words(d));
}

TEST(DisturbanceRecord, RefusesRangesThatCannotBe) {
  for (const DisturbanceRange& range : kDisturbanceRanges) {
    for (const double value : {range.least - 1e-3, range.most * 1.01 + 1e-9}) {
      Disturbances d;
      d.*range.value = value;
      const auto read = [&] { read_disturbances(geom::JsonFields(written(d), "tube", 7)); };
      EXPECT_TRUE(support::says(support::refusal_of(read), "tube:7: " + std::string(range.key)));
    }
  }
  EXPECT_NE(support::refusal_of([] { read_disturbances(geom::JsonFields("{}", "tube", 7)); }), "");
}

}  // namespace
}  // namespace traj
