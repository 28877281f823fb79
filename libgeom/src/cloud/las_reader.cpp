#include <fmt/format.h>

#include "geom/cloud/point_cloud.h"
#include "geom/text/counted.h"
#include "point_chunks.h"

// LAS 1.4 R15 (ASPRS 2019), tables 3 and 7 to 17: offsets below are those of the specification.

namespace geom {
namespace {

constexpr std::size_t kHeader = 227;    // of LAS 1.0 to 1.2
constexpr std::size_t kHeader13 = 235;  // of LAS 1.3
constexpr std::size_t kHeader14 = 375;  // of LAS 1.4
constexpr std::size_t kRecordHead = 54;
constexpr std::size_t kLaterHead = 60;
constexpr std::size_t kRecord[] = {20, 28, 26, 34, 57, 63, 30, 36, 38, 59, 67};

[[noreturn]] void refuse(std::string_view source, std::string_view message) {
  throw InputError(source, message);
}

struct Header {
  std::size_t size = 0;
  std::uint32_t records = 0;        // variable length records before the points
  std::uint64_t later_records = 0;  // where those after the points start; 0: none
  std::uint32_t later_count = 0;
  std::uint64_t waveforms = 0;   // where they start; 0: not in this file
  bool well_known_text = false;  // is what describes the coordinates, not the keys
  std::uint32_t data = 0;        // where the points start
  std::size_t record = 0;        // bytes a point
  bool modern = false;           // formats 6 to 10 keep their class elsewhere
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
  h.records = number_at<std::uint32_t>(&b[100]);
  h.well_known_text = number_at<std::uint16_t>(&b[6]) & 0x10;
  h.points = number_at<std::uint32_t>(&b[107]);
  if (minor >= 3 && b.size() >= kHeader13) h.waveforms = number_at<std::uint64_t>(&b[227]);
  if (minor == 4 && b.size() >= kHeader14) {
    h.later_records = number_at<std::uint64_t>(&b[235]);
    h.later_count = number_at<std::uint32_t>(&b[243]);
    const auto counted = number_at<std::uint64_t>(&b[247]);
    if (counted && h.points && counted != h.points) {
      refuse(source, fmt::format("the header counts {} points at one place and {} at another",
                                 counted, h.points));
    }
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
  Header header = parse(bytes, source);
  header.size = bytes.size();
  if (header.data < bytes.size()) {
    refuse(source,
           fmt::format("points must start after the header, found them at byte {}", header.data));
  }
  in.ignore(static_cast<std::streamsize>(std::min<std::size_t>(size, header.data) - bytes.size()));
  header.size = std::min<std::size_t>(size, header.data);
  return header;
}

// What the records say of the coordinates, gathered while they pass.
class References {
 public:
  explicit References(std::string_view source) : source_(source) {}

  void take(std::string_view user, std::uint16_t id, const std::string& data) {
    const bool standard = user == "LASF_Projection";
    const auto bytes = reinterpret_cast<const unsigned char*>(data.data());
    if (standard && id == 34735) {
      for (std::size_t i = 0; i + 2 <= data.size(); i += 2) {
        directory_.push_back(number_at<std::uint16_t>(bytes + i));
      }
    } else if (standard && id == 34736) {
      for (std::size_t i = 0; i + 8 <= data.size(); i += 8) {
        doubles_.push_back(number_at<double>(bytes + i));
      }
    } else if ((standard || user == "liblas") && id == 2112) {
      const std::string_view text(data.c_str());
      if (!text.empty() && (standard || text_.empty())) text_ = text;
    }
  }

  // Of both the one that the header names; the other must not contradict it.
  CoordinateReference reference(bool well_known_text) const {
    CoordinateReference of_text;
    CoordinateReference of_keys;
    if (!text_.empty()) of_text = reference_of_wkt(text_);
    if (!directory_.empty()) of_keys = reference_of_geo_keys(directory_, doubles_);
    if (text_.empty()) return of_keys;
    if (directory_.empty()) return of_text;
    const bool same_plane =
        of_text.kind == of_keys.kind &&
        (!of_text.plane || !of_keys.plane || std::abs(*of_text.plane - *of_keys.plane) < 1e-9);
    if (!same_plane) {
      refuse(source_, fmt::format("its well-known text ({}) and its GeoTIFF keys ({}) contradict "
                                  "each other",
                                  of_text.name, of_keys.name));
    }
    return well_known_text || !of_keys.plane ? of_text : of_keys;
  }

