// repeat_laz FILE TIMES OUT: a LAZ file of point formats 0 to 5 in chunks of one size, its full
// chunks so many times, then its last one: a large file that compresses as a small one does.

#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iterator>

#include "cloud/integer_decoder.h"
#include "support/range_encoder.h"

namespace {

template <class T>
T number(const std::string& bytes, std::size_t at) {
  T value;
  std::memcpy(&value, bytes.data() + at, sizeof value);
  return value;
}

template <class T>
void add(std::string& to, T value) {
  to.append(reinterpret_cast<const char*>(&value), sizeof value);
}

// The bytes of each chunk, as the table at this place says.
std::vector<std::uint32_t> sizes_of(const std::string& laz, std::size_t table) {
  const auto* code = reinterpret_cast<const unsigned char*>(laz.data()) + table + 8;
  geom::ByteSource bytes({code, laz.size() - table - 8}, table + 8, "its table");
  geom::RangeDecoder decoder(bytes);
  geom::IntegerDecoder decode(32, 2);
  std::vector<std::uint32_t> sizes(number<std::uint32_t>(laz, table + 4));
  std::int32_t last = 0;
  for (std::uint32_t& size : sizes) {
    last = decode.next(decoder, last, 1);
    size = static_cast<std::uint32_t>(last);
  }
  return sizes;
}

std::string table_of(const std::vector<std::uint32_t>& sizes) {
  std::string out;
  add<std::uint32_t>(out, 0);
  add(out, static_cast<std::uint32_t>(sizes.size()));
  support::RangeEncoder code;
  support::IntegerEncoder encode(32, 2);
  std::uint32_t last = 0;
  for (const std::uint32_t size : sizes) {
    encode.put(code, last, size, 1);
    last = size;
  }
  return out + code.finish();
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 4) return 2;
  std::ifstream in(argv[1], std::ios::binary);
  std::string laz(std::istreambuf_iterator<char>(in), {});
  const auto times = static_cast<std::uint32_t>(std::atoi(argv[2]));
  const std::size_t start = number<std::uint32_t>(laz, 96);
  const std::vector<std::uint32_t> sizes = sizes_of(laz, number<std::uint64_t>(laz, start));
  std::size_t full = 0;  // bytes of the chunks that are
  for (std::size_t i = 0; i + 1 < sizes.size(); ++i) full += sizes[i];
  std::string chunks;
  std::vector<std::uint32_t> all;
  for (std::uint32_t i = 0; i < times; ++i) {
    chunks += laz.substr(start + 8, full);
    all.insert(all.end(), sizes.begin(), sizes.end() - 1);
  }
  chunks += laz.substr(start + 8 + full, sizes.back());
  all.push_back(sizes.back());
  // The points of a full chunk stand in the record of LASzip.
  const std::size_t record = laz.find("laszip encoded") - 2 + 54;
  const auto points = number<std::uint32_t>(laz, record + 12);
  const auto one = static_cast<std::uint32_t>(sizes.size() - 1) * points;
  const std::uint32_t count = number<std::uint32_t>(laz, 107) + (times - 1) * one;
  std::memcpy(&laz[107], &count, 4);
  std::string out = laz.substr(0, start);
  add<std::uint64_t>(out, start + 8 + chunks.size());
  out += chunks + table_of(all);
  std::ofstream file(argv[3], std::ios::binary);
  file << out;
  return file.flush() ? 0 : 4;
}
