#include "geom/map/map_doubts.h"

#include <gtest/gtest.h>

#include "geom/map/derive.h"
#include "support/random_city.h"

namespace geom {
namespace {

BoxMap with_history(const std::string& history) {
  return {{.bounds = {{0, 0, 0}, {100, 100, 50}}, .history = history},
          support::table_of({{{0, 0, 0}, {10, 20, 30}}})};
}

MapDoubts doubts(const std::string& history) { return doubts_of(with_history(history).spec()); }

TEST(DoubtsOf, SaysWhatTheSourcesLeftOpen) {
  EXPECT_FALSE(doubts("").any());
  EXPECT_FALSE(doubts(R"([{"unknown":"blocked"},{"pad":3}])").any());
  EXPECT_FALSE(doubts(R"([{"tool":"skyway-cloud","gap":2}])").any()) << "one of points";
  EXPECT_EQ(doubts(R"([{"skipped":2},{"skipped":1}])"), (MapDoubts{.skipped = 3}));
  EXPECT_EQ(doubts(R"([{"unknown":"blocked"},{"unknown":"free"}])"),
            (MapDoubts{.unknown_free = true}));
}

TEST(DoubtsOf, SaysThatBoundsWereMadeWider) {
  const BoxMap map = with_history("");
  const auto widened = [&](const BoundsChange& change) {
    return doubts_of(with_bounds(map, change, "m").map.spec()).widened;
  };
  EXPECT_TRUE(widened({.ceiling = 60}));
  EXPECT_TRUE(widened({.bounds = Aabb{{-1, 0, 0}, {9, 9, 9}}}));
  EXPECT_FALSE(widened({.ceiling = 40}));
}

TEST(DoubtsOf, LooksAtAllMapsOfAJoin) {
  const SourceMap maps[] = {{"a", with_history("")},
                            {"b", with_history(R"([{"skipped":2,"unknown":"free"}])")}};
  EXPECT_EQ(doubts_of(join(maps).spec()), (MapDoubts{.skipped = 2, .unknown_free = true}));
}

}  // namespace
}  // namespace geom
