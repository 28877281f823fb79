#include <fmt/format.h>

#include "geom/io/point_cloud.h"
#include "point_chunks.h"

// LAS 1.4 R15 (ASPRS 2019), tables 3 and 7 to 17: offsets below are those of the specification.

namespace geom {
namespace {

constexpr std::size_t kHeader = 227;    // of LAS 1.0 to 1.2
constexpr std::size_t kHeader14 = 375;  // of LAS 1.4
constexpr std::size_t kRecord[] = {20, 28, 26, 34, 57, 63, 30, 36, 38, 59, 67};

[[noreturn]] void refuse(std::string_view source, std::string_view message) {
  throw InputError(source, message);
}

struct Header {
  std::uint32_t data = 0;  // where the points start
  std::size_t record = 0;  // bytes a point
  bool modern = false;     // formats 6 to 10 keep their class elsewhere
  std::uint64_t points = 0;
  Vec3 scale;
  Vec3 offset;
};

Header parse(const std::vector<unsigned char>& b, std::string_view source) {
  const unsigned major = b[24];
  const unsigned minor = b[25];
  if (major != 1 || minor > 4) {
    refuse(source, fmt::format("expected LAS 1.0 to 1.4, found {}.{}", major, minor));
  }
  const unsigned format = b[104] & 0x3f;
  if (b[104] & 0xc0) {
    refuse(source,
           "this is compressed (LAZ or COPC): convert it first, for example with "
           "`pdal translate in.laz out.las`");
  }
  if (format > 10) refuse(source, fmt::format("expected a point format 0 to 10, found {}", format));
  Header h;
  h.data = number_at<std::uint32_t>(&b[96]);
  h.record = number_at<std::uint16_t>(&b[105]);
  h.modern = format >= 6;
  if (h.record < kRecord[format]) {
    refuse(source, fmt::format("expected at least {} bytes a point of format {}, found {}",
                               kRecord[format], format, h.record));
  }
  h.points = number_at<std::uint32_t>(&b[107]);
  if (minor == 4 && b.size() >= kHeader14) {
    const auto counted = number_at<std::uint64_t>(&b[247]);
    if (counted) h.points = counted;
  }
  for (int i = 0; i < 3; ++i) {
    h.scale[i] = number_at<double>(&b[131 + 8 * static_cast<std::size_t>(i)]);
    h.offset[i] = number_at<double>(&b[155 + 8 * static_cast<std::size_t>(i)]);
    if (!(std::abs(h.scale[i]) > 0 && std::abs(h.scale[i]) <= 1e3) ||
        !(std::abs(h.offset[i]) <= kLargestCoordinate)) {
      refuse(source, fmt::format("scale and offset must be finite numbers, the scale not 0; found "
                                 "{} and {}",
                                 h.scale[i], h.offset[i]));
    }
  }
  return h;
}

Header read_header(std::istream& in, std::string_view source) {
  std::vector<unsigned char> bytes(kHeader);
  const auto read = [&](std::size_t from) {
    in.read(reinterpret_cast<char*>(bytes.data() + from),
            static_cast<std::streamsize>(bytes.size() - from));
    if (static_cast<std::size_t>(in.gcount()) < bytes.size() - from) {
      refuse(source, "the header is cut short");
    }
  };
  in.read(reinterpret_cast<char*>(bytes.data()), 4);
  if (in.gcount() < 4 || std::memcmp(bytes.data(), "LASF", 4) != 0) {
    refuse(source, "expected a LAS file, which starts with \"LASF\"");
  }
  read(4);
  const std::size_t size = number_at<std::uint16_t>(&bytes[94]);
  if (size < kHeader)
    refuse(source, fmt::format("expected a header of {} bytes or more, found {}", kHeader, size));
  bytes.resize(std::min<std::size_t>(size, kHeader14));
  read(kHeader);
  const Header header = parse(bytes, source);
  if (header.data < bytes.size()) {
    refuse(source,
           fmt::format("points must start after the header, found them at byte {}", header.data));
  }
  in.ignore(static_cast<std::streamsize>(header.data - bytes.size()));
  if (static_cast<std::size_t>(in.gcount()) < header.data - bytes.size()) {
    refuse(source,
           fmt::format("expected points at byte {}, and the file ends before", header.data));
  }
  return header;
}

}  // namespace

CloudCounts read_las(std::istream& in, std::string_view source, const PointSink& sink) {
  const Header h = read_header(in, source);
  PointChunks chunks(source, sink);
  const std::uint64_t found =
      for_each_record(in, h.record, h.points, [&](const unsigned char* record) {
        const Vec3 raw(number_at<std::int32_t>(record), number_at<std::int32_t>(record + 4),
                       number_at<std::int32_t>(record + 8));
        const std::uint8_t cls =
            h.modern ? record[16] : static_cast<std::uint8_t>(record[15] & 0x1f);
        chunks.add(raw.cwiseProduct(h.scale) + h.offset, cls);
      });
  if (found < h.points) {
    refuse(source, fmt::format("expected {} points, and the file ends after {}", h.points, found));
  }
  return chunks.finish();
}

}  // namespace geom
