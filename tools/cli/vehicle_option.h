#pragma once

// --vehicle and --margin, and how they meet what a record already says.

#include <CLI/CLI.hpp>
#include <optional>
#include <string>

#include "geom/collision.h"
#include "geom/io/record.h"
#include "geom/vehicle.h"
#include "traj/airframe.h"
#include "traj/limits.h"

namespace cli {

struct VehicleProfile {
  geom::Vehicle vehicle;
  traj::Limits limits;             // what the vehicle can do; options are stricter or looser
  traj::Airframe airframe;         // of a file only
  std::optional<geom::Vec3> body;  // half sizes, m, that `vehicle` holds up to limits.tilt
};

// "box:HX,HY,HZ", "sphere:R", a built-in name, or a JSON file
// {"name":…,"body":[a,b,c],"tilt_max_deg":T,"limits":{…}} (half sizes of the body in metres) with
// the keys of parse_airframe.
// Throws UsageError for a malformed word, geom::InputError for a bad file.
VehicleProfile parse_vehicle(const std::string& word);

struct VehicleOptions {
  std::string word;              // --vehicle
  std::optional<double> margin;  // --margin

  void add_to(CLI::App& app);
  std::optional<VehicleProfile> profile() const;
};

// The scene of a map for what a record and the options ask; the last one is kept.
class Scenes {
 public:
  enum class Differences { refused, stricter_allowed, allowed };

  // `budget`: geom::CollisionOptions. Records are local, and a group is built within 2 ms.
  Scenes(geom::BoxMap map, const VehicleOptions& options, Differences differences,
         std::size_t budget = std::size_t{1} << 26);

  // Throws geom::InputError(source, line, …) where the record is of another map or frame or, as
  // `differences` says, asks for another vehicle or margin than the options; UsageError where
  // neither says which vehicle.
  const geom::CollisionScene& scene_for(const geom::Provenance& record, std::string_view source,
                                        std::size_t line);
  const geom::CollisionScene& scene();  // by the options alone
  const geom::BoxMap& map() const { return map_; }
  const std::optional<VehicleProfile>& profile() const { return profile_; }

 private:
  const geom::CollisionScene& build(const geom::Vehicle& vehicle, double margin);

  geom::BoxMap map_;
  std::optional<VehicleProfile> profile_;
  std::optional<double> margin_;
  Differences differences_;
  std::size_t budget_;
  std::optional<geom::CollisionScene> scene_;
};

// A lattice or roadmap (`kind`) serves one map, frame, vehicle and margin: throws
// geom::InputError(source, …) where these are not the scene's.
void require_same(const geom::Provenance& made_for, const geom::CollisionScene& scene,
                  const std::string& source, const char* kind);

}  // namespace cli