 private:
  std::string_view source_;
  std::vector<std::uint16_t> directory_;
  std::vector<double> doubles_;
  std::string text_;
};

// The records before the points, of 54 bytes and what these announce each.
CoordinateReference read_records(std::istream& in, const Header& h, std::string_view source) {
  References references(source);
  std::uint64_t left = h.data - h.size;
  const auto cut_short = [&] {
    refuse(source, fmt::format("expected points at byte {}, and the file ends before", h.data));
  };
  for (std::uint32_t i = 0; i < h.records; ++i) {
    unsigned char head[kRecordHead];
    if (left < kRecordHead) {
      refuse(source, fmt::format("expected {} records before the points at byte {}, and {} fit",
                                 h.records, h.data, i));
    }
    in.read(reinterpret_cast<char*>(head), kRecordHead);
    if (static_cast<std::size_t>(in.gcount()) < kRecordHead) cut_short();
    left -= kRecordHead;
    const std::uint16_t length = number_at<std::uint16_t>(head + 20);
    if (length > left) {
      refuse(source, fmt::format("record {} of {} bytes reaches beyond the points at byte {}", i,
                                 length, h.data));
    }
    std::string data(length, '\0');
    in.read(data.data(), length);
    if (in.gcount() < length) cut_short();
    left -= length;
    const std::string user(reinterpret_cast<const char*>(head + 2),
                           strnlen(reinterpret_cast<const char*>(head + 2), 16));
    references.take(user, number_at<std::uint16_t>(head + 18), data);
  }
  in.ignore(static_cast<std::streamsize>(left));
  if (static_cast<std::uint64_t>(in.gcount()) < left) cut_short();
  return references.reference(h.well_known_text);
}

// Whether points that the header does not count follow those it does: `left` bytes to what comes
// next.
void require_no_more(std::istream& in, const Header& h, std::string_view source) {
  const std::uint64_t end = h.data + h.points * h.record;
  const bool known_end = (h.later_count > 0 && h.later_records >= end) || h.waveforms >= end;
  if (known_end) return;
  in.ignore(static_cast<std::streamsize>(h.record));
  if (static_cast<std::size_t>(in.gcount()) == h.record) {
    refuse(source, fmt::format("expected {} points of {} bytes, and the file holds more", h.points,
                               h.record));
  }
}

// Whether one of the records after the points describes the coordinates.
bool described_later(std::istream& in, const Header& h, std::string_view source) {
  if (h.later_count == 0) return false;
  const std::uint64_t end = h.data + h.points * h.record;
  const auto cut_short = [&] { refuse(source, "its records after the points are cut short"); };
  const auto skip = [&](std::uint64_t bytes) {
    if (bytes > std::uint64_t{1} << 62) cut_short();
    in.ignore(static_cast<std::streamsize>(bytes));
    if (static_cast<std::uint64_t>(in.gcount()) < bytes) cut_short();
  };
  if (h.later_records < end) {
    refuse(source, fmt::format("expected its later records after byte {}, found them at {}", end,
                               h.later_records));
  }
  skip(h.later_records - end);
  for (std::uint32_t i = 0; i < h.later_count; ++i) {
    unsigned char head[kLaterHead];
    in.read(reinterpret_cast<char*>(head), kLaterHead);
    if (static_cast<std::size_t>(in.gcount()) < kLaterHead) cut_short();
    const bool projection = std::memcmp(head + 2, "LASF_Projection", 16) == 0;
    const std::uint16_t id = number_at<std::uint16_t>(head + 18);
    if (projection && (id == 2112 || id == 34735)) return true;
    skip(number_at<std::uint64_t>(head + 20));
  }
  return false;
}

}  // namespace

CloudCounts read_las(std::istream& in, std::string_view source, const PointSink& sink,
                     const ReferenceSink& reference) {
  const Header h = read_header(in, source);
  const CoordinateReference told = read_records(in, h, source);
  if (reference) reference(told);
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
    refuse(source, fmt::format("expected {}, and the file ends after {}",
                               counted(h.points, "point"), found));
  }
  require_no_more(in, h, source);
  if (described_later(in, h, source) && told.kind == CoordinateReference::Kind::none) {
    refuse(source,
           "its reference system stands after its points, where it is not read: write the file "
           "anew, for example with `pdal translate in.las out.las`");
  }
  return chunks.finish();
}

}  // namespace geom
