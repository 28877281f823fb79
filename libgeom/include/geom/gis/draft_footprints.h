#pragma once

// From a file of footprints, a city model or a height model to the boxes of a map.
//
// Example:
//   geom::gis::FootprintDraftOptions options;
//   options.map.floor = 0;
//   const geom::MadeMap made =
//       geom::make_map(geom::gis::draft_footprints("blocks.geojson", options));

#include <string>

#include "geom/base/execution.h"
#include "geom/base/hashed_stream.h"
#include "geom/base/notes.h"
#include "geom/base/open_file.h"
#include "geom/gis/footprint_format.h"
#include "geom/gis/footprint_source.h"
#include "geom/map/map_draft.h"

namespace geom::gis {

// Where neither map.pad, map.ceiling nor map.bounds is given, the map of anything but a height
// model reaches so far beyond the outermost wall, and above the highest roof: flights go around and
// over what the file ends with, 120 m above ground by most laws. The history's `defaulted` names
// those.
inline constexpr double kDefaultPad = 50;        // metres
inline constexpr double kDefaultHeadroom = 120;  // metres; not beside map.pad

struct FootprintDraftOptions {
  const FootprintFormat* format = nullptr;  // null: what footprint_format_of() says
  ReadOptions read;                         // its slack and origin are those of the map, too
  // Whether read.height.default_height may stand for the height of any number of buildings. Else
  // at most a tenth of them may get it.
  bool default_height_chosen = false;
  std::string terrain;  // path of a GeoTIFF of the ground that footprints stand on; empty: none
  bool metres = false;  // numbers without a reference system are metres, whatever they look like
  bool allow_skipped = false;  // leave out possible obstacles that cannot be built
  MakeMapOptions map;
  OpenFile open = open_file;  // of files whose sums the history has
};

// Reads the file, brings it to the map's coordinates and onto the ground, and covers it with boxes.
// Throws InputError where the file is refused, where a possible obstacle cannot be built and that
// is not allowed, and where too many heights are unknown; UsageError where `metres` meets a file
// that names its reference system; FileError where a file cannot be opened.
MapDraft draft_footprints(const std::string& path, const FootprintDraftOptions& options = {},
                          const Notes& notes = {}, const Execution& run = {});

// The same for an open file: `file` is the file at `path`. GDAL and libosmium read by path.
MapDraft draft_footprints(const std::string& path, HashedStream& file,
                          const FootprintDraftOptions& options, const Notes& notes = {},
                          const Execution& run = {});

}  // namespace geom::gis
