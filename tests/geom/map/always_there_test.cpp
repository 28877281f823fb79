#include "geom/map/always_there.h"

#include <gtest/gtest.h>

#include "geom/map/join.h"
#include "support/random_city.h"

namespace geom {
namespace {

TEST(AlwaysThere, IsTheMapToWhichTimedBoxesWereAdded) {
  const BoxMap city = support::random_city(3, 60, 200);
  BoxMapSpec spec = city.spec();
  spec.epoch = "2026-05-04T06:30:00Z";
  BoxTable table = table_of(city);
  table.add({{1, 2, 3}, {4, 5, 6}}, 900);
  table.set_time(table.boxes.size() - 1, {5, 6});
  const BoxMap timed(spec, table);
  EXPECT_NE(timed.hash(), city.hash());
  EXPECT_EQ(always_there(timed).hash(), city.hash());
  EXPECT_EQ(always_there(city).hash(), city.hash());
}

}  // namespace
}  // namespace geom
