#pragma once

// From the coordinates of a point cloud to metres of a map.
//
// Example:
//   geom::CloudPlace place({.origin = geom::GeodeticOrigin{47.4, 8.5, 0}});
//   place.settle(geom::CoordinateReference{}, "scan.xyz");  // the file says nothing of its own
//   std::vector<geom::CloudPoint> points = {{geom::Vec3(1, 2, 3)}};
//   place.place(points);
//   assert(place.frame().origin->latitude == 47.4);
//
// What a cloud's coordinates mean: how long their units are, which reference system they are of,
// and where on Earth they count from.

#include <optional>
#include <span>
#include <string>
#include <utility>

#include "geom/cloud/point_cloud.h"
#include "geom/earth/coordinate_reference.h"
#include "geom/earth/proj_reference.h"
#include "geom/earth/proj_way.h"
#include "geom/map/frame.h"

namespace geom {

// What a user says of a cloud's coordinates, beside what the file says.
struct CloudPlaceOptions {
  struct Unit {
    std::string word;  // for messages
    double metres;
  };

  std::string crs;                       // a reference system that PROJ knows; empty: the file's
  std::optional<Unit> plane;             // of x and y, and of z unless `up` says another
  std::optional<Unit> up;                // of z
  std::optional<GeodeticOrigin> origin;  // where on Earth the map's (0, 0, 0) is
  bool origin_near_points = false;       // it is near the first point
};

// Whether PROJ knows it as a reference system.
bool knows_reference(const std::string& text);

// From the coordinates of a file to those of the map: settle() by what the file says, as read_las
// tells it, then place() its points.
class CloudPlace {
 public:
  explicit CloudPlace(CloudPlaceOptions options = {})
      : options_(std::move(options)), origin_(options_.origin) {}

  // Decides by what the file says, which is obeyed, by what PROJ knows of that, and by the options:
  // `crs` stands in place of what the file says, the others may add to it and not contradict it.
  // Throws InputError(source, …) where PROJ does not know `crs`, where that leaves a unit open,
  // where two of them disagree, and where the numbers are no metres on the ground and no origin is
  // given to bring them there. Throws, too, where the file says that its coordinates are shifted and
  // `crs` says of which system they are, and where it says that they are scaled and no unit is
  // given.
  void settle(const CoordinateReference& told, const std::string& source);

  bool settled_by_user() const { return options_.plane || !options_.crs.empty(); }

  // Once settled: a rectangle of the file's coordinates around all that comes to lie in this one of
  // the map (z is not looked at), and the metres in a unit of x and y; nothing where that is not
  // known before points are read, or is not the same everywhere.
  std::optional<Aabb> in_file(const Aabb& region) const;
  std::optional<double> metres_in_file() const;

  // Once settled: to metres of the map. The first points of all decide where `origin_near_points`
  // puts the origin.
  void place(std::span<CloudPoint> points);
  bool moves_points() const { return projects_ || metres_ != Vec3::Ones(); }

  // Once the first points are placed:
  const Frame& frame() const { return frame_; }
  std::string report() const;  // a line for the user; may be empty
  const Vec3& metres() const {
    return metres_;
  }  // in a unit of each axis; of x and y unless projected
  const std::optional<GeodeticOrigin>& origin() const { return origin_; }
  std::string projected_from() const { return projects_ ? reference_->told().crs : ""; }

 private:
  CoordinateReference understood(const CoordinateReference& told, const std::string& source);
  void require_whole(const CoordinateReference& file, const std::string& source) const;
  double plane_unit(const CoordinateReference& told, const std::string& source) const;
  double upward_unit(const CoordinateReference& told, double plane,
                     const std::string& source) const;
  void settle_frame(const CoordinateReference& told, const std::string& source);
  void lead_to(const GeodeticOrigin& origin);

  CloudPlaceOptions options_;
  std::optional<GeodeticOrigin> origin_;  // the options', or near the first point

  std::string source_;
  Vec3 metres_ = Vec3::Ones();  // in a unit of each axis; x and y: unless projected
  bool up_assumed_ = false;     // nothing says the unit of heights
  std::optional<ProjReference> reference_;
  std::optional<ProjWay> way_;
  bool projects_ = false;
  bool plane_ = true;  // x and y of the file are lengths
  Frame frame_;
  std::string told_by_;
  std::string moved_;     // a comment which says that coordinates are shifted or scaled
  std::string replaced_;  // what the file says, where --crs stands in its place
};

}  // namespace geom
