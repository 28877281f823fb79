#pragma once

// From a table, block text, world, voxel map or octree to the boxes of a map.
//
// Example:
//   geom::BoxDraftOptions options;
//   options.map.ceiling = 120;
//   std::istringstream in("boundary 0 0 0 10 10 10\nblock 4 0 0 5 8 8\n");
//   geom::HashedStream file(in);
//   const geom::MadeMap made = geom::make_map(geom::draft_boxes(file, "city.txt", options));

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "geom/base/execution.h"
#include "geom/base/hashed_stream.h"
#include "geom/base/notes.h"
#include "geom/base/open_file.h"
#include "geom/import/import_boxes.h"
#include "geom/map/map_draft.h"

namespace geom {

struct BoxDraftOptions {
  const BoxFormat* format = nullptr;  // null: what box_format_of() says
  std::optional<Axes> axes;           // of the file's numbers, in place of what the format says
  double unit = 1;                    // metres in one of the file's numbers
  bool unknown_blocked = false;       // cells of an OctoMap or a jps3d map never seen become boxes

  // Of SDF worlds:
  double slack = 0.1;                // metres that boxes may reach outside turned or round shapes
  bool visuals = true;               // shapes that are only shown are obstacles, too
  std::vector<std::string> without;  // names of models that are left out; each must be there
  std::vector<std::string> model_path;  // folders that model:// is looked for in
  ReadCollada read_collada;             // empty: COLLADA meshes are skipped

  bool allow_skipped = false;  // leave out possible obstacles that cannot be built
  MakeMapOptions map;
  std::uint64_t bytes = 0;    // of the file, where that is known: memory is taken once
  OpenFile open = open_file;  // of files that a world names
};

// Throws InputError where the file is refused, where a possible obstacle cannot be built and that
// is not allowed, and where a model of `without` is not there; UsageError where `map.pad` meets a
// file with bounds of its own; FileError where a file cannot be opened. `source` is for
// messages, and what the paths in a world are relative to.
MapDraft draft_boxes(HashedStream& file, const std::string& source,
                     const BoxDraftOptions& options = {}, const Notes& notes = {},
                     const Execution& run = {});

// The same of the file at `path`.
MapDraft draft_boxes(const std::string& path, const BoxDraftOptions& options = {},
                     const Notes& notes = {}, const Execution& run = {});

}  // namespace geom
