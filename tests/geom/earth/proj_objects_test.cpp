#include "earth/proj_objects.h"

#include <gtest/gtest.h>

#include "geom/earth/proj_way.h"
#include "support/short_memory.h"

namespace geom {
namespace {

using support::expect_bad_alloc_where_one_is_swallowed;

TEST(WatchedProj, WatchesWhileASystemIsLookedUp) {
  expect_bad_alloc_where_one_is_swallowed([] { EXPECT_TRUE(ProjReference::of("EPSG:28992")); });
}

TEST(WatchedProj, WatchesWhileAWayIsSearched) {
  expect_bad_alloc_where_one_is_swallowed(
      [] { EXPECT_TRUE(ProjWay::to_places(*ProjReference::of("EPSG:28992"))); });
}

// A way that was found is not searched again, but its last steps are made.
TEST(WatchedProj, WatchesWhileThePlaneIsMade) {
  const auto system = ProjReference::of("EPSG:25832");
  EXPECT_TRUE(ProjWay::to_places(*system));
  expect_bad_alloc_where_one_is_swallowed([&] {
    EXPECT_TRUE(ProjWay::to_plane(*system, {47.8, 9, 0}));
  });
}

}  // namespace
}  // namespace geom
