#include "geom/cloud/draft_cloud.h"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>
#include <stdexcept>

#include "geom/base/error.h"
#include "geom/base/open_file.h"
#include "geom/base/usage_error.h"
#include "support/temporary_folder.h"

namespace geom {
namespace {

// Two towers of three returns each, and a point alone.
constexpr const char* kPoints =
    "0.5 0.5 1\n0.5 0.6 2\n0.5 0.5 3\n20.5 0.5 1\n20.5 0.6 2\n20.5 0.5 3\n60 60 9\n";

MapDraft drafted(const std::string& text, const CloudDraftOptions& options = {},
                 unsigned threads = 1) {
  std::istringstream in(text);
  HashedStream first(in);
  const OpenFile again = [&](const std::string&) {
    return std::make_shared<std::istringstream>(text);
  };
  return draft_cloud({"cloud", first, again, nullptr}, options, {}, {threads, {}});
}

std::size_t fact(const MapDraft& draft, const std::string& name) {
  for (const auto& [what, value] : draft.facts) {
    if (what == name) return std::get<std::size_t>(value);
  }
  return ~std::size_t{0};
}

TEST(DraftCloud, MakesColumnsOfAllPoints) {
  const MapDraft draft = drafted(kPoints);
  EXPECT_EQ(fact(draft, "points"), 7u);
  EXPECT_EQ(fact(draft, "kept"), 7u);
  EXPECT_EQ(draft.table.boxes.size(), 3u);
}

// The second reading would find another cloud than the first.
TEST(DraftCloud, RefusesAFileThatChangesBetweenItsReadings) {
  const support::TemporaryFolder folder;
  const std::string path = folder / "cloud.xyz";
  std::ofstream(path) << kPoints;
  CloudDraftOptions options;
  options.drop_ground = true;
  options.ground_by = "shape";
  for (const bool changes : {false, true}) {
    const auto in = open_file(path);
    HashedStream first(*in);
    const OpenFile again = [&](const std::string& name) {
      if (changes) std::ofstream(name, std::ios::app) << "1 1 1\n";
      return open_file(name);
    };
    const auto draft = [&] { return draft_cloud({path, first, again, nullptr}, options); };
    if (changes) {
      EXPECT_THROW(draft(), std::runtime_error);
    } else {
      EXPECT_EQ(fact(draft(), "points"), 7u);
    }
  }
}

// More points than one batch has: a slope, and towers on it.
std::string many_points() {
  std::string text;
  for (int i = 0; i < 2200000; ++i) {
    const int x = i * 7 % 211;
    const int y = i * 13 % 307;
    text += std::to_string(x) + ' ' + std::to_string(y) + ' ' +
            std::to_string(x / 20 + (x % 50 < 5 && y % 40 < 5 ? i % 30 : 0)) + '\n';
  }
  return text;
}

TEST(DraftCloud, IsTheSameForAnyNumberOfThreads) {
  const std::string text = many_points();
  CloudDraftOptions options;
  options.ground_by = "shape";
  for (const bool drop_ground : {false, true}) {
    options.drop_ground = drop_ground;
    const MapDraft one = drafted(text, options, 1);
    EXPECT_EQ(fact(one, "points"), 2200000u);
    const MapDraft other = drafted(text, options, 3);
    EXPECT_EQ(other.facts, one.facts);
    EXPECT_TRUE(other.table.boxes == one.table.boxes);
    EXPECT_EQ(other.table.ids, one.table.ids);
  }
}

TEST(DraftCloud, TellsTheFirstFaultForAnyNumberOfThreads) {
  CloudDraftOptions options;
  options.columns.cell = 1e-3;
  std::string text = "0 0 1\n9e6 0 1\n8e6 0 1\n";  // the second is beyond 2^31 cells
  for (int i = 0; i < 20000; ++i) text += "1 2 3\n";
  for (const unsigned threads : {1u, 3u}) {
    try {
      drafted(text + "1 2 west\n", options, threads);
      ADD_FAILURE() << "accepted";
    } catch (const InputError& error) {
      EXPECT_EQ(error.fault().found, "9000000") << error.what();
    }
  }
}

TEST(DraftCloud, MakesABoxAnObject) {
  CloudDraftOptions options;
  options.objects = true;
  options.tolerance = 1.5;
  options.min_points = 2;
  const MapDraft draft = drafted(kPoints, options);
  EXPECT_EQ(draft.table.boxes.size(), 2u);
  EXPECT_EQ(fact(draft, "dropped_in_small_objects"), 1u);
  EXPECT_EQ(draft.table.boxes[0], (Aabb{{0.5, 0.5, 1}, {0.5, 0.6, 3}}));
}

TEST(DraftCloud, TellsHowTheGroundIsToldAndReadsAgain) {
  CloudDraftOptions options;
  options.drop_ground = true;
  std::string told;
  options.ground_told = [&](const std::string& by) { told = by; };
  const MapDraft draft = drafted(kPoints, options);
  EXPECT_EQ(told, "shape");
  EXPECT_EQ(fact(draft, "points"), 7u);
  EXPECT_EQ(fact(draft, "dropped_as_ground") + fact(draft, "kept"), 7u);
}

TEST(DraftCloud, RefusesWhatLeavesNothingOrContradicts) {
  CloudDraftOptions options;
  options.objects = true;
  options.min_points = 9;
  EXPECT_THROW(drafted(kPoints, options), InputError);
  EXPECT_THROW(drafted(""), InputError);
  options.resolution = 2;
  EXPECT_THROW(drafted(kPoints, options), UsageError);
  CloudDraftOptions fine;
  fine.resolution = 2;  // of a file that is no COPC
  EXPECT_THROW(drafted(kPoints, fine), InputError);
}

}  // namespace
}  // namespace geom
