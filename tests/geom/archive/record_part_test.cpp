#include "geom/archive/record_part.h"

#include <gtest/gtest.h>

#include "geom/base/error.h"
#include "support/shards.h"

namespace geom {
namespace {

RecordPart share_of(const std::vector<std::string>& records, const Shard& shard) {
  RecordPart out;
  out.head = "head\n";
  for (const std::size_t i : shard.items(records.size())) {
    out.text += records[i];
    out.ends.push_back(out.text.size());
  }
  return out;
}

TEST(RecordPart, SharesJoinToTheStream) {
  const std::vector<std::string> records = {"a\n", "bb\nbb\n", "", "d\n", "eee\n"};
  for (const std::size_t count : {1u, 2u, 3u, 7u}) {
    std::vector<RecordPart> shares;
    for (std::size_t k = 0; k < count; ++k) shares.push_back(share_of(records, {k, count}));
    std::ostringstream joined;
    join_records(joined, support::shards(count, "records", [&](const Shard& shard) {
                   return arrays_of(shares[shard.index], records.size());
                 }));
    EXPECT_EQ(joined.str(), "head\na\nbb\nbb\nd\neee\n") << count;
  }
}

TEST(RecordPart, RefusesAShareThatHoldsTooFewOrEndsOutside) {
  RecordPart part = share_of({"a\n", "b\n"}, {});
  std::ostringstream out;
  const auto join = [&](std::size_t total) {
    join_records(
        out, support::shards(1, "records", [&](const Shard&) { return arrays_of(part, total); }));
  };
  EXPECT_THROW(join(3), InputError);
  part.ends.back() = 9;
  EXPECT_THROW(join(2), InputError);
}

}  // namespace
}  // namespace geom
