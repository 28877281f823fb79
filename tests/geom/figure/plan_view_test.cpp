#include "geom/figure/plan_view.h"

#include <gtest/gtest.h>

#include "support/random_city.h"
#include "support/reading.h"
#include "support/small_map.h"

namespace {

TEST(PlanView, CountsEachKindByItsName) {
  const geom::BoxMap map =
      support::map_of({{0, 0, 0}, {100, 100, 50}}, {{{40, 0, 0}, {50, 10, 20}}});
  const std::vector<geom::Vec3> way = {{0, 0, 5}, {10, 0, 5}};
  const geom::figure::PlanLine lines[] = {
      {"path", "a", way}, {"path", "b", way}, {"trajectory", "a", way}};
  const std::string svg = geom::figure::plan_view(map, {}, lines);
  EXPECT_TRUE(support::says(svg, ">1 box, 2 paths of 20.0 m in all, 1 trajectory of 10.0 m<"));
  EXPECT_TRUE(support::says(svg, ">trajectory a<"));
}

// How often the words stand there.
std::size_t count_of(const std::string& svg, const std::string& words) {
  std::size_t out = 0;
  for (auto at = svg.find(words); at != std::string::npos; at = svg.find(words, at + 1)) ++out;
  return out;
}

TEST(PlanView, ShowsAStartAndAnEndAtOnePlace) {
  const geom::BoxMap map =
      support::map_of({{0, 0, 0}, {100, 100, 50}}, {{{40, 0, 0}, {50, 10, 20}}});
  const geom::figure::PlanLine lines[] = {{"path", "a", {{0, 0, 5}, {10, 0, 5}}},
                                          {"path", "b", {{10, 0, 5}, {0, 0, 5}}}};
  const std::string svg = geom::figure::plan_view(map, {}, lines);
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
  const geom::Aabb bounds{{0, 0, 0}, {120, 90, 50}};
  const std::string many = geom::figure::plan_view(support::map_of(bounds, strips), {}, {});
  EXPECT_LT(many.size(), 30000u);
  EXPECT_EQ(count_of(many, "<path "), 1u) << "all tops are level";
  EXPECT_EQ(count_of(many, "M"), 70u) << "an outline a house";
  strips.resize(300);
  const std::string few = geom::figure::plan_view(support::map_of(bounds, strips), {}, {});
  EXPECT_GT(count_of(few, "<rect "), 300u);
}

TEST(PlanView, LetsTheCityThroughAKeepOutVolume) {
  geom::BoxTable table =
      support::table_of({{{40, 0, 0}, {50, 10, 20}}, {{0, 0, 0}, {100, 100, 50}}});
  table.labels = {"", "keep-out: all of it"};
  table.label = {0, 1};
  const std::string svg =
      geom::figure::plan_view({{.bounds = {{0, 0, 0}, {100, 100, 50}}}, table}, {}, {});
  EXPECT_EQ(count_of(svg, "fill-opacity=\"0.12\""), 2u) << "the volume and the key";
  EXPECT_TRUE(support::says(svg, ">keep-out<"));
  EXPECT_LT(svg.find("#00000022"), svg.find("fill-opacity"));
}

}  // namespace
