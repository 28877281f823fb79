#include "traj/submit/manifest.h"

#include <gtest/gtest.h>

#include "geom/base/error.h"

namespace {

using traj::listed_file;
using traj::ListedFile;

TEST(Manifest, ComesBackInTheOrderOfPaths) {
  const std::vector<ListedFile> files{listed_file("b/c", "x"), listed_file("a", "abc")};
  const auto read = traj::read_manifest(traj::to_json(files, "skyway"), "manifest.json");
  ASSERT_EQ(read.size(), 2u);
  EXPECT_EQ(read[0].path, "a");
  EXPECT_TRUE(read[0].sha256.starts_with("ba7816bf"));
  EXPECT_EQ(read[1], files[0]);
}

TEST(Manifest, NamesWhatIsMissingMoreOrChanged) {
  const std::vector<ListedFile> listed{listed_file("a", "1"), listed_file("c", "2")};
  const auto why = [&](std::vector<ListedFile> found) {
    return traj::why_not_as_listed(listed, found).value_or("");
  };
  EXPECT_EQ(why(listed), "");
  EXPECT_EQ(why({listed[0]}), "c is missing");
  EXPECT_EQ(why({listed[1]}), "a is missing");
  EXPECT_EQ(why({}), "a is missing");
  EXPECT_EQ(why({listed[0], listed_file("b", ""), listed[1]}), "b is not in the manifest");
  EXPECT_TRUE(why({listed[0], listed_file("c", "3")}).starts_with("c was changed"));
}

TEST(Manifest, LeadsNowhereElse) {
  for (const char* path : {"../a", "/a", "a/../b", "a//b", "./a", "a\\b", ""}) {
    const std::string json = traj::to_json({listed_file(path, "1")}, "skyway");
    EXPECT_THROW(traj::read_manifest(json, "m"), geom::InputError) << path;
  }
  const std::string twice = traj::to_json({listed_file("a", "1"), listed_file("a", "1")}, "skyway");
  EXPECT_THROW(traj::read_manifest(twice, "m"), geom::InputError);
}

}  // namespace
