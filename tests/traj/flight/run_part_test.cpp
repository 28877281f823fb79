#include "traj/flight/run_part.h"

#include <gtest/gtest.h>

#include <cmath>

#include "geom/base/error.h"
#include "support/shards.h"

namespace traj {
namespace {

using Outcomes = std::vector<RunOutcome>;

constexpr double kDuration = 0.25;  // s: three periods

RunOutcome outcome(double seed, bool settles) {
  RunOutcome out;
  out.tracking = {seed, seed + 1, seed + 2, seed + 3, 0.1, seed + 4, seed + 5, std::nullopt};
  if (settles) out.tracking.settling = 0;
  out.saturated = seed / 100;
  out.tilt = seed / 50;
  out.largest = {seed, 0, 2 * seed};
  return out;
}

RunOutcome lost() {
  RunOutcome out;
  out.lost = true;
  return out;
}

void expect_equal(const RunOutcome& a, const RunOutcome& b) {
  EXPECT_EQ(a.lost, b.lost);
  EXPECT_EQ(a.tracking.mean, b.tracking.mean);
  EXPECT_EQ(a.tracking.rms, b.tracking.rms);
  EXPECT_EQ(a.tracking.p99, b.tracking.p99);
  EXPECT_EQ(a.tracking.largest, b.tracking.largest);
  EXPECT_EQ(a.tracking.largest_time, b.tracking.largest_time);
  EXPECT_EQ(a.tracking.arrival, b.tracking.arrival);
  EXPECT_EQ(a.tracking.final_distance, b.tracking.final_distance);
  EXPECT_EQ(a.tracking.settling, b.tracking.settling);
  EXPECT_EQ(a.saturated, b.saturated);
  EXPECT_EQ(a.tilt, b.tilt);
  EXPECT_EQ(a.largest, b.largest);
}

TEST(RunPart, JoinsToAllRuns) {
  const std::vector<Outcomes> all = {
      {outcome(1, true), outcome(2, false), lost(), outcome(4, true), outcome(5, true)},
      {lost(), outcome(7, false), outcome(8, true), outcome(9, true), outcome(10, false)}};
  for (const std::size_t count : {1u, 2u, 5u, 7u}) {
    const JoinedRuns joined(support::shards(count, "runs", [&](const geom::Shard& shard) {
      std::vector<Outcomes> share(all.size());
      for (std::size_t t = 0; t < all.size(); ++t) {
        for (const std::size_t i : shard.items(5)) share[t].push_back(all[t][i]);
      }
      return arrays_of(share, 5);
    }));
    ASSERT_EQ(joined.trajectories(), all.size());
    for (std::size_t t = 0; t < all.size(); ++t) {
      const Outcomes got = joined.outcomes(t, kDuration);
      ASSERT_EQ(got.size(), 5u);
      for (std::size_t i = 0; i < 5; ++i) expect_equal(got[i], all[t][i]);
    }
    EXPECT_THROW(joined.outcomes(1, 0.35), geom::InputError);  // of a longer trajectory
  }
}

TEST(RunPart, RefusesWhatCannotBe) {
  struct Case {
    std::string content = R"({"trajectories":1,"runs":1})";
    std::uint8_t lost = 0;
    std::vector<double> tracking = {1, 1, 1, 1, 1, 1, 1, 1, 0.5, 0.3};
    std::vector<double> largest = {1, 2, 3};
    std::vector<std::uint64_t> ends = {3};
    std::string kind = "runs";
  };
  const auto read = [&](const Case& c) {
    const auto part = [&](const geom::Shard&) -> geom::PartArrays {
      return {c.content,
              {geom::named_array<std::uint8_t>("lost", {&c.lost, 1}),
               geom::named_array<double>("tracking", c.tracking, 10),
               geom::named_array<double>("largest", c.largest),
               geom::named_array<std::uint64_t>("ends", c.ends)},
              {}};
    };
    return JoinedRuns(support::shards(1, c.kind, part)).outcomes(0, kDuration);
  };
  EXPECT_EQ(read({}).size(), 1u);
  const double nan = std::nan("");
  std::vector<Case> wrong(12);
  wrong[0].content = R"({"trajectories":2,"runs":1})";
  wrong[1].content = R"({"trajectories":1,"runs":0})";
  wrong[2].content = R"({"trajectories":-1,"runs":1})";
  wrong[3].content = R"({"runs":1})";
  wrong[4].lost = 2;
  wrong[5].tracking[0] = nan;
  wrong[6].tracking[8] = 1.5;
  wrong[7].largest[1] = -1;
  wrong[8].ends = {4};
  wrong[9].ends = {3, 3};
  wrong[10].kind = "records";
  wrong[11].tracking[9] = nan;
  for (std::size_t i = 0; i < wrong.size(); ++i) {
    EXPECT_THROW(read(wrong[i]), geom::InputError) << i;
  }
}

}  // namespace
}  // namespace traj
