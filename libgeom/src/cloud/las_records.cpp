#include "las_records.h"

#include <fmt/format.h>

#include <cmath>
#include <cstring>
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

}  // namespace

// The records before the points, of 54 bytes and what these announce each.
LasRecords read_las_records(std::istream& in, const LasHeader& h, std::string_view source) {
  References references(source);
  LasRecords out;
  std::uint64_t left = h.data - h.size;
  const auto cut_short = [&] {
    refuse(source,
           {.says = fmt::format("expected points at byte {}, and the file ends before", h.data)});
  };
  for (std::uint32_t i = 0; i < h.records; ++i) {
    unsigned char head[kRecordHead];
    if (left < kRecordHead) {
      refuse(source,
             {.says = fmt::format("expected {} records before the points at byte {}, and {} fit",
                                  h.records, h.data, i)});
    }
    in.read(reinterpret_cast<char*>(head), kRecordHead);
    if (static_cast<std::size_t>(in.gcount()) < kRecordHead) cut_short();
    left -= kRecordHead;
    const std::uint16_t length = number_at<std::uint16_t>(head + 20);
    if (length > left) {
      refuse(source,
             {.says = fmt::format("record {} of {} bytes reaches beyond the points at byte {}", i,
                                  length, h.data)});
    }
    std::string data(length, '\0');
    in.read(data.data(), length);
    if (in.gcount() < length) cut_short();
    left -= length;
    const std::string user(reinterpret_cast<const char*>(head + 2),
                           strnlen(reinterpret_cast<const char*>(head + 2), 16));
    const auto id = number_at<std::uint16_t>(head + 18);
    references.take(user, id, data);
    if (i == 0 && user == "copc" && id == 1) out.copc = data;
    if (h.compressed && user == "laszip encoded" && id == 22204) {
      out.laz = parse_laz_setup(data, h.format, h.record, source);
    }
  }
  in.ignore(static_cast<std::streamsize>(left));
  if (static_cast<std::uint64_t>(in.gcount()) < left) cut_short();
  if (h.compressed && !out.laz) {
    refuse(source, {.says = "its points are compressed, and no record \"laszip encoded\" says how",
                    .advice = "the file is damaged"});
  }
  out.reference = references.reference(h.well_known_text);
  return out;
}

}  // namespace geom
