#include "ground.h"

#include <algorithm>
#include <filesystem>

#include "cli/file/files.h"
#include "geom/zone/ground_band.h"
#include "traj/submit/submitted_flights.h"

namespace submitting {

std::optional<geom::GroundModel> take_ground(const cli::TerrainOption& option,
                                             const geom::BoxMap& map,
                                             traj::SubmissionMethod& method,
                                             SubmissionFolder& folder) {
  const std::string path = option.file();
  if (path.empty()) return std::nullopt;
  geom::require_same_zero(geom::read_ground(path), map, path);
  const std::string text = cli::InputFile(path).read_all();
  method.ground_model = {std::filesystem::path(path).filename().string(),
                         traj::listed_file(traj::kGroundFile, text).sha256};
  method.terrain_error = option.error();
  method.surface = option.surface();
  folder.add(traj::kGroundFile, text);
  // The proof is of the folder's copy, even if the file is changed meanwhile.
  return geom::read_ground(folder.place_of(traj::kGroundFile));
}

double floor_over(const geom::GroundModel& ground, const geom::Aabb& bounds) {
  const geom::GroundRange range = ground.range({bounds.min.head<2>(), bounds.max.head<2>()});
  return range.any_known ? std::min(bounds.min.z(), range.low) : bounds.min.z();
}

}  // namespace submitting
