#pragma once

// One door to all readers of boxes: tables, block texts, worlds, voxels and octrees.
//
// Example:
//   std::istringstream in("boundary 0 0 0 10 10 10\nblock 4 0 0 5 8 8\n");
//   const geom::BoxFormat format = geom::box_format_of("boundary 0 0 0 10 10 10\n", "city.txt");
//   geom::ImportedBoxes boxes = geom::import_boxes(in, format, "city.txt");
//   const geom::MadeMap made = geom::make_map(std::move(boxes), "city.txt");
//   assert(made.map.size() == 1);

#include <iosfwd>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "geom/base/skipped.h"
#include "geom/import/sdf_world.h"
#include "geom/map/box_table.h"
#include "geom/map/frame.h"
#include "geom/map/make_map.h"
#include "geom/text/words.h"

namespace geom {

enum class BoxFormat { fcnd, box_csv, block_text, world_json, voxel_3dmap, octomap, sdf, jps3d };
inline constexpr Words<BoxFormat, 8> kBoxFormatWords{{
    {BoxFormat::fcnd, "fcnd"},
    {BoxFormat::box_csv, "box-csv"},
    {BoxFormat::block_text, "block-text"},
    {BoxFormat::world_json, "world-json"},
    {BoxFormat::voxel_3dmap, "3dmap"},
    {BoxFormat::octomap, "octomap"},
    {BoxFormat::sdf, "sdf"},
    {BoxFormat::jps3d, "jps3d"},
}};
constexpr std::string_view name(BoxFormat format) { return word_of(kBoxFormatWords, format); }

// The format of a file that begins like this, by its first line that is neither blank nor a
// comment. An empty file counts as a table. InputError(source, 1, …) where it looks like none.
BoxFormat box_format_of(std::string_view head, std::string_view source);

struct ImportOptions {
  bool unknown_blocked = false;  // cells of an OctoMap or a jps3d map never seen become boxes
  SdfOptions sdf;
};

struct ImportedBoxes {
  BoxTable table;                  // in the source's numbers
  Frame frame;                     // what the format says: NEU for FCND tables, else ENU
  std::optional<Aabb> bounds;      // of the source itself, in its numbers
  std::optional<double> floor;     // metres, where the format has one: FCND tables stand on 0
  double seal = 0;                 // metres: what hangs lower stands on the floor (MakeMapOptions)
  std::size_t flat = 0;            // boxes without extent along one or two axes: kept
  std::size_t reversed = 0;        // boxes given from their upper corner to their lower one
  double largest_change = 0;       // metres that rounding outward moved a face by, at most
  Skipped skipped;                 // obstacles, or possible ones, that could not be built
  bool allow_skipped = false;      // for make_map(): whether the caller accepts a map without them
  std::size_t unknown = 0;         // cells of an OctoMap or a jps3d map, never seen
  std::size_t movable = 0;         // models of an SDF world that may move from where they stand
  std::set<std::string> left_out;  // models of an SDF world that the options leave out
  std::vector<std::string> names;  // unknown keys that by their name are no geometry
};

// Throws InputError as the reader of the format does (its header says when).
ImportedBoxes import_boxes(std::istream& in, BoxFormat format, std::string_view source,
                           const ImportOptions& options = {});

// The map of the imported boxes. Bounds, floor and seal are the source's if the options do not give
// them. Throws InputError if an obstacle was skipped, because a vehicle could fly through it,
// unless that is allowed; then the map's history counts it.
MadeMap make_map(ImportedBoxes boxes, std::string_view source, MakeMapOptions options = {});

}  // namespace geom
