// make_laz LAS|COUNT FORMAT VERSION one_stream|fixed|varying EXTRA FILE: the points of a LAS file
// of format 0 to 5, or so many made-up ones, as LAZ. Times, colours and extra bytes are chance.

#include <cstdlib>
#include <fstream>
#include <iostream>
#include <iterator>

#include "support/laz_file.h"

namespace {

using support::LazFile;

template <class T>
T number(const std::string& bytes, std::size_t at) {
  T value;
  std::memcpy(&value, bytes.data() + at, sizeof value);
  return value;
}

void read_las(const std::string& name, LazFile& file) {
  std::ifstream in(name, std::ios::binary);
  const std::string bytes(std::istreambuf_iterator<char>(in), {});
  file.scale = number<double>(bytes, 131);
  for (std::size_t i = 0; i < 3; ++i) file.offset[i] = number<double>(bytes, 155 + 8 * i);
  const auto size = number<std::uint16_t>(bytes, 105);
  for (std::size_t at = number<std::uint32_t>(bytes, 96); at + size <= bytes.size(); at += size) {
    support::LazFilePoint p{number<std::int32_t>(bytes, at), number<std::int32_t>(bytes, at + 4),
                            number<std::int32_t>(bytes, at + 8)};
    p.cls = number<std::uint8_t>(bytes, at + 15) & 31;
    p.number = number<std::uint8_t>(bytes, at + 14) & 7u;
    p.of = number<std::uint8_t>(bytes, at + 14) >> 3 & 7u;
    file.points.push_back(p);
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 7) return 2;
  LazFile file;
  file.format = static_cast<unsigned>(std::atoi(argv[2]));
  file.version = static_cast<unsigned>(std::atoi(argv[3]));
  const std::string layout = argv[4];
  file.layout = layout == "one_stream" ? LazFile::Layout::one_stream
                : layout == "varying"  ? LazFile::Layout::varying
                                       : LazFile::Layout::fixed;
  file.extra = static_cast<std::uint32_t>(std::atoi(argv[5]));
  if (const int count = std::atoi(argv[1]); count > 0) {
    file.points = LazFile::scan(static_cast<std::size_t>(count), 1, file.format >= 6);
  } else {
    read_las(argv[1], file);
  }
  if (file.points.size() > 1000) file.chunk = 50000;
  std::ofstream out(argv[6], std::ios::binary);
  out << file.bytes();
  return out ? 0 : 4;
}
