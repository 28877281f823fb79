#pragma once

// How --vehicle and --margin meet what a record already says.

#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "agreed_room.h"
#include "geom/collision/collision.h"
#include "geom/record/record.h"
#include "named_map.h"
#include "vehicle_option.h"

namespace cli {

// The scene of a map for what a record and the options ask; the last one is kept.
class Scenes {
 public:
  using Differences = cli::Differences;

  Scenes(geom::BoxMap map, const VehicleOptions& options, Differences differences);

  // Of agreed_room. Throws geom::InputError(source, line, …) where the record is of another map or
  // frame too (named_map.h).
  const geom::CollisionScene& scene_for(const geom::Provenance& record, std::string_view source,
                                        std::size_t line);
  const geom::CollisionScene& scene();  // by the options alone
  // For what looks at several records in the last scene: InputError(source, line, …) where that is
  // not of this one's room.
  void require_same_room(const geom::Provenance& record, std::string_view source,
                         std::size_t line) const;
  const geom::BoxMap& map() const { return map_.map(); }

  // For --stats: how many groups of tiles the last scene built, and built again.
  nlohmann::ordered_json stats() const;
  const std::optional<traj::VehicleProfile>& profile() const { return profile_; }

 private:
  const geom::CollisionScene& build(const Room& room);

  NamedMap map_;
  std::optional<traj::VehicleProfile> profile_;
  AskedRoom asked_;
  Differences differences_;
  std::size_t budget_;
  std::optional<geom::CollisionScene> scene_;
};

// A lattice or roadmap (`kind`) serves one map, frame, vehicle and margin: throws
// geom::InputError(source, …) where these are not the scene's.
void require_same(const geom::Provenance& made_for, const geom::CollisionScene& scene,
                  const std::string& source, const char* kind);

}  // namespace cli
