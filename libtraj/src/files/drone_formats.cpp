#include "traj/files/drone_formats.h"

#include <algorithm>
#include <vector>

#include "geom/gis/footprint_format.h"
#include "geom/model/model_format.h"
#include "traj/mission/formats/mission_formats.h"

namespace traj::files {
namespace {

using geom::Format;

constexpr const Format* kShared[] = {&geom::gis::kKmlFile, &geom::gis::kGeoJsonFile,
                                     &geom::kGlbFile};

std::vector<const Format*> table() {
  std::vector<const Format*> rows;
  for (const traj::MissionFormat* one : traj::mission_formats()) {
    if (!one->read) continue;
    const Format* const shared = geom::format_named(one->format.word, kShared);
    rows.push_back(shared ? shared : &one->format);
  }
  return rows;
}

}  // namespace

geom::Formats drone_formats() {
  static const std::vector<const Format*> rows = table();
  return rows;
}

bool is_drone_format(const Format* format) {
  const geom::Formats rows = drone_formats();
  return std::find(rows.begin(), rows.end(), format) != rows.end();
}

}  // namespace traj::files
