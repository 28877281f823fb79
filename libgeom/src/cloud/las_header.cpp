#include "las_header.h"

#include <fmt/format.h>

#include "point_chunks.h"

// Offsets below are those of the specification.

namespace geom {
namespace {

constexpr std::size_t kHeader = 227;    // of LAS 1.0 to 1.2
constexpr std::size_t kHeader13 = 235;  // of LAS 1.3
constexpr std::size_t kHeader14 = 375;  // of LAS 1.4
constexpr std::size_t kRecord[] = {20, 28, 26, 34, 57, 63, 30, 36, 38, 59, 67};

[[noreturn]] void refuse(std::string_view source, Fault fault) {
  throw InputError(source, std::move(fault));
}

LasHeader parse(const std::vector<unsigned char>& b, std::string_view source) {
  const unsigned major = b[24];
  const unsigned minor = b[25];
  if (major != 1 || minor > 4) {
    refuse(source, {.expected = "LAS 1.0 to 1.4", .found = fmt::format("{}.{}", major, minor)});
  }
  const unsigned format = b[104] & 0x3f;
  if (b[104] & 0x40) {
    refuse(source,
           {.says = "this was compressed by an early, experimental LASzip, which is not read",
            .advice = "ask its source for LAS, or for LAZ as it is written today"});
  }
  if (format > 10)
    refuse(source, {.expected = "a point format 0 to 10", .found = fmt::to_string(format)});
  LasHeader h;
  h.data = number_at<std::uint32_t>(&b[96]);
  h.record = number_at<std::uint16_t>(&b[105]);
  h.format = format;
  h.compressed = b[104] & 0x80;
  if (h.record < kRecord[format]) {
    refuse(source, {.expected = fmt::format("at least {} bytes a point of format {}",
                                            kRecord[format], format),
                    .found = fmt::to_string(h.record)});
  }
  h.records = number_at<std::uint32_t>(&b[100]);
  h.well_known_text = number_at<std::uint16_t>(&b[6]) & 0x10;
  h.points = number_at<std::uint32_t>(&b[107]);
  if (minor >= 3 && b.size() >= kHeader13) h.waveforms = number_at<std::uint64_t>(&b[227]);
  if (minor == 4 && b.size() >= kHeader14) {
    h.later_records = number_at<std::uint64_t>(&b[235]);
    h.later_count = number_at<std::uint32_t>(&b[243]);
    const auto counted = number_at<std::uint64_t>(&b[247]);
    if (counted && h.points && counted != h.points) {
      refuse(source,
             {.says = fmt::format("the header counts {} points at one place and {} at another",
                                  counted, h.points)});
    }
    if (counted) h.points = counted;
  }
  for (int i = 0; i < 3; ++i) {
    h.scale[i] = number_at<double>(&b[131 + 8 * static_cast<std::size_t>(i)]);
    h.offset[i] = number_at<double>(&b[155 + 8 * static_cast<std::size_t>(i)]);
    if (!(std::abs(h.scale[i]) > 0 && std::abs(h.scale[i]) <= 1e3) ||
        !(std::abs(h.offset[i]) <= kLargestCoordinate)) {
      refuse(source,
             {.says = fmt::format(
                  "scale and offset must be finite numbers, the scale not 0; found {} and {}",
                  h.scale[i], h.offset[i])});
    }
  }
  return h;
}

}  // namespace

LasHeader read_las_header(std::istream& in, std::string_view source) {
  std::vector<unsigned char> bytes(kHeader);
  const auto read = [&](std::size_t from) {
    in.read(reinterpret_cast<char*>(bytes.data() + from),
            static_cast<std::streamsize>(bytes.size() - from));
    if (static_cast<std::size_t>(in.gcount()) < bytes.size() - from) {
      refuse(source, {.says = "the header is cut short"});
    }
  };
  in.read(reinterpret_cast<char*>(bytes.data()), 4);
  if (in.gcount() < 4 || std::memcmp(bytes.data(), "LASF", 4) != 0) {
    refuse(source, {.expected = "a LAS file, which starts with \"LASF\""});
  }
  read(4);
  const std::size_t size = number_at<std::uint16_t>(&bytes[94]);
  if (size < kHeader)
    refuse(source, {.expected = fmt::format("a header of {} bytes or more", kHeader),
                    .found = fmt::to_string(size)});
  bytes.resize(std::min<std::size_t>(size, kHeader14));
  read(kHeader);
  LasHeader header = parse(bytes, source);
  header.size = bytes.size();
  if (header.data < bytes.size()) {
    refuse(source, {.says = "points must start after the header",
                    .found = fmt::format("them at byte {}", header.data)});
  }
  in.ignore(static_cast<std::streamsize>(std::min<std::size_t>(size, header.data) - bytes.size()));
  header.size = std::min<std::size_t>(size, header.data);
  return header;
}

}  // namespace geom
