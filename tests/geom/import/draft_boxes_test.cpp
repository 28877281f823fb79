#include "geom/import/draft_boxes.h"

#include <gtest/gtest.h>

#include <sstream>

#include "geom/base/error.h"
#include "geom/base/usage_error.h"
#include "support/reading.h"

namespace geom {
namespace {

constexpr const char* kBlocks = "boundary 0 0 0 10 10 5\nblock 1 1 0 2 3 4 255 0 0\n";

struct Said {
  std::vector<std::string> remarks;
  std::vector<std::string> warnings;

  Notes notes() {
    return {[this](const std::string& text) { remarks.push_back(text); },
            [this](const std::string& text) { warnings.push_back(text); }};
  }
};

MapDraft drafted(const std::string& text, const BoxDraftOptions& options = {},
                 const Notes& notes = {}) {
  std::istringstream in(text);
  HashedStream file(in);
  return draft_boxes(file, "file", options, notes);
}

TEST(DraftBoxes, MakesTheMapOfTheReader) {
  const MadeMap expected =
      make_map(import_boxes(support::Text(kBlocks), kBlockText, "file"), "file");
  const MadeMap made = make_map(drafted(kBlocks));
  EXPECT_EQ(made.map.hash(), expected.map.hash());
  EXPECT_TRUE(support::says(made.map.spec().history, R"("format":"block-text")"));
  EXPECT_TRUE(support::says(made.map.spec().history, "sha256:"));
}

TEST(DraftBoxes, TakesTheOptionsBeforeWhatTheFileSays) {
  BoxDraftOptions options;
  options.unit = 0.5;
  options.axes = Axes::neu;
  options.map.ceiling = 4;
  const MadeMap made = make_map(drafted(kBlocks, options));
  EXPECT_EQ(made.map.spec().frame.axes, Axes::neu);
  EXPECT_EQ(made.map.spec().bounds, (Aabb{{0, 0, 0}, {5, 5, 4}}));
}

TEST(DraftBoxes, RefusesPadForAFileWithBounds) {
  for (const double pad : {0.0, 2.0}) {
    BoxDraftOptions options;
    options.map.pad = pad;
    EXPECT_THROW(drafted(kBlocks, options), UsageError) << pad;
  }
}

TEST(DraftBoxes, RefusesWhatCannotBeBuiltUnlessThatIsAllowed) {
  const std::string text = std::string(kBlocks) + "window 1 1 0 2 3 4\n";
  EXPECT_TRUE(support::says(support::refusal_of([&] { drafted(text); }), "--allow-skipped"));
  BoxDraftOptions options;
  options.allow_skipped = true;
  Said said;
  const MadeMap made = make_map(drafted(text, options, said.notes()));
  EXPECT_EQ(skipped_in(made.map.spec()), 1u);
  ASSERT_EQ(said.warnings.size(), 1u);
  EXPECT_TRUE(support::says(said.warnings[0], "file: 1 possible obstacle is left out"));
}

TEST(DraftBoxes, RefusesAModelThatIsNotThere) {
  BoxDraftOptions options;
  options.without = {"drone"};
  EXPECT_THROW(drafted("<sdf version='1.9'><world name='w'></world></sdf>", options), InputError);
}

TEST(DraftBoxes, RefusesAFileWithoutObstacles) {
  EXPECT_THROW(make_map(drafted("boundary 0 0 0 10 10 5\n")), InputError);
}

}  // namespace
}  // namespace geom
