#include <gtest/gtest.h>
#include <sys/mman.h>
#include <unistd.h>

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

TEST(OutputFile, KeepsTheEndOfTheLastLineBackUntilMoreFollows) {
  const int pieces = memfd_create("pieces", 0);
  ASSERT_GE(pieces, 0);
  const auto written = [&] {
    std::string bytes(2 * kLarge, 0);
    bytes.resize(static_cast<std::size_t>(pread(pieces, bytes.data(), bytes.size(), 0)));
    return bytes;
  };
  const std::string lines = std::string(kLarge, 'x') + ",1\n2,3\n";
  OutputFile file("/dev/fd/" + std::to_string(pieces), OutputKind::artefact);
  file.stream() << "a\n" << lines;
  EXPECT_TRUE(written() == "a\n" + lines.substr(0, lines.size() - 3));
  file.stream() << "4,5\n";
  file.pass_on();
  EXPECT_TRUE(written() == "a\n" + lines + "4");
  file.commit_now();
  EXPECT_TRUE(written() == "a\n" + lines + "4,5\n");
  close(pieces);
}

TEST(OutputFile, TellsThatALargePieceCannotBeWritten) {
  OutputFile file("/dev/full", OutputKind::artefact);
  EXPECT_THROW(file.stream() << std::string(kLarge, 'x'), std::exception);
}

}  // namespace
}  // namespace cli
