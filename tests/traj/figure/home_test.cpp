#include "traj/figure/home.h"

#include <gtest/gtest.h>

#include "figure/home_band.h"
#include "support/random_city.h"
#include "support/reading.h"

namespace {

using traj::figure::HomeFlight;
using traj::figure::TimeSpans;

std::size_t count(const std::string& svg, const std::string& words) {
  std::size_t out = 0;
  for (auto at = svg.find(words); at != std::string::npos; at = svg.find(words, at + 1)) ++out;
  return out;
}

traj::ReturnSummary returns_of(double duration, const TimeSpans& gaps) {
  traj::ReturnSummary out{.action = "rtl", .autopilot = "px4:1.17", .home = geom::Vec3(0, 0, 0)};
  out.height = 60;
  out.duration = duration;
  for (const auto& [from, until] : gaps) {
    out.gaps.push_back({.from = from, .until = until, .phase = "way", .reason = "collision"});
    out.gaps.back().box = 1549;
  }
  out.share = traj::figure::share_without(gaps, duration);
  return out;
}

traj::ContingencyRecord way(double from, double until, std::optional<double> latest) {
  traj::ContingencyRecord out{.id = "q1", .from = from, .until = until, .site = "pad"};
  out.points = {{0, 0, 9}, {0, 0, 0}};
  out.duration = 31;
  out.latest_departure = latest;
  out.bounds_energy = true;
  return out;
}

TEST(PlannedTimes, GoOnAsLongAsWaysMeetAndEnergyLasts) {
  EXPECT_EQ(
      traj::figure::planned_times({way(0, 4, 4), way(4, 9, 9), way(12, 15, 13), way(15, 20, 20)}),
      (TimeSpans{{0, 9}, {12, 13}, {15, 20}}));
  EXPECT_EQ(traj::figure::planned_times({way(0, 9, 9), way(2, 4, 4), way(9, 10, {})}),
            (TimeSpans{{0, 9}}));
  traj::ContingencyRecord none{.id = "q1", .from = 0, .until = 5};
  EXPECT_TRUE(traj::figure::planned_times({none}).empty());
}

TEST(WithoutProperty, HasAllThatSpansLeave) {
  support::Random random(41);
  for (int i = 0; i < 500; ++i) {
    TimeSpans spans;
    double time = 0;
    for (int k = random.below(6); k > 0; --k) {
      const double from = time + random.uniform(0.1, 3);
      time = from + random.uniform(0.1, 3);
      spans.emplace_back(from, time);
    }
    const double duration = time + random.uniform(0.1, 2);
    const TimeSpans rest = traj::figure::without(spans, duration);
    SCOPED_TRACE(testing::Message() << "seed 41, case " << i);
    EXPECT_NEAR(
        traj::figure::share_without(spans, duration) + traj::figure::share_without(rest, duration),
        1, 1e-9);
    EXPECT_EQ(traj::figure::without(rest, duration), spans);
  }
}

TEST(Without, OfNothingIsAllOfIt) {
  EXPECT_EQ(traj::figure::without({}, 5), (TimeSpans{{0, 5}}));
  EXPECT_EQ(traj::figure::without({}, 0), (TimeSpans{{0, 0}}));  // a flight that was never planned
  EXPECT_EQ(traj::figure::share_without({{0, 0}}, 0), 0);
}

TEST(Percent, IsNeverWholeForWhatIsNot) {
  EXPECT_EQ(traj::figure::percent(1), "100.0 %");
  EXPECT_EQ(traj::figure::percent(0.99999), "99.9 %");
  EXPECT_EQ(traj::figure::percent(0.4042), "40.4 %");
}

TEST(HomePlot, SaysShareHeightsAndWhatIsInTheWay) {
  HomeFlight flight{.id = "a<b"};
  flight.height = {{0, 0}, {5, 30}, {10, 30}};
  flight.returns = {returns_of(10, {{2, 7}})};
  flight.returns[0].least_height = 74.5;
  flight.returns[0].gaps[0].item = 4;
  flight.returns[0].gaps[0].part = "leg";
  const std::string svg = traj::figure::home(flight);
  for (const char* words :
       {"a&lt;b: the autopilot's return is proved for 50.0 % of 10.0 s", "return height 60 m",
        "least return height 74.5 m", "rtl, 60 m above home",
        "2.0 to 7.0 s, item 4 (leg): on its way home it meets obstacle 1549", "height, m",
        "at 74.5 m above home it is proved from every instant"}) {
    EXPECT_TRUE(support::says(svg, words)) << words;
  }
  EXPECT_FALSE(support::says(svg, "planned"));
  EXPECT_FALSE(support::says(svg, "nan"));
}

TEST(HomePlot, SaysABetterHeightWhereNoneIsEnough) {
  HomeFlight flight{.id = "a"};
  flight.height = {{0, 0}, {10, 30}};
  flight.returns = {returns_of(10, {{2, 7}})};
  flight.returns[0].best_height = 45;
  flight.returns[0].best_share = 0.75;
  const std::string better = traj::figure::home(flight);
  EXPECT_TRUE(support::says(
      better, "at 45 m above home it is proved for 75.0 %, and at no height for more"));
  EXPECT_TRUE(support::says(better, "best return height 45 m"));
  EXPECT_TRUE(support::says(traj::figure::homes(std::vector{flight}), "45 m: 75.0 %"));
  flight.returns[0].best_share = 0.5;
  const std::string no_better = traj::figure::home(flight);
  EXPECT_TRUE(support::says(no_better, "no return height makes all of it safe"));
  EXPECT_FALSE(support::says(no_better, "best return height"));
  EXPECT_TRUE(support::says(traj::figure::homes(std::vector{flight}), ">none<"));
}

TEST(HomePlot, SaysPlannedWaysAndTheirEnergy) {
  HomeFlight flight{.id = "q1"};
  flight.ways = {way(0, 4, 4), way(4, 8, 6)};
  traj::ContingencyRecord none{.id = "q1", .from = 8, .until = 10};
  none.message = "no way home was found from near (1, 2, 3)";
  flight.ways.push_back(none);
  const std::string svg = traj::figure::home(flight);
  for (const char* words :
       {"q1: a planned way home for 60.0 %", "planned ways home",
        "6.0 to 10.0 s: not enough energy for the planned way home to pad",
        "how long the planned way home takes, at most", "or not the energy for it"}) {
    EXPECT_TRUE(support::says(svg, words)) << words;
  }
  EXPECT_FALSE(support::says(svg, "return proved"));
  flight.ways = {none};
  EXPECT_TRUE(
      support::says(traj::figure::home(flight), "no way home was found from near (1, 2, 3)"));
}

TEST(HomePlot, OfManyGapsSaysHowManyMore) {
  HomeFlight flight{.id = "q1"};
  TimeSpans gaps;
  for (int i = 0; i < 30; ++i) gaps.emplace_back(i, i + 0.5);
  flight.returns = {returns_of(30, gaps)};
  EXPECT_TRUE(support::says(traj::figure::home(flight), "and 16 more"));
}

TEST(HomesPlot, HasTheSmallestShareFirst) {
  std::vector<HomeFlight> flights(3);
  flights[0] = {.id = "most"};
  flights[0].returns = {returns_of(10, {{2, 3}})};
  flights[1] = {.id = "all"};
  flights[1].returns = {returns_of(30, {})};
  flights[2] = {.id = "least"};
  flights[2].returns = {returns_of(10, {{0, 8}})};
  const std::string svg = traj::figure::homes(flights);
  EXPECT_LT(svg.find(">least<"), svg.find(">most<"));
  EXPECT_LT(svg.find(">most<"), svg.find(">all<"));
  for (const char* words : {"3 flights, the smallest share first",
                            "A return is proved from every instant of 1 of 3 flights, and from "
                            "82.0 % of all their time",
                            ">20.0 %<", ">90.0 %<", ">100.0 %<"}) {
    EXPECT_TRUE(support::says(svg, words)) << words;
  }
  EXPECT_FALSE(support::says(svg, "more"));
}

TEST(HomesPlot, OfManyFlightsHasTheFirstAndAHistogramOfAll) {
  std::vector<HomeFlight> flights;
  for (int i = 0; i < 300; ++i) {
    flights.push_back({.id = "f" + std::to_string(i)});
    flights.back().returns = {returns_of(100, {{0, i % 100}})};
  }
  const std::string svg = traj::figure::homes(flights);
  EXPECT_TRUE(support::says(svg, "and 260 more"));
  EXPECT_TRUE(support::says(svg, "how many have which share"));
  EXPECT_EQ(count(svg, ">1.0 %<"), 3u);  // of 99 s without
  EXPECT_LT(svg.size(), 60000u);
}

}  // namespace
