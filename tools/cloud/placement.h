#pragma once

// What a cloud's coordinates mean: how long their units are, which reference system they are of,
// and where on Earth they count from.

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <string>

#include "geom/cloud/coordinate_reference.h"
#include "geom/map/frame.h"
#include "proj_reference.h"

namespace cloud {

class Placement {
 public:
  void add_to(CLI::App& app);  // --crs, --units, --vertical-units, --origin

  // Decides by what the file says, which is obeyed, by what PROJ knows of that, and by the options:
  // --crs stands in place of what the file says, the others may add to it and not contradict it.
  // Throws geom::InputError(source, …) where that leaves a unit open, where two of them disagree,
  // and where the numbers are no metres on the ground and no origin is given to bring them there.
  void settle(const geom::CoordinateReference& told, const std::string& source);

  bool settled_by_user() const { return !units_.empty() || !crs_.empty(); }

  // Once settled: a rectangle of the file's coordinates around all that comes to lie in this one of
  // the map (z is not looked at), and the metres in a unit of x and y; nothing where that is not
  // known before points are read, or is not the same everywhere.
  std::optional<geom::Aabb> in_file(const geom::Aabb& region) const;
  std::optional<double> metres_in_file() const;

  // Once settled: to metres of the map. The first points of all decide where `--origin auto` is.
  void place(std::span<geom::CloudPoint> points);

  // Once the first points are placed:
  const geom::Frame& frame() const { return frame_; }
  void record(nlohmann::ordered_json& step) const;  // in the map's history
  std::string report() const;                       // a line for the user; may be empty

 private:
  void parse_origin(const std::string& text);
  geom::CoordinateReference understood(const geom::CoordinateReference& told,
                                       const std::string& source);
  double plane_unit(const geom::CoordinateReference& told, const std::string& source) const;
  double upward_unit(const geom::CoordinateReference& told, double plane,
                     const std::string& source) const;
  void settle_frame(const geom::CoordinateReference& told, const std::string& source);
  void lead_to(const geom::GeodeticOrigin& origin);

  std::string crs_;
  std::string units_;
  std::string vertical_units_;
  std::optional<geom::GeodeticOrigin> origin_;
  bool origin_near_points_ = false;  // --origin auto

  std::string source_;
  geom::Vec3 metres_ = geom::Vec3::Ones();  // in a unit of each axis; x and y: unless projected
  bool up_assumed_ = false;                 // nothing says the unit of heights
  std::optional<ProjReference> reference_;
  std::optional<ProjWay> way_;
  bool projects_ = false;
  bool plane_ = true;  // x and y of the file are lengths
  geom::Frame frame_;
  std::string told_by_;
  std::string replaced_;  // what the file says, where --crs stands in its place
};

}  // namespace cloud
