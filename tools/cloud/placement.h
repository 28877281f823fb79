#pragma once

// What a cloud's coordinates mean: how long their units are, which reference system they are of,
// and where on Earth they count from.

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "geom/cloud/coordinate_reference.h"
#include "geom/map/frame.h"

namespace cloud {

class Placement {
 public:
  void add_to(CLI::App& app);  // --units, --vertical-units, --origin

  // Decides by what the file says, which is obeyed, and by the options, which may add to it and not
  // contradict it. Throws geom::InputError(source, …) where that leaves a unit open, and where the
  // numbers are no metres on the ground whatever their unit.
  void settle(const geom::CoordinateReference& told, const std::string& source);

  bool units_given() const { return !units_.empty(); }

  // Once settled:
  geom::Vec3 in_metres(const geom::Vec3& p) const { return p.cwiseProduct(metres_); }
  const geom::Frame& frame() const { return frame_; }
  void record(nlohmann::ordered_json& step) const;  // in the map's history
  std::string report() const;                       // a line for the user; may be empty

 private:
  double plane_unit(const geom::CoordinateReference& told, const std::string& source) const;
  double upward_unit(const geom::CoordinateReference& told, double plane,
                     const std::string& source) const;

  std::string units_;
  std::string vertical_units_;
  std::optional<geom::GeodeticOrigin> origin_;
  geom::Vec3 metres_ = geom::Vec3::Ones();  // in a unit of each axis
  geom::Frame frame_;
  std::string told_by_;
};

}  // namespace cloud
