#include "geom/import/import_boxes.h"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>

#include "geom/base/error.h"
#include "geom/import/box_csv.h"
#include "geom/import/fcnd_csv.h"
#include "geom/import/sdf_world.h"
#include "geom/text/counted.h"
#include "geom/text/json_line.h"
#include "import/block_text.h"
#include "import/jps3d_map.h"
#include "import/octomap.h"
#include "import/voxel_3dmap.h"
#include "import/world_json.h"

namespace geom {
namespace {

// Of text between angle brackets, whatever stands before.
bool is_sdf(std::string_view head) {
  const std::size_t at = head.find_first_not_of("\xef\xbb\xbf \t\r\n");
  if (at == head.npos || head[at] != '<') return false;
  const std::size_t root = head.find("<sdf");
  return root != head.npos && root + 4 < head.size() &&
         std::string_view(" \t\r\n>").find(head[root + 4]) != std::string_view::npos;
}

std::optional<BoxFormat> detect(std::string_view head) {
  if (head.starts_with("# Octomap")) return BoxFormat::octomap;
  if (is_sdf(head)) return BoxFormat::sdf;
  std::istringstream in{std::string(head)};
  for (std::string line; std::getline(in, line);) {
    if (line.find("min_x_m") != std::string::npos) return BoxFormat::box_csv;
    const std::size_t at = line.find_first_not_of(" \t\r");
    if (at == std::string::npos || line[at] == '#') continue;
    const std::string_view text = std::string_view(line).substr(at);
    if (text.starts_with("boundary") || text.starts_with("block")) return BoxFormat::block_text;
    if (text.starts_with("voxel")) return BoxFormat::voxel_3dmap;
    if (text.starts_with("{")) return BoxFormat::world_json;
    if (text.starts_with("- ") && text.find(':') != text.npos) return BoxFormat::jps3d;
    const bool table =
        text.find("pos") != std::string::npos || text.find("half") != std::string::npos;
    const bool numbers = text.find_first_of("0123456789") < 2;
    if (table || numbers || text.starts_with("lat0") || text.starts_with("\xef\xbb\xbf")) {
      return BoxFormat::fcnd;
    }
    return std::nullopt;
  }
  return BoxFormat::fcnd;
}

ImportedBoxes from_fcnd(std::istream& in, std::string_view source) {
  FcndTable fcnd = read_fcnd_csv(in, source);
  ImportedBoxes out;
  out.table = std::move(fcnd.table);
  out.frame = {Axes::neu, fcnd.origin, ""};
  out.floor = 0;
  out.seal = 1;
  out.flat = fcnd.flat;
  out.largest_change = fcnd.largest_change;
  out.skipped = std::move(fcnd.skipped);
  return out;
}

ImportedBoxes from_blocks(std::istream& in, std::string_view source) {
  BlockText block = read_block_text(in, source);
  ImportedBoxes out;
  out.table = std::move(block.table);
  out.bounds = block.boundary;
  out.flat = block.flat;
  out.reversed = block.reversed;
  out.skipped = std::move(block.skipped);
  return out;
}

ImportedBoxes from_world(std::istream& in, std::string_view source) {
  WorldJson world = read_world_json(in, source);
  ImportedBoxes out;
  out.table = std::move(world.table);
  out.bounds = world.bounds;
  out.flat = world.flat;
  out.reversed = world.reversed;
  out.skipped = std::move(world.skipped);
  out.names = std::move(world.names);
  return out;
}

ImportedBoxes from_voxels(std::istream& in, std::string_view source) {
  VoxelMap voxels = read_voxel_3dmap(in, source);
  ImportedBoxes out;
  out.table = std::move(voxels.table);
  out.bounds = voxels.bounds;
  return out;
}

ImportedBoxes from_octomap(std::istream& in, std::string_view source, bool unknown_blocked) {
  Octomap tree = read_octomap(in, source, {unknown_blocked});
  ImportedBoxes out;
  out.table = std::move(tree.table);
  out.bounds = tree.bounds;
  out.unknown = tree.unknown;
  return out;
}

ImportedBoxes from_sdf(std::istream& in, std::string_view source, const SdfOptions& options) {
  SdfWorld world = read_sdf_world(in, source, options);
  ImportedBoxes out;
  out.table = std::move(world.table);
  out.frame = world.frame;
  out.bounds = world.bounds;
  out.floor = world.floor;
  out.flat = world.flat;
  out.skipped = std::move(world.skipped);
  out.movable = world.movable;
  out.left_out = std::move(world.left_out);
  return out;
}

ImportedBoxes from_jps3d(std::istream& in, std::string_view source, bool unknown_blocked) {
  Jps3dMap map = read_jps3d_map(in, source, {unknown_blocked});
  ImportedBoxes out;
  out.table = std::move(map.table);
  out.bounds = map.bounds;
  out.unknown = map.unknown;
  out.largest_change = map.largest_change;
  return out;
}

}  // namespace

BoxFormat box_format_of(std::string_view head, std::string_view source) {
  if (const auto format = detect(head)) return *format;
  throw InputError(
      source, 1,
      {.expected = "an FCND table, box CSV, block text, RotorPy JSON, .3dmap, OctoMap .bt, SDF or "
                   "jps3d YAML",
       .found = fmt::format("a file that begins with \"{}\"",
                            head.substr(0, std::min<std::size_t>(60, head.find_first_of("\r\n")))),
       .advice = "name its format with --format"});
}

ImportedBoxes import_boxes(std::istream& in, BoxFormat format, std::string_view source,
                           const ImportOptions& options) {
  switch (format) {
    case BoxFormat::fcnd:
      return from_fcnd(in, source);
    case BoxFormat::box_csv: {
      ImportedBoxes out;
      out.table = read_box_csv(in, source);
      return out;
    }
    case BoxFormat::block_text:
      return from_blocks(in, source);
    case BoxFormat::world_json:
      return from_world(in, source);
    case BoxFormat::voxel_3dmap:
      return from_voxels(in, source);
    case BoxFormat::octomap:
      return from_octomap(in, source, options.unknown_blocked);
    case BoxFormat::sdf:
      return from_sdf(in, source, options.sdf);
    case BoxFormat::jps3d:
      return from_jps3d(in, source, options.unknown_blocked);
  }
  throw InputError(source, {.expected = "a known format of boxes", .found = "another"});
}

MadeMap make_map(ImportedBoxes boxes, std::string_view source, MakeMapOptions options) {
  std::string history = "[]";
  if (!boxes.skipped.empty()) {
    if (!boxes.allow_skipped) {
      throw InputError(source,
                       {.says = fmt::format("{} cannot be built: {}",
                                            counted(boxes.skipped.count(), "possible obstacle"),
                                            boxes.skipped.text())});
    }
    history = '[' + JsonLine().add("skipped", boxes.skipped.count()).object() + ']';
  }
  if (boxes.table.boxes.empty())
    throw InputError(source, {.expected = "at least one obstacle", .found = "none"});
  if (!options.source_bounds) options.source_bounds = boxes.bounds;
  if (!options.floor) options.floor = boxes.floor;
  if (!options.seal) options.seal = boxes.seal;
  return make_map(std::move(boxes.table), boxes.frame, std::move(history), source, options);
}

}  // namespace geom
