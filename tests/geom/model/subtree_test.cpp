#include "model/subtree.h"

#include <gtest/gtest.h>

#include "geom/base/error.h"
#include "support/reading.h"
#include "support/subtree_file.h"

namespace geom {
namespace {

using support::json;
using support::SubtreeFile;

// A quadtree of two levels: a root with the children (0, 0) and (1, 1), of which the first has
// content.
const SubtreeFile kGood("11001", {"01000"}, "1000000000000010");
constexpr SubtreeShape kShape{4, 2, 1};

Subtree read(const std::string& bytes, const SubtreeShape& shape = kShape,
             const std::string& other = {}) {
  return Subtree("a/0.subtree", shape, [&](const std::string& path) {
    EXPECT_TRUE(path == "a/0.subtree" || path == "a/bits.bin") << path;
    return path == "a/0.subtree" ? bytes : other;
  });
}

void expect_refusal(const std::string& bytes, const std::string& message,
                    const SubtreeShape& shape = kShape) {
  const std::string found = support::refusal_of([&] { read(bytes, shape); });
  EXPECT_TRUE(support::says(found, message));
}
void expect_refusal(const SubtreeFile& file, const std::string& message,
                    const SubtreeShape& shape = kShape) {
  expect_refusal(file.bytes(), message, shape);
}

TEST(Subtree, SaysWhichTilesContentsAndSubtreesThereAre) {
  const Subtree made = read(kGood.bytes());
  EXPECT_TRUE(made.has_tile(0, 0));
  EXPECT_TRUE(made.has_tile(1, 0));
  EXPECT_FALSE(made.has_tile(1, 1));
  EXPECT_FALSE(made.has_tile(1, 2));
  EXPECT_TRUE(made.has_tile(1, 3));
  EXPECT_FALSE(made.has_content(0, 0, 0));
  EXPECT_TRUE(made.has_content(0, 1, 0));
  EXPECT_FALSE(made.has_content(0, 1, 3));
  EXPECT_FALSE(made.has_content(1, 1, 0));
  EXPECT_TRUE(made.has_child(0));
  EXPECT_FALSE(made.has_child(13));
  EXPECT_TRUE(made.has_child(14));
}

TEST(Subtree, TakesOneAnswerForAllAndNoContentsAtAll) {
  const Subtree made = read(SubtreeFile("1", {}, "0").bytes());
  EXPECT_TRUE(made.has_tile(1, 2));
  EXPECT_FALSE(made.has_content(0, 1, 2));
  EXPECT_FALSE(made.has_child(15));
  const Subtree octree = read(SubtreeFile("1", {"1", "0"}, "1").bytes(), {8, 1, 2});
  EXPECT_TRUE(octree.has_content(0, 0, 0));
  EXPECT_FALSE(octree.has_content(1, 0, 0));
  EXPECT_TRUE(octree.has_child(7));
}

TEST(Subtree, ReadsJsonWithBitsInAnotherFile) {
  SubtreeFile file = kGood;
  file.text["buffers"][0]["uri"] = "bits.bin";
  EXPECT_TRUE(read(file.text.dump(), kShape, file.binary).has_tile(1, 3));
  EXPECT_TRUE(support::says(support::refusal_of([&] { read(file.text.dump(), kShape, ""); }),
                            "expected 4 bytes, as it says, found 0"));
}

TEST(Subtree, RefusesWhatIsCutAndWhatLies) {
  const std::string whole = kGood.bytes();
  for (std::size_t n = 4; n < whole.size(); n += 7) {
    EXPECT_NE(support::refusal_of([&] { read(whole.substr(0, n)); }), "") << n;
  }
  SubtreeFile file = kGood;
  file.text["tileAvailability"]["availableCount"] = 4;
  expect_refusal(file, "expected 4 available, as it says, found 3");
  file = kGood;
  file.text["tileAvailability"]["constant"] = 1;
  expect_refusal(file, "expected a constant of 0 or 1, or a bitstream");
  file = kGood;
  file.text["tileAvailability"] = {{"constant", 2}};
  expect_refusal(file, "expected a constant of 0 or 1");
  file = kGood;
  file.text["tileAvailability"] = {{"bufferView", 0}};
  expect_refusal(file, "expected a whole number as \"bitstream\"");
  file = kGood;
  file.text.erase("childSubtreeAvailability");
  expect_refusal(file, "childSubtreeAvailability");
  file = kGood;
  file.text["bufferViews"][1]["byteLength"] = 1;
  expect_refusal(file, "expected 16 bits, found 1 bytes");
  file = kGood;
  file.text["bufferViews"][0]["byteOffset"] = 4;
  expect_refusal(file, "expected it within the 4 bytes of its buffer");
  file = kGood;
  file.text["extensions"]["3DTILES_multiple_contents"] = json::object();
  expect_refusal(file, "3DTILES_multiple_contents is not read");
  expect_refusal(kGood, "expected contentAvailability of 2 contents, found 1", {4, 2, 2});
  expect_refusal(kGood, "bits, found", {4, 3, 1});
}

TEST(Subtree, RefusesWhatWouldHangBelowNothing) {
  expect_refusal(SubtreeFile("01000", {"0"}, "0"), "a tile below is available at level 0");
  expect_refusal(SubtreeFile("11000", {"00010"}, "0"), "content is available at level 1");
  expect_refusal(SubtreeFile("11000", {"0"}, "0000100000000000"),
                 "a subtree below is available at level 1 of the subtree, place 1");
  expect_refusal(SubtreeFile("0", {"1"}, "1"), "expected the tile that it begins with, found none");
}

}  // namespace
}  // namespace geom
