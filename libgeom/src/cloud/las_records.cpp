#include "las_records.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <set>

#include "geom/base/error.h"
#include "point_chunks.h"

namespace geom {
namespace {

constexpr std::size_t kRecordHead = 54;

[[noreturn]] void refuse(std::string_view source, Fault fault) {
  throw InputError(source, std::move(fault));
}

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

}  // namespace

// The records before the points, of 54 bytes and what these announce each.
LasRecords read_las_records(std::istream& in, const LasHeader& h, std::string_view source) {
  LasRecords out{.references = LasReferences(source)};
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
    out.references.take(user, id, data);
    if (i == 0 && user == "copc" && id == 1) out.copc = data;
    if (h.compressed && user == "laszip encoded" && id == 22204) {
      out.laz = parse_laz_setup(data, h.format, h.record, source);
    }
  }
  require_no_lost_reference(area, heads, std::string(source));
  if (h.compressed && !out.laz) {
    refuse(source, {.says = "its points are compressed, and no record \"laszip encoded\" says how",
                    .advice = "the file is damaged"});
  }
  out.reference = out.references.reference(h.well_known_text);
  return out;
}

}  // namespace geom
