#include "geom/base/open_file.h"

#include <gtest/gtest.h>

#include <array>
#include <fstream>
#include <system_error>

#include "support/temporary_folder.h"

namespace {

TEST(OpenFile, GivesTheFileFromItsBeginning) {
  const support::TemporaryFolder folder;
  const std::string path = folder / "text";
  std::ofstream(path) << "one two";
  const auto file = geom::open_file(path);
  std::string word;
  *file >> word;
  EXPECT_EQ(word, "one");
}

TEST(OpenFile, SaysThatAFileCannotBeRead) {
  EXPECT_THROW(geom::open_file("/nowhere/at/all"), std::system_error);
  EXPECT_THROW(geom::open_file("/"), std::system_error);
}

TEST(OpenFile, SaysThatSomebodyWroteToTheFile) {
  const support::TemporaryFolder folder;
  const std::string path = folder / "text";
  std::ofstream(path) << "one";
  const auto file = geom::open_file(path);
  std::ofstream(path, std::ios::app) << " two";
  std::string text;
  EXPECT_THROW(std::getline(*file, text), std::runtime_error);
}

TEST(RandomFile, ReadsAnywhere) {
  const support::TemporaryFolder folder;
  const std::string path = folder / "bytes";
  std::ofstream(path) << "0123456789";
  const geom::RandomFile input(path);
  EXPECT_EQ(input.size(), 10u);
  std::array<unsigned char, 4> four{};
  EXPECT_EQ(input.read(6, four), 4u);
  EXPECT_EQ(std::string(four.begin(), four.end()), "6789");
  EXPECT_EQ(input.read(0, four), 4u);
  EXPECT_EQ(std::string(four.begin(), four.end()), "0123");
  EXPECT_EQ(input.read(8, four), 2u);
  EXPECT_EQ(input.read(10, four), 0u);
  EXPECT_EQ(input.read(~std::uint64_t{0} - 2, four), 0u);
}

TEST(RandomFile, SaysThatAFileCannotBeRead) {
  EXPECT_THROW(geom::RandomFile("/nowhere/at/all"), std::system_error);
  const geom::RandomFile folder("/");
  std::array<unsigned char, 4> four{};
  EXPECT_THROW(folder.read(0, four), std::system_error);
}

}  // namespace
