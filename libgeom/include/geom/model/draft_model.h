#pragma once

// From a model of triangles to the boxes of a map.
//
// Example:
//   geom::ModelDraftOptions options;
//   options.slack = 0.5;
//   options.allow_skipped = true;
//   const geom::MadeMap made = geom::make_map(geom::draft_model("house.obj", options));

#include <optional>
#include <string>

#include "geom/base/execution.h"
#include "geom/base/notes.h"
#include "geom/base/open_file.h"
#include "geom/map/map_draft.h"
#include "geom/model/read_model.h"

namespace geom {

struct ModelDraftOptions {
  double slack = 0.25;                   // metres that boxes may reach outside triangles and solid
  bool solid = false;                    // fill what closed surfaces enclose
  std::optional<UpAxis> up;              // absent: what the file says, else z
  std::optional<double> unit;            // metres in one of the file's numbers; absent: likewise, 1
  std::optional<GeodeticOrigin> origin;  // where on Earth the map's (0, 0, 0) is
  bool allow_skipped = false;            // leave out possible obstacles that cannot be built
  MakeMapOptions map;
};

// Throws InputError where a possible obstacle cannot be built and that is not allowed, where there
// is no triangle, and where the triangles are known too coarsely for the slack. `up` and `unit`
// change nothing of a model that is on Earth.
MapDraft draft_model(ModelSource model, const std::string& source,
                     const ModelDraftOptions& options = {}, const Notes& notes = {},
                     const Execution& run = {});

// The same of the file at `path` (read_model()); `open` opens it and those that it names.
MapDraft draft_model(const std::string& path, const ModelDraftOptions& options = {},
                     const Notes& notes = {}, const Execution& run = {},
                     const OpenFile& open = open_file);

}  // namespace geom
