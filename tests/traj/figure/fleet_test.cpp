#include "traj/figure/fleet.h"

#include <gtest/gtest.h>

#include "support/reading.h"

namespace {

TEST(InTheAir, CountsFromDepartureUntilArrival) {
  const std::vector<traj::figure::FleetFlight> flights{
      {"a", 0, 10, {}}, {"b", 5, 10, {}}, {"c", 10, 2, {}}, {"d", 20, 0, {}}};
  const auto steps = traj::figure::in_the_air(flights);
  const auto at = [&](double t) {
    std::size_t now = 0;
    for (const auto& step : steps) now = step.time <= t ? step.flights : now;
    return now;
  };
  EXPECT_EQ(at(0), 1u);
  EXPECT_EQ(at(5), 2u);
  EXPECT_EQ(at(10), 2u);  // one arrives as another departs
  EXPECT_EQ(at(12), 1u);
  EXPECT_EQ(at(15), 0u);
  EXPECT_EQ(at(20), 0u);
}

TEST(FleetPlot, SaysDelaysTheNearestPairAndTheMostInTheAir) {
  const std::vector<traj::figure::FleetFlight> flights{
      {"a<b", 0, 10, 0.0}, {"c", 5, 10, 5.0}, {"d", 10, 20, 10.0}};
  traj::Approaches approaches{20, {}};
  approaches.list.push_back({{0, 2}, 1.25, 10, {}, {}});
  const std::string svg = traj::figure::fleet(flights, approaches);
  for (const char* words :
       {"3 flights", "2 of 3 flights late", "5 s in the mean", "10 s at most", "1 pair within 20 m",
        "least 1.25 m: a&lt;b and d at 10 s", "2 in the air at once at most, at 5 s"}) {
    EXPECT_TRUE(support::says(svg, words)) << words;
  }
  EXPECT_FALSE(support::says(svg, "nan"));
  const std::vector<traj::figure::FleetFlight> alone{{"a", 0, 1, {}}};
  EXPECT_TRUE(support::says(traj::figure::fleet(alone, {50, {}}), "no pair within 50 m"));
  EXPECT_TRUE(support::says(traj::figure::fleet(alone, {50, {}}), "no delays"));
}

}  // namespace
