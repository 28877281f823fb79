#include "geom/map/map_part.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "geom/base/error.h"
#include "support/random_city.h"
#include "support/shards.h"

namespace geom {
namespace {

MapDraft draft_of(const BoxMap& city) {
  MapDraft draft;
  draft.source = "city";
  for (std::size_t i = 0; i < city.size(); ++i) {
    draft.table.add(city.boxes()[i], city.ids()[i], static_cast<std::uint32_t>(i * 7 % 3));
  }
  draft.table.labels = {"", "Road", "Building"};
  draft.frame = {Axes::neu, GeodeticOrigin{60, 25, 12}, ""};
  draft.options.scale = 0.5;
  draft.options.inflate = 0.25;
  draft.options.floor = -3;
  draft.options.seal = 2;
  draft.options.pad = 7;
  draft.options.headroom = 90;
  draft.history = R"([{"tool":"test"}])";
  return draft;
}

// The boxes of a share.
MapDraft share_of(const MapDraft& whole, const Shard& shard) {
  MapDraft out = whole;
  out.table = {};
  out.table.labels = whole.table.labels;
  const std::size_t all = whole.table.boxes.size();
  for (std::size_t i = shard.begin(all); i < shard.end(all); ++i) {
    out.table.add(whole.table.boxes[i], whole.table.ids[i], whole.table.label[i]);
  }
  return out;
}

TEST(MapPart, SharesOfBoxesJoinToTheMapOfAll) {
  const MapDraft whole = draft_of(support::random_city(4, 60, 200));
  const MadeMap expected = make_map(whole);
  for (const std::size_t count : {1u, 2u, 7u}) {
    std::vector<MapDraft> shares;
    for (std::size_t k = 0; k < count; ++k) shares.push_back(share_of(whole, {k, count}));
    const MadeMap joined = join_map(support::shards(
        count, "boxes", [&](const Shard& shard) { return arrays_of(shares[shard.index]); }));
    EXPECT_EQ(joined.map.hash(), expected.map.hash()) << count;
    EXPECT_EQ(joined.map.spec().history, expected.map.spec().history);
    EXPECT_EQ(joined.map.spec().bounds, expected.map.spec().bounds);
    EXPECT_EQ(joined.sealed, expected.sealed);
    EXPECT_EQ(joined.map.labels(), expected.map.labels());
    EXPECT_TRUE(std::ranges::equal(joined.map.label(), expected.map.label()));
  }
}

TEST(MapPart, SharesOfColumnsJoinToTheMapOfAll) {
  const ColumnSpec spec{1, 0.5, 2, true};
  MapDraft draft = draft_of(support::random_city(4, 1, 200));
  draft.table = {};
  ColumnGrid all(spec);
  ColumnGrid shares[2] = {ColumnGrid(spec), ColumnGrid(spec)};
  support::Random random(8);
  for (int i = 0; i < 300; ++i) {
    const Vec3 p(random.uniform(0, 20), random.uniform(0, 20), random.uniform(0, 9));
    all.add(p);
    shares[static_cast<int>(p.x()) % 2].add(p);
  }
  const MadeMap joined = join_map(support::shards(2, "columns", [&](const Shard& shard) {
    return arrays_of(draft, shares[shard.index], spec);
  }));
  draft.table = all.boxes("cloud");
  EXPECT_EQ(joined.map.hash(), make_map(draft).map.hash());
}

TEST(MapPart, RefusesSharesOfOtherOptionsAndWithoutBoxes) {
  const MapDraft whole = draft_of(support::random_city(4, 10, 200));
  MapDraft other = share_of(whole, {1, 2});
  other.options.scale = 1;
  const MapDraft first = share_of(whole, {0, 2});
  EXPECT_THROW(
      join_map(support::shards(
          2, "boxes", [&](const Shard& shard) { return arrays_of(shard.index ? other : first); })),
      InputError);
  MapDraft none = whole;
  none.table = {};
  EXPECT_THROW(join_map(support::shards(1, "boxes", [&](const Shard&) { return arrays_of(none); })),
               InputError);
}

}  // namespace
}  // namespace geom
