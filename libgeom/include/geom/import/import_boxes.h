#pragma once

// One door to all readers of boxes: tables, block texts, worlds, voxels and octrees.
//
// Example:
//   std::istringstream in("boundary 0 0 0 10 10 10\nblock 4 0 0 5 8 8\n");
//   const geom::BoxFormat& format = geom::box_format_of("boundary 0 0 0 10 10 10\n", "city.txt");
//   geom::ImportedBoxes boxes = geom::import_boxes(in, format, "city.txt");
//   const geom::MadeMap made = geom::make_map(std::move(boxes), "city.txt");
//   assert(made.map.size() == 1);

#include <iosfwd>
#include <string_view>

#include "geom/import/box_csv.h"
#include "geom/import/box_format.h"
#include "geom/import/fcnd_csv.h"
#include "geom/import/sdf_world.h"
#include "geom/map/make_map.h"

namespace geom {

// Formats whose readers are known by these rows alone; kFcnd, kBoxCsv and kGazeboWorld stand with
// theirs.
extern const BoxFormat kBlockText;
extern const BoxFormat kJps3d;
extern const BoxFormat kOctomapTree;
extern const BoxFormat kRotorPyWorld;
extern const BoxFormat kVoxelMap;

// The table of all of them.
FormatRows<BoxFormat> box_formats();

// The format of a file that begins like this: the one that recognises it, else the one that its
// first line that is neither blank nor a comment may belong to. An empty file counts as an FCND
// table. Throws InputError(source, 1, …) where it looks like none.
const BoxFormat& box_format_of(std::string_view head, std::string_view source);

// Throws InputError as the reader of the format does (its header says when).
ImportedBoxes import_boxes(std::istream& in, const BoxFormat& format, std::string_view source,
                           const ImportOptions& options = {});

// The map of the imported boxes. Bounds, floor and seal are the source's if the options do not give
// them. Throws InputError if an obstacle was skipped, because a vehicle could fly through it,
// unless that is allowed; then the map's history counts it.
MadeMap make_map(ImportedBoxes boxes, std::string_view source, MakeMapOptions options = {});

}  // namespace geom
