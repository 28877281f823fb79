#include "cli/option/memory.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "support/temporary_folder.h"

namespace cli {
namespace {

TEST(ParseBytes, KnowsSuffixes) {
  EXPECT_EQ(parse_bytes("0"), 0u);
  EXPECT_EQ(parse_bytes("4096"), 4096u);
  EXPECT_EQ(parse_bytes("64k"), 65536u);
  EXPECT_EQ(parse_bytes("64K"), 65536u);
  EXPECT_EQ(parse_bytes("512M"), std::size_t{1} << 29);
  EXPECT_EQ(parse_bytes("1.5g"), std::size_t{3} << 29);
}

TEST(ParseBytes, RefusesWhatIsNone) {
  for (const char* text : {"", "k", "-1", "5 M", "5MB", "5T", "nan", "inf", "1e30", "0x10"}) {
    EXPECT_FALSE(parse_bytes(text)) << text;
  }
}

TEST(FairShare, IsSomethingAndNoMoreThanAQuarterOfTheMachine) {
  EXPECT_GT(fair_share(), 0u);
  EXPECT_LE(fair_share(), std::size_t{1} << 50);
}

void write(const std::filesystem::path& path, const char* text) {
  std::filesystem::create_directories(path.parent_path());
  std::ofstream(path) << text << '\n';
}

TEST(CgroupLimit, IsTheLeastOfAGroupAndThoseAboveIt) {
  const support::TemporaryFolder folder;
  const std::filesystem::path root = folder.path();
  EXPECT_FALSE(cgroup_limit("0::/\n", root.string()));
  write(root / "a/memory.max", "1000000");
  write(root / "a/b/memory.max", "max");
  EXPECT_EQ(cgroup_limit("0::/a/b\n", root.string()), 1000000u);
  write(root / "a/b/memory.max", "5000");
  EXPECT_EQ(cgroup_limit("0::/a/b\n", root.string()), 5000u);
  EXPECT_EQ(cgroup_limit("0::/a\n", root.string()), 1000000u);
  EXPECT_FALSE(cgroup_limit("0::/c\n", root.string()));
}

TEST(CgroupLimit, ReadsTheFirstVersionToo) {
  const support::TemporaryFolder folder;
  const std::filesystem::path root = folder.path();
  write(root / "memory/job/memory.limit_in_bytes", "777");
  EXPECT_EQ(cgroup_limit("5:cpu:/\n4:blkio,memory:/job\nnonsense\n", root.string()), 777u);
  EXPECT_FALSE(cgroup_limit("4:memorial:/job\n", root.string()));
}

}  // namespace
}  // namespace cli
