#include "cli/file/random_input.h"

#include <gtest/gtest.h>

#include <array>
#include <filesystem>
#include <fstream>
#include <system_error>

#include "geom/base/sha256.h"
#include "support/temporary_folder.h"

namespace {

TEST(RandomInput, ReadsAnywhereAndSumsWhatWasRead) {
  const support::TemporaryFolder folder;
  const std::string path = folder / "bytes";
  std::ofstream(path) << "0123456789";
  cli::RandomInput input(path);
  EXPECT_EQ(input.size(), 10u);
  std::array<unsigned char, 4> four{};
  EXPECT_EQ(input.read(6, four), 4u);
  EXPECT_EQ(std::string(four.begin(), four.end()), "6789");
  EXPECT_EQ(input.read(0, four), 4u);
  EXPECT_EQ(std::string(four.begin(), four.end()), "0123");
  EXPECT_EQ(input.read(8, four), 2u);
  EXPECT_EQ(input.read(10, four), 0u);
  EXPECT_EQ(input.read(~std::uint64_t{0} - 2, four), 0u);
  geom::Sha256 sum;
  sum.update(std::as_bytes(std::span("6789012389", 10)));
  EXPECT_EQ(input.hash_of_read(), "sha256:" + sum.hex());
}

TEST(RandomInput, SaysThatAFileCannotBeRead) {
  EXPECT_THROW(cli::RandomInput("/nowhere/at/all"), std::system_error);
  cli::RandomInput folder("/");
  std::array<unsigned char, 4> four{};
  EXPECT_THROW(folder.read(0, four), std::system_error);
}

}  // namespace
