#include "cli/file/recognise.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

namespace cli {
namespace {

TEST(RecogniseFile, LooksAtTheFirstBytesAndTheNameOfRegularFilesAlone) {
  const auto folder = std::filesystem::temp_directory_path() / "skyway_recognise_test";
  std::filesystem::create_directories(folder / "folder.obj");
  std::ofstream(folder / "a.txt") << "%PDF-1.7";
  std::ofstream(folder / "house.obj") << "v 1 2 3\n";
  std::ofstream(folder / "empty.obj");
  EXPECT_EQ(head_of(folder / "a.txt"), "%PDF-1.7");
  EXPECT_EQ(recognise_file(folder / "a.txt")->what, "a PDF document");
  EXPECT_EQ(recognise_file(folder / "house.obj")->what, "an OBJ model");
  EXPECT_EQ(recognise_file(folder / "empty.obj"), nullptr);
  EXPECT_EQ(recognise_file(folder / "folder.obj"), nullptr);
  EXPECT_EQ(recognise_file(folder / "missing.obj"), nullptr);
  std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace cli
