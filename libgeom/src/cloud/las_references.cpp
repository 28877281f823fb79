#include "las_references.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "geom/base/error.h"
#include "point_chunks.h"

namespace geom {
namespace {

constexpr std::string_view kUser("LASF_Projection\0", 16);
constexpr std::uint16_t kTransform = 2111;
constexpr std::uint16_t kText = 2112;
constexpr std::uint16_t kKeys = 34735;
constexpr std::uint16_t kDoubles = 34736;
constexpr std::size_t kLaterData = 16 + 2 + 8 + 32;  // from the user of a later record to its data
constexpr std::uint64_t kMostData = 1 << 20;         // of a later record

bool describes(std::uint16_t id) {
  return id == kTransform || id == kText || id == kKeys || id == kDoubles;
}

template <class T>
T number_in(std::string_view bytes, std::size_t at) {
  return number_at<T>(reinterpret_cast<const unsigned char*>(bytes.data()) + at);
}

template <class T>
std::vector<T> numbers_of(std::string_view bytes) {
  std::vector<T> out;
  for (std::size_t i = 0; i + sizeof(T) <= bytes.size(); i += sizeof(T)) {
    out.push_back(number_in<T>(bytes, i));
  }
  return out;
}

}  // namespace

void LasReferences::keep(std::string& kept, std::string_view data, const char* what) const {
  if (data.empty() || kept == data) return;
  if (!kept.empty()) {
    throw InputError(source_, {.says = fmt::format("two of its records have {}, and differ", what),
                               .advice = "remove the one that is wrong"});
  }
  kept = data;
}

void LasReferences::take(std::string_view user, std::uint16_t id, const std::string& data) {
  const std::string_view text(data.c_str());
  if (user == "liblas" && id == kText) keep(liblas_, text, "well-known text");
  if (user != "LASF_Projection") return;
  if (id == kKeys) keep(directory_, data, "GeoTIFF keys");
  if (id == kDoubles) keep(doubles_, data, "numbers of GeoTIFF keys");
  if (id == kText) keep(text_, text, "well-known text");
  if (id == kTransform && !text.empty()) {
    throw InputError(source_, {.says = "its record 2111 says that points are to be transformed, "
                                       "which is not done",
                               .advice = "write the file with points where they stand"});
  }
}

CoordinateReference LasReferences::reference(bool well_known_text) const {
  const std::string& text = text_.empty() ? liblas_ : text_;
  CoordinateReference of_text;
  CoordinateReference of_keys;
  if (!text.empty()) of_text = reference_of_wkt(text);
  if (!directory_.empty()) {
    of_keys =
        reference_of_geo_keys(numbers_of<std::uint16_t>(directory_), numbers_of<double>(doubles_));
  }
  if (text.empty()) return of_keys;
  if (directory_.empty()) return of_text;
  const auto same_unit = [](std::optional<double> a, std::optional<double> b) {
    return !a || !b || std::abs(*a - *b) < 5e-7 * *b;  // the feet of the world differ by 2e-6
  };
  const bool same = of_text.kind == of_keys.kind && same_unit(of_text.plane, of_keys.plane) &&
                    same_unit(of_text.up, of_keys.up) &&
                    (!of_text.epsg || !of_keys.epsg || of_text.epsg == of_keys.epsg);
  if (!same) {
    throw InputError(
        source_, {.says = fmt::format(
                      "its well-known text ({}) and its GeoTIFF keys ({}) contradict each other",
                      of_text.name, of_keys.name)});
  }
  return well_known_text || !of_keys.plane ? of_text : of_keys;
}

void require_no_lost_reference(std::string_view area, const std::set<std::size_t>& heads,
                               const std::string& source) {
  for (std::size_t at = 0; (at = area.find(kUser, at)) != area.npos; ++at) {
    if (at < 2 || at + 18 > area.size() || heads.contains(at - 2)) continue;
    if (!describes(number_in<std::uint16_t>(area, at + 16))) continue;
    throw InputError(source,
                     {.says = "a record of its reference system stands where no record begins",
                      .advice = "the lengths or the number of its records are wrong: write the "
                                "file anew, for example with `pdal translate`"});
  }
}

void LaterReferences::take(std::span<const unsigned char> bytes) {
  window_.append(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  look(false);
}

// Keeps what may be the beginning of a record whose other bytes are still to come.
void LaterReferences::look(bool last) {
  std::size_t at = 0;
  while ((at = window_.find(kUser, at)) != window_.npos) {
    const std::string_view record = std::string_view(window_).substr(at);
    if (record.size() < kLaterData) break;
    const auto id = number_in<std::uint16_t>(record, 16);
    if (describes(id)) {
      const auto length = std::min(number_in<std::uint64_t>(record, 18), kMostData);
      if (!last && record.size() - kLaterData < length) break;
      window_.erase(0, at);
      take_record(id, length);
      at = 0;
    }
    at += kUser.size();
  }
  const std::size_t tail = window_.size() - std::min(window_.size(), kUser.size());
  window_.erase(0, at == window_.npos ? tail : at);
}

void LaterReferences::take_record(std::uint16_t id, std::size_t bytes) {
  if (told_.reference(well_known_text_).kind == CoordinateReference::Kind::none) {
    throw InputError(
        told_.source(),
        {.says = "its reference system stands after its points, where it is not read",
         .advice = "write the file anew, for example with `pdal translate in.las out.las`"});
  }
  told_.take("LASF_Projection", id, window_.substr(kLaterData, bytes));
  told_.reference(well_known_text_);  // throws where it contradicts what stands before the points
}

}  // namespace geom
