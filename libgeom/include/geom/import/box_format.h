#pragma once

// What a reader of boxes gives, whatever its format, and the row of it in the table of formats.
//
// No example: import_boxes.h shows how the rows are used.

#include <cstddef>
#include <cstdint>
#include <iosfwd>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "geom/base/execution.h"
#include "geom/base/format.h"
#include "geom/base/skipped.h"
#include "geom/import/sdf_world.h"
#include "geom/map/box_table.h"
#include "geom/map/frame.h"

namespace geom {

struct ImportOptions {
  bool unknown_blocked = false;  // cells of an OctoMap or a jps3d map never seen become boxes
  SdfOptions sdf;
  Execution run = {};       // FCND tables are parsed on all threads
  std::uint64_t bytes = 0;  // of the file, where that is known: memory is taken once
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

// A row of box_formats() (import_boxes.h); it lies with its reader.
struct BoxFormat {
  const Format* format;
  Formats kinds = {};
  bool (*may_be)(std::string_view head) = nullptr;  // where no format of the table is sure
  // Throws InputError as the reader of the format does.
  ImportedBoxes (*read)(std::istream& in, std::string_view source, const ImportOptions& options);
  bool has_unknown = false;  // it tells cells that were never seen from free ones
};

}  // namespace geom
