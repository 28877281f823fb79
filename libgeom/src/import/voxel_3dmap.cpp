// Moving AI `.3dmap` voxel worlds (Brewer and Sturtevant, SoCS 2018): `voxel X Y Z` with the size
// of the grid, then one filled voxel `x y z` a line, which is the unit box from there. Ids are line
// numbers, and the bounds are the whole grid.

#include <fmt/format.h>

#include <charconv>

#include "geom/import/import_boxes.h"
#include "geom/text/beginning.h"
#include "geom/text/text_table.h"

namespace geom {
namespace {

struct Expected {
  std::string_view what;
  int low;
  Eigen::Vector3i high;
};

// Exactly three whole numbers in [low, high], separated by white space.
Eigen::Vector3i whole_numbers(const TextLines& lines, std::string_view text,
                              const Expected& expected) {
  const auto& [what, low, high] = expected;
  Eigen::Vector3i v;
  for (int i = 0; i < 3; ++i) {
    text = trimmed(text);
    const auto [rest, error] = std::from_chars(text.data(), text.data() + text.size(), v[i]);
    if (error != std::errc() || v[i] < low || v[i] > high[i]) {
      lines.refuse({.expected = fmt::format("{} as three whole numbers, {} in [{}, {}]", what,
                                            "xyz"[i], low, high[i]),
                    .found = in_quotes(lines.line().substr(0, 60))});
    }
    text.remove_prefix(static_cast<std::size_t>(rest - text.data()));
  }
  if (!trimmed(text).empty()) {
    lines.refuse({.expected = fmt::format("{} and nothing after it", what),
                  .found = in_quotes(lines.line().substr(0, 60))});
  }
  return v;
}

ImportedBoxes read_voxel_3dmap(std::istream& in, std::string_view source, const ImportOptions&) {
  TextLines lines(in, source);
  if (!lines.next() || !lines.line().starts_with("voxel")) {
    lines.refuse({.expected = "\"voxel X Y Z\"", .found = in_quotes(lines.line().substr(0, 60))});
  }
  const Eigen::Vector3i size = whole_numbers(
      lines, lines.line().substr(5), {"the grid's size", 1, Eigen::Vector3i::Constant(1000000)});
  ImportedBoxes out;
  out.bounds = {Vec3::Zero(), size.cast<double>()};
  while (lines.next()) {
    if (lines.line().empty()) continue;
    const Vec3 low =
        whole_numbers(lines, lines.line(), {"a voxel", 0, size.array() - 1}).cast<double>();
    out.table.add({low, low + Vec3::Ones()}, lines.number());
  }
  if (out.table.boxes.empty())
    lines.refuse({.expected = "at least one filled voxel", .found = "none"});
  return out;
}

bool may_be_voxel_3dmap(std::string_view head) { return first_line(head).starts_with("voxel"); }

constexpr std::string_view kReaders[] = {"skyway-import"};
constexpr Format kFormat{.word = "3dmap",
                         .what = "a list of voxels (.3dmap)",
                         .begins = text_begins_with<"voxel ">,
                         .readers = kReaders};

}  // namespace

constinit const BoxFormat kVoxelMap{
    .format = &kFormat, .may_be = may_be_voxel_3dmap, .read = read_voxel_3dmap};

}  // namespace geom
