#pragma once

// From a point cloud to the boxes of a map.
//
// Example:
//   geom::CloudDraftOptions options;
//   options.columns.cell = 0.5;
//   options.allow_skipped = true;
//   const geom::MadeMap made = geom::make_map(geom::draft_cloud("scan.xyz", options));

#include <bitset>
#include <functional>
#include <optional>
#include <string>

#include "geom/base/execution.h"
#include "geom/base/hashed_stream.h"
#include "geom/base/notes.h"
#include "geom/base/open_file.h"
#include "geom/cloud/cloud_format.h"
#include "geom/cloud/cloud_place.h"
#include "geom/cloud/point_cloud.h"
#include "geom/map/column_grid.h"
#include "geom/map/ground_grid.h"
#include "geom/map/map_draft.h"

namespace geom {

// Points are dropped whose mean distance to so many nearest ones is more than so many standard
// deviations above the mean of all.
struct OutlierRule {
  int neighbours;
  double deviations;
};

// Lengths are metres.
struct CloudDraftOptions {
  const CloudFormat* format = nullptr;  // null: the row of cloud_formats() that recognises it
  CloudPlaceOptions place;

  // Which points count. Classes and noise are those of LAS.
  std::bitset<256> classes;  // none: all
  bool drop_noise = false;   // what the file classifies as noise
  std::optional<OutlierRule> outliers;
  double voxel = 0;       // one point is kept of each cube of this side; 0: all points
  double resolution = 0;  // points are read until they are this near; 0: all (COPC alone)
  bool drop_ground = false;
  std::string ground_by = "auto";  // "class", "shape" or "auto" (ground_filter.h)
  GroundSpec ground;
  // Is told how the ground is told, "class" or "shape", before any point is dropped. It may throw.
  std::function<void(const std::string& by)> ground_told = {};

  // What becomes of them: columns, or a box for each group of points that are near to each other.
  ColumnSpec columns;
  bool objects = false;
  double tolerance = 1;        // points this near to each other are one object
  std::size_t min_points = 1;  // objects of fewer points are left out

  bool allow_skipped = false;  // leave out possible obstacles that cannot be built
  MakeMapOptions map;

  // Whether some step looks at all points together, which are then held in memory.
  bool in_memory() const { return outliers || voxel > 0 || objects; }
  // Whether points change nothing of how others are made into boxes. Then those outside the bounds,
  // or finer than the resolution, need not be read.
  bool each_point_alone() const;
};

// A cloud as its bytes.
struct CloudFile {
  std::string name;               // for messages
  HashedStream& first;            // from its beginning; for the first reading
  OpenFile again = open_file;     // opens the file of that name for a further reading
  const RandomFile* random = {};  // null: no part of it can be read alone
};

// Reads the cloud, once more where ground is told by its shape. Throws InputError where the file is
// refused, where it is not known what its coordinates mean, where a possible obstacle cannot be
// built and that is not allowed, and where no point is left; UsageError where a resolution meets a
// file whose coordinates are no lengths, or options for which each point counts.
MapDraft draft_cloud(const CloudFile& file, const CloudDraftOptions& options = {},
                     const Notes& notes = {}, const Execution& run = {});

// The same of the file at `path`.
MapDraft draft_cloud(const std::string& path, const CloudDraftOptions& options = {},
                     const Notes& notes = {}, const Execution& run = {});

}  // namespace geom
