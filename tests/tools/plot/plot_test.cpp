#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "geom/base/error.h"
#include "plot/clearance.h"
#include "plot/comparison.h"
#include "plot/figure.h"
#include "plot/fleet.h"
#include "plot/histogram.h"
#include "plot/motion_profile.h"
#include "plot/plan_view.h"
#include "plot/ticks.h"
#include "plot/tracking.h"
#include "support/random_city.h"

namespace {

using plot::Point;
using support::Random;

bool holds(const std::string& svg, const std::string& words) {
  return svg.find(words) != std::string::npos;
}

TEST(TicksProperty, AreRoundWithinTheRangeAndNeitherFewNorMany) {
  Random random(31);
  for (int i = 0; i < 2000; ++i) {
    const double low = random.uniform(-1, 1) * std::pow(10, random.uniform(-3, 4));
    const double high = low + std::pow(10, random.uniform(-2, 6));
    const auto ticks = plot::ticks(low, high, 4);
    SCOPED_TRACE(testing::Message() << "seed 31, case " << i << ": " << low << " to " << high);
    ASSERT_GE(ticks.size(), 2u);
    ASSERT_LE(ticks.size(), 7u);
    const double step = ticks[1] - ticks[0];
    EXPECT_GE(ticks.front(), low - 1e-6 * step);
    EXPECT_LE(ticks.back(), high + 1e-6 * step);
    const double lead = step / std::pow(10, std::floor(std::log10(step) + 1e-9));
    EXPECT_LT(std::min({std::abs(lead - 1), std::abs(lead - 2), std::abs(lead - 5)}), 1e-6);
  }
}

TEST(Thinned, KeepsEndsAndExtremes) {
  std::vector<Point> points;
  for (int i = 0; i < 100000; ++i) points.push_back({i * 1e-3, std::sin(i * 1e-3)});
  points[34567].y = 9;
  points[76543].y = -9;
  const auto few = plot::thinned(points, 500);
  EXPECT_LE(few.size(), 2000u);
  EXPECT_EQ(few.front().x, points.front().x);
  EXPECT_EQ(few.back().x, points.back().x);
  EXPECT_TRUE(std::is_sorted(few.begin(), few.end(),
                             [](const Point& a, const Point& b) { return a.x < b.x; }));
  const auto has = [&](double y) {
    return std::any_of(few.begin(), few.end(), [&](const Point& p) { return p.y == y; });
  };
  EXPECT_TRUE(has(9));
  EXPECT_TRUE(has(-9));
  EXPECT_EQ(plot::thinned({{0, 1}, {1, 2}}, 500).size(), 2u);
}

TEST(Histogram, HoldsEachValueOnceInRoundBins) {
  Random random(5);
  for (int i = 0; i < 500; ++i) {
    std::vector<double> values;
    const double scale = std::pow(10, random.uniform(-3, 5));
    for (int k = random.below(50); k >= 0; --k) values.push_back(scale * random.uniform(-1, 3));
    const plot::Histogram bars = plot::histogram(values, 40);
    SCOPED_TRACE(testing::Message() << "seed 5, case " << i);
    std::size_t all = 0;
    for (const std::size_t count : bars.counts) all += count;
    EXPECT_EQ(all, values.size());
    EXPECT_LE(bars.counts.size(), 43u);
    for (const double v : values) {
      EXPECT_GE(v, bars.low - 1e-9 * scale);
      EXPECT_LE(v, bars.high() + 1e-9 * scale);
    }
  }
}

TEST(Histogram, OfEqualValuesOrNoneIsOneBin) {
  EXPECT_EQ(plot::histogram({}, 40).counts, std::vector<std::size_t>{0});
  const std::vector<double> zeros(7, 0.0);
  EXPECT_EQ(plot::histogram(zeros, 40).counts, std::vector<std::size_t>{7});
}

TEST(InTheAir, CountsFromDepartureUntilArrival) {
  const std::vector<plot::FleetFlight> flights{
      {"a", 0, 10, {}}, {"b", 5, 10, {}}, {"c", 10, 2, {}}, {"d", 20, 0, {}}};
  const auto steps = plot::in_the_air(flights);
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
  const std::vector<plot::FleetFlight> flights{
      {"a<b", 0, 10, 0.0}, {"c", 5, 10, 5.0}, {"d", 10, 20, 10.0}};
  traj::Approaches approaches{20, {}};
  approaches.list.push_back({{0, 2}, 1.25, 10, {}, {}});
  const std::string svg = plot::fleet(flights, approaches);
  for (const char* words :
       {"3 flights", "2 of 3 flights late", "5 s in the mean", "10 s at most", "1 pair within 20 m",
        "least 1.25 m: a&lt;b and d at 10 s", "2 in the air at once at most, at 5 s"}) {
    EXPECT_TRUE(holds(svg, words)) << words;
  }
  EXPECT_FALSE(holds(svg, "nan"));
  const std::vector<plot::FleetFlight> alone{{"a", 0, 1, {}}};
  EXPECT_TRUE(holds(plot::fleet(alone, {50, {}}), "no pair within 50 m"));
  EXPECT_TRUE(holds(plot::fleet(alone, {50, {}}), "no delays"));
}

TEST(MotionProfile, ShowsUnitsAndLimitsOnce) {
  traj::TrajectoryRecord record;
  record.id = "a<b";
  record.status = traj::TrajectoryStatus::solved;
  traj::State end;
  end.position = {10, 0, 3};
  record.trajectory.segments = {traj::hermite({}, end, 5)};
  record.limits[geom::Limit::speed] = 8;
  record.limits[geom::Limit::tilt] = 0.5;
  const std::string svg = plot::motion_profile(record);
  for (const char* words :
       {"position, m", "speed, m/s", "acceleration, m/s\u00b2", "jerk, m/s\u00b3", "thrust/mass",
        "snap, m/s\u2074",
        "\u222b |jerk|\u00b2 dt = ", "\u222b |snap|\u00b2 dt = ", "m\u00b2/s\u2077", "tilt, \u00b0",
        "time, s", "vmax 8", "tilt 28.65", "a&lt;b: 5.00 s", "east", "north"}) {
    EXPECT_TRUE(holds(svg, words)) << words;
  }
  EXPECT_FALSE(holds(svg, "amax"));
  EXPECT_FALSE(holds(svg, "nan"));
}

TEST(MotionProfile, SaysHowMuchFasterAnyOtherCouldBe) {
  traj::TrajectoryRecord record;
  record.id = "a";
  record.status = traj::TrajectoryStatus::solved;
  traj::State end;
  end.position = {10, 0, 0};
  record.trajectory.segments = {traj::hermite({}, end, 5)};
  record.limits[geom::Limit::speed] = 4;
  EXPECT_FALSE(holds(plot::motion_profile(record), "slower"));
  record.bound = 10;
  record.duration_bound = 2.4;
  EXPECT_TRUE(holds(plot::motion_profile(record), "at most 100.1 % slower than any"));
  record.duration_bound = 2.6;  // 10 m at 4 m/s take 2.5 s
  EXPECT_FALSE(holds(plot::motion_profile(record), "slower"));
}

TEST(Tracking, StatesTheErrors) {
  traj::FlightLog log{"f", "", {}};
  for (int i = 0; i < 4; ++i) {
    traj::FlightSample s;
    s.time = i;
    s.setpoint_position = {i == 2 ? 4.0 : 0.0, 0, 0};
    log.samples.push_back(s);
  }
  const std::string svg = plot::tracking(log);
  EXPECT_TRUE(holds(svg, "f: 3.00 s flown, tracking error 2 m root mean square"));
  EXPECT_TRUE(holds(svg, "largest 4 m"));
  log.samples.resize(1);  // one row has no time to show
  EXPECT_FALSE(holds(plot::tracking(log), "nan"));
}

TEST(Clearance, IsThatOfTheScene) {
  geom::BoxMapSpec spec;
  spec.bounds = {{0, 0, 0}, {100, 100, 50}};
  const geom::BoxMap map(spec, support::table_of({{{40, 0, 0}, {50, 10, 20}}}));
  const geom::CollisionScene scene(map, {"box", {1, 1, 1}}, 0.5);
  const std::vector<geom::Vec3> path = {{20, 5, 5}, {30, 5, 5}, {20, 5, 5}};
  const plot::ClearanceTrack track{"path q", traj::clearance_profile(scene, path, 100)};
  const std::string svg = plot::clearance(scene, std::span(&track, 1), "length, m");
  EXPECT_TRUE(holds(svg, "least 9 m at"));  // 10 m less the vehicle, the margin not counted
  EXPECT_TRUE(holds(svg, "margin 0.5 m"));
  EXPECT_FALSE(holds(svg, "less than the margin"));
}

TEST(Clearance, SaysAndShadesWhatIsLessThanTheMargin) {
  geom::BoxMapSpec spec;
  spec.bounds = {{0, 0, 0}, {100, 100, 50}};
  const geom::BoxMap map(spec, support::table_of({{{40, 0, 0}, {50, 10, 20}}}));
  const geom::CollisionScene scene(map, {"box", {1, 1, 1}}, 0.5);
  const plot::ClearanceTrack tracks[] = {{"path q", {{0, 2, 9}, {2, 5, 0.3}, {5, 6, 0.4995}}}};
  const std::string svg = plot::clearance(scene, tracks, "length, m", " (1 path left out)");
  EXPECT_TRUE(holds(svg, "least 0.3 m at 2 m; less than the margin for 3 m"));
  EXPECT_TRUE(holds(svg, "fill-opacity"));
  EXPECT_TRUE(holds(svg, "(1 path left out)"));
}

TEST(Frame, IsLinearWhereNothingIsShownAtLarge) {
  const plot::Frame frame{10, 20, 100, 200, {-1, -300}, {1, 500}};
  for (const double y : {-300.0, -1.0, 0.0, 1.0, 100.0, 500.0}) {
    EXPECT_NEAR(frame.at({0, y}).y, 20 + 200 * (500 - y) / 800, 1e-9) << y;
  }
}

TEST(Frame, ShowsWhatIsNearAtLarge) {
  plot::Frame frame{0, 0, 100, 200, {0, 0}, {1, 50}, 1};
  EXPECT_DOUBLE_EQ(frame.at({0, 0}).y, 200);
  EXPECT_DOUBLE_EQ(frame.at({0, 1}).y, 110);
  EXPECT_DOUBLE_EQ(frame.at({0, 50}).y, 0);
  frame.high.y = 0.8;  // all of it is near
  EXPECT_DOUBLE_EQ(frame.at({0, 0.4}).y, 100);
}

TEST(PlanView, CountsEachKindByItsName) {
  geom::BoxMapSpec spec;
  spec.bounds = {{0, 0, 0}, {100, 100, 50}};
  const geom::BoxMap map(spec, support::table_of({{{40, 0, 0}, {50, 10, 20}}}));
  const std::vector<geom::Vec3> way = {{0, 0, 5}, {10, 0, 5}};
  const plot::PlanLine lines[] = {{"path", "a", way}, {"path", "b", way}, {"trajectory", "a", way}};
  const std::string svg = plot::plan_view(map, {}, lines);
  EXPECT_TRUE(holds(svg, ">1 box, 2 paths of 20.0 m in all, 1 trajectory of 10.0 m<"));
  EXPECT_TRUE(holds(svg, ">trajectory a<"));
}

// How often the words stand there.
std::size_t count_of(const std::string& svg, const std::string& words) {
  std::size_t out = 0;
  for (auto at = svg.find(words); at != std::string::npos; at = svg.find(words, at + 1)) ++out;
  return out;
}

TEST(PlanView, ShowsAStartAndAnEndAtOnePlace) {
  geom::BoxMapSpec spec;
  spec.bounds = {{0, 0, 0}, {100, 100, 50}};
  const geom::BoxMap map(spec, support::table_of({{{40, 0, 0}, {50, 10, 20}}}));
  const plot::PlanLine lines[] = {{"path", "a", {{0, 0, 5}, {10, 0, 5}}},
                                  {"path", "b", {{10, 0, 5}, {0, 0, 5}}}};
  const std::string svg = plot::plan_view(map, {}, lines);
  const std::size_t last_ring = svg.rfind("r=\"7.50\"");
  EXPECT_EQ(count_of(svg, "r=\"7.50\" fill=\"none\""), 6u) << "two starts and the key, each twice";
  EXPECT_EQ(count_of(svg, "r=\"4.00\""), 3u);
  EXPECT_LT(svg.find("r=\"4.00\""), last_ring) << "the key's ring comes last";
  const std::string before_key = svg.substr(0, last_ring);
  EXPECT_GT(before_key.find("r=\"4.00\""), before_key.find("r=\"7.50\""))
      << "dots above rings, which are open";
}

TEST(PlanView, DrawsOutlinesOfVeryManyBoxesAndBoxesOfFew) {
  std::vector<geom::Aabb> strips;
  for (int house = 0; house < 70; ++house) {
    for (int i = 0; i < 300; ++i) {
      const geom::Vec3 low(0.03 * i + 12 * (house % 10), 12 * (house / 10), 0);
      strips.push_back({low, low + geom::Vec3(0.03, 8 + 0.001 * i, 9)});
    }
  }
  geom::BoxMapSpec spec;
  spec.bounds = {{0, 0, 0}, {120, 90, 50}};
  const std::string many = plot::plan_view(geom::BoxMap(spec, support::table_of(strips)), {}, {});
  EXPECT_LT(many.size(), 30000u);
  EXPECT_EQ(count_of(many, "<path "), 1u) << "all tops are level";
  EXPECT_EQ(count_of(many, "M"), 70u) << "an outline a house";
  strips.resize(300);
  const std::string few = plot::plan_view(geom::BoxMap(spec, support::table_of(strips)), {}, {});
  EXPECT_GT(count_of(few, "<rect "), 300u);
}

TEST(PlanView, LetsTheCityThroughAKeepOutVolume) {
  geom::BoxMapSpec spec;
  spec.bounds = {{0, 0, 0}, {100, 100, 50}};
  geom::BoxTable table =
      support::table_of({{{40, 0, 0}, {50, 10, 20}}, {{0, 0, 0}, {100, 100, 50}}});
  table.labels = {"", "keep-out: all of it"};
  table.label = {0, 1};
  const std::string svg = plot::plan_view(geom::BoxMap(spec, table), {}, {});
  EXPECT_EQ(count_of(svg, "fill-opacity=\"0.12\""), 2u) << "the volume and the key";
  EXPECT_TRUE(holds(svg, ">keep-out<"));
  EXPECT_LT(svg.find("#00000022"), svg.find("fill-opacity"));
}

plot::Comparison parsed(const char* json) {
  return plot::parse_comparison(geom::JsonFields(json, "report.json", 0), "set");
}

TEST(Comparison, ShowsLengthOverTheBestOnlyWhereAllHaveIt) {
  const char* best = R"({"type":"benchmark","methods":[{"method":"a","trials":4,"found":3,)"
                     R"("time_ms":{"mean":0.2,"p50":0.1,"p99":1},)"
                     R"("length_over_reference":{"mean":1.01,"p50":1,"p99":1.1},)"
                     R"("length_over_straight":{"mean":1.3,"p50":1.2,"p99":2}}]})";
  const char* straight =
      R"({"type":"benchmark","methods":[{"method":"b","trials":4,"found":4,)"
      R"("time_ms":{"mean":0.2},"length_over_straight":{"mean":1.3,"p50":1.2,"p99":2}}]})";
  const plot::Comparison both[] = {parsed(best), parsed(straight)};
  EXPECT_TRUE(holds(plot::comparison(std::span(both, 1)), "over the best known"));
  EXPECT_TRUE(holds(plot::comparison(both), "over the straight line"));
  EXPECT_TRUE(holds(plot::comparison(both), "3 of 4"));
}

TEST(Comparison, RefusesOtherRecords) {
  for (const char* json :
       {R"({"type":"path"})", R"({"type":"benchmark"})", R"({"type":"benchmark","methods":[]})",
        R"({"type":"benchmark","methods":[{"method":"a"}]})",
        R"({"type":"benchmark","methods":[{"method":"a","trials":-1,"found":0}]})"}) {
    EXPECT_THROW(parsed(json), geom::InputError) << json;
  }
}

}  // namespace
