#include "geom/archive/shard_file.h"

#include <gtest/gtest.h>

#include "support/reading.h"
#include "support/shards.h"

namespace geom {
namespace {

Work work(const std::string& size, const std::string& map = "sha256:1") {
  return {"skyway-x", "1", R"({"size":[")" + size + "\"]}", R"({"map":")" + map + "\"}"};
}

TEST(ShardFile, ComesBackAsItWasWritten) {
  const auto read = support::shards(3, "boxes", [](const Shard& shard) -> PartArrays {
    return {"{\"k\":" + std::to_string(shard.index) + '}', {}, {}};
  });
  ASSERT_EQ(read.size(), 3u);
  EXPECT_EQ(read[2].shard, (Shard{2, 3}));
  EXPECT_EQ(read[2].kind, "boxes");
  EXPECT_EQ(read[2].output, "output");
  EXPECT_EQ(read[2].content, R"({"k":2})");
  EXPECT_TRUE(read[2].yes);
}

TEST(ShardFile, MustBeThereOnceEach) {
  auto read = support::shards(2, "boxes", [](const Shard&) { return PartArrays{"{}", {}, {}}; });
  EXPECT_TRUE(
      support::says(support::refusal_of([&] { complete_shards({read[1]}); }), "found no shard 1"));
  EXPECT_TRUE(support::says(support::refusal_of([&] {
                              complete_shards({read[0], read[1], read[0]});
                            }),
                            "expected each shard once"));
  EXPECT_EQ(complete_shards({read[1], read[0]}).front().shard.index, 0u);
}

TEST(Work, DiffersInWords) {
  EXPECT_EQ(difference(work("5"), work("5")), "");
  EXPECT_EQ(difference(work("5"), work("6")), "the option size 6 instead of 5");
  EXPECT_TRUE(support::says(difference(work("5"), work("5", "sha256:2")), "the input map"));
}

}  // namespace
}  // namespace geom
