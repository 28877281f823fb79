#include "las_records.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <set>
#include <vector>

#include "geom/base/error.h"
#include "point_chunks.h"

namespace geom {
namespace {

constexpr std::size_t kRecordHead = 54;

[[noreturn]] void refuse(std::string_view source, Fault fault) {
  throw InputError(source, std::move(fault));
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
    const auto same_unit = [](std::optional<double> a, std::optional<double> b) {
      return !a || !b || std::abs(*a - *b) < 5e-7 * *b;  // the feet of the world differ by 2e-6
    };
    const bool same = of_text.kind == of_keys.kind && same_unit(of_text.plane, of_keys.plane) &&
                      same_unit(of_text.up, of_keys.up) &&
                      (!of_text.epsg || !of_keys.epsg || of_text.epsg == of_keys.epsg);
    if (!same) {
      refuse(source_,
             {.says = fmt::format(
                  "its well-known text ({}) and its GeoTIFF keys ({}) contradict each other",
                  of_text.name, of_keys.name)});
    }
    return well_known_text || !of_keys.plane ? of_text : of_keys;
  }

 private:
  std::string_view source_;
  std::vector<std::uint16_t> directory_;
  std::vector<double> doubles_;
  std::string text_;
};

// The bytes between the header and the points, in pieces: a header may lie about how many they are.
std::string records_area(std::istream& in, const LasHeader& h, std::string_view source) {
  constexpr std::uint64_t kPiece = 1 << 20;
  std::string out;
  for (std::uint64_t left = h.data - h.size; left > 0;) {
    const std::size_t had = out.size();
    const std::uint64_t piece = std::min(kPiece, left);
    out.resize(had + piece);
    in.read(out.data() + had, static_cast<std::streamsize>(piece));
    if (static_cast<std::uint64_t>(in.gcount()) < piece) {
      refuse(source,
             {.says = fmt::format("expected points at byte {}, and the file ends before", h.data)});
    }
    left -= piece;
  }
  return out;
}

// A record that describes the coordinates and is none of those at `heads`: the length of one before
// it is wrong, or the number of all.
void require_no_lost_reference(std::string_view area, const std::set<std::size_t>& heads,
                               std::string_view source) {
  constexpr std::string_view kUser("LASF_Projection\0", 16);
  for (std::size_t at = 0; (at = area.find(kUser, at)) != area.npos; ++at) {
    if (at < 2 || at + 18 > area.size() || heads.contains(at - 2)) continue;
    const auto id =
        number_at<std::uint16_t>(reinterpret_cast<const unsigned char*>(area.data()) + at + 16);
    if (id != 2112 && id != 34735 && id != 34736) continue;
    refuse(source, {.says = "a record of its reference system stands where no record begins",
                    .advice = "the lengths or the number of its records are wrong: write the file "
                              "anew, for example with `pdal translate`"});
  }
}

}  // namespace

// The records before the points, of 54 bytes and what these announce each.
LasRecords read_las_records(std::istream& in, const LasHeader& h, std::string_view source) {
  References references(source);
  LasRecords out;
  const std::string area = records_area(in, h, source);
  std::set<std::size_t> heads;
  std::size_t at = 0;
  for (std::uint32_t i = 0; i < h.records; ++i) {
    if (area.size() - at < kRecordHead) {
      refuse(source,
             {.says = fmt::format("expected {} records before the points at byte {}, and {} fit",
                                  h.records, h.data, i)});
    }
    heads.insert(at);
    const auto* const head = reinterpret_cast<const unsigned char*>(area.data()) + at;
    at += kRecordHead;
    const std::uint16_t length = number_at<std::uint16_t>(head + 20);
    if (length > area.size() - at) {
      refuse(source,
             {.says = fmt::format("record {} of {} bytes reaches beyond the points at byte {}", i,
                                  length, h.data)});
    }
    const std::string data = area.substr(at, length);
    at += length;
    const std::string user(reinterpret_cast<const char*>(head + 2),
                           strnlen(reinterpret_cast<const char*>(head + 2), 16));
    const auto id = number_at<std::uint16_t>(head + 18);
    references.take(user, id, data);
    if (i == 0 && user == "copc" && id == 1) out.copc = data;
    if (h.compressed && user == "laszip encoded" && id == 22204) {
      out.laz = parse_laz_setup(data, h.format, h.record, source);
    }
  }
  require_no_lost_reference(area, heads, source);
  if (h.compressed && !out.laz) {
    refuse(source, {.says = "its points are compressed, and no record \"laszip encoded\" says how",
                    .advice = "the file is damaged"});
  }
  out.reference = references.reference(h.well_known_text);
  return out;
}

}  // namespace geom
