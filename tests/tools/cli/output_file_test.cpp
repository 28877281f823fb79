#include <gtest/gtest.h>

#include <exception>
#include <fstream>
#include <iterator>
#include <string>

#include "cli/file/files.h"

namespace cli {
namespace {

constexpr std::size_t kLarge = 300'000;  // more than what it writes at once

TEST(OutputFile, KeepsTheOrderOfSmallAndLargePieces) {
  const std::string path = testing::TempDir() + "output_file_pieces.bin";
  const std::string large(kLarge, 'x');
  {
    OutputFile file(path, OutputKind::artefact);
    file.stream() << "a" << large << "b" << large << "c";
    file.commit_now();
  }
  std::ifstream in(path, std::ios::binary);
  const std::string read{std::istreambuf_iterator<char>(in), {}};
  EXPECT_TRUE(read == "a" + large + "b" + large + "c");
}

TEST(OutputFile, TellsThatALargePieceCannotBeWritten) {
  OutputFile file("/dev/full", OutputKind::artefact);
  EXPECT_THROW(file.stream() << std::string(kLarge, 'x'), std::exception);
}

}  // namespace
}  // namespace cli
