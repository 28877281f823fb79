#include "plan/bench/query_set.h"

#include <gtest/gtest.h>

#include "geom/base/error.h"
#include "support/walled_scene.h"

namespace plan::bench {
namespace {

const geom::CollisionScene& scene() { return support::walled_scene(); }

TEST(QuerySet, DrawsWhatWasAskedForAndTheSameEachTime) {
  RandomSpec spec;
  spec.ends = Ends::street_blocked;
  spec.length = {40, 60};
  QuerySet set(scene(), spec);
  QuerySet again(scene(), spec);
  again.at(150);
  for (std::size_t i = 0; i < 200; ++i) {
    const geom::PlanQuery& query = set.at(i);
    EXPECT_TRUE(scene().free(query.from) && scene().free(query.to));
    EXPECT_FALSE(scene().free(query.from, query.to));
    EXPECT_LE(std::max(query.from.z(), query.to.z()), 30);
    EXPECT_GE((query.to - query.from).norm(), 40 - 1e-9);
    EXPECT_LE((query.to - query.from).norm(), 60 + 1e-9);
    EXPECT_EQ(query.to, again.at(i).to);
  }
  EXPECT_GT(set.rejected().outside + set.rejected().blocked, 0u);
  EXPECT_GT(set.rejected().line_free, 0u);
}

TEST(QuerySet, GivesUp) {
  RandomSpec spec;
  spec.length = {200, 300};
  QuerySet set(scene(), spec);
  EXPECT_THROW(set.at(0), geom::InputError);
}

}  // namespace
}  // namespace plan::bench
